/// The address of everything that a style fetches: what is in `url(…)` or in an
/// `@import`.
pub fn urls(css: &str) -> Vec<&str> {
    let quotes = ['"', '\''];
    let inside =
        css.split("url(").skip(1).filter_map(|rest| rest.split(')').next());
    let imports = css.split("@import").skip(1);
    let imports = imports.filter_map(|rest| rest.split(quotes).nth(1));
    inside.chain(imports).map(|url| url.trim().trim_matches(quotes)).collect()
}

#[test]
fn addresses_are_found_with_and_without_quotes() {
    let css = "@import 'a.css'; b { src: url(c.woff2), url( \"d.woff2\" ) }";
    let mut urls = urls(css);
    urls.sort();
    assert_eq!(urls, ["a.css", "c.woff2", "d.woff2"]);
}
