use glam::DVec3;

/// r = 2(n·l)n − l, the mirror image of `l` on the other side of the unit normal
/// `n`. All three point away from the surface.
/// ```
/// let (n, l) = (glam::DVec3::Y, glam::DVec3::new(0.6, 0.8, 0.0));
/// assert_eq!(step05_phong::reflect(n, l), glam::DVec3::new(-0.6, 0.8, 0.0));
/// ```
pub fn reflect(n: DVec3, l: DVec3) -> DVec3 {
    2.0 * n.dot(l) * n - l
}
