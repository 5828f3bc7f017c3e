//! Claims, limits, effects and figures as a table in the source, one entry a line.

/// Adds claims to a report: what it is as a doc comment, then the key, the value, its unit,
/// the independent route and what it gives, and the bound. What a student would compute goes
/// `in` a group of the answer box; below it stand wrong answers that people give, each with a
/// hint. An answer may be off by the part that is `judged` right, a thousandth if nothing is
/// said; a wrong answer that is nearer needs it. A claim with an `if` is made only where that
/// is true, and not computed elsewhere.
/// Evaluates to a `Result`.
///
/// ```
/// use kit::Report;
/// let (length, tau) = (2.0_f64, core::f64::consts::TAU);
/// let mut report = Report::new("A pendulum", "a weight on a string")?;
/// kit::claims! { report,
///     /// time of a swing to and fro
///     period: tau * (length / 9.81).sqrt(), "s", "by hand" => 2.837, within 1e-3, in "The swing":
///         0.5 * tau * (length / 9.81).sqrt() => "that is the time from side to side",
///         tau * (9.81 / length).sqrt() => "look at the unit";
///     /// the same, squared
///     square: tau * tau * length / 9.81, "s^2", "by hand" => 8.049, within 1e-3, judged 1e-2;
///     /// the time in which a beam tips over
///     tip: f64::NAN, "s", "nothing" => 0.0, within 0.0, if length < 0.0;
/// }?;
/// assert_eq!(report.claims().len(), 2);
/// assert_eq!(report.claims()[0].slips.len(), 2);
/// assert_eq!(report.claims().iter().map(|c| c.judged_within).collect::<Vec<_>>(), [1e-3, 1e-2]);
/// # Ok::<(), kit::Error>(())
/// ```
///
/// A meaning that is put together at run time needs [`claim`](crate::claim).
///
/// # Errors
/// As [`Report::add`](crate::Report::add).
#[macro_export]
macro_rules! claims {
    ($report:expr,
     $( $(#[doc = $meaning:literal])+
        $key:ident : $value:expr, $unit:literal, $oracle:expr => $gives:expr, within $bound:expr
        $(, judged $relative:expr)?
        $(, if $holds:expr)?
        $(, in $group:literal $(: $( $wrong:expr => $hint:literal ),+ )? )? ; )+) => { {
        let mut claims = Vec::new();
        $( $( if $holds )? {
            claims.push(
                $crate::claim(stringify!($key), concat!($($meaning),+).trim(), $value, $unit)
                    .within($bound)
                    .against($oracle, $gives)
                    $( .judged_within($relative) )?
                    $( .answer($group) $( $( .slip($wrong, $hint) )+ )? )?,
            );
        } )+
        $report.add(claims)
    } };
}

/// Refuses what a page cannot take, by numbers that are computed from its parameters: what each
/// is, its value, the interval that is allowed, and why it ends there. The first that is outside
/// counts. Evaluates to a `Result`.
///
/// ```
/// use kit::interval::{above, from_to};
/// let said = |length: f64, hole: f64| kit::allowed! {
///     "length - hole, what is left,": length - hole, above(0.0), "nothing moves inside the hole";
///     "hole/length": hole / length, from_to(0.01, 1.0), "the turns are too many";
/// }.map_err(|error| error.to_string());
/// assert_eq!(said(1.0, 0.5), Ok(()));
/// assert_eq!(said(1.0, 0.001).unwrap_err(),
///     "hole/length = 0.001 is not allowed: it must be from 0.01 to 1 (the turns are too many)");
/// ```
///
/// # Errors
/// As [`Interval::check`](crate::interval::Interval::check).
#[macro_export]
macro_rules! allowed {
    ($( $name:literal : $value:expr, $allowed:expr, $because:literal; )+) => {
        (|| -> $crate::Result<()> {
            $( $allowed.because($because).check($name, $value)?; )+
            Ok(())
        })()
    };
}

/// Adds limits to a report: why it must come out as a doc comment, then the limit, what the
/// result gives there, what it must give, and within which bound. Evaluates to a `Result`.
///
/// ```
/// use kit::Report;
/// fn period(angle: f64) -> f64 { 6.283_185 * (1.0 + angle * angle / 16.0) }
/// let mut report = Report::new("A pendulum", "a weight on a string")?;
/// kit::limits! { report,
///     /// the sine of a small angle is the angle
///     "small angles: omega tau": period(1e-4) => core::f64::consts::TAU, within 1e-6;
///     /// what is small enters as its square
///     "small angles: slope": (period(1e-4) - period(0.0)) / 1e-4 => 0.0, within 1e-4;
/// }?;
/// // A limit that is missed is refused.
/// assert!(kit::limits! { report,
///     /// the sine of a small angle is the angle
///     "small angles: omega tau": period(1.0) => core::f64::consts::TAU, within 1e-6;
/// }.is_err());
/// # Ok::<(), kit::Error>(())
/// ```
///
/// A name or a reason that is put together at run time needs [`limit`](crate::limit).
///
/// # Errors
/// As [`Report::add`](crate::Report::add).
#[macro_export]
macro_rules! limits {
    ($report:expr,
     $( $(#[doc = $because:literal])+ $limit:literal : $gives:expr => $must_give:expr, within $bound:expr; )+) => {
        $report.add(vec![ $(
            $crate::limit($limit, $must_give, $gives)
                .within($bound)
                .because(concat!($($because),+).trim()),
        )+ ])
    };
}

/// Adds lines to the card of effects: the effect, the dimensionless number that measures it,
/// as a formula and its value, the error of leaving it out, and of what it is an error. After
/// that may stand what a simulation measures of that error, `measured`, what it costs,
/// `at_cost` in words or `at_work`, and that the scene has it `included`: the verbs of
/// [`EffectLine`](crate::EffectLine). Before all lines may stand the accuracy `asked`
/// ([`Report::ask`](crate::Report::ask)): an effect is in at it if twice its error is
/// larger. Evaluates to a `Result`.
///
/// ```
/// use kit::Report;
/// let mut report = Report::new("A pendulum", "a weight on a string")?;
/// let (drag, angle) = (1e-3, 0.1_f64);
/// kit::effect_card! { report, asked 1e-4;
///     "air": "rho C S l/M" = drag, costs 4.0 / 3.0 * drag * angle, "of the swing",
///         measured 1.4e-4;
///     "size of the swing": "theta^2" = angle * angle, costs 0.0, "of the period", included;
/// }?;
/// let text = report.text()?;
/// assert!(text.contains("here      at 1e-4") && text.contains("left out  in"), "{text}");
/// // A small effect whose prediction a simulation does not bear out is refused.
/// assert!(kit::effect_card! { report,
///     "air": "rho C S l/M" = drag, costs 1e-3, "of the swing", measured 4e-4;
/// }.is_err());
/// # Ok::<(), kit::Error>(())
/// ```
///
/// # Errors
/// [`Error::NotFinite`](rotation_dynamics::Error::NotFinite) for a NaN or an infinity,
/// [`Error::Contradicted`](crate::Error::Contradicted) for a small effect whose prediction is
/// off by more than a factor 2.
#[macro_export]
macro_rules! effect_card {
    ($report:expr, asked $asked:expr; $($lines:tt)+) => {
        $report.ask($asked).and_then(|()| $crate::effect_card! { $report, $($lines)+ })
    };
    ($report:expr,
     $( $effect:literal : $number:literal = $value:expr, costs $error:expr, $of:literal $(, $verb:ident $($what:expr)? )*; )+) => {
        $report.add(vec![ $(
            $crate::effect($effect).number($number, $value).costs($error, $of)
                $( .$verb( $($what)? ) )*,
        )+ ])
    };
}

/// Writes the function `figures` of a page, given its parameters; each figure is an entry: what is to be seen as a
/// doc comment, then the name and the [`Drawing`](crate::draw::Drawing). Where what is
/// to be seen holds a number, it follows the name in brackets. What several figures need, such
/// as a solved motion, is computed once, beside the parameters.
///
/// ```
/// use rotation_dynamics::math::sin;
/// use kit::draw::{Curve, Ink, Panel, Side, Sketch};
/// use kit::times;
/// struct Parameters { swing: f64 }
///
/// kit::figures! { p: &Parameters, angle = |t: f64| p.swing * sin(t);
///     /// A weight hangs from a ceiling on a string of length l.
///     setup: Sketch::within((-1.0, 1.0), (-1.2, 0.2))
///         .wall((0.5, 0.0), (-0.5, 0.0))
///         .string((0.0, 0.0), (0.0, -0.9), "$l$", Side::Left)
///         .weight((0.0, -0.9), 0.08, "$M$");
///
///     swing(format!("The angle against time, a wave of the height {} rad.", p.swing)):
///         Panel::over_axes("$t$ / s", r"$\theta$ / rad")
///             .curve(Curve::of(times(0.0, 9.0, 90), angle, Ink::Body));
/// }
/// let [setup, swing] = &figures(&Parameters { swing: 0.5 })?[..] else { unreachable!() };
/// assert_eq!(setup.alt, "A weight hangs from a ceiling on a string of length l.");
/// assert!(swing.name == "swing" && swing.alt.ends_with("height 0.5 rad."));
/// # Ok::<(), kit::Error>(())
/// ```
///
/// # Errors
/// The function returns those of the drawings.
#[macro_export]
macro_rules! figures {
    ($p:tt : $parameters:ty $(, $shared:tt = $of:expr)*;
     $( $(#[doc = $alt:literal])* $name:ident $( ($told:expr) )? : $drawing:expr ; )+) => {
        /// All figures of the page.
        pub fn figures($p: $parameters) -> $crate::Result<Vec<$crate::Figure>> {
            $( let $shared = $of; )*
            Ok(vec![ $( {
                let alt: String = [ $( String::from($alt), )* $( String::from($told) )? ].concat();
                $crate::draw::Drawing::drawn($drawing, stringify!($name), alt.trim())?
            }, )+ ])
        }
    };
}
