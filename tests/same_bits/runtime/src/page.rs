//! A page's module and its calls, as `book/theme/module.js` makes them.

use flate2::read::GzDecoder;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};
use wasmtime::{
    Config, Engine, Error, Instance, Linker, Memory, Module, Result, Store, WasmParams,
};

#[derive(Deserialize)]
struct Index {
    pages: BTreeMap<String, Entry>,
}

/// What `index.json` says of a page.
#[derive(Deserialize)]
pub struct Entry {
    #[serde(rename = "page")]
    pub number: i32,
    pub declared: Declared,
    /// The name of its file.
    pub module: String,
}

#[derive(Deserialize)]
pub struct Declared {
    pub about: String,
    pub moves: bool,
}

/// The modules in a directory, compiled.
pub struct Modules {
    pub directory: PathBuf,
    pub pages: BTreeMap<String, Entry>,
    engine: Engine,
    compiled: BTreeMap<String, Module>,
}

impl Modules {
    pub fn read(directory: &Path) -> Result<Self> {
        let index: Index = serde_json::from_slice(&fs::read(directory.join("index.json"))?)?;
        let mut config = Config::new();
        // No instruction may depend on the processor. Every NaN gets the same bits, which no
        // browser sees to: what is told does not depend on them.
        config.wasm_simd(true).wasm_relaxed_simd(false);
        config.cranelift_nan_canonicalization(true);
        let mut modules = Self {
            directory: directory.to_owned(),
            pages: index.pages,
            engine: Engine::new(&config)?,
            compiled: BTreeMap::new(),
        };
        for name in modules.pages.values().map(|page| &page.module) {
            if !modules.compiled.contains_key(name) {
                let wasm = inflated(File::open(directory.join(name))?)?;
                let module = Module::new(&modules.engine, wasm)?;
                modules.compiled.insert(name.clone(), module);
            }
        }
        Ok(modules)
    }

    /// A new instance of these bytes.
    pub fn of(&self, wasm: &[u8], number: i32) -> Result<Page> {
        self.instance(&Module::new(&self.engine, wasm)?, number)
    }

    /// A page, in an instance of its own.
    pub fn page(&self, stem: &str) -> Result<Page> {
        let Entry { module, number, .. } = &self.pages[stem];
        self.instance(&self.compiled[module], *number)
    }

    /// Nothing that a page tells rests on what its module asks of a platform.
    fn instance(&self, module: &Module, number: i32) -> Result<Page> {
        let mut linker = Linker::new(&self.engine);
        let mut store = Store::new(&self.engine, ());
        linker.define_unknown_imports_as_default_values(&mut store, module)?;
        let instance = linker.instantiate(&mut store, module)?;
        let memory = instance.get_memory(&mut store, "memory");
        let memory = memory.ok_or_else(|| Error::msg("a module without memory"))?;
        Ok(Page { store, instance, memory, number })
    }
}

/// # Errors
/// The bytes are damaged.
pub fn inflated(gz: impl Read) -> Result<Vec<u8>> {
    let mut wasm = Vec::new();
    GzDecoder::new(gz).read_to_end(&mut wasm)?;
    Ok(wasm)
}

/// A page and the instance that answers for it.
pub struct Page {
    store: Store<()>,
    instance: Instance,
    memory: Memory,
    number: i32,
}

impl Page {
    fn number<P: WasmParams>(&mut self, call: &str, parameters: P) -> Result<usize> {
        let function = self.instance.get_typed_func::<P, u32>(&mut self.store, call)?;
        Ok(function.call(&mut self.store, parameters)? as usize)
    }

    /// Leaves a text for the next call.
    fn write(&mut self, text: &str) -> Result<()> {
        let at = self.number("input", text.len() as u32)?;
        Ok(self.memory.write(&mut self.store, at, text.as_bytes())?)
    }

    /// The bytes that a call leaves.
    fn call<P: WasmParams>(&mut self, call: &str, parameters: P) -> Result<Vec<u8>> {
        let mut bytes = vec![0; self.number(call, parameters)?];
        let at = self.number("output", ())?;
        self.memory.read(&self.store, at, &mut bytes)?;
        Ok(bytes)
    }

    /// What a call answers to a text.
    pub fn ask(&mut self, call: &str, text: &str) -> Result<Vec<u8>> {
        self.write(text)?;
        self.call(call, self.number)
    }

    /// What is drawn at a time, seen from elsewhere by so much.
    pub fn frame(&mut self, t: f64, about: f64) -> Result<Vec<u8>> {
        let drawn = self.call("frame", (t, about, 0.0))?;
        if drawn.is_empty() {
            let reason = self.call("failure", ())?;
            return Err(Error::msg(String::from_utf8(reason)?));
        }
        Ok(drawn)
    }
}
