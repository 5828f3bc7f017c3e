// In a worker: compiles the module of a part of the book, and calls it.
'use strict';

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

async function compiled(gz) {
  return WebAssembly.compile(await inflated(gz));
}

// An instance. Nothing that a page tells rests on what its module asks of a platform.
async function instance(module) {
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    (imports[from] ??= {})[name] = () => 0;
  }
  return (await WebAssembly.instantiate(module, imports)).exports;
}

// Answers calls one after the other. A call is `{id, gz?, call?, page?, text?, numbers?}`: `gz`
// gives another module; `call` is an export, given the numbers and, if it takes one more, the
// page's; `text` is its input, or its bytes. The answer is `{id, text}`, of `frame` and `shown`
// `{id, bytes}`, with `told` also `alt`, what it shows in words, or `{id, error}`.
function caller() {
  let module;
  let wasm;
  let opened; // the last call that prepared pictures, and the instance that has them
  const invoke = ({ call, page, text, numbers = [] }) => {
    if (text !== undefined) {
      const bytes = typeof text === 'string' ? new TextEncoder().encode(text) : text;
      const at = wasm.input(bytes.length); // may move the memory
      new Uint8Array(wasm.memory.buffer, at, bytes.length).set(bytes);
    }
    const length = wasm[call](...[page, ...numbers].slice(-wasm[call].length));
    const at = wasm.output();
    return new Uint8Array(wasm.memory.buffer, at, length);
  };
  const told = (message) => new TextDecoder().decode(invoke(message));
  return async ({ id, gz, ...message }) => {
    try {
      if (gz) [module, wasm] = [compiled(gz), undefined];
      wasm ??= await instance(await module);
      if (message.call === undefined) return { id };
      if (message.call === 'open' || message.call === 'recorded') opened = { message, wasm };
      if (message.call !== 'frame' && message.call !== 'shown') return { id, text: told(message) };
      if (opened && opened.wasm !== wasm) {
        told(opened.message);
        opened.wasm = wasm;
      }
      const bytes = invoke(message).slice().buffer;
      if (bytes.byteLength === 0) return { id, error: told({ call: 'failure' }) };
      return message.told ? { id, bytes, alt: told({ call: 'alt' }) } : { id, bytes };
    } catch (error) {
      wasm = undefined; // What it left in memory is not to be relied on.
      return { id, error: String(error) };
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
