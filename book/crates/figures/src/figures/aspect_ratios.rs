use crate::aspect_ratio::ASPECT_RATIOS;
use crate::{Drawing, Interactive, Output};
use glam::dvec2;
use std::iter::zip;

/// The lecture's four aspect ratios at one width.
pub struct AspectRatios;

impl Interactive for AspectRatios {
    const NAME: &str = "aspect-ratios";
    const TITLE: &str = "Four rectangles of one width: 4:3 standard video, 16:9 widescreen video, 2.35:1 many movies, 2.59:1 Cinerama; each is less tall than the one before.";
    const CAPTION: &str = "Four aspect ratios at the same width, each with the rows that go with 640 columns of square \
                  pixels. The wider the format, the fewer the rows.";

    fn from_values(_: &[f64]) -> Self {
        Self
    }

    fn draw(&self) -> Output {
        let mut drawing = Drawing::new(480.0, 300.0);
        let names = ["standard video", "widescreen video", "many movies", "Cinerama"];
        let feet = [(120.0, 146.0), (360.0, 146.0), (120.0, 270.0), (360.0, 270.0)];
        for (ratio, (name, (x, bottom))) in zip(ASPECT_RATIOS, zip(names, feet)) {
            let rows = f64::from(ratio.v_res(640));
            let half = dvec2(95.0, 95.0 * rows / 640.0);
            let middle = dvec2(x, bottom - half.y);
            drawing.rectangle("screen", middle, half);
            drawing.label("strong", middle, &format!("{}:{}", ratio.width, ratio.height));
            drawing.label("quiet small", middle + dvec2(0.0, 20.0), &format!("640 × {rows}"));
            drawing.label("quiet", middle + dvec2(0.0, half.y + 20.0), name);
        }
        Output::Drawing(drawing)
    }
}
