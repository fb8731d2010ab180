//! Handles lead to values, and values to the numbers of the chapters.

use figures::{Handle, LIVE, Live, Mark, Parameter, find};
use glam::{DVec2, DVec3, dvec2};

fn find_live(name: &str) -> &'static Live {
    find(name).expect("a figure or picture")
}

/// A number of the text at these values: one, or the entries of a vector.
fn parse_number(live: &Live, values: &[f64], name: &str) -> Vec<f64> {
    let text = (live.numbers)(values).remove(name).expect(name);
    let text = text.replace('−', "-");
    let entries = text.trim_matches(['(', ')']).split(", ");
    entries.filter_map(|entry| entry.parse().ok()).collect()
}

fn parse_vector(live: &Live, values: &[f64], name: &str) -> DVec3 {
    DVec3::from_slice(&parse_number(live, values, name))
}

#[test]
fn dragged_handle_of_a_picture_is_near_the_pointer() {
    let pictures = LIVE.iter().filter(|live| live.name.starts_with("step"));
    let handles = pictures.flat_map(|live| live.handles.iter().map(move |handle| (live, handle)));
    let pointer = dvec2(400.0, 150.0);
    let count = handles
        .map(|(live, handle)| {
            let values = live.drag_handle(&live.default_values(), handle, pointer);
            let place = handle.place(&values.expect("allowed values"));
            let distance = place.expect("a place").distance(pointer);
            assert!(distance < 20.0, "{}: {}", live.name, handle.words);
        })
        .count();
    assert_eq!(count, 7);
}

#[test]
fn light_that_is_moved_by_keys_stays_inside_the_picture() {
    let live = find_live("step04_diffuse");
    let warm = &live.handles[1];
    assert_eq!(warm.mark, Mark::Light);
    let mut values = live.default_values();
    values[3..6].copy_from_slice(&[0.0, 0.5, -4.0]);
    for _ in 0..100 {
        values = live.step_handle(&values, warm, dvec2(1.0, 0.0)).expect("allowed values");
    }
    let place = warm.place(&values).expect("a place");
    assert_eq!(place, place.clamp(DVec2::ZERO, dvec2(640.0, 360.0)));
}

#[test]
fn light_behind_the_eye_has_no_place() {
    let live = find_live("step04_diffuse");
    let warm = &live.handles[1];
    let mut values = live.default_values();
    for (z, has_place) in [(-2.0, true), (0.0, false), (2.0, false)] {
        values[3..6].copy_from_slice(&[0.0, 0.5, z]);
        assert_eq!(warm.place(&values).is_some(), has_place, "z = {z}");
        let new = live.step_handle(&values, warm, dvec2(1.0, 0.0));
        assert_eq!(new.is_some(), has_place, "z = {z}");
    }
}

/// The values of the own scene at an address, and its handle of the red sphere.
fn own_scene_and_handle(address: &str) -> (&'static Live, Vec<f64>, &'static Handle) {
    let live = find_live("own_scene");
    let mut values = live.default_values();
    for part in address.split(',') {
        let (name, value) = part.split_once(':').expect("a value");
        let is_named =
            |parameter: &Parameter| format!("{} {}", parameter.group, parameter.words) == name;
        let index = live.parameters.iter().position(is_named).expect(name);
        values[index] = value.parse().expect("a number");
    }
    (live, values, &live.handles[0])
}

#[test]
fn dragged_sphere_of_the_own_scene_is_at_the_pointer_of_any_camera() {
    for camera in [
        "camera roll:90",
        "camera position sideways:6,camera position upwards:8,camera roll:-30,\
         camera target backwards:-8",
        // It looks back at the scene.
        "camera position backwards:-20,camera target upwards:1",
    ] {
        let (live, values, handle) = own_scene_and_handle(camera);
        let pointer = handle.place(&values).expect("a place") + dvec2(20.0, -30.0);
        let new = live.drag_handle(&values, handle, pointer).expect("values");
        let place = handle.place(&new).expect("a place");
        assert!(place.distance(pointer) < 1.0, "{camera}: {place}");
        let z = handle.parameters[1] + 1;
        assert_eq!(values[z], new[z], "{camera}");
    }
}

#[test]
fn dragged_sphere_stays_where_its_plane_is_edge_on_or_behind() {
    for (camera, pointer) in [
        // The eye is in the plane z = −7.4.
        (
            "camera position sideways:6,camera position backwards:-7.4,\
             camera target backwards:-7.4",
            dvec2(300.0, 100.0),
        ),
        // The upper part of the picture looks back.
        (
            "camera field of view:120,camera target upwards:1,\
             camera target backwards:-0.3,red sphere upwards:5",
            dvec2(320.0, 10.0),
        ),
    ] {
        let (live, values, handle) = own_scene_and_handle(camera);
        assert!(handle.place(&values).is_some(), "{camera}");
        let new = live.drag_handle(&values, handle, pointer);
        assert_eq!(new, Some(values), "{camera}");
    }
}

#[test]
fn k_of_a_sphere_has_a_control_where_there_are_mirrors() {
    for (switch, count) in [(0, 0), (1, 12)] {
        let address = format!("the way back shadows and mirrors:{switch}");
        let (live, values, _) = own_scene_and_handle(&address);
        let parameters = live.parameters.iter();
        let controls = parameters.filter(|parameter| {
            parameter.symbol == "k" && (parameter.has_control)(parameter, &values)
        });
        assert_eq!(controls.count(), count);
    }
}

#[test]
fn p_plus_d_times_l_is_the_position_of_the_light() {
    let live = find_live("step04_diffuse");
    let mut values = live.default_values();
    values[3..].copy_from_slice(&[-1.0, 2.0, -4.0, 2.5, -1.0, -13.0]);
    let p = parse_vector(live, &values, "p");
    for (light, x) in [("warm", 3), ("cool", 6)] {
        let l = parse_vector(live, &values, &format!("l {light}"));
        let d = parse_number(live, &values, &format!("d {light}"))[0];
        let position = DVec3::from_slice(&values[x..]);
        assert!((p + d * l).abs_diff_eq(position, 0.01), "{light}: {}", p + d * l);
    }
}

#[test]
fn material_controls_are_those_of_the_sphere_at_the_probe() {
    let live = find_live("step05_phong");
    for (pixel, colour) in [([583.0, 215.0], "teal"), ([262.0, 132.0], "red")] {
        let mut values = live.default_values();
        values[..2].copy_from_slice(&pixel);
        let has_control = |k: &usize| {
            let parameter = &live.parameters[*k];
            (parameter.has_control)(parameter, &values)
        };
        let controls: Vec<_> = (6..live.parameters.len()).filter(has_control).collect();
        let [n, r_s] = controls[..] else { panic!("{colour}: {controls:?}") };
        assert!(live.parameters[n].words.contains(colour));
        let specular = parse_vector(live, &values, "specular");
        assert_ne!(specular, DVec3::ZERO, "{colour} has a highlight there");
        (values[n], values[r_s]) = (7.0, 0.0);
        assert_eq!(parse_number(live, &values, "shininess"), [7.0]);
        assert_eq!(parse_vector(live, &values, "specular"), DVec3::ZERO);
    }
}

#[test]
fn scene_from_above_marks_every_root() {
    let live = find_live("step03_nearest");
    let companion = live.companion.expect("the scene from above");
    for ([i, j], count) in [([195.0, 237.0], 7), ([600.0, 20.0], 0)] {
        let values = [i, j, 640.0];
        let names = (0..9).flat_map(|k| [format!("near{k}"), format!("far{k}")]);
        let roots = names.flat_map(|name| parse_number(live, &values, &name));
        // The drawing ends at 13.2.
        assert_eq!(roots.filter(|t| *t < 13.2).count(), count);
        let drawing = (companion.draw)(&values);
        let dots = ["\"ray dot\"", "\"behind dot\""]
            .map(|class| drawing.svg_elements().matches(class).count());
        assert_eq!(dots.iter().sum::<usize>(), count);
    }
}

#[test]
fn angle_of_the_drawn_light_is_that_of_the_caption() {
    let live = find_live("phong-vectors");
    for turn in [-30.0, 0.0, 25.0, 70.0] {
        let place = live.handles[0].place(&[turn]).expect("a place");
        let angle = figures::degrees_left_of_up(dvec2(240.0, 240.0), place);
        let number = parse_number(live, &[turn], "angle")[0];
        assert!((angle.abs() - number).abs() < 0.1, "{angle}, {number}");
    }
}

#[test]
fn ratio_of_an_oval_is_as_the_chapter_derives() {
    let live = find_live("eggs");
    let alpha = 8_f64.to_radians();
    for (theta, phi) in [(60.0, 20_f64), (100.0, 40.0), (140.0, 60.0)] {
        assert_eq!(parse_number(live, &[theta], "phi"), [phi]);
        let phi = phi.to_radians();
        let length = (phi + alpha).tan() - (phi - alpha).tan();
        let width = 2.0 * alpha.sin() / (phi.cos().powi(2) - alpha.sin().powi(2)).sqrt();
        let ratio = parse_number(live, &[theta], "times")[0];
        assert!((ratio - length / width).abs() <= 0.051, "{ratio}");
    }
}

/// The flat world after a handle was dragged by (x, y) of the drawing, and the words about
/// the path of its ray.
fn drag_in_flat_world(handle: usize, by: DVec2) -> Option<(Vec<f64>, String)> {
    let live = find_live("flat-world");
    let values = live.default_values();
    let handle = &live.handles[handle];
    let place = handle.place(&values).expect("a place") + by;
    let values = live.drag_handle(&values, handle, place)?;
    let path = (live.numbers)(&values).remove("path").expect("a path");
    Some((values, path))
}

#[test]
fn path_in_the_flat_world_follows_what_is_dragged() {
    let [eye, end, light, ball_2, ball_3] = [0, 1, 2, 4, 5];
    for (handle, by, expected) in [
        (ball_2, dvec2(-90.0, 0.0), "ball 1 at t = 2.84, in the light; then ball 3"),
        (light, dvec2(100.0, 0.0), "ball 1 at t = 2.84, in the light; then ball 3"),
        (ball_3, dvec2(-96.0, 0.0), "ball 1 at t = 2.84, in shadow; then nothing"),
        // V is twice as long.
        (end, dvec2(57.6, -2.4), "ball 1 at t = 1.42, in shadow; then ball 3"),
        (end, dvec2(0.0, 120.0), "nothing"),
    ] {
        let (_, path) = drag_in_flat_world(handle, by).expect("allowed values");
        assert!(path.starts_with(expected), "{handle}: {path}");
    }
    // An eye in a ball, and a V of no length.
    for (handle, by) in [(eye, dvec2(190.0, 40.0)), (end, dvec2(-57.6, 2.4))] {
        assert_eq!(drag_in_flat_world(handle, by), None);
    }
}

#[test]
fn flat_world_draws_what_its_caption_says() {
    let live = find_live("flat-world");
    for (handle, by) in [(0, DVec2::ZERO), (4, dvec2(-90.0, 0.0)), (1, DVec2::X)] {
        let (values, path) = drag_in_flat_world(handle, by).expect("allowed values");
        let figures::Output::Drawing(drawing) = (live.draw)(&values) else { panic!("a picture") };
        let count = |class: &str| drawing.svg_elements().matches(class).count();
        assert_eq!(count("\"light\""), path.matches("in the light").count());
        assert_eq!(count("\"guide\""), path.matches("in shadow").count());
        assert_eq!(count("\"behind dot\""), path.matches("in shadow").count());
        assert_eq!(count("\"hit dot\""), path.matches("ball").count());
        assert_eq!(count("\"object seen\""), path.matches("ball").count());
        // The first hit is at S + tV.
        let t: f64 = path.split(['=', ',']).nth(1).and_then(|t| t.trim().parse().ok()).expect("t");
        let [s, end] = [0, 1].map(|k| live.handles[k].place(&values).expect("a place"));
        let p = s + t * (end - s);
        let dots = drawing.svg_elements().split("\"hit dot\" cx=\"").nth(1);
        let coordinates: Vec<f64> = dots
            .expect("a dot")
            .split('"')
            .step_by(2)
            .take(2)
            .filter_map(|number| number.parse().ok())
            .collect();
        assert!(DVec2::from_slice(&coordinates).distance(p) < 0.5, "{coordinates:?}, {p}");
    }
}
