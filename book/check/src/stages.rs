use crate::light::light;
use crate::place::{back, place};
use crate::seen::{Pixels, Seen};
use crate::sky::Sky;
use crate::{Step, camera};
use image::RgbImage;

/// The first stage of a picture that is wrong: what is counted, and the likeliest files.
pub(crate) struct Wrong {
    pub text: String,
    pub files: Vec<&'static str>,
}

const CAMERA: &str = "step01_rays/camera.rs";
const SKY: &str = "step01_rays/picture.rs";
const RGB8: &str = "step01_rays/rgb8.rs";
const SPHERE: &str = "step02_sphere/sphere.rs";
const QUADRATIC: &str = "step02_sphere/quadratic.rs";
const NEAREST: &str = "step03_nearest/nearest.rs";
const OBJECTS: &str = "step03_nearest/objects.rs";
pub(crate) const MATERIALS: &str = "step05_phong/scene.rs";

/// Which stages of a picture are right, the first that is not, and where to go back to.
///
/// What it says is counted; only the files are a guess.
pub(crate) fn stages(step: Step, yours: &RgbImage, ours: &RgbImage) -> String {
    let (pixels, mut right) = (Pixels::new(step, yours, ours), vec![]);
    let wrong = sky(&pixels, yours, &mut right)
        .or_else(|| outlines(&pixels, &mut right))
        .or_else(|| objects(&pixels, &mut right))
        .or_else(|| light(&pixels, &mut right));
    let Some(Wrong { text, files }) = wrong else { return String::new() };
    let right = match right.is_empty() {
        true => String::new(),
        false => format!("Right: {}.\n", right.join(", ")),
    };
    let places: Vec<_> = files.iter().filter_map(|file| place(file)).collect();
    format!(
        "{right}First wrong: {}.\n{}",
        text.trim_end_matches('.'),
        back(&places)
    )
}

pub(crate) fn wrong(text: String, files: &[&'static str]) -> Option<Wrong> {
    Some(Wrong { text, files: files.to_vec() })
}

/// The rays, as the sky has them.
fn sky(
    pixels: &Pixels,
    yours: &RgbImage,
    right: &mut Vec<String>,
) -> Option<Wrong> {
    let size @ (columns, rows) = yours.dimensions();
    let ours = Sky::of(&camera(columns, rows));
    let (some, all) = pixels.wrong(|seen| seen.object.is_none());
    let text = format!("{some} of {all} pixels of the sky");
    match Sky::read(yours) {
        Some(yours) if 0 < some && !yours.is_like(&ours, size) => {
            let told = yours.differences(&ours, size);
            wrong(format!("{text}.\n{}", told.trim_end()), &[CAMERA, SKY])
        }
        None if 0 < some && 4 * (all - some) < all => {
            let (its, _) = pixels.wrong(|seen| seen.object.is_some());
            let all_sky = [SKY, CAMERA, "step01_rays/render.rs"];
            let files = [SKY, CAMERA, QUADRATIC, SPHERE];
            wrong(text, if its == 0 { &all_sky } else { &files })
        }
        _ if pixels.step == Step::Rays => wrong(text, &[SKY, RGB8]),
        None if 0 < some => None,
        _ => {
            right.push("the rays".to_owned());
            None
        }
    }
}

/// Which pixels show an object, and which the sky.
fn outlines(pixels: &Pixels, right: &mut Vec<String>) -> Option<Wrong> {
    let own = match pixels.step {
        Step::Sphere => "step02_sphere/picture.rs",
        _ => OBJECTS,
    };
    let shows_sky = |seen: &Seen| seen.shows_sky;
    let (extra, sky) = pixels.wrong(|seen| seen.object.is_none());
    let gone = |k| pixels.count(|seen| seen.object == Some(k), shows_sky);
    let (some, names) = pixels.those(|k| 0 < gone(k).0);
    let (gone, all) =
        some.iter().map(|k| gone(*k)).fold((0, 0), |a, b| (a.0 + b.0, a.1 + b.1));
    if gone + extra == 0 {
        right.push("the outlines".to_owned());
    }
    if gone + extra < 4 {
        return None;
    }
    let files: &[_] = match (&some[..], gone == all && extra == 0) {
        _ if pixels.all.iter().all(shows_sky) => &[QUADRATIC, SPHERE, NEAREST],
        ([_], true) => &[own, QUADRATIC, SPHERE],
        ([_, _, ..], true) => &[NEAREST, own],
        ([_], false) => &[own, SPHERE, QUADRATIC],
        _ => &[SPHERE, QUADRATIC, own],
    };
    let text = match (gone, extra) {
        (0, _) => format!("{extra} of {sky} pixels of the sky do not show it"),
        (_, 0) => format!("{gone} of {all} pixels of {names} show the sky"),
        _ => format!(
            "{gone} of {all} pixels of {names} show the sky, and {extra} of {sky} \
                 pixels of the sky do not"
        ),
    };
    wrong(text, &files[..files.len().min(pixels.step.number())])
}

/// Which object is in front, and whether only one of them is wrong.
fn objects(pixels: &Pixels, right: &mut Vec<String>) -> Option<Wrong> {
    let is_wrong = |k| pixels.wrong(|seen| seen.object == Some(k)).0 != 0;
    let (some, names) = pixels.those(is_wrong);
    let (crowded, all) = pixels.wrong(|seen| seen.is_crowded);
    let (its, of) =
        pixels.wrong(|seen| seen.object.is_some_and(|k| some.contains(&k)));
    let (text, files): (_, &[_]) = match (pixels.step, &some[..]) {
        (Step::Sphere, _) => (
            format!("{its} of {of} pixels of {names}"),
            &["step02_sphere/picture.rs"],
        ),
        _ if its == crowded && 0 < crowded => (
            format!("{crowded} of {all} pixels where one object hides another"),
            &[NEAREST, "step03_nearest/picture.rs"],
        ),
        (step, [_]) => (
            format!("{its} of {of} pixels of {names}; all other objects are right"),
            if step == Step::Phong { &[MATERIALS, OBJECTS] } else { &[OBJECTS] },
        ),
        (Step::Nearest, _) => (
            format!("{its} of {of} pixels of {names}"),
            &["step03_nearest/picture.rs", OBJECTS],
        ),
        _ => {
            if crowded == 0 {
                right.push("which object is in front".to_owned());
            }
            return None;
        }
    };
    wrong(text, files)
}
