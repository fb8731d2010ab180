use crate::Drawing;
use glam::{DVec2, DVec3, dvec2};
use step01_rays::{Camera, direction_colour, render};

/// The image plane with a dot for each pixel, and the rays through its corners.
pub fn draw_view_pyramid(drawing: &mut Drawing, camera: &Camera, project: impl Fn(DVec3) -> DVec2) {
    let c = project(camera.centre);
    let [right, bottom] = [camera.h_res, camera.v_res].map(|n| f64::from(n - 1));
    let corners = [(0.0, 0.0), (right, 0.0), (right, bottom), (0.0, bottom)];
    let rays = corners.map(|(i, j)| camera.ray(i, j));
    drawing.area("plane", rays.map(|ray| project(ray.at(1.0))));
    for ray in rays {
        drawing.line("ray faint", c, project(ray.at(1.0)));
        drawing.line("guide", project(ray.at(1.0)), project(ray.at(1.26)));
    }
    drawing.line("guide", c, project(DVec3::NEG_Z));
    let image = render(camera, 1, direction_colour);
    let place = |i: f64, j: f64| project(camera.ray(i, j).at(1.0));
    let radius = (0.36 * place(0.0, 0.0).distance(place(1.0, 0.0))).min(5.0);
    for (i, j, pixel) in image.enumerate_pixels() {
        drawing.pixel(place(f64::from(i), f64::from(j)), radius, pixel.0);
    }
}

/// V_0, D_u and D_v, and the steps that lead to a pixel.
pub fn draw_steps(
    drawing: &mut Drawing,
    camera: &Camera,
    pixel: DVec2,
    project: impl Fn(DVec3) -> DVec2,
) {
    let (d_u, d_v, v_0) = (camera.matrix.x_axis, camera.matrix.y_axis, camera.matrix.z_axis);
    let (c, first) = (project(camera.centre), project(v_0));
    let above = project(camera.ray(pixel.x, 0.0).at(1.0));
    drawing.line("way", first, above);
    drawing.line("way", above, project(camera.ray(pixel.x, pixel.y).at(1.0)));
    drawing.arrow("vector", c, first);
    let label = (c + first) / 2.0 + dvec2(-6.0, -12.0);
    drawing.label_ending_at("strong", label, "$V_0$");
    drawing.arrow("accent", first, project(v_0 + d_u));
    drawing.arrow("second", first, project(v_0 + d_v));
    drawing.label("accent", project(v_0 + 0.6 * d_u) + dvec2(2.0, -12.0), "$D_u$");
    let label = project(v_0 + 0.75 * d_v) + dvec2(9.0, 6.0);
    drawing.label_starting_at("second over", label, "$D_v$");
}
