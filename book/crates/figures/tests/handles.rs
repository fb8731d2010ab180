//! Laws of what is dragged and told: a handle is where the pointer is, and numbers agree with
//! each other and with the chapters. The drawings and numbers themselves are locked as text.

use figures::{FIGURES, Figure, Handle, find};
use glam::{DVec2, DVec3, dvec2};

fn find_figure(name: &str) -> &'static Figure {
    find(name).expect("a figure or picture")
}

/// A number of the text at these values: one, or the entries of a vector.
fn parse_number(figure: &Figure, values: &[f64], name: &str) -> Vec<f64> {
    let text = (figure.numbers)(values).remove(name).expect(name).replace('−', "-");
    let entries = text.trim_matches(['(', ')']).split(", ");
    entries.filter_map(|entry| entry.parse().ok()).collect()
}

fn parse_vector(figure: &Figure, values: &[f64], name: &str) -> DVec3 {
    DVec3::from_slice(&parse_number(figure, values, name))
}

#[test]
fn dragged_handle_of_a_picture_is_near_the_pointer() {
    let pointer = dvec2(400.0, 150.0);
    for figure in FIGURES.iter().filter(|figure| figure.name.starts_with("step")) {
        for handle in &figure.handles {
            let values = figure.drag_handle(&figure.default_values(), handle, pointer);
            let place = (handle.locate)(&values.expect("allowed values")).expect("a place");
            assert!(place.distance(pointer) < 20.0, "{}: {}", figure.name, handle.words);
        }
    }
}

#[test]
fn light_that_is_moved_by_keys_stays_inside_the_picture() {
    let figure = find_figure("step04_diffuse");
    let (warm, mut values) = (&figure.handles[1], figure.default_values());
    values[3..6].copy_from_slice(&[0.0, 0.5, -4.0]);
    for _ in 0..100 {
        values = figure.step_handle(&values, warm, dvec2(1.0, 0.0)).expect("allowed values");
    }
    let place = (warm.locate)(&values).expect("a place");
    assert_eq!(place, place.clamp(DVec2::ZERO, dvec2(640.0, 360.0)));
}

#[test]
fn light_behind_the_eye_has_no_place() {
    let figure = find_figure("step04_diffuse");
    let (warm, mut values) = (&figure.handles[1], figure.default_values());
    for (z, has_place) in [(-2.0, true), (0.0, false), (2.0, false)] {
        values[3..6].copy_from_slice(&[0.0, 0.5, z]);
        assert_eq!((warm.locate)(&values).is_some(), has_place, "z = {z}");
        let new = figure.step_handle(&values, warm, dvec2(1.0, 0.0));
        assert_eq!(new.is_some(), has_place, "z = {z}");
    }
}

/// The own scene, its values with these changes, and its handle of the red sphere.
fn own_scene_with(changes: &[(&str, f64)]) -> (&'static Figure, Vec<f64>, &'static Handle) {
    let figure = find_figure("own_scene");
    let mut values = figure.default_values();
    for (name, value) in changes {
        let mut names = figure.parameters.iter().map(|one| format!("{} {}", one.group, one.words));
        values[names.position(|known| known == *name).expect(name)] = *value;
    }
    (figure, values, &figure.handles[0])
}

#[test]
fn dragged_sphere_of_the_own_scene_is_at_the_pointer_of_any_camera() {
    for camera in [
        &[("camera roll", 90.0)][..],
        &[
            ("camera position sideways", 6.0),
            ("camera roll", -30.0),
            ("camera target backwards", -8.0),
        ],
        // It looks back at the scene.
        &[("camera position backwards", -20.0), ("camera target upwards", 1.0)],
    ] {
        let (figure, values, handle) = own_scene_with(camera);
        let pointer = (handle.locate)(&values).expect("a place") + dvec2(20.0, -30.0);
        let new = figure.drag_handle(&values, handle, pointer).expect("values");
        let place = (handle.locate)(&new).expect("a place");
        assert!(place.distance(pointer) < 1.0, "{camera:?}: {place}");
        let z = handle.parameters[1] + 1;
        assert_eq!(values[z], new[z], "{camera:?}");
    }
}

#[test]
fn dragged_sphere_stays_where_its_plane_is_edge_on() {
    let (side, depth) = (("camera position sideways", 6.0), -7.4);
    let camera = [side, ("camera position backwards", depth), ("camera target backwards", depth)];
    let (figure, values, handle) = own_scene_with(&camera);
    assert!((handle.locate)(&values).is_some());
    assert_eq!(figure.drag_handle(&values, handle, dvec2(300.0, 100.0)), Some(values));
}

#[test]
fn eye_in_a_ball_of_the_flat_world_is_not_allowed() {
    let figure = find_figure("flat-world");
    let (values, eye) = (figure.default_values(), &figure.handles[0]);
    let place = (eye.locate)(&values).expect("a place");
    assert_eq!(figure.drag_handle(&values, eye, place), Some(values.clone()));
    assert_eq!(figure.drag_handle(&values, eye, place + dvec2(190.0, 40.0)), None);
}

#[test]
fn p_plus_d_times_l_is_the_position_of_the_light() {
    let figure = find_figure("step04_diffuse");
    let mut values = figure.default_values();
    values[3..].copy_from_slice(&[-1.0, 2.0, -4.0, 2.5, -1.0, -13.0]);
    let p = parse_vector(figure, &values, "p");
    for (light, x) in [("warm", 3), ("cool", 6)] {
        let l = parse_vector(figure, &values, &format!("l {light}"));
        let d = parse_number(figure, &values, &format!("d {light}"))[0];
        let position = DVec3::from_slice(&values[x..]);
        assert!((p + d * l).abs_diff_eq(position, 0.01), "{light}: {}", p + d * l);
    }
}

#[test]
fn material_controls_are_those_of_the_sphere_at_the_probe() {
    let figure = find_figure("step05_phong");
    for (pixel, colour) in [([583.0, 215.0], "teal"), ([262.0, 132.0], "red")] {
        let mut values = figure.default_values();
        values[..2].copy_from_slice(&pixel);
        let controls = figure.parameters[6..].iter().filter(|one| one.has_control(&values));
        let words: Vec<_> = controls.map(|parameter| &parameter.words[..]).collect();
        let expected = format!("of the {colour} sphere");
        assert_eq!(words, [&expected[..]; 2]);
    }
}

#[test]
fn angle_of_the_drawn_light_is_that_of_the_caption() {
    let figure = find_figure("phong-vectors");
    for turn in [-30.0, 0.0, 25.0, 70.0] {
        let place = (figure.handles[0].locate)(&[turn]).expect("a place");
        let angle = figures::degrees_left_of_up(dvec2(240.0, 240.0), place);
        let number = parse_number(figure, &[turn], "angle")[0];
        assert!((angle.abs() - number).abs() < 0.1, "{angle}, {number}");
    }
}

#[test]
fn ratio_of_an_oval_is_as_the_chapter_derives() {
    let alpha = 8_f64.to_radians();
    for (theta, phi) in [(60.0, 20_f64), (100.0, 40.0), (140.0, 60.0)] {
        let number = |name| parse_number(find_figure("eggs"), &[theta], name)[0];
        assert_eq!(number("phi"), phi);
        let phi = phi.to_radians();
        let length = (phi + alpha).tan() - (phi - alpha).tan();
        let width = 2.0 * alpha.sin() / (phi.cos().powi(2) - alpha.sin().powi(2)).sqrt();
        let ratio = number("times");
        assert!((ratio - length / width).abs() <= 0.051, "{ratio}");
    }
}
