use super::shown;
use crate::live::{Knob, Live, number};
use gallery::{COUNT, Mistake, Parts, Step, apart, by_step, panels};
use image::RgbImage;
use step01_rays::{AspectRatio, Camera};

/// A mistake of the gallery at any view: its picture, the right one, and where they
/// differ.
pub const MISTAKES: Live = Live {
    name: "mistakes",
    knobs: &[
        Knob::list("mistake", 3.0, COUNT, |k| match by_step().nth(k) {
            Some(Mistake { step, when, .. }) => [STEPS[step.number() - 1], when],
            None => [""; 2],
        }),
        Knob::choice("in the picture of step 5", 1.0, &["off", "on"]),
        Knob::new(["θ", "field of view", "°"], 60.0, [1.0, 179.0], 1.0),
        Knob::new(["hRes", "columns", ""], 320.0, [2.0, 320.0], 1.0),
    ],
    handles: &[],
    is_allowed: |values| camera(values).is_ok(),
    sight: |values| {
        let [wrong, right] = pictures(values);
        shown(&panels([("wrong", &wrong), ("right", &right)]))
    },
    numbers: |values| {
        let [wrong, right] = pictures(values);
        let pairs = wrong.pixels().zip(right.pixels());
        let differ = pairs.filter(|(a, b)| 0 < apart(a, b)).count();
        let Mistake { when, says, .. } = mistake(values);
        vec![
            ("when".into(), when.replace('`', "")),
            ("says".into(), says.replace('`', "")),
            ("differ".into(), number(differ as f64)),
            ("pixels".into(), number(wrong.pixels().len() as f64)),
        ]
    },
};

const STEPS: [&str; 5] = ["Step 1", "Step 2", "Step 3", "Step 4", "Step 5"];

/// The mistake of these values, which are allowed.
fn mistake(values: &[f64]) -> &'static Mistake {
    by_step().nth(values[0] as usize).expect("a mistake of the gallery")
}

/// The picture with the mistake, and without it.
fn pictures(values: &[f64]) -> [RgbImage; 2] {
    let mistake = mistake(values);
    let step = if values[1] == 0.0 { mistake.step } else { Step::Phong };
    let camera = camera(values).unwrap_or_else(|_| crate::camera());
    let right = Parts::right(&camera);
    let mut wrong = right.clone();
    (mistake.change)(&mut wrong);
    [wrong, right].map(|parts| parts.picture(step, 1))
}

/// The camera of these values.
fn camera(values: &[f64]) -> Result<Camera, String> {
    let columns = values[3] as u32;
    let rows = AspectRatio { width: 16.0, height: 9.0 }.v_res(columns)?;
    Ok(Camera::new(columns, rows, values[2].to_radians()))
}
