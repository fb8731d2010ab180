use super::words::{list, number, vector};
use super::{Look, Stage, Verdict};
use crate::section;
use glam::{DMat3, DVec3};

/// The stage of the rays: the camera matrix, as the sky tells it.
pub(super) fn stage(look: &Look) -> Stage {
    let (verdict, numbers) = verdict(look);
    let test = Some("direction_of_a_pixel");
    Stage { name: "rays", verdict, numbers, section: section::CAMERA, test }
}

fn verdict(look: &Look) -> (Verdict, Vec<String>) {
    let Some(sky) = &look.sky else {
        let why = "no place of it is the sky of any camera".to_owned();
        return (Verdict::Unknown(why), vec![]);
    };
    if look.is_right_camera {
        return (Verdict::Right, vec![]);
    }
    let ours = look.right.camera.matrix;
    let numbers = differences(look, &sky.matrix, &ours);
    if let Some(fov) = field_of_view(&sky.matrix, &ours, &sky.errors, look) {
        let why = format!(
            "it is the camera of `--fov {}`; if you gave no such option, all of the \
             matrix is {} times what it should be, and so is its tan(θ/2)",
            number(fov),
            number(sky.matrix.x_axis.x / ours.x_axis.x)
        );
        return (Verdict::Unknown(why), numbers);
    }
    match numbers.is_empty() {
        true => {
            let why = "the sky is as far off as one byte is, or less".to_owned();
            (Verdict::Unknown(why), numbers)
        }
        false => (Verdict::Wrong, numbers),
    }
}

/// How the columns of a matrix differ from those of ours, as far as can be told.
fn differences(look: &Look, yours: &DMat3, ours: &DMat3) -> Vec<String> {
    let errors = look.sky.map_or([0.0; 3], |sky| sky.errors);
    let columns = ["D_u", "D_v", "V_0"];
    let mut numbers = vec![];
    for (k, name) in columns.into_iter().enumerate() {
        let (yours, ours) = (yours.col(k), ours.col(k));
        let off = (yours - ours).abs();
        if 5.0 * errors[k] < off.max_element() {
            let why = list(&ratios(look, yours, ours, errors[k]));
            let why = if why.is_empty() { why } else { format!(": {why}") };
            numbers.push(format!(
                "your {name} is {}; it should be {}{why}",
                vector(clean(yours, errors[k])),
                vector(ours)
            ));
        }
    }
    numbers
}

/// Numbers that can't be told from 0 as 0.
fn clean(v: DVec3, error: f64) -> DVec3 {
    v.map(|x| if x.abs() < 5.0 * error { 0.0 } else { x })
}

/// What the ratios of the parts that are wrong may mean.
fn ratios(look: &Look, yours: DVec3, ours: DVec3, error: f64) -> Vec<String> {
    let mut words = vec![];
    for (k, part) in ["x", "y", "z"].into_iter().enumerate() {
        let (yours, ours) = (yours[k], ours[k]);
        if (yours - ours).abs() < 5.0 * error || ours == 0.0 {
            continue;
        }
        let ratio = yours / ours;
        let near = |value: f64| (value - ratio).abs() < 5.0 * error / ours.abs();
        let name = meanings(look).into_iter().find(|(value, _)| near(*value));
        let name = name.map_or(String::new(), |(_, name)| format!(", {name}"));
        words.push(format!("its {part} is {} times ours{name}", number(ratio)));
    }
    words
}

/// Ratios that ordinary mistakes give.
fn meanings(look: &Look) -> Vec<(f64, &'static str)> {
    let (width, height) = look.yours.dimensions();
    let (columns, rows) = (f64::from(width), f64::from(height));
    let tan = -look.right.camera.matrix.z_axis.x;
    let half = tan.atan();
    let full = (2.0 * half).tan();
    vec![
        (0.0, "it is missing"),
        (-1.0, "the sign is wrong"),
        (0.5, "half of it"),
        (2.0, "twice as much"),
        (-0.5, "half of it, with the wrong sign"),
        (-2.0, "twice as much, with the wrong sign"),
        ((columns - 1.0) / columns, "as with hRes for hRes − 1"),
        ((columns - 1.0) / (columns - 2.0), "as with hRes − 2 for hRes − 1"),
        ((columns - 1.0) / (columns + 1.0), "as with hRes + 1 for hRes − 1"),
        ((columns - 1.0) / (rows - 1.0), "as with vRes − 1 for hRes − 1"),
        ((columns - 1.0) / rows, "as with vRes for hRes − 1"),
        (rows / (rows - 1.0), "as with vRes for vRes − 1"),
        ((rows - 2.0) / (rows - 1.0), "as with vRes − 2 for vRes − 1"),
        (columns / (rows - 1.0), "as with hRes for vRes − 1"),
        (
            (columns - 1.0) / (rows - 1.0) * (columns - 1.0) / (rows - 1.0),
            "as with the aspect ratio upside down",
        ),
        (columns - 1.0, "as without the hRes − 1 below it"),
        (full / tan, "as with tan θ for tan(θ/2)"),
        (full / tan / 2.0, "as with tan(θ)/2 for tan(θ/2)"),
        (half / tan, "as with θ/2 for its tangent"),
        (2.0 * half / tan, "as with θ for tan(θ/2)"),
        (half.sin() / tan, "as with the sine for the tangent"),
        (half.cos() / tan, "as with the cosine for the tangent"),
        (1.0 / tan, "as with 1 for tan(θ/2)"),
        (1.0 / (tan * tan), "as divided by tan(θ/2)"),
        (tan, "as with tan(θ/2) twice"),
        (1.0 / tan.powi(2), "as with 1/tan(θ/2)"),
        ((half / 2.0).tan() / tan, "as with tan(θ/4) for tan(θ/2)"),
        (half.to_degrees().tan() / tan, "as with degrees for radians"),
    ]
}

/// The field of view in degrees, where it is the only thing that differs.
fn field_of_view(
    yours: &DMat3,
    ours: &DMat3,
    errors: &[f64; 3],
    look: &Look,
) -> Option<f64> {
    let (columns, rows) = look.yours.dimensions();
    let ratio = yours.z_axis.x / ours.z_axis.x;
    let is_one = (0..3).all(|k| {
        let scale = DVec3::new(ratio, ratio, 1.0);
        let off = (yours.col(k) - scale * ours.col(k)).abs().max_element();
        off < 6.0 * errors[k]
    });
    let tan = -yours.z_axis.x;
    let fov = 2.0 * tan.atan().to_degrees();
    let whole = (fov * 2.0).round() / 2.0;
    let error = 6.0 * errors[2].to_degrees() * 2.0;
    let is_option = (fov - whole).abs() < error.max(0.02);
    (is_one && 0.0 < tan && is_option && columns.min(rows) > 1).then_some(whole)
}
