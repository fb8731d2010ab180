/// The real roots of a quadratic: three cases, told apart by D = b² − 4ac.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roots {
    /// D < 0: no root; the line misses.
    Zero,
    /// D = 0: one; the line touches.
    One(f64),
    /// D > 0: two, the smaller first; the line goes in and comes out.
    Two(f64, f64),
}

/// Solves at² + bt + c = 0 for t, where a > 0, by the quadratic formula.
///
/// Where b² is much larger than 4ac, −b and √D nearly cancel in one root, and digits
/// are lost. Careful libraries compute only the other root, and divide the product of
/// the two, c/a, by it. With 64 bits, the lecture's form gives the same picture.
/// ```
/// use step02_sphere::{Roots, quadratic};
/// assert_eq!(quadratic(1.0, -10.0, 24.0), Roots::Two(4.0, 6.0));
/// ```
/// # Panics
/// Where a is not above 0, in a build with debug assertions.
pub fn quadratic(a: f64, b: f64, c: f64) -> Roots {
    debug_assert!(0.0 < a, "a is not above 0");
    let d = b * b - 4.0 * a * c;
    if d < 0.0 {
        Roots::Zero
    } else if d == 0.0 {
        Roots::One(-b / (2.0 * a))
    } else {
        Roots::Two((-b - d.sqrt()) / (2.0 * a), (-b + d.sqrt()) / (2.0 * a))
    }
}

impl Roots {
    /// The roots, one after the other, the smaller first.
    pub fn iter(self) -> impl Iterator<Item = f64> {
        let (first, second) = match self {
            Roots::Zero => (None, None),
            Roots::One(t) => (Some(t), None),
            Roots::Two(t, u) => (Some(t), Some(u)),
        };
        first.into_iter().chain(second)
    }

    /// The smallest t above 0: where a ray first meets the surface.
    /// Below 0 a root lies behind the ray; 0 is the starting point, and no hit.
    pub fn first_hit(self) -> Option<f64> {
        match self {
            Roots::One(t) | Roots::Two(t, _) if 0.0 < t => Some(t),
            Roots::Two(_, t) if 0.0 < t => Some(t),
            _ => None,
        }
    }
}
