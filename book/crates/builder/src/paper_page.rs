use crate::{Page, select_all};
use anyhow::{Result, ensure};
use ego_tree::NodeId;
use scraper::{ElementRef, Node};
use std::mem::take;

/// Arranges mdBook's page of the whole book for paper: a list of contents before the
/// chapters, and behind each chapter what is folded away on the screen.
pub fn arrange_for_paper(page: &mut Page) -> Result<()> {
    let end = page.select_first("main")?.last_child().map(|node| node.id());
    let mut paper = Paper::default();
    for part in page.select_all("main h1, main details, main > div[style*=break-before]") {
        match part.value().name() {
            "h1" => paper.add_chapter(part),
            "div" => paper.end_chapter(part),
            _ => paper.unfold(part),
        }
    }
    let (chapters, breaks) = (paper.contents.len(), paper.breaks.len());
    ensure!(
        1 < chapters && chapters == breaks + 1,
        "{} has {chapters} chapters with {breaks} breaks between them",
        page.name,
    );
    let (first_break, html) = &paper.breaks[0];
    let contents = paper.contents[1..].concat();
    let list = format!(
        "{html}<h2 id=\"contents-on-paper\">Contents</h2><ol class=\"chapters\">{contents}</ol>"
    );
    paper.insertions.push((*first_break, list));
    paper.insertions.extend(end.map(|end| (end, answers_html(&paper.answers))));
    paper.insertions.iter().for_each(|(node, html)| page.insert_html_before(*node, html));
    paper.folded.into_iter().for_each(|node| page.remove_node(node));
    remove_what_is_for_screens(page);
    Ok(())
}

/// What is found in the page, from top to bottom.
#[derive(Default)]
struct Paper {
    /// HTML to put before nodes.
    insertions: Vec<(NodeId, String)>,
    /// The boxes that a reader of the screen opens.
    folded: Vec<NodeId>,
    /// What begins a new page between chapters, and its HTML.
    breaks: Vec<(NodeId, String)>,
    /// An item of the list of contents for each chapter.
    contents: Vec<String>,
    question_count: usize,
    /// The answers to the questions of the chapter so far.
    answers: String,
}

impl Paper {
    fn add_chapter(&mut self, heading: ElementRef) {
        let id = heading.attr("id").unwrap_or_default();
        let title = first_inside(heading, "a").map_or(String::new(), |a| a.inner_html());
        self.contents.push(format!("<li><a href=\"#{id}\">{title}</a></li>"));
    }

    fn end_chapter(&mut self, page_break: ElementRef) {
        self.insertions.push((page_break.id(), answers_html(&take(&mut self.answers))));
        self.breaks.push((page_break.id(), page_break.html()));
    }

    /// Puts an aside in place of its box, and of any other the question alone.
    fn unfold(&mut self, details: ElementRef) {
        self.folded.push(details.id());
        let summary = first_inside(details, "summary");
        let Some(summary) = summary.filter(|_| details.attr("hidden").is_none()) else { return };
        let words = summary.inner_html();
        let text = details.inner_html().replacen(&summary.html(), "", 1);
        let html = if details.attr("class") == Some("aside") {
            format!("<section class=\"aside\"><p>{words}</p>{text}</section>")
        } else {
            self.question_count += 1;
            let number = self.question_count;
            self.answers += &format!(
                "<div class=\"answer\" id=\"answer-{number}\">\
                 <a href=\"#asked-{number}\">{number}</a>{text}</div>"
            );
            format!(
                "<p class=\"asked\" id=\"asked-{number}\">{words} \
                 <a href=\"#answer-{number}\">→ {number}</a></p>"
            )
        };
        self.insertions.push((details.id(), html));
    }
}

fn first_inside<'a>(element: ElementRef<'a>, selector: &str) -> Option<ElementRef<'a>> {
    select_all(element, selector).into_iter().next()
}

/// The section with these answers, behind a chapter.
fn answers_html(answers: &str) -> String {
    let heading = if answers.is_empty() { "" } else { "<h2>Answers and hints</h2>" };
    format!("{heading}{answers}")
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
