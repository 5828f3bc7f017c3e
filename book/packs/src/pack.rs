//! The bytes of a pack, as `book/theme/module.js` reads them.
//!
//! A pack is a head, bodies and data; numbers take seven bits a byte, lowest first. The head is
//! empty (0) but in the pack of what all pages share. Bodies: the number of runs; for each how
//! many functions are passed over and how many follow; then each body, its size first. Data:
//! the number of runs; for each how many bytes of memory are passed over and how many follow;
//! then the bytes of all.

use crate::slim::{Node, Slim, unsigned};
use std::collections::BTreeSet;
use std::num::NonZeroU64;

fn number(value: usize, out: &mut Vec<u8>) {
    unsigned(value as u64, out);
}

fn counted(bytes: &[u8], out: &mut Vec<u8>) {
    number(bytes.len(), out);
    out.extend(bytes);
}

/// Start and length of what joins on, each start from the last end.
fn runs(pieces: impl Iterator<Item = (usize, usize)>, out: &mut Vec<u8>) {
    let mut runs: Vec<(usize, usize)> = Vec::new();
    for (start, length) in pieces {
        match runs.last_mut() {
            Some(last) if last.0 + last.1 == start => last.1 += length,
            _ => runs.push((start, length)),
        }
    }
    number(runs.len(), out);
    let mut reached = 0;
    for (start, length) in runs {
        number(start - reached, out);
        number(length, out);
        reached = start + length;
    }
}

/// What every module has: types, memory and globals as sections; how many functions are in the
/// table; the exports, a name and a function each; the types of all functions, as runs of how
/// many and which.
fn head(module: &Slim) -> Vec<u8> {
    let mut out = Vec::new();
    for section in &module.sections {
        counted(section, &mut out);
    }
    number(module.slots, &mut out);
    number(module.exports.len(), &mut out);
    for (name, function) in &module.exports {
        counted(name.as_bytes(), &mut out);
        number(*function, &mut out);
    }
    let kinds: Vec<&[u32]> = module.kinds.chunk_by(|a, b| a == b).collect();
    number(kinds.len(), &mut out);
    for run in kinds {
        number(run.len(), &mut out);
        number(run[0] as usize, &mut out);
    }
    out
}

/// The pack of these bodies and data.
pub fn pack(module: &Slim, nodes: &BTreeSet<Node>, with_head: bool) -> Vec<u8> {
    let mut out = Vec::new();
    match with_head {
        true => counted(&head(module), &mut out),
        false => number(0, &mut out),
    }
    let functions = nodes.iter().filter_map(|node| match node {
        Node::Function(f) => Some(*f),
        Node::Datum(_) => None,
    });
    runs(functions.clone().map(|f| (f, 1)), &mut out);
    for function in functions {
        counted(&module.bodies[function], &mut out);
    }
    let data = nodes.iter().filter_map(|node| match node {
        Node::Datum(d) => Some(&module.data[*d]),
        Node::Function(_) => None,
    });
    runs(data.clone().map(|(address, bytes)| (*address, bytes.len())), &mut out);
    for (_, bytes) in data {
        out.extend(bytes);
    }
    out
}

/// The pack of all.
pub fn whole(module: &Slim) -> Vec<u8> {
    pack(module, &module.names.keys().copied().collect(), true)
}

/// How often the compressor tries anew; after the third time it gains 0.1 %.
const TRIES: NonZeroU64 = NonZeroU64::new(3).expect("not 0");

/// The pack compressed (RFC 1952).
pub fn compressed(pack: &[u8]) -> std::io::Result<Vec<u8>> {
    let options = zopfli::Options { iteration_count: TRIES, ..zopfli::Options::default() };
    let mut out = Vec::new();
    zopfli::compress(options, zopfli::Format::Gzip, pack, &mut out)?;
    Ok(out)
}

/// Whether a file holds this pack.
pub fn is(file: &[u8], pack: &[u8]) -> bool {
    let deflated = file.get(10..file.len().saturating_sub(8)).unwrap_or_default();
    miniz_oxide::inflate::decompress_to_vec(deflated).is_ok_and(|held| held == pack)
}
