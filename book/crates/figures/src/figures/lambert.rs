//! Lambert's cosine law.

use super::*;
use std::f64::consts::FRAC_PI_2;
use step04_diffuse::{Attenuation, Matte, PointLight, diffuse};

/// Maps the world to the drawing. The origin is the point at which the beam on the right falls on
/// the ground.
const VIEW: View = View { origin: dvec2(352.0, 210.0), scale: DVec2::ONE };

/// The length of the beams.
const LENGTH: f64 = 165.0;

const ANGLE: ParameterId = ParameterId::new("angle");

const CONTENT: Content = Content::Drawing {
    title: "A beam of light falls on the ground twice: straight down, where it lights a strip as wide as the beam, and at an angle, where the same beam lights a wider strip.",
    caption: "Lambert's cosine law. Both beams are equally wide and carry the same light. With the light at {{#number lambert:angle}}° from the normal, each \
                  point of the ground gets {{#number lambert:share}} of what it gets from straight above, which is \
                  the cosine of the angle. From a light below the ground, it gets nothing. <span class='move'>Lower the light to the ground, and then below it. \
                  (A low beam lights more ground than is drawn.)</span>",
    draw,
};

/// A beam of light that falls straight down, and a beam whose angle the reader can set.
pub fn figure() -> Figure {
    let angle = Parameter::number(ANGLE, "angle of the light", 60.0, [0.0, 100.0], 1.0)
        .with_symbol("α")
        .with_unit("°");
    Figure {
        parameters: vec![angle],
        handles: vec![Handle::of_degrees_left_of_up("the light on the right", ANGLE, VIEW, LENGTH)],
        readouts: |values| {
            let share = brightness(direction_left_of_up(values[ANGLE]));
            collect_readouts([
                ("angle", format_number(values[ANGLE])),
                ("share", format_with_max_decimals(share, 3)),
            ])
        },
        ..Figure::new("lambert", CONTENT)
    }
}

/// Draws a beam that falls straight down, and a beam at the angle that the reader has set.
fn draw(values: &ParameterValues) -> Drawing {
    let mut drawing = Drawing::new(300.0);
    draw_beam_on_ground(&mut drawing, dvec2(106.0, 210.0), 0.0);
    draw_beam_on_ground(&mut drawing, VIEW.origin, values[ANGLE]);
    drawing
}

/// Draws a beam at an angle to the normal, the strip of ground that the beam lights, and the
/// numbers below the strip.
fn draw_beam_on_ground(drawing: &mut Drawing, ground: DVec2, degrees: f64) {
    let angle = degrees.to_radians();
    let l = direction_left_of_up(degrees);
    let to_light = dvec2(l.x, -l.y);
    let share = brightness(l);
    // At 90°, rounding leaves the cosine slightly above 0, so a tiny share counts as no light.
    let is_lit = share >= 0.0005;
    // Half the width of the lit strip. The strip's width is the beam's width divided by the cosine.
    let half = 26.0 / l.y;
    // A beam at a grazing angle lights more ground than is drawn, so the beam is cut off where the
    // drawn ground ends.
    let edge = (92.0 / half.abs()).min(1.0);
    let foot = |k: f64| ground + dvec2(k * half, 0.0);
    // A unit vector perpendicular to the beam.
    let across = to_light.perp();
    let start = |k: f64| ground + LENGTH * to_light + 26.0 * k * across;
    drawing.area("beam", [foot(-edge), foot(edge), start(edge), start(-edge)]);
    for k in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        drawing.arrow("light", start(k * edge), foot(k * edge));
    }
    let side = dvec2(92.0, 0.0);
    drawing.line("plane", ground - side, ground + side);
    drawing.arrow("second", ground, ground - dvec2(0.0, 172.0));
    drawing.label("strong", ground + dvec2(0.0, -180.0), "$n$");
    if is_lit {
        drawing.line("lit", foot(-edge), foot(edge));
    }
    if angle > 0.0 {
        drawing.arc("axis", ground, 92.0, [FRAC_PI_2, FRAC_PI_2 + angle]);
        drawing.label("end over", ground + dvec2(-30.0, -100.0), "$α$");
    }
    let is_strip = is_lit && edge == 1.0;
    if is_strip {
        // This line is as long as the beam is wide. It is one leg of a right triangle whose
        // hypotenuse is the strip.
        let corner = foot(-1.0);
        let end = corner + 52.0 * across;
        drawing.line("vector", corner, end);
        if angle > 0.0 {
            drawing.label("strong over", corner + 26.0 * across + 16.0 * to_light, "$w$");
            drawing.arc("axis", corner, 24.0, [0.0, angle]);
            drawing.label("over", corner + dvec2(34.0, -8.0), "$α$");
            drawing.label("over", corner + dvec2(0.0, 22.0), "$A$");
            drawing.label("over", foot(1.0) + dvec2(0.0, 22.0), "$B$");
            drawing.label("over", end + 14.0 * across + dvec2(2.0, 5.0), "$C$");
        } else {
            drawing.label("strong over", ground + dvec2(0.0, 24.0), "$w$");
        }
    }
    let label = format!("cos {degrees}° = {}", format_with_max_decimals(l.y, 3));
    drawing.label("", ground + dvec2(0.0, 56.0), &label);
    let label = if is_lit {
        format!("strip × {}", format_with_max_decimals(1.0 / share, 2))
    } else {
        "max($n$·$l$, 0) = 0: no light".into()
    };
    drawing.label("quiet", ground + dvec2(0.0, 80.0), &label);
}

/// The diffuse term of step 4 for a white light in the direction `l`. The normal points up.
fn brightness(l: DVec2) -> f64 {
    let attenuation = Attenuation { a: 1.0, b: 0.0, c: 0.0 };
    let light = PointLight { position: l.extend(0.0), diffuse: DVec3::ONE, attenuation };
    diffuse(DVec3::Y, l.extend(0.0), 1.0, &Matte::of(DVec3::ONE), &light).x
}
