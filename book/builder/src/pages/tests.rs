//! The lint of finished pages: what is sound passes, and each damage is found at its line.

use super::*;

fn checked(html: &str) -> Result<(), String> {
    let pages = BTreeMap::from([("a/b.html".to_owned(), html.to_owned())]);
    let all = ["a/b.html".to_owned(), "c.css".to_owned()];
    check(&pages, &all, |_| None).map_err(|e| e.to_string())
}

#[test]
fn a_sound_page_passes_and_each_damage_is_found() {
    let sound = "<!DOCTYPE html>\n<link href=\"../c.css\"><h1 id=\"x\">T</h1>\n\
        <a href=\"#x\">x</a><a href='b.html#x'>y</a><code>$ {{</code>\
        <svg role=\"img\" aria-label=\"A line that falls\"></svg>\
        <script>if (a<b) { \"{{\" }</script>";
    assert_eq!(checked(sound), Ok(()));
    let damages = [
        ("<h1", "<p>$x$</p><h1", "2: '$' is left over"),
        ("<h1", "<p>{{num a:b}}</p><h1", "2: '{{' is left over"),
        ("#x", "#y", "3: the link #y leads to no place in a/b.html"),
        ("b.html", "c.html", "3: the link c.html#x leads nowhere"),
        ("A line that falls", "", "3: a figure without alternative text"),
        ("../c", "https://cdn.example/c", "2: https://cdn.example/c.css loads from outside"),
        ("<a href='b", "<p id=\"x\"></p><a href='b", "3: the id 'x' stands twice"),
    ];
    for (from, to, message) in damages {
        let found = checked(&sound.replacen(from, to, 1)).err().unwrap_or_default();
        let expected = format!("a/b.html:{message}");
        assert!(found.starts_with(&expected), "{expected}: {found}");
    }
    // The line of the source, where it can be found.
    let pages = BTreeMap::from([("b.html".to_owned(), "<a href=\"no.html#x\">".to_owned())]);
    let source = |_: &str| Some(("b.md".into(), "T\n\n[a](no.md#x)".into()));
    let found = check(&pages, &["b.html".into()], source);
    let expected = "b.md:3: the link no.html#x leads nowhere";
    assert_eq!(found.map_err(|e| e.to_string()), Err(expected.into()));
}

/// Everything that may load or be linked, soundly, a line each.
const LOADS: [&str; 17] = [
    "<script src=\"../c.css\"></script>",
    "<img src='../c.css' alt=\"A line\">",
    "<iframe src=\"../c.css\"></iframe>",
    "<source src=\"../c.css\"/>",
    "<audio src=\"../c.css\"></audio>",
    "<video src=../c.css></video>",
    "<embed src = \"../c.css\">",
    "<object data=\"../c.css\"></object>",
    "<link rel=\"x\" href=\"../c.css\">",
    "<a name=\"n\" href=\"https://example.org/a\">x</a>",
    "<a href=\"mailto:a@b\">x</a><a href=\"data:x\">x</a><a href=\"http://b\">x</a>",
    "<a href=\"#n\">x</a><a href=\"./b.html#n\">x</a><a href=\"../a/b.html#p%20q\">x</a>",
    "<p id=\"p q\" title=\"a > {{ b\">x</p>",
    "<!-- {{ $ <p id=\"n\"> -->",
    "<pre>{{ $</pre><textarea>$</textarea><style>\n\"$\"</style>",
    "<p title='\"'>a</p><br/>b",
    "<svg role=\"presentation\"></svg><b id=\"k\"/><i>x</i>",
];

#[test]
fn what_loads_is_looked_at_wherever_it_stands() {
    let sound = LOADS.join("\n");
    assert_eq!(checked(&sound), Ok(()));
    let mut damaged = 0;
    let mut damage = |n: usize, from: &str, to: &str, message: &str| {
        let mut lines = LOADS.map(str::to_owned);
        assert!(lines[n].contains(from), "{from}");
        lines[n] = lines[n].replace(from, to);
        let found = checked(&lines.join("\n")).err().unwrap_or_default();
        // The style has two lines.
        let line = n + 1 + usize::from(n > 14);
        assert_eq!(found, format!("a/b.html:{line}: {message}"), "{to}");
        damaged += 1;
    };
    for (n, _) in LOADS.iter().enumerate().take(9) {
        let url = "//cdn.example/c.css";
        damage(
            n,
            "../c.css",
            url,
            &format!(
                "{url} loads from outside\nerror: a/b.html:{}: the link {url} leads nowhere",
                n + 1
            ),
        );
        damage(n, "../c.css", "https://x/c", "https://x/c loads from outside");
        damage(n, "../c.css", "../d.css", "the link ../d.css leads nowhere");
        damage(n, "../c.css", "../../c.css/..", "the link ../../c.css/.. leads nowhere");
    }
    let bare = "a picture without alternative text";
    damage(1, "\"A line\"", "\" \"", bare);
    damage(1, " alt=\"A line\"", "", bare);
    let nowhere = "the link #m leads to no place in a/b.html";
    damage(11, "\"#n\"", "\"#m\"", nowhere);
    damage(11, "p%20q", "q", "the link ../a/b.html#q leads to no place in a/b.html");
    damage(13, " -->", " --><b id=\"p q\">", "the id 'p q' stands twice in this page");
    damage(12, ">x<", ">}}<", "'}}' is left over: }}");
    damage(13, "-->", "-->$", "'$' is left over: $");
    damage(14, "</pre>", "</pre>\\tag", "'\\tag' is left over: \\tag");
    damage(15, ">a<", ">\\eqref<", "'\\eqref' is left over: \\eqrefb");
    damage(16, ">x<", ">\\label<", "'\\label' is left over: \\label");
    damage(16, "presentation", "img", "a figure without alternative text");
    assert_eq!(damaged, 47);
}

#[test]
fn the_page_of_errors_and_the_print_page_are_let_be() {
    let all = ["b.html".to_owned(), "404.html".into(), "print.html".into()];
    let damaged = "<p id=\"x\"></p><p id=\"x\"></p><a href=\"no.html\">x</a>";
    let run = |pages: &[(&str, &str)]| {
        let pages = pages.iter().map(|(address, html)| ((*address).to_owned(), (*html).to_owned()));
        check(&pages.collect(), &all, |_| None).map_err(|e| e.to_string())
    };
    let nowhere = "the link no.html leads nowhere";
    assert_eq!(run(&[("404.html", "<a href=\"no.html\">x</a>")]), Ok(()));
    // What the print page repeats is said once, where it stands.
    let twice = "b.html:1: the id 'x' stands twice in this page";
    assert_eq!(
        run(&[("b.html", damaged), ("print.html", damaged)]),
        Err(format!("{twice}\nerror: b.html:1: {nowhere}"))
    );
    assert_eq!(run(&[("print.html", damaged)]), Err(format!("print.html:1: {nowhere}")));
}
