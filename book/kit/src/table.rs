//! Tables as text: aligned columns, at least two spaces apart, and back again.

use crate::error::{Error, Result};
use core::fmt;

/// A table of text with a heading; every cell is non-empty and has no run of two spaces.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    heading: String,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// Accepts text that survives in a table: one line, not empty, trimmed, no two
/// spaces in a row.
pub(super) fn check_cell(cell: &str) -> Result<()> {
    let fits = !cell.is_empty()
        && cell.trim() == cell
        && !cell.contains("  ")
        && !cell.chars().any(char::is_control);
    if fits {
        Ok(())
    } else {
        Err(Error::Text {
            text: cell.into(),
            allowed: "text in a table is one line, not empty, without two spaces in a row",
        })
    }
}

impl Table {
    /// An empty table named `name` (`[a-z0-9_]+`; it appears as `table NAME`).
    ///
    /// # Errors
    /// [`Error::Text`] for a name or a column that a table cannot hold.
    pub fn new<S: Into<String>>(name: &str, columns: impl IntoIterator<Item = S>) -> Result<Self> {
        let plain = !name.is_empty()
            && name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_');
        if !plain {
            return Err(Error::Text {
                text: name.into(),
                allowed: "the name of a table has only a-z, 0-9 and _",
            });
        }
        Self::headed(format!("table {name}"), columns)
    }

    /// A table with a row for each of `items`: the cells that `row` makes of it.
    ///
    /// ```
    /// use kit::Table;
    /// let cells = |n: u32| Ok([n.to_string(), (n * n).to_string()]);
    /// let table = Table::of("squares", "number, square".split(", "), 1..=3, cells)?;
    /// assert_eq!(table.rows()[2], ["3", "9"]);
    /// # Ok::<(), kit::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Table::new`] and [`Table::push`], and those of `row`.
    pub fn of<I, S: Into<String>, R: IntoIterator<Item: Into<String>>>(
        name: &str,
        columns: impl IntoIterator<Item = S>,
        items: impl IntoIterator<Item = I>,
        mut row: impl FnMut(I) -> Result<R>,
    ) -> Result<Self> {
        let mut table = Self::new(name, columns)?;
        for item in items {
            table.push(row(item)?)?;
        }
        Ok(table)
    }

    pub(super) fn headed<S: Into<String>>(
        heading: impl Into<String>,
        columns: impl IntoIterator<Item = S>,
    ) -> Result<Self> {
        let columns: Vec<String> = columns.into_iter().map(Into::into).collect();
        for column in &columns {
            check_cell(column)?;
        }
        if columns.is_empty() {
            return Err(Error::Text {
                text: String::new(),
                allowed: "a table has at least one column",
            });
        }
        Ok(Self { heading: heading.into(), columns, rows: Vec::new() })
    }

    /// Appends a row.
    ///
    /// # Errors
    /// [`Error::Text`] if a cell does not fit, or their number differs from the columns'.
    pub fn row<S: Into<String>>(mut self, cells: impl IntoIterator<Item = S>) -> Result<Self> {
        self.push(cells)?;
        Ok(self)
    }

    /// Appends a row, in place; errors as [`Table::row`].
    pub fn push<S: Into<String>>(&mut self, cells: impl IntoIterator<Item = S>) -> Result<()> {
        let cells: Vec<String> = cells.into_iter().map(Into::into).collect();
        for cell in &cells {
            check_cell(cell)?;
        }
        if cells.len() != self.columns.len() {
            return Err(Error::Text {
                text: cells.join("  "),
                allowed: "a row has as many cells as the table has columns",
            });
        }
        self.rows.push(cells);
        Ok(())
    }

    /// `claims`, `limits`, …, or `table NAME`.
    pub fn heading(&self) -> &str {
        &self.heading
    }
    /// The names of the columns.
    pub fn columns(&self) -> &[String] {
        &self.columns
    }
    /// The rows, each as long as [`Table::columns`].
    pub fn rows(&self) -> &[Vec<String>] {
        &self.rows
    }
    /// True if there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

impl fmt::Display for Table {
    /// Heading, column names, rows; each line ends with a newline and has no trailing
    /// space. Where a column has a negative number, the others leave room for the sign.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let signed: Vec<bool> = (0..self.columns.len())
            .map(|i| i > 0 && self.rows.iter().any(|row| is_negative(&row[i])))
            .collect();
        let shown = |i: usize, cell: &str| -> String {
            let room = if signed[i] && !is_negative(cell) { " " } else { "" };
            format!("{room}{cell}")
        };
        let lines: Vec<Vec<String>> = core::iter::once(&self.columns)
            .chain(&self.rows)
            .map(|line| line.iter().enumerate().map(|(i, cell)| shown(i, cell)).collect())
            .collect();
        let mut widths = vec![0; self.columns.len()];
        for line in &lines {
            for (width, cell) in widths.iter_mut().zip(line) {
                *width = (*width).max(cell.chars().count());
            }
        }
        writeln!(f, "{}", self.heading)?;
        for line in &lines {
            let mut padding = 0;
            for (width, cell) in widths.iter().zip(line) {
                write!(f, "{:padding$}{cell}", "")?;
                padding = width - cell.chars().count() + 2;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

/// True for a number with a minus sign; `-` alone stands for nothing.
fn is_negative(cell: &str) -> bool {
    cell.starts_with('-') && cell.parse::<f64>().is_ok()
}

/// A report read back from its text; see [`parse`].
#[derive(Debug, Clone, PartialEq)]
pub struct Parsed {
    /// The first line.
    pub title: String,
    /// The lines between the title and the first section, joined by spaces.
    pub description: String,
    /// The sections in order.
    pub tables: Vec<Table>,
}

impl Parsed {
    /// The section with this heading.
    pub fn table(&self, heading: &str) -> Option<&Table> {
        self.tables.iter().find(|t| t.heading == heading)
    }
}

/// Reads the text of a report, in the grammar given in [the crate](crate).
///
/// # Errors
/// [`Error::Text`] with the line that does not fit.
pub fn parse(text: &str) -> Result<Parsed> {
    let mut blocks =
        text.split("\n\n").map(|block| block.trim_matches('\n')).filter(|block| !block.is_empty());
    let head = blocks.next().unwrap_or("");
    let (title, description) = head.split_once('\n').unwrap_or((head, ""));
    check_cell(title)?;
    let mut tables = Vec::new();
    for block in blocks {
        let mut lines = block.lines();
        let heading = lines.next().unwrap_or("");
        let cells = |line: &str| -> Vec<String> {
            line.split("  ")
                .map(str::trim)
                .filter(|cell| !cell.is_empty())
                .map(Into::into)
                .collect()
        };
        let mut table = Table::headed(heading, cells(lines.next().unwrap_or("")))?;
        for line in lines {
            table.push(cells(line))?;
        }
        tables.push(table);
    }
    Ok(Parsed { title: title.into(), description: description.replace('\n', " "), tables })
}
