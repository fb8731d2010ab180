//! Tests of the solutions to the exercises, and of the scenes made from students' names.

mod fast_simd;
mod named_scene;
mod step01;
mod step02;
mod step03;
mod step04;
mod step05;

use course::examples::own_scene;
use course::{DrawPicture, describe_difference, read_locked_picture};
use glam::DMat3;
use step01_rays::Camera;
use support::{camera, locked_pictures};

/// Declares programs as modules. The macro hides the modules from rustfmt. Otherwise, rustfmt would
/// format the programs' files with the workspace's settings instead of `steps/.rustfmt.toml`.
macro_rules! programs {
    ($($name:ident: $path:literal,)*) => {
        $(#[allow(dead_code, reason = "`main` is never called here")] #[path = $path] mod $name;)*
    };
}

programs! {
    step01_starter: "../../steps/step01_rays/examples/step01_starter.rs",
    step02_starter: "../../steps/step02_sphere/examples/step02_starter.rs",
    step03_starter: "../../steps/step03_nearest/examples/step03_starter.rs",
    step04_starter: "../../steps/step04_diffuse/examples/step04_starter.rs",
    step05_starter: "../../steps/step05_phong/examples/step05_starter.rs",
    fast: "../../steps/step05_phong/examples/fast.rs",
}

#[test]
fn starters_fast_and_own_scene_draw_the_pictures_of_their_steps() {
    let pictures: [(_, DrawPicture); 7] = [
        ("step01_rays", step01_starter::picture),
        ("step02_sphere", step02_starter::picture),
        ("step03_nearest", step03_starter::picture),
        ("step04_diffuse", step04_starter::picture),
        ("step05_phong", step05_starter::picture),
        ("step05_phong", fast::picture),
        ("step05_phong", own_scene::picture),
    ];
    for (name, draw) in pictures {
        let locked = read_locked_picture(name).expect("the locked picture can be read");
        assert_eq!(describe_difference(&locked, &draw(&camera(), 1)), None, "{name}");
    }
}

/// Replaces each number in the camera's matrix with its `neighbour`, which is the next or the
/// previous f64. Integers stay as they are, because the formulas give integers exactly, no matter
/// how the terms are ordered.
fn perturb_camera(camera: &Camera, neighbour: fn(f64) -> f64) -> Camera {
    let perturb = |x: f64| if x.fract() == 0.0 { x } else { neighbour(x) };
    let matrix = camera.matrix.to_cols_array().map(perturb);
    Camera { matrix: DMat3::from_cols_array(&matrix), ..*camera }
}

/// The camera's matrix contains a tangent. On a different platform, the last bit of the tangent may
/// be different. If a reader writes the terms of a formula in a different order, the last bit of a
/// number in the matrix may be different, too.
///
/// We skip the picture `speckled`, because this picture shows rounding errors on purpose. Its
/// camera has the tangent as a literal, so the tangent is the same on every platform.
#[test]
#[ignore = "takes a minute: cargo test -- --include-ignored"]
fn pictures_do_not_depend_on_the_last_bit_of_the_camera() {
    let mut faults = vec![];
    for (name, camera, draw) in locked_pictures() {
        if name == "speckled" {
            continue;
        }
        let picture = draw(&camera, 1);
        for neighbour in [f64::next_up, f64::next_down] {
            let perturbed_picture = draw(&perturb_camera(&camera, neighbour), 1);
            let difference = describe_difference(&picture, &perturbed_picture);
            faults.extend(difference.map(|text| format!("{name}: {text}")));
        }
    }
    assert!(faults.is_empty(), "{faults:#?}");
}
