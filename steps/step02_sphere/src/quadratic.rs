/// The real roots of a quadratic equation: three cases, told apart by D = b² − 4ac.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Roots {
    /// D < 0: no root. The line misses.
    Zero,
    /// D = 0: one root. The line touches.
    One(f64),
    /// D > 0: two roots, the smaller first. The line goes in and comes out.
    Two(f64, f64),
}

/// Solves at² + bt + c = 0 for t, where a > 0, by the quadratic formula.
///
/// This is the plain formula of the lecture. If b² is much larger than 4ac, one root
/// is the difference of nearly equal numbers and loses digits. Careful libraries get
/// it from the other root, since the product of the two is c/a. With 64 bits, that
/// doesn't change any picture of this course.
/// ```
/// use step02_sphere::{Roots, quadratic};
/// assert_eq!(quadratic(1.0, -10.0, 24.0), Roots::Two(4.0, 6.0));
/// ```
/// # Panics
/// If a is not above 0, in a build with debug assertions.
pub fn quadratic(a: f64, b: f64, c: f64) -> Roots {
    debug_assert!(a > 0.0, "a is not above 0");
    let d = b * b - 4.0 * a * c;
    if d < 0.0 {
        Roots::Zero
    } else if d == 0.0 {
        Roots::One(-b / (2.0 * a))
    } else {
        Roots::Two((-b - d.sqrt()) / (2.0 * a), (-b + d.sqrt()) / (2.0 * a))
    }
}

impl IntoIterator for Roots {
    type Item = f64;
    // What `into_iter` returns below: an `array::IntoIter` over two `Option`s, and
    // around it a `Flatten`, which leaves out each `None`.
    type IntoIter = std::iter::Flatten<std::array::IntoIter<Option<f64>, 2>>;

    /// Iterates over the roots, the smaller first.
    fn into_iter(self) -> Self::IntoIter {
        let up_to_two = match self {
            Roots::Zero => [None, None],
            Roots::One(t) => [Some(t), None],
            Roots::Two(t, u) => [Some(t), Some(u)],
        };
        up_to_two.into_iter().flatten() // leaves out each None
    }
}

impl Roots {
    /// The smallest root above 0: the t at which a ray first meets the surface. A
    /// root below 0 is behind the start of the ray. A root of 0 is the start
    /// itself, and doesn't count as a hit.
    pub fn first_hit(self) -> Option<f64> {
        self.into_iter().find(|&t| t > 0.0)
    }
}
