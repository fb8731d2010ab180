use super::Figure;
use crate::svg::Drawing;
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};
use step04_diffuse::{Attenuation, PointLight, Surface, diffuse};

/// One beam of light that falls straight down and at 60 degrees, and the ground
/// that it lights.
pub fn figure() -> Figure {
    let mut drawing = Drawing::new(480.0, 292.0);
    for (x, angle, name) in [(106.0, 0.0, "0°"), (352.0, FRAC_PI_3, "60°")] {
        let ground = dvec2(x, 210.0);
        let l = dvec2(-angle.sin(), angle.cos());
        let to_light = dvec2(l.x, -l.y);
        let share = brightness(l);
        // The beam has one width; the strip it lights is wider by 1 / cos.
        let half = 26.0 / share;
        let foot = |k: f64| ground + dvec2(k * half, 0.0);
        // Across the beam, at a right angle to it.
        let across = dvec2(-to_light.y, to_light.x);
        let start = |k: f64| ground + 165.0 * to_light + 26.0 * k * across;
        drawing.area("beam", &[foot(-1.0), foot(1.0), start(1.0), start(-1.0)]);
        for k in [-1.0, -0.5, 0.0, 0.5, 1.0] {
            drawing.arrow("light", start(k), foot(k));
        }
        let side = dvec2(92.0, 0.0);
        drawing.line("ground", ground - side, ground + side);
        drawing.line("lit", foot(-1.0), foot(1.0));
        drawing.arrow("normal", ground, ground - dvec2(0.0, 172.0));
        drawing.label("strong", ground + dvec2(0.0, -180.0), "$n$");
        if 0.0 < angle {
            drawing.arc("angle", ground, 92.0, FRAC_PI_2, FRAC_PI_2 + angle);
            drawing.label_to("", ground + dvec2(-30.0, -100.0), "$α$");
            // The triangle whose leg is the beam's width and whose hypotenuse is
            // the strip.
            let corner = foot(-1.0);
            drawing.line("vector", corner, corner + 52.0 * across);
            drawing.arc("angle", corner, 24.0, 0.0, angle);
            drawing.label("", corner + dvec2(34.0, -8.0), "$α$");
            let beyond = corner + 66.0 * across + dvec2(3.0, 3.0);
            drawing.label("strong", beyond, "$w$");
        } else {
            let top = start(0.0) + dvec2(0.0, 26.0);
            drawing.line("vector", top - 26.0 * across, top + 26.0 * across);
            let beside = top - 38.0 * across.abs() + dvec2(0.0, 5.0);
            drawing.label("strong", beside, "$w$");
        }
        let label =
            format!("$n$·$l$ = cos {name} = {}", (share * 1e3).round() / 1e3);
        drawing.label("", ground + dvec2(0.0, 34.0), &label);
        let strip = format!("strip × {}", (1.0 / share * 1e3).round() / 1e3);
        drawing.label("quiet", ground + dvec2(0.0, 58.0), &strip);
    }
    Figure {
        title: "A beam of light falls on the ground twice: straight down, where it lights a strip as wide as the beam, and at 60 degrees, where the same beam lights a strip twice as wide.",
        caption: "Lambert's cosine law. Both beams are equally wide and carry the same light. At 60° it is \
                  spread over twice the ground, so each point of it gets half: the cosine of the angle.",
        drawing,
    }
}

/// What the step's own diffuse term makes of a white light from the direction `l`,
/// n being up.
fn brightness(l: DVec2) -> f64 {
    let attenuation = Attenuation { a: 1.0, b: 0.0, c: 0.0 };
    let light =
        PointLight { position: l.extend(0.0), diffuse: DVec3::ONE, attenuation };
    diffuse(DVec3::Y, l.extend(0.0), 1.0, &Surface::of(DVec3::ONE), &light).x
}
