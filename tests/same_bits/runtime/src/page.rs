//! A page's module and its calls, as `book/theme/module.js` makes them.

use crate::module::assembled;
use flate2::read::GzDecoder;
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap, VecDeque};
use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use wasmtime::{
    CacheStore, Config, Engine, Error, Instance, Memory, Module, Result, Store, Trap, WasmParams,
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
    /// The names of packs.
    #[serde(flatten)]
    lists: BTreeMap<String, Vec<String>>,
}

#[derive(Deserialize)]
pub struct Declared {
    pub about: String,
    pub moves: bool,
}

/// Machine code: what several lists have is compiled once, which more than halves the time.
#[derive(Debug, Default)]
struct Code(Mutex<HashMap<Vec<u8>, Vec<u8>>>);

impl CacheStore for Code {
    fn get(&self, key: &[u8]) -> Option<Cow<'_, [u8]>> {
        let code = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        code.get(key).cloned().map(Cow::Owned)
    }

    fn insert(&self, key: &[u8], value: Vec<u8>) -> bool {
        let mut code = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        code.insert(key.to_owned(), value);
        true
    }
}

/// The packs in a directory, and what runs them.
pub struct Modules {
    pub directory: PathBuf,
    pub pages: BTreeMap<String, Entry>,
    engine: Engine,
}

impl Modules {
    pub fn read(directory: &Path) -> Result<Self> {
        let index: Index = serde_json::from_slice(&fs::read(directory.join("index.json"))?)?;
        let mut config = Config::new();
        // No instruction may depend on the processor. Every NaN gets the same bits, which no
        // browser sees to: what is told does not depend on them.
        config.wasm_simd(true).wasm_relaxed_simd(false);
        config.cranelift_nan_canonicalization(true);
        config.enable_incremental_compilation(Arc::<Code>::default())?;
        Ok(Self {
            directory: directory.to_owned(),
            pages: index.pages,
            engine: Engine::new(&config)?,
        })
    }

    /// The packs of a list, inflated.
    pub fn packs(&self, list: &[String]) -> Result<Vec<Vec<u8>>> {
        let inflated = |name| inflated(File::open(self.directory.join(name))?);
        list.iter().map(inflated).collect()
    }

    pub fn joined(&self, packs: &[Vec<u8>]) -> Result<Joined> {
        let module = Module::new(&self.engine, assembled(packs))?;
        let mut store = Store::new(&self.engine, ());
        let instance = Instance::new(&mut store, &module, &[])?;
        let memory = instance.get_memory(&mut store, "memory");
        let memory = memory.ok_or_else(|| Error::msg("a module without memory"))?;
        Ok(Joined {
            store,
            instance,
            memory,
        })
    }

    /// The lists of a page: for what moves, then the longer ones, each within the next.
    pub fn lists(&self, stem: &str) -> Vec<&[String]> {
        let mut lists: Vec<_> = self.pages[stem].lists.iter().collect();
        lists.sort_by_key(|(name, packs)| (*name != "motion", packs.len()));
        lists
            .into_iter()
            .map(|(_, packs)| packs.as_slice())
            .collect()
    }

    /// A page with the first of these lists; the others are at hand.
    pub fn page<'a>(&'a self, stem: &str, lists: &[&'a [String]]) -> Result<Page<'a>> {
        let (first, longer) = lists.split_first().ok_or_else(|| Error::msg("no list"))?;
        Ok(Page {
            modules: self,
            number: self.pages[stem].number,
            joined: self.joined(&self.packs(first)?)?,
            longer: longer.iter().copied().collect(),
            broke_off: Vec::new(),
        })
    }
}

/// # Errors
/// The bytes are damaged.
pub fn inflated(gz: impl Read) -> Result<Vec<u8>> {
    let mut pack = Vec::new();
    GzDecoder::new(gz).read_to_end(&mut pack)?;
    Ok(pack)
}

/// An instance of joined packs.
pub struct Joined {
    store: Store<()>,
    instance: Instance,
    memory: Memory,
}

impl Joined {
    fn number<P: WasmParams>(&mut self, call: &str, parameters: P) -> Result<usize> {
        let function = self
            .instance
            .get_typed_func::<P, u32>(&mut self.store, call)?;
        Ok(function.call(&mut self.store, parameters)? as usize)
    }

    /// Leaves a text for the next call.
    fn write(&mut self, text: &str) -> Result<()> {
        let at = self.number("input", text.len() as u32)?;
        Ok(self.memory.write(&mut self.store, at, text.as_bytes())?)
    }

    /// The bytes that a call leaves.
    pub fn call<P: WasmParams>(&mut self, call: &str, parameters: P) -> Result<Vec<u8>> {
        let mut bytes = vec![0; self.number(call, parameters)?];
        let at = self.number("output", ())?;
        self.memory.read(&self.store, at, &mut bytes)?;
        Ok(bytes)
    }
}

/// A page: a call that breaks off for want of a function is made again with the next longer list.
pub struct Page<'a> {
    modules: &'a Modules,
    number: i32,
    joined: Joined,
    longer: VecDeque<&'a [String]>,
    /// The calls that needed a longer list.
    pub broke_off: Vec<String>,
}

impl Page<'_> {
    /// What a call answers to a text.
    pub fn ask(&mut self, call: &str, text: &str) -> Result<Vec<u8>> {
        loop {
            self.joined.write(text)?;
            let told = self.joined.call(call, self.number);
            let missing =
                |error: &Error| error.downcast_ref() == Some(&Trap::UnreachableCodeReached);
            if !told.as_ref().is_err_and(missing) {
                return told;
            }
            let Some(longer) = self.longer.pop_front() else {
                return told;
            };
            self.broke_off.push(call.to_owned());
            self.joined = self.modules.joined(&self.modules.packs(longer)?)?;
        }
    }

    /// What is drawn at a time, seen from elsewhere by so much.
    pub fn frame(&mut self, t: f64, about: f64) -> Result<Vec<u8>> {
        let drawn = self.joined.call("frame", (t, about, 0.0))?;
        if drawn.is_empty() {
            let reason = self.joined.call("failure", ())?;
            return Err(Error::msg(String::from_utf8(reason)?));
        }
        Ok(drawn)
    }
}
