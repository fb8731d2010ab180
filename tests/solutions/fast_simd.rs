//! Tests that the example `fast` draws exactly the same bytes as `render` with `colour`.

use super::fast::draw;
use course::environment::is_thorough;
use course::examples::look_at::look_at;
use course::{camera_with_size, generate_scene};
use fearless_simd::{Level, Simd};
use glam::{DMat3, DVec3};
use step05_phong::*;
use support::{RandomInputs, test_law};

/// Returns every set of vector instructions that this machine supports.
///
/// `fearless_simd` also has a fallback without vector instructions. We don't test the fallback. For
/// a target whose processors all have vector instructions, the fallback isn't even compiled.
/// Compiling the fallback anyway would cost a cold `cargo test` nearly a minute of CPU time.
fn simd_levels() -> Vec<Level> {
    let best = Level::new();
    let mut levels = vec![Level::baseline(), best];
    #[cfg(target_arch = "x86_64")]
    {
        levels.extend(best.as_sse4_2().map(Simd::level));
        levels.extend(best.as_avx2().map(Simd::level));
    }
    levels
}

/// Asserts that `fast` draws the same bytes as `render`, with every set of vector instructions.
fn assert_fast_draws(camera: &Camera, samples: u32, scene: &Scene<Material, Light>) {
    let expected = render(camera, samples, |ray| colour(scene, ray));
    for level in simd_levels() {
        let image = draw(level, camera, samples, scene);
        assert!(image == expected, "wrong bytes with {level:?}: {camera:?}, {samples}, {scene:?}");
    }
}

/// A random scene, with small and large spheres in any position, and up to four lights. A few
/// spheres occur twice, usually with different materials.
fn random_scene(random: &mut RandomInputs) -> Scene<Material, Light> {
    let mut scene = generate_scene(&random.index(10_000).to_string());
    let objects = scene.objects.clone();
    let count = [0, 1, 5, 40, 300][random.index(5)];
    scene.objects = (0..count)
        .map(|k| {
            let mut object = objects[k % objects.len()];
            object.sphere.centre = random.number(0.1, 20.0) * random.unit_vector();
            object.sphere.radius = 10_f64.powf(random.number(-3.0, 1.0));
            object
        })
        .collect();
    for _ in 0..random.index(4).min(count) {
        let copied = scene.objects[random.index(count)];
        let index = random.index(count);
        scene.objects.insert(index, copied.with_material(objects[random.index(3)].material));
    }
    scene.lights = (0..random.index(5)).map(|k| scene.lights[k % scene.lights.len()]).collect();
    for light in &mut scene.lights {
        light.point_light.position = random.number(0.0, 9.0) * random.unit_vector();
    }
    scene
}

/// A random camera, with a narrow or wide field of view, in any position and orientation, sometimes
/// mirrored. The camera's picture may be wider than the tiles in which `fast` draws.
fn random_camera(random: &mut RandomInputs) -> Camera {
    let angle = [0.001, 1.0, 60.0, 120.0, 179.0, 179.999][random.index(6)];
    let size = (2 + random.index(80) as u32, 1 + random.index(70) as u32);
    let unturned_camera = Camera::new(size.0, size.1, f64::to_radians(angle));
    let (position, roll) = (random.point(), random.number(-3.0, 3.0));
    let mut camera = look_at(&unturned_camera, position, DVec3::NEG_Z, roll);
    if random.index(3) == 0 {
        camera.matrix = DMat3::from_diagonal(DVec3::new(-1.0, 1.0, 1.0)) * camera.matrix;
    }
    camera
}

#[test]
fn fast_draws_the_bytes_of_render_for_any_scene() {
    test_law(if is_thorough() { 1000 } else { 30 }, |random| {
        let (scene, camera) = (random_scene(random), random_camera(random));
        assert_fast_draws(&camera, 1 + random.index(3) as u32, &scene);
    });
}

#[test]
fn fast_draws_the_bytes_of_render_from_inside_a_ball_and_from_its_surface() {
    test_law(25, |random| {
        let (scene, mut camera) = (random_scene(random), random_camera(random));
        if let Some(object) = scene.objects.first() {
            let away = [0.0, 0.3, 0.999_999, 1.0, 1.000_001][random.index(5)];
            let offset = away * object.sphere.radius * random.unit_vector();
            camera.centre = object.sphere.centre + offset;
        }
        assert_fast_draws(&camera, 1, &scene);
    });
}

// The ray through the middle meets both spheres at t = 4. Both spheres are equally near, so `fast`
// may test either sphere first. The sphere that comes first in the scene still has to win the tie.
#[test]
fn fast_shows_the_first_of_two_spheres_that_touch_where_a_ray_meets_them() {
    let mut scene = generate_scene("touching");
    scene.objects.truncate(2);
    for (object, r) in scene.objects.iter_mut().zip([1.0, 2.0]) {
        object.sphere = Sphere { centre: DVec3::new(0.0, 0.0, -4.0 - r), radius: r };
    }
    scene.objects[1].material.matte.ambient =
        DVec3::splat(0.5) - scene.objects[0].material.matte.ambient;
    assert_fast_draws(&Camera::new(3, 3, f64::to_radians(90.0)), 1, &scene);
    scene.objects.reverse();
    assert_fast_draws(&Camera::new(3, 3, f64::to_radians(90.0)), 1, &scene);
}

// If a light is exactly at a visible point, the direction from the point to the light is undefined.
#[test]
fn fast_draws_the_bytes_of_render_with_a_light_at_a_visible_point() {
    test_law(25, |random| {
        let (mut scene, camera) = (random_scene(random), random_camera(random));
        let ray = camera.ray(random.index(2) as f64, 0.0);
        let point = visible_point(&scene.objects, &ray).map(|point| point.p);
        for light in &mut scene.lights {
            light.point_light.position = point.unwrap_or(DVec3::ZERO);
        }
        assert_fast_draws(&camera, 1, &scene);
    });
}

// If the columns of a camera's matrix lie in one plane, all of the camera's rays lie in that plane,
// too. Some of the rays may even coincide. In the third case here, the columns lie only nearly in
// one plane.
#[test]
fn fast_draws_the_bytes_of_render_for_rays_in_one_plane() {
    test_law(15, |random| {
        let (scene, mut camera) = (random_scene(random), random_camera(random));
        match random.index(3) {
            0 => camera.matrix.x_axis = DVec3::ZERO,
            1 => camera.matrix.y_axis = camera.matrix.x_axis,
            _ => camera.matrix.z_axis = 3.0 * camera.matrix.x_axis + camera.matrix.y_axis + 1e-12,
        }
        assert_fast_draws(&camera, 1, &scene);
    });
}

// `fast` draws the picture in blocks of pixels. Neighbouring blocks share an edge at column 15.5.
// To find the spheres that a block may show, `fast` computes the plane through the camera's centre
// and this edge. Here, the centre is almost on the edge, so rounding errors in V rotate the plane
// by a large angle.
#[test]
fn fast_draws_the_bytes_of_render_for_a_camera_nearly_in_the_plane_of_its_picture() {
    test_law(60, |random| {
        let size = (33 + random.index(8) as u32, 1 + random.index(30) as u32);
        let mut camera = Camera::new(size.0, size.1, 1.0);
        let DMat3 { x_axis: x, y_axis: y, .. } = camera.matrix;
        let depth = 10_f64.powf(random.number(-16.5, -15.5));
        camera.matrix.z_axis =
            depth * DVec3::NEG_Z - 15.5 * x - random.number(0.0, f64::from(size.1)) * y;
        let roll = random.number(-3.0, 3.0);
        let camera = look_at(&camera, random.point(), DVec3::NEG_Z, roll);
        let objects = generate_scene("turned").objects;
        let mut scene = generate_scene("turned");
        scene.objects.clear();
        for k in 0..10 + random.index(20) {
            let mut object = objects[k % objects.len()];
            let i = random.number(-1.0, f64::from(size.0));
            let j = random.number(-1.0, f64::from(size.1));
            let to_centre = camera.ray(i, j).direction.normalize_or(DVec3::X);
            let distance = random.number(0.1, 10.0);
            object.sphere.centre = camera.centre + distance * to_centre;
            object.sphere.radius = distance * 10_f64.powf(random.number(-3.0, 0.3));
            scene.objects.push(object);
        }
        assert_fast_draws(&camera, 1, &scene);
    });
}

#[test]
fn fast_draws_the_bytes_of_render_if_every_sphere_occurs_twice() {
    test_law(if is_thorough() { 250 } else { 50 }, |random| {
        let mut scene = generate_scene(&random.index(10_000).to_string());
        scene.lights.truncate(random.index(3));
        scene.objects.truncate(random.index(10));
        // Add a copy of every sphere, usually in a different material. The original and the copy
        // are hit at the same t. `render` shows the original, because it comes first in the list.
        let pairs = scene.objects.iter().zip(scene.objects.iter().rev());
        let copies: Vec<_> =
            pairs.map(|(original, model)| original.with_material(model.material)).collect();
        scene.objects.extend(copies);
        assert_fast_draws(
            &small_camera_at_random_position(random),
            1 + random.index(3) as u32,
            &scene,
        );
    });
}

// If a sphere's radius is less than 1e-8 times the sphere's distance, the radius is lost in the
// rounding errors of the discriminant D. Such a sphere is drawn as a spot that is larger than the
// sphere, and the hits in the spot are too near or too far. Here, the field of view is so narrow
// that these spots are larger than a pixel. The small spheres are close to the surface of a larger
// ball.
#[test]
fn fast_draws_the_bytes_of_render_where_rounding_errors_are_larger_than_the_spheres() {
    test_law(16, |random| {
        let size = (20 + random.index(30) as u32, 1 + random.index(30) as u32);
        let pixel = 10_f64.powf(random.number(-10.0, -8.0));
        let camera = Camera::new(size.0, size.1, f64::from(size.0) * pixel);
        let roll = random.number(-3.0, 3.0);
        let camera = look_at(&camera, random.point(), DVec3::NEG_Z, roll);
        let (distance, radius) = (random.number(0.1, 10.0), random.number(0.5, 2.0));
        let point = |i, j, t| camera.centre + t * camera.ray(i, j).direction.normalize();
        let middle = [size.0, size.1].map(|pixels| f64::from(pixels - 1) / 2.0);
        let ball = Sphere { centre: point(middle[0], middle[1], distance + radius), radius };
        let mut spheres = vec![ball];
        for _ in 0..3 + random.index(10) {
            let i = random.number(-1.0, f64::from(size.0));
            let j = random.number(-1.0, f64::from(size.1));
            let centre = point(i, j, distance * (1.0 + random.number(-1e-8, 1e-8)));
            let radius = distance * 10_f64.powf(random.number(-11.0, -7.0));
            spheres.insert(random.index(spheres.len() + 1), Sphere { centre, radius });
        }
        // In half of the scenes, remove the ball, so that the sky behind the ball is visible.
        if random.index(2) == 0 {
            spheres.retain(|sphere| *sphere != ball);
        }
        let mut scene = generate_scene("rounded");
        let materials: Vec<_> = scene.objects.iter().map(|object| object.material).collect();
        scene.objects = (spheres.into_iter().zip(materials.into_iter().cycle()))
            .map(|(sphere, material)| Object { name: "ball", sphere, material })
            .collect();
        assert_fast_draws(&camera, 1 + random.index(2) as u32, &scene);
    });
}

// Most rounding errors vanish when a colour is rounded to a byte. In these scenes, the tiniest
// error may change a byte. In one scene, a ray is tangent to a sphere, and may hit or miss it. In
// the other scene, the ray's colour is halfway between two bytes.
#[test]
fn fast_rounds_like_render() {
    test_law(400, |random| {
        let camera = small_camera_at_random_position(random);
        let ray = camera.ray(random.index(37) as f64, random.index(7) as f64);
        let offset = 0.8 * random.number(0.2, 5.0) * random.unit_vector();
        let to_centre = 9.0 * ray.direction.normalize() + offset;
        let hit_sphere = Sphere { centre: ray.start + to_centre, radius: offset.length() / 0.8 };
        let radius = to_centre.reject_from(ray.direction).length();
        let tangent_sphere = Sphere { radius, ..hit_sphere };
        let with_sphere = |sphere, ambient_light| {
            let mut scene = Scene { ambient_light, ..generate_scene("rounded") };
            scene.objects.truncate(1);
            scene.objects[0].sphere = sphere;
            scene.objects[0].material.matte.ambient = DVec3::ONE;
            scene
        };
        let lit = colour(&with_sphere(hit_sphere, DVec3::ZERO), &ray);
        // This ambient light moves the colour to halfway between two bytes.
        let ambient_light = ((255.0 * lit).floor() + 1.5) / 255.0 - lit;
        for (sphere, light) in [(tangent_sphere, DVec3::ONE), (hit_sphere, ambient_light)] {
            assert_fast_draws(&camera, 1, &with_sphere(sphere, light));
        }
    });
}

/// A camera with few pixels, at a random position.
fn small_camera_at_random_position(random: &mut RandomInputs) -> Camera {
    let roll = random.number(-3.0, 3.0);
    look_at(&camera_with_size(37, 7), random.point(), DVec3::NEG_Z, roll)
}
