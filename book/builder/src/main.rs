//! `cargo book`: builds the book, a directory of pages that open as files.
//!
//! ```text
//! pages ── expand (directives, formulas) ── mdBook ── marks filled ── checked ── book
//! ```
//! The same two steps are commands for the stock `mdbook` (`preprocess` and `render`
//! in `book.toml`). Nothing here knows physics.

mod build;
mod check;
mod colour;
mod contents;
mod coverage;
mod directive;
mod edition;
mod exercises;
mod expand;
mod frame;
mod lint;
mod live;
mod measured;
mod modules;
mod pages;
mod paper;
mod place;
mod preprocess;
mod problem;
mod project;
mod race;
mod recording;
mod render;
mod source;
mod splice;
mod spoken;
mod table;
mod times;
mod warnings;

use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use mdbook_preprocessor::Preprocessor;
use mdbook_renderer::{RenderContext, Renderer};
use project::Project;
use std::error::Error;
use std::io;
use std::path::PathBuf;
use std::process::ExitCode;
use typeset::{figure, fonts, maths, mend, notation, text, token};

fn command() -> Command {
    let supports = Command::new("supports")
        .about("Whether a renderer is supported (for mdbook)")
        .arg(Arg::new("renderer").required(true));
    Command::new("cargo book")
        .about("Builds the book")
        .arg(
            Arg::new("open")
                .long("open")
                .action(ArgAction::SetTrue)
                .help("Open the book in the browser"),
        )
        .arg(
            Arg::new("out")
                .long("out")
                .value_name("DIR")
                .value_parser(value_parser!(PathBuf))
                .help("Build into this directory instead of book/book"),
        )
        .arg(
            Arg::new("pdf")
                .long("pdf")
                .value_name("FILE")
                .value_parser(value_parser!(PathBuf))
                .help("Print the book to this file as well, through Chromium"),
        )
        .arg(
            Arg::new("root")
                .long("root")
                .value_name("DIR")
                .value_parser(value_parser!(PathBuf))
                .hide(true)
                .help("The project's directory"),
        )
        .subcommand(
            Command::new("preprocess")
                .about("Expand the pages (called by mdbook)")
                .subcommand(supports),
        )
        .subcommand(Command::new("render").about("Write the pages (called by mdbook)"))
}

fn run(matches: &ArgMatches) -> Result<(), Box<dyn Error>> {
    warnings::listen();
    match matches.subcommand() {
        Some(("preprocess", sub)) => {
            if let Some(asked) = sub.subcommand_matches("supports") {
                let renderer = asked.get_one::<String>("renderer");
                let supported = renderer.map(|name| preprocess::Directives.supports_renderer(name));
                return match supported {
                    Some(Ok(true)) => Ok(()),
                    _ => Err("only the renderers 'pages' and 'html' are supported".into()),
                };
            }
            let (ctx, book) = mdbook_preprocessor::parse_input(io::stdin())?;
            let book = preprocess::Directives.run(&ctx, book)?;
            Ok(serde_json::to_writer(io::stdout(), &book)?)
        }
        Some(("render", _)) => {
            let ctx = RenderContext::from_json(io::stdin())?;
            Ok(render::Pages.render(&ctx)?)
        }
        _ => {
            let here = std::env::current_dir()?;
            let project = match matches.get_one::<PathBuf>("root") {
                Some(root) => Project::new(root),
                None => {
                    let project = Project::above(&here)
                        .ok_or("there is no book/book.toml here or in any directory above")?;
                    modules::renew(&project);
                    project
                }
            };
            let out = match matches.get_one::<PathBuf>("out") {
                Some(out) => here.join(out),
                None => project.path("book/book"),
            };
            let pdf = matches.get_one::<PathBuf>("pdf").map(|pdf| here.join(pdf));
            let printer = pdf.as_deref().map(paper::printer).transpose()?;
            build::once(&project, &out)?;
            if let (Some(printer), Some(pdf)) = (printer, pdf) {
                paper::print(&printer, &project, &out, &pdf)?;
            }
            if matches.get_flag("open") {
                open::that_detached(out.join("index.html"))?;
            }
            Ok(())
        }
    }
}

fn main() -> ExitCode {
    let matches = command().get_matches();
    match run(&matches) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{}", build::message(error.as_ref()));
            ExitCode::FAILURE
        }
    }
}
