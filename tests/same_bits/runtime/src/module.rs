//! Joins packs into the module of a page, as `book/theme/module.js` does.
//!
//! `book/packs/src/pack.rs` says what bytes a pack has. A function that no pack brought gets a
//! body that traps.

use std::iter::repeat_n;
use std::ops::Range;

const TRAP: [u8; 3] = [0, 0x00, 0x0b]; // no locals, unreachable, end

struct Reader<'a>(&'a [u8]);

impl<'a> Reader<'a> {
    fn take(&mut self, length: usize) -> &'a [u8] {
        let (taken, rest) = self.0.split_at(length);
        self.0 = rest;
        taken
    }

    fn number(&mut self) -> usize {
        match usize::from(self.take(1)[0]) {
            last @ 0..0x80 => last,
            low => low & 0x7f | self.number() << 7,
        }
    }

    fn counted(&mut self) -> &'a [u8] {
        let length = self.number();
        self.take(length)
    }

    fn list<T>(&mut self, one: impl Fn(&mut Self) -> T) -> Vec<T> {
        (0..self.number()).map(|_| one(self)).collect()
    }

    fn runs(&mut self) -> Vec<Range<usize>> {
        let apart = self.list(|pack| (pack.number(), pack.number()));
        let mut reached = 0;
        let run = |(passed, length)| {
            let start = reached + passed;
            reached = start + length;
            start..reached
        };
        apart.into_iter().map(run).collect()
    }
}

fn unsigned(value: usize) -> Vec<u8> {
    let low = (value & 0x7f) as u8;
    match value >> 7 {
        0 => vec![low],
        high => [vec![low | 0x80], unsigned(high)].concat(),
    }
}

/// An address as a signed number: its highest bit is no sign.
fn address(value: usize) -> Vec<u8> {
    let mut bytes = unsigned(value);
    if let Some(last) = bytes.last_mut().filter(|last| **last >= 0x40) {
        *last |= 0x80;
        bytes.push(0);
    }
    bytes
}

fn counted(bytes: &[u8]) -> Vec<u8> {
    [&unsigned(bytes.len()), bytes].concat()
}

fn list(items: impl ExactSizeIterator<Item = Vec<u8>>) -> Vec<u8> {
    let mut bytes = unsigned(items.len());
    bytes.extend(items.flatten());
    bytes
}

/// The module's bytes, of inflated packs.
pub fn assembled(packs: &[Vec<u8>]) -> Vec<u8> {
    let mut packs: Vec<Reader> = packs.iter().map(|pack| Reader(pack)).collect();
    let heads: Vec<&[u8]> = packs.iter_mut().map(Reader::counted).collect();
    let head = heads.into_iter().find(|head| !head.is_empty());
    let mut head = Reader(head.expect("one of the packs has a head"));
    let [types, memory, globals] = [(); 3].map(|()| head.counted().to_vec());
    let slots = head.number();
    let exported = head.list(|head| (head.counted(), head.number()));
    let kinds = head.list(|head| (head.number(), head.number()));
    let kinds: Vec<usize> = kinds
        .into_iter()
        .flat_map(|(functions, kind)| repeat_n(kind, functions))
        .collect();

    let mut bodies: Vec<&[u8]> = vec![&TRAP; kinds.len()];
    let mut data = Vec::new();
    for pack in &mut packs {
        for run in pack.runs() {
            bodies[run].fill_with(|| pack.counted());
        }
        for run in pack.runs() {
            data.push((run.start, pack.take(run.len())));
        }
    }
    let export =
        |(name, function): (&[u8], usize)| [counted(name), vec![0], unsigned(function)].concat();
    let mut exports: Vec<Vec<u8>> = exported.into_iter().map(export).collect();
    exports.push([counted(b"memory"), vec![2, 0]].concat());
    let datum = |(at, bytes): (usize, &[u8])| {
        [vec![0, 0x41], address(at), vec![0x0b], counted(bytes)].concat()
    };
    let sections = [
        (1, types),
        (3, list(kinds.into_iter().map(unsigned))),
        (4, [vec![1, 0x70, 0], unsigned(slots + 1)].concat()),
        (5, memory),
        (6, globals),
        (7, list(exports.into_iter())),
        (
            9,
            [vec![1, 0, 0x41, 1, 0x0b], list((0..slots).map(unsigned))].concat(),
        ),
        (10, list(bodies.into_iter().map(counted))),
        (11, list(data.into_iter().map(datum))),
    ];
    let mut module = b"\0asm\x01\0\0\0".to_vec();
    for (id, section) in sections {
        module.push(id);
        module.extend(counted(&section));
    }
    module
}
