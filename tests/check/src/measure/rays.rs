use super::words::{list, number, vector};
use super::{Eye, Look, Sky, Stage, Verdict};
use crate::{Step, section};
use glam::{DMat3, DVec3};

/// The stages of the rays and of the sky's colour.
pub(super) fn stages(look: &Look) -> Vec<Stage> {
    let is_colour = match look.fault {
        Some(fault) => fault.section == section::DIRECTIONS,
        None => look.tint != DMat3::IDENTITY,
    };
    let ((rays, first), (colour, second)) = match is_colour {
        true => ((Verdict::Right, vec![]), colour(look)),
        false => rays(look),
    };
    let place = look.fault.map_or(section::CAMERA, |fault| fault.section);
    let place = if is_colour { section::CAMERA } else { place };
    let stage = |name, verdict, numbers, section, test| {
        let test = Some(test);
        Stage { name, verdict, numbers, section, test }
    };
    vec![
        stage("rays", rays, first, place, "direction_of_a_pixel"),
        stage("sky", colour, second, section::DIRECTIONS, "colour_of_a_pixel"),
    ]
}

type Told = (Verdict, Vec<String>);

/// What is told where the camera may be wrong and the sky's colour is right.
fn rays(look: &Look) -> (Told, Told) {
    let unknown = |why: &str| (Verdict::Unknown(why.to_owned()), vec![]);
    match look.eye {
        Eye::Right => ((Verdict::Right, vec![]), (unspoilt(look), vec![])),
        Eye::Unknown => {
            let why =
                "no part of the picture is the sky of any camera that is known";
            (unknown(why), unknown(why))
        }
        Eye::Exact | Eye::Read => {
            let why = match look.step {
                Step::Rays => {
                    "the sky alone tells the rays, or its own colour: see the rays"
                }
                _ => "it is read as if it were right, and so tells the rays",
            };
            (camera(look), unknown(why))
        }
    }
}

/// What is told of a sky whose rays and colours are right: in step 1, all is sky.
fn unspoilt(look: &Look) -> Verdict {
    let is_other = |&(i, j): &(u32, u32)| {
        *look.yours.get_pixel(i, j)
            != look.sky_pixel(&look.theirs, &look.tint, i, j)
    };
    match look.pixels().filter(is_other).count() {
        other if 0 < other && look.step == Step::Rays => {
            Verdict::Unknown(format!("it is right in all pixels but {other}"))
        }
        _ => Verdict::Right,
    }
}

/// What is told of a camera that is not the right one.
fn camera(look: &Look) -> Told {
    let (yours, ours) = (look.theirs.camera.matrix, look.right.camera.matrix);
    let mut numbers = differences(look, &yours, &ours);
    numbers
        .extend(look.fault.map(|fault| {
            format!("such a sky is what you get when {}", fault.when)
        }));
    if look.step == Step::Rays {
        numbers.extend(or_colour(&yours, &ours));
    }
    if let Some(fov) = field_of_view(&yours, &ours, look).filter(|_| yours != ours)
    {
        let why = format!(
            "it is the camera of `--fov {}`; if you gave no such option, tan(θ/2) is {} \
             times what it should be",
            number(fov),
            number(yours.x_axis.x / ours.x_axis.x)
        );
        return (Verdict::Unknown(why), numbers);
    }
    match numbers.is_empty() {
        true => {
            let why = "it is no farther off than the rounding of a byte".to_owned();
            (Verdict::Unknown(why), numbers)
        }
        false => (Verdict::Wrong, numbers),
    }
}

/// What the sky would be if its colour were wrong and not the camera, where that is
/// simple.
fn or_colour(yours: &DMat3, ours: &DMat3) -> Option<String> {
    let tint = *yours * ours.inverse();
    let scale = tint.x_axis.x;
    let is_scaled = (tint.y_axis.y - scale).abs() < 0.003 * scale.abs();
    let is_square =
        [tint.x_axis.y, tint.x_axis.z, tint.y_axis.x, tint.y_axis.z].map(f64::abs);
    let shift = [-tint.z_axis.x, -tint.z_axis.y];
    let is_shifted = (shift[0] - shift[1]).abs() < 0.003;
    let is_other = 0.003 < (scale - 1.0).abs() || 0.003 < shift[0].abs();
    let is_ahead = yours.row(2).abs_diff_eq(ours.row(2), 1e-9) && 0.0 < scale;
    let is_same = is_square.iter().all(|x| *x < 0.003);
    let is_it = is_scaled && is_shifted && is_other && is_ahead && is_same;
    is_it.then(|| {
        format!(
            "or else the rays are right and the sky's colour is {} + {} V, where it \
             should be 0.7 + 0.3 V",
            number(0.7 + 0.3 * shift[0]),
            number(0.3 * scale)
        )
    })
}

/// What is told of a sky whose rays are right and whose colour is not.
fn colour(look: &Look) -> Told {
    if let Some(fault) = look.fault {
        let told = format!("such a sky is what you get when {}", fault.when);
        return (Verdict::Wrong, vec![told]);
    }
    let is_deep = look.sky.is_some_and(|sky| sky.is_deep);
    let names = ["red", "green", "blue"];
    let signs = [1.0, 1.0, -1.0];
    let told = (0..3).filter(|k| *k < 2 || is_deep).filter_map(|k| {
        let row = look.tint.transpose().col(k) * 0.3 * signs[k];
        let mut right = DVec3::ZERO;
        right[k] = 0.3 * signs[k];
        let is_right = (row - right).abs().max_element() < 0.002;
        (!is_right).then(|| {
            format!(
                "the sky's {} is 0.7{}; it should be 0.7{}",
                names[k],
                sum(row),
                sum(right)
            )
        })
    });
    let told: Vec<_> = told.collect();
    match told.is_empty() {
        true => {
            (Verdict::Unknown("it is off by less than a byte".to_owned()), told)
        }
        false => (Verdict::Wrong, told),
    }
}

/// " + 0.3 V_x", with the other parts where there are any; a constant is one of V_z,
/// which is −1 everywhere.
fn sum(row: DVec3) -> String {
    let names = ["V_x", "V_y", "V_z"];
    let terms = (0..3).filter(|&k| 0.002 < row[k].abs());
    let term = |k: usize| {
        let sign = if row[k] < 0.0 { "−" } else { "+" };
        format!(" {sign} {} {}", number(row[k].abs()), names[k])
    };
    terms.map(term).collect()
}

/// Cameras of which one number is another, as ordinary mistakes make it.
pub(super) fn ordinary(look: &Look) -> Vec<DMat3> {
    let ours = look.right.camera.matrix;
    let mut all = vec![];
    for column in 0..3 {
        for row in 0..2 {
            for (ratio, _) in meanings(look) {
                for c in 0..3 {
                    for value in [ours.col(c).x, ours.col(c).y] {
                        let mut matrix = ours;
                        matrix.col_mut(column)[row] = ratio * value;
                        all.push(matrix);
                        matrix.col_mut(column)[row] = -ratio * value;
                        all.push(matrix);
                    }
                }
            }
        }
    }
    all.retain(|matrix| *matrix != ours);
    all
}

/// Cameras that can't be told from the one that a sky tells, with numbers that ordinary
/// mistakes give.
pub(super) fn snapped(look: &Look, sky: &Sky) -> Vec<DMat3> {
    let ours = look.right.camera.matrix;
    let mut all =
        [true, false].map(|simple| nearest_ordinary(look, sky, simple)).to_vec();
    let is_near = |matrix: &DMat3| {
        (0..3).all(|k| {
            let off = (matrix.col(k) - sky.matrix.col(k)).abs();
            off.max_element() < 8.0 * sky.errors[k]
        })
    };
    // Some of the four numbers are all wrong by one factor.
    let views = [1.0, 2.0, 4.0].map(|part| {
        let fov = 2.0 * (-sky.matrix.z_axis.x).atan().to_degrees();
        ((fov * part).round() / part / 2.0).to_radians().tan() / -ours.z_axis.x
    });
    let ratios = meanings(look).into_iter().map(|(ratio, _)| ratio).chain(views);
    for (ratio, which) in ratios.flat_map(|r| (1..16).map(move |which| (r, which)))
    {
        let factor = |bit: u32| if which & bit == 0 { 1.0 } else { ratio };
        let mut matrix = ours;
        matrix.x_axis.x *= factor(1);
        matrix.y_axis.y *= factor(2);
        matrix.z_axis.x *= factor(4);
        matrix.z_axis.y *= factor(8);
        all.push(matrix);
    }
    let two = all.split_off(2);
    all.extend(two.into_iter().filter(is_near).take(8));
    all
}

/// What half a pixel, or one, added to i and j makes of a number of V_0.
fn shifted(ours: &DMat3, column: usize, row: usize) -> Vec<f64> {
    let step = ours.col(0)[row] + ours.col(1)[row];
    let by = |by: f64| ours.col(2)[row] + by * step;
    match column {
        2 => [0.5, -0.5, 1.0, -1.0].map(by).into(),
        _ => vec![],
    }
}

/// The camera that a sky tells, with the nearest numbers that ordinary mistakes give, or
/// with the simplest.
fn nearest_ordinary(look: &Look, sky: &Sky, is_simple: bool) -> DMat3 {
    let ours = look.right.camera.matrix;
    let mut matrix = sky.matrix;
    for column in 0..3 {
        for row in 0..2 {
            let error = 5.0 * sky.errors[column];
            let value = &mut matrix.col_mut(column)[row];
            let candidates = [ours.col(column)[row], 0.0].into_iter().chain(
                meanings(look)
                    .into_iter()
                    .flat_map(|(ratio, _)| [ratio, -ratio])
                    .flat_map(|ratio| (0..3).map(move |c| (ratio, c)))
                    .flat_map(|(ratio, c)| {
                        [ratio * ours.col(c).x, ratio * ours.col(c).y]
                    })
                    .chain(shifted(&ours, column, row)),
            );
            let near = candidates.filter(|one| (one - *value).abs() < error);
            let first = near
                .min_by(|a, b| (a - *value).abs().total_cmp(&(b - *value).abs()));
            let simple = [ours.col(column)[row], 0.0];
            let mut simple = simple.into_iter().filter(|_| is_simple);
            let simple = simple.find(|one| (one - *value).abs() < error);
            *value = simple.or(first).unwrap_or(*value);
        }
    }
    matrix
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
            let why = match pixels(look, yours - ours).filter(|_| k == 2) {
                Some(pixels) => pixels,
                None => list(&ratios(look, yours, ours, errors[k])),
            };
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

/// A small difference of V_0 in pixels of ours.
fn pixels(look: &Look, off: DVec3) -> Option<String> {
    let ours = look.right.camera.matrix;
    let (right, down) = (off.x / ours.x_axis.x, off.y / ours.y_axis.y);
    let is_small = right.abs().max(down.abs()) < 3.0 && off.z == 0.0;
    is_small.then(|| {
        let words = [(right, "right"), (down, "down")].into_iter();
        let words = words.filter(|(by, _)| 0.05 < by.abs());
        let words: Vec<_> =
            words.map(|(by, way)| format!("{} pixels {way}", number(by))).collect();
        format!("that is {} of it", list(&words))
    })
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
fn field_of_view(yours: &DMat3, ours: &DMat3, look: &Look) -> Option<f64> {
    let (columns, rows) = look.yours.dimensions();
    let errors = look.sky?.errors;
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
    let is_option = is_option && whole != 60.0 && 1 < columns.min(rows);
    (is_one && 0.0 < tan && is_option).then_some(whole)
}
