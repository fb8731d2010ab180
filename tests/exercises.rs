//! The exercises: each solution's picture is locked, and its mathematics holds.

#![allow(dead_code, reason = "the main of an example runs as a program only")]

#[path = "../steps/step01_rays/examples/graticule.rs"]
mod graticule;
#[path = "../steps/step01_rays/examples/look_at.rs"]
mod look_at;
#[path = "../steps/step01_rays/examples/panorama.rs"]
mod panorama;
#[path = "../steps/step01_rays/examples/step01_starter.rs"]
mod step01_starter;

#[path = "../steps/step02_sphere/examples/lens.rs"]
mod lens;
#[path = "../steps/step02_sphere/examples/plane.rs"]
mod plane;
#[path = "../steps/step02_sphere/examples/quadric.rs"]
mod quadric;
#[path = "../steps/step02_sphere/examples/step02_starter.rs"]
mod step02_starter;

#[path = "../steps/step03_nearest/examples/depth.rs"]
mod depth;
#[path = "../steps/step03_nearest/examples/jitter.rs"]
mod jitter;
#[path = "../steps/step03_nearest/examples/many.rs"]
mod many;
#[path = "../steps/step03_nearest/examples/step03_starter.rs"]
mod step03_starter;

#[path = "../steps/step04_diffuse/examples/gamma.rs"]
mod gamma;
#[path = "../steps/step04_diffuse/examples/shadows.rs"]
mod shadows;
#[path = "../steps/step04_diffuse/examples/spot.rs"]
mod spot;
#[path = "../steps/step04_diffuse/examples/step04_starter.rs"]
mod step04_starter;
#[path = "../steps/step04_diffuse/examples/sun.rs"]
mod sun;

#[path = "../steps/step05_phong/examples/glass.rs"]
mod glass;
#[path = "../steps/step05_phong/examples/halfway.rs"]
mod halfway;
#[path = "../steps/step05_phong/examples/mirror.rs"]
mod mirror;
#[path = "../steps/step05_phong/examples/step05_starter.rs"]
mod step05_starter;

// Steps 1 to 3.

mod of_step_1 {
    use crate::{graticule, look_at, panorama, step01_starter};
    use glam::DVec3;
    use image::Rgb;
    use look_at::look_at;
    use panorama::{direction, panoramic};
    use proptest::prelude::*;
    use std::f64::consts::FRAC_PI_2;
    use step01_rays::Camera;
    use tests::{assert_locked, camera, point};

    #[test]
    fn the_starter_draws_the_picture_of_the_step() {
        assert_locked("step01_rays", &step01_starter::picture(&camera(), 1));
    }

    #[test]
    fn graticule_is_locked() {
        assert_locked("graticule", &graticule::picture(&camera(), 1));
    }

    #[test]
    fn look_at_is_locked() {
        assert_locked("look_at", &look_at::picture(&camera(), 1));
    }

    #[test]
    fn panorama_is_locked() {
        assert_locked("panorama", &panorama::picture(&camera(), 1));
    }

    #[test]
    fn lines_of_the_graticule_are_5_degrees_apart() {
        for (degrees, away) in [(0.0, 0.0), (10.0, 0.0), (-15.0, 0.0), (7.0, 2.0)] {
            let found = graticule::from_line(f64::to_radians(degrees)).to_degrees();
            assert!((found - away).abs() < 1e-12, "{degrees}: {found}");
        }
    }

    #[test]
    fn the_equator_and_the_meridians_are_where_they_should_be() {
        let (camera, picture) = (camera(), graticule::picture(&camera(), 1));
        for degrees in [-30.0, -10.0, 0.0, 15.0, 30.0] {
            let x = f64::to_radians(degrees).tan();
            let i = (x - camera.matrix.z_axis.x) / camera.matrix.x_axis.x;
            let pixel = picture.get_pixel(i.round() as u32, 20);
            assert!(240 < pixel[0], "{degrees} degrees: {pixel:?}");
        }
        assert!((0..640).all(|i| picture.get_pixel(i, 179) == &Rgb([255; 3])));
    }

    #[test]
    fn from_the_origin_along_minus_z_it_is_the_given_camera() {
        assert_eq!(look_at(&camera(), DVec3::ZERO, DVec3::NEG_Z, 0.0), camera());
    }

    #[test]
    fn straight_down_is_a_direction_too() {
        let down = look_at(&camera(), DVec3::Y, DVec3::ZERO, 0.0);
        let middle = down.ray(319.5, 179.5).direction;
        assert!(middle.distance(DVec3::NEG_Y) < 1e-12, "{middle}");
        assert!(0.0 < down.matrix.determinant().abs());
    }

    #[test]
    fn a_roll_by_90_degrees_turns_right_into_up() {
        let rolled = look_at(&camera(), DVec3::ZERO, DVec3::NEG_Z, FRAC_PI_2);
        let length = camera().matrix.x_axis.length();
        assert!(rolled.matrix.x_axis.distance(length * DVec3::Y) < 1e-12);
    }

    #[test]
    fn the_four_ways_of_the_panorama() {
        for (longitude, latitude, v) in [
            (0.0, 0.0, DVec3::NEG_Z),
            (FRAC_PI_2, 0.0, DVec3::X),
            (2.0 * FRAC_PI_2, 0.0, DVec3::Z),
            (1.0, FRAC_PI_2, DVec3::Y),
        ] {
            assert!(direction(longitude, latitude).distance(v) < 1e-12, "{v}");
        }
    }

    #[test]
    fn the_panorama_closes_at_its_left_and_right_edges() {
        let camera = Camera::new(64, 32, 1.0);
        for j in 0..32 {
            let at = |i| panoramic(&camera, DVec3::new(i, f64::from(j), 1.0));
            assert!(at(-0.5).distance(at(63.5)) < 1e-12);
            assert!((at(10.0) + at(42.0)).with_y(0.0).length() < 1e-12);
        }
    }

    proptest! {
        #[test]
        fn the_target_is_in_the_middle(from in point(), to in point(), roll in -3.0..3.0) {
            prop_assume!(0.1 < from.distance(to));
            let ray = look_at(&camera(), from, to, roll).ray(319.5, 179.5);
            prop_assert_eq!(ray.start, from);
            prop_assert!(look_at::passes(&ray, to).is_some_and(|away| away < 1e-9));
        }

        #[test]
        fn turning_keeps_lengths_and_angles(from in point(), to in point(), roll in -3.0..3.0) {
            prop_assume!(0.1 < from.distance(to));
            let (own, turned) = (camera().matrix, look_at(&camera(), from, to, roll).matrix);
            let apart = turned.transpose() * turned - own.transpose() * own;
            prop_assert!(apart.to_cols_array().iter().all(|x| x.abs() < 1e-12));
            prop_assert!(turned.determinant() * own.determinant() > 0.0);
        }

        #[test]
        fn without_roll_the_horizon_is_level(from in point(), to in point()) {
            prop_assume!(0.1 < (from - to).with_y(0.0).length());
            let turned = look_at(&camera(), from, to, 0.0).matrix;
            prop_assert!(turned.x_axis.y.abs() < 1e-15 && turned.y_axis.y < 0.0);
        }
    }
}

mod of_step_2 {
    use crate::{lens, plane, quadric, step02_starter};
    use glam::{DMat3, DVec3};
    use lens::{Interval, inside_all};
    use plane::Plane;
    use proptest::prelude::*;
    use quadric::Quadric;
    use step02_sphere::{Ray, Roots, Sphere};
    use tests::{assert_locked, camera, point, rays, sphere, unit};

    const AHEAD: Ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };

    #[test]
    fn the_starter_draws_the_picture_of_the_step() {
        assert_locked("step02_sphere", &step02_starter::picture(&camera(), 1));
    }

    #[test]
    fn plane_is_locked() {
        assert_locked("plane", &plane::picture(&camera(), 1));
    }

    #[test]
    fn quadric_is_locked() {
        assert_locked("quadric", &quadric::picture(&camera(), 1));
    }

    #[test]
    fn lens_is_locked() {
        assert_locked("lens", &lens::picture(&camera(), 1));
    }

    #[test]
    fn a_ray_along_the_plane_or_away_from_it_misses() {
        let wall =
            |z| Plane { point: DVec3::new(7.0, 8.0, z), normal: 2.0 * DVec3::Z };
        assert_eq!(wall(-3.0).first_hit(&AHEAD), Some(3.0));
        assert_eq!(wall(0.0).first_hit(&AHEAD), None);
        assert_eq!(wall(3.0).first_hit(&AHEAD), None);
        let along = Ray { direction: DVec3::X, ..AHEAD };
        assert_eq!(wall(-3.0).first_hit(&along), None);
        assert_eq!(wall(0.0).first_hit(&along), None);
    }

    #[test]
    fn a_ray_parallel_to_a_cylinder_or_a_side_of_a_cone_is_no_quadratic() {
        let round = DMat3::from_diagonal(DVec3::new(1.0, 1.0, 0.0));
        let cylinder = Quadric::around(DVec3::ZERO, round, -1.0);
        assert_eq!(cylinder.intersect(&AHEAD), Roots::None);
        let cone = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
        let cone = Quadric::around(DVec3::new(0.0, 0.0, -4.0), cone, 0.0);
        let side = Ray { direction: DVec3::new(1.0, 0.0, -1.0), ..AHEAD };
        assert_eq!(cone.coefficients(&side).0, 0.0);
        assert_eq!(cone.intersect(&side), Roots::One(2.0));
    }

    #[test]
    fn where_a_is_below_0_the_smaller_root_still_comes_first() {
        let bowls = DMat3::from_diagonal(DVec3::new(1.0, 1.0, -1.0));
        let bowls = Quadric::around(DVec3::new(0.0, 0.0, -4.0), bowls, 1.0);
        assert_eq!(bowls.intersect(&AHEAD), Roots::Two(3.0, 5.0));
    }

    #[test]
    fn what_is_cut_off_is_seen_through() {
        let pipe = DMat3::from_diagonal(DVec3::new(1.0, 0.0, 1.0));
        let pipe = Quadric::around(DVec3::new(0.0, 0.0, -5.0), pipe, -1.0);
        let down = Ray { direction: DVec3::new(0.0, -0.2, -1.0), ..AHEAD };
        assert_eq!(pipe.first_between(&down, -2.0, 2.0), Some(4.0));
        // Over the edge in front, onto the inside.
        assert!(pipe.first_between(&down, -2.0, -1.0).is_some_and(|t| 5.9 < t));
        assert_eq!(pipe.first_between(&down, -0.5, 0.5), None);
    }

    #[test]
    fn the_lens_of_a_sphere_with_itself_is_the_sphere() {
        let sphere = Sphere { centre: DVec3::new(0.0, 0.0, -5.0), radius: 1.0 };
        let whole = Interval { enter: 4.0, leave: 6.0 };
        assert_eq!(inside_all(&[sphere; 2], &AHEAD), Some(whole));
        assert_eq!(inside_all(&[], &AHEAD), Some(lens::RAY));
        let within = Ray { start: sphere.centre, ..AHEAD };
        let half = Interval { enter: 0.0, leave: 1.0 };
        assert_eq!(inside_all(&[sphere], &within), Some(half));
        let beyond = Ray { start: 9.0 * DVec3::NEG_Z, ..AHEAD };
        assert_eq!(inside_all(&[sphere], &beyond), None);
    }

    /// Symmetric matrices of all kinds of quadrics.
    fn symmetric() -> impl Strategy<Value = DMat3> {
        (point(), point()).prop_map(|(diagonal, other)| {
            let DVec3 { x, y, z } = other / 10.0;
            let products = DMat3::from_cols_array(&[0., x, y, x, 0., z, y, z, 0.]);
            DMat3::from_diagonal(diagonal / 10.0) + products
        })
    }

    proptest! {
        #[test]
        fn hits_satisfy_the_equation_of_the_plane(
            q in point(), n in unit(), start in point(), v in unit(), length in 0.1..5.0
        ) {
            let (plane, ray) =
                (Plane { point: q, normal: n }, Ray { start, direction: length * v });
            let towards = n.dot(q - start) * n.dot(v);
            prop_assume!(1e-3 < n.dot(v).abs());
            let hit = plane.first_hit(&ray);
            prop_assert_eq!(hit.is_some(), 0.0 < towards);
            if let Some(t) = hit {
                prop_assert!(n.dot(ray.at(t) - q).abs() < 1e-9 * (1.0 + t));
            }
        }

        #[test]
        fn a_quadric_with_the_matrix_of_a_sphere_is_the_sphere((sphere, ray) in rays()) {
            let Sphere { centre, radius } = sphere;
            let quadric = Quadric::around(centre, DMat3::IDENTITY, -radius * radius);
            let (a, b, c) = sphere.coefficients(&ray);
            let found = DVec3::from(quadric.coefficients(&ray));
            prop_assert!(found.distance(DVec3::new(a, b, c)) < 1e-11 * (1.0 + c.abs()) * (1.0 + a));
        }

        #[test]
        fn hits_satisfy_the_equation_of_the_quadric(
            centre in point(), q in symmetric(), w in -9.0..9.0, start in point(), v in unit()
        ) {
            let (quadric, ray) = (Quadric::around(centre, q, w), Ray { start, direction: v });
            prop_assume!(1e-3 < quadric.coefficients(&ray).0.abs());
            let ts = match quadric.intersect(&ray) {
                Roots::None => vec![],
                Roots::One(t) => vec![t],
                Roots::Two(near, far) => vec![near, far],
            };
            prop_assert!(ts.is_sorted());
            for t in ts {
                let p = ray.at(t) - centre;
                prop_assert!((p.dot(q * p) + w).abs() < 1e-9 * (1.0 + t * t));
            }
        }

        #[test]
        fn a_point_is_in_the_lens_where_it_is_in_both(
            (one, ray) in rays(), (off, r) in (unit(), 0.1..4.0), k in 0.0..1.5
        ) {
            let other = Sphere { centre: one.centre + 0.7 * (one.radius + r) * off, radius: r };
            let piece = inside_all(&[one, other], &ray);
            prop_assert_eq!(piece, inside_all(&[other, one], &ray));
            let t = k * (one.centre - ray.start).length() / ray.direction.length();
            let deep = |s: &Sphere| s.radius - ray.at(t).distance(s.centre);
            prop_assume!(1e-6 < deep(&one).abs() && 1e-6 < deep(&other).abs());
            let inside = 0.0 < deep(&one) && 0.0 < deep(&other);
            prop_assert_eq!(piece.is_some_and(|p| p.enter <= t && t <= p.leave), inside);
        }

        #[test]
        fn the_lens_is_not_longer_than_either_sphere((one, ray) in rays(), other in sphere()) {
            if let Some(both) = inside_all(&[one, other], &ray) {
                for each in [one, other] {
                    let alone = inside_all(&[each], &ray);
                    prop_assert!(alone.is_some_and(|a| a.enter <= both.enter && both.leave <= a.leave));
                }
            }
        }
    }
}

mod of_step_3 {
    use crate::{depth, jitter, many, step03_starter};
    use glam::DVec3;
    use many::Tree;
    use proptest::{collection::vec, prelude::*};
    use step03_nearest::{Ray, SPHERES, Sphere, nearest};
    use tests::{assert_locked, camera, point, rays, sphere, unit};

    #[test]
    fn the_starter_draws_the_picture_of_the_step() {
        assert_locked("step03_nearest", &step03_starter::picture(&camera(), 1));
    }

    #[test]
    fn depth_is_locked() {
        assert_locked("depth", &depth::picture(&camera(), 1));
    }

    #[test]
    fn jitter_is_locked() {
        assert_locked("jitter", &jitter::picture(&camera(), 1));
    }

    #[test]
    fn many_is_locked() {
        assert_locked("many", &many::picture(&camera(), 1));
    }

    #[test]
    fn up_to_4_samples_jitter_draws_the_same_picture() {
        let four = jitter::picture(&camera(), 4);
        assert!(jitter::picture(&camera(), 1) == four);
        assert!(jitter::picture(&camera(), 5) != four);
    }

    #[test]
    fn each_random_ray_stays_in_its_sub_pixel() {
        let (camera, side) = (camera(), 4);
        let inverse = camera.matrix.inverse();
        for (x, y) in (0..400).flat_map(|y| (0..400).map(move |x| (x, y))) {
            let centre = |k: i32| (f64::from(k) + 0.5) / f64::from(side) - 0.5;
            let place = DVec3::new(centre(x), centre(y), 1.0);
            let ray = jitter::jittered(&camera, side, place);
            let off = (inverse * ray.direction - place) * f64::from(side);
            assert!(off.abs().max_element() < 0.5 + 1e-9, "{x}, {y}: {off}");
        }
    }

    #[test]
    fn the_noise_is_even_and_neighbours_do_not_go_together() {
        let (side, mut bins, mut together) = (300, [[0; 8]; 8], [0.0; 3]);
        for (x, y) in (0..side).flat_map(|y| (0..side).map(move |x| (x, y))) {
            let [u, v] = jitter::noise(x, y);
            bins[(8.0 * u) as usize][(8.0 * v) as usize] += 1;
            let [right, below] = [jitter::noise(x + 1, y), jitter::noise(x, y + 1)];
            for (sum, other) in together.iter_mut().zip([v, right[0], below[0]]) {
                *sum += 12.0 * (u - 0.5) * (other - 0.5) / f64::from(side * side);
            }
        }
        // 1406 of the 90,000 fall into each of 64 bins, give or take 5 times √1406.
        assert!(
            bins.iter().flatten().all(|n| (1218..1595).contains(n)),
            "{bins:?}"
        );
        // The correlation of chance is about 1/√90,000.
        assert!(together.iter().all(|sum| sum.abs() < 0.017), "{together:?}");
    }

    fn in_tree(spheres: &[Sphere], ray: &Ray) -> Option<step03_nearest::Hit> {
        Tree::new(spheres)
            .nearest(ray, |index| spheres[index].intersect(ray).first_hit())
    }

    #[test]
    fn the_tree_finds_what_the_loop_finds_and_asks_far_fewer() {
        let (camera, spheres) = (camera(), many::spheres());
        let tree = Tree::new(&spheres);
        let (mut asked, mut rays, mut hits) = (0, 0, 0);
        for (i, j) in (0..90).flat_map(|j| (0..160).map(move |i| (4 * i, 4 * j))) {
            let ray = camera.ray(i.into(), j.into());
            let found = tree.nearest(&ray, |index| {
                asked += 1;
                spheres[index].intersect(&ray).first_hit()
            });
            assert_eq!(found, nearest(&spheres, &ray), "column {i}, row {j}");
            rays += 1;
            hits += usize::from(found.is_some());
        }
        assert!(rays / 4 < hits);
        // The loop asks 1000 a ray. The limit is tight, so that a tree fails that goes
        // into the farther half first, or into boxes behind the nearest hit.
        assert!(2 * asked < 3 * rays, "{asked} spheres for {rays} rays");
    }

    #[test]
    fn the_tree_of_none_is_empty_and_of_the_scene_is_the_scene() {
        let ray = Ray { start: DVec3::ZERO, direction: DVec3::NEG_Z };
        assert_eq!(in_tree(&[], &ray), None);
        for (i, j) in (0..36).flat_map(|j| (0..64).map(move |i| (10 * i, 10 * j))) {
            let ray = camera().ray(i.into(), j.into());
            assert_eq!(in_tree(&SPHERES, &ray), nearest(&SPHERES, &ray));
        }
    }

    #[test]
    fn rays_along_the_axes_and_tangents_are_found_too() {
        let grid = |x: i32| Sphere {
            centre: DVec3::new(x.into(), 0.0, -5.0),
            radius: 1.0,
        };
        let spheres: Vec<Sphere> = (-8..8).map(|x| grid(2 * x)).collect();
        for x in -20..20 {
            let start = DVec3::new(f64::from(x) / 2.0, 0.0, 0.0);
            for direction in [DVec3::NEG_Z, DVec3::Z, DVec3::X, -DVec3::X] {
                for start in [start, start - 4.0 * DVec3::Z, start - 5.0 * DVec3::Z]
                {
                    let ray = Ray { start, direction };
                    assert_eq!(
                        in_tree(&spheres, &ray),
                        nearest(&spheres, &ray),
                        "{ray:?}"
                    );
                }
            }
        }
    }

    proptest! {
        #[test]
        fn depth_does_not_depend_on_the_length_of_v(v in unit(), k in 0.1..9.0, s in point()) {
            let ray = |direction| Ray { start: s / 10.0, direction };
            if let (Some(d), Some(e)) = (depth::distance(&ray(v)), depth::distance(&ray(k * v))) {
                let seen = |v| nearest(&SPHERES, &ray(v)).map(|hit| hit.index);
                prop_assume!(seen(v) == seen(k * v));
                prop_assert!((d - e).abs() < 1e-6);
                let hit = nearest(&SPHERES, &ray(k * v)).map(|hit| ray(k * v).at(hit.t));
                prop_assert!(hit.is_some_and(|p| (p.distance(s / 10.0) - e).abs() < 1e-9));
            }
        }

        #[test]
        fn the_tree_finds_what_the_loop_finds(
            (target, ray) in rays(), mut list in vec(sphere(), 0..30), twice in any::<bool>()
        ) {
            list.push(target);
            if twice {
                // Each at the same t as another: the first in the list counts.
                list.extend_from_within(..);
            }
            prop_assert_eq!(in_tree(&list, &ray), nearest(&list, &ray));
        }
    }
}

// Steps 4 and 5.

mod of_steps_4_and_5 {
    use crate::{
        gamma, glass, halfway, mirror, shadows, spot, step04_starter,
        step05_starter, sun,
    };
    use glam::DVec3;
    use image::Rgb;
    use proptest::prelude::*;
    use step05_phong::{
        Attenuation, LIGHTS, MATERIALS, PointLight, Ray, SPHERES, Sphere, diffuse,
        nearest, normal, reflect,
    };
    use tests::{assert_locked, camera, locked, point, unit};

    const GREY: DVec3 = DVec3::splat(0.5);

    /// Where the rays through the pixels of the camera meet the scene: the ray, p, n
    /// and the index of the sphere.
    fn hits() -> impl Iterator<Item = (Ray, DVec3, DVec3, usize)> {
        let pixels = (0..360).flat_map(|j| (0..640).map(move |i| (i, j)));
        pixels.filter_map(|(i, j)| {
            let ray = camera().ray(i.into(), j.into());
            let hit = nearest(&SPHERES, &ray)?;
            let p = ray.at(hit.t);
            Some((ray, p, normal(&SPHERES[hit.index], p), hit.index))
        })
    }

    #[test]
    fn the_starters_draw_the_pictures_of_their_steps() {
        assert_locked("step04_diffuse", &step04_starter::picture(&camera(), 1));
        assert_locked("step05_phong", &step05_starter::picture(&camera(), 1));
    }

    // gamma

    #[test]
    fn gamma_is_locked() {
        assert_locked("gamma", &gamma::picture(&camera(), 1));
    }

    #[test]
    fn the_curve_leaves_black_and_white_and_joins_its_two_parts() {
        assert_eq!(gamma::srgb(0.0), 0.0);
        assert!((gamma::srgb(1.0) - 1.0).abs() < 1e-15);
        assert!((gamma::srgb(0.0031308) - gamma::srgb(0.0031309)).abs() < 2e-6);
    }

    #[test]
    fn half_the_light_is_the_byte_188_and_too_much_is_white() {
        assert_eq!(gamma::rgb8(GREY), Rgb([188; 3]));
        assert_eq!(gamma::rgb8(DVec3::new(-1.0, 2.0, 1e9)), Rgb([0, 255, 255]));
    }

    #[test]
    fn the_curve_comes_after_the_mean() {
        // The pixel in which the red sphere ends before the sky.
        let camera = camera();
        let (j, red) = (190, |i: u32| locked("gamma").get_pixel(i, 190)[2] < 150);
        let i = (270..400).find(|&i| !red(i)).expect("an edge") - 1;
        let centres = [-0.375, -0.125, 0.125, 0.375];
        let rays = centres.iter().flat_map(|v| centres.map(|u| (u, *v)));
        let ray = |(u, v)| camera.ray(f64::from(i) + u, f64::from(j) + v);
        let mean =
            rays.map(ray).map(|ray| step04_diffuse::colour(&ray)).sum::<DVec3>();
        let pixel = gamma::picture(&camera, 4)[(i, j)];
        assert_eq!(pixel, gamma::rgb8(mean / 16.0));
    }

    // sun

    #[test]
    fn sun_is_locked() {
        assert_locked("sun", &sun::picture(&camera(), 1));
    }

    // spot

    #[test]
    fn spot_is_locked() {
        assert_locked("spot", &spot::picture(&camera(), 1));
    }

    /// The spot light that shines from (0, 4, 0) downwards.
    fn down() -> spot::SpotLight {
        let position = DVec3::new(0.0, 4.0, 0.0);
        let point = PointLight { position, ..spot::SPOTS[0].point };
        spot::SpotLight { point, target: DVec3::ZERO, ..spot::SPOTS[0] }
    }

    /// The unit vector to the light from a point at `angle` from the axis of `down`.
    fn from_angle(angle: f64) -> DVec3 {
        DVec3::new(angle.sin(), angle.cos(), 0.0)
    }

    #[test]
    fn the_cone_is_whole_inside_empty_outside_and_half_between() {
        let spot = down();
        let (inner, outer) = (spot.inner, spot.outer);
        let part = |angle: f64| spot.cone(from_angle(angle));
        assert_eq!([part(0.0), part(inner / 2.0)], [1.0, 1.0]);
        assert_eq!([part(1.01 * outer), part(3.0)], [0.0, 0.0]);
        let half = f64::midpoint(inner.cos(), outer.cos()).acos();
        assert!((part(half) - 0.5).abs() < 1e-12);
    }

    // shadows

    #[test]
    fn shadows_is_locked() {
        assert_locked("shadows", &shadows::picture(&camera(), 1));
    }

    #[test]
    fn a_point_with_a_sphere_before_the_light_is_dark() {
        let (sphere, light) = (SPHERES[0], LIGHTS[0].point.position);
        let way = (sphere.centre - light).normalize();
        let (before, behind) = (
            sphere.centre - 1.5 * sphere.radius * way,
            sphere.centre + 1.01 * sphere.radius * way,
        );
        assert!(shadows::hidden(light, behind, way));
        assert!(!shadows::hidden(light, before, -way));
    }

    #[test]
    fn a_sphere_behind_the_light_hides_nothing() {
        let sphere = SPHERES[0];
        let p = sphere.centre + DVec3::new(0.0, 0.0, 4.0 * sphere.radius);
        let light = sphere.centre + DVec3::new(0.0, 0.0, 2.0 * sphere.radius);
        assert!(!shadows::hidden(light, p, DVec3::Z));
        let inside = sphere.centre + DVec3::new(0.0, 0.0, 0.9 * sphere.radius);
        assert!(shadows::hidden(inside, p, DVec3::Z));
    }

    #[test]
    fn a_surface_that_faces_a_light_is_hidden_by_other_spheres_only() {
        let mut hidden_by_itself = 0;
        for (_, p, n, index) in hits() {
            for light in LIGHTS {
                let q = light.point.position;
                if n.dot(q - p) <= 0.0 {
                    continue;
                }
                let ray = Ray { start: p, direction: q - p };
                let hides = |sphere: &Sphere| {
                    sphere.intersect(&ray).first_hit().is_some_and(|t| t < 1.0)
                };
                let mut others = SPHERES.iter().enumerate();
                let other = others.any(|(i, sphere)| i != index && hides(sphere));
                assert_eq!(shadows::hidden(q, p, n), other, "{p}");
                assert_eq!(
                    mirror::hidden(light.point.position, p, n),
                    other,
                    "{p}"
                );
                assert_eq!(
                    glass::hidden(light.point.position, p, n, &[None; 9]),
                    other,
                    "{p}"
                );
                hidden_by_itself += u32::from(hides(&SPHERES[index]));
            }
        }
        // Without the offset there would be this many wrong shadows.
        assert!(50_000 < hidden_by_itself, "{hidden_by_itself}");
    }

    #[test]
    fn a_shadow_takes_light_and_never_adds_it() {
        let with = shadows::picture(&camera(), 1);
        let without = locked("step04_diffuse");
        let mut darker = 0;
        for (a, b) in with.pixels().zip(without.pixels()) {
            assert!(a.0.iter().zip(b.0).all(|(a, b)| *a <= b));
            darker += u32::from(a != b);
        }
        assert!(10_000 < darker, "{darker}");
    }

    // halfway

    #[test]
    fn halfway_is_locked() {
        assert_locked("halfway", &halfway::picture(&camera(), 1));
    }

    #[test]
    fn with_light_and_eye_along_the_normal_both_highlights_are_equal() {
        assert_eq!(halfway::halfway(DVec3::Y, DVec3::Y), DVec3::Y);
        let (material, light) = (&MATERIALS[0], &LIGHTS[0]);
        assert_eq!(
            halfway::specular(DVec3::Y, DVec3::Y, 3.0, material, light),
            step05_phong::specular(DVec3::Y, DVec3::Y, 3.0, material, light)
        );
    }

    #[test]
    fn four_times_the_exponent_gives_about_the_same_highlight() {
        // l, n and v in one plane, v up to 5 degrees away from r.
        let (material, light, l) = (&MATERIALS[0], &LIGHTS[0], from_angle(0.5));
        for step in 0..=10 {
            let v = from_angle(-0.5 + f64::from(step) * 0.5_f64.to_radians());
            let h = halfway::halfway(l, v);
            let blinn = halfway::specular(DVec3::Y, h, 3.0, material, light).x;
            let r = reflect(l, DVec3::Y);
            let term = step05_phong::specular(r, v, 3.0, material, light).x;
            assert!((blinn - term).abs() < 1e-3 * term, "{blinn} {term}");
        }
    }

    // mirror

    #[test]
    fn mirror_is_locked() {
        assert_locked("mirror", &mirror::picture(&camera(), 1));
    }

    #[test]
    fn without_mirrors_a_point_that_both_lights_reach_looks_as_in_step_5() {
        let none = [0.0; 9];
        let (mut lit, mut dark) = (0, 0);
        for (ray, p, n, _) in hits() {
            let colour = mirror::colour(&ray, &none, mirror::DEPTH);
            let step_5 = step05_phong::colour(&ray);
            if !LIGHTS
                .iter()
                .any(|light| mirror::hidden(light.point.position, p, n))
            {
                assert_eq!(colour, step_5);
                lit += 1;
            } else {
                assert!(colour.cmple(step_5).all());
                dark += 1;
            }
        }
        assert!(10_000 < lit && 10_000 < dark, "{lit} {dark}");
    }

    #[test]
    fn at_the_depth_limit_mirrors_show_their_own_colour() {
        for (ray, ..) in hits().step_by(7) {
            assert_eq!(
                mirror::colour(&ray, &mirror::MIRRORS, 0),
                mirror::colour(&ray, &[0.0; 9], mirror::DEPTH)
            );
        }
    }

    #[test]
    fn mirrors_show_the_green_sphere_behind_the_camera() {
        // Green alone is above 60, and more than twice red and blue.
        let is_green = |&&Rgb([r, g, b]): &&Rgb<u8>| 60 < g && r.max(b) < g / 2;
        let green =
            |picture: &image::RgbImage| picture.pixels().filter(is_green).count();
        assert_eq!(green(&locked("step05_phong")), 0);
        assert!(0 < green(&mirror::picture(&camera(), 1)));
    }

    #[test]
    fn nothing_mirrors_itself() {
        for (ray, p, n, index) in hits() {
            let direction = reflect(-ray.direction, n);
            let mirrored = Ray { start: p + mirror::OFFSET * n, direction };
            let hit = nearest(&SPHERES, &mirrored);
            assert!(hit.is_none_or(|hit| hit.index != index), "{p}");
        }
    }

    // glass

    #[test]
    fn glass_is_locked() {
        assert_locked("glass", &glass::picture(&camera(), 1));
    }

    #[test]
    fn without_glass_the_scene_is_that_of_the_mirrors_with_none_of_them() {
        for (ray, ..) in hits().step_by(7) {
            assert_eq!(
                glass::colour(&ray, &[None; 9], glass::DEPTH),
                mirror::colour(&ray, &[0.0; 9], mirror::DEPTH)
            );
        }
    }

    #[test]
    fn glass_bends_light_to_the_normal_and_back() {
        // Sines of 0.6 outside and 0.4 inside: an index of 1.5.
        let outside = DVec3::new(0.6, -0.8, 0.0);
        let inside = DVec3::new(0.4, -(0.84_f64.sqrt()), 0.0);
        let bent = |v, n| {
            // Only the ray that goes on has a colour: its direction.
            let goes_on = |ray: &Ray| {
                if ray.direction.y < 0.0 { ray.direction } else { DVec3::ZERO }
            };
            glass::through_glass(v, DVec3::ZERO, n, 1.5, goes_on).normalize()
        };
        assert!(bent(outside, DVec3::Y).distance(inside) < 1e-12);
        assert!(bent(inside, DVec3::NEG_Y).distance(outside) < 1e-12);
    }

    #[test]
    fn glass_mirrors_a_25th_of_the_light_head_on_and_all_of_it_along_the_surface() {
        let part = |degrees: f64| {
            let v = -from_angle(degrees.to_radians());
            let bent = glass::refract(v, DVec3::Y, 1.0 / 1.5).expect("it goes in");
            glass::fresnel(v, bent, DVec3::Y, 1.0 / 1.5)
        };
        assert!((part(0.0) - 0.04).abs() < 1e-12);
        assert!((part(60.0) - 0.0892).abs() < 1e-4);
        assert!((part(90.0) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn from_inside_beyond_the_critical_angle_all_light_is_mirrored() {
        let critical = (1.0 / 1.5_f64).asin();
        let bent = |angle: f64| glass::refract(-from_angle(angle), DVec3::Y, 1.5);
        assert!(bent(critical - 1e-6).is_some());
        assert_eq!(bent(critical + 1e-6), None);
    }

    #[test]
    fn glass_throws_no_shadow() {
        let (sphere, light) = (SPHERES[0], LIGHTS[0]);
        let way = (sphere.centre - light.point.position).normalize();
        let behind = sphere.centre + 1.01 * sphere.radius * way;
        let mut spheres = [None; 9];
        assert!(glass::hidden(light.point.position, behind, way, &spheres));
        spheres[0] = Some(1.5);
        assert!(!glass::hidden(light.point.position, behind, way, &spheres));
    }

    /// A light whose L_d and L_s are those of the sun, at `position`, that does not
    /// fade.
    fn steady(position: DVec3) -> PointLight {
        let attenuation = Attenuation { a: 1.0, b: 0.0, c: 0.0 };
        PointLight { position, diffuse: sun::SUN.diffuse, attenuation }
    }

    proptest! {
        #[test]
        fn the_curve_rises_and_has_its_inverse(i in 0.0..1.0) {
            let v = gamma::srgb(i);
            prop_assert!(i <= v && v < gamma::srgb(i + 1e-6));
            let back =
                if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) };
            prop_assert!((back - i).abs() < 1e-7);
        }

        #[test]
        fn the_sun_is_a_point_light_far_away_that_does_not_fade(p in point(), n in unit()) {
            let light = steady(1e9 * sun::SUN.direction);
            let (l, d) = light.seen_from(p);
            let far = diffuse(n, l, d, GREY, &light);
            prop_assert!(sun::SUN.diffuse(n, GREY).distance(far) < 1e-7);
        }

        #[test]
        fn the_cone_never_brightens_and_fades_outwards(a in 0.0..3.1, b in 0.0..3.1) {
            let (near, far) = (f64::min(a, b), f64::max(a, b));
            let (near, far) = (down().cone(from_angle(near)), down().cone(from_angle(far)));
            prop_assert!(0.0 <= far && far <= near && near <= 1.0);
        }

        #[test]
        fn n_is_halfway_between_l_and_its_reflection(l in unit(), n in unit()) {
            prop_assume!(0.01 < n.dot(l));
            prop_assert!(halfway::halfway(l, reflect(l, n)).distance(n) < 1e-12);
        }

        #[test]
        fn refraction_obeys_snell_and_can_be_walked_back(
            v in unit(), n in unit(), length in 0.1..5.0_f64, ratio in 0.3..3.0
        ) {
            let n = if v.dot(n) < 0.0 { n } else { -n };
            prop_assume!(v.dot(n) < -0.01);
            let sine = |v: DVec3| v.cross(n).length() / v.length();
            match glass::refract(length * v, n, ratio) {
                None => prop_assert!(1.0 - 1e-12 < ratio * sine(v)),
                Some(bent) => {
                    prop_assert!((sine(bent) - ratio * sine(v)).abs() < 1e-12);
                    prop_assert!((bent.length() - length).abs() < 1e-12);
                    prop_assert!(bent.dot(n) <= 0.0);
                    prop_assert!(v.cross(n).dot(bent).abs() < 1e-12);
                    let back = glass::refract(-bent, -n, 1.0 / ratio);
                    let there = |back: DVec3| (back + length * v).length() < 1e-6;
                    prop_assert!(back.is_none_or(there));
                    let part = glass::fresnel(v, bent / length, n, ratio);
                    let again = glass::fresnel(-bent / length, -v, -n, 1.0 / ratio);
                    prop_assert!((0.0..=1.0).contains(&part));
                    prop_assert!((part - again).abs() < 1e-9);
                }
            }
        }

        #[test]
        fn an_index_of_1_leaves_the_ray_straight(v in unit(), n in unit(), p in point()) {
            prop_assume!(0.01 < v.dot(n).abs());
            let seen = glass::through_glass(v, p, n, 1.0, |ray| ray.direction);
            prop_assert!(seen.distance(v) < 1e-12);
        }

        #[test]
        fn glass_in_even_light_is_not_seen(v in unit(), n in unit(), p in point(), index in 1.0..2.5) {
            let seen = glass::through_glass(v, p, n, index, |_| DVec3::ONE);
            prop_assert!(seen.distance(DVec3::ONE) < 1e-12);
        }
    }
}
