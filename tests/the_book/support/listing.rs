use builder::{Page, inner_text, select_all};
use scraper::ElementRef;

/// A listing: contiguous lines of a file.
#[derive(Clone, Debug)]
pub struct Listing<'a> {
    pub path: &'a str,
    /// The number of its first line, from 1.
    pub first_line: usize,
    pub code: String,
}

pub fn page_listings(page: &Page) -> impl Iterator<Item = Listing<'_>> {
    let figures = page.select_all(".listing").into_iter();
    figures.map(|figure| Listing::from_figure(page, figure))
}

impl<'a> Listing<'a> {
    /// Reads the listing in a `figure` of the page.
    pub fn from_figure(page: &'a Page, figure: ElementRef<'a>) -> Self {
        let location = page.address_for_fault(figure);
        let elements = select_all(figure, "code");
        let [element] = elements[..] else { panic!("{location} needs one code element") };
        let lines = figure.attr("data-lines").and_then(|lines| lines.split('-').next());
        let is_rust = element.attr("class").is_some_and(|class| class.contains("rust"));
        let mut code = inner_text(element);
        // mdBook ends the last line of all code but Rust.
        if !is_rust && code.ends_with('\n') {
            code.pop();
        }
        Self {
            path: figure.attr("data-path").unwrap_or_default(),
            first_line: lines.and_then(|first| first.parse().ok()).expect(&location),
            code,
        }
    }
}

/// Joins the listings of one file, in the order of its lines.
pub fn join_listings(listings: &[Listing]) -> String {
    let mut listings: Vec<_> = listings.iter().collect();
    listings.sort_by_key(|listing| listing.first_line);
    listings.iter().map(|listing| format!("{}\n", listing.code)).collect()
}
