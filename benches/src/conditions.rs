//! Under which conditions times were measured: the first table of every record.

use kit::Table;
use std::error::Error;
use std::fs;
use std::process::Command;

/// Processor, compiler and date.
#[derive(Debug, Clone, Default)]
pub struct Conditions {
    processor: Option<String>,
    compiler: Option<String>,
    date: Option<String>,
}

impl Conditions {
    /// From the flags `--date`, `--processor` and `--compiler` of the binary `name`; the
    /// processor and the compiler are asked if they are not given.
    ///
    /// # Errors
    /// Another flag, a flag without a value, a machine that does not say what it is.
    pub fn read(
        name: &str,
        mut arguments: impl Iterator<Item = String>,
    ) -> Result<Self, Box<dyn Error>> {
        let mut conditions = Self::default();
        while let Some(flag) = arguments.next() {
            let field = match flag.as_str() {
                "--processor" => &mut conditions.processor,
                "--compiler" => &mut conditions.compiler,
                "--date" => &mut conditions.date,
                _ => Err(format!(
                    "usage: {name} [--date DATE] [--processor NAME] [--compiler NAME]"
                ))?,
            };
            *field = Some(arguments.next().ok_or(format!("{flag} needs a value"))?);
        }
        conditions.processor = match conditions.processor {
            None => Some(processor().ok_or("name the processor with --processor")?),
            named => named,
        };
        conditions.compiler = match conditions.compiler {
            None => Some(compiler().ok_or("name the compiler with --compiler")?),
            named => named,
        };
        Ok(conditions)
    }

    /// The table `conditions` of a record.
    ///
    /// # Errors
    /// A name that a table cannot hold.
    pub fn table(&self) -> kit::Result<Table> {
        let mut table = Table::new("conditions", ["condition", "value"])?;
        let all = [
            ("processor", &self.processor),
            ("compiler", &self.compiler),
            ("date", &self.date),
        ];
        for (name, value) in all {
            if let Some(value) = value {
                table.push([name, value])?;
            }
        }
        Ok(table)
    }
}

fn said_by(command: &str, arguments: &[&str]) -> Option<String> {
    let said = Command::new(command).args(arguments).output().ok()?;
    let said = String::from_utf8(said.stdout).ok()?;
    (!said.trim().is_empty()).then(|| said.trim().to_owned())
}

/// The processor's model, without marks of trade.
fn processor() -> Option<String> {
    let model = match fs::read_to_string("/proc/cpuinfo") {
        Ok(text) => {
            let line = text.lines().find(|line| line.starts_with("model name"))?;
            line.split_once(':')?.1.to_owned()
        }
        Err(_) => said_by("sysctl", &["-n", "machdep.cpu.brand_string"])?,
    };
    let plain = model.replace("(R)", "").replace("(TM)", "");
    Some(plain.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// `rustc 1.95.0`, without commit and date.
fn compiler() -> Option<String> {
    let version = said_by("rustc", &["--version"])?;
    let mut words = version.split(' ');
    Some(format!("{} {}", words.next()?, words.next()?))
}
