use crate::evidence::{Evidence, Pixel};
use crate::explanation::Explanation;
use crate::step_scene::{hits_nearest_first, intensity_function, scene_of_step};
use crate::{Picture, Step};
use glam::{DMat3, DVec3};
use std::array;
use std::fmt::Write;
use step01_rays::Camera;

const CAMERA: &str = "step01_rays/camera.rs";
const SKY: &str = "step01_rays/picture.rs";
const RGB8: &str = "step01_rays/rgb8.rs";

/// Camera as the sky of a picture tells it: the x and y of D_u, D_v and
/// V_0. Their z leaves no trace in it.
pub(crate) struct SkyCamera {
    /// x of D_u, D_v and V_0.
    pub x: DVec3,
    /// y of the same.
    pub y: DVec3,
}

/// How far off a byte the sky may be where it is that of our camera.
const ENOUGH: f64 = 0.02;

/// How far off a byte the sky that was read may be: its rows are few.
const UNCERTAIN: f64 = 0.25;

impl SkyCamera {
    /// Reads it where blue is 255, as everywhere in our sky: the planes that fit red and
    /// green best, as red = 0.7 + 0.3 V_x and green = 0.7 + 0.3 V_y. None where too little of
    /// the picture is such a sky.
    pub fn fit(yours: &Picture) -> Option<Self> {
        let is_sky = |pixel: [u8; 3]| {
            pixel[2] == 255 && pixel[..2].iter().all(|c| (1..255).contains(c))
        };
        let all = places_and_colours(yours).filter(|(_, pixel)| is_sky(*pixel));
        let all: Vec<_> = all.collect();
        if all.len() * 20 < yours.pixels.pixels().len() {
            return None;
        }
        let decode = |byte: u8| (f64::from(byte) / 255.0 - 0.7) / 0.3;
        let point = |(place, [r, g, _]): &(DVec3, [u8; 3])| {
            (*place, [decode(*r), decode(*g)])
        };
        let [x, y] = fit_planes(&all.iter().map(point).collect::<Vec<_>>())?;
        Some(Self { x, y })
    }

    fn from_camera(camera: &Camera) -> Self {
        let rows = camera.matrix.transpose();
        Self { x: rows.x_axis, y: rows.y_axis }
    }

    /// The camera that it tells, with the z of ours. What is 0 in ours and hardly more here is 0.
    fn camera_with_z_of(&self, ours: &Camera) -> Camera {
        let (columns, rows) = (f64::from(ours.h_res), f64::from(ours.v_res));
        let (mut x, mut y) = (self.x, self.y);
        for (number, count) in [(&mut x.y, rows), (&mut y.x, columns)] {
            if number.abs() * count * 76.5 < UNCERTAIN {
                *number = 0.0;
            }
        }
        let z = ours.matrix.row(2);
        Camera { matrix: DMat3::from_cols(x, y, z).transpose(), ..*ours }
    }

    /// The field of view that it tells, to a tenth of a degree.
    pub fn rounded_fov_degrees(&self, columns: u32) -> f64 {
        let tan = self.x.x.abs() * f64::from(columns - 1) / 2.0;
        (20.0 * tan.atan().to_degrees()).round() / 10.0
    }

    /// Whether D_u and D_v have one direction, as those of no camera have.
    fn has_parallel_axes(&self) -> bool {
        let area = self.x.x * self.y.y - self.x.y * self.y.x;
        let [u, v] =
            [(self.x.x, self.y.x), (self.x.y, self.y.y)].map(|(x, y)| x.hypot(y));
        area.abs() < 0.2 * u * v
    }

    /// Whether a byte of a picture would be off by no more with the other camera.
    fn is_within_byte_tolerance(
        &self,
        other_camera: &Self,
        (columns, rows): (u32, u32),
        byte_tolerance: f64,
    ) -> bool {
        let corners = [(0, 0), (columns, 0), (0, rows), (columns, rows)];
        corners.into_iter().all(|(i, j)| {
            let corner = DVec3::new(i.into(), j.into(), 1.0);
            let byte_difference =
                |a: DVec3, b: DVec3| (a - b).dot(corner).abs() * 76.5;
            byte_difference(self.x, other_camera.x)
                .max(byte_difference(self.y, other_camera.y))
                < byte_tolerance
        })
    }

    /// Half a sentence: which of D_u, D_v and V_0 are others than in `ours`.
    fn clauses_of_differences(
        &self,
        ours: &Self,
        (columns, rows): (u32, u32),
    ) -> String {
        let mut text = String::new();
        let parts = [("D_u", columns), ("D_v", rows), ("V_0", 1)];
        for (k, (name, count)) in parts.into_iter().enumerate() {
            let [yours, right] = [self, ours].map(|sky| (sky.x[k], sky.y[k]));
            let difference =
                (yours.0 - right.0).abs().max((yours.1 - right.1).abs());
            if ENOUGH < difference * f64::from(count) * 76.5 {
                let [yours, right] = [yours, right].map(|(x, y)| {
                    format!(
                        "({}, {})",
                        format_4_or_6_decimals(x),
                        format_4_or_6_decimals(y)
                    )
                });
                let _ =
                    write!(text, " x and y of {name} are {yours}, not {right};");
            }
        }
        text.trim_end_matches(';').to_owned() + "."
    }
}

/// Each pixel, and its place (i, j, 1).
fn places_and_colours(yours: &Picture) -> impl Iterator<Item = (DVec3, [u8; 3])> {
    yours.pixels.enumerate_pixels().map(|(i, k, pixel)| {
        let j = yours.rows[k as usize];
        (DVec3::new(i.into(), j.into(), 1.0), pixel.0)
    })
}

/// A number with four digits that tell.
fn format_4_or_6_decimals(number: f64) -> String {
    let number = if number.abs() < 1e-6 { 0.0 } else { number };
    let digits = if number.abs() < 0.1 { 6 } else { 4 };
    let text = format!("{number:.digits$}").replace('-', "−");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// How far off a point of the sky may be while the plane is refined; the last are little
/// more than what the rounding of its byte does.
const LIMITS: [f64; 8] = [0.02, 0.015, 0.012, 0.01, 0.009, 0.008, 0.008, 0.008];

/// The planes a·i + b·j + c, one for each of N values, on which most of the points are, by
/// least squares; None where these are few. (What is drawn in the sky's blue is not of the
/// sky.)
fn fit_planes<const N: usize>(points: &[(DVec3, [f64; N])]) -> Option<[DVec3; N]> {
    if points.len() < 100 {
        return None;
    }
    let is_on =
        |planes: &[DVec3; N], limit: f64, (place, values): &(DVec3, [f64; N])| {
            let mut pairs = planes.iter().zip(values);
            pairs.all(|(plane, value)| (plane.dot(*place) - value).abs() < limit)
        };
    // The best of some planes through three points each, far from each other.
    let samples: Vec<_> =
        points.iter().step_by(points.len().div_ceil(400)).collect();
    let through = |k: usize| {
        let three =
            [k, 7 * k + 131, 31 * k + 270].map(|n| samples[n * 17 % samples.len()]);
        let [p, q, r] = three.map(|point| point.0);
        let inverse = DMat3::from_cols(p, q, r).transpose().inverse();
        let value = |n: usize| DVec3::from_array(three.map(|point| point.1[n]));
        inverse.is_finite().then(|| array::from_fn(|n| inverse * value(n)))
    };
    let count = |planes: &[DVec3; N]| {
        samples.iter().filter(|point| is_on(planes, 0.01, point)).count()
    };
    let mut planes = (0..400).filter_map(through).max_by_key(count)?;
    for limit in LIMITS {
        let (mut matrix, mut right, mut count) = (DMat3::ZERO, [DVec3::ZERO; N], 0);
        // Every second one, so that the fit can be asked of the others.
        let second = points.iter().step_by(2);
        for (place, values) in second.filter(|point| is_on(&planes, limit, point)) {
            matrix += DMat3::from_cols(
                *place * place.x,
                *place * place.y,
                *place * place.z,
            );
            right
                .iter_mut()
                .zip(values)
                .for_each(|(sum, value)| *sum += *place * *value);
            count += 1;
        }
        let inverse = matrix.inverse();
        if count * 5 < points.len() || !inverse.is_finite() {
            return None;
        }
        planes = right.map(|right| inverse * right);
    }
    Some(planes)
}

/// How far from the middle of a pixel a fitted camera may be.
const SLACK: f64 = 0.3;

/// Explanation, not yet tried: our step with the camera that the sky tells.
pub(crate) fn camera_candidate<'a>(
    evidence: &'a Evidence,
) -> Option<Explanation<'a>> {
    let (step, size) = (evidence.step?, evidence.yours.size);
    let (sky, ours) =
        (SkyCamera::fit(evidence.yours)?, SkyCamera::from_camera(&evidence.camera));
    if sky.is_within_byte_tolerance(&ours, size, ENOUGH) || sky.has_parallel_axes()
    {
        return None;
    }
    // Where the angle alone is another, one number is fitted, and not six.
    let tan = (sky.x.x * f64::from(size.0 - 1) / 2.0 - sky.x.z) / 2.0;
    let zoomed = Camera::new(size.0, size.1, 2.0 * tan.abs().atan());
    let is_zoomed = sky.is_within_byte_tolerance(
        &SkyCamera::from_camera(&zoomed),
        size,
        UNCERTAIN,
    ) && !sky.is_within_byte_tolerance(&ours, size, UNCERTAIN)
        && 0.0 < tan;
    let (camera, clause) = match is_zoomed {
        true => {
            let angle = sky.rounded_fov_degrees(size.0);
            (zoomed, format!(" its field of view is {angle}°, not 60°."))
        }
        false => (
            sky.camera_with_z_of(&evidence.camera),
            sky.clauses_of_differences(&ours, size),
        ),
    };
    let sentence = match step {
        Step::Rays => format!(
            "Your picture is what our step draws with another camera:{clause} (That is, if red \
             is 0.7 + 0.3 V_x and green 0.7 + 0.3 V_y, as in picture.rs.)"
        ),
        _ => format!(
            "Your picture is what our step draws with another camera:{clause}"
        ),
    };
    // The same factor and the same sum in red and in green may be those of all bytes.
    let factors = (sky.x.x / ours.x.x, sky.y.y / ours.y.y);
    let sums = (sky.x.z - factors.0 * ours.x.z, sky.y.z - factors.1 * ours.y.z);
    let is_alike = |(a, b): (f64, f64)| (a - b).abs() < 0.02;
    let files: &[_] = match step {
        Step::Rays
            if is_alike(factors) && is_alike(sums) && 0.02 < sums.0.abs() =>
        {
            &[RGB8, SKY, CAMERA]
        }
        Step::Rays => &[CAMERA, SKY],
        _ => &[CAMERA],
    };
    let intensity = intensity_function(step, &scene_of_step(step));
    let mut explanation =
        Explanation::within_range(sentence, files, move |pixel| {
            let offsets = [
                (0.0, 0.0),
                (SLACK, 0.0),
                (-SLACK, 0.0),
                (0.0, SLACK),
                (0.0, -SLACK),
            ];
            let colours = offsets.map(|(u, v)| {
                let ray =
                    camera.ray(f64::from(pixel.i) + u, f64::from(pixel.j) + v);
                evidence.encode(intensity(&ray))
            });
            range_with_margin(&colours, 1)
        });
    explanation.rays = 5;
    // An edge may lie between two of these places.
    explanation.exceptions = 2000;
    Some(explanation)
}

/// The range of some colours, and so much beyond it.
pub(crate) fn range_with_margin(colours: &[[u8; 3]], margin: u8) -> [[u8; 3]; 2] {
    let mut range = [[255; 3], [0; 3]];
    for colour in colours {
        for k in 0..3 {
            range[0][k] = range[0][k].min(colour[k].saturating_sub(margin));
            range[1][k] = range[1][k].max(colour[k].saturating_add(margin));
        }
    }
    range
}

/// A vector that is made of V.
type Direction = fn(DVec3) -> DVec3;

/// The sky of another colour, where each channel is a plane in the picture; objects as ours.
pub(crate) fn sky_colour_candidates<'a>(
    evidence: &'a Evidence,
) -> impl Iterator<Item = Explanation<'a>> {
    let is_sky = |pixel: &Pixel| pixel.region.object.is_none();
    let is_alone = evidence.step == Some(Step::Rays);
    let is_asked = evidence.step.is_some()
        && 0 < evidence.count_wrong_and_all(is_sky).0
        && evidence.count_wrong_and_all(|pixel| !is_sky(pixel)).0 == 0;
    let directions: [(&str, Direction); 2] =
        [("V", |v| v), ("V/|V|", |v| v.normalize())];
    let directions = directions.into_iter().filter(move |_| is_asked);
    directions.filter_map(move |(name, direction)| {
        let fits: Vec<_> = (0..3)
            .map(|k| fit_sky_channel(evidence, k, direction))
            .collect::<Option<_>>()?;
        let words: Vec<_> = (0..3)
            .zip(&fits)
            .map(|(k, fit)| format_channel_plane(k, *fit, name))
            .collect();
        let else_right = if is_alone { "" } else { ", and all else is right" };
        let words = words.join(", ");
        let sentence = format!("Your sky has another colour{else_right}: {words}.");
        // A V that is longer, but not another way, looks the same.
        let is_scaled = fits[..2].iter().all(|fit| (fit.z - 0.7).abs() < 0.01);
        let files: &[_] = match (is_alone, is_scaled) {
            (_, true) => &[SKY, CAMERA],
            (true, _) => &[SKY, RGB8],
            _ => &[SKY],
        };
        Some(Explanation::within_one(sentence, files, move |pixel| {
            match pixel.region.object {
                Some(_) => pixel.ours,
                None => {
                    let v = direction(evidence.our_ray(pixel).direction);
                    let sky_point = DVec3::new(v.x, v.y, 1.0);
                    [0, 1, 2]
                        .map(|k| (255.0 * fits[k].dot(sky_point)).round() as u8)
                }
            }
        }))
    })
}

/// Fits a channel of the sky: a·V_x + b·V_y + c.
fn fit_sky_channel(
    evidence: &Evidence,
    channel: usize,
    direction: Direction,
) -> Option<DVec3> {
    let sky = evidence.pixels.iter().filter(|pixel| pixel.region.object.is_none());
    let point = |pixel: &Pixel| {
        let v = direction(evidence.our_ray(pixel).direction);
        (DVec3::new(v.x, v.y, 1.0), [f64::from(pixel.yours[channel]) / 255.0])
    };
    let points: Vec<_> = sky.map(point).collect();
    let inner = points.iter().filter(|(_, [v])| 0.002 < *v && *v < 0.998);
    let inner: Vec<_> = inner.copied().collect();
    match inner.len() * 4 < points.len() {
        // All of it may have been clamped.
        true => Some(DVec3::new(0.0, 0.0, points.first()?.1[0])),
        false => fit_planes(&inner).map(|[plane]| plane),
    }
}

fn format_channel_plane(channel: usize, fit: DVec3, direction: &str) -> String {
    let name = ["red", "green", "blue"][channel];
    let mut text = format!("{name} = {}", format_2_decimals(fit.z));
    for (number, letter) in [(fit.x, "x"), (fit.y, "y")] {
        if number.abs() > 0.005 {
            let sign = if number < 0.0 { "−" } else { "+" };
            text +=
                &format!(" {sign} {} {letter}", format_2_decimals(number.abs()));
        }
    }
    match channel {
        2 => format!("{text}, where (x, y) is that of {direction}"),
        _ => text,
    }
}

fn format_2_decimals(number: f64) -> String {
    format!("{number:.2}").replace('-', "−")
}

/// The pixels in which the camera that the sky tells meets nothing, if these are all as that
/// camera would draw them: the sentence that is told of the sky alone.
pub(crate) fn clauses_and_count_of_sky(
    evidence: &Evidence,
    budget: &crate::explanation::RayBudget,
) -> Option<(String, usize)> {
    let step = evidence.step.filter(|step| Step::Rays < *step)?;
    let explanation = camera_candidate(evidence)?;
    let sky = SkyCamera::fit(evidence.yours)?;
    let camera = sky.camera_with_z_of(&evidence.camera);
    let scene = scene_of_step(step);
    let is_sky = |pixel: &Pixel| {
        let (i, j) = (f64::from(pixel.i), f64::from(pixel.j));
        [(0.0, 0.0), (2.0, 0.0), (-2.0, 0.0), (0.0, 2.0), (0.0, -2.0)].iter().all(
            |(u, v)| {
                hits_nearest_first(&scene, &camera.ray(i + u, j + v)).is_empty()
            },
        )
    };
    let count = evidence.pixels.iter().filter(|pixel| is_sky(pixel)).count();
    let is_much = evidence.pixels.len() / 10 < count;
    (is_much && explanation.holds_in_region(evidence, is_sky, budget)).then(|| {
        (
            sky.clauses_of_differences(
                &SkyCamera::from_camera(&evidence.camera),
                evidence.yours.size,
            ),
            count,
        )
    })
}
