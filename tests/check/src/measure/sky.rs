use super::Least;
use crate::view::scattered;
use glam::{DMat3, DVec3};
use image::RgbImage;

/// What the sky of a picture shows: the directions of its rays.
///
/// Its red is 0.7 + 0.3 V_x and its green 0.7 + 0.3 V_y, and both parts of V grow evenly
/// with i and j; so three numbers each tell them. Its blue is that of V_z.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sky {
    /// [D_u D_v V_0], as the sky tells them.
    pub matrix: DMat3,
    /// How far off each of these three may be, in x and in y.
    pub errors: [f64; 3],
}

/// A place and the V that its colour stands for.
type Sight = (DVec3, DVec3);

/// How far a part of V may be off by the rounding of its byte, and a little more.
const NEAR: f64 = 0.0075;

impl Sky {
    /// The plane on which most places lie, or None where there is no such.
    pub fn of(yours: &RgbImage) -> Option<Self> {
        let points = points(yours);
        let few: Vec<_> = points.iter().step_by(points.len() / 1500 + 1).collect();
        let is_on =
            |matrix: &DMat3, (place, v): &Sight| is_near(*matrix * *place, *v);
        let count = |matrix: &DMat3| {
            few.iter().filter(|point| is_on(matrix, point)).count()
        };
        let planes = triples(yours);
        let best = planes.map(|plane| (count(&plane), plane));
        let (count, mut matrix) = best.max_by_key(|(count, _)| *count)?;
        if count * 100 < few.len() || count < 6 {
            return None;
        }
        let mut errors = [0.0; 3];
        for wide in [3.0, 2.0, 1.5, 1.2, 1.0, 1.0, 1.0, 1.0] {
            let is_on = |(place, v): &&Sight| {
                (matrix * *place - *v).abs().max_element() < wide * NEAR
            };
            let on: Vec<_> = points.iter().filter(is_on).collect();
            (matrix, errors) = plane(&on)?;
        }
        widen(&mut errors, &matrix, yours.dimensions());
        let is_deep =
            points.iter().any(|point| is_on(&matrix, point) && is_deep(point));
        let scale = DVec3::new(1.0, 1.0, if is_deep { 1.0 } else { 0.0 });
        matrix = DMat3::from_diagonal(scale) * matrix;
        if !is_deep {
            matrix.z_axis.z = -1.0;
        }
        Some(Self { matrix, errors })
    }

    /// Whether no pixel is told from another one.
    pub fn is_even(&self) -> bool {
        let [i, j, _] = self.errors;
        let is_still =
            |step: DVec3, error: f64| step.abs().max_element() < 5.0 * error;
        is_still(self.matrix.x_axis, i) && is_still(self.matrix.y_axis, j)
    }

    /// How far a pixel is from the sky that these rays give, in parts of V that one byte
    /// may be off; None where it tells nothing.
    pub fn off(&self, yours: &RgbImage, (i, j): (u32, u32)) -> Option<f64> {
        let (place, v) = point(yours, i, j)?;
        Some((self.matrix * place - v).abs().truncate().max_element() / NEAR)
    }
}

/// A part of V that hardly changes is known to one byte only.
fn widen(errors: &mut [f64; 3], matrix: &DMat3, (width, height): (u32, u32)) {
    let [width, height] = [width, height].map(f64::from);
    let range = matrix.x_axis.abs() * width + matrix.y_axis.abs() * height;
    if range.x.min(range.y) < 0.1 {
        errors[0] += 0.2 * NEAR / width;
        errors[1] += 0.2 * NEAR / height;
        errors[2] += 0.2 * NEAR;
    }
}

/// Whether two directions have one colour.
fn is_near(a: DVec3, b: DVec3) -> bool {
    (a - b).abs().max_element() < NEAR
}

/// Whether the blue of a point is no clamped one.
fn is_deep((_, v): &Sight) -> bool {
    -1.0 + NEAR < v.z
}

/// Places all over the picture whose red and green are not clamped.
fn points(yours: &RgbImage) -> Vec<Sight> {
    let count = (yours.width() * yours.height()).min(12_000);
    let places = scattered(yours, count).into_iter();
    places.filter_map(|(i, j)| point(yours, i, j)).collect()
}

fn point(yours: &RgbImage, i: u32, j: u32) -> Option<Sight> {
    let pixel = yours.get_pixel(i, j);
    let is_open = [pixel[0], pixel[1]].iter().all(|b| !matches!(b, 0 | 255));
    let colour = DVec3::from_array(pixel.0.map(f64::from)) / 255.0;
    let v = (colour - 0.7) / 0.3 * DVec3::new(1.0, 1.0, -1.0);
    is_open.then(|| (DVec3::new(i.into(), j.into(), 1.0), v))
}

/// The planes through three neighbouring points each, in many parts of the picture.
fn triples(yours: &RgbImage) -> impl Iterator<Item = DMat3> {
    let (width, height) = yours.dimensions();
    let across = (width / 10).clamp(1, 64);
    let down = (height / 10).clamp(1, 64);
    scattered(yours, 260).into_iter().filter_map(move |(i, j)| {
        let k =
            if i + across < width { i + across } else { i.checked_sub(across)? };
        let l = if j + down < height { j + down } else { j.checked_sub(down)? };
        let [a, b, c] = [(i, j), (k, j), (i, l)].map(|(i, j)| point(yours, i, j));
        let (a, b, c) = (a?, b?, c?);
        let places = DMat3::from_cols(a.0, b.0, c.0);
        let seen = DMat3::from_cols(a.1, b.1, c.1);
        let matrix = seen * places.inverse();
        // What changes nowhere is an object of one colour.
        let is_flat = (seen.x_axis - seen.y_axis).abs().max_element() < 1e-9
            && (seen.x_axis - seen.z_axis).abs().max_element() < 1e-9;
        let is_ahead = a.1.z < -1.0 + NEAR;
        (matrix.is_finite() && (!is_flat || is_ahead)).then_some(matrix)
    })
}

/// The plane that lies best on the points, and how far off its numbers may be.
fn plane(points: &[&Sight]) -> Option<(DMat3, [f64; 3])> {
    let mut parts = [Least::<3>::new(), Least::new(), Least::new()];
    for (place, v) in points {
        for (k, least) in parts.iter_mut().enumerate() {
            least.add(&place.to_array(), v[k]);
        }
    }
    let [x, y, z] = [&parts[0], &parts[1], &parts[2]].map(Least::solve);
    let (x, y, z) = (x?, y?, z?);
    let matrix = DMat3::from_cols_array_2d(&[x, y, z]).transpose();
    Some((matrix, parts[0].errors(1.0 / (255.0 * 0.3 * 12_f64.sqrt()))))
}
