//! What is answered to a page's requests.

use live::{Sight, find, own_scene};

#[test]
fn a_picture_as_printed_is_that_of_its_step() {
    for (name, picture) in exercises::STEPS {
        let picture = picture(&live::camera(), 1);
        let printed = find(name).expect("it answers").printed();
        let is_same = matches!(printed, Sight::Picture(ours) if ours == picture);
        assert!(is_same, "{name} is another picture");
    }
    let own = find("own_scene").expect("it answers");
    assert_eq!(own_scene(&own.values()), step05_phong::scene());
}

/// What is answered at an address of one's own scene.
fn open(address: &str) -> String {
    live::answer(&format!("open own_scene {address}")).text
}

#[test]
fn a_wrong_address_gets_a_sentence() {
    for (address, what) in [
        ("red-sphere-radius:0", "“0” for red-sphere-radius; allowed are 0.05 to 3"),
        ("camera-field-of-view:NaN", "allowed are 1 to 179"),
        ("red-sphere-radius:2,ground-radius:", "“” for ground-radius; allowed"),
        ("moon-radius:1", "speaks of “moon-radius”"),
    ] {
        let told = open(address);
        assert!(told.contains(what), "{address}: {told}");
    }
}

#[test]
fn an_address_leads_back_to_its_values() {
    let address = "camera-field-of-view:20,red-sphere-radius:2,cool-light-on:0";
    for address in [address, "", "ambient-light-blue:0.07"] {
        let field = format!("\"address\":\"{address}\"");
        assert!(open(address).contains(&field), "{}", open(address));
    }
}
