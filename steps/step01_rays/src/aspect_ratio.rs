/// The shape of a picture, such as 16:9 (slide "Quick Aside about Aspect Ratios").
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AspectRatio {
    /// W, the first number of the ratio; above 0.
    pub width: f64,
    /// H, the second number of the ratio; above 0.
    pub height: f64,
}

impl AspectRatio {
    /// vRes, the number of rows that makes the pixels square, to the nearest row.
    ///
    /// An error is a sentence: the ratio leaves no row, or more than 16384.
    pub fn v_res(&self, h_res: u32) -> Result<u32, String> {
        let Self { width, height } = self;
        let rows = (f64::from(h_res) * height / width).round();
        let is_allowed = (1.0..=16384.0).contains(&rows);
        is_allowed.then_some(rows as u32).ok_or(format!(
            "{width}:{height} gives {h_res} columns {rows} rows; allowed are 1 to 16384"
        ))
    }
}
