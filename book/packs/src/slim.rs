//! The module made slim: equal functions and data once, no padding, what nothing reaches gone.
//!
//! Functions get a new order: first those of the table, so that slot `n` is function `n - 1`
//! and no list is needed, then the others; within both by type, so that the types are a
//! few runs. Memory keeps its addresses.

use crate::linked::{Form, Hole, Linked, Target};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// A function body or a datum.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Node {
    Function(usize),
    Datum(usize),
}

/// The slim module; a function and a datum go by their new numbers.
#[derive(Debug)]
pub struct Slim {
    /// The sections of types, memory and globals.
    pub sections: [Vec<u8>; 3],
    /// The type of each function.
    pub kinds: Vec<u32>,
    /// How many functions are in the table.
    pub slots: usize,
    pub bodies: Vec<Vec<u8>>,
    /// Address and bytes, by address.
    pub data: Vec<(usize, Vec<u8>)>,
    pub exports: BTreeMap<String, usize>,
    /// What a node names.
    pub names: BTreeMap<Node, Vec<Node>>,
    /// What each was called, to tell of it.
    pub called: BTreeMap<Node, String>,
}

/// What a hole names, folded.
fn named(hole: &Hole, same: &Same) -> Option<Node> {
    match hole.target {
        Target::Function(f) | Target::Slot(f) => Some(Node::Function(same.functions[f])),
        Target::Datum(d) => Some(Node::Datum(same.data[d])),
        Target::Fixed => None,
    }
}

/// For each function and each datum the first one that is equal to it.
struct Same {
    functions: Vec<usize>,
    data: Vec<usize>,
}

impl Same {
    /// Two are equal when their bytes are and what they name is: the coarsest such partition,
    /// found by refining the one in which all that have the same bytes are equal.
    fn find(module: &Linked) -> Self {
        let functions = module.functions.len();
        let blank = |bytes: &[u8], holes: &[Hole]| {
            let mut bytes = bytes.to_vec();
            for hole in holes.iter().filter(|hole| hole.target != Target::Fixed) {
                bytes[hole.at..hole.at + hole.width()].fill(0);
            }
            bytes
        };
        // A datum that may be written stays its own.
        let bare = module.functions.iter().map(|f| (f.kind, 0, blank(&f.bytes, &f.holes)));
        let bare = bare.chain(module.data.iter().enumerate().map(|(index, datum)| {
            let own = if datum.constant { 0 } else { index + 1 };
            (u32::MAX, own, blank(&datum.bytes, &datum.holes))
        }));
        let mut classes = HashMap::new();
        let mut class: Vec<usize> = Vec::new();
        for key in bare {
            let next = classes.len();
            class.push(*classes.entry(key).or_insert(next));
        }
        let mut count = classes.len();
        loop {
            let mut finer = HashMap::new();
            let holes = module
                .functions
                .iter()
                .map(|f| &f.holes)
                .chain(module.data.iter().map(|d| &d.holes));
            let next: Vec<usize> = holes
                .enumerate()
                .map(|(node, holes)| {
                    let target = |hole: &Hole| match hole.target {
                        Target::Function(f) | Target::Slot(f) => (hole.at, class[f], 0),
                        Target::Datum(d) => {
                            (hole.at, class[functions + d], offset(hole, module, d))
                        }
                        Target::Fixed => (hole.at, usize::MAX, 0),
                    };
                    let key = (class[node], holes.iter().map(target).collect::<Vec<_>>());
                    let next = finer.len();
                    *finer.entry(key).or_insert(next)
                })
                .collect();
            class = next;
            if finer.len() == count {
                break;
            }
            count = finer.len();
        }
        let mut first = HashMap::new();
        let firsts: Vec<usize> = class
            .iter()
            .enumerate()
            .map(|(node, class)| *first.entry(class).or_insert(node))
            .collect();
        Self {
            functions: firsts[..functions].to_vec(),
            data: firsts[functions..].iter().map(|node| node - functions).collect(),
        }
    }
}

/// How far into a datum, or on from it, an address is.
fn offset(hole: &Hole, module: &Linked, datum: usize) -> i64 {
    hole.value - i64::try_from(module.data[datum].address).expect("an address")
}

/// A number in as few groups of seven bits as it takes.
pub fn unsigned(mut value: u64, out: &mut Vec<u8>) {
    while value >= 0x80 {
        out.push((value & 0x7f) as u8 | 0x80);
        value >>= 7;
    }
    out.push(value as u8);
}

fn signed(mut value: i64, out: &mut Vec<u8>) {
    while !(-64..64).contains(&value) {
        out.push((value & 0x7f) as u8 | 0x80);
        value >>= 7;
    }
    out.push((value & 0x7f) as u8);
}

/// The bytes with every hole filled anew.
fn filled(bytes: &[u8], holes: &[Hole], value: impl Fn(&Hole) -> i64) -> Vec<u8> {
    let mut out = Vec::with_capacity(bytes.len());
    let mut from = 0;
    for hole in holes {
        out.extend(&bytes[from..hole.at]);
        let value = value(hole);
        match hole.form {
            Form::Unsigned => unsigned(value as u64, &mut out),
            Form::Signed => signed(value, &mut out),
            Form::Word => out.extend((value as u32).to_le_bytes()),
        }
        from = hole.at + hole.width();
    }
    out.extend(&bytes[from..]);
    out
}

impl Slim {
    /// What the exports reach, slim.
    ///
    /// # Errors
    /// They reach an import: a page has nothing to give.
    pub fn new(module: &Linked) -> Result<Self, String> {
        let same = Same::find(module);
        let names = |node: Node| -> Vec<Node> {
            let holes = match node {
                Node::Function(f) => &module.functions[f].holes,
                Node::Datum(d) => &module.data[d].holes,
            };
            holes.iter().filter_map(|hole| named(hole, &same)).collect()
        };
        let roots = module.exports.values().map(|&f| Node::Function(same.functions[f]));
        // What no symbol covers is kept: nothing says who reads it.
        let unnamed = module.data.iter().enumerate().filter(|(_, datum)| datum.name.is_empty());
        let roots = roots.chain(unnamed.map(|(index, _)| Node::Datum(index)));
        let kept = closure(roots, names, |_| true);
        let imported = |node: &&Node| match node {
            Node::Function(f) => module.functions[*f].bytes.is_empty(),
            Node::Datum(_) => false,
        };
        if let Some(Node::Function(f)) = kept.iter().find(imported) {
            let name = &module.functions[*f].name;
            return Err(format!("the module needs {name} of whoever runs it"));
        }

        let mut slots = BTreeSet::new();
        for &node in &kept {
            let holes = match node {
                Node::Function(f) => &module.functions[f].holes,
                Node::Datum(d) => &module.data[d].holes,
            };
            for hole in holes {
                if let Target::Slot(f) = hole.target {
                    slots.insert(same.functions[f]);
                }
            }
        }
        let functions = kept.iter().filter_map(|node| match node {
            Node::Function(f) => Some(*f),
            Node::Datum(_) => None,
        });
        let mut order: Vec<usize> = functions.collect();
        order.sort_by_key(|f| (!slots.contains(f), module.functions[*f].kind, *f));
        let data: Vec<usize> = kept
            .iter()
            .filter_map(|node| match node {
                Node::Datum(d) => Some(*d),
                Node::Function(_) => None,
            })
            .collect();
        let place: HashMap<usize, usize> =
            order.iter().enumerate().map(|(new, old)| (*old, new)).collect();
        let datum: HashMap<usize, usize> =
            data.iter().enumerate().map(|(new, old)| (*old, new)).collect();
        let renamed = |node: Node| match node {
            Node::Function(f) => Node::Function(place[&f]),
            Node::Datum(d) => Node::Datum(datum[&d]),
        };
        let value = |hole: &Hole| match hole.target {
            Target::Function(f) => place[&same.functions[f]] as i64,
            Target::Slot(f) => place[&same.functions[f]] as i64 + 1,
            Target::Datum(d) => offset(hole, module, d) + module.data[same.data[d]].address as i64,
            Target::Fixed => hole.value,
        };
        let called = kept.iter().map(|&node| {
            let name = match node {
                Node::Function(f) => &module.functions[f].name,
                Node::Datum(d) => &module.data[d].name,
            };
            (renamed(node), name.clone())
        });
        let filled_body =
            |f: &usize| filled(&module.functions[*f].bytes, &module.functions[*f].holes, value);
        let filled_datum = |d: &usize| {
            (module.data[*d].address, filled(&module.data[*d].bytes, &module.data[*d].holes, value))
        };
        let names = kept
            .iter()
            .map(|&node| (renamed(node), names(node).into_iter().map(renamed).collect()));
        Ok(Self {
            sections: module.sections.clone(),
            kinds: order.iter().map(|f| module.functions[*f].kind).collect(),
            slots: slots.len(),
            bodies: order.iter().map(filled_body).collect(),
            data: data.iter().map(filled_datum).collect(),
            exports: module
                .exports
                .iter()
                .map(|(name, f)| (name.clone(), place[&same.functions[*f]]))
                .collect(),
            names: names.collect(),
            called: called.collect(),
        })
    }
}

impl Slim {
    /// How many bytes a body has, or a datum.
    pub fn size(&self, node: Node) -> usize {
        match node {
            Node::Function(f) => self.bodies[f].len(),
            Node::Datum(d) => self.data[d].1.len(),
        }
    }

    /// What every module has: what is called from outside, and the data that no symbol covers.
    pub fn roots(&self) -> impl Iterator<Item = Node> + '_ {
        let exports = self.exports.values().map(|f| Node::Function(*f));
        let unnamed = self
            .called
            .iter()
            .filter(|(node, name)| matches!(node, Node::Datum(_)) && name.is_empty());
        exports.chain(unnamed.map(|(node, _)| *node))
    }
}

/// All that the roots name, and what these name, as far as `wanted`.
pub fn closure(
    roots: impl IntoIterator<Item = Node>,
    names: impl Fn(Node) -> Vec<Node>,
    wanted: impl Fn(Node) -> bool,
) -> BTreeSet<Node> {
    let mut open: Vec<Node> = roots.into_iter().filter(|node| wanted(*node)).collect();
    let mut found: BTreeSet<Node> = open.iter().copied().collect();
    while let Some(node) = open.pop() {
        for next in names(node) {
            if wanted(next) && found.insert(next) {
                open.push(next);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linked::Function;

    #[test]
    fn numbers_take_as_few_bytes_as_they_can() {
        // The values of the DWARF standard's tables of LEB128.
        let cases: [(i64, &[u8]); 6] = [
            (2, &[2]),
            (-2, &[0x7e]),
            (127, &[0xff, 0]),
            (-127, &[0x81, 0x7f]),
            (128, &[0x80, 1]),
            (-129, &[0xff, 0x7e]),
        ];
        for (value, bytes) in cases {
            let mut out = Vec::new();
            signed(value, &mut out);
            assert_eq!(out, bytes, "{value}");
        }
        for (value, bytes) in
            [(2, &[2][..]), (127, &[0x7f]), (128, &[0x80, 1]), (12857, &[0xb9, 0x64])]
        {
            let mut out = Vec::new();
            unsigned(value, &mut out);
            assert_eq!(out, bytes, "{value}");
        }
    }

    /// A page has nothing to give to a module; what is imported and not used is cut.
    #[test]
    fn an_import_is_refused_if_it_is_reached() {
        let function = |name: &str, bytes: &[u8], calls: &[usize]| Function {
            name: name.into(),
            kind: 0,
            bytes: bytes.into(),
            holes: calls
                .iter()
                .map(|f| Hole {
                    at: 0,
                    form: Form::Unsigned,
                    target: Target::Function(*f),
                    value: 0,
                })
                .collect(),
        };
        let module = |exported: usize| Linked {
            sections: Default::default(),
            functions: vec![
                function("window", &[], &[]),
                function("asks", &[0; 5], &[0]),
                function("computes", &[0; 5], &[2]),
            ],
            data: Vec::new(),
            exports: BTreeMap::from([("run".into(), exported)]),
        };
        let kept = Slim::new(&module(2)).expect("nothing is asked for");
        assert_eq!(kept.bodies.len(), 1);
        let refused = Slim::new(&module(1)).unwrap_err();
        assert_eq!(refused, "the module needs window of whoever runs it");
    }

    #[test]
    fn a_hole_is_filled_without_its_padding() {
        let hole = |at, form| Hole { at, form, target: Target::Fixed, value: 3 };
        let bytes =
            [0x10, 0x83, 0x80, 0x80, 0x80, 0, 0x41, 0x83, 0x80, 0x80, 0x80, 0, 0x0b, 3, 0, 0, 0];
        let holes = [hole(1, Form::Unsigned), hole(7, Form::Signed), hole(13, Form::Word)];
        let found = filled(&bytes, &holes, |hole| hole.value + 64);
        assert_eq!(found, [0x10, 67, 0x41, 0xc3, 0, 0x0b, 67, 0, 0, 0]);
    }
}
