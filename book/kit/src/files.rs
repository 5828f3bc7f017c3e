//! Files that are written whole or not at all.

use crate::error::{Error, Result};
use std::fs::{self, File, FileType, Metadata, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The directories on the way to a place that are not there yet, the deepest first.
/// Unless they are kept, those that are empty are taken away again.
#[derive(Default)]
pub(super) struct Directories(Vec<PathBuf>);

impl Directories {
    pub(super) fn missing(place: &Path) -> Self {
        let missing = |p: &&Path| !p.as_os_str().is_empty() && !p.exists();
        Self(place.ancestors().take_while(missing).map(Into::into).collect())
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

/// Where the content of a file goes.
enum Place {
    /// A file: the new one takes its name when it is whole.
    File { path: PathBuf, replaced: Option<Metadata> },
    /// A pipe: what is written cannot be taken back.
    Pipe(PathBuf),
}

impl Place {
    /// What `path` leads to, through links.
    fn at(path: &Path) -> Result<Self> {
        Self::through(path, 40)
    }

    /// The same through at most so many links to what is not there.
    fn through(path: &Path, links: u32) -> Result<Self> {
        let refused = |reason: &str| {
            Err(Error::File { path: path.display().to_string(), reason: reason.into() })
        };
        let Ok(found) = fs::metadata(path) else {
            // A link to nothing yet is written through; it may lead to another.
            return match fs::read_link(path) {
                Ok(_) if links == 0 => refused("its links lead round in a circle"),
                Ok(to) => Self::through(&path.with_file_name(to), links - 1),
                Err(_) if path.file_name().is_none() => refused("it does not name a file"),
                Err(_) => Ok(Self::File { path: path.into(), replaced: None }),
            };
        };
        if found.is_dir() {
            return refused("it is a directory");
        }
        if is_pipe(found.file_type()) {
            return Ok(Self::Pipe(path.into()));
        }
        if !found.is_file() {
            return refused("it is a device; give a file or a pipe");
        }
        if found.permissions().readonly() {
            return refused("it is write-protected");
        }
        if is_standard_output(&found) {
            return refused("the report goes there; give another file");
        }
        Ok(Self::File {
            path: fs::canonicalize(path).map_err(|e| failure(path, &e))?,
            replaced: Some(found),
        })
    }
}

#[cfg(unix)]
fn is_pipe(kind: FileType) -> bool {
    std::os::unix::fs::FileTypeExt::is_fifo(&kind)
}

#[cfg(not(unix))]
fn is_pipe(_: FileType) -> bool {
    false
}

/// True if it is the file that standard output has been redirected to.
#[cfg(unix)]
fn is_standard_output(found: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    let same = |out: Metadata| (out.dev(), out.ino()) == (found.dev(), found.ino());
    fs::metadata("/dev/stdout").is_ok_and(same)
}

#[cfg(not(unix))]
fn is_standard_output(_: &Metadata) -> bool {
    false
}

/// Writes all `files` or none, through links: each goes to a temporary file beside its
/// place first, and only when all are complete do they take their names. What goes to a
/// pipe goes last. Returns how many files were there before.
///
/// # Errors
/// [`Error::File`] with the path and why it cannot be written.
pub fn write_whole(files: &[(PathBuf, &str)]) -> Result<usize> {
    let mut staged = Vec::new();
    let mut outcome = files.iter().try_for_each(|(path, content)| {
        match Place::at(path)? {
            Place::File { path, replaced } => {
                staged.push((stage(&path, content, &replaced)?, path, replaced))
            }
            Place::Pipe(_) => {}
        }
        Ok(())
    });
    for (temporary, path, _) in &staged {
        if outcome.is_ok() {
            outcome = fs::rename(temporary, path).map_err(|e| failure(path, &e));
        }
    }
    for (temporary, ..) in &staged {
        // Renamed and gone, unless something failed.
        let _ = fs::remove_file(temporary);
    }
    outcome?;
    for (path, content) in files {
        if let Place::Pipe(path) = Place::at(path)? {
            let pipe = OpenOptions::new().write(true).open(&path);
            pipe.and_then(|mut pipe| pipe.write_all(content.as_bytes()))
                .map_err(|e| failure(&path, &e))?;
        }
    }
    Ok(staged.iter().filter(|(.., was)| was.is_some()).count())
}

/// A temporary file beside `path` with this content, on the disk.
fn stage(path: &Path, content: &str, replaced: &Option<Metadata>) -> Result<PathBuf> {
    let mut hidden = std::ffi::OsString::from(".");
    hidden.push(path.file_name().unwrap_or_default());
    hidden.push(format!(".{}.tmp", std::process::id()));
    let temporary = path.with_file_name(hidden);
    let write = |mut file: File| {
        file.write_all(content.as_bytes())?;
        if let Some(was) = replaced {
            file.set_permissions(was.permissions())?;
        }
        file.sync_all()
    };
    let mut new = OpenOptions::new();
    let file = new.write(true).create_new(true).open(&temporary);
    let file = file.map_err(|e| failure(path, &e))?;
    write(file).map_err(|e| {
        let _ = fs::remove_file(&temporary);
        failure(path, &e)
    })?;
    Ok(temporary)
}

pub(super) fn failure(path: &Path, error: &std::io::Error) -> Error {
    Error::File { path: path.display().to_string(), reason: error.to_string() }
}
