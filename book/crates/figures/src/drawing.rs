//! Drawings in SVG.

use crate::View;
use crate::text_markup::{escape, symbol_spans};
use glam::DVec2;

/// A drawing in SVG, 480 wide. x points right and y points down, and a line of text is about 20
/// high.
///
/// Every element has a class, through which the theme's style sheet gives it its colours.
#[derive(Clone, Debug)]
pub struct Drawing {
    height: f64,
    body: String,
}

impl Drawing {
    /// An empty drawing, as wide as the column of text.
    pub fn new(height: f64) -> Self {
        Self { height, body: String::new() }
    }

    /// Draws a straight line.
    pub fn line(&mut self, class: &str, start: DVec2, end: DVec2) {
        self.path(class, [start, end]);
    }

    /// Draws an arrow that ends at `tip`.
    pub fn arrow(&mut self, class: &str, start: DVec2, tip: DVec2) {
        let along = (tip - start).normalize_or(DVec2::X);
        let back = tip - 9.0 * along;
        self.line(class, start, back + 2.0 * along);
        let side = 3.8 * along.perp();
        self.area(&format!("{class} head"), [tip, back + side, back - side]);
    }

    /// Draws a line through all `points`.
    pub fn path(&mut self, class: &str, points: impl IntoIterator<Item = DVec2>) {
        self.body += &format!(r#"<path class="{class}" d="{}"></path>"#, path_commands(points));
    }

    /// Draws the area whose corners are `points`.
    pub fn area(&mut self, class: &str, points: impl IntoIterator<Item = DVec2>) {
        self.body +=
            &format!(r#"<path class="{class} area" d="{}Z"></path>"#, path_commands(points));
    }

    /// Draws a circle.
    pub fn circle(&mut self, class: &str, centre: DVec2, radius: f64) {
        let DVec2 { x, y } = centre;
        let position = format!(r#"cx="{x:.2}" cy="{y:.2}" r="{radius:.2}""#);
        self.body += &format!(r#"<circle class="{class}" {position}></circle>"#);
    }

    /// Draws a small filled circle to mark a point.
    pub fn dot(&mut self, class: &str, centre: DVec2) {
        self.circle(&format!("{class} dot"), centre, 4.5);
    }

    /// Draws a pixel as a disc in its own colour.
    pub fn pixel(&mut self, centre: DVec2, radius: f64, [red, green, blue]: [u8; 3]) {
        let DVec2 { x, y } = centre;
        self.body += &format!(
            r#"<circle class="pixel" cx="{x:.2}" cy="{y:.2}" r="{radius:.1}" style="fill:rgb({red} {green} {blue})"></circle>"#
        );
    }

    /// Draws an arc around `centre` from one angle to another. Angles are in radians, anticlockwise
    /// from the x axis.
    pub fn arc(&mut self, class: &str, centre: DVec2, radius: f64, [start, end]: [f64; 2]) {
        let angle = |k: i32| start + (end - start) * f64::from(k) / 24.0;
        let view = View { origin: centre, scale: DVec2::splat(radius) };
        self.path(class, (0..=24).map(|k| view.to_drawing(DVec2::from_angle(angle(k)))));
    }

    /// Writes text centred at a position; with the class `start` it begins there, and with `end` it
    /// ends there. Symbols are between dollar signs: `$V_0$` is a V with a subscript 0.
    pub fn label(&mut self, class: &str, position: DVec2, text: &str) {
        let parts = text.split('$').zip([escape, symbol_spans].into_iter().cycle());
        let spans: String = parts.map(|(part, spans)| spans(part)).collect();
        let DVec2 { x, y } = position;
        self.body += &format!(r#"<text class="{class}" x="{x:.1}" y="{y:.1}">{spans}</text>"#);
    }

    /// The drawing's elements, to be put inside an SVG element.
    pub fn svg_elements(&self) -> &str {
        &self.body
    }

    /// The drawing as an HTML element, with a `title` for readers who can't see it.
    pub fn html(&self, title: &str) -> String {
        let Self { height, body } = self;
        let title = escape(title);
        format!(
            r#"<svg role="img" viewBox="0 0 480 {height}" width="480" height="{height}"><title>{title}</title><g>{body}</g></svg>"#
        )
    }
}

/// The commands for a path through `points`.
fn path_commands(points: impl IntoIterator<Item = DVec2>) -> String {
    let pairs = points.into_iter().map(|DVec2 { x, y }| format!("{x:.2} {y:.2}"));
    format!("M{}", pairs.collect::<Vec<_>>().join("L"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_between_dollar_signs_is_a_symbol() {
        let mut drawing = Drawing::new(100.0);
        drawing.label("quiet", DVec2::ZERO, "$t$ < 2");
        let spans = "<tspan class=\"math\">𝑡</tspan> &lt; 2";
        assert_eq!(
            drawing.svg_elements(),
            format!("<text class=\"quiet\" x=\"0.0\" y=\"0.0\">{spans}</text>")
        );
    }

    #[test]
    fn drawing_has_its_title_and_its_height() {
        let html = Drawing::new(100.0).html("a & b");
        assert!(
            html.contains("viewBox=\"0 0 480 100\"") && html.contains("<title>a &amp; b</title>")
        );
    }
}
