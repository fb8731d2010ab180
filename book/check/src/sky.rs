use glam::{DMat3, DVec3};
use image::RgbImage;
use std::fmt::Write;
use step01_rays::Camera;

/// What the sky of a picture tells of the camera that drew it: the x and y of D_u, D_v and
/// V_0. Their z leaves no trace in it.
pub(crate) struct Sky {
    /// x of D_u, D_v and V_0.
    pub x: DVec3,
    /// y of the same.
    pub y: DVec3,
}

/// How far off a byte the sky may be where it is that of the right camera.
const ENOUGH: f64 = 0.02;

impl Sky {
    /// Reads it: the planes that fit red and green best, as red = 0.7 + 0.3 V_x and green
    /// = 0.7 + 0.3 V_y. None where too little of the picture is such a sky.
    pub fn read(yours: &RgbImage) -> Option<Self> {
        let mut counts = [0; 256];
        yours.pixels().for_each(|pixel| counts[usize::from(pixel[2])] += 1);
        let (blue, count) = (0..256).zip(counts).max_by_key(|(_, count)| *count)?;
        if count * 20 < yours.pixels().len() {
            return None;
        }
        let sky = |channel: usize| {
            let pixels = yours.enumerate_pixels();
            let its = pixels.filter(move |(.., p)| {
                i32::from(p[2]) == blue && 0 < p[channel] && p[channel] < 255
            });
            its.map(move |(i, j, pixel)| {
                let v = (f64::from(pixel[channel]) / 255.0 - 0.7) / 0.3;
                (DVec3::new(i.into(), j.into(), 1.0), v)
            })
        };
        Some(Self {
            x: plane(&sky(0).collect::<Vec<_>>())?,
            y: plane(&sky(1).collect::<Vec<_>>())?,
        })
    }

    /// The right one.
    pub fn of(camera: &Camera) -> Self {
        let rows = camera.matrix.transpose();
        Self { x: rows.x_axis, y: rows.y_axis }
    }

    /// Whether no byte of the picture would be another with the other camera.
    pub fn is_like(&self, other: &Self, (columns, rows): (u32, u32)) -> bool {
        let corners = [(0, 0), (columns, 0), (0, rows), (columns, rows)];
        corners.into_iter().all(|(i, j)| {
            let corner = DVec3::new(i.into(), j.into(), 1.0);
            let apart = |a: DVec3, b: DVec3| (a - b).dot(corner).abs() * 76.5;
            apart(self.x, other.x).max(apart(self.y, other.y)) < ENOUGH
        })
    }

    /// Says which of D_u, D_v and V_0 are others than in `ours`.
    pub fn differences(&self, ours: &Self, (columns, rows): (u32, u32)) -> String {
        let mut text = String::new();
        let parts = [("D_u", columns), ("D_v", rows), ("V_0", 1)];
        for (k, (name, count)) in parts.into_iter().enumerate() {
            let [yours, right] = [self, ours].map(|sky| (sky.x[k], sky.y[k]));
            let apart = (yours.0 - right.0).abs().max((yours.1 - right.1).abs());
            if ENOUGH < apart * f64::from(count) * 76.5 {
                let [yours, right] = [yours, right]
                    .map(|(x, y)| format!("({}, {})", short(x), short(y)));
                let _ = writeln!(
                    text,
                    "x and y of {name} are about {yours} in your picture; they should \
                     be {right}."
                );
            }
        }
        text
    }
}

/// A number with four digits that tell.
pub(crate) fn short(number: f64) -> String {
    let number = if number.abs() < 1e-6 { 0.0 } else { number };
    let digits = if number.abs() < 0.1 { 6 } else { 4 };
    let text = format!("{number:.digits$}").replace('-', "−");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The plane a·i + b·j + c that goes through most of the points, by least squares over
/// those that are not off by more than a byte; None where these are few.
fn plane(points: &[(DVec3, f64)]) -> Option<DVec3> {
    let mut plane: Option<DVec3> = None;
    for limit in [f64::INFINITY, 0.1, 0.03, 0.0075, 0.0075] {
        let (mut matrix, mut right, mut count) = (DMat3::ZERO, DVec3::ZERO, 0);
        for (at, v) in points {
            if plane.is_none_or(|plane| (plane.dot(*at) - v).abs() < limit) {
                matrix += DMat3::from_cols(*at * at.x, *at * at.y, *at * at.z);
                right += *at * *v;
                count += 1;
            }
        }
        if count * 10 < points.len() * 9 && limit < 0.01 || count < 100 {
            return None;
        }
        let inverse = matrix.inverse();
        plane = inverse.is_finite().then(|| inverse * right);
    }
    plane
}
