//! The whole book as one page, to be printed: mdBook's own, with a list of contents, and
//! with what is folded away on the screen behind its chapter.

/// What mdBook puts between two chapters.
const BREAK: &str =
    "<div style=\"break-before: page; page-break-before: always;\"></div>";
const MAIN: &str = "<main id=\"mdbook-content\" tabindex=\"-1\">";

/// mdBook's print page, for paper.
pub fn pressed(html: &str) -> String {
    let parts = html.split_once(MAIN).and_then(|(head, rest)| {
        let (text, foot) = rest.split_once("</main>")?;
        Some((head, text, foot))
    });
    let Some((head, text, foot)) = parts else { return html.to_owned() };
    // A picture that waits to be seen would not be on paper.
    let text = text.replace(" loading=\"lazy\"", "");
    let mut answers = 0;
    let chapters: Vec<_> =
        text.split(BREAK).map(|chapter| parted(chapter, &mut answers)).collect();
    let contents = contents(&chapters);
    let [cover, rest @ ..] = &chapters[..] else { return html.to_owned() };
    let text = [&[cover.clone(), contents], rest].concat().join(BREAK);
    format!("{head}{MAIN}{text}</main>{foot}")
}

/// A chapter with every question and no answer, and the answers at its end.
fn parted(chapter: &str, count: &mut usize) -> String {
    let (mut text, mut answers, mut rest) = (String::new(), String::new(), chapter);
    while let Some((before, kind, summary, inside, after)) = next_box(rest) {
        text += before;
        rest = after;
        if kind == "aside" {
            text += &format!(
                "<section class=\"aside\"><p>{summary}</p>{inside}</section>"
            );
            continue;
        }
        *count += 1;
        let n = *count;
        text += &format!(
            "<p class=\"asked\" id=\"asked-{n}\">{summary} \
             <a href=\"#answer-{n}\">→ {n}</a></p>"
        );
        answers += &format!(
            "<div class=\"answer\" id=\"answer-{n}\"><a href=\"#asked-{n}\">{n}</a>\
             {inside}</div>"
        );
    }
    text += rest;
    if !answers.is_empty() {
        text += &format!("<h2>Answers and hints</h2>{answers}");
    }
    text
}

/// What is before the next box, its kind, summary and inside, and what is after it.
fn next_box(html: &str) -> Option<(&str, &str, &str, &str, &str)> {
    let (before, rest) = html.split_once("<details class=\"")?;
    let (kind, rest) = rest.split_once("\"><summary>")?;
    let (summary, rest) = rest.split_once("</summary>")?;
    let (inside, after) = rest.split_once("</details>")?;
    Some((before, kind, summary, inside, after))
}

/// The list of contents: each chapter's heading.
fn contents(chapters: &[String]) -> String {
    let headings = chapters.iter().skip(1).filter_map(|chapter| {
        let (id, rest) = chapter.split_once("<h1 id=\"")?.1.split_once('"')?;
        let title = rest.split_once("\">")?.1.split_once("</a>")?.0;
        Some(format!("<li><a href=\"#{id}\">{title}</a></li>"))
    });
    let items: String = headings.collect();
    format!(
        "<h2 id=\"contents-on-paper\">Contents</h2><ol class=\"chapters\">{items}</ol>"
    )
}

#[test]
fn answers_come_behind_their_chapter_and_asides_stay() {
    let predict = |what| {
        format!(
            "<details class=\"predict\"><summary>{what}?</summary>\n<p>{what}.</p></details>"
        )
    };
    let chapter = |title: &str, text: String| {
        format!(
            "<h1 id=\"{title}\"><a href=\"#{title}\">{title}</a></h1>{text}<p>End {title}</p>"
        )
    };
    let aside =
        "<details class=\"aside\"><summary>By the way</summary><p>so</p></details>";
    let one = chapter("one", predict("why") + aside + &predict("how"));
    let html = format!(
        "<p>x</p>{MAIN}<h1>Cover</h1>{BREAK}{one}{BREAK}{}</main><p>y</p>",
        chapter("two", predict("who"))
    );
    let paper = pressed(&html);
    let order = [
        "<p>x</p>",
        "Cover",
        "href=\"#one\">one</a></li>",
        "href=\"#two\">two</a></li>",
        "why?",
        "<section class=\"aside\"><p>By the way</p><p>so</p></section>",
        "how?",
        "End one",
        "Answers",
        "id=\"answer-1\"",
        "why.",
        "how.",
        "who?",
        "End two",
        "id=\"answer-3\"",
        "who.",
        "</main><p>y</p>",
    ];
    let mut from = 0;
    for words in order {
        let at = paper[from..].find(words);
        from += at.unwrap_or_else(|| panic!("{words} after {}", &paper[..from]));
    }
    assert!(!paper.contains("details"), "{paper}");
}
