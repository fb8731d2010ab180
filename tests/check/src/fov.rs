use crate::view::View;
use crate::{key, sort};
use step01_rays::{Camera, direction_colour};

/// The field of view of the course's camera, in degrees.
pub(crate) const FOV: f64 = 60.0;

/// Fields of view that a picture may have been drawn with, in degrees, other than that
/// of the course, as round numbers: the sky tells its rays, and these the angle.
pub(crate) fn fields_of_view(yours: &View) -> Vec<f64> {
    // The angle of which most sky is seen, be it little.
    let (mut most, mut all) = (FEW, vec![]);
    for fov in (1..180).map(f64::from) {
        let sky = sky(yours, fov);
        if most < sky {
            (most, all) = (sky, vec![fov]);
        }
    }
    if let Some(tan) = half_width(yours) {
        let degrees = 2.0 * tan.atan().to_degrees();
        all.extend(
            [1.0, 2.0, 10.0, 100.0].map(|unit| (degrees * unit).round() / unit),
        );
        // Those that give this one with a mistake: θ from top to bottom, θ for θ/2, half the
        // tangent of θ, and θ/2 for its tangent.
        let [width, height] =
            [yours.size.0, yours.size.1].map(|k| f64::from(k - 1));
        let upright = 2.0 * (tan * height / width).atan();
        let others = [upright, tan.atan(), (2.0 * tan).atan(), 2.0 * tan];
        all.extend(others.map(|fov| fov.to_degrees().round()));
        // And whole degrees that were taken for radians.
        let is_near =
            |fov: &f64| ((fov / 2.0).tan().abs() / tan - 1.0).abs() < 0.003;
        all.extend((1..180).map(f64::from).filter(is_near));
    }
    all.retain(|fov| *fov != FOV && 0.0 < *fov && *fov < 180.0);
    all.dedup();
    // What the course's angle explains as well needs no other.
    let usual = sky(yours, FOV);
    all.retain(|fov| !is_much(usual) || usual < sky(yours, *fov));
    all
}

/// Of some fields of view the one of which most sky is seen, if some is.
pub(crate) fn likeliest(yours: &View, all: Vec<f64>) -> Option<f64> {
    let all = all.into_iter().rev().map(|fov| (sky(yours, fov), fov));
    let (most, fov) = all.max_by_key(|(sky, _)| *sky)?;
    (FEW < most).then_some(fov)
}

/// Whether a field of view may have been given as an option: the course's own, or whole
/// degrees of which as much sky is seen as of any angle close by.
pub(crate) fn is_option(yours: &View, fov: f64) -> bool {
    let most = sky(yours, fov);
    let is_less = |k: i32| {
        let near = sky(yours, fov + 0.02 * f64::from(k));
        near <= most + most / 50
    };
    fov == FOV || fov.fract() == 0.0 && (-25..=25).all(is_less)
}

/// How many pixels are looked at for the sky.
const PLACES: u32 = 600;

/// So few of them are like another sky by chance.
const FEW: usize = 5;

fn is_much(sky: usize) -> bool {
    10 * sky > PLACES as usize
}

/// How many of some pixels show the sky of a field of view.
fn sky(yours: &View, fov: f64) -> usize {
    let (width, height) = yours.size;
    let camera = Camera::new(width, height, fov.to_radians());
    let is_sky = |&(i, j): &(u32, u32)| {
        let colour = direction_colour(&camera.ray(i.into(), j.into()));
        let bytes = (255.0 * colour + 0.5).to_array().map(|c| c as u8);
        // White is the sky of many angles, and other things.
        let is_clamped = matches!(bytes, [0 | 255, 0 | 255, _]);
        yours.pixel(i, j).0 == bytes && !is_clamped
    };
    yours.scattered(PLACES).iter().filter(|place| is_sky(place)).count()
}

/// tan(θ/2), as most of the sky has it.
fn half_width(yours: &View) -> Option<f64> {
    let columns = f64::from(yours.size.0 - 1);
    let tan = |(i, j): (u32, u32)| {
        let red = yours.pixel(i, j)[0];
        let v_x = (f64::from(red) / 255.0 - 0.7) / 0.3;
        let place = 2.0 * f64::from(i) / columns - 1.0;
        let is_sky = 0 < red && red < 255 && 0.3 < place.abs();
        is_sky.then_some((v_x / place).abs())
    };
    // Much of the upper third of the picture is sky.
    let places = yours.scattered(4000).into_iter();
    let upper = places.filter(|(_, j)| 3 * j < yours.size.1);
    let mut all: Vec<f64> = upper.filter_map(tan).collect();
    sort(&mut all, |tan| key(*tan));
    // Where most of them are close together, and the middle of these.
    let close = |start: usize| {
        let end = all.partition_point(|tan| *tan < 1.01 * all[start]);
        (end - start, (start + end) / 2)
    };
    let (_, middle) = (0..all.len()).map(close).max_by_key(|(count, _)| *count)?;
    all.get(middle).copied()
}
