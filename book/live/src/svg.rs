use glam::{DVec2, dvec2};
use std::fmt::Write;

/// A drawing in SVG: x runs right and y down, and a line of text is about 20 high.
///
/// Every element has a class; what it looks like, in light and in dark, is the
/// theme's business.
#[derive(Clone, Debug)]
pub struct Drawing {
    size: DVec2,
    body: String,
}

/// A map from the world, where y runs up, to a drawing.
#[derive(Clone, Copy, Debug)]
pub struct View {
    /// Where in the drawing the world's origin is.
    pub origin: DVec2,
    /// How long in the drawing one unit of each axis is.
    pub scale: DVec2,
}

impl View {
    /// The place in the drawing of a point of the world.
    pub fn at(&self, point: DVec2) -> DVec2 {
        self.xy(point.x, point.y)
    }

    /// The place of the point (x, y).
    pub fn xy(&self, x: f64, y: f64) -> DVec2 {
        self.origin + self.scale * dvec2(x, -y)
    }

    /// The point of the world at a place in the drawing.
    pub fn world(&self, place: DVec2) -> DVec2 {
        (place - self.origin) / self.scale * dvec2(1.0, -1.0)
    }
}

/// How far `place` is to the left of straight up, seen from another, in degrees.
pub fn degrees_left(from: DVec2, place: DVec2) -> f64 {
    let DVec2 { x, y } = from - place;
    x.atan2(y).to_degrees()
}

impl Drawing {
    /// An empty drawing; one 480 wide fills the column of text.
    pub fn new(width: f64, height: f64) -> Self {
        Self { size: dvec2(width, height), body: String::new() }
    }

    /// A straight line.
    pub fn line(&mut self, class: &str, from: DVec2, to: DVec2) {
        self.path(class, &[from, to]);
    }

    /// An arrow whose tip is at `to`.
    pub fn arrow(&mut self, class: &str, from: DVec2, to: DVec2) {
        let along = (to - from).normalize_or(DVec2::X);
        let back = to - 9.0 * along;
        self.line(class, from, back + 2.0 * along);
        let side = 3.8 * along.perp();
        self.area(&format!("{class} head"), &[to, back + side, back - side]);
    }

    /// A line through all `points`.
    pub fn path(&mut self, class: &str, points: &[DVec2]) {
        self.body +=
            &format!(r#"<path class="{class}" d="{}"></path>"#, steps(points));
    }

    /// The area whose corners are `points`.
    pub fn area(&mut self, class: &str, points: &[DVec2]) {
        self.body += &format!(
            r#"<path class="{class} area" d="{}Z"></path>"#,
            steps(points)
        );
    }

    /// A rectangle, from its middle to its upper right corner.
    pub fn rectangle(&mut self, class: &str, middle: DVec2, half: DVec2) {
        let flip = dvec2(half.x, -half.y);
        self.area(class, &[-half, flip, half, -flip].map(|corner| middle + corner));
    }

    /// A circle.
    pub fn circle(&mut self, class: &str, centre: DVec2, radius: f64) {
        let (x, y) = (centre.x, centre.y);
        self.body += &format!(
            r#"<circle class="{class}" cx="{x:.2}" cy="{y:.2}" r="{radius:.2}"></circle>"#
        );
    }

    /// A small filled circle, which marks a point.
    pub fn dot(&mut self, class: &str, centre: DVec2) {
        self.circle(&format!("{class} dot"), centre, 4.5);
    }

    /// A pixel as a disc in its own colour.
    pub fn pixel(
        &mut self,
        centre: DVec2,
        radius: f64,
        [red, green, blue]: [u8; 3],
    ) {
        let (x, y) = (centre.x, centre.y);
        self.body += &format!(
            r#"<circle class="pixel" cx="{x:.2}" cy="{y:.2}" r="{radius:.1}" style="fill:rgb({red} {green} {blue})"></circle>"#
        );
    }

    /// An arc about `centre` from one angle to another, in radians from the x axis,
    /// upwards.
    pub fn arc(
        &mut self,
        class: &str,
        centre: DVec2,
        radius: f64,
        [from, to]: [f64; 2],
    ) {
        let angle = |k: i32| from + (to - from) * f64::from(k) / 24.0;
        let view = View { origin: centre, scale: DVec2::splat(radius) };
        let points: Vec<_> =
            (0..=24).map(|k| view.at(DVec2::from_angle(angle(k)))).collect();
        self.path(class, &points);
    }

    /// A text with its middle at a point, with symbols between dollar signs: `$V_0$`
    /// is a V with a 0 below the line.
    pub fn label(&mut self, class: &str, middle: DVec2, text: &str) {
        self.text(class, middle, "middle", text);
    }

    /// A text that begins at a point.
    pub fn label_from(&mut self, class: &str, start: DVec2, text: &str) {
        self.text(class, start, "start", text);
    }

    /// A text that ends at a point.
    pub fn label_to(&mut self, class: &str, end: DVec2, text: &str) {
        self.text(class, end, "end", text);
    }

    fn text(&mut self, class: &str, at: DVec2, anchor: &str, text: &str) {
        let spans: String = text
            .split('$')
            .enumerate()
            .map(|(k, part)| if k % 2 == 0 { escape(part) } else { symbol(part) })
            .collect();
        let (x, y) = (at.x, at.y);
        self.body += &format!(
            r#"<text class="{class}" x="{x:.1}" y="{y:.1}" text-anchor="{anchor}">{spans}</text>"#
        );
    }

    /// Its width and height.
    pub fn size(&self) -> [f64; 2] {
        self.size.to_array()
    }

    /// Everything that was drawn, as the children of an element of SVG.
    pub fn body(&self) -> &str {
        &self.body
    }

    /// The drawing as an element of HTML, with a `title` for those who can't see
    /// it.
    pub fn html(&self, title: &str) -> String {
        let (width, height) = (self.size.x, self.size.y);
        format!(
            r#"<svg role="img" viewBox="0 0 {width} {height}" width="{width}" height="{height}"><title>{}</title><g>{}</g></svg>"#,
            escape(title),
            self.body
        )
    }
}

/// The commands of a path through `points`.
fn steps(points: &[DVec2]) -> String {
    let step = |point: &DVec2| format!("{:.2} {:.2}", point.x, point.y);
    format!("M{}", points.iter().map(step).collect::<Vec<_>>().join("L"))
}

/// A symbol in the letters of the formulas: `_` puts the next one below the line,
/// `^` above it.
fn symbol(text: &str) -> String {
    let mut spans = String::from(r#"<tspan class="math">"#);
    let mut letters = text.chars();
    while let Some(c) = letters.next() {
        let (class, shift) = match c {
            '_' => ("small", 4.0),
            '^' => ("small", -7.0),
            _ => {
                spans.push_str(&escape(&italic(c).to_string()));
                continue;
            }
        };
        let raised = letters.next().map_or(' ', italic);
        let _ = write!(
            spans,
            r#"<tspan class="{class}" dy="{shift}">{raised}</tspan><tspan dy="{}">&#8203;</tspan>"#,
            -shift
        );
    }
    spans + "</tspan>"
}

/// The italic letter of mathematics for a Latin or small Greek letter; others stay
/// as they are.
pub fn italic(c: char) -> char {
    let shifted =
        |first: char, base: u32| char::from_u32(base + (c as u32 - first as u32));
    let letter = match c {
        'h' => Some('ℎ'),
        'a'..='z' => shifted('a', 0x1D44E),
        'A'..='Z' => shifted('A', 0x1D434),
        'α'..='ω' => shifted('α', 0x1D6FC),
        '-' => Some('−'),
        _ => None,
    };
    letter.unwrap_or(c)
}

/// Escapes `text` for HTML, attributes included.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}
