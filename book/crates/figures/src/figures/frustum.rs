//! OpenGL's frustum, and what lies outside it.

use super::*;
use step01_rays::Camera;
use step03_nearest::{Ray, Sphere};

/// Maps (depth, height) to the drawing. The camera looks to the right.
const VIEW: View = View { origin: dvec2(26.0, 172.0), scale: DVec2::splat(78.0) };

/// The balls: one nearby, one in the middle, and one far away.
const BALLS: [Sphere; 3] = [
    Sphere { centre: DVec3::new(0.0, -0.19, -0.85), radius: 0.12 },
    Sphere { centre: DVec3::new(0.0, 0.45, -2.35), radius: 0.33 },
    Sphere { centre: DVec3::new(0.0, -0.25, -4.72), radius: 0.42 },
];

const NEAR: ParameterId = ParameterId::new("near plane");
const FAR: ParameterId = ParameterId::new("far plane");

const CONTENT: Content = Content::Drawing {
    title: "A view from the side. Rays go from the point C to three balls and meet each of them. The frustum is the part of the view between the near plane and the far plane. One ball is nearer than the near plane and one is beyond the far plane: both are cut away. The ball in between is drawn.",
    caption: "The frustum is the shaded part, and the labels say what OpenGL does with each ball. Our rays start at $C$, \
                  ignore both planes, and meet all three balls. <span class='move'>Drag the planes: balls are cut, and no ray changes.</span>",
    draw,
};

/// OpenGL's frustum from the side, and rays to three balls. The rays also hit the balls outside the
/// frustum.
pub fn figure() -> Figure {
    let handle = |label, depth: ParameterId| {
        let locate = move |values: &ParameterValues| {
            side_view_position(top_and_bottom_rays()[1].at(values[depth]))
        };
        Handle::of_parameter(label, depth, locate, |_, position| VIEW.to_world(position).x)
    };
    Figure {
        parameters: vec![
            Parameter::number(NEAR, "near plane", 1.25, [0.2, 2.4], 20.0),
            Parameter::number(FAR, "far plane", 3.9, [2.6, 5.3], 20.0),
        ],
        handles: vec![handle("the near plane", NEAR), handle("the far plane", FAR)],
        ..Figure::new("frustum", CONTENT)
    }
}

/// The position, in the view from the side, of a point in the world.
fn side_view_position(point: DVec3) -> DVec2 {
    VIEW.xy_to_drawing(-point.z, point.y)
}

/// The rays along the top and the bottom edge of the field of view.
fn top_and_bottom_rays() -> [Ray; 2] {
    let camera = Camera::new(2, 2, 40_f64.to_radians());
    [0.0, 1.0].map(|j| camera.ray(0.5, j))
}

/// The effect of OpenGL's near and far plane on a ball.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Clipping {
    CutAway,
    CutInTwo,
    Drawn,
}

impl Clipping {
    fn new(sphere: &Sphere, [near, far]: [f64; 2]) -> Self {
        let (depth, radius) = (-sphere.centre.z, sphere.radius);
        if depth + radius <= near || depth - radius >= far {
            Self::CutAway
        } else if depth - radius >= near && depth + radius <= far {
            Self::Drawn
        } else {
            Self::CutInTwo
        }
    }

    fn label(self) -> &'static str {
        match self {
            Self::CutAway => "cut away",
            Self::CutInTwo => "cut in two",
            Self::Drawn => "drawn",
        }
    }
}

/// Draws the frustum, the balls with their labels, and the rays that hit the balls.
fn draw(values: &ParameterValues) -> Drawing {
    let (planes, edge_rays) = ([values[NEAR], values[FAR]], top_and_bottom_rays());
    let mut drawing = Drawing::new(334.0);
    let [near, far] = planes.map(|t| edge_rays.map(|ray| side_view_position(ray.at(t))));
    drawing.area("plane", [near[0], far[0], far[1], near[1]]);
    for ray in edge_rays {
        drawing.line("guide", side_view_position(ray.start), side_view_position(ray.at(5.4)));
    }
    for ([upper, lower], class, name) in
        [(near, "quiet over end", "near plane"), (far, "quiet over start", "far plane")]
    {
        drawing.line("plane", upper, lower);
        drawing.label(class, upper - dvec2(0.0, 10.0), name);
    }
    let shading = Shading::new("frustum-ball", TO_LIGHT);
    for sphere in BALLS {
        let clipping = Clipping::new(&sphere, planes);
        let (centre, radius) = (side_view_position(sphere.centre), VIEW.scale.x * sphere.radius);
        if clipping == Clipping::CutAway {
            drawing.circle("behind", centre, radius);
        } else {
            drawing.ball(&shading, centre, DVec2::splat(radius));
        }
        // So that no label overlaps the ray to another ball, the label of a high ball is above the
        // ball, and the label of a low ball is below the ball.
        let label_offset = if sphere.centre.y > 0.0 { -radius - 10.0 } else { radius + 40.0 };
        drawing.label("quiet over", centre + dvec2(0.0, label_offset), clipping.label());
        let ray = Ray { start: DVec3::ZERO, direction: sphere.centre };
        if let Some(t) = sphere.intersect(&ray).first_hit() {
            drawing.line("ray", side_view_position(ray.start), side_view_position(ray.at(t)));
            drawing.dot("hit", side_view_position(ray.at(t)));
        }
    }
    drawing.dot("eye", VIEW.origin);
    drawing.label("strong", VIEW.origin + dvec2(0.0, 28.0), "$C$");
    drawing
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn planes_cut_a_ball_away_or_in_two_or_not_at_all() {
        let ball = Sphere { centre: DVec3::new(0.0, 0.0, -3.0), radius: 1.0 };
        for (planes, clipping) in [
            ([1.0, 2.0], Clipping::CutAway),
            ([1.0, 3.0], Clipping::CutInTwo),
            ([2.0, 4.0], Clipping::Drawn),
            ([2.5, 5.0], Clipping::CutInTwo),
            ([4.0, 5.0], Clipping::CutAway),
        ] {
            assert_eq!(Clipping::new(&ball, planes), clipping, "{planes:?}");
        }
    }
}
