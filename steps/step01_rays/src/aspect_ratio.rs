/// The shape of a picture, such as 16:9 (slide "Quick Aside about Aspect Ratios").
#[derive(Clone, Copy, Debug)]
pub struct AspectRatio {
    /// W, the first number of the ratio; above 0.
    pub width: f64,
    /// H, the second number of the ratio; above 0.
    pub height: f64,
}

impl AspectRatio {
    /// vRes, the number of rows of a picture that has `h_res` columns and this
    /// shape: rounded, and at least 1.
    pub fn v_res(&self, h_res: u32) -> u32 {
        (f64::from(h_res) * (self.height / self.width)).round().max(1.0) as u32
    }
}
