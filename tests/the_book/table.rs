use book::{Element, Page};

/// A row of a table, with the headings of its columns.
pub struct Row<'a> {
    page: &'a Page,
    cells: Vec<(&'a str, &'a Element)>,
}

/// Every row of every table of a page, from top to bottom.
pub fn rows(page: &Page) -> Vec<Row<'_>> {
    let mut rows = vec![];
    for table in page.all("table") {
        let inside =
            |tag, outer| page.all(tag).filter(move |e| page.within(e, outer));
        let heads: Vec<_> =
            inside("th", table).map(|th| th.text.as_str()).collect();
        for tr in inside("tr", table) {
            let cells: Vec<_> =
                heads.iter().copied().zip(inside("td", tr)).collect();
            if !cells.is_empty() {
                rows.push(Row { page, cells });
            }
        }
    }
    rows
}

impl<'a> Row<'a> {
    /// Where it is, for the sentence about a fault.
    pub fn at(&self) -> String {
        self.cells.first().map_or(String::new(), |(_, cell)| self.page.at(cell))
    }

    /// The cell in the column of this heading.
    fn cell(&self, head: &str) -> Option<&'a Element> {
        self.cells.iter().find(|(known, _)| *known == head).map(|(_, cell)| *cell)
    }

    /// The text in the column of this heading, if there is such a column.
    pub fn text(&self, head: &str) -> Option<&'a str> {
        self.cell(head).map(|cell| cell.text.trim())
    }

    /// What stands as code in the column of this heading.
    pub fn codes(&self, head: &str) -> Vec<&'a str> {
        let Some(cell) = self.cell(head) else { return vec![] };
        let codes =
            self.page.all("code").filter(|code| self.page.within(code, cell));
        codes.map(|code| code.text.as_str()).collect()
    }
}

#[test]
fn a_row_has_its_cells_by_their_headings() {
    let page = Page::new(
        "a.html",
        "<table><tr><th>A</th><th>B</th></tr>\n<tr><td>x</td><td><code>y</code>, z</td></tr></table>",
    );
    let [row] = &rows(&page)[..] else { panic!("not one row") };
    assert_eq!(row.at(), "line 2 of a.html");
    assert_eq!((row.text("A"), row.text("C")), (Some("x"), None));
    assert_eq!((row.text("B"), row.codes("B")), (Some("y, z"), vec!["y"]));
}
