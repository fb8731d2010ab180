//! Answers to the requests of a page.

use figures::{Output, find, own_scene};

#[test]
fn default_picture_is_that_of_the_program() {
    let mirror: course::Picture = course::examples::mirror::picture;
    for (name, picture) in course::PICTURES[..5].iter().copied().chain([("mirror", mirror)]) {
        let output = find(name).expect("a picture").default_output();
        let Output::Picture(default) = output else { panic!("{name} is drawn") };
        assert!(default == picture(&figures::camera(), 1), "{name} is another picture");
    }
}

#[test]
fn default_own_scene_is_that_of_step_5() {
    let values = find("own_scene").expect("a picture").default_values();
    assert_eq!(own_scene(&values).scene, step05_phong::scene());
}

#[test]
fn own_scene_with_shadows_and_mirrors_is_that_of_the_example() {
    let live = find("own_scene").expect("a picture");
    let mut values = live.default_values();
    let mut parameters = live.parameters.iter();
    let switch = parameters.position(|p| p.words == "shadows and mirrors");
    values[switch.expect("a switch")] = 1.0;
    let Output::Picture(picture) = (live.draw)(&values) else { panic!("the scene is drawn") };
    assert!(picture == course::examples::mirror::picture(&figures::camera(), 1));
}

/// The answer to an address of the own scene.
fn open(address: &str) -> String {
    figures::answer(&format!("open own_scene {address}")).text
}

#[test]
fn wrong_address_is_answered_by_a_sentence() {
    for (address, sentence) in [
        ("red-sphere-radius:0", "“0” for red-sphere-radius; allowed are 0.05 to 3"),
        ("camera-field-of-view:NaN", "allowed are 1 to 179"),
        ("red-sphere-radius:2,ground-radius:", "“” for ground-radius; allowed"),
        ("moon-radius:1", "speaks of “moon-radius”"),
        // The camera is at its own target.
        ("camera-position-backwards:-1", "nothing to show at this address"),
    ] {
        let answer = open(address);
        assert!(answer.contains(sentence), "{address}: {answer}");
    }
}

#[test]
fn address_is_parsed_and_formatted_without_change() {
    let address = "camera-field-of-view:20,red-sphere-radius:2,cool-light-on:0";
    let camera = "camera-position-sideways:3,camera-position-upwards:2,\
                  camera-position-backwards:-4,camera-target-sideways:1,\
                  camera-target-upwards:-1,camera-target-backwards:-7,camera-roll:-20";
    let mirrors = "the-way-back-shadows-and-mirrors:1,red-sphere-mirror-image:0.5";
    for address in [address, "", "ambient-light-blue:0.07", camera, mirrors] {
        let field = format!("\"address\":\"{address}\"");
        assert!(open(address).contains(&field), "{}", open(address));
    }
}

#[test]
fn address_of_an_earlier_edition_opens_its_scene() {
    let address = "red-sphere-radius:2,camera-field-of-view:45,third-light-on:1,\
                   ground-mirrored:0.5,cool-light-quadratic-fading:0.03";
    for part in address.split(',') {
        assert!(open(address).contains(part), "{part}: {}", open(address));
    }
}
