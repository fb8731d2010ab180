//! Answers to the requests of a page.

use live::{Output, find, own_scene};

#[test]
fn default_picture_is_that_of_the_step() {
    for (name, picture) in exercises::STEPS {
        let output = find(name).expect("a picture").default_output();
        let Output::Picture(default) = output else { panic!("{name} is drawn") };
        assert!(
            default == picture(&live::camera(), 1),
            "{name} is another picture"
        );
    }
}

#[test]
fn default_own_scene_is_that_of_step_5() {
    let values = find("own_scene").expect("a picture").default_values();
    assert_eq!(own_scene(&values), step05_phong::scene());
}

/// The answer to an address of the own scene.
fn open(address: &str) -> String {
    live::answer(&format!("open own_scene {address}")).text
}

#[test]
fn wrong_address_is_answered_by_a_sentence() {
    for (address, sentence) in [
        ("red-sphere-radius:0", "“0” for red-sphere-radius; allowed are 0.05 to 3"),
        ("camera-field-of-view:NaN", "allowed are 1 to 179"),
        ("red-sphere-radius:2,ground-radius:", "“” for ground-radius; allowed"),
        ("moon-radius:1", "speaks of “moon-radius”"),
    ] {
        let answer = open(address);
        assert!(answer.contains(sentence), "{address}: {answer}");
    }
}

#[test]
fn address_is_parsed_and_formatted_without_change() {
    let address = "camera-field-of-view:20,red-sphere-radius:2,cool-light-on:0";
    for address in [address, "", "ambient-light-blue:0.07"] {
        let field = format!("\"address\":\"{address}\"");
        assert!(open(address).contains(&field), "{}", open(address));
    }
}
