//! What a sound page becomes.

use super::{Labels, Sample, Target};

#[test]
fn what_is_sound_is_expanded_without_a_word() {
    let sample = Sample::new("sound");
    let period = "«num proof-a-b-1 2.0064 <b>2.0064\u{202f}s</b><br>error below \
                  5\u{202f}\u{d7}\u{202f}10<sup>\u{2212}5</sup><br>checked against: closed form»";
    let tick = "«tick proof-a-b-1 checked by <a href=\"source/tests/t.rs.html#L2\">it swings</a>\
                <br>in tests/t.rs»";
    let cases: [(&str, &str); 49] = [
        // Prose is copied, and so is what only looks like a directive or a formula.
        ("a **b** č { } \\ 15.5\n\nc\n", "a **b** č { } \\ 15.5\n\nc\n"),
        ("<!-- $ {{ 3.1416 -->x", "<!-- $ {{ 3.1416 -->x"),
        ("x <!-- $ {{ 3.1416", "x <!-- $ {{ 3.1416"),
        // Code: the numbers alone are replaced.
        ("`$x$ {{num s:period}} {{x}}`", "`$x$ 2.0064 {{x}}`"),
        ("`{{param s:length m}} {{num s:turns}}`", "`1.5 m 3`"),
        ("``a ` {{num s:turns}} ``` b`` $x$", "``a ` 3 ``` b`` «x»"),
        ("` $x$", "` «x»"),
        ("`` $x$ `", "`` «x» `"),
        ("`{{num s:turns`", "`{{num s:turns`"),
        ("```\n$x$ {{num s:turns}} 3.1416\n```\n$x$", "```\n$x$ 3 3.1416\n```\n«x»"),
        ("~~~\n$x$\n```\n~~~ \n$x$", "~~~\n$x$\n```\n~~~ \n«x»"),
        ("````\n```\n$x$\n`````\n$x$", "````\n```\n$x$\n`````\n«x»"),
        ("> ```\n> $x$\n> ```\n> $x$", "> ```\n> $x$\n> ```\n> «x»"),
        ("  ```\n  $x$\n  ```\n  $x$", "  ```\n  $x$\n  ```\n  «x»"),
        ("```\n$x$ never closed", "```\n$x$ never closed"),
        ("```\n```a\n$x$\n```\n$x$", "```\n```a\n$x$\n```\n«x»"),
        ("a ```$x$``` b", "a ```$x$``` b"),
        ("~~ $x$", "~~ «x»"),
        // Formulas in a line, with what must not be parted from them.
        ("a $x$ b", "a «x» b"),
        ("č $x$, b", "č <span class=\"glued\">«x»,</span> b"),
        ("(($x$)).", "<span class=\"glued\">((«x»)).</span>"),
        ("[$x$](c)", "[«x»](c)"),
        ("a ($x$ b)", "a <span class=\"glued\">(«x»</span> b)"),
        ("\u{201c}$x$\u{201d}", "<span class=\"glued\">\u{201c}«x»</span>\u{201d}"),
        ("$a\n+ b$ c", "«a\n+ b» c"),
        ("$x_{{a}}$", "«x_{{a}}»"),
        ("$x = {{num s:turns}}$", "«x = {3}»"),
        ("$T = {{num s:period s}} + {{given 3.1416}}$", "«T = {2.0064}\\,\\mathrm{s} + {3.1416}»"),
        ("$l = {{param s:length}}$", "«l = {1.5}»"),
        // Formulas of their own.
        ("$$x$$ y", "«x|None|None|false» y"),
        ("$$\nx \\tag{1.2345} \\label{eq:a b}\n$$", "«x|Some(\"1.2345\")|Some(\"eq-a-b\")|false»"),
        ("$$\\boxed{x}$$", "«x|None|None|true»"),
        ("> $$\n> x + \n> y\n> $$", "> «x + \n y|None|None|false»"),
        // References.
        ("\\eqref{eq:here}", "<a class=\"eqref\" href=\"#eq-here\">1.1 (2)</a>"),
        ("\\eqref{eq:there}.", "<a class=\"eqref\" href=\"c.html#eq-there\">1.1 (2)</a>."),
        // Directives in a line.
        ("{{num s:period}}", period),
        ("a {{given 9.8066}} b", "a 9.8066 b"),
        (
            "a {{num s:period@2 s}}, b",
            "a <span class=\"glued\">«num proof-a-b-1 2.0\u{202f}s <b>2.0064\u{202f}s</b><br>error below 5\u{202f}\u{d7}\u{202f}10<sup>\u{2212}5</sup><br>checked against: closed form»,</span> b",
        ),
        ("{{num s:turns}}", "«num proof-a-b-1 3 <b>3</b><br>checked against: counting»"),
        ("{{param s:length m}}", "1.5\u{202f}m"),
        ("{{param s:length unit}}", "1.5\u{202f}m"),
        ("{{test t::it_swings}}", tick),
        ("{{given 2}} {{given 3}}", "2 3"),
        // Directives of a line.
        ("{{table s:limits}}", "<div class=\"box\">«table s:limits»</div>\n\n"),
        ("> {{table s:limits}}", "> <div class=\"box\">«table s:limits»</div>\n\n"),
        (
            "{{listing s:physics}}\nx",
            "<div class=\"code\"><div class=\"listing\"><a href=\"source/examples/s.rs.html#L3\">examples/s.rs</a></div>\n\n```rust,noplayground\nlet g = 9.8;\n```\n\n</div>\n\n\nx",
        ),
        (
            "{{figure s:swing}}\n\n**It** $x$.\nMore.\n\nEnd",
            "<figure id=\"fig-swing\">\n<div class=\"panels\"><div class=\"panel\" data-figure=\"s:swing\">«s:swing»</div></div>\n<figcaption>\n\n<span class=\"number\">Figure 1.</span> **It** <span class=\"glued\">«x».</span>\nMore.\n\n</figcaption>\n</figure>\n\n\n\nEnd",
        ),
        (
            "{{stills s}}\n\n**Two.**",
            "<figure id=\"fig-frames\" data-frame=\"s\">\n<div class=\"panels stills\"><div class=\"panel\" data-figure=\"s:frame_1\">«s:frame_1»</div><div class=\"panel\" data-figure=\"s:frame_2\">«s:frame_2»</div></div>«player s»\n<figcaption>\n\n<span class=\"number\">Figure 1.</span> **Two.**\n\n</figcaption>\n</figure>\n\n",
        ),
        (
            "{{output s:limits}}",
            "```console\n$ cargo run --example s\nlimits\nlimit        must give  gives   within  because\ntheta0 -> 0  2.0061     2.0061  1e-4    small swings take the same time\n```\n\n",
        ),
    ];
    for (source, want) in cases {
        let page = sample.page(source);
        assert_eq!(page.html, want, "{source}");
        assert_eq!(page.problems, [""; 0], "{source}");
    }
}

#[test]
fn a_page_says_what_it_uses() {
    let sample = Sample::new("uses");
    let page = sample.page(
        "{{num s:period}} {{test t::it_swings}}\n\n{{listing s:physics}}\n\n\
         {{figure s:swing}}\n\n**A.**\n\n{{figure s:swing}}\n\n**B.**\n\n\
         $$x \\tag{1.1 (1)} \\label{eq:x}$$\n\n{{check s}}\n",
    );
    assert_eq!(page.problems, [""; 0]);
    assert_eq!(page.stems, ["s"; 5]);
    assert_eq!(page.sources, ["tests/t.rs", "examples/s.rs"]);
    let target =
        Target { page: "a/b.html".into(), tag: "1.1 (1)".into(), place: ("a/b.md".into(), 17) };
    assert_eq!(page.found, Labels::from([("eq:x".to_owned(), target)]));
    for text in
        ["proof-a-b-1 ", "proof-a-b-2 ", "Figure 1.</span> **A.**", "Figure 2.</span> **B.**"]
    {
        assert_eq!(page.html.matches(text).count(), 1, "{text}: {}", page.html);
    }
    // What is searched for: the number, the formula as it is spoken, the words of a figure.
    for text in ["2&#46;0064</span>", "\">x</span>", "\">It swings</span>"] {
        assert!(page.raw.contains(text), "{text}: {}", page.raw);
    }
    // A tick has no text.
    let tick = sample.page("{{test t::it_swings}}").raw;
    assert!(tick.ends_with("\"></span>"), "{tick}");
    // A strip has a column for its times, other tables stay as they are.
    for (section, column, other) in
        [("accuracy", "time", "relative"), ("limits", "because", "time\n")]
    {
        let raw = sample.page(&format!("{{{{table s:{section}}}}}")).raw;
        assert!(raw.contains(column) && !raw.contains(other), "{raw}");
    }
}
