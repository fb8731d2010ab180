use std::str::FromStr;

/// The shape of a picture, such as 16:9 (slide "Quick Aside about Aspect Ratios").
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AspectRatio {
    /// W, the first number of the ratio; above 0.
    pub width: f64,
    /// H, the second number of the ratio; above 0.
    pub height: f64,
}

impl AspectRatio {
    /// vRes, the rows that make the pixels square: to the nearest row, and at least 1.
    pub fn v_res(&self, h_res: u32) -> u32 {
        (f64::from(h_res) * self.height / self.width).round().max(1.0) as u32
    }
}

impl FromStr for AspectRatio {
    type Err = &'static str;
    /// Reads W:H; a picture may be up to four times as high as wide.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text.split_once(':').map(|(w, h)| (w.parse(), h.parse())) {
            Some((Ok(w), Ok(h))) if 0.0 < h && w < 1e9 && 0.25 <= w / h => {
                Ok(Self { width: w, height: h })
            }
            _ => Err("allowed is W:H, two numbers above 0, down to 1:4"),
        }
    }
}
