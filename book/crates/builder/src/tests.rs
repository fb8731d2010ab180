//! What a chapter may hold, what its author is told, and what is done to a page.

use crate::chapter::expand_directives;
use crate::{Files, Page, Site, links, paper_page, pixel_panel, problem};
use course::workspace;

const RAY: &str = "../../../../steps/step01_rays/src/ray.rs";
const SKY: &str = "../../tests/snapshots/step01_rays.snap.png";

fn listing_markdown(target: &str) -> String {
    format!("# Title\n\n```rust\n{{{{#include {target}}}}}\n```\n")
}

#[track_caller]
fn expand_without_fault(markdown: &str) -> String {
    let (markdown, faults) = expand_directives(markdown, &workspace());
    assert_eq!(faults, []);
    markdown
}

/// Fails unless the only fault is on `line` and is told in these words.
#[track_caller]
fn assert_one_fault(markdown: &str, line: usize, words: &str) {
    let (_, faults) = expand_directives(markdown, &workspace());
    let [(found, what)] = &faults[..] else { panic!("not one fault: {faults:?}") };
    assert_eq!(*found, line, "{what}");
    assert!(what.contains(words), "{what:?} does not say {words:?}");
}

#[test]
fn a_listing_is_a_file_or_a_part_of_it() {
    let file = include_str!("../../../../steps/step01_rays/src/ray.rs").trim_end();
    let part = |part: &str| expand_without_fault(&listing_markdown(&format!("{RAY}:{part}")));
    let (before_impl, after_impl) = (part("..impl Ray"), part("impl Ray.."));
    let (begin, end) = file.split_once("\nimpl").expect("an impl");
    assert!(
        expand_without_fault(&listing_markdown(RAY)).contains(&format!("```rust\n{file}\n```"))
    );
    assert!(before_impl.contains(&format!("```rust\n{begin}\n```")), "{before_impl}");
    assert!(after_impl.contains(&format!("```rust\nimpl{end}\n```")), "{after_impl}");
    assert_one_fault(&listing_markdown("../../../../steps/nowhere.rs"), 3, "no file");
    assert_one_fault(&listing_markdown(&format!("{RAY}:3:5")), 3, "not 3:5");
    assert_one_fault(
        &listing_markdown(&format!("{RAY}:..pub type")),
        3,
        "begins with \"pub type\"",
    );
    assert_one_fault(&listing_markdown(&format!("{RAY}}}}}\nlet x = 1; {{{{")), 3, "nothing else");
    assert_one_fault("{{#include ../../Cargo.toml}}\n", 1, "stands alone");
}

#[test]
fn a_formula_is_read() {
    assert!(expand_without_fault("So $a_i^2 * b$.").contains("<msubsup>"));
    expand_without_fault("It costs 5\\$.\n");
    assert_one_fault("One.\n\nTwo $\\nosuchcommand{x}$.\n", 3, "does not parse");
    for dollar in ["It costs 5$ or so.\n", "<p>$x$</p>\n", "$$\\frac{1}{2\n"] {
        assert_one_fault(dollar, 1, "a $ that is no formula");
    }
}

#[test]
fn a_value_has_the_minus_of_its_place() {
    assert!(expand_without_fault("It is {{#value camera-v0-x}}.").contains("−0.5774"));
    assert!(expand_without_fault("It is `{{#value camera-v0-x}}`.").contains("-0.5774"));
    assert!(expand_without_fault("It is $t = {{#value camera-tan}}$.").contains("<mn>0&#46;5774"));
    assert_one_fault("It is {{#value nothing}} long.\n", 1, "no value nothing");
    assert_one_fault("It is $t = {{#value nothing}}$.\n", 1, "no value nothing");
    assert_one_fault("One {{#value camera-step\n", 1, "no }}");
}

#[test]
fn a_value_is_of_a_pixel_or_a_figure_or_a_function() {
    let pixel = expand_without_fault("{{#value step05_phong:470,120:bytes}}");
    assert!(pixel.contains("(228, 215, 255)"), "{pixel}");
    assert!(expand_without_fault("{{#value row:D}}").contains("0.1925"));
    assert!(expand_without_fault("{{#value half-angle 1}}").contains("60.0"));
    for name in [
        "step05_phong:470,360:bytes",
        "step05_phong:470:bytes",
        "step05_phong:nothing",
        "row:470,120:D",
        "half-angle",
        "half-angle 1 2",
        "camera-tan 1",
    ] {
        assert_one_fault(&format!("It is {{{{#value {name}}}}}.\n"), 1, "no value");
    }
}

#[test]
fn a_directive_has_its_place() {
    assert_one_fault("One.\n\n{{#figure nowhere}}\n", 3, "no figure nowhere");
    assert_one_fault("See {{#figure ray}} here.\n", 1, "stands alone");
    assert_one_fault("One\n{{#playground x.rs}}\n", 2, "none of the directives");
    assert_one_fault("{{#predict Why?}}\n\nSo.\n", 1, "no {{#end}}");
    assert_one_fault("So.\n\n{{#end}}\n", 3, "without a box");
    assert_one_fault("One.\n\n```console\n$ ls\n```\n", 3, "console,yours or");
}

#[test]
fn a_problem_has_an_answer_that_is_a_value() {
    let problem = "{{#problem 7 camera-tan}}\n\nHow *far*?\n\n\
                   {{#answer}}\n\n**{{#value camera-tan}}.** So.\n\n{{#end}}\n";
    let html = expand_without_fault(problem);
    let attributes = |answer: &str, tolerance: &str| {
        format!("id=\"problem-7\" data-answer=\"{answer}\" data-tolerance=\"{tolerance}\"")
    };
    assert!(html.contains(&attributes("0.5774", "0.01")), "{html}");
    let count = problem.replace("7 camera-tan", "7 mirror-depth 0.8");
    let count = expand_without_fault(&count);
    assert!(count.contains(&attributes("25", "0")), "{count}");
    assert!(html.trim_end().ends_with("</details>\n</section>"), "{html}");
    let without_answer = problem.replace("{{#answer}}\n\n", "");
    assert_one_fault(&without_answer, 7, "no {{#answer}}");
    let without_end = problem.replace("{{#end}}", "");
    assert_one_fault(&without_end, 1, "no {{#end}}");
    assert_one_fault(&problem.replace(" 7", ""), 1, "NUMBER VALUE");
    assert_one_fault(&problem.replace("7 camera", "7 lens"), 1, "no value");
    let (_, faults) = expand_directives(&without_end.repeat(2), &workspace());
    assert!(faults[1].1.contains("after the {{#end}}"), "{faults:?}");
}

#[test]
fn the_sheet_has_the_problems_of_all_chapters_and_then_their_answers() {
    let chapter = |number: u32| {
        format!(
            "# A title\n\n{{{{#problem {number} camera-tan}}}}\n\nQuestion {number}?\n\n\
             {{{{#answer}}}}\n\nWay {number}.\n\n{{{{#end}}}}\n\nText.\n"
        )
    };
    let chapters = [("One", &*chapter(1)), ("None", "# None\n"), ("Two", &chapter(2))];
    let sheet = expand_without_fault(&problem::sheet_markdown(chapters.into_iter()));
    let parts = [
        "## One",
        "Question 1?",
        "## Two",
        "Question 2?",
        "## Answers",
        "<details",
        "Way 1.",
        "Way 2.",
        "</details>",
    ];
    let positions = parts.map(|part| sheet.find(part));
    assert!(positions.iter().all(Option::is_some) && positions.is_sorted(), "{sheet}");
    assert!(!sheet.contains("Text.") && !sheet.contains("None"), "{sheet}");
}

#[test]
fn problems_are_short_and_numbered_as_they_are_read() {
    let files = Files::read(&workspace().join("book/src")).expect("chapters");
    let summary = files.text("SUMMARY.md").expect("a summary");
    let names = summary.split(['(', ')']).filter(|name| name.ends_with(".md"));
    let text: String = names.filter_map(|name| files.text(name)).collect();
    let problems: Vec<_> = text.split("\n{{#problem ").skip(1).collect();
    for (number, problem) in (1..).zip(&problems) {
        assert!(problem.starts_with(&format!("{number} ")), "{number}: {problem}");
        let words = problem.split("\n{{#answer}}").next().map(str::split_whitespace);
        assert!(words.is_some_and(|words| words.count() <= 80), "{problem}");
    }
    assert!(10 < problems.len());
}

#[test]
fn a_picture_has_words_and_may_answer() {
    assert_one_fault("One.\n\n![](generated/step01_rays.png)\n", 3, "no alt text");
    assert_one_fault("One.\n\n![What](generated/nowhere.png)\n", 3, "no picture");
    assert_one_fault(&format!("![A sky.]({SKY}) {{{{#live nothing}}}}\n"), 1, "nothing answers");
    let html =
        expand_without_fault(&format!("![A sky.]({SKY} \"[It](a.md)\") {{{{#live own_scene}}}}"));
    assert!(html.contains("alt=\"A sky.\"") && html.contains("data-live=\"own_scene\""));
}

#[test]
fn every_figure_and_every_value_is_used() {
    let files = Files::read(&workspace().join("book/src")).expect("chapters");
    let texts = files.texts_with_suffix(".md").map(|(_, text)| text);
    let chapters: String = texts.chain([pixel_panel::TEXT]).collect();
    let figures = figures::LIVE
        .iter()
        .filter(|live| !live.title.is_empty())
        .map(|live| format!("{{{{#figure {}", live.name));
    // Each value is an arm of a match, `("name", [])`.
    let sources = Files::read(&workspace().join("book/crates/builder/src/values"));
    let sources = sources.expect("the sources of the values");
    let lines = sources.texts_with_suffix(".rs").flat_map(|(_, text)| text.lines());
    let names: Vec<_> =
        lines.filter_map(|line| line.trim().strip_prefix("(\"")?.split('"').next()).collect();
    assert!(50 < names.len(), "{names:?}");
    let values = names.iter().map(|name| format!("{{{{#value {name}"));
    let unused = figures.chain(values).filter(|directive| {
        ["}}", " "].iter().all(|end| !chapters.contains(&format!("{directive}{end}")))
    });
    assert_eq!(unused.collect::<Vec<_>>(), [""; 0]);
}

#[test]
fn a_link_that_leads_nowhere_is_a_fault() {
    for (html, what) in [
        ("<a href=\"nowhere.html\">a</a>", "a.html#i leads to nowhere.html"),
        ("<a href=\"#nowhere\">a</a>", "#nowhere, which is not in a.html"),
        ("<img srcset=\"b.png 2x\">", "leads to b.png"),
        ("<img src=\"//a.example/b\">", "fetches //a.example/b"),
        ("<style>p { background: url('x:b') }</style>", "fetches x:b"),
    ] {
        let fine = "<a href=\"https://a.example\">a</a><a href=\"#i\">b</a>";
        let page = Page::parse("a.html", &format!("<p id=\"i\">{fine}</p>{html}"));
        let files = Files([("a.html".to_owned(), vec![])].into());
        let site = Site { files, pages: [("a.html".to_owned(), page)].into() };
        let faults = links::find_faults(&site, &Files::default());
        assert!(faults.len() == 1 && faults[0].contains(what), "{faults:?}");
    }
}

#[test]
fn a_fault_of_a_link_has_the_line_of_its_chapter() {
    let html = "<p><a href=\"b.html#i\">b</a></p>";
    let pages = ["a.html", "print.html"].map(|name| (name.to_owned(), Page::parse(name, html)));
    let site = Site { files: Files::default(), pages: pages.into() };
    let chapter = b"# A\n\nSee [b](b.md#i).\n".to_vec();
    let faults = links::find_faults(&site, &Files([("a.md".to_owned(), chapter)].into()));
    let sentence = "book/src/a.md:3: the link leads to b.html, which is not in the book";
    assert_eq!(faults, [sentence]);
}

#[test]
fn on_paper_answers_come_behind_their_chapter() {
    let predict = "<details class=\"predict\"><summary>why?</summary>so</details>";
    let aside = "<details class=\"aside\"><summary>by the way</summary>it</details>";
    let next = "<div style=\"break-before: page;\"></div>";
    let chapter = |name| format!("<h1 id=\"{name}\"><a>{name}</a></h1>");
    let (one, two) = (chapter("one"), chapter("two"));
    let html = format!("<main>{one}{next}{two}{predict}{aside}end</main>");
    let mut page = Page::parse("print.html", &html);
    paper_page::arrange_for_paper(&mut page).expect("a book of two chapters");
    let text = crate::inner_text(page.html.root_element());
    assert_eq!(text, "oneContentstwotwowhy? → 1by the wayitAnswers and hints1soend");
    let torn = format!("<main>{one}{two}</main>");
    assert!(paper_page::arrange_for_paper(&mut Page::parse("print.html", &torn)).is_err());
}
