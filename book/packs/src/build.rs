//! What other programs do: cargo compiles and links, node traces.

use serde_json::Value;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

const TARGET: &str = "wasm32-unknown-unknown";

/// What the module is compiled of.
const SOURCES: [&str; 9] = [
    "Cargo.toml",
    "Cargo.lock",
    "src",
    "examples",
    "tests/every_example",
    "book/kit",
    "book/live",
    "book/models",
    "book/packs",
];

/// Lanes of two doubles, the same bits as one by one; and half of the code that inlining would
/// make.
const CODE: &str = "-Ctarget-feature=+simd128 -Cllvm-args=-inline-threshold=50";

/// The project's directory.
pub fn root() -> Result<PathBuf, Box<dyn Error>> {
    let here = env::current_dir()?;
    let found = here.ancestors().find(|above| above.join("book/book.toml").is_file());
    found
        .map(Path::to_owned)
        .ok_or("there is no book/book.toml here or in any directory above".into())
}

/// Every file in a directory, or the file itself.
fn files(path: PathBuf, found: &mut Vec<PathBuf>) -> std::io::Result<()> {
    if !path.is_dir() {
        found.push(path);
        return Ok(());
    }
    for entry in fs::read_dir(path)? {
        files(entry?.path(), found)?;
    }
    Ok(())
}

/// A number that changes with the sources (FNV-1a of names and contents).
pub fn sources(root: &Path) -> Result<String, Box<dyn Error>> {
    let mut found = Vec::new();
    for source in SOURCES {
        files(root.join(source), &mut found)?;
    }
    found.sort();
    let mut hash = 0xcbf2_9ce4_8422_2325_u64;
    for file in found {
        let name = file.strip_prefix(root)?.to_string_lossy().replace('\\', "/");
        for byte in name.bytes().chain(fs::read(&file)?) {
            hash = (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
    Ok(format!("{hash:016x}"))
}

/// Compiles and links the module of all pages; where it lies.
pub fn linked(root: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let cargo = env::var_os("CARGO").unwrap_or("cargo".into());
    let home = env::var_os("CARGO_HOME").map(PathBuf::from);
    let home = home
        .or_else(|| Some(env::home_dir()?.join(".cargo")))
        .ok_or("there is no home directory")?;
    // The same bytes wherever it is compiled.
    let given = "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS";
    let flags = format!(
        "{} --remap-path-prefix={}=. --remap-path-prefix={}=crates {CODE}",
        env::var(given).unwrap_or_default(),
        root.display(),
        home.join("registry/src").display()
    );
    let built = Command::new(cargo)
        .current_dir(root)
        .args(["rustc", "--quiet", "--locked", "--profile", "page", "--package", "live"])
        .args(["--target", TARGET, "--", "-C", "link-arg=--emit-relocs"])
        .env(given, flags.trim())
        .status()?;
    if !built.success() {
        return Err(format!(
            "the module was not compiled; its target comes by `rustup target add {TARGET}`, or else \
             by `eval \"$(book/packs/toolchain.sh)\"`"
        )
        .into());
    }
    let target = env::var_os("CARGO_TARGET_DIR").map_or(root.join("target"), PathBuf::from);
    Ok(target.join(TARGET).join("page/live.wasm"))
}

/// What runs when pages move and tell.
pub fn traced(root: &Path, whole: &[u8]) -> Result<Value, Box<dyn Error>> {
    let file = env::temp_dir().join(format!("packs_{}", std::process::id()));
    fs::write(&file, whole)?;
    let node = Command::new("node")
        .arg(root.join("book/packs/trace.mjs"))
        .arg(&file)
        .stderr(Stdio::inherit())
        .output();
    fs::remove_file(&file)?;
    let node =
        node.map_err(|error| format!("node, which runs the module once, did not start: {error}"))?;
    if !node.status.success() {
        return Err("the module broke off in node".into());
    }
    Ok(serde_json::from_slice(&node.stdout)?)
}
