//! `accuracy_kit DATA OUT`: for each `DATA/<family>.in` that this library can
//! answer, writes `OUT/rotation__<family>.out`, one line per row, `E:...` for an
//! error.

use kit::cli::alive;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::{env, fs, process};

fn main() {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [data, out] = arguments.as_slice() else {
        eprintln!("usage: accuracy_kit DATA OUT");
        process::exit(2);
    };
    match alive(|| run(Path::new(data), Path::new(out))) {
        Ok(files) => println!("{files} files written to {out}"),
        Err(error) => {
            eprintln!("{error}");
            process::exit(1);
        }
    }
}

fn run(data: &Path, out: &Path) -> Result<usize, String> {
    let at = |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
    fs::create_dir_all(out).map_err(|e| at(out, e))?;
    let mut inputs: Vec<_> = fs::read_dir(data)
        .map_err(|e| at(data, e))?
        .filter_map(|entry| entry.ok().map(|e| e.path()))
        .filter(|path| path.extension().is_some_and(|e| e == "in"))
        .collect();
    inputs.sort();
    let mut files = 0;
    for input in inputs {
        let family = input.file_stem().unwrap_or_default().to_string_lossy();
        let Some(answer) = benches::kit::answerer(&family) else {
            eprintln!("{family}: not a family of this library");
            continue;
        };
        let path = out.join(format!("rotation__{family}.out"));
        let mut file = BufWriter::new(fs::File::create(&path).map_err(|e| at(&path, e))?);
        for row in fs::read_to_string(&input).map_err(|e| at(&input, e))?.lines() {
            let line = match answer(&row.split_whitespace().collect::<Vec<_>>()) {
                Ok(values) => values.iter().map(|v| format!("{v:e}")).collect::<Vec<_>>().join(" "),
                Err(error) => format!("E:{error}"),
            };
            writeln!(file, "{line}").map_err(|e| at(&path, e))?;
        }
        file.flush().map_err(|e| at(&path, e))?;
        files += 1;
    }
    Ok(files)
}
