//! What is finished in a page that mdBook has written, so that it is shown quickly: its
//! styles are in it, and neither its first picture nor its faces wait.

use crate::Files;
use crate::files::joined;
use crate::picture::LAZY;

/// A page with all that it needs to be shown; `files` are those of the book.
pub fn finished(html: &str, files: &Files) -> String {
    let html = scrolled(&listed(&faced(&styled(html, files))));
    let Some(at) = html.find("<main") else { return html };
    let (head, text) = html.split_at(at);
    head.to_owned() + &text.replacen(LAZY, " fetchpriority=\"high\"", 1)
}

/// The page with the styles in it, instead of links to them.
fn styled(html: &str, files: &Files) -> String {
    const LINK: &str = "<link rel=\"stylesheet\" href=\"";
    let (mut page, mut styles, mut rest) = (String::new(), String::new(), html);
    while let Some((before, after)) = rest.split_once(LINK) {
        let Some((path, after)) = after.split_once("\">\n") else { break };
        let Some(css) = files.text(path) else { break };
        page += before;
        styles += &moved(css, path);
        rest = after;
    }
    match styles.is_empty() {
        true => html.to_owned(),
        false => format!("{page}<style>\n{styles}</style>\n{rest}"),
    }
}

/// The style from the file `path` for a page: its addresses count from there.
fn moved(css: &str, path: &str) -> String {
    let mut parts = css.split("url(\"");
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |css, part| match part.split_once('"') {
        Some((address, rest)) => {
            css + "url(\"" + &joined(path, address) + "\"" + rest
        }
        None => css + "url(\"" + part,
    })
}

/// The page, which begins with all faces if it has formulas: then it has code, too.
fn faced(html: &str) -> String {
    const FIRST: &str = "\"literata\", \"source-sans\"";
    const ALL: &str = "\"literata\", \"literata-italic\", \"source-sans\", \
                       \"course-math\", \"jetbrains-mono\"";
    if html.contains("<math") { html.replace(FIRST, ALL) } else { html.to_owned() }
}

/// mdBook puts the title of a part into an item of its own, and HTML has no such item.
fn listed(html: &str) -> String {
    let title = "<li class=\"part-title\">";
    let within = format!("<li class=\"chapter-item expanded \">{title}");
    html.replace(&within, title).replace("</li></li>", "</li>")
}

/// The page, in which what may scroll sideways takes the focus, so that the keyboard
/// can scroll it.
fn scrolled(html: &str) -> String {
    let mut html = html.to_owned();
    for start in ["<pre", "<div class=\"table-wrapper\"", "<span class=\"formula\""]
    {
        let whole = format!("{start}>");
        html = html.replace(&whole, &format!("{start} tabindex=\"0\">"));
    }
    html
}

#[test]
fn styles_and_the_first_picture_come_at_once() {
    let css = "@font-face { src: url(\"literata.woff2\"); }\n";
    let files = [("fonts/fonts.css", css), ("a.css", "p { color: red; }\n")];
    let files = files.map(|(path, text)| (path.to_owned(), text.into()));
    let link = |path| format!("<link rel=\"stylesheet\" href=\"{path}\">\n");
    let html = format!(
        "<head>\n<title>A</title>\n{}{}\
         <script>\nconst faces = [\"literata\", \"source-sans\"];\n</script>\n</head>\n\
         <li class=\"chapter-item expanded \"><li class=\"part-title\">B</li></li>\n\
         <main><img src=\"c.png\"{LAZY}><img src=\"d.png\"{LAZY}>\
         <pre></pre><math></math></main>",
        link("fonts/fonts.css"),
        link("a.css"),
    );
    let page = finished(&html, &Files(files.into()));
    let style = "<style>\n@font-face { src: url(\"fonts/literata.woff2\"); }\n\
                 p { color: red; }\n</style>\n<script>";
    let pictures = format!(
        "<main><img src=\"c.png\" fetchpriority=\"high\"><img src=\"d.png\"{LAZY}>"
    );
    let title = "\n<li class=\"part-title\">B</li>\n";
    let faces = "\"course-math\", \"jetbrains-mono\"];";
    let code = "<pre tabindex=\"0\"></pre>";
    for part in [style, &pictures, title, faces, code] {
        assert!(page.contains(part), "no {part} in {page}");
    }
}
