//! What a chapter may hold, what its author is told, and what is done to a page.

use crate::chapter::expand;
use crate::{Files, Page, Site, links, paper_page, pixel_panel};
use compare::workspace;

const RAY: &str = "../../steps/step01_rays/src/ray.rs";
const SKY: &str = "../../tests/snapshots/step01_rays.snap.png";

fn listing(target: &str) -> String {
    format!("# Title\n\n```rust\n{{{{#include {target}}}}}\n```\n")
}

#[track_caller]
fn right(markdown: &str) -> String {
    let (markdown, faults) = expand(markdown, &workspace());
    assert_eq!(faults, []);
    markdown
}

/// Fails unless the only fault is on `line` and is told in these words.
#[track_caller]
fn wrong(markdown: &str, line: usize, words: &str) {
    let (_, faults) = expand(markdown, &workspace());
    let [(found, what)] = &faults[..] else { panic!("not one fault: {faults:?}") };
    assert_eq!(*found, line, "{what}");
    assert!(what.contains(words), "{what:?} does not say {words:?}");
}

#[test]
fn a_listing_is_a_file_or_a_part_of_it() {
    let file = include_str!("../../steps/step01_rays/src/ray.rs").trim_end();
    let part = |part: &str| right(&listing(&format!("{RAY}:{part}")));
    let (until, from) = (part("..impl Ray"), part("impl Ray.."));
    let (begin, end) = file.split_once("\nimpl").expect("an impl");
    assert!(right(&listing(RAY)).contains(&format!("```rust\n{file}\n```")));
    assert!(until.contains(&format!("```rust\n{begin}\n```")), "{until}");
    assert!(from.contains(&format!("```rust\nimpl{end}\n```")), "{from}");
    wrong(&listing("../../steps/nowhere.rs"), 3, "no file");
    wrong(&listing(&format!("{RAY}:3:5")), 3, "not 3:5");
    wrong(&listing(&format!("{RAY}:..pub type")), 3, "begins with \"pub type\"");
    wrong(&listing(&format!("{RAY}}}}}\nlet x = 1; {{{{")), 3, "nothing else");
    wrong("{{#include ../../Cargo.toml}}\n", 1, "stands alone");
}

#[test]
fn a_formula_is_read() {
    assert!(right("So $a_i^2 * b$.").contains("<msubsup>"));
    right("It costs 5\\$.\n");
    wrong("One.\n\nTwo $\\nosuchcommand{x}$.\n", 3, "does not parse");
    for dollar in ["It costs 5$ or so.\n", "<p>$x$</p>\n", "$$\\frac{1}{2\n"] {
        wrong(dollar, 1, "a $ that is no formula");
    }
}

#[test]
fn a_value_has_the_minus_of_its_place() {
    assert!(right("It is {{#value camera-v0-x}}.").contains("−0.5774"));
    assert!(right("It is `{{#value camera-v0-x}}`.").contains("-0.5774"));
    assert!(right("It is $t = {{#value camera-tan}}$.").contains("<mn>0&#46;5774"));
    wrong("It is {{#value nothing}} long.\n", 1, "no value nothing");
    wrong("It is $t = {{#value nothing}}$.\n", 1, "no value nothing");
    wrong("One {{#value camera-step\n", 1, "no }}");
}

#[test]
fn a_value_is_of_a_pixel_or_a_figure_or_a_function() {
    let pixel = right("{{#value step05_phong:470,120:bytes}}");
    assert!(pixel.contains("(228, 215, 255)"), "{pixel}");
    assert!(right("{{#value row:D}}").contains("0.1925"));
    assert!(right("{{#value half-angle 1}}").contains("60.0"));
    for name in [
        "step05_phong:470,360:bytes",
        "step05_phong:470:bytes",
        "step05_phong:nothing",
        "row:470,120:D",
        "half-angle",
        "half-angle 1 2",
        "camera-tan 1",
    ] {
        wrong(&format!("It is {{{{#value {name}}}}}.\n"), 1, "no value");
    }
}

#[test]
fn a_directive_has_its_place() {
    wrong("One.\n\n{{#figure nowhere}}\n", 3, "no figure nowhere");
    wrong("See {{#figure ray}} here.\n", 1, "stands alone");
    wrong("One\n{{#playground x.rs}}\n", 2, "none of the directives");
    wrong("{{#predict Why?}}\n\nSo.\n", 1, "no {{#end}}");
    wrong("So.\n\n{{#end}}\n", 3, "without a box");
    wrong("One.\n\n```console\n$ ls\n```\n", 3, "console,yours or");
}

#[test]
fn a_picture_has_words_and_may_answer() {
    wrong("One.\n\n![](generated/step01_rays.png)\n", 3, "no alt text");
    wrong("One.\n\n![What](generated/nowhere.png)\n", 3, "no picture");
    wrong(
        &format!("![A sky.]({SKY}) {{{{#live nothing}}}}\n"),
        1,
        "nothing answers",
    );
    let html =
        right(&format!("![A sky.]({SKY} \"[It](a.md)\") {{{{#live own_scene}}}}"));
    assert!(
        html.contains("alt=\"A sky.\"") && html.contains("data-live=\"own_scene\"")
    );
}

#[test]
fn every_figure_and_every_value_is_used() {
    let files = Files::read(&workspace().join("book/chapters")).expect("chapters");
    let texts = files.texts(".md").map(|(_, text)| text);
    let chapters: String = texts.chain([pixel_panel::TEXT]).collect();
    let figures = live::LIVE
        .iter()
        .filter(|live| !live.title.is_empty())
        .map(|live| format!("{{{{#figure {}", live.name));
    // Each value is an arm of a match, `("name", [])`.
    let sources = Files::read(&workspace().join("book/builder/values"));
    let sources = sources.expect("the sources of the values");
    let lines = sources.texts(".rs").flat_map(|(_, text)| text.lines());
    let names: Vec<_> = lines
        .filter_map(|line| line.trim().strip_prefix("(\"")?.split('"').next())
        .collect();
    assert!(50 < names.len(), "{names:?}");
    let values = names.iter().map(|name| format!("{{{{#value {name}"));
    let unused = figures.chain(values).filter(|directive| {
        ["}}", " "]
            .iter()
            .all(|end| !chapters.contains(&format!("{directive}{end}")))
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
        let page = Page::new("a.html", &format!("<p id=\"i\">{fine}</p>{html}"));
        let files = Files([("a.html".to_owned(), vec![])].into());
        let site = Site { files, pages: [("a.html".to_owned(), page)].into() };
        let faults = links::faults(&site, &Files::default());
        assert!(faults.len() == 1 && faults[0].contains(what), "{faults:?}");
    }
}

#[test]
fn a_fault_of_a_link_has_the_line_of_its_chapter() {
    let html = "<p><a href=\"b.html#i\">b</a></p>";
    let pages = ["a.html", "print.html"]
        .map(|name| (name.to_owned(), Page::new(name, html)));
    let site = Site { files: Files::default(), pages: pages.into() };
    let chapter = b"# A\n\nSee [b](b.md#i).\n".to_vec();
    let faults =
        links::faults(&site, &Files([("a.md".to_owned(), chapter)].into()));
    let told =
        "book/chapters/a.md:3: the link leads to b.html, which is not in the book";
    assert_eq!(faults, [told]);
}

#[test]
fn on_paper_answers_come_behind_their_chapter() {
    let predict = "<details class=\"predict\"><summary>why?</summary>so</details>";
    let aside =
        "<details class=\"aside\"><summary>by the way</summary>it</details>";
    let next = "<div style=\"break-before: page;\"></div>";
    let chapter = |name| format!("<h1 id=\"{name}\"><a>{name}</a></h1>");
    let (one, two) = (chapter("one"), chapter("two"));
    let html = format!("<main>{one}{next}{two}{predict}{aside}end</main>");
    let mut page = Page::new("print.html", &html);
    paper_page::arrange(&mut page).expect("a book of two chapters");
    let text = crate::text(page.html.root_element());
    assert_eq!(
        text,
        "oneContentstwotwowhy? → 1by the wayitAnswers and hints1soend"
    );
    let torn = format!("<main>{one}{two}</main>");
    assert!(paper_page::arrange(&mut Page::new("print.html", &torn)).is_err());
}
