use crate::Step;
use crate::scene::COUNT;
use crate::seen::Pixels;
use crate::stages::{MATERIALS, Wrong, wrong};

const AMBIENT: &str = "step04_diffuse/ambient.rs";
const DIFFUSE: &str = "step04_diffuse/diffuse.rs";
const LIGHT: &str = "step04_diffuse/light.rs";
const LAMPS: &str = "step04_diffuse/scene.rs";
const NORMAL: &str = "step04_diffuse/surface_point.rs";
const SPECULAR: &str = "step05_phong/specular.rs";
const REFLECT: &str = "step05_phong/reflect.rs";
const PHONG: &str = "step05_phong/phong.rs";

/// The light: where none reaches, each lamp, and the highlights.
pub(crate) fn light(pixels: &Pixels, right: &mut Vec<String>) -> Option<Wrong> {
    let own = match pixels.step {
        Step::Phong => PHONG,
        _ => "step04_diffuse/picture.rs",
    };
    let dark: &[_] = match is_flat(pixels) {
        true => &[AMBIENT, LAMPS, DIFFUSE, own],
        false => &[DIFFUSE, NORMAL, LIGHT, own],
    };
    let shiny = [SPECULAR, PHONG, REFLECT, MATERIALS];
    let (some, all) = pixels.wrong(|seen| seen.lit != [false; 2] && !seen.shines);
    let lamps: &[_] = match pixels.step == Step::Phong && 2 * some < all {
        true => &shiny,
        false => &[DIFFUSE, LIGHT, LAMPS, NORMAL, own],
    };
    for (name, lit, shines, files) in [
        ("where no light reaches", [false; 2], false, dark),
        ("where the warm light alone reaches", [true, false], false, lamps),
        ("where the cool light alone reaches", [false, true], false, lamps),
        ("where both lights reach", [true; 2], false, lamps),
        ("where highlights may be", [true; 2], true, &shiny),
    ] {
        let (some, all) = pixels.wrong(|seen| {
            let is_lit = seen.object.is_some() && seen.lit == lit;
            seen.shines == shines && (shines || is_lit)
        });
        let is_part = pixels.step == Step::Phong && lit != [false; 2] && !shines;
        let name =
            format!("{name}{}", if is_part { " (without highlights)" } else { "" });
        if 0 < some {
            return wrong(format!("{some} of {all} pixels {name}"), files);
        }
        right.push(name);
    }
    None
}

/// Whether each object has one colour where no light reaches it.
fn is_flat(pixels: &Pixels) -> bool {
    let mut colours = [None; COUNT];
    let mut dark = pixels.all.iter().filter(|seen| seen.lit == [false; 2]);
    dark.all(|seen| {
        let Some(k) = seen.object else { return true };
        let old = colours[k].replace(seen.yours);
        old.is_none_or(|other| other == seen.yours)
    })
}
