use crate::Step;
use crate::classes::Seen;
use crate::scenes::OBJECTS;
use crate::stages::{Pixels, Stage};

const DIFFUSE: [&str; 3] = [
    "step04_diffuse/diffuse.rs",
    "step04_diffuse/light.rs",
    "step04_diffuse/point.rs",
];

/// The light: that of all sides, of each lamp, and the highlights.
pub(crate) fn light(
    pixels: &Pixels,
    right: &mut Vec<&'static str>,
) -> Option<Stage> {
    let stage = |text: String, files: &[&'static str]| {
        Some(Stage { text, files: files.to_vec() })
    };
    let is = |seen: &Seen, lit: [bool; 2]| {
        seen.object.is_some() && seen.is_lit == lit && !seen.shines
    };
    let dark = pixels.count(|seen| is(seen, [false, false]));
    let told = |(right, all): (usize, usize)| format!("{} of {all}", all - right);
    if dark.0 < dark.1 {
        let text = format!("{} pixels that no light reaches", told(dark));
        if !is_flat(pixels) {
            let text = format!("{text}, where there is light.");
            return stage(text, &[DIFFUSE[0], DIFFUSE[2], "step05_phong/phong.rs"]);
        }
        let own = match pixels.step {
            Step::Phong => "step05_phong/phong.rs",
            _ => "step04_diffuse/picture.rs",
        };
        let text = format!("{text}: the ambient light.");
        return stage(
            text,
            &["step04_diffuse/ambient.rs", "step04_diffuse/scene.rs", own],
        );
    }
    right.push("the side no light reaches");
    let warm = pixels.count(|seen| is(seen, [true, false]));
    let cool = pixels.count(|seen| is(seen, [false, true]));
    let both = pixels.count(|seen| is(seen, [true, true]));
    let is_right = |(right, all): (usize, usize)| right == all;
    let lamp = |name: &str, count| {
        let text = format!("the light of {name}: {} pixels.", told(count));
        stage(text, &["step04_diffuse/scene.rs", DIFFUSE[0], DIFFUSE[1]])
    };
    match [is_right(warm), is_right(cool), is_right(both)] {
        [true, true, true] => {
            right.push("diffuse light");
            let shine = pixels.count(|seen| seen.shines);
            let text = match is_right(shine) {
                false => {
                    format!("the highlights: {} of their pixels.", told(shine))
                }
                true => "highlights where there is none.".to_owned(),
            };
            stage(
                text,
                &[
                    "step05_phong/specular.rs",
                    "step05_phong/phong.rs",
                    "step05_phong/reflect.rs",
                    "step05_phong/scene.rs",
                ],
            )
        }
        [true, false, _] => lamp("the cool light alone", cool),
        [false, true, _] => lamp("the warm light alone", warm),
        [true, true, false] => {
            let text = format!("where both lights add up: {} pixels.", told(both));
            stage(text, &["step04_diffuse/picture.rs", "step05_phong/phong.rs"])
        }
        [false, false, _] => {
            let all = (warm.0 + cool.0 + both.0, warm.1 + cool.1 + both.1);
            let text = format!("diffuse light: {} pixels.", told(all));
            stage(text, &DIFFUSE)
        }
    }
}

/// Whether each object has one colour where no light reaches it.
fn is_flat(pixels: &Pixels) -> bool {
    let mut colours = [None; OBJECTS.len()];
    let all = pixels.classes.iter().zip(pixels.yours.pixels());
    let dark = all.filter(|(seen, _)| seen.is_lit == [false; 2] && !seen.shines);
    for (seen, pixel) in dark {
        let Some(k) = seen.object else { continue };
        if colours[k].replace(pixel.0).is_some_and(|other| other != pixel.0) {
            return false;
        }
    }
    true
}
