//! Files that are written whole or not at all.

use crate::error::{Error, Result};
use std::fs::{self, File, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The directories on the way to a place that are not there yet, the deepest first.
/// Unless they are kept, those that are empty are taken away again.
#[derive(Default)]
pub(super) struct Directories(Vec<PathBuf>);

impl Directories {
    pub(super) fn missing(place: &Path) -> Self {
        let missing = |p: &&Path| !p.as_os_str().is_empty() && !p.exists();
        Self(
            place
                .ancestors()
                .take_while(missing)
                .map(Into::into)
                .collect(),
        )
    }

    pub(super) fn keep(mut self) {
        self.0.clear();
    }
}

impl Drop for Directories {
    fn drop(&mut self) {
        for directory in &self.0 {
            // It may never have been made, or hold what others put there.
            let _ = fs::remove_dir(directory);
        }
    }
}

/// Writes all `files` or none: each goes to a temporary file beside its place
/// first, and only when all are complete are they renamed.
pub(super) fn write_whole(files: &[(PathBuf, &str)]) -> Result<()> {
    let mut staged: Vec<(PathBuf, &Path)> = Vec::new();
    let mut outcome = Ok(());
    for (path, content) in files {
        match stage(path, content) {
            Ok(temporary) => staged.push((temporary, path)),
            Err(error) => {
                outcome = Err(error);
                break;
            }
        }
    }
    if outcome.is_ok() {
        for (temporary, path) in &staged {
            if let Err(e) = fs::rename(temporary, path) {
                outcome = Err(failure(path, &e));
                break;
            }
        }
    }
    if outcome.is_err() {
        for (temporary, _) in &staged {
            // Already renamed or already gone: nothing is left to clean.
            let _ = fs::remove_file(temporary);
        }
    }
    outcome
}

fn stage(path: &Path, content: &str) -> Result<PathBuf> {
    let name = path.file_name().ok_or_else(|| Error::File {
        path: path.display().to_string(),
        reason: "it does not name a file".into(),
    })?;
    if path.is_dir() {
        return Err(Error::File {
            path: path.display().to_string(),
            reason: "it is a directory".into(),
        });
    }
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}.tmp", std::process::id()));
    let temporary = path.with_file_name(hidden);
    let written = OpenOptions::new()
        .write(true)
        .create_new(true)
        .open(&temporary)
        .map_err(|e| failure(path, &e))
        .and_then(|file: File| {
            (&file)
                .write_all(content.as_bytes())
                .and_then(|()| file.sync_all())
                .map_err(|e| {
                    let _ = fs::remove_file(&temporary);
                    failure(path, &e)
                })
        });
    written.map(|()| temporary)
}

pub(super) fn failure(path: &Path, error: &std::io::Error) -> Error {
    Error::File {
        path: path.display().to_string(),
        reason: error.to_string(),
    }
}
