//! The modules of the pages, made anew where this machine can: they are compiled for another
//! target, and a reader who does not have it gets the committed ones.

use crate::project::Project;
use std::env;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// The committed modules.
const COMMITTED: &str = "book/modules";

/// Those made of sources that differ from the committed ones' sources; git ignores them.
const OWN: &str = "target/modules";

/// What `rustc` compiles the modules for.
const TARGET: &str = "wasm32-wasip1";

/// The directory of the modules that belong to the sources, as far as [`renew`] could make them.
pub fn directory(project: &Project) -> &'static str {
    match project.path(OWN).join("index.json").is_file() {
        true => OWN,
        false => COMMITTED,
    }
}

/// Whether the standard library is there for the target.
fn target_is_there() -> bool {
    let rustc = env::var_os("RUSTC").unwrap_or("rustc".into());
    let told = Command::new(rustc).args(["--print", "target-libdir", "--target", TARGET]).output();
    let told = told.ok().and_then(|told| String::from_utf8(told.stdout).ok());
    told.is_some_and(|libraries| PathBuf::from(libraries.trim()).is_dir())
}

/// Makes the modules anew if their target is there and the sources have changed since they were
/// made; without the target this is a question to `rustc`, and no more.
pub fn renew(project: &Project) {
    if target_is_there() && project.path(COMMITTED).is_dir() {
        let made = Command::new("node")
            .current_dir(project.path("."))
            .args(["book/live/modules.mjs", "--out", OWN])
            .status();
        if made.is_ok_and(|status| status.success()) {
            return;
        }
        eprintln!("the modules of the pages are the committed ones: new ones could not be made");
    }
    // What an earlier run left may be of other sources.
    let _ = fs::remove_file(project.path(OWN).join("index.json"));
}
