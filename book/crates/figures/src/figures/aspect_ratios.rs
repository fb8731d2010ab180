use crate::{Drawing, Interactive, Output};
use glam::dvec2;
use step01_rays::AspectRatio;

/// The lecture's four aspect ratios at one width.
pub struct AspectRatios;

impl Interactive for AspectRatios {
    const NAME: &str = "aspect-ratios";
    const TITLE: &str = "Four rectangles of one width: 4:3 standard video, 16:9 widescreen video, 2.35:1 many movies, 2.59:1 Cinerama; each is less tall than the one before.";
    const CAPTION: &str = "Four aspect ratios at the same width, and the rows that 640 columns of square pixels \
                  get in each. The wider the format, the fewer the rows.";

    fn from_values(_: &[f64]) -> Self {
        Self
    }

    fn draw(&self) -> Output {
        let mut drawing = Drawing::new(480.0, 300.0);
        let formats = [
            (4.0, 3.0, "standard video"),
            (16.0, 9.0, "widescreen video"),
            (2.35, 1.0, "many movies"),
            (2.59, 1.0, "Cinerama"),
        ];
        for (k, (w, h, name)) in formats.into_iter().enumerate() {
            let aspect_ratio = AspectRatio { width: w, height: h };
            let rows = f64::from(aspect_ratio.v_res(640));
            let (width, height) = (190.0, 190.0 * rows / 640.0);
            let (column, line) = (f64::from(k as u32 % 2), f64::from(k as u32 / 2));
            let bottom = 146.0 + 124.0 * line;
            let middle = dvec2(120.0 + 240.0 * column, bottom - height / 2.0);
            let half = dvec2(width, height) / 2.0;
            drawing.rectangle("screen", middle, half);
            drawing.label("strong", middle, &format!("{w}:{h}"));
            let size = format!("640 × {rows}");
            drawing.label("quiet small", middle + dvec2(0.0, 20.0), &size);
            drawing.label("quiet", middle + dvec2(0.0, half.y + 20.0), name);
        }
        drawing.into()
    }
}
