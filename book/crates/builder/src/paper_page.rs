use crate::{Page, select_all};
use anyhow::{Context, Result};
use scraper::{ElementRef, Node};
use std::mem::take;

/// Arranges mdBook's page of the whole book for paper: a list of contents before the
/// chapters, and behind each chapter what is folded away on the screen.
pub fn arrange_for_paper(page: &mut Page) -> Result<()> {
    let (mut insertions, mut folded) = (vec![], vec![]);
    let (mut answers, mut contents, mut first_break) = (Answers::default(), String::new(), None);
    for part in page.select_all("main h1, main details, main > div[style*=break-before]") {
        match part.value().name() {
            "h1" if first_break.is_some() => contents += &contents_item_html(part),
            "h1" => {}
            "div" => {
                insertions.push((part.id(), answers.take_html()));
                first_break.get_or_insert((part.id(), part.html()));
            }
            _ => {
                insertions.push((part.id(), answers.unfold(part)));
                folded.push(part.id());
            }
        }
    }
    let (first_break, html) = first_break.context("nothing ends a chapter on paper")?;
    let list = format!(
        "{html}<h2 id=\"contents-on-paper\">Contents</h2><ol class=\"chapters\">{contents}</ol>"
    );
    insertions.push((first_break, list));
    let main = page.select_all("main");
    let end = main.first().and_then(|main| main.last_child()).map(|end| end.id());
    insertions.extend(end.map(|end| (end, answers.take_html())));
    insertions.iter().for_each(|(node, html)| page.insert_html_before(*node, html));
    folded.into_iter().for_each(|node| page.remove_node(node));
    remove_what_is_for_screens(page);
    Ok(())
}

/// The item of a chapter in the list of contents.
fn contents_item_html(heading: ElementRef) -> String {
    let id = heading.attr("id").unwrap_or_default();
    let title = first_inside(heading, "a").map_or(String::new(), |a| a.inner_html());
    format!("<li><a href=\"#{id}\">{title}</a></li>")
}

/// The answers to the questions of the chapter so far.
#[derive(Default)]
struct Answers {
    html: String,
    question_count: usize,
}

impl Answers {
    /// The section with these answers, behind a chapter.
    fn take_html(&mut self) -> String {
        let heading = if self.html.is_empty() { "" } else { "<h2>Answers and hints</h2>" };
        heading.to_owned() + &take(&mut self.html)
    }

    /// What stands on paper in place of a box: an aside opened, of any other the question alone.
    fn unfold(&mut self, details: ElementRef) -> String {
        let summary = first_inside(details, "summary");
        let Some(summary) = summary.filter(|_| details.attr("hidden").is_none()) else {
            return String::new();
        };
        let words = summary.inner_html();
        let text = details.inner_html().replacen(&summary.html(), "", 1);
        if details.attr("class") == Some("aside") {
            return format!("<section class=\"aside\"><p>{words}</p>{text}</section>");
        }
        self.question_count += 1;
        let number = self.question_count;
        self.html += &format!(
            "<div class=\"answer\" id=\"answer-{number}\">\
             <a href=\"#asked-{number}\">{number}</a>{text}</div>"
        );
        format!(
            "<p class=\"asked\" id=\"asked-{number}\">{words} \
             <a href=\"#answer-{number}\">→ {number}</a></p>"
        )
    }
}

fn first_inside<'a>(element: ElementRef<'a>, selector: &str) -> Option<ElementRef<'a>> {
    select_all(element, selector).into_iter().next()
}

/// A picture that waits to be seen would not be on paper, and no pixel can be asked there.
fn remove_what_is_for_screens(page: &mut Page) {
    for node in page.html.tree.values_mut() {
        if let Node::Element(element) = node {
            element.attrs.retain(|(name, value)| match &*name.local {
                "loading" => false,
                "href" => {
                    !["#pixel=", "#line=", "#scene="].iter().any(|start| value.contains(start))
                }
                _ => true,
            });
        }
    }
}
