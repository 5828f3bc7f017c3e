//! An example: its name everywhere, what it can be told, what it computes and draws.

use super::cli::{self, Leaf, Outcome};
use super::live::set_lines;
use super::parameters::{Settings, check, table};
use super::recorded::{Asked, Recorded, Recordings};
use super::{Figure, Flag, Grid, Lab, MovingPicture, ParameterSet, Report, Trajectory};
use crate::error::{Error, Result};

/// What stands behind a page: the functions of an example and their parameters.
///
/// Nothing in them reads a clock or a file or starts a thread, so they run anywhere.
///
/// ```
/// use kit::Result;
/// use kit::{Example, Report, Trajectory, claim};
///
/// kit::parameters! {
///     /// A thin rod.
///     pub struct Parameters {
///         /// length of the rod
///         length: number(3.0, "m", above(0.0));
///     }
/// }
/// fn report(p: &Parameters) -> Result<Report> {
///     let mut report = Report::new("A rod", "a thin rod about its middle")?;
///     let (l, i) = (p.length, p.length * p.length / 12.0);
///     report.add(claim("inertia", "moment of inertia over mass", i, "m^2").within(1e-15)
///         .against("end, moved to the middle", l * l / 3.0 - l * l / 4.0))?;
///     Ok(report)
/// }
/// const EXAMPLE: Example<Parameters> = Example {
///     stem: "rod",
///     about: "A thin rod about its middle",
///     report,
///     figures: |_| Ok(Vec::new()),
///     trajectory: |_| Trajectory::new(["t [s]"]),
///     moving_picture: None,
///     recordings: None,
/// };
/// let outcome = EXAMPLE.answer(["--length", "6", "--check", "inertia=3.0"]);
/// assert_eq!((outcome.code, outcome.stdout.as_str()), (0, "right: inertia = 3.00000000000000 m^2\n"));
/// assert_eq!(EXAMPLE.answer(["--length", "-6"]).code, 2);
/// # Ok::<(), kit::Error>(())
/// ```
pub struct Example<P: 'static> {
    /// The stem that names the page, the example and the snapshot.
    pub stem: &'static str,
    /// One line for `--help`.
    pub about: &'static str,
    /// The numbers.
    pub report: fn(&P) -> Result<Report>,
    /// The drawings.
    pub figures: fn(&P) -> Result<Vec<Figure>>,
    /// The motion, for `--csv`.
    pub trajectory: fn(&P) -> Result<Trajectory>,
    /// The drawing that moves, if something does.
    pub moving_picture: Option<fn(&P) -> Result<MovingPicture>>,
    /// What it does with a reader's own recording, if it reads any.
    pub recordings: Option<Recordings<P>>,
}

impl<P: ParameterSet> Example<P> {
    /// The numbers for these parameters, which are listed first.
    ///
    /// # Errors
    /// [`crate::Error::Parameter`] if a parameter may not have its value; those of the example.
    pub fn report(&self, parameters: &P) -> Result<Report> {
        report(&self.with(parameters.clone()))
    }

    /// The drawings, and the stills of the one that moves.
    ///
    /// # Errors
    /// As [`Example::report`].
    pub fn figures(&self, parameters: &P) -> Result<Vec<Figure>> {
        figures(&self.with(parameters.clone()))
    }

    /// The moving picture at `t`; prepares everything anew: to draw many, keep the picture.
    ///
    /// # Errors
    /// As [`Example::report`], and [`Error::OutsideRun`](rotation_dynamics::Error::OutsideRun);
    /// `None` if nothing moves.
    pub fn frame(&self, parameters: &P, t: f64) -> Result<Option<Figure>> {
        parameters.check()?;
        let Some(picture) = self.moving_picture else {
            return Ok(None);
        };
        picture(parameters)?.frame(t).map(Some)
    }

    /// It, whatever its parameters.
    pub const fn page(&self) -> &dyn Page {
        self
    }

    fn with(&self, parameters: P) -> Running<'_, P> {
        Running { example: self, parameters }
    }

    /// With its defaults.
    pub(super) fn run(&self) -> Running<'_, P> {
        self.with(P::default())
    }
}

/// An example with its parameters, whatever their type: what is written for it is compiled once
/// for all examples.
pub trait Run {
    fn stem(&self) -> &'static str;
    fn about(&self) -> &'static str;
    fn parameters(&self) -> &dyn Settings;
    fn parameters_mut(&mut self) -> &mut dyn Settings;
    /// What the example itself says, parameters unchecked and unlisted.
    fn numbers(&self) -> Result<Report>;
    /// The drawings that do not move, parameters unchecked.
    fn drawings(&self) -> Result<Vec<Figure>>;
    fn trajectory(&self) -> Result<Trajectory>;
    fn moves(&self) -> bool;
    fn moving_picture(&self) -> Result<Option<MovingPicture>>;
    /// Whether it reads recordings, and whether these hold several numbered pieces.
    fn reads(&self) -> Option<bool>;
    /// A made-up recording, if it reads any.
    fn made(&self) -> Option<String>;
    /// What it makes of a recording, if it reads any, parameters unchecked.
    fn recorded(&self, name: &str, bytes: &[u8], asked: &Asked) -> Option<Result<Recorded>>;
}

/// An example with its parameters.
pub(super) struct Running<'e, P: 'static> {
    example: &'e Example<P>,
    parameters: P,
}

impl<P: ParameterSet> Run for Running<'_, P> {
    fn stem(&self) -> &'static str {
        self.example.stem
    }
    fn about(&self) -> &'static str {
        self.example.about
    }
    fn parameters(&self) -> &dyn Settings {
        &self.parameters
    }
    fn parameters_mut(&mut self) -> &mut dyn Settings {
        &mut self.parameters
    }
    fn numbers(&self) -> Result<Report> {
        (self.example.report)(&self.parameters)
    }
    fn drawings(&self) -> Result<Vec<Figure>> {
        (self.example.figures)(&self.parameters)
    }
    fn trajectory(&self) -> Result<Trajectory> {
        (self.example.trajectory)(&self.parameters)
    }
    fn moves(&self) -> bool {
        self.example.moving_picture.is_some()
    }
    fn moving_picture(&self) -> Result<Option<MovingPicture>> {
        let picture = self.example.moving_picture;
        picture.map(|picture| picture(&self.parameters)).transpose()
    }
    fn reads(&self) -> Option<bool> {
        self.example.recordings.as_ref().map(|recordings| recordings.throws)
    }
    fn made(&self) -> Option<String> {
        self.example.recordings.as_ref().map(|recordings| (recordings.made)())
    }
    fn recorded(&self, name: &str, bytes: &[u8], asked: &Asked) -> Option<Result<Recorded>> {
        let recordings = self.example.recordings.as_ref()?;
        Some((recordings.recorded)(&self.parameters, name, bytes, asked))
    }
}

/// The numbers, the parameters first.
pub(super) fn report(run: &dyn Run) -> Result<Report> {
    check(run.parameters())?;
    let mut report = run.numbers()?;
    report.set_parameters(table(run.parameters())?);
    Ok(report)
}

/// The drawings, and the stills of the one that moves.
pub(super) fn figures(run: &dyn Run) -> Result<Vec<Figure>> {
    let mut figures = drawings(run)?;
    if let Some(picture) = run.moving_picture()? {
        figures.extend(picture.stills()?);
    }
    Ok(figures)
}

/// The drawings that do not move.
fn drawings(run: &dyn Run) -> Result<Vec<Figure>> {
    check(run.parameters())?;
    run.drawings()
}

/// The methods to try, with these lines set.
fn lab(run: &mut dyn Run, settings: &str) -> Result<Option<Lab>> {
    set_lines(run.parameters_mut(), settings)?;
    Ok(report(run)?.lab().cloned())
}

/// The names of flags that a problem sheet draws, and their values.
fn drawn(run: &dyn Run) -> Vec<(String, Grid)> {
    let grid = |flag: &Flag| Some((flag.name(), flag.grid()?));
    run.parameters().flags().iter().filter_map(grid).collect()
}

/// Sets these numbers, the others as they are.
fn set(parameters: &mut dyn Settings, flags: &[(&str, f64)]) -> Result<()> {
    let known = parameters.flags();
    let numbers = || known.iter().filter(|flag| flag.words().is_empty());
    for (name, value) in flags {
        let unknown = || Error::UnknownKey {
            key: (*name).to_owned(),
            known: numbers().map(Flag::name).collect::<Vec<_>>().join(", "),
        };
        let flag = numbers().find(|flag| flag.name() == *name);
        flag.ok_or_else(unknown)?.set_number(parameters, *value);
    }
    Ok(())
}

/// Makes the [`EXAMPLE`](Example) of a file, and its `main`: the stem, one line for
/// `--help`, and the functions `report`, `figures`, `trajectory` and, if something moves,
/// `moving_picture`, in this order; after a semicolon [`Recordings`](crate::Recordings), if it reads a
/// reader's own. The parameters are the type `Parameters` of the file.
///
/// In place of the function `report` may stand the report's title and description, and the
/// functions that add its sections.
///
/// ```
/// use kit::Result;
/// use kit::{Figure, Page, Report, Trajectory};
/// # fn figures(_: &Parameters) -> Result<Vec<Figure>> { Ok(Vec::new()) }
/// # fn trajectory(_: &Parameters) -> Result<Trajectory> { Trajectory::new(["t [s]"]) }
///
/// kit::parameters! {
///     /// A thin rod.
///     pub struct Parameters {
///         /// length of the rod
///         length: number(3.0, "m", above(0.0));
///     }
/// }
/// fn report(_: &Parameters) -> Result<Report> {
///     Report::new("A rod", "a thin rod about its middle")
/// }
/// kit::example! { rod: "A thin rod"; report, figures, trajectory }
/// # fn checked() { assert_eq!(EXAMPLE.stem(), "rod"); }
/// ```
///
/// ```
/// # use kit::prelude::*;
/// # fn figures(_: &Parameters) -> Result<Vec<Figure>> { Ok(Vec::new()) }
/// # fn trajectory(_: &Parameters) -> Result<Trajectory> { Trajectory::new(["t [s]"]) }
/// # parameters! {
/// #     /// A thin rod.
/// #     pub struct Parameters {
/// #         /// length of the rod
/// #         length: number(3.0, "m", above(0.0));
/// #     }
/// # }
/// fn claims(p: &Parameters, report: &mut Report) -> Result<()> {
///     claims! { report,
///         /// half of it
///         half: 0.5 * p.length, "m", "to the end" => p.length - 0.5 * p.length, within 1e-15;
///     }
/// }
/// example! {
///     rod: "A thin rod"; "A rod", "a thin rod about its middle", [claims]; figures, trajectory
/// }
/// ```
#[macro_export]
macro_rules! example {
    ($stem:ident: $about:literal;
     $title:literal, $description:literal, [$($section:path),+ $(,)?];
     $figures:expr, $trajectory:expr $(, $moves:expr)? $(; $recordings:expr)?) => {
        /// Every number of the page.
        fn report(p: &Parameters) -> $crate::Result<$crate::Report> {
            let mut report = $crate::Report::new($title, $description)?;
            $( $section(p, &mut report)?; )+
            Ok(report)
        }

        $crate::example! { $stem: $about; report, $figures, $trajectory $(, $moves)? $(; $recordings)? }
    };
    ($stem:ident: $about:literal; $report:expr, $figures:expr, $trajectory:expr $(, $moves:expr)?
     $(; $recordings:expr)?) => {
        /// The example, as the command line, the tests and the book see it.
        pub const EXAMPLE: $crate::Example<Parameters> = $crate::Example {
            stem: stringify!($stem),
            about: $about,
            report: $report,
            figures: $figures,
            trajectory: $trajectory,
            moving_picture: $crate::example!(@maybe $($moves)?),
            recordings: $crate::example!(@maybe $($recordings)?),
        };

        fn main() -> std::process::ExitCode {
            let run = || EXAMPLE.main();
            $crate::example!(@run run)
        }
    };
    (@run $run:ident) => {{
        // Where it is only checked whether it compiles, no code is made for it.
        #[cfg(only_checked)]
        {
            drop($run);
            $crate::cli::only_checked()
        }
        #[cfg(not(only_checked))]
        $run()
    }};
    (@maybe) => { None };
    (@maybe $part:expr) => { Some($part) };
}

/// An example whose type of parameters is not asked for: with their defaults it is what the
/// tests lock and the book shows.
pub trait Page: Sync {
    /// It with its default parameters, of whatever type: the one thing that is compiled for each.
    #[doc(hidden)]
    fn with_defaults(&self) -> Box<dyn Run + '_>;

    /// The stem.
    fn stem(&self) -> &'static str;
}

/// What is asked of a page: on the pointer, so that it is compiled once for all.
impl dyn Page + '_ {
    /// The names of the flags.
    pub fn flags(&self) -> Vec<String> {
        let run = self.with_defaults();
        run.parameters().flags().iter().map(Flag::name).collect()
    }
    /// The numbers.
    ///
    /// # Errors
    /// Those of the example; none for a sound one.
    pub fn report(&self) -> Result<Report> {
        report(&*self.with_defaults())
    }
    /// The drawings, with the stills.
    ///
    /// # Errors
    /// As `report`.
    pub fn figures(&self) -> Result<Vec<Figure>> {
        figures(&*self.with_defaults())
    }
    /// The moving picture, if there is one.
    ///
    /// # Errors
    /// As `report`.
    pub fn moving_picture(&self) -> Result<Option<MovingPicture>> {
        self.with_defaults().moving_picture()
    }
    /// What a problem sheet draws: the names of flags, and their values.
    pub fn drawn(&self) -> Vec<(String, Grid)> {
        drawn(&*self.with_defaults())
    }
    /// The numbers with these flags set.
    ///
    /// # Errors
    /// As [`Example::report`], and [`Error::UnknownKey`] for a flag that is none or no number.
    pub fn report_with(&self, flags: &[(&str, f64)]) -> Result<Report> {
        let mut run = self.with_defaults();
        set(run.parameters_mut(), flags)?;
        report(&*run)
    }
    /// The drawings, without stills, with these flags set.
    ///
    /// # Errors
    /// As `report_with`.
    pub fn figures_with(&self, flags: &[(&str, f64)]) -> Result<Vec<Figure>> {
        let mut run = self.with_defaults();
        set(run.parameters_mut(), flags)?;
        drawings(&*run)
    }
    /// What it is and its parameters are, as JSON for the controls of its page.
    pub fn declared(&self) -> String {
        super::live::declared(&*self.with_defaults())
    }
    /// The methods for a reader to try, with these lines set as in
    /// [`Moves::opened`](super::Moves::opened); `None` where no motion is known exactly.
    ///
    /// # Errors
    /// As there, and as `report`.
    pub fn lab(&self, settings: &str) -> Result<Option<Lab>> {
        lab(&mut *self.with_defaults(), settings)
    }
    /// What it prints for these arguments, parted by spaces.
    pub fn answer(&self, arguments: &str) -> Outcome {
        let arguments = arguments.split_whitespace().map(Into::into).collect();
        cli::answer(&mut *self.with_defaults(), arguments)
    }
    /// The same for arguments one by one, with the files that it would write.
    pub fn answer_with_files(&self, arguments: Vec<String>) -> (Outcome, Vec<Leaf>) {
        let arguments = arguments.into_iter().map(Into::into).collect();
        cli::answer_with_files(&mut *self.with_defaults(), arguments)
    }
    /// The numbers for these arguments; its accuracy strip is computed when it is read.
    ///
    /// # Errors
    /// What is printed instead of running.
    pub fn report_for(&self, arguments: &str) -> core::result::Result<Report, Outcome> {
        let arguments = arguments.split_whitespace().map(Into::into).collect();
        cli::report_for(&mut *self.with_defaults(), arguments)
    }
    /// The drawings for these arguments, with the stills.
    ///
    /// # Errors
    /// What is printed instead of running.
    pub fn figures_for(
        &self,
        arguments: Vec<String>,
    ) -> core::result::Result<Vec<Figure>, Outcome> {
        let arguments = arguments.into_iter().map(Into::into).collect();
        cli::figures_for(&mut *self.with_defaults(), arguments)
    }
    /// A made-up recording, if it reads any.
    pub fn made(&self) -> Option<String> {
        self.with_defaults().made()
    }
    /// What it makes of the bytes of a recording, with these arguments, of which `--recording` names
    /// the file.
    ///
    /// # Errors
    /// What is printed instead.
    pub fn recorded_for(
        &self,
        arguments: Vec<String>,
        bytes: &[u8],
    ) -> core::result::Result<Recorded, Outcome> {
        let arguments = arguments.into_iter().map(Into::into).collect();
        cli::recorded_for(&mut *self.with_defaults(), arguments, bytes)
    }
}

impl<P: ParameterSet> Page for Example<P> {
    fn with_defaults(&self) -> Box<dyn Run + '_> {
        Box::new(self.run())
    }
    fn stem(&self) -> &'static str {
        self.stem
    }
}
