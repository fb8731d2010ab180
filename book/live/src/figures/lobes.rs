use crate::live::{Handle, Knob, Live, Sight};
use crate::svg::{Drawing, View, degrees_left};
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::{FRAC_PI_4, PI};
use step05_phong::{Attenuation, Light, Material, Matte, PointLight, specular};

const VIEW: View = View { origin: dvec2(176.0, 258.0), scale: dvec2(222.0, 222.0) };

/// The unit vector r, as far from the normal as the light on its other side.
fn reflected(values: &[f64]) -> DVec2 {
    DVec2::from_angle((90.0 - values[1]).to_radians())
}

/// max(r·v, 0)ⁿ for several n: as far from the point as it is bright, towards every
/// v.
fn draw(values: &[f64]) -> Drawing {
    let (view, r) = (VIEW, reflected(values));
    let last = values[0] as i32;
    let mut drawing = Drawing::new(480.0, 300.0);
    drawing.line("ground", dvec2(30.0, 258.0), dvec2(450.0, 258.0));
    for (k, n) in [1, 10, 40, last].into_iter().enumerate() {
        let lobe: Vec<DVec2> = (0..=180)
            .map(|k| DVec2::from_angle(f64::from(k).to_radians()))
            .map(|v| view.at(highlight(r, v, n) * v))
            .collect();
        drawing.area(&format!("lobe lobe-{}", k + 1), &lobe);
    }
    let l = dvec2(-r.x, r.y);
    drawing.arc("guide", view.origin, 111.0, [0.0, PI]);
    drawing.arrow("light", view.origin, view.at(0.85 * l));
    drawing.arrow("normal", view.origin, view.at(0.85 * DVec2::Y));
    drawing.arrow("vector", view.origin, view.at(1.12 * r));
    drawing.label_to("strong", view.at(0.9 * l) + dvec2(-4.0, 2.0), "$l$");
    drawing.label("strong", view.at(0.85 * DVec2::Y) + dvec2(0.0, -8.0), "$n$");
    drawing.label_from("strong", view.at(1.12 * r) + dvec2(6.0, -2.0), "$r$");
    for (n, angle, y) in
        [(1, 0.12, 226.0), (10, 0.44, 190.0), (40, 0.6, 154.0), (last, 0.7, 118.0)]
    {
        // Beside r, on the side of the numbers, and above the ground.
        let v = DVec2::from_angle((r.to_angle() - FRAC_PI_4 + angle).max(0.0));
        let at = view.at(highlight(r, v, n) * v);
        let end = dvec2(418.0, y);
        drawing.line("leader", at, end - dvec2(5.0, 5.0));
        drawing.label_from("quiet", end, &n.to_string());
    }
    drawing.label_from("quiet", dvec2(418.0, 90.0), "$n$ =");
    let half = view.origin + dvec2(-111.0, 22.0);
    drawing.label("quiet", half, "one half");
    drawing
}

/// The lobes of several exponents, one of which its reader sets, and the light.
pub fn figure() -> Live {
    Live {
        title: "Lobes around the reflection vector r: for the exponents 1, 10, 40 and 150 they are ever narrower, and all of the same length along r.",
        caption: "The highlight $\\max(r \\cdot v, 0)^n$, drawn as a shape, a *lobe*: the brighter it is in a direction $v$, \
                  the further the lobe reaches. All lobes are equally long along $r$; a larger $n$ leaves less to the sides. \
                  Where a lobe crosses the dotted circle, the highlight is down to one half. \
                  <span class='move'>Turn the light, and let $n$ grow.</span>",
        knobs: vec![
            Knob::new(["n", "of the first lobe", ""], 150.0, [1.0, 300.0], 1.0),
            Knob::new(["", "angle of the light", "°"], 45.0, [5.0, 50.0], 1.0),
        ],
        handles: vec![Handle::new(
            "the light l",
            [1, 1],
            |_, values| {
                let r = reflected(values);
                VIEW.at(0.85 * dvec2(-r.x, r.y))
            },
            |_, _, to| DVec2::splat(degrees_left(VIEW.origin, to)),
        )],
        ..Live::new("lobes", |values| Sight::Drawing(draw(values)))
    }
}

/// What the step's own specular term makes of a white light, seen along `v`.
fn highlight(r: DVec2, v: DVec2, shininess: i32) -> f64 {
    let matte = Matte::of(DVec3::ZERO);
    let material = Material { matte, specular: DVec3::ONE, shininess };
    let attenuation = Attenuation { a: 1.0, b: 0.0, c: 0.0 };
    let point_light =
        PointLight { position: DVec3::Y, diffuse: DVec3::ZERO, attenuation };
    let light = Light { point_light, specular: DVec3::ONE };
    specular(r.extend(0.0), v.extend(0.0), 1.0, &material, &light).x
}
