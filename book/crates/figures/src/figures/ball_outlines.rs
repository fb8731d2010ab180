use crate::{
    Drawing, Interactive, Numbers, Output, Parameter, View, collect_numbers, discriminant,
    format_fixed, format_number,
};
use glam::{DVec2, DVec3, dvec2};
use std::f64::consts::{FRAC_PI_2, TAU};
use step03_nearest::{Ray, Sphere};

/// The angle between the centres of two balls, seen from the eye, in degrees.
const SPACING: f64 = 20.0;

/// The angle from the centre of a ball to its outline, in degrees.
const HALF_ANGLE: f64 = 8.0;

/// The distance of the balls from the eye; the image plane is at 1.
const DISTANCE: f64 = 0.7;

/// The ball `k`, which is `k` times 20° off the axis.
fn ball(k: i32) -> Sphere {
    let phi = (SPACING * f64::from(k)).to_radians();
    let centre = DISTANCE * DVec3::new(phi.sin(), 0.0, -phi.cos());
    Sphere { centre, radius: DISTANCE * HALF_ANGLE.to_radians().sin() }
}

/// The point of the image plane on the ray to the centre of a ball.
fn image_of_centre(ball: &Sphere) -> DVec2 {
    (ball.centre / -ball.centre.z).truncate()
}

/// The outline of a ball on the image plane: on each line from the image of the centre, the
/// point where the discriminant falls below 0.
fn outline(ball: &Sphere) -> Vec<DVec2> {
    let centre = image_of_centre(ball);
    let edge = |line: DVec2| {
        let [mut inside, mut outside] = [0.0, 8.0];
        for _ in 0..30 {
            let middle = (inside + outside) / 2.0;
            let direction = (centre + middle * line).extend(-1.0);
            let is_outside = discriminant(ball, &Ray { start: DVec3::ZERO, direction }) < 0.0;
            *if is_outside { &mut outside } else { &mut inside } = middle;
        }
        centre + inside * line
    };
    let angles = (0..120).map(|k| TAU * f64::from(k) / 120.0);
    angles.map(|angle| edge(DVec2::from_angle(angle))).collect()
}

/// Equal balls round the eye and their picture, with a field of view to set.
pub struct BallOutlines {
    /// The field of view.
    degrees: f64,
    /// The tangent of half of it.
    tan: f64,
    /// The map of the picture.
    picture: View,
    /// The map of the eye and the balls, seen from above.
    above: View,
}

impl BallOutlines {
    /// The number of the last ball that is whole in the picture.
    fn outermost_ball(&self) -> i32 {
        ((self.degrees / 2.0 - HALF_ANGLE) / SPACING) as i32
    }

    /// A ball in the picture, cut off at its sides, and from above.
    fn draw_ball(&self, drawing: &mut Drawing, ball: &Sphere) {
        let Self { tan, picture, above, .. } = self;
        let centre = above.xy_to_drawing(ball.centre.x, -ball.centre.z);
        let outline = outline(ball);
        let is_visible = outline.iter().any(|point| point.x.abs() < *tan);
        let class = if is_visible { "object" } else { "guide" };
        drawing.circle(class, centre, above.scale.x * ball.radius);
        if is_visible {
            let cut = |point: &DVec2| picture.xy_to_drawing(point.x.clamp(-tan, *tan), point.y);
            drawing.area("object", outline.iter().map(cut));
        }
    }

    /// The rays that touch a ball on both sides, and the two parts of its picture.
    fn draw_cone(&self, drawing: &mut Drawing, ball: &Sphere) {
        let Self { picture, above, .. } = self;
        let outline = outline(ball);
        let (outer, inner) = (outline[0].x, outline[60].x);
        let middle = image_of_centre(ball).x;
        let on_plane = |x: f64| above.xy_to_drawing(x, 1.0);
        for (class, x) in [("ray", inner), ("guide", middle), ("ray", outer)] {
            drawing.line(class, above.origin, on_plane(x));
            drawing.line("leader", on_plane(x), picture.xy_to_drawing(x, 0.0));
        }
        drawing.line("second", on_plane(inner), on_plane(middle));
        drawing.line("accent", on_plane(middle), on_plane(outer));
    }
}

impl Interactive for BallOutlines {
    const NAME: &str = "eggs";
    const TITLE: &str = "Seven balls in an arc round the eye, from above, and over it the picture of those in view. The rays that touch one on the right are cut by the image plane at a slant; in the picture, the balls are the longer the further they are from the middle.";
    const CAPTION: &str = "Equal balls, all at the same distance from the eye. The lower part shows them from above, the upper one their images in a picture with $\\theta = {{#number eggs:angle}}°$. \
                  The last ball that's whole in the picture is {{#number eggs:phi}}° from the axis, and its image {{#number eggs:times}} times as long as it's wide. \
                  The dashed ray goes through its centre, and on the image plane, the outer half of the image is longer than the inner one. <span class='move'>Make $\\theta$ larger.</span>";

    fn parameters() -> Vec<Parameter> {
        vec![Parameter::new(["θ", "field of view", "°"], 100.0, [60.0, 140.0], 1.0)]
    }

    fn from_values(values: &[f64]) -> Self {
        let degrees = values[0];
        let tan = (degrees / 2.0).to_radians().tan();
        let scale = DVec2::splat((222.0 / tan).min(170.0));
        // The image plane is 78 below the middle of the picture.
        let [picture, above] =
            [56.0, 134.0 + scale.y].map(|y| View { origin: dvec2(240.0, y), scale });
        Self { degrees, tan, picture, above }
    }

    fn draw(&self) -> Output {
        let Self { degrees, tan, picture, above } = self;
        let c = above.origin;
        let mut drawing = Drawing::new(480.0, 336.0);
        drawing.rectangle("plane", picture.origin, dvec2(tan * picture.scale.x, 50.0));
        for k in -3..=3 {
            self.draw_ball(&mut drawing, &ball(k));
        }
        let sides = [-tan, *tan].map(|x| above.xy_to_drawing(x, 1.0));
        drawing.line("plane", sides[0], sides[1]);
        self.draw_cone(&mut drawing, &ball(self.outermost_ball()));
        for side in sides {
            drawing.line("ray faint", c, side);
        }
        let half = (degrees / 2.0).to_radians();
        drawing.arc("angle", c, 34.0, [FRAC_PI_2 - half, FRAC_PI_2 + half]);
        drawing.label("", c + dvec2(-12.0, -40.0), "$θ$");
        drawing.dot("eye", c);
        Output::Drawing(drawing)
    }

    fn numbers(&self) -> Numbers {
        let k = self.outermost_ball();
        let outline = outline(&ball(k));
        let largest = outline.iter().copied().fold(DVec2::MIN, DVec2::max);
        let smallest = outline.iter().copied().fold(DVec2::MAX, DVec2::min);
        let size = largest - smallest;
        collect_numbers([
            ("angle", format_number(self.degrees)),
            ("phi", format_number(SPACING * f64::from(k))),
            ("times", format_fixed(size.x / size.y, 1)),
        ])
    }
}
