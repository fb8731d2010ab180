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
        (f64::from(h_res) * (self.height / self.width)).round().max(1.0) as u32
    }
}

impl FromStr for AspectRatio {
    type Err = &'static str;
    /// Reads W:H; a picture may be up to four times as high as wide.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let refusal = "allowed is W:H, two numbers above 0, down to 1:4";
        let (w, h) = text.split_once(':').ok_or(refusal)?;
        let width = w.parse().or(Err(refusal))?;
        let height = h.parse().or(Err(refusal))?;
        let is_allowed = 0.0 < height && 0.25 <= width / height;
        if is_allowed { Ok(Self { width, height }) } else { Err(refusal) }
    }
}
