//! Mistakes with θ and the size of the image plane.

use crate::mistake::book;
use crate::{Mistake, Parts, section};
use step01_rays::Camera;

pub(crate) const ALL: &[Mistake] = &[
    Mistake {
        name: "degrees",
        when: "the angle is in degrees",
        sees: book("The view is far too wide, upside down and mirrored."),
        says: "The tangent takes radians: of 30 radians it is −6.4, and of 30° it is 0.58.",
        change: |parts| {
            let Camera { h_res, v_res, .. } = parts.camera;
            parts.camera = Camera::new(h_res, v_res, theta(parts).to_degrees());
        },
        ..section::PROGRAM.mistake()
    },
    Mistake {
        name: "full-angle",
        when: "the tangent is that of θ, not of θ/2",
        sees: book(
            "The view is three times as wide, so everything is three times as small.",
        ),
        says: "From the middle of the picture to its side is half of the angle.",
        change: |parts| parts.camera = wide(parts, theta(parts).tan()),
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "half-tangent",
        when: "half the tangent of θ is taken for the tangent of θ/2",
        sees: book("The view is too wide, and everything is a third smaller."),
        says: "The half belongs inside: tan(θ/2), not tan(θ)/2.",
        change: |parts| parts.camera = wide(parts, theta(parts).tan() / 2.0),
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "no-tangent",
        when: "θ/2 stands where its tangent should",
        sees: book(
            "The view is a tenth too narrow, and everything a tenth larger.",
        ),
        says: "The image plane is flat: its half width is tan(θ/2), not θ/2.",
        change: |parts| parts.camera = wide(parts, theta(parts) / 2.0),
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "no-angle",
        when: "the image plane runs from −1 to 1 whatever the angle is",
        sees: book("The view is too wide, exactly as with `--fov 90`."),
        says: "Its half width is tan(θ/2), and that is 1 for 90° only.",
        change: |parts| parts.camera = wide(parts, 1.0),
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "upright-angle",
        when: "θ is taken from top to bottom",
        sees: book(
            "The view is too wide, and everything smaller by the aspect ratio.",
        ),
        says: "OpenGL's angle is vertical, the lecture's goes from left to right.",
        change: |parts| {
            let tan = parts.camera.matrix.z_axis.y;
            parts.camera = wide(parts, parts.camera.matrix.z_axis.x.powi(2) / tan);
        },
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "square-view",
        when: "the view is as high as it is wide, though the picture is not",
        sees: book(
            "Everything is squeezed from top to bottom: spheres are flat ovals.",
        ),
        says: "Pixels are square where D_v is as long as D_u, with hRes − 1 below both.",
        change: |parts| high(parts, 1.0),
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "ratio-upside-down",
        when: "the aspect ratio is upside down",
        sees: book("Everything is squeezed very flat."),
        says: "The height of the view is its width times vRes/hRes, not hRes/vRes.",
        change: |parts| {
            let Camera { h_res, v_res, .. } = parts.camera;
            high(parts, f64::from(h_res) / f64::from(v_res));
        },
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "too-many-steps",
        when: "hRes and vRes stand where hRes − 1 and vRes − 1 should",
        sees: book(
            "It looks right, but every edge is off by a fraction of a pixel.",
        ),
        says: "Between hRes rays there are hRes − 1 steps.",
        change: |parts| {
            let Camera { h_res, v_res, .. } = parts.camera;
            let columns = f64::from(h_res);
            let matrix = &mut parts.camera.matrix;
            let tan = -matrix.z_axis.x;
            matrix.x_axis.x = 2.0 * tan / columns;
            matrix.y_axis.y = -2.0 * tan / columns;
            matrix.z_axis.y = f64::from(v_res) / columns * tan;
        },
        ..section::CAMERA.mistake()
    },
    Mistake {
        name: "edge-to-edge",
        when: "θ reaches from the left edge of the picture to its right edge",
        sees: book(
            "It looks right, but every edge is off by a fraction of a pixel.",
        ),
        says: "Many courses measure it so; the lecture's θ lies between the middles of the \
         outermost pixels, which are hRes − 1 steps apart.",
        change: |parts| {
            let columns = f64::from(parts.camera.h_res);
            let tan = -parts.camera.matrix.z_axis.x;
            parts.camera = wide(parts, tan * (columns - 1.0) / columns);
        },
        ..section::CAMERA.mistake()
    },
];

/// θ of the camera, in radians.
fn theta(parts: &Parts) -> f64 {
    2.0 * (-parts.camera.matrix.z_axis.x).atan()
}

/// The camera whose image plane is `tan` wide on either side.
fn wide(parts: &Parts, tan: f64) -> Camera {
    Camera::new(parts.camera.h_res, parts.camera.v_res, 2.0 * tan.atan())
}

/// Makes the view `ratio` times as high as it is wide.
fn high(parts: &mut Parts, ratio: f64) {
    let rows = f64::from(parts.camera.v_res.max(2) - 1);
    let matrix = &mut parts.camera.matrix;
    matrix.z_axis.y = -matrix.z_axis.x * ratio;
    matrix.y_axis.y = -2.0 * matrix.z_axis.y / rows;
}
