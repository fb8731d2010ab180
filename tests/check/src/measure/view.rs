use crate::Step;
use crate::fov::{FOV, fields_of_view};
use image::RgbImage;
use step01_rays::{Camera, direction_colour};

/// The options that a picture may have been drawn with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct View {
    /// The field of view, in degrees.
    pub fov: f64,
    /// The side of the grid of rays in each pixel.
    pub samples: u32,
}

impl View {
    /// Our picture with these options.
    pub fn picture(&self, step: Step, (width, height): (u32, u32)) -> RgbImage {
        let camera = Camera::new(width, height, self.fov.to_radians());
        step.picture(&camera, self.samples)
    }
}

/// The likeliest first: the defaults.
pub(super) fn views(yours: &RgbImage) -> Vec<View> {
    let whole = crate::view::View::whole(yours.clone());
    let others = fields_of_view(&whole).into_iter();
    let fovs =
        [FOV].into_iter().chain(others.filter(|fov| has_sky(yours, *fov)).take(1));
    let samples: &[u32] = if is_smooth(yours) { &[2, 3, 4, 1] } else { &[1] };
    let all = fovs
        .flat_map(|fov| samples.iter().map(move |&samples| View { fov, samples }));
    all.collect()
}

/// Whether much of a picture is the sky of a field of view.
fn has_sky(yours: &RgbImage, fov: f64) -> bool {
    let (width, height) = yours.dimensions();
    let camera = Camera::new(width, height, fov.to_radians());
    let is_sky = |&(i, j): &(u32, u32)| {
        let colour = direction_colour(&camera.ray(i.into(), j.into()));
        let bytes = (255.0 * colour + 0.5).to_array().map(|c| c as u8);
        yours.get_pixel(i, j).0 == bytes
    };
    let places = crate::view::scattered(yours, 600);
    let sky = places.iter().filter(|place| is_sky(place)).count();
    10 * sky > places.len()
}

/// Whether the pixels along sharp edges are mixed of two colours, as with more rays a
/// pixel.
fn is_smooth(yours: &RgbImage) -> bool {
    let (mut edges, mut mixed) = (0, 0);
    for j in 0..yours.height() {
        for i in 2..yours.width() - 2 {
            let at = |i: u32| yours.get_pixel(i, j);
            let apart = |a: u32, b: u32| crate::apart(at(a), at(b));
            // Two even sides, and one pixel between them.
            let is_even = apart(i - 2, i - 1) < 4 && apart(i + 1, i + 2) < 4;
            if is_even && 40 < apart(i - 1, i + 1) {
                edges += 1;
                let is_mixed = 8 < apart(i - 1, i).min(apart(i, i + 1));
                mixed += usize::from(is_mixed);
            }
        }
    }
    edges < 3 * mixed && 3 < mixed
}

/// The last column or row, where nothing is drawn.
pub(super) struct Black {
    /// What is told of it.
    pub told: String,
    column: Option<u32>,
    row: Option<u32>,
}

/// The last column or row, where it is black though the one before is not.
pub(super) fn black(yours: &RgbImage) -> Option<Black> {
    let (width, height) = yours.dimensions();
    let is_black = |i: u32, j: u32| yours.get_pixel(i, j).0 == [0; 3];
    let column = |i: u32| (0..height).all(|j| is_black(i, j));
    let row = |j: u32| (0..width).all(|i| is_black(i, j));
    let told = |what: &str, k: u32| {
        format!("the last {what}, {what} {k}, is black: nothing is drawn there")
    };
    if 2 < width && column(width - 1) && !column(width - 2) {
        let told = told("column", width - 1);
        return Some(Black { told, column: Some(width - 1), row: None });
    }
    let is_row = 2 < height && row(height - 1) && !row(height - 2);
    let told = told("row", height.saturating_sub(1));
    is_row.then_some(Black { told, column: None, row: Some(height - 1) })
}

/// All pixels, or some 200,000 of them where there are many more; none of a black line.
pub(super) fn places(yours: &RgbImage, black: Option<&Black>) -> Vec<(u32, u32)> {
    let (width, height) = yours.dimensions();
    let all = u64::from(width) * u64::from(height);
    let stride = (all / 260_000).isqrt() as usize + 1;
    let columns = move |j| (0..width).step_by(stride).map(move |i| (i, j));
    let all = (0..height).step_by(stride).flat_map(columns);
    let is_drawn = |(i, j): &(u32, u32)| {
        black.is_none_or(|b| b.column != Some(*i) && b.row != Some(*j))
    };
    all.filter(is_drawn).collect()
}
