use super::view_pyramid::{draw_steps, draw_view_pyramid};
use crate::aspect_ratio::{aspect_ratio_parameter, camera};
use crate::{
    Drawing, Handle, Interactive, Numbers, Output, Parameter, View, array, collect_numbers,
    format_number, format_vector,
};
use glam::{DMat2, DQuat, DVec2, DVec3, dvec2};
use step01_rays::{Camera, Ray};

/// The pyramid of rays of a small camera, its picture on the image plane, and the ray of
/// one of the pixels.
pub struct CameraFigure {
    camera: Camera,
    pixel: DVec2,
}

impl CameraFigure {
    /// The ray of the pixel.
    fn ray(&self) -> Ray {
        self.camera.ray(self.pixel.x, self.pixel.y)
    }

    /// The place in the drawing of a point of the world: turned about y, tilted, without
    /// perspective. A wide view is drawn smaller, so that the lowest ray stays inside.
    fn project(&self, point: DVec3) -> DVec2 {
        let turn = DQuat::from_rotation_x(0.3) * DQuat::from_rotation_y(-0.72);
        let Camera { h_res, v_res, matrix, .. } = self.camera;
        let last = self.camera.ray(f64::from(h_res - 1), f64::from(v_res - 1));
        let depth = -(turn * last.direction).y;
        let scale = (144.35 / -matrix.z_axis.x).min(58.0 / depth.max(0.2)).min(250.0);
        let view = View { origin: dvec2(82.0, 216.0), scale: DVec2::splat(scale) };
        view.to_drawing((turn * point).truncate())
    }

    /// The pixel at a place on the image plane.
    fn pixel_at(&self, place: DVec2) -> DVec2 {
        let project = |i, j| self.project(self.camera.ray(i, j).at(1.0));
        let first = project(0.0, 0.0);
        let steps = DMat2::from_cols(project(1.0, 0.0) - first, project(0.0, 1.0) - first);
        nearest_pixel(&self.camera, steps.inverse() * (place - first))
    }
}

/// The pixel of the camera that is nearest to `pixel`, still with fractions.
fn nearest_pixel(camera: &Camera, pixel: DVec2) -> DVec2 {
    let last = dvec2(f64::from(camera.h_res), f64::from(camera.v_res)) - 1.0;
    pixel.clamp(DVec2::ZERO, last)
}

impl Interactive for CameraFigure {
    const NAME: &str = "camera";
    const TITLE: &str = "A pyramid with its tip at C and the image plane, a grid of 8 by 5 points in pale colours, as its base. The arrow V0 goes from C to the top left point, Du from there one point right, Dv one point down. A ray goes from C through the point i = 5, j = 3.";
    const CAPTION: &str = "The pyramid of rays of a camera with {{#number camera:columns}} columns and {{#number camera:rows}} rows, each point in the colour \
                  of its pixel. $V_0$ leads from $C$ to the top left one, $D_u$ one column to the right, $D_v$ one row \
                  down. From the top left pixel, {{#number camera:i}} times $D_u$ and {{#number camera:j}} times $D_v$ lead to $V =$ {{#number camera:V}}. <span class='move'>Drag the ray to another pixel.</span>";

    fn parameters() -> Vec<Parameter> {
        vec![
            Parameter::new(["θ", "field of view", "°"], 60.0, [20.0, 120.0], 1.0),
            aspect_ratio_parameter(),
            Parameter::new(["hRes", "columns", ""], 8.0, [2.0, 16.0], 1.0),
            Parameter::new(["i", "column", ""], 5.0, [0.0, 15.0], 1.0),
            Parameter::new(["j", "row", ""], 3.0, [0.0, 11.0], 1.0),
        ]
    }

    fn from_values(values: &[f64]) -> Self {
        let [degrees, choice, columns, i, j] = array(values);
        let camera = camera(degrees, choice, columns);
        Self { camera, pixel: nearest_pixel(&camera, dvec2(i, j)) }
    }

    fn handles() -> Vec<Handle> {
        let locate = |figure: &Self| Some(figure.project(figure.ray().at(1.0)));
        let handle = Self::handle("the pixel of the ray", [3, 4], locate, Self::pixel_at);
        vec![Handle { is_down: true, ..handle }]
    }

    fn draw(&self) -> Output {
        let Self { camera, pixel } = self;
        let project = |point: DVec3| self.project(point);
        let c = project(DVec3::ZERO);
        let mut drawing = Drawing::new(480.0, 310.0);
        draw_view_pyramid(&mut drawing, camera, project);
        draw_steps(&mut drawing, camera, *pixel, project);
        drawing.dot("eye", c);
        drawing.label_ending_at("strong", c + dvec2(-12.0, 6.0), "$C$");
        let tip = project(self.ray().at(1.42));
        drawing.arrow("ray", c, tip);
        let label = format!("$i$ = {}, $j$ = {}", pixel.x, pixel.y);
        if tip.x < 380.0 {
            drawing.label_starting_at("quiet over", tip + dvec2(10.0, 5.0), &label);
        } else {
            let end = (tip + dvec2(14.0, -12.0)).clamp(dvec2(0.0, 16.0), dvec2(474.0, 300.0));
            drawing.label_ending_at("quiet over", end, &label);
        }
        let corner = dvec2(44.0, 286.0);
        for (axis, name) in [(DVec3::X, "$x$"), (DVec3::Y, "$y$"), (DVec3::Z, "$z$")] {
            let arrow = (project(axis) - c) * 40.0 / (project(DVec3::Y) - c).length();
            drawing.arrow("axis", corner, corner + arrow);
            drawing.label("quiet", corner + 1.32 * arrow + dvec2(0.0, 5.0), name);
        }
        Output::Drawing(drawing)
    }

    fn numbers(&self) -> Numbers {
        let Self { camera, pixel } = self;
        collect_numbers([
            ("columns", camera.h_res.to_string()),
            ("rows", camera.v_res.to_string()),
            ("i", format_number(pixel.x)),
            ("j", format_number(pixel.y)),
            ("V", format_vector(self.ray().direction)),
        ])
    }
}
