//! The renderer: mdBook's HTML, our marks filled, fonts and sources beside it, all of
//! it checked before the old book is replaced.

use crate::build::bar;
use crate::check;
use crate::colour;
use crate::exercises;
use crate::figure;
use crate::fonts;
use crate::frame;
use crate::live::Modules;
use crate::maths;
use crate::measured;
use crate::pages;
use crate::place::{self, Place};
use crate::project::Project;
use crate::source;
use crate::splice::{self, Splice};
use crate::table;
use crate::text::{escape, tag_html};
use crate::times;
use crate::warnings;
use kit::draw::css_variables;
use mdbook_html::HtmlHandlebars;
use mdbook_renderer::errors::{Error, Result};
use mdbook_renderer::{RenderContext, Renderer};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// Our renderer, under the name that `book.toml` gives it.
pub struct Pages;

/// The name in `book.toml`.
pub const NAME: &str = "pages";

/// What belongs at a mark; `number` counts the figures of the page.
///
/// # Errors
/// Whatever is missing by now.
pub fn html_of(project: &Project, splice: &Splice, number: &mut usize) -> Result<String, String> {
    match splice {
        Splice::Inline { tex } => {
            let pieces = maths::pieces(tex);
            // The empty group keeps the space behind the relation.
            let piece = |n: usize| match n + 1 < pieces.len() {
                true => format!("{}{{}}", pieces[n]),
                false => pieces[n].to_owned(),
            };
            let set = |n: usize| maths::mathml(&piece(n), false).map_err(|e| e.reason);
            let set: Result<Vec<String>, String> = (0..pieces.len()).map(set).collect();
            Ok(match pieces.len() {
                1 => set?.concat(),
                _ => format!("<span class=\"pieces\">{}</span>", set?.join("<wbr>")),
            })
        }
        Splice::Display { tex, tag, id, boxed } => {
            let parts: Result<String, String> = maths::parts(tex)
                .iter()
                .map(|part| maths::mathml(part, true).map_err(|e| e.reason))
                .collect();
            let mathml = parts?;
            let class = if *boxed { "formula boxed" } else { "formula" };
            let identifier = id.as_ref().map(|id| format!(" id=\"{}\"", escape(id)));
            let tag = match (tag, id) {
                (None, _) => String::new(),
                (Some(tag), None) => format!("<span class=\"tag\">{}</span>", tag_html(tag)),
                (Some(tag), Some(id)) => {
                    format!("<a class=\"tag\" href=\"#{}\">{}</a>", escape(id), tag_html(tag))
                }
            };
            Ok(format!(
                "<span class=\"equation\"{}><span class=\"{class}\">{mathml}</span>{tag}</span>",
                identifier.unwrap_or_default()
            ))
        }
        Splice::Proof { kind, id, html, proof } => {
            let label = match kind.as_str() {
                "tick" => " aria-label=\"checked by a test\"",
                _ => "",
            };
            // Links say whose proof they are, so that the source can link back.
            let proof = proof.replace("<a href=", &format!("<a data-from=\"{id}-at\" href="));
            Ok(format!(
                "<button type=\"button\" class=\"{kind}\" id=\"{id}-at\" popovertarget=\"{id}\"{label}>\
                 {html}</button><span class=\"proof\" id=\"{id}\" popover>{proof}</span>"
            ))
        }
        Splice::Figure { stem, name } => {
            *number += 1;
            figure::inline(&project.figure(stem, name)?, &format!("f{number}-"))
        }
        // Moves in a page only.
        Splice::Player { .. } | Splice::Recording { .. } => Ok(String::new()),
        Splice::Table { stem, section } => {
            let table = project.table(stem, section)?;
            match section == times::SECTION {
                true => Ok(times::of(project, stem, &table)?.html(project, stem)),
                false => Ok(table::section(&table)),
            }
        }
        Splice::Measured { record, table } => measured::html(project, record, table),
        Splice::Check { stem } => check::html(project, stem),
        Splice::Exercises { group } => exercises::html(project, group),
    }
}

impl Renderer for Pages {
    fn name(&self) -> &str {
        NAME
    }

    fn render(&self, ctx: &RenderContext) -> Result<()> {
        crate::preprocess::same_protocol(&ctx.version)?;
        let root = ctx.root.canonicalize()?;
        let root = root.parent().ok_or(Error::msg("the book has no parent"))?;
        let project = Project::new(root);
        let destination = &ctx.destination;
        may_be_replaced(destination)?;

        // The old book stays until the new one is whole.
        let mut fresh = destination.clone().into_os_string();
        fresh.push(".new");
        let fresh = PathBuf::from(fresh);
        let mut ctx = ctx.clone();
        ctx.destination.clone_from(&fresh);
        let mut html: serde_json::Value = ctx
            .config
            .get("output.pages.html")?
            .ok_or(Error::msg("book.toml has no table [output.pages.html]"))?;
        // `mdbook serve` gives its endpoint for reloading here.
        let reload: Option<String> = ctx.config.get("output.html.live-reload-endpoint")?;
        if let (Some(reload), Some(table)) = (reload, html.as_object_mut()) {
            table.insert("live-reload-endpoint".into(), reload.into());
        }
        ctx.config.set("output.html", html)?;

        let done = build(&project, &ctx).and_then(|()| replace(&fresh, destination));
        let cleared = match fresh.exists() {
            true => fs::remove_dir_all(&fresh).map_err(Error::from),
            false => Ok(()),
        };
        done.and(cleared)
    }
}

fn build(project: &Project, ctx: &RenderContext) -> Result<()> {
    let fresh = &ctx.destination;
    let bar = bar("writing", ctx.book.chapters().count());
    bar.tick();
    HtmlHandlebars::new().render(ctx)?;
    warnings::none()?;
    for path in files(fresh)? {
        let name = address(fresh, &path);
        if frame::COLOURING.iter().any(|begin| name.starts_with(begin)) {
            fs::remove_file(path)?;
        } else if name.starts_with("toc") {
            let [theirs, ours] = frame::FOLD;
            fs::write(&path, fs::read_to_string(&path)?.replace(theirs, ours))?;
        }
    }

    let mut written = BTreeMap::new();
    let fonts = first_fonts(fresh)?;
    let modules = Modules::of(project).map_err(Error::msg)?;
    let places = place::places(&ctx.book);
    let paths = files(fresh)?;
    bar.set_length(paths.len() as u64);
    for path in paths {
        bar.inc(1);
        if path.extension().is_some_and(|e| e == "html") {
            let address = address(fresh, &path);
            let html = fs::read_to_string(&path)?;
            let place = places.get(&address).cloned().unwrap_or_default();
            let html = finish(project, modules.as_ref(), &html, &address, &place, &fonts)
                .map_err(|e| Error::msg(format!("{address}: {e}")))?;
            fs::write(&path, &html)?;
            written.insert(address, html);
        }
    }
    bar.finish_and_clear();
    for (address, html) in source::pages(project, &written).map_err(Error::msg)? {
        let path = fresh.join(&address);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent)?;
        }
        fs::write(&path, &html)?;
        written.insert(address, html);
    }
    for (address, bytes) in
        modules.map_or(Ok(Vec::new()), |m| m.files(project)).map_err(Error::msg)?
    {
        let path = fresh.join(&address);
        fs::create_dir_all(path.parent().unwrap_or(fresh))?;
        fs::write(&path, bytes)?;
    }
    let all: Vec<String> = files(fresh)?.iter().map(|p| address(fresh, p)).collect();
    let source = |address: &str| {
        let file = format!("book/src/{}.md", address.strip_suffix(".html")?);
        project.read(&file).ok().map(|text| (file, text))
    };
    pages::check(&written, &all, source).map_err(Error::new)
}

/// The addresses of the fonts to be loaded first: mdBook puts a hash behind their names.
fn first_fonts(fresh: &Path) -> Result<Vec<String>> {
    let all: Vec<String> = files(fresh)?.iter().map(|p| address(fresh, p)).collect();
    let font = |name: &&str| {
        all.iter().find(|file| {
            let hash = file.strip_prefix(&format!("fonts/{name}-"));
            let hash = hash.and_then(|rest| rest.strip_suffix(".woff2"));
            hash.is_some_and(|hash| !hash.contains('-') && hash.len() == 8)
        })
    };
    Ok(fonts::FIRST.iter().filter_map(font).cloned().collect())
}

/// The text keeps its place but is not shown before its letters are there, so that nothing moves
/// when they come; it waits for them no longer than a second.
const SETTING: &str = "<style>.setting :is(main,#mdbook-sidebar){visibility:hidden}</style><script>(root=>{\
    const show=()=>root.classList.remove('setting');root.classList.add('setting');setTimeout(show,1000);\
    addEventListener('DOMContentLoaded',()=>document.fonts.ready.then(show))})(document.documentElement)</script>";

/// A page with its marks filled and the theme's colours in place.
fn finish(
    project: &Project,
    modules: Option<&Modules>,
    html: &str,
    address: &str,
    place: &Place,
    fonts: &[String],
) -> Result<String, String> {
    let mut number = 0;
    // Everything on one page is for paper.
    let modules = modules.filter(|_| address != "print.html");
    let html = modules.map_or(html.to_owned(), |modules| modules.runs(html));
    let html = colour::listings(&frame::page(&html, address, place)?);
    let html = splice::fill(&html, |splice| {
        let plain = html_of(project, splice, &mut number)?;
        Ok(match (modules, splice) {
            (Some(modules), Splice::Player { stem }) => {
                modules.player(stem, &format!("p{number}-"))
            }
            (Some(modules), Splice::Recording { stem, flags }) => {
                modules.recording(stem, flags, &format!("r{number}-"))
            }
            (Some(modules), Splice::Table { stem, section }) if section == times::SECTION => {
                plain + &modules.bench(stem, &project.table(stem, section)?)
            }
            _ => plain,
        })
    })?;
    let live = modules.and_then(|modules| modules.head(&html)).unwrap_or_default();
    let up = "../".repeat(address.matches('/').count());
    let preload: String = fonts
        .iter()
        .map(|font| {
            format!(
                "<link rel=\"preload\" as=\"font\" type=\"font/woff2\" crossorigin href=\"{up}{font}\">"
            )
        })
        .collect();
    let colours = format!(
        "{preload}{SETTING}{live}<style>:root{{{light}}}.coal{{{dark}}}@media print{{:root,.coal{{{light}}}}}</style></head>",
        light = css_variables(false).replace('\n', ""),
        dark = css_variables(true).replace('\n', ""),
    );
    Ok(html.replacen("</head>", &colours, 1))
}

/// The files at or below `directory`, sorted.
fn files(directory: &Path) -> Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(directory)? {
        let path = entry?.path();
        if path.is_dir() {
            found.append(&mut files(&path)?);
        } else {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

fn address(root: &Path, path: &Path) -> String {
    let relative = path.strip_prefix(root).unwrap_or(path);
    relative.to_string_lossy().replace('\\', "/")
}

/// Refuses a directory that holds something other than a book.
fn may_be_replaced(directory: &Path) -> Result<()> {
    let empty = match fs::read_dir(directory) {
        Ok(mut entries) => entries.next().is_none(),
        Err(_) => !directory.exists(),
    };
    if empty || directory.join(".nojekyll").is_file() {
        return Ok(());
    }
    Err(Error::msg(format!(
        "{} holds files that are not a book; give an empty or a new directory",
        directory.display()
    )))
}

/// Makes `old` equal to `new`, touching only what differs.
fn replace(new: &Path, old: &Path) -> Result<()> {
    fs::create_dir_all(old)?;
    let wanted = files(new)?;
    for path in &wanted {
        let target = old.join(path.strip_prefix(new)?);
        let bytes = fs::read(path)?;
        if fs::read(&target).is_ok_and(|there| there == bytes) {
            continue;
        }
        if let Some(parent) = target.parent() {
            fs::create_dir_all(parent)?;
        }
        fs::write(&target, bytes)?;
    }
    for path in files(old)? {
        if !new.join(path.strip_prefix(old)?).exists() {
            fs::remove_file(path)?;
        }
    }
    Ok(())
}
