use std::str::FromStr;

/// The shape of a picture, such as 16:9 (slide "Quick Aside about Aspect Ratios").
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AspectRatio {
    /// The first number of the ratio; above 0.
    pub width: f64,
    /// The second number of the ratio; above 0.
    pub height: f64,
}

impl AspectRatio {
    /// vRes, the number of rows that makes the pixels square, to the nearest row.
    ///
    /// None where the ratio leaves no row, or more than 16384.
    pub fn v_res(&self, h_res: u32) -> Option<u32> {
        let rows = (f64::from(h_res) * self.height / self.width).round();
        (1.0..=16384.0).contains(&rows).then_some(rows as u32)
    }
}

impl FromStr for AspectRatio {
    type Err = &'static str;

    /// Reads `W:H`, two finite numbers above 0.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let side = |text: &str| {
            text.parse().ok().filter(|&side: &f64| side.is_finite() && 0.0 < side)
        };
        text.split_once(':')
            .and_then(|(w, h)| Some(Self { width: side(w)?, height: side(h)? }))
            .ok_or("allowed are two numbers above 0 as W:H, such as 16:9 or 2.35:1")
    }
}
