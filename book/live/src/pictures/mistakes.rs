use super::shown;
use crate::live::{Knob, Live};
use gallery::{COUNT, Mistake, Step, by_step, panels};
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
        let mistake = mistake(values);
        let step = if values[1] == 0.0 { mistake.step } else { Step::Phong };
        let camera = camera(values).unwrap_or_else(|_| crate::camera());
        let (wrong, right) =
            (mistake.picture_in(step, &camera, 1), step.picture(&camera, 1));
        shown(&panels([("wrong", &wrong), ("right", &right)]))
    },
    beside: None,
    numbers: |values| {
        let Mistake { when, says, .. } = mistake(values);
        let texts = [("when", when), ("says", says)];
        texts.map(|(name, text)| (name.into(), text.replace('`', ""))).into()
    },
};

const STEPS: [&str; 5] = ["Step 1", "Step 2", "Step 3", "Step 4", "Step 5"];

/// The mistake of these values, which are allowed.
fn mistake(values: &[f64]) -> &'static Mistake {
    by_step().nth(values[0] as usize).expect("a mistake of the gallery")
}

/// The camera of these values.
fn camera(values: &[f64]) -> Result<Camera, String> {
    let columns = values[3] as u32;
    let rows = AspectRatio { width: 16.0, height: 9.0 }.v_res(columns);
    Ok(Camera::new(columns, rows, values[2].to_radians()))
}
