use glam::DVec3;

/// r, the unit vector `l` mirrored in the unit normal `n`: r = 2(n·l)n − l.
pub fn reflect(n: DVec3, l: DVec3) -> DVec3 {
    2.0 * n.dot(l) * n - l
}
