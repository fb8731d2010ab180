//! What a chapter may hold, and each fault that its author is told of.

use crate::draft::{Chapter, expand};
use crate::files::CHAPTERS;
use crate::{Files, values};

/// The workspace of these tests is this project itself.
fn chapter(markdown: &str) -> Chapter {
    expand(markdown, &::compare::workspace())
}

/// Asserts that the only fault is on `line` and that it is told in these words.
#[track_caller]
fn wrong(markdown: &str, line: usize, words: &str) {
    let faults = chapter(markdown).faults;
    let [(found, what)] = &faults[..] else { panic!("not one fault: {faults:?}") };
    assert_eq!(*found, line, "{what}");
    assert!(what.contains(words), "{what:?} does not say {words:?}");
}

#[track_caller]
fn right(markdown: &str) -> String {
    let Chapter { markdown, faults } = chapter(markdown);
    assert_eq!(faults, []);
    markdown
}

const RAY: &str = "../../steps/step01_rays/src/ray.rs";

fn listing(target: &str) -> String {
    format!("# Title\n\n```rust\n{{{{#include {target}}}}}\n```\n")
}

#[test]
fn a_listing_has_every_line_of_its_file() {
    let file = include_str!("../../steps/step01_rays/src/ray.rs");
    let markdown = right(&listing(RAY));
    assert!(markdown.contains(file.trim_end()));
    assert!(markdown.contains(r#"data-path="steps/step01_rays/src/ray.rs""#));
    assert!(markdown.contains("step01_rays/src/<b>ray.rs</b>"));
    assert!(!markdown.contains("class=\"part\""));
}

#[test]
fn a_part_of_a_file_says_which_lines() {
    let part = |part: &str| right(&listing(&format!("{RAY}:{part}")));
    let (until, from) = (part("..impl Ray"), part("impl Ray.."));
    assert!(until.contains(r#"data-lines="1-11""#) && !until.contains("impl Ray"));
    assert!(from.contains("lines 12–17 of 17") && from.contains("rust\nimpl Ray"));
    // A part begins with the comments and attributes of its item.
    assert!(part("pub struct..pub fn at").contains("lines 3–12 of 17"));
}

#[test]
fn a_wrong_listing_is_a_mistake() {
    wrong("# Title\n\n```rust\nfn main() {}\n```\n", 3, "Rust in the book is");
    wrong("Text.\n\n~~~rs\nlet x = 1;\n~~~\n", 3, "Rust in the book is");
    wrong("Text.\n\n    let x = 1;\n", 3, "fence that names its language");
    wrong("Text.\n\n```\nlet x = 1;\n```\n", 3, "names no language");
    wrong(&listing("../../steps/nowhere.rs"), 4, "no file");
    wrong(&listing(&format!("{RAY}:3:5")), 4, "not 3:5");
    wrong(&listing(&format!("{RAY}:..pub type")), 4, "begins with \"pub type\"");
    wrong(&listing(&format!("{RAY}:impl Ray..use")), 4, "begins with \"use\"");
    wrong(&listing(&format!("{RAY}}}}}\nlet x = 1; {{{{")), 4, "nothing else");
    wrong(
        "- item\n\n  ```rust\n  {{#include ../../steps/step01_rays/src/ray.rs}}\n  ```\n",
        4,
        "left margin",
    );
    wrong("{{#include ../../Cargo.toml}}\n", 1, "alone in a fence");
}

#[test]
fn a_wrong_formula_is_a_mistake() {
    wrong("One.\n\nTwo $\\nosuchcommand{x}$.\n", 3, "does not parse");
    wrong("One.\n\n$$\\frac{1}{2\n", 3, "leftover $$");
    wrong("One.\n\nTwo $a \\\\[4pt] b$.\n", 3, "a length after a line's end");
    wrong("It costs 5$ or so.\n", 1, "lone $");
    wrong("<p>$x$</p>\n", 1, "no formula");
    right("It costs 5\\$.\n");
    assert!(right("So $a_i^2 * b$.").contains("<msubsup>"));
}

#[test]
fn a_wrong_figure_value_or_directive_is_a_mistake() {
    wrong("One.\n\n{{#figure nowhere}}\n", 3, "no figure nowhere");
    wrong("See {{#figure ray}} here.\n", 1, "stands alone");
    wrong("So {{#by-hand it}} is.\n", 1, "stands alone");
    wrong("It is {{#value nothing}} long.\n", 1, "no value nothing");
    wrong("It is $t = {{#value nothing}}$.\n", 1, "no value nothing");
    wrong("One\n{{#playground x.rs}}\n", 2, "no directive");
    wrong("One {{#value camera-step\n", 1, "no }}");
    wrong("{{#predict Why?}}\n\nSo.\n", 1, "no {{#end}}");
    wrong("So.\n\n{{#end}}\n", 3, "without a box");
    wrong("One.\n\n```console\n$ ls\n```\n", 3, "console,yours or");
    let ours = right("One.\n\n```console,ours\n$ ls\n```\n");
    assert!(ours.contains("our folder") && ours.contains("```console\n$ ls\n"));
    let new = right("So.\n\n{{#rust `let … else` is new.}}\n");
    assert!(new.contains("New Rust here</b> <code>let … else</code>"), "{new}");
    assert!(
        right("{{#predict Why $t$?}}\n\nSo.\n\n{{#end}}\n").contains("<details")
    );
    assert!(
        right("So.\n\n{{#by-hand axis_a}}\n").contains(r#"id="by-hand-axis_a""#)
    );
    assert!(
        right("It is $t = {{#value camera-tan}}$.").contains("<mn>0&#46;5774</mn>")
    );
    assert!(right("It is {{#value camera-v0-x}}.").contains("−0.5774"));
}

#[test]
fn a_wrong_picture_is_a_mistake() {
    wrong("One.\n\n![](pictures/step01_rays.png)\n", 3, "no alt text");
    wrong("One.\n\n![What](pictures/nowhere.png)\n", 3, "no picture");
    wrong("One.\n\n![What](SUMMARY.md)\n", 3, "not a PNG");
    wrong(
        "One.\n\n<img src=\"pictures/step01_rays.png\" alt=\"x\">\n",
        3,
        "write a picture as",
    );
}

const SKY: &str = "../../tests/snapshots/step01_rays.snap.png";

#[test]
fn a_picture_answers_by_the_name_of_its_file_or_by_another() {
    let picture = format!("![A sky.]({SKY})");
    let html = right(&format!("{picture} {{{{#live own_scene}}}}\n"));
    assert!(html.contains(r#"data-live="own_scene""#), "{html}");
    // All of its knobs are printed, in the order of the page's values.
    let last = live::find("own_scene").map_or(0, |live| live.knobs.len()) - 1;
    assert!(html.contains(&format!(r#"data-knob="{last}""#)), "{html}");
    assert!(html.contains("<option>red sphere</option>"), "{html}");
    wrong(&format!("{picture} {{{{#live}}}}\n"), 1, "nothing answers");
    wrong(&format!("{picture} {{{{#live nothing}}}}\n"), 1, "nothing answers");
}

#[test]
fn a_listing_may_move() {
    let path = "steps/step05_phong/examples/my_scene.rs";
    let html = right(&format!("{{{{#listing own_scene:rust {path}}}}}\n"));
    let end = format!(r#"-my_scene.rs" data-path="{path}" data-lines="1-"#);
    assert!(html.contains(&end), "{html}");
    let code = html.split("```").nth(1).expect("a fence");
    let lines = code.lines().count() - 1; // the language
    let start = format!(r#" data-code="own_scene:rust" style="--lines: {lines}">"#);
    assert!(html.contains(&start), "{html}");
    assert!(html.contains("    run(env!(\"CARGO_CRATE_NAME\"), picture);\n}\n```"));
    wrong("{{#listing own_scene:rust}}\n", 1, "NAME:NUMBER path");
    wrong(
        &format!("{{{{#listing own_scene:c {path}}}}}\n"),
        1,
        "no number own_scene:c",
    );
}

#[test]
fn a_caption_may_hold_a_link() {
    let html = right(&format!(r#"![A sky.]({SKY} "[Step 1](SUMMARY.md).")"#));
    assert!(html.contains(r#"alt="A sky.""#), "{html}");
}

#[test]
fn a_picture_may_stand_right_after_a_formula() {
    let html = right(&format!("Here $x$![A sky.]({SKY})."));
    assert!(html.contains("</math><img "), "{html}");
}

/// Each figure and each value that no chapter uses.
fn unused(chapters: &str) -> Vec<String> {
    let figures = live::names().map(|name| format!("{{{{#figure {name}}}}}"));
    let values = values::names().map(|name| format!("{{{{#value {name}}}}}"));
    figures.chain(values).filter(|one| !chapters.contains(one)).collect()
}

#[test]
fn every_figure_and_every_value_is_used() {
    let folder = ::compare::workspace().join(CHAPTERS);
    let files = Files::read(&folder).expect("the chapters can be read");
    let texts = files.texts(".md").map(|(_, text)| text);
    let chapters: String = texts.chain([crate::chain::TEXT]).collect();
    assert_eq!(unused(&chapters), [""; 0]);
    for one in
        ["{{#figure row}}", "{{#figure from-above}}", "{{#value slips-angle-2}}"]
    {
        assert_eq!(unused(&chapters.replace(one, "")), [one]);
    }
}

#[test]
fn a_reader_is_told_where_our_folder_is() {
    let ours = |url| crate::course::our_folder("/home/me/course".as_ref(), url);
    assert!(ours(None).contains("built: `/home/me/course`"));
    let url = "https://example.org/course";
    assert!(ours(Some(url)).contains("`git clone https://example.org/course`"));
}
