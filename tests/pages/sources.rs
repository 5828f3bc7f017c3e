//! What the sources of the examples, of the library and of the kit must not do: they will run in
//! the page, where there is no clock, no file and no thread.

use std::fs;
use std::path::{Path, PathBuf};

/// What tells of a clock, a file, a thread, or the process around.
const FORBIDDEN: [&str; 7] = [
    "Instant",
    "SystemTime",
    "std::fs",
    "std::thread",
    "std::env",
    "println!",
    "std::process::Command",
];

/// The only files that may: the command line, what it writes, what `--cfg registers` asks, and the
/// maker of problem sheets, which is a program for the desk.
const ALLOWED: [&str; 5] = [
    "src/math/lane/registers.rs",
    "book/kit/src/cli.rs",
    "book/kit/src/files.rs",
    "examples/problem_sheet/exercise.rs",
    "examples/problem_sheet/sheet.rs",
];

/// What is forbidden in this source, outside of comments and of its tests.
fn forbidden(source: &str) -> Vec<&'static str> {
    let code = source.split("#[cfg(test)]").next().unwrap_or(source);
    let code: Vec<&str> = code
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .collect();
    let code = code.join("\n");
    FORBIDDEN
        .into_iter()
        .filter(|word| code.contains(word))
        .collect()
}

/// Adds the Rust files below a directory.
pub fn rust_files(directory: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(directory).expect("readable") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            rust_files(&path, files);
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
}

#[test]
fn no_clock_no_file_no_thread() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut files = Vec::new();
    rust_files(&root.join("src"), &mut files);
    rust_files(&root.join("book/kit/src"), &mut files);
    rust_files(&root.join("examples"), &mut files);
    let (mut seen, mut excused) = (0, 0);
    for file in files {
        let name = file.strip_prefix(&root).expect("below the root");
        let name = name.to_string_lossy().replace('\\', "/");
        let found = forbidden(&fs::read_to_string(&file).expect("readable"));
        if ALLOWED.contains(&name.as_str()) {
            excused += usize::from(!found.is_empty());
        } else {
            assert!(found.is_empty(), "{name}: {found:?}");
        }
        seen += 1;
    }
    assert!(seen > 100, "only {seen} files seen");
    assert_eq!(excused, ALLOWED.len());
    // The damaged twins.
    assert_eq!(forbidden("let t = Instant::now();"), ["Instant"]);
    assert_eq!(forbidden("// Instant\nuse std::fs::File;"), ["std::fs"]);
}
