use super::Figure;
use crate::svg::Drawing;
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::FRAC_PI_3;
use step01_rays::Camera;

/// The frustum of a small camera, with D_u, D_v and V_0, seen from the right and a
/// little above.
pub fn figure() -> Figure {
    let camera = Camera::new(8, 5, FRAC_PI_3);
    let (d_u, d_v, v_0) =
        (camera.matrix.x_axis, camera.matrix.y_axis, camera.matrix.z_axis);
    let at = |i: f64, j: f64| project(camera.ray(i, j).at(1.0));
    let far = |i: f64, j: f64| project(camera.ray(i, j).at(1.26));
    let c = project(camera.centre);
    let (right, bottom) = (7.0, 4.0);
    let corners = [(0.0, 0.0), (right, 0.0), (right, bottom), (0.0, bottom)];
    let mut drawing = Drawing::new(480.0, 310.0);
    drawing.area("plane", &corners.map(|(i, j)| at(i, j)));
    for i in (0..8).map(f64::from) {
        drawing.line("grid", at(i, 0.0), at(i, bottom));
    }
    for j in (0..5).map(f64::from) {
        drawing.line("grid", at(0.0, j), at(right, j));
    }
    for (i, j) in corners {
        drawing.line("ray faint", c, at(i, j));
        drawing.line("guide", at(i, j), far(i, j));
    }
    drawing.line("guide", c, project(DVec3::NEG_Z));
    drawing.arrow("vector", c, project(v_0));
    let label = (c + project(v_0)) / 2.0 + dvec2(-6.0, -12.0);
    drawing.label_to("strong", label, "$V_0$");
    drawing.arrow("accent", project(v_0), project(v_0 + d_u));
    drawing.arrow("second", project(v_0), project(v_0 + d_v));
    drawing.label("accent", project(v_0 + 0.6 * d_u) + dvec2(2.0, -12.0), "$D_u$");
    let label = project(v_0 + 0.75 * d_v) + dvec2(9.0, 6.0);
    drawing.label_from("second", label, "$D_v$");
    drawing.dot("eye", c);
    drawing.label_to("strong", c + dvec2(-12.0, 6.0), "$C$");
    let tip = project(camera.ray(5.0, 3.0).at(1.42));
    drawing.arrow("ray", c, tip);
    drawing.dot("ray", at(5.0, 3.0));
    drawing.label_from("quiet", tip + dvec2(10.0, 5.0), "$i$ = 5, $j$ = 3");
    let corner = dvec2(44.0, 286.0) - c;
    for (axis, name) in [(DVec3::X, "$x$"), (DVec3::Y, "$y$"), (DVec3::Z, "$z$")] {
        let tip = project(0.16 * axis);
        drawing.arrow("axis", c + corner, tip + corner);
        let label = tip + 0.32 * (tip - c) + corner + dvec2(0.0, 5.0);
        drawing.label("quiet", label, name);
    }
    Figure {
        title: "A pyramid with its tip at C and the image plane, a grid of 8 by 5 points, as its base. The arrow V0 goes from C to the top left point, Du from there one point right, Dv one point down. A ray goes from C through the point i = 5, j = 3.",
        caption: "The pyramid of rays of a camera with 8 columns and 5 rows. $V_0$ leads from $C$ to the top left \
                  point, $D_u$ one column to the right, $D_v$ one row down. The point $i = 5$, $j = 3$ \
                  is five steps of the one and three of the other away.",
        drawing,
    }
}

/// Where a point of the world is in the drawing: turned about y, tilted, without
/// perspective.
fn project(point: DVec3) -> DVec2 {
    let turned = glam::DQuat::from_rotation_x(0.3)
        * glam::DQuat::from_rotation_y(-0.72)
        * point;
    dvec2(82.0 + 250.0 * turned.x, 216.0 - 250.0 * turned.y)
}
