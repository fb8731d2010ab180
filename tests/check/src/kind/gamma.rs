use crate::Locked;
use crate::measure::number;
use image::RgbImage;

/// Says whether every byte is that of ours to some power, or by the curve of sRGB, both
/// of which are called gamma.
pub(super) fn told(yours: &RgbImage, ours: &Locked) -> Option<String> {
    if yours.dimensions() != ours.picture.dimensions() {
        return None;
    }
    let curve = curve(yours, &ours.picture)?;
    let is = |byte: &dyn Fn(f64) -> f64| {
        let far = |(x, y): &(f64, f64)| (255.0 * byte(*x) - 255.0 * y).abs();
        curve.iter().all(|point| far(point) < 1.6)
    };
    let power = power(&curve);
    let how = if is(&srgb) {
        "by the curve of sRGB".to_owned()
    } else if (power - 1.0).abs() < 0.02 || !is(&|x: f64| x.powf(power)) {
        return None;
    } else if power < 1.0 {
        format!("to the power 1/{}", hundredths(1.0 / power))
    } else {
        format!("to the power {}", hundredths(power))
    };
    Some(format!(
        "Not right yet: its bytes are those of the picture of {} {how}: that is gamma, and here \
         round(255 I) is what is wanted.",
        ours.name
    ))
}

fn hundredths(x: f64) -> String {
    number((100.0 * x).round() / 100.0)
}

/// For each byte of ours that is often there, what stands in its place, both from 0 to
/// 1; None where that is not one and the same in nearly all pixels and channels.
fn curve(yours: &RgbImage, ours: &RgbImage) -> Option<Vec<(f64, f64)>> {
    let mut counts = vec![[0_usize; 256]; 256];
    for (ours, yours) in ours.as_raw().iter().zip(yours.as_raw()) {
        counts[usize::from(*ours)][usize::from(*yours)] += 1;
    }
    let (mut kept, mut curve) = (0, vec![]);
    for (x, counts) in counts.iter().enumerate() {
        let (y, most) =
            counts.iter().enumerate().max_by_key(|(_, count)| **count)?;
        kept += most;
        if 20 < *most {
            curve.push((x as f64 / 255.0, y as f64 / 255.0));
        }
    }
    let is_one = ours.as_raw().len() < kept * 200 / 199;
    (is_one && 16 < curve.len()).then_some(curve)
}

/// The power that fits best: the mean of those that fit in the middle.
fn power(curve: &[(f64, f64)]) -> f64 {
    let is_middle = |v: f64| 0.1 < v && v < 0.9;
    let middle = curve.iter().filter(|(x, y)| is_middle(*x) && is_middle(*y));
    let (sum, weight) = middle.fold((0.0, 0.0), |(sum, weight), (x, y)| {
        (sum + y.ln() * x.ln(), weight + x.ln() * x.ln())
    });
    if 0.0 < weight { sum / weight } else { 1.0 }
}

/// What sRGB makes of an intensity.
fn srgb(x: f64) -> f64 {
    if x <= 0.003_130_8 { 12.92 * x } else { 1.055 * x.powf(1.0 / 2.4) - 0.055 }
}
