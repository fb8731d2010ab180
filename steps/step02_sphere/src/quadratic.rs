/// The real roots of a quadratic: the three cases that its discriminant tells apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roots {
    /// D < 0: none; the ray misses.
    None,
    /// D = 0: one; the ray touches.
    One(f64),
    /// D > 0: two, the smaller first; the ray goes in and comes out.
    Two(f64, f64),
}

/// Solves at² + bt + c = 0 for t, where a > 0, by the quadratic formula.
pub fn quadratic(a: f64, b: f64, c: f64) -> Roots {
    let d = b * b - 4.0 * a * c;
    if d < 0.0 {
        Roots::None
    } else if d == 0.0 {
        Roots::One(-b / (2.0 * a))
    } else {
        Roots::Two((-b - d.sqrt()) / (2.0 * a), (-b + d.sqrt()) / (2.0 * a))
    }
}

impl Roots {
    /// The smallest t above 0: where a ray first meets the surface.
    ///
    /// Below 0 a root lies behind the ray; 0 is the starting point, and no hit.
    pub fn first_hit(self) -> Option<f64> {
        match self {
            Roots::One(t) | Roots::Two(t, _) if 0.0 < t => Some(t),
            Roots::Two(_, t) if 0.0 < t => Some(t),
            _ => None,
        }
    }
}
