//! What other programs do: cargo compiles and links, node traces.

use serde_json::Value;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fs};

const TARGET: &str = "wasm32-unknown-unknown";

/// The project's directory.
pub fn root() -> Result<PathBuf, Box<dyn Error>> {
    let here = env::current_dir()?;
    let found = here
        .ancestors()
        .find(|above| above.join("book/book.toml").is_file());
    found
        .map(Path::to_owned)
        .ok_or("there is no book/book.toml here or in any directory above".into())
}

/// Compiles and links the module of all pages; where it lies.
pub fn linked(root: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let cargo = env::var_os("CARGO").unwrap_or("cargo".into());
    let built = Command::new(cargo)
        .current_dir(root)
        .args([
            "rustc",
            "--quiet",
            "--locked",
            "--profile",
            "page",
            "--package",
            "live",
            "--target",
            TARGET,
        ])
        .args(["--", "-C", "link-arg=--emit-relocs"])
        .status()?;
    if !built.success() {
        return Err(format!(
            "the module was not compiled; the target is added by `rustup target add {TARGET}`"
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
        .arg(root.join("book/packs/src/trace.mjs"))
        .arg(root.join("book/theme/module.js"))
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
