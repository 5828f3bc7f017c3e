// Joins packs into the module of a page and, in a worker, calls it.
//
// `book/packs/src/pack.rs` says what bytes a pack has: function bodies by their numbers, data
// by their addresses. A function that no pack brought gets a body that traps.
'use strict';

const TRAP = [3, 0, 0x00, 0x0b]; // 3 bytes: no locals, unreachable, end

// Not by a Blob or a Response: these ask another process.
async function inflated(gz) {
  const { writable, readable } = new DecompressionStream('gzip');
  const writer = writable.getWriter();
  const written = Promise.all([writer.write(gz), writer.close()]);
  written.catch(() => {}); // reading fails, too
  const parts = [];
  for (const reader = readable.getReader(); ; ) {
    const { done, value } = await reader.read();
    if (done) break;
    parts.push(value);
  }
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

// Reads numbers of seven bits a byte, and what they count.
function reader(bytes) {
  let at = 0;
  const number = () => {
    for (let value = 0, shift = 0; ; shift += 7) {
      const byte = bytes[at++];
      value |= (byte & 0x7f) << shift;
      if (byte < 0x80) return value >>> 0;
    }
  };
  const take = (length) => bytes.subarray(at, (at += length));
  const counted = () => take(number());
  const list = (one) => Array.from({ length: number() }, one);
  // Start and length of each run.
  const runs = () => {
    let reached = 0;
    return list(() => {
      const start = reached + number();
      const length = number();
      reached = start + length;
      return [start, length];
    });
  };
  return { number, take, counted, list, runs, rest: () => bytes.subarray(at) };
}

function unsigned(value) {
  const bytes = [];
  for (; value >= 0x80; value >>>= 7) bytes.push((value & 0x7f) | 0x80);
  return [...bytes, value];
}

// An address as a signed number: its highest bit is no sign.
function address(value) {
  const bytes = unsigned(value);
  const last = bytes.length - 1;
  return bytes[last] < 0x40 ? bytes : [...bytes.slice(0, last), bytes[last] | 0x80, 0];
}

// Writes bytes and numbers one behind the other.
function writer() {
  let bytes = new Uint8Array(0x40000);
  let at = 0;
  const room = (length) => {
    if (at + length <= bytes.length) return;
    const more = new Uint8Array(2 * (at + length));
    more.set(bytes.subarray(0, at));
    bytes = more;
  };
  const put = (part) => {
    room(part.length);
    bytes.set(part, at);
    at += part.length;
  };
  // So many times, each copy twice as long as the one before: most functions are missing.
  const repeated = (part, times) => {
    room(part.length * times);
    const [from, end] = [at, at + part.length * times];
    if (times > 0) put(part);
    while (at < end) {
      bytes.copyWithin(at, from, Math.min(at, from + end - at));
      at = Math.min(2 * at - from, end);
    }
  };
  const number = (value) => {
    room(5);
    for (; value >= 0x80; value >>>= 7) bytes[at++] = (value & 0x7f) | 0x80;
    bytes[at++] = value;
  };
  const counted = (part) => {
    number(part.length);
    put(part);
  };
  // What `write` writes, behind its length in five bytes.
  const section = (id, write) => {
    put([id, 0, 0, 0, 0, 0]);
    const from = at;
    write();
    for (let n = 0; n < 5; n++) bytes[from - 5 + n] = (((at - from) >>> (7 * n)) & 0x7f) | (n < 4 ? 0x80 : 0);
  };
  return { put, repeated, number, counted, section, whole: () => bytes.subarray(0, at) };
}

// The module's bytes, of inflated packs. `changed` may write a body anew, given its number.
function assembled(packs, changed = (body) => body) {
  const read = packs.map(reader);
  const heads = read.map((pack) => pack.counted());
  const head = reader(heads.find((bytes) => bytes.length > 0));
  const [types, memory, globals] = [head.counted(), head.counted(), head.counted()];
  const slots = head.number();
  const exported = head.list(() => [head.counted(), head.number()]);
  const kinds = head.list(() => [head.number(), head.number()]);
  const functions = kinds.reduce((sum, [count]) => sum + count, 0);

  const [bodies, data] = [new Array(functions), []];
  for (const pack of read) {
    for (const [start, count] of pack.runs()) {
      for (let n = start; n < start + count; n++) bodies[n] = changed(pack.counted(), n);
    }
    for (const [start, length] of pack.runs()) data.push([start, pack.take(length)]);
  }
  const { put, repeated, number, counted, section, whole } = writer();
  put([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);
  section(1, () => put(types));
  section(3, () => {
    number(functions);
    for (const [count, kind] of kinds) repeated(unsigned(kind), count);
  });
  section(4, () => {
    put([1, 0x70, 0]);
    number(slots + 1);
  });
  section(5, () => put(memory));
  section(6, () => put(globals));
  section(7, () => {
    number(exported.length + 1);
    for (const [name, n] of exported) {
      counted(name);
      put([0]);
      number(n);
    }
    counted(new TextEncoder().encode('memory'));
    put([2, 0]);
  });
  section(9, () => {
    put([1, 0, 0x41, 1, 0x0b]);
    number(slots);
    for (let n = 0; n < slots; n++) number(n);
  });
  section(10, () => {
    number(functions);
    let next = 0;
    bodies.forEach((body, n) => {
      repeated(TRAP, n - next);
      counted(body);
      next = n + 1;
    });
    repeated(TRAP, functions - next);
  });
  section(11, () => {
    number(data.length);
    for (const [start, bytes] of data) {
      put([0, 0x41, ...address(start), 0x0b]);
      counted(bytes);
    }
  });
  return whole();
}

async function compiled(packs) {
  return WebAssembly.compile(assembled(await Promise.all(packs.map(inflated))));
}

// The instance of gzipped packs.
async function joined(packs) {
  return WebAssembly.instantiate(await compiled(packs), {});
}

// Answers calls one after the other. A call is `{id, packs?, call?, page?, text?, numbers?}`:
// `packs` (gzipped, of one list) give a new instance; `call` is an export, given the numbers and,
// if it takes one more, the page's; `text` is its input. The answer is `{id, text}`, of
// `frame` `{id, bytes}`, with `told` also `alt`, what it shows in words, or `{id, error, trapped}`: `trapped` when the module broke off, as it
// does where a function is missing; the same call with a page's full packs then tells.
function caller() {
  let module;
  let wasm;
  let opened; // the last `open`, and the instance that has it
  const invoke = ({ call, page, text, numbers = [] }) => {
    if (text !== undefined) {
      const bytes = new TextEncoder().encode(text);
      const at = wasm.input(bytes.length); // may move the memory
      new Uint8Array(wasm.memory.buffer, at, bytes.length).set(bytes);
    }
    const length = wasm[call](...[page, ...numbers].slice(-wasm[call].length));
    const at = wasm.output();
    return new Uint8Array(wasm.memory.buffer, at, length);
  };
  const told = (message) => new TextDecoder().decode(invoke(message));
  return async ({ id, packs, ...message }) => {
    try {
      if (packs) [module, wasm] = [compiled(packs), undefined];
      wasm ??= (await WebAssembly.instantiate(await module, {})).exports;
      if (message.call === undefined) return { id };
      if (message.call === 'open') opened = { message, wasm };
      if (message.call !== 'frame') return { id, text: told(message) };
      if (opened && opened.wasm !== wasm) {
        told(opened.message);
        opened.wasm = wasm;
      }
      const bytes = invoke(message).slice().buffer;
      if (bytes.byteLength === 0) return { id, error: told({ call: 'failure' }) };
      return message.told ? { id, bytes, alt: told({ call: 'alt' }) } : { id, bytes };
    } catch (error) {
      const trapped = error instanceof WebAssembly.RuntimeError;
      if (trapped) wasm = undefined; // What it left in memory is not to be relied on.
      return { id, error: String(error), trapped };
    }
  };
}

if (typeof importScripts === 'function') {
  const answer = caller();
  let before = Promise.resolve();
  onmessage = ({ data }) => {
    before = before.then(() => answer(data)).then((told) => {
      postMessage(told, told.bytes ? [told.bytes] : []);
    });
  };
}
