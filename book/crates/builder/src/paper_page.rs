use crate::{Page, select_all};
use anyhow::{Result, ensure};
use scraper::Node;
use std::mem::take;

/// Arranges mdBook's page of the whole book for paper: a list of contents before the
/// chapters, and behind each chapter what is folded away on the screen.
pub fn arrange_for_paper(page: &mut Page) -> Result<()> {
    let end = page.select_first("main")?.last_child().map(|node| node.id());
    let mut insertions = vec![];
    let mut removals = vec![];
    let (mut breaks, mut contents) = (vec![], vec![]);
    let (mut question_count, mut answers) = (0, String::new());
    for part in page.select_all("main h1, main details, main > div[style*=break-before]") {
        let inside = |selector| select_all(part, selector).into_iter().next();
        match part.value().name() {
            "div" => {
                insertions.push((part.id(), answers_html(&take(&mut answers))));
                breaks.push(part);
            }
            "h1" => {
                let id = part.attr("id").unwrap_or_default();
                let title = inside("a").map_or(String::new(), |a| a.inner_html());
                contents.push(format!("<li><a href=\"#{id}\">{title}</a></li>"));
            }
            _ => {
                removals.push(part.id());
                if part.attr("hidden").is_some() {
                    continue;
                }
                let Some(summary) = inside("summary") else { continue };
                let words = summary.inner_html();
                let text = part.inner_html().replacen(&summary.html(), "", 1);
                let html = if part.attr("class") == Some("aside") {
                    format!("<section class=\"aside\"><p>{words}</p>{text}</section>")
                } else {
                    question_count += 1;
                    answers += &format!(
                        "<div class=\"answer\" id=\"answer-{question_count}\">\
                         <a href=\"#asked-{question_count}\">{question_count}</a>{text}</div>"
                    );
                    format!(
                        "<p class=\"asked\" id=\"asked-{question_count}\">{words} \
                         <a href=\"#answer-{question_count}\">→ {question_count}</a></p>"
                    )
                };
                insertions.push((part.id(), html));
            }
        }
    }
    ensure!(
        1 < contents.len() && contents.len() == breaks.len() + 1,
        "{} has {} chapters with {} breaks between them",
        page.name,
        contents.len(),
        breaks.len()
    );
    let list = format!(
        "{}<h2 id=\"contents-on-paper\">Contents</h2><ol class=\"chapters\">{}</ol>",
        breaks[0].html(),
        contents[1..].concat()
    );
    insertions.push((breaks[0].id(), list));
    insertions.extend(end.map(|end| (end, answers_html(&answers))));
    insertions.iter().for_each(|(node, html)| page.insert_html_before(*node, html));
    removals.into_iter().for_each(|node| page.remove_node(node));
    // A picture that waits to be seen would not be on paper, and no pixel can be asked there.
    for node in page.html.tree.values_mut() {
        if let Node::Element(element) = node {
            element.attrs.retain(|(name, value)| match &*name.local {
                "loading" => false,
                "href" => !value.contains("#pixel="),
                _ => true,
            });
        }
    }
    Ok(())
}

/// The section with these answers, behind a chapter.
fn answers_html(answers: &str) -> String {
    let heading = if answers.is_empty() { "" } else { "<h2>Answers and hints</h2>" };
    format!("{heading}{answers}")
}
