//! Drawings in SVG.

use crate::label_box::LabelBox;
use crate::text_markup::symbol_tspans;
use crate::{Shading, View};
use course::escape_html;
use glam::{DVec2, dvec2};
use std::collections::BTreeMap;
use std::mem;

/// The width of every drawing.
pub const WIDTH: f64 = 480.0;

/// A drawing in SVG, 480 units wide. The x axis points right, and the y axis points down. A line of
/// text is about 20 units high.
///
/// Balls and pixels set their own colours. All other elements get their colours from the theme's
/// style sheet, which selects them by class. Labels are on top of everything else.
#[derive(Clone, Debug)]
pub struct Drawing {
    height: f64,
    /// The gradients that fill the balls, keyed by id.
    gradients: BTreeMap<&'static str, String>,
    shapes: String,
    labels: Vec<Label>,
    /// The positions of the handles that lie on top of the drawing.
    handles: Vec<DVec2>,
}

/// A text in a drawing.
#[derive(Clone, Debug)]
struct Label {
    class: String,
    position: DVec2,
    text: String,
}

impl Drawing {
    /// An empty drawing of the given height.
    pub fn new(height: f64) -> Self {
        Self {
            height,
            gradients: BTreeMap::new(),
            shapes: String::new(),
            labels: vec![],
            handles: vec![],
        }
    }

    /// Draws a straight line.
    pub fn line(&mut self, class: &str, start: DVec2, end: DVec2) {
        self.path(class, [start, end]);
    }

    /// Draws an arrow from `start` to `tip`.
    pub fn arrow(&mut self, class: &str, start: DVec2, tip: DVec2) {
        let arrow_direction = (tip - start).normalize_or(DVec2::X);
        let back = tip - 9.0 * arrow_direction;
        self.line(class, start, back + 2.0 * arrow_direction);
        let side = 3.8 * arrow_direction.perp();
        self.area(&format!("{class} head"), [tip, back + side, back - side]);
    }

    /// Draws a polyline through `points`.
    pub fn path(&mut self, class: &str, points: impl IntoIterator<Item = DVec2>) {
        self.shapes += &format!(r#"<path class="{class}" d="{}"></path>"#, path_commands(points));
    }

    /// Draws a filled polygon whose corners are `points`.
    pub fn area(&mut self, class: &str, points: impl IntoIterator<Item = DVec2>) {
        self.shapes +=
            &format!(r#"<path class="{class} area" d="{}Z"></path>"#, path_commands(points));
    }

    /// Draws a circle.
    pub fn circle(&mut self, class: &str, centre: DVec2, radius: f64) {
        let DVec2 { x, y } = centre;
        let position = format!(r#"cx="{x:.2}" cy="{y:.2}" r="{radius:.2}""#);
        self.shapes += &format!(r#"<circle class="{class}" {position}></circle>"#);
    }

    /// Draws a small filled circle to mark a point.
    pub fn dot(&mut self, class: &str, centre: DVec2) {
        self.circle(&format!("{class} dot"), centre, 4.5);
    }

    /// Draws the projection of a shaded ball: an ellipse with these half axes.
    pub fn ball(&mut self, shading: &Shading, centre: DVec2, half_axes: DVec2) {
        self.gradients.entry(shading.id).or_insert_with(|| shading.svg());
        let (id, DVec2 { x, y }) = (shading.id, centre);
        let size = format!(r#"rx="{:.2}" ry="{:.2}""#, half_axes.x, half_axes.y);
        self.shapes += &format!(
            r#"<ellipse cx="{x:.2}" cy="{y:.2}" {size} style="fill:url(#{id})"></ellipse>"#
        );
    }

    /// Draws a disc in a given colour, such as that of a pixel.
    pub fn coloured_disc(&mut self, centre: DVec2, radius: f64, [red, green, blue]: [u8; 3]) {
        let DVec2 { x, y } = centre;
        self.shapes += &format!(
            r#"<circle class="pixel" cx="{x:.2}" cy="{y:.2}" r="{radius:.1}" style="fill:rgb({red} {green} {blue})"></circle>"#
        );
    }

    /// Draws an arc around `centre` from one angle to another. Angles are in radians, and are
    /// measured anticlockwise from the x axis.
    pub fn arc(&mut self, class: &str, centre: DVec2, radius: f64, [start, end]: [f64; 2]) {
        let angle = |k: i32| start + (end - start) * f64::from(k) / 24.0;
        let view = View { origin: centre, scale: DVec2::splat(radius) };
        self.path(class, (0..=24).map(|k| view.to_drawing(DVec2::from_angle(angle(k)))));
    }

    /// Writes text that is centred at `position`. With the class `start`, the text begins at
    /// `position`. With the class `end`, the text ends at `position`. Symbols are between dollar
    /// signs: `$V_0$` is a V with a subscript 0.
    ///
    /// Text that would be cut off at the border or overlap an earlier label is moved to a free
    /// position nearby.
    pub fn label(&mut self, class: &str, position: DVec2, text: &str) {
        let position = self.free_position_nearby(class, position, text);
        self.labels.push(Label { class: class.into(), position, text: text.into() });
    }

    /// Moves labels away from handles, to free positions nearby. `handles` contains the positions
    /// of the handles.
    pub fn with_labels_clear_of_handles(mut self, handles: Vec<DVec2>) -> Self {
        self.handles = handles;
        for Label { class, position, text } in mem::take(&mut self.labels) {
            self.label(&class, position, &text);
        }
        self
    }

    /// Finds a position near `position` at which a label is inside the drawing, overlaps no earlier
    /// label and isn't covered by a handle. If there is no such position, returns the nearest
    /// position at which the label is inside the drawing.
    fn free_position_nearby(&self, class: &str, position: DVec2, text: &str) -> DVec2 {
        let box_at = |position| LabelBox::new(class, position, text);
        let position_inside = position + box_at(position).shift_into(dvec2(WIDTH, self.height));
        let earlier_boxes: Vec<LabelBox> =
            self.label_boxes().map(|(_, label_box)| label_box).collect();
        let is_free = |position: &DVec2| {
            let label_box = box_at(*position);
            let is_inside = label_box.shift_into(dvec2(WIDTH, self.height)) == DVec2::ZERO;
            is_inside
                && !earlier_boxes.iter().any(|earlier_box| label_box.overlaps(earlier_box))
                && !self.handles.iter().any(|&handle| label_box.is_covered_by_handle(handle))
        };
        let distances = (0..=15).map(|k| 4.0 * f64::from(k));
        let mut candidates =
            distances.flat_map(|distance| DIRECTIONS.map(|d| position_inside + distance * d));
        candidates.find(is_free).unwrap_or(position_inside)
    }

    /// The text of each label, and the box that the label fills.
    pub fn label_boxes(&self) -> impl Iterator<Item = (&str, LabelBox)> {
        let labels = self.labels.iter();
        labels
            .map(|Label { class, position, text }| (&**text, LabelBox::new(class, *position, text)))
    }

    /// The height of the drawing.
    pub fn height(&self) -> f64 {
        self.height
    }

    /// The elements of the drawing, to be put inside an `<svg>` element.
    pub fn svg_elements(&self) -> String {
        let labels = self.labels.iter().map(Label::svg);
        let gradients = self.gradients.values().map(String::as_str);
        gradients.chain([&*self.shapes]).map(str::to_owned).chain(labels).collect()
    }

    /// The drawing as an `<svg>` element for an HTML page. The element has a title for readers who
    /// can't see the drawing.
    pub fn html(&self, title: &str) -> String {
        let (height, elements, title) = (self.height, self.svg_elements(), escape_html(title));
        format!(
            r#"<svg role="img" viewBox="0 0 480 {height}" width="480" height="{height}"><title>{title}</title><g>{elements}</g></svg>"#
        )
    }
}

/// The directions in which a label may be moved to a free position, in order of preference.
const DIRECTIONS: [DVec2; 8] = [
    dvec2(0.0, -1.0),
    dvec2(1.0, 0.0),
    dvec2(-1.0, 0.0),
    dvec2(0.0, 1.0),
    dvec2(1.0, -1.0),
    dvec2(-1.0, -1.0),
    dvec2(1.0, 1.0),
    dvec2(-1.0, 1.0),
];

impl Label {
    fn svg(&self) -> String {
        let Self { class, position: DVec2 { x, y }, text } = self;
        let parts = text.split('$').zip([escape_html, symbol_tspans].into_iter().cycle());
        let spans: String = parts.map(|(part, spans)| spans(part)).collect();
        format!(r#"<text class="{class}" x="{x:.1}" y="{y:.1}">{spans}</text>"#)
    }
}

/// The commands of an SVG path through `points`. A point is left out if its rounded coordinates are
/// the same as those of the previous point.
fn path_commands(points: impl IntoIterator<Item = DVec2>) -> String {
    let pairs = points.into_iter().map(|DVec2 { x, y }| format!("{x:.2} {y:.2}"));
    let mut pairs: Vec<_> = pairs.collect();
    pairs.dedup();
    format!("M{}", pairs.join("L"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_between_dollar_signs_is_a_symbol() {
        let mut drawing = Drawing::new(100.0);
        drawing.label("quiet", DVec2::splat(50.0), "$t$ < 2");
        let spans = "<tspan class=\"math\">𝑡</tspan> &lt; 2";
        assert_eq!(
            drawing.svg_elements(),
            format!("<text class=\"quiet\" x=\"50.0\" y=\"50.0\">{spans}</text>")
        );
    }

    #[test]
    fn path_leaves_out_points_that_round_to_the_previous_point() {
        let points = [(1.0, 2.0), (1.001, 2.0), (3.0, 2.0), (1.0, 2.0)].map(DVec2::from);
        assert_eq!(path_commands(points), "M1.00 2.00L3.00 2.00L1.00 2.00");
    }

    #[test]
    fn drawing_has_its_title_and_its_height() {
        let html = Drawing::new(100.0).html("a & b");
        assert!(
            html.contains("viewBox=\"0 0 480 100\"") && html.contains("<title>a &amp; b</title>")
        );
    }

    #[test]
    fn label_gives_way_to_the_border_and_to_earlier_labels() {
        let mut drawing = Drawing::new(100.0);
        for position in [DVec2::ZERO, DVec2::ZERO, dvec2(480.0, 100.0)] {
            drawing.label("", position, "label");
        }
        let boxes: Vec<LabelBox> = drawing.label_boxes().map(|(_, label_box)| label_box).collect();
        for (k, label_box) in boxes.iter().enumerate() {
            assert_eq!(label_box.shift_into(dvec2(WIDTH, 100.0)), DVec2::ZERO);
            assert!(!boxes[..k].iter().any(|earlier_box| label_box.overlaps(earlier_box)));
        }
    }
}
