use crate::Step;
use crate::classes::Seen;
use crate::pixels::Pixels;
use crate::scenes::OBJECTS;
use crate::stages::Stage;

const AMBIENT: &str = "step04_diffuse/ambient.rs";
const DIFFUSE: &str = "step04_diffuse/diffuse.rs";
const LIGHT: &str = "step04_diffuse/light.rs";
const LAMPS: &str = "step04_diffuse/scene.rs";
const POINT: &str = "step04_diffuse/surface_point.rs";
const PHONG: &str = "step05_phong/phong.rs";

/// Pixels that are right, and all.
type Count = (usize, usize);

/// The light: that of all sides, of each lamp, and the highlights.
pub(crate) fn light(
    pixels: &Pixels,
    right: &mut Vec<&'static str>,
) -> Option<Stage> {
    let is_dark = |seen: &Seen| seen.object.is_some() && seen.is_lit == [false; 2];
    let dark = pixels.count(is_dark);
    if dark.0 < dark.1 {
        return Some(unlit(pixels, dark));
    }
    right.push("the side no light reaches");
    // Where no highlight can be, there is diffuse light and nothing else.
    let lit = |lit: [bool; 2]| {
        pixels.count(|seen| {
            seen.object.is_some() && seen.is_lit == lit && !seen.shines
        })
    };
    let (warm, cool) = (lit([true, false]), lit([false, true]));
    let both = lit([true, true]);
    let all = (warm.0 + cool.0 + both.0, warm.1 + cool.1 + both.1);
    if pixels.step == Step::Phong && !is_mostly_wrong(all) {
        return Some(highlights(pixels, all, right));
    }
    let lamp = |name: &str, count| {
        let text = format!("the light of {name}: {} pixels.", wrong(count));
        stage(text, &[LAMPS, LIGHT, DIFFUSE])
    };
    Some(match [warm, cool, both].map(|(right, all)| right == all) {
        [true, false, _] => lamp("the cool light", cool),
        [false, true, _] => lamp("the warm light", warm),
        [true, true, _] => {
            let text = format!("where both lights add up: {} pixels.", wrong(both));
            stage(text, &["step04_diffuse/picture.rs", PHONG])
        }
        [false, false, _] => {
            let text = format!(
                "the light of both lamps: {} pixels without highlights.",
                wrong(all)
            );
            let own = match pixels.step {
                Step::Phong => PHONG,
                _ => "step04_diffuse/picture.rs",
            };
            stage(text, &[DIFFUSE, LIGHT, POINT, own])
        }
    })
}

/// The side that no light reaches, where it is wrong.
fn unlit(pixels: &Pixels, dark: Count) -> Stage {
    let own = match pixels.step {
        Step::Phong => PHONG,
        _ => "step04_diffuse/picture.rs",
    };
    let text = format!("{} pixels that no light reaches", wrong(dark));
    match is_flat(pixels) {
        true => stage(
            format!("{text}: there should be the ambient light alone."),
            &[AMBIENT, LAMPS, own, "step04_diffuse/surface.rs"],
        ),
        false => stage(
            format!("{text}: there should be one colour for each object."),
            &[DIFFUSE, POINT, LIGHT, own],
        ),
    }
}

/// The highlights, where no more than these is wrong.
fn highlights(
    pixels: &Pixels,
    (matt, all): Count,
    right: &mut Vec<&'static str>,
) -> Stage {
    let shine = pixels.count(|seen| seen.shines);
    let text = match matt == all {
        true => format!("the highlights: {} pixels.", wrong(shine)),
        false => format!(
            "the highlights, which reach {} pixels where none can be.",
            wrong((matt, all))
        ),
    };
    if matt == all {
        right.push("diffuse light");
    }
    stage(
        text,
        &[
            "step05_phong/specular.rs",
            PHONG,
            "step05_phong/reflect.rs",
            "step05_phong/scene.rs",
        ],
    )
}

fn stage(text: String, files: &[&'static str]) -> Stage {
    Stage { text, files: files.to_vec() }
}

/// "3 of 10", where that many are wrong.
fn wrong((right, all): Count) -> String {
    format!("{} of {all}", all - right)
}

fn is_mostly_wrong((right, all): Count) -> bool {
    all < 2 * (all - right)
}

/// Whether each object has one colour where no light reaches it.
fn is_flat(pixels: &Pixels) -> bool {
    let mut colours = [None; OBJECTS.len()];
    let all = pixels.classes.iter().zip(pixels.yours.pixels());
    let mut dark = all.filter(|(seen, _)| seen.is_lit == [false; 2]);
    dark.all(|(seen, pixel)| {
        let Some(k) = seen.object else { return true };
        let old = colours[k].replace(pixel.0);
        old.is_none_or(|other| other == pixel.0)
    })
}
