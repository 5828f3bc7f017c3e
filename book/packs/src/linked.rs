//! The linked module as a graph: function bodies and data, and what each names.
//!
//! The linker leaves its relocations in (`--emit-relocs`): each says where a body or a datum
//! names another, so nothing is guessed from the bytes.

use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::ops::Range;
use wasmparser::{
    DataKind, ExternalKind, KnownCustom, Linking, Name, Operator, Parser, Payload, RelocationEntry,
    RelocationType, SymbolInfo, TypeRef,
};

/// What a body or a datum names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Target {
    /// A function, by its index.
    Function(usize),
    /// A function, by its place in the table.
    Slot(usize),
    /// A datum, by an address.
    Datum(usize),
    /// What is never cut: a type, a global, memory that starts as zeros.
    Fixed,
}

/// How a name is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Form {
    /// Unsigned, seven bits a byte.
    Unsigned,
    /// Signed, seven bits a byte.
    Signed,
    /// Four bytes.
    Word,
}

/// A place that names something.
#[derive(Clone, Copy, Debug)]
pub struct Hole {
    /// Its offset in the bytes.
    pub at: usize,
    pub form: Form,
    pub target: Target,
    /// The number that stands there.
    pub value: i64,
}

impl Hole {
    /// How many bytes the linker takes for it.
    pub fn width(&self) -> usize {
        if self.form == Form::Word { 4 } else { 5 }
    }
}

/// A function.
#[derive(Debug)]
pub struct Function {
    pub name: String,
    /// The index of its type.
    pub kind: u32,
    /// Locals and code; of an import nothing.
    pub bytes: Vec<u8>,
    pub holes: Vec<Hole>,
}

/// Bytes that memory starts with: a symbol, or several that overlap.
#[derive(Debug)]
pub struct Datum {
    pub name: String,
    pub address: usize,
    pub bytes: Vec<u8>,
    pub holes: Vec<Hole>,
    /// Whether nothing may write it.
    pub constant: bool,
}

/// The module.
#[derive(Debug)]
pub struct Linked {
    /// The sections of types, memory and globals, as they are.
    pub sections: [Vec<u8>; 3],
    pub functions: Vec<Function>,
    /// By address.
    pub data: Vec<Datum>,
    /// Name and index of each exported function.
    pub exports: BTreeMap<String, usize>,
}

type Outcome<T> = Result<T, Box<dyn Error>>;

/// The number written in groups of seven bits, padded or not.
fn seven_bits(bytes: &[u8], signed: bool) -> i64 {
    let (mut value, mut shift) = (0_i64, 0);
    for byte in bytes {
        value |= i64::from(byte & 0x7f) << shift;
        shift += 7;
        if byte & 0x80 == 0 {
            if signed && byte & 0x40 != 0 {
                value |= -1 << shift;
            }
            break;
        }
    }
    value
}

/// A segment of memory's first bytes.
struct Segment<'a> {
    address: usize,
    /// Where its bytes start in the module.
    at: usize,
    bytes: &'a [u8],
}

/// What a symbol stands for.
#[derive(Clone, Copy)]
enum Symbol {
    Function(usize),
    /// Its address.
    Datum(usize),
    Other,
}

/// The module's parts as they are read.
#[derive(Default)]
struct Parts<'a> {
    sections: [Vec<u8>; 3],
    kinds: Vec<u32>,
    /// How many of the functions are imports: they come first.
    imported: usize,
    bodies: Vec<Range<usize>>,
    code: usize,
    segments: Vec<Segment<'a>>,
    data: usize,
    symbols: Vec<Symbol>,
    names: BTreeMap<usize, String>,
    /// The numbers of the segments that nothing may write.
    constant: BTreeSet<usize>,
    /// Address, end and name of each datum.
    places: Vec<(usize, usize, String)>,
    relocations: [Vec<RelocationEntry>; 2],
    exports: BTreeMap<String, usize>,
}

fn at(offset: u64) -> usize {
    usize::try_from(offset).expect("a module fits into memory")
}

impl<'a> Parts<'a> {
    fn read(module: &'a [u8]) -> Outcome<Self> {
        let mut parts = Self::default();
        let raw = |range: Range<u64>| module[at(range.start)..at(range.end)].to_vec();
        for payload in Parser::new(0).parse_all(module) {
            match payload? {
                Payload::ImportSection(imports) => {
                    for import in imports.into_imports() {
                        let import = import?;
                        let TypeRef::Func(kind) = import.ty else {
                            return Err("the module imports what is no function".into());
                        };
                        parts.names.insert(parts.imported, import.name.into());
                        parts.kinds.push(kind);
                        parts.imported += 1;
                    }
                }
                Payload::TypeSection(section) => parts.sections[0] = raw(section.range()),
                Payload::MemorySection(section) => parts.sections[1] = raw(section.range()),
                Payload::GlobalSection(section) => parts.sections[2] = raw(section.range()),
                Payload::FunctionSection(section) => {
                    for kind in section {
                        parts.kinds.push(kind?);
                    }
                }
                Payload::ExportSection(section) => {
                    for export in section {
                        let export = export?;
                        // What begins so belongs to the tool wasm-bindgen, which is not used.
                        let others = export.name.starts_with("__");
                        if export.kind == ExternalKind::Func && !others {
                            parts.exports.insert(export.name.into(), export.index as usize);
                        }
                    }
                }
                Payload::CodeSectionStart { unchecked_range, .. } => {
                    parts.code = at(unchecked_range.start)
                }
                Payload::CodeSectionEntry(body) => {
                    parts.bodies.push(at(body.range().start)..at(body.range().end));
                }
                Payload::DataSection(section) => {
                    parts.data = at(section.range().start);
                    for segment in section {
                        let segment = segment?;
                        let DataKind::Active { offset_expr, .. } = segment.kind else {
                            return Err("a segment of memory is copied at run time".into());
                        };
                        let Operator::I32Const { value } =
                            offset_expr.get_operators_reader().read()?
                        else {
                            return Err("a segment of memory has no fixed address".into());
                        };
                        parts.segments.push(Segment {
                            address: usize::try_from(value)?,
                            at: at(segment.range.end) - segment.data.len(),
                            bytes: segment.data,
                        });
                    }
                }
                Payload::CustomSection(custom) => match (custom.name(), custom.as_known()) {
                    (_, KnownCustom::Linking(linking)) => {
                        for part in linking.subsections() {
                            if let Linking::SymbolTable(symbols) = part? {
                                for symbol in symbols {
                                    parts.symbol(&symbol?);
                                }
                            }
                        }
                    }
                    (_, KnownCustom::Name(names)) => {
                        for part in names {
                            if let Name::Data(names) = part? {
                                for name in names {
                                    let name = name?;
                                    if name.name == ".rodata" {
                                        parts.constant.insert(name.index as usize);
                                    }
                                }
                            }
                        }
                    }
                    ("reloc.CODE", KnownCustom::Reloc(section)) => {
                        parts.relocations[0] =
                            section.entries().into_iter().collect::<Result<_, _>>()?;
                    }
                    ("reloc.DATA", KnownCustom::Reloc(section)) => {
                        parts.relocations[1] =
                            section.entries().into_iter().collect::<Result<_, _>>()?;
                    }
                    _ => {}
                },
                _ => {}
            }
        }
        if parts.relocations[0].is_empty() || parts.symbols.is_empty() {
            return Err("the module was linked without --emit-relocs".into());
        }
        Ok(parts)
    }

    fn symbol(&mut self, symbol: &SymbolInfo) {
        let found = match symbol {
            SymbolInfo::Func { index, name, .. } => {
                if let Some(name) = name {
                    self.names.insert(*index as usize, (*name).into());
                }
                Symbol::Function(*index as usize)
            }
            SymbolInfo::Data { name, symbol: Some(place), .. } => {
                match self.segments.get(place.index as usize) {
                    Some(segment) => {
                        let start = segment.address + place.offset as usize;
                        self.places.push((start, start + place.size as usize, (*name).into()));
                        Symbol::Datum(start)
                    }
                    None => Symbol::Other,
                }
            }
            _ => Symbol::Other,
        };
        self.symbols.push(found);
    }

    /// The data: symbols, merged where they overlap, and what lies between them.
    fn data(&mut self) -> Vec<Datum> {
        self.places.sort();
        let mut data: Vec<Datum> = Vec::new();
        for (index, segment) in self.segments.iter().enumerate() {
            let end = segment.address + segment.bytes.len();
            let inside = |place: &&(usize, usize, String)| {
                (segment.address..end).contains(&place.0) && place.1 > place.0
            };
            let mut cuts: Vec<(usize, usize, &str)> = Vec::new();
            let mut reached = segment.address;
            for (start, stop, name) in self.places.iter().filter(inside) {
                if *start > reached {
                    cuts.push((reached, *start, ""));
                }
                match cuts.last_mut() {
                    Some(last) if *start < last.1 => last.1 = last.1.max(*stop),
                    _ => cuts.push((*start, *stop, name)),
                }
                reached = reached.max(*stop);
            }
            if reached < end {
                cuts.push((reached, end, ""));
            }
            data.extend(cuts.into_iter().map(|(start, stop, name)| Datum {
                name: name.into(),
                address: start,
                bytes: segment.bytes[start - segment.address..stop - segment.address].to_vec(),
                holes: Vec::new(),
                constant: self.constant.contains(&index),
            }));
        }
        data
    }
}

/// The datum at an address.
pub fn datum_at(data: &[Datum], address: usize) -> Option<usize> {
    let after = data.partition_point(|datum| datum.address <= address);
    let found = after.checked_sub(1)?;
    (address < data[found].address + data[found].bytes.len()).then_some(found)
}

impl Linked {
    /// Reads a module that was linked with its relocations.
    ///
    /// # Errors
    /// It is no module, or one of a kind that is not cut: without relocations.
    pub fn read(module: &[u8]) -> Outcome<Self> {
        let mut parts = Parts::read(module)?;
        let mut data = parts.data();
        let hole = |entry: &RelocationEntry, start: usize, place: usize| -> Outcome<Hole> {
            use RelocationType as R;
            let form = match entry.ty {
                R::FunctionIndexLeb
                | R::MemoryAddrLeb
                | R::TypeIndexLeb
                | R::GlobalIndexLeb
                | R::TableNumberLeb => Form::Unsigned,
                R::TableIndexSleb | R::MemoryAddrSleb => Form::Signed,
                R::TableIndexI32 | R::MemoryAddrI32 => Form::Word,
                other => return Err(format!("a relocation of the unknown kind {other:?}").into()),
            };
            // A type is named by its index; all else by a symbol.
            let symbol = match entry.ty {
                R::TypeIndexLeb => Symbol::Other,
                _ => parts.symbols[entry.index as usize],
            };
            let target = match (symbol, entry.ty) {
                (Symbol::Function(index), R::TableIndexSleb | R::TableIndexI32) => {
                    Target::Slot(index)
                }
                (Symbol::Function(index), _) => Target::Function(index),
                (Symbol::Datum(address), _) => {
                    datum_at(&data, address).map_or(Target::Fixed, Target::Datum)
                }
                (Symbol::Other, _) => Target::Fixed,
            };
            let bytes = &module[place..place + 5];
            let value = match form {
                Form::Word => {
                    i64::from(u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]))
                }
                _ => seven_bits(bytes, form == Form::Signed),
            };
            Ok(Hole { at: place - start, form, target, value })
        };
        let mut functions = Vec::with_capacity(parts.kinds.len());
        let mut code = parts.relocations[0].iter().peekable();
        for (index, kind) in parts.kinds.iter().enumerate() {
            let (mut bytes, mut holes) = (Vec::new(), Vec::new());
            if let Some(body) = index.checked_sub(parts.imported).map(|n| &parts.bodies[n]) {
                while let Some(entry) =
                    code.next_if(|entry| parts.code + (entry.offset as usize) < body.end)
                {
                    holes.push(hole(entry, body.start, parts.code + entry.offset as usize)?);
                }
                bytes = module[body.clone()].to_vec();
            }
            functions.push(Function {
                name: parts.names.get(&index).cloned().unwrap_or_default(),
                kind: *kind,
                bytes,
                holes,
            });
        }
        let mut words = Vec::new();
        for entry in &parts.relocations[1] {
            let place = parts.data + entry.offset as usize;
            let segment =
                parts.segments.iter().find(|s| (s.at..s.at + s.bytes.len()).contains(&place));
            let segment = segment.ok_or("a relocation lies in no segment")?;
            let address = segment.address + place - segment.at;
            let datum = datum_at(&data, address).ok_or("a relocation lies in no datum")?;
            words.push((datum, hole(entry, place - (address - data[datum].address), place)?));
        }
        for (datum, hole) in words {
            data[datum].holes.push(hole);
        }
        Ok(Self { sections: parts.sections, functions, data, exports: parts.exports })
    }
}
