//! Tests of how chapters are expanded, which faults are reported, and what the search index
//! contains.

use crate::chapter::{ExpandedChapter, expand_chapter};
use crate::directive::DirectiveKind;
use crate::problem::{self, Problem};
use crate::{Files, Page, Site, Sources, links, search};
use course::workspace;
use figures::{Content, FIGURES};
use std::io;
use std::sync::LazyLock;

static SOURCES: LazyLock<Sources> =
    LazyLock::new(|| Sources::read(&workspace()).expect("the sources can be read"));

fn expand(chapter: &str) -> ExpandedChapter {
    expand_chapter(chapter, &SOURCES, "in *our* folder")
}

fn list_faults(chapter: &str) -> String {
    expand(chapter).faults.iter().map(|fault| format!("{fault}\n")).collect()
}

#[test]
fn chapter_with_every_directive_is_expanded() {
    let text = include_str!("tests/one_of_each.md");
    assert_eq!(list_faults(text), "");
    insta::assert_snapshot!(expand(text).markdown_with_sheet("The sheet.\n"));
}

#[test]
fn each_directive_is_listed_in_lib_and_expanded_in_one_of_each() {
    let list: String =
        include_str!("lib.rs").lines().filter(|line| line.starts_with("//!")).collect();
    let example = include_str!("tests/one_of_each.md");
    let mut faults = vec![];
    for kind in DirectiveKind::ALL {
        let name = kind.name();
        if !list.contains(&format!("*{name}*")) && !list.contains(&format!("`{name}`")) {
            faults.push(format!("The list at the top of lib.rs has no {name}."));
        }
        let is_expanded =
            ["}}", " "].iter().any(|end| example.contains(&format!("{{{{#{name}{end}")));
        if !is_expanded {
            faults.push(format!("tests/one_of_each.md has no {{{{#{name}}}}}."));
        }
    }
    assert_eq!(faults, [""; 0]);
}

#[test]
fn each_fault_is_reported_with_its_line() {
    let faults = list_faults(include_str!("tests/faults.md"));
    // The message for a missing file differs between systems.
    let not_found = io::Error::from_raw_os_error(2).to_string();
    insta::assert_snapshot!(faults.replace(&not_found, "[not found]"));
}

/// These SVG files are for use on slides. Not every presentation program supports CSS variables and
/// CSS functions.
#[test]
fn svg_files_of_drawings_have_no_css_variables_or_functions() {
    let files: Vec<_> = SOURCES.generated.texts_with_suffix(".svg").collect();
    let is_drawing = |content: &Content| matches!(content, Content::Drawing { .. });
    assert_eq!(files.len(), FIGURES.iter().filter(|figure| is_drawing(&figure.content)).count());
    for (name, svg) in files {
        let (start, style) = svg.split_once("<style>").expect(name);
        assert!(start.contains("viewBox=\"-24 0 528 "), "{name} begins with {start}");
        for words in ["var(", "light-dark(", ":is(", "transform"] {
            assert!(!style.contains(words), "the style of {name} contains {words}");
        }
    }
}

#[test]
fn deep_nesting_is_a_fault() {
    let formulas =
        [("{", "}"), ("\\sqrt", ""), ("\\left(", "\\right)"), ("\\frac{1}", ""), ("x^", "")];
    let formulas =
        formulas.map(|(open, close)| format!("${}x{}$\n", open.repeat(5000), close.repeat(5000)));
    let blocks = ["> ", "- "].map(|open| open.repeat(5000) + "x\n");
    for chapter in formulas.iter().chain(&blocks) {
        let faults = list_faults(chapter);
        assert!(faults.starts_with("1: "), "{}: {faults}", &chapter[..20]);
    }
}

#[test]
fn problem_with_too_many_words_is_a_fault() {
    let problem = |words: usize| {
        let text = "word ".repeat(words);
        format!("{{{{#problem 7 0.5}}}}\n\n{text}\n\n{{{{#answer}}}}\n\n**0.5**\n\n{{{{#end}}}}\n")
    };
    assert_eq!(list_faults(&problem(80)), "");
    assert_eq!(list_faults(&problem(81)), "1: a problem has at most 80 words\n");
}

#[test]
fn the_sheet_has_the_problems_of_all_chapters_and_then_their_answers() {
    let text = "# A title\n\n{{#problem 7 0.5}}\n\nHow **far** is $t$?\n\n{{#answer}}\n\n\
                It is **0.5 = $t$.** A **way**.\n\n{{#end}}\n\nText.\n";
    let texts = [("One: practice", text), ("None", "# None\n"), ("Two", &text.replace('7', "8"))];
    let chapters = texts.map(|(title, text)| (title.to_owned(), expand(text).problems));
    insta::assert_snapshot!(
        problem::sheet_markdown(&chapters, &SOURCES.values).expect("the sheet has no faults")
    );
}

#[test]
fn problems_are_numbered_in_order_and_their_bold_answers_match_their_first_lines() {
    let files = Files::read(&workspace().join("book/src")).expect("the chapters can be read");
    let summary = files.text("SUMMARY.md").expect("SUMMARY.md exists");
    let names = summary.split(['(', ')']).filter(|name| name.ends_with(".md"));
    let chapters = names.filter_map(|name| files.text(name));
    let problems: Vec<_> = chapters.flat_map(|text| expand(text).problems).collect();
    for (number, problem) in (1..).zip(&problems) {
        let Problem { number_and_answer, text, result } = problem;
        assert_eq!(number_and_answer.number, number.to_string(), "{text}");
        // The sheet shows the passage in bold as the answer, so the passage has to match the answer
        // in `{{#problem …}}`.
        let bold = result.trim_matches('*').trim_end_matches(['.', '°', '%']).trim_end();
        assert_eq!(number_and_answer.answer, bold, "{text}");
    }
    assert!(problems.len() > 10);
}

#[test]
fn broken_links_and_external_resources_are_faults() {
    let page = Page::parse("a.html", include_str!("tests/links.html"));
    let files = Files([("a.html".to_owned(), vec![])].into());
    let site = Site { files, pages: [("a.html".to_owned(), page)].into() };
    let faults: Vec<_> =
        links::find_address_faults(&site).iter().map(ToString::to_string).collect();
    insta::assert_snapshot!(faults.join("\n"));
}

fn small_site() -> Site {
    let html = include_str!("tests/sections.html");
    let pages = ["a.html", "index.html"].map(|name| (name.to_owned(), Page::parse(name, html)));
    Site { files: Files([].into()), pages: pages.into() }
}

#[test]
fn search_index_has_the_sections_of_a_page_without_answers_or_hidden_text() {
    insta::assert_snapshot!(search::index_script(&small_site(), "").expect("all sections exist"));
}

#[test]
fn search_index_has_the_phrases_hints_and_synonyms_of_readers() {
    let words = include_str!("tests/search_words.txt");
    insta::assert_snapshot!(
        search::index_script(&small_site(), words).expect("all sections exist")
    );
}

#[test]
fn search_words_for_a_missing_section_are_a_fault() {
    let words =
        "@ a.html#a\nreal words\n\n@ a.html#gone\nwords\n\n@ b.html#b\n! E0001 → A sentence.\n";
    let error = search::index_script(&small_site(), words).expect_err("two sections are missing");
    insta::assert_snapshot!(error);
}
