//! The rays of a small camera.

use super::*;
use crate::pictures::step01::{FIELD_OF_VIEW, aspect_ratio_parameter, camera};
use course::FOV_DEGREES;
use glam::{DMat2, DQuat};
use step01_rays::{Camera, Ray, direction_colour, render};

const COLUMNS: ParameterId = ParameterId::new("columns");
const I: ParameterId = ParameterId::new("i");
const J: ParameterId = ParameterId::new("j");

const CONTENT: Content = Content::Drawing {
    title: "A pyramid with its tip at C and the image plane, a grid of 8 by 5 points in pale colours, as its base. The arrow V0 goes from C to the top left point, Du from there one point right, Dv one point down. A ray goes from C through the point i = 5, j = 3.",
    caption: "The pyramid of rays of a camera with {{#number camera:columns}} columns and {{#number camera:rows}} rows, each point in the colour \
                  of its pixel. $V_0$ leads from $C$ to the top left one, $D_u$ one column to the right, $D_v$ one row \
                  down. From the top left pixel, {{#number camera:i}} times $D_u$ and {{#number camera:j}} times $D_v$ lead to $V =$ {{#number camera:V}}. <span class='move'>Drag the ray to another pixel.</span>",
    draw,
};

/// A small camera: the pyramid of its rays, its picture on the image plane, and the ray through one
/// pixel.
pub fn figure() -> Figure {
    let locate = |values: &ParameterValues| {
        let figure = CameraFigure::new(values);
        Some(figure.project(figure.ray().at(1.0)))
    };
    let pixel_at =
        |values: &ParameterValues, position| Some(CameraFigure::new(values).pixel_at(position));
    Figure {
        parameters: vec![
            Parameter::number(FIELD_OF_VIEW, "field of view", FOV_DEGREES, [20.0, 90.0], 1.0)
                .with_symbol("θ")
                .with_unit("°"),
            aspect_ratio_parameter(),
            Parameter::number(COLUMNS, "columns", 8.0, [3.0, 16.0], 1.0).with_symbol("hRes"),
            Parameter::number(I, "column", 5.0, [0.0, 15.0], 1.0)
                .with_symbol("i")
                .with_axis(Axis::Right),
            Parameter::number(J, "row", 3.0, [0.0, 11.0], 1.0)
                .with_symbol("j")
                .with_axis(Axis::Down),
        ],
        handles: vec![Handle::new("the pixel of the ray", [I, J], locate, pixel_at)],
        readouts,
        ..Figure::new("camera", CONTENT)
    }
}

struct CameraFigure {
    camera: Camera,
    pixel: DVec2,
}

impl CameraFigure {
    fn new(values: &ParameterValues) -> Self {
        let camera = camera(values, values[COLUMNS] as u32);
        Self { camera, pixel: clamp_to_picture(&camera, dvec2(values[I], values[J])) }
    }

    fn ray(&self) -> Ray {
        self.camera.ray(self.pixel.x, self.pixel.y)
    }

    /// Projects a point in the world to the drawing: rotates the point about the y axis, then about
    /// the x axis, and drops its z. A wide field of view is drawn at a smaller scale.
    fn project(&self, point: DVec3) -> DVec2 {
        let turn = DQuat::from_rotation_x(0.3) * DQuat::from_rotation_y(-0.72);
        let scale = (144.35 / -self.camera.matrix.z_axis.x).min(250.0);
        let view = View { origin: dvec2(82.0, 204.0), scale: DVec2::splat(scale) };
        view.to_drawing((turn * point).truncate())
    }

    /// Returns the pixel whose point on the image plane is drawn at a position. The pixel's
    /// coordinates are fractional, and are clamped to the picture.
    fn pixel_at(&self, position: DVec2) -> DVec2 {
        let project = |i, j| self.project(self.camera.ray(i, j).at(1.0));
        let first_point = project(0.0, 0.0);
        let steps =
            DMat2::from_cols(project(1.0, 0.0) - first_point, project(0.0, 1.0) - first_point);
        clamp_to_picture(&self.camera, steps.inverse() * (position - first_point))
    }

    /// Draws the image plane with a dot for each pixel, and the rays through the plane's corners.
    fn draw_pyramid(&self, drawing: &mut Drawing) {
        let Self { camera, .. } = self;
        let c = self.project(camera.centre);
        let [right, bottom] = [camera.h_res, camera.v_res].map(|n| f64::from(n - 1));
        let corners = [(0.0, 0.0), (right, 0.0), (right, bottom), (0.0, bottom)];
        let rays = corners.map(|(i, j)| camera.ray(i, j));
        drawing.area("plane", rays.map(|ray| self.project(ray.at(1.0))));
        for ray in rays {
            drawing.line("ray faint", c, self.project(ray.at(1.16)));
        }
        drawing.line("guide", c, self.project(DVec3::NEG_Z));
        let position = |i: f64, j: f64| self.project(camera.ray(i, j).at(1.0));
        let radius = (0.36 * position(0.0, 0.0).distance(position(1.0, 0.0))).min(5.0);
        for (i, j, pixel) in render(camera, 1, direction_colour).enumerate_pixels() {
            drawing.coloured_disc(position(f64::from(i), f64::from(j)), radius, pixel.0);
        }
    }

    /// Draws V_0, D_u and D_v, and the way to the chosen pixel: along the top row, then down.
    fn draw_vectors_to_pixel(&self, drawing: &mut Drawing) {
        let Camera { centre, matrix, .. } = self.camera;
        let (d_u, d_v, v_0) = (matrix.x_axis, matrix.y_axis, matrix.z_axis);
        let (c, first_point) = (self.project(centre), self.project(v_0));
        let point_above = self.project(self.camera.ray(self.pixel.x, 0.0).at(1.0));
        drawing.path("ray faint", [first_point, point_above, self.project(self.ray().at(1.0))]);
        drawing.arrow("vector", c, first_point);
        drawing.label("strong end", (c + first_point) / 2.0 + dvec2(-6.0, -12.0), "$V_0$");
        for (class, step, name, shift) in [
            ("accent", d_u, "$D_u$", dvec2(2.0, -12.0)),
            ("second", d_v, "$D_v$", dvec2(21.0, 6.0)),
        ] {
            drawing.arrow(class, first_point, self.project(v_0 + step));
            let middle = self.project(v_0 + 0.7 * step);
            drawing.label(&format!("{class} over"), middle + shift, name);
        }
    }
}

/// Clamps a pixel's coordinates, which may be fractions, to the picture.
fn clamp_to_picture(camera: &Camera, pixel: DVec2) -> DVec2 {
    let last_pixel = dvec2(f64::from(camera.h_res), f64::from(camera.v_res)) - 1.0;
    pixel.clamp(DVec2::ZERO, last_pixel)
}

/// Draws the pyramid of rays, the vectors that lead to the chosen pixel, and the ray through this
/// pixel.
fn draw(values: &ParameterValues) -> Drawing {
    let figure = CameraFigure::new(values);
    let c = figure.project(DVec3::ZERO);
    let mut drawing = Drawing::new(310.0);
    figure.draw_pyramid(&mut drawing);
    figure.draw_vectors_to_pixel(&mut drawing);
    drawing.dot("eye", c);
    drawing.label("strong end", c + dvec2(-12.0, 6.0), "$C$");
    drawing.arrow("ray", c, figure.project(figure.ray().at(1.26)));
    drawing
}

fn readouts(values: &ParameterValues) -> Readouts {
    let figure = CameraFigure::new(values);
    let CameraFigure { camera, pixel } = &figure;
    collect_readouts([
        ("columns", camera.h_res.to_string()),
        ("rows", camera.v_res.to_string()),
        ("i", format_number(pixel.x)),
        ("j", format_number(pixel.y)),
        ("V", format_vector(figure.ray().direction)),
    ])
}
