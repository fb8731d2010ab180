use crate::light::light;
use crate::pixels::Pixels;
use crate::place::{back, place};
use crate::scenes::OBJECTS;
use crate::sky::Sky;
use crate::{Step, camera};

/// The first stage that is wrong.
pub(crate) struct Stage {
    /// Whole lines, of what is wrong.
    pub text: String,
    /// The likeliest files, such as `step01_rays/camera.rs`.
    pub files: Vec<&'static str>,
}

/// Which stages of a picture are right, the first that is not, and where to go back to.
pub(crate) fn stages(pixels: &Pixels) -> String {
    let mut right = vec![];
    let Some(Stage { text, files }) = first_wrong(pixels, &mut right) else {
        return String::new();
    };
    let right = match right.is_empty() {
        true => String::new(),
        false => format!("Right: {}.\n", right.join(", ")),
    };
    let places: Vec<_> = files.iter().filter_map(|file| place(file)).collect();
    format!("{right}First wrong: {text}\n{}", back(&places))
}

fn first_wrong(pixels: &Pixels, right: &mut Vec<&'static str>) -> Option<Stage> {
    if let Some(stage) = rays(pixels) {
        return Some(stage);
    }
    right.push("the rays");
    if pixels.step == Step::Rays {
        let text = "the colours of the rays.".to_owned();
        let files = vec!["step01_rays/picture.rs", "step01_rays/rgb8.rs"];
        return Some(Stage { text, files });
    }
    if let Some(stage) = outlines(pixels) {
        return Some(stage);
    }
    right.push("the outlines");
    if let Some(stage) = objects(pixels, right) {
        return Some(stage);
    }
    light(pixels, right)
}

/// The rays, as the sky has them.
fn rays(pixels: &Pixels) -> Option<Stage> {
    let size @ (columns, rows) = pixels.yours.dimensions();
    let ours = Sky::of(&camera(columns, rows));
    let (sky, all) = pixels.count(|seen| seen.object.is_none());
    match Sky::read(pixels.yours) {
        Some(yours) if yours.is_like(&ours, size) => None,
        Some(yours) if sky < all => {
            let told = yours.differences(&ours, size);
            let text = format!("the rays.\n{}", told.trim_end());
            let files = vec!["step01_rays/camera.rs", "step01_rays/picture.rs"];
            Some(Stage { text, files })
        }
        None if sky * 4 < all => {
            let (its, objects) = pixels.count(|seen| seen.object.is_some());
            let mut files = vec!["step01_rays/picture.rs", "step01_rays/camera.rs"];
            if its < objects {
                files.push("step02_sphere/quadratic.rs");
                files.push("step02_sphere/sphere.rs");
            }
            let text =
                "the sky: it is not 0.7 + 0.3 V of the rays, or it is hidden.";
            Some(Stage { text: text.to_owned(), files })
        }
        _ => None,
    }
}

/// Which pixels show an object, and which the sky.
fn outlines(pixels: &Pixels) -> Option<Stage> {
    const SHAPES: [&str; 2] =
        ["step02_sphere/quadratic.rs", "step02_sphere/sphere.rs"];
    let own = match pixels.step {
        Step::Sphere => "step02_sphere/picture.rs",
        _ => "step03_nearest/objects.rs",
    };
    let (sky, all) = pixels.count(|seen| seen.object.is_none());
    let extra = all - sky;
    let count = if pixels.step == Step::Sphere { 1 } else { OBJECTS.len() };
    let missing: Vec<_> = (0..count).map(|k| pixels.missing(k)).collect();
    let gone: usize = missing.iter().map(|(sky, _)| sky).sum();
    if gone + extra < 4 {
        return None;
    }
    let stage = |text: String, files: &[&'static str]| {
        Some(Stage { text, files: files.to_vec() })
    };
    if pixels.shows_sky.iter().all(|is| *is) {
        let mut files = SHAPES.to_vec();
        if pixels.step != Step::Sphere {
            files.push("step03_nearest/nearest.rs");
        }
        return stage("no ray meets an object.".to_owned(), &files);
    }
    let name = |k: usize| if count == 1 { "the sphere" } else { OBJECTS[k] };
    let wrong: Vec<_> = (0..count).filter(|k| 3 < missing[*k].0).collect();
    let is_gone = |k: &usize| missing[*k].0 == missing[*k].1;
    if 1 < wrong.len() && extra == 0 && wrong.iter().all(is_gone) {
        let names: Vec<_> = wrong.iter().map(|k| name(*k)).collect();
        let text = format!("{} are missing.", names.join(", "));
        return stage(text, &["step03_nearest/nearest.rs", own]);
    }
    match wrong[..] {
        [k] if missing[k].0 == missing[k].1 && extra == 0 => {
            stage(format!("{} is missing.", name(k)), &[own, SHAPES[0], SHAPES[1]])
        }
        [k] => {
            let (sky, all) = missing[k];
            let text = format!(
                "the outline of {}: {sky} of its {all} pixels show the sky.",
                name(k)
            );
            stage(text, &[own, SHAPES[1], SHAPES[0]])
        }
        [] => {
            let text = format!(
                "the outlines: {extra} pixels of the sky show something else."
            );
            stage(text, &[SHAPES[0], SHAPES[1], own])
        }
        _ => {
            let text = format!(
                "the outlines: {gone} pixels of {} objects show the sky.",
                wrong.len()
            );
            stage(text, &[SHAPES[1], SHAPES[0], own])
        }
    }
}

/// Which object is in front, and whether only one of them is wrong.
fn objects(pixels: &Pixels, right: &mut Vec<&'static str>) -> Option<Stage> {
    let stage = |text: String, files: &[&'static str]| {
        Some(Stage { text, files: files.to_vec() })
    };
    if pixels.step == Step::Sphere {
        let text = "the colour of the sphere.".to_owned();
        return stage(text, &["step02_sphere/picture.rs"]);
    }
    let alone = pixels.count(|seen| seen.object.is_some() && !seen.is_crowded);
    let crowded = pixels.count(|seen| seen.is_crowded);
    if alone.0 == alone.1 && crowded.0 < crowded.1 {
        let text = format!(
            "{} of {} pixels where one object hides another.",
            crowded.1 - crowded.0,
            crowded.1
        );
        return stage(
            text,
            &["step03_nearest/nearest.rs", "step03_nearest/picture.rs"],
        );
    }
    let is_wrong = |k: &usize| {
        let (right, all) = pixels.count(|seen| seen.object == Some(*k));
        right < all
    };
    let wrong: Vec<_> = (0..OBJECTS.len()).filter(is_wrong).collect();
    if let [k] = wrong[..] {
        let text = format!("{}; all others are right.", OBJECTS[k]);
        let mut files = vec!["step03_nearest/objects.rs"];
        if pixels.step == Step::Phong {
            files.insert(0, "step05_phong/scene.rs");
        }
        return stage(text, &files);
    }
    if pixels.step == Step::Nearest {
        let names: Vec<_> = wrong.iter().map(|k| OBJECTS[*k]).collect();
        let text = format!("the colours of {}.", names.join(", "));
        return stage(
            text,
            &["step03_nearest/picture.rs", "step03_nearest/objects.rs"],
        );
    }
    if crowded.0 == crowded.1 {
        right.push("which object is in front");
    }
    None
}
