//! Prints the directions of a row of rays in a flat world.

use glam::{DMat2, DVec2};

/// A row of rays from the origin, looking along +y (slide "Generating Rays in 2D").
#[derive(Debug)]
pub struct Row {
    /// [D V_0]: the step from one direction to the next, and the first direction.
    pub matrix: DMat2,
}

impl Row {
    /// A row of `h_res` rays. The angle between the outermost two is
    /// `field_of_view`, θ, in radians.
    pub fn new(h_res: u32, field_of_view: f64) -> Self {
        let tan = (field_of_view / 2.0).tan();
        let d = DVec2::new(2.0 * tan / f64::from(h_res - 1), 0.0);
        let v_0 = DVec2::new(-tan, 1.0);
        Self { matrix: DMat2::from_cols(d, v_0) }
    }

    /// The direction V_i = [D V_0] (i, 1)ᵀ; i runs from 0 to hRes − 1.
    pub fn direction(&self, i: f64) -> DVec2 {
        self.matrix * DVec2::new(i, 1.0)
    }
}

fn main() {
    let row = Row::new(7, 60_f64.to_radians());
    for i in 0..7 {
        println!("V_{i} = {:.4}", row.direction(f64::from(i)));
    }
}
