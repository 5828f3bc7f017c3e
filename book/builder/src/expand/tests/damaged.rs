//! What is said of a damaged page, and what is left of it.

use super::Sample;

/// A page, what is left of it, and what is said of it, with the line.
type Case<'a> = (&'a str, &'a str, &'a [(usize, &'a str)]);

#[test]
fn damage_is_named_with_its_line() {
    let sample = Sample::new("damage");
    let typed = "3.1416 is typed, not computed: use {{num STEM:KEY}} for a result, \
                 {{given 3.1416}} for what is given";
    let in_formula = "3.1416 is typed in a formula, not computed: use {{num STEM:KEY}} for a \
                      result, {{given 3.1416}} for what is given";
    let caption = "a figure is followed by a paragraph, its caption";
    let bold = "a caption begins with what the figure shows, in bold: **…**";
    let known = "s claims no 'no'; its keys are: period, turns";
    let cases: [Case; 40] = [
        // A number that is typed, whatever stands before it.
        ("3.1416", "3.1416", &[(5, typed)]),
        ("a\n\n3.1416\n", "a\n\n3.1416\n", &[(7, typed)]),
        ("$a\n+ b$\n3.1416", "«a\n+ b»\n3.1416", &[(7, typed)]),
        ("$$\na\n$$\n3.1416", "«a|None|None|false»\n3.1416", &[(8, typed)]),
        ("```\na\n```\n3.1416", "```\na\n```\n3.1416", &[(8, typed)]),
        ("<!--\n--> 3.1416", "<!--\n--> 3.1416", &[(6, typed)]),
        ("`a\nb` 3.1416", "`a\nb` 3.1416", &[(6, typed)]),
        (
            "{{table s:limits}}\n3.1416",
            "<div class=\"box\">«table s:limits»</div>\n\n\n3.1416",
            &[(6, typed)],
        ),
        ("$x = 3.1416$", "«x = 3.1416»", &[(5, in_formula)]),
        ("\n$$\nx\n= 3.1416\n$$", "\n«x\n= 3.1416|None|None|false»", &[(8, in_formula)]),
        ("$x^{{3.1416}}$", "«x^{{3.1416}}»", &[(5, in_formula)]),
        (
            "$\\frac{dT}{4}$",
            "«\\frac{dT}{4}»",
            &[(5, "the d of a differential stands upright: \\mathrm{d}, not dT}{4}")],
        ),
        // Formulas.
        ("\na \\$ b", "\na  b", &[(6, "a dollar sign is a formula's; write the word")]),
        ("a\n$x", "a\nx", &[(6, "a formula that $ opens is not closed in its paragraph")]),
        (
            "$x\n\ny$ z",
            "x\n\ny z",
            &[
                (5, "a formula that $ opens is not closed in its paragraph"),
                (7, "a formula that $ opens is not closed in its paragraph"),
            ],
        ),
        ("a\n$$x\n{{", "a\n", &[(6, "$$ is not closed")]),
        ("$$a\n\nb$$ c", "«a\n\nb|None|None|false» c", &[(5, "a blank line inside $$…$$")]),
        (
            "$$x \\label{eq:a}$$",
            "«x|None|Some(\"eq-a\")|false»",
            &[(5, "\\label{eq:a} needs a \\tag{…}")],
        ),
        ("$$x \\tag{1} \\tag{2}$$ c", " c", &[(5, "\\tag stands twice in one formula")]),
        (
            "$$x \\tag{1} \\label{eq:a}$$\n$$y \\tag{2} \\label{eq:a}$$",
            "«x|Some(\"1\")|Some(\"eq-a\")|false»\n«y|Some(\"2\")|Some(\"eq-a\")|false»",
            &[(6, "the label 'eq:a' is taken at a/b.md:5")],
        ),
        ("$ $", "", &[(5, "TeX: the formula is empty Near: ")]),
        // References.
        (
            "a\n\\eqref{eq:no}",
            "a\n",
            &[(6, "no equation is labelled 'eq:no'; labelled are: eq:here, eq:there")],
        ),
        ("\\eqref{eq:here $x$", "\\eqref{eq:here «x»", &[(5, "\\eqref{ is not closed")]),
        // Directives in a line and in code.
        ("a {{num s:no}} b", "a  b", &[(5, known)]),
        ("{{num s:period m}}", "", &[(5, "the unit of s:period is s, not m")]),
        ("{{num s:turns s}}", "", &[(5, "s:turns has no unit")]),
        ("{{num s:period@6}}", "", &[(5, "s:period = 2.0064 cannot be rounded to 6 digits")]),
        ("a\n{{num s:turns c", "a\nnum s:turns c", &[(6, "{{ is not closed")]),
        ("a {{table s:limits}}", "a ", &[(5, "this directive must have its line for itself")]),
        ("```\n\n{{num s:no}}\n```", "```\n\n\n```", &[(7, known)]),
        ("`{{num s:no}}`\n", "``\n", &[(5, known)]),
        ("$x\n= {{num s:no}}$", "«x\n= »", &[(5, known)]),
        (
            "{{numb s:period}}\nx",
            "\nx",
            &[(
                5,
                "unknown directive {{numb s:period}}; there are num, param, given, figure, stills, listing, output, table, measured, check, recording, exercise, exercises, pages, test",
            )],
        ),
        // Directives of a line, and their captions.
        (
            "a\n\n{{table s:no}}\nx",
            "a\n\n\nx",
            &[(
                7,
                "the output of s has no section 'no'; it has: parameters, claims, limits, accuracy, checks",
            )],
        ),
        (
            "a\n\n{{table twice:limits}}\nx",
            "a\n\n\nx",
            &[(7, "'limits' is a section of the output of twice and the name of a table in it")],
        ),
        ("{{figure s:swing}}\n\n\nIt", "", &[(8, bold)]),
        ("{{figure s:swing}}\n\n# It", "", &[(7, caption)]),
        ("{{figure s:swing}}\n\n| a |", "", &[(7, caption)]),
        ("{{figure s:swing}}\n\n{{given 2}}", "", &[(7, caption)]),
        ("{{figure s:swing}}\n", "", &[(6, caption)]),
    ];
    for (source, want, problems) in cases {
        let page = sample.page(source);
        let problems: Vec<String> =
            problems.iter().map(|(line, message)| format!("a/b.md:{line}: {message}")).collect();
        assert_eq!(page.problems, problems, "{source}");
        // A figure with a bad caption is drawn all the same.
        if !want.is_empty() || !source.starts_with("{{") {
            assert_eq!(page.html, want, "{source}");
        }
    }
}

/// What TeX refuses is named with the line in the formula and what stands there.
#[test]
fn what_tex_refuses_is_found_in_its_line() {
    let sample = Sample::new("tex");
    for (source, place, near) in [
        ("a\n$\\nonsense x$", "a/b.md:6: TeX: ", "\\nonsense x"),
        ("$$\nx\n+ \\nonsense y$$", "a/b.md:7: TeX: ", "\\nonsense y"),
        (
            "$$\n\\nonsense abcdefghijklmnopqrstuvwxyz$$",
            "a/b.md:6: TeX: ",
            "\\nonsense abcdefghijklmn",
        ),
    ] {
        let page = sample.page(source);
        let [problem] = page.problems.as_slice() else {
            panic!("{source}: {:?}", page.problems);
        };
        assert!(problem.starts_with(place), "{problem}");
        assert!(problem.ends_with(&format!(" Near: {near}")), "{problem}");
        assert!(!page.html.contains("nonsense"), "{}", page.html);
    }
}
