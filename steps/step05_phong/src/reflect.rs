use glam::DVec3;

/// r, the vector `l` mirrored in the unit normal `n`: r = 2(n·l)n − l.
/// ```
/// let (n, l) = (glam::DVec3::Y, glam::DVec3::new(0.6, 0.8, 0.0));
/// assert_eq!(step05_phong::reflect(n, l), glam::DVec3::new(-0.6, 0.8, 0.0));
/// ```
pub fn reflect(n: DVec3, l: DVec3) -> DVec3 {
    2.0 * n.dot(l) * n - l
}
