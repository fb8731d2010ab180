//! What a chapter works out by hand, the step's tests by hand hold.

use super::built::BOOK;
use super::source::SOURCE;
use super::typist::STEPS;
use super::{assert_found, assert_none};
use book::{Files, Page, Site};
use std::collections::BTreeMap;
use syn::punctuated::Punctuated;
use syn::visit_mut::{self, VisitMut};
use syn::{
    BinOp, Expr, ExprBinary, ExprUnary, Item, ItemFn, LitFloat, Local, Macro,
    Token, UnOp,
};

/// Each name that stands in a chapter but not in the tests, or the other way round,
/// and each number in a test that its chapter does not have there.
fn faults(book: &Site, source: &Files) -> Vec<String> {
    STEPS.iter().flat_map(|step| faults_of(step, book, source)).collect()
}

fn faults_of(step: &str, book: &Site, source: &Files) -> Vec<String> {
    let path = format!("steps/{step}/tests/by_hand.rs");
    let tests = source.text(&path).map(tests).unwrap_or_default();
    let page = &book.pages[&format!("{step}.html")];
    let mut labels = labels(page);
    let mut faults = vec![];
    for mut test in tests {
        let name = test.sig.ident.to_string();
        let Some(text) = labels.remove(name.as_str()) else {
            faults.push(format!("{} does not name the test {name}.", page.name));
            continue;
        };
        let shown = shown(text);
        let mut asserted = Asserted::default();
        asserted.visit_block_mut(&mut test.block);
        let wrong = asserted.0.iter().filter(|number| !shown.contains(number));
        faults.extend(wrong.map(|number| {
            let page = &page.name;
            format!("{page} has no {number} above {name}, which asserts it.")
        }));
    }
    let lost = labels.keys().map(|name| format!("{path} has no test {name}."));
    faults.extend(lost);
    faults
}

/// Every test in a Rust file.
fn tests(text: &str) -> Vec<ItemFn> {
    let file = syn::parse_file(text).expect("the file is Rust");
    let tests = file.items.into_iter().filter_map(|item| match item {
        Item::Fn(test) if !test.attrs.is_empty() => Some(test),
        _ => None,
    });
    tests.collect()
}

/// Each test that a page names, and the text from the heading or the name before.
fn labels(page: &Page) -> BTreeMap<&str, &str> {
    let mut labels = BTreeMap::new();
    let mut from = 0;
    for element in &page.elements {
        if element.is("p", "by-hand") {
            let name = element.get("id").and_then(|id| id.strip_prefix("by-hand-"));
            let text = &page.text[from..element.place.start];
            labels.insert(name.unwrap_or_default(), text);
            from = element.place.end;
        } else if ["h1", "h2", "h3", "h4"].contains(&element.tag.as_str()) {
            from = element.place.end;
        }
    }
    labels
}

/// The numbers in a text: each without its sign, and with it.
fn shown(text: &str) -> Vec<f64> {
    let text = text.replace(['-', '−'], " - ");
    let text =
        text.replace(|c: char| !c.is_ascii_digit() && !"-.,".contains(c), " ");
    let mut numbers = vec![];
    let mut sign = 1.0;
    for word in text.split_whitespace() {
        let digits = word.replace(',', "");
        if let Ok(number) = digits.trim_matches('.').parse::<f64>() {
            numbers.extend([number, sign * number]);
        }
        sign = if word == "-" { -1.0 } else { 1.0 };
    }
    numbers
}

/// The numbers with a point in a test: those in a `let` are given, those in a product
/// are the formula's, and 5e-5 is a tolerance.
#[derive(Default)]
struct Asserted(Vec<f64>);

impl VisitMut for Asserted {
    fn visit_local_mut(&mut self, _: &mut Local) {}

    fn visit_expr_binary_mut(&mut self, binary: &mut ExprBinary) {
        if !matches!(binary.op, BinOp::Mul(_)) {
            visit_mut::visit_expr_binary_mut(self, binary);
        }
    }

    fn visit_macro_mut(&mut self, assertion: &mut Macro) {
        let arguments = Punctuated::<Expr, Token![,]>::parse_terminated;
        let arguments = assertion.parse_body_with(arguments);
        let arguments = arguments.into_iter().flatten();
        arguments.for_each(|mut argument| self.visit_expr_mut(&mut argument));
    }

    fn visit_expr_unary_mut(&mut self, unary: &mut ExprUnary) {
        let before = self.0.len();
        visit_mut::visit_expr_unary_mut(self, unary);
        if let (UnOp::Neg(_), Expr::Lit(_)) = (&unary.op, &*unary.expr) {
            self.0[before..].iter_mut().for_each(|number| *number = -*number);
        }
    }

    fn visit_lit_float_mut(&mut self, number: &mut LitFloat) {
        if !number.to_string().contains('e') {
            self.0.extend(number.base10_parse::<f64>());
        }
    }
}

const TESTS: &str = "steps/step02_sphere/tests/by_hand.rs";

/// A book and its source with one test by hand more.
fn with_test(text: &str, asserted: &str) -> (Site, Files) {
    let label = "<p class=\"by-hand\" id=\"by-hand-one_more\">Test</p>";
    let html = format!("<h2>A</h2><p>{text}</p>{label}</main>");
    let book = BOOK.with("step02_sphere.html", "</main>", &html);
    let mut source = SOURCE.clone();
    let test = format!("#[test]\nfn one_more() {{ assert_eq!({asserted}); }}");
    source.0.entry(TESTS.to_string()).or_default().extend(test.into_bytes());
    (book, source)
}

#[test]
fn every_number_by_hand_is_tested() {
    assert_none(&faults(&BOOK, &SOURCE));
    let text = "12,967 + <i>a</i>/2 <mo>−</mo><mn>0.5</mn>, (3, 4.50, −1)";
    let asserted = "f(-0.5, 2.0), (12967.0, [3.0, 4.5, -1.0], 2.0 - 0.5, 5e-5)";
    let (book, source) = with_test(text, asserted);
    assert_none(&faults(&book, &source));
}

#[test]
fn a_name_without_its_test_or_its_place_is_found() {
    let (book, source) = with_test("1", "x, 1.0");
    assert_found(&faults(&book, &SOURCE), &[TESTS, "no test one_more"]);
    let words = ["step02_sphere.html", "does not name the test one_more"];
    assert_found(&faults(&BOOK, &source), &words);
}

#[test]
fn another_number_is_found() {
    for (text, asserted) in
        [("4.58", "x, 4.582"), ("24", "x, -24.0"), ("7", "8.0, x")]
    {
        let (book, source) = with_test(text, asserted);
        let words = ["step02_sphere.html has no ", "above one_more"];
        assert_found(&faults(&book, &source), &words);
    }
    let (book, source) = with_test("7</p><h3>B</h3><p>", "x, 7.0");
    assert_found(&faults(&book, &source), &["has no 7 above one_more"]);
}
