use super::pyramid::{draw_pyramid, draw_steps};
use crate::live::{Handle, Knob, Live, Sight, named, number, vector};
use crate::pictures::step01::{aspect_ratio, camera};
use crate::svg::Drawing;
use glam::{DMat2, DQuat, DVec2, DVec3, dvec2};
use step01_rays::Ray;

/// The pixel that is chosen, or the nearest to it that there is.
fn pixel_of(values: &[f64]) -> DVec2 {
    inside(values, dvec2(values[3], values[4]))
}

fn inside(values: &[f64], pixel: DVec2) -> DVec2 {
    let camera = camera(values);
    let last = dvec2(f64::from(camera.h_res), f64::from(camera.v_res)) - 1.0;
    pixel.clamp(DVec2::ZERO, last)
}

/// Its ray.
fn chosen(values: &[f64]) -> Ray {
    let pixel = pixel_of(values);
    camera(values).ray(pixel.x, pixel.y)
}

/// Where a point of the world is in the drawing: turned about y, tilted, without
/// perspective. A wide view is drawn smaller.
fn project(values: &[f64], point: DVec3) -> DVec2 {
    let side = -camera(values).matrix.z_axis.x;
    let scale = 250.0 * (0.5774 / side).min(1.0);
    let turned =
        DQuat::from_rotation_x(0.3) * DQuat::from_rotation_y(-0.72) * point;
    dvec2(82.0, 216.0) + scale * dvec2(turned.x, -turned.y)
}

/// The column and the row, with fractions, at a place on the image plane.
fn pixel_at(values: &[f64], place: DVec2) -> DVec2 {
    let camera = camera(values);
    let at = |i: f64, j: f64| project(values, camera.ray(i, j).at(1.0));
    let first = at(0.0, 0.0);
    let steps = DMat2::from_cols(at(1.0, 0.0) - first, at(0.0, 1.0) - first);
    steps.inverse() * (place - first)
}

fn draw(values: &[f64]) -> Drawing {
    let camera = camera(values);
    let project = |point: DVec3| project(values, point);
    let c = project(camera.centre);
    let mut drawing = Drawing::new(480.0, 310.0);
    draw_pyramid(&mut drawing, &camera, project);
    draw_steps(&mut drawing, &camera, pixel_of(values), project);
    drawing.dot("eye", c);
    drawing.label_to("strong", c + dvec2(-12.0, 6.0), "$C$");
    let tip = project(chosen(values).at(1.42));
    drawing.arrow("ray", c, tip);
    let DVec2 { x: i, y: j } = pixel_of(values);
    let label = format!("$i$ = {i}, $j$ = {j}");
    if tip.x < 380.0 {
        drawing.label_from("quiet over", tip + dvec2(10.0, 5.0), &label);
    } else {
        let place =
            (tip + dvec2(14.0, -12.0)).clamp(dvec2(0.0, 16.0), dvec2(474.0, 300.0));
        drawing.label_to("quiet over", place, &label);
    }
    let corner = dvec2(44.0, 286.0);
    for (axis, name) in [(DVec3::X, "$x$"), (DVec3::Y, "$y$"), (DVec3::Z, "$z$")] {
        let along = (project(axis) - c) * 40.0 / (project(DVec3::Y) - c).length();
        drawing.arrow("axis", corner, corner + along);
        drawing.label("quiet", corner + 1.32 * along + dvec2(0.0, 5.0), name);
    }
    drawing
}

/// The frustum of a small camera, its picture on the image plane, and the ray of one
/// of the pixels.
pub fn figure() -> Live {
    Live {
        title: "A pyramid with its tip at C and the image plane, a grid of 8 by 5 points in pale colours, as its base. The arrow V0 goes from C to the top left point, Du from there one point right, Dv one point down. A ray goes from C through the point i = 5, j = 3.",
        caption: "The pyramid of rays of a camera with {{#number frustum:columns}} columns and {{#number frustum:rows}} rows, each point in the colour \
                  of its pixel. $V_0$ leads from $C$ to the top left one, $D_u$ one column to the right, $D_v$ one row \
                  down. From there, {{#number frustum:i}} times $D_u$ and {{#number frustum:j}} times $D_v$ lead to $V =$ {{#number frustum:V}}. <span class='move'>Drag the ray to another pixel.</span>",
        knobs: vec![
            Knob::new(["θ", "field of view", "°"], 60.0, [20.0, 120.0], 1.0),
            aspect_ratio(),
            Knob::new(["hRes", "columns", ""], 8.0, [2.0, 16.0], 1.0),
            Knob::turned(5.0, [0.0, 15.0], 1.0),
            Knob::turned(3.0, [0.0, 11.0], 1.0),
        ],
        handles: vec![Handle {
            is_down: true,
            ..Handle::new(
                "the pixel of the ray",
                [3, 4],
                |_, values| project(values, chosen(values).at(1.0)),
                |_, values, to| inside(values, pixel_at(values, to)),
            )
        }],
        numbers: |values| {
            let (camera, pixel) = (camera(values), pixel_of(values));
            named([
                ("columns", camera.h_res.to_string()),
                ("rows", camera.v_res.to_string()),
                ("i", number(pixel.x)),
                ("j", number(pixel.y)),
                ("V", vector(chosen(values).direction)),
            ])
        },
        ..Live::new("frustum", |values| Sight::Drawing(draw(values)))
    }
}
