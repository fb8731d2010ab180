//! What is answered to a page's requests.

use live::{Live, Sight};

#[test]
fn a_picture_as_printed_is_that_of_its_step() {
    let drawn = |live: &Live| match (live.sight)(&live.values()) {
        Sight::Picture { pixels, .. } => pixels,
        Sight::Drawing(_) => vec![],
    };
    let camera = live::camera();
    for (name, picture) in [
        ("step01_rays", step01_rays::picture(&camera, 1)),
        ("step02_sphere", step02_sphere::picture(&camera, 1)),
        ("step03_nearest", step03_nearest::picture(&camera, 1)),
        ("step04_diffuse", step04_diffuse::picture(&camera, 1)),
        ("step05_phong", step05_phong::picture(&camera, 1)),
    ] {
        let live = live::find(name).expect("the picture answers");
        assert!(drawn(live) == live::rgba(&picture), "{name} is another picture");
    }
    let own = live::find("own_scene").expect("the scene of one's own");
    assert_eq!(live::own_scene(&own.values()), step05_phong::scene());
}

#[test]
fn nonsense_gets_a_sentence() {
    for request in [
        "",
        "show",
        "show nowhere",
        "about nowhere",
        "show row",
        "show row 7",
        "drag row 0 1",
        "show row 7 sixty",
        "show row 7 NaN",
        "drag row 5 0 0 7 60",
        "drag row 0 inf 0 7 60",
        "turn row 0 0 0 7 60",
        "é",
        "open nowhere",
    ] {
        let text = live::answer(request).text;
        assert!(text.contains("There is no answer to"), "{request}: {text}");
    }
}

#[test]
fn a_wrong_address_gets_a_sentence() {
    for (address, what) in [
        (
            "red-sphere-radius:0",
            "says 0 for red-sphere-radius; allowed are 0.05 to 3",
        ),
        ("camera-field-of-view:NaN", "allowed are 1 to 179"),
        (
            "red-sphere-radius:2,ground-radius:",
            "“” for ground-radius, which is no number",
        ),
        ("moon-radius:1", "speaks of “moon-radius”"),
        (&"%".repeat(99), "%…”, and nothing here is called so"),
    ] {
        let answer = live::answer(&format!("open own_scene {address}"));
        assert!(answer.text.contains(what), "{address}: {}", answer.text);
        assert!(answer.pixels.is_empty());
    }
}

#[test]
fn an_address_leads_back_to_its_values() {
    let address = "red-sphere-radius:2,cool-light-on:0,camera-field-of-view:20";
    for address in [address, "", "ambient-light-blue:0.07"] {
        let answer = live::answer(&format!("open own_scene {address}"));
        let told =
            answer.text.split_once("\"address\":\"").map_or("", |(_, told)| told);
        let told = told.split('"').next().unwrap_or_default();
        let sorted = |address: &str| {
            let mut parts: Vec<_> = address.split(',').map(str::to_owned).collect();
            parts.sort();
            parts
        };
        assert_eq!(sorted(told), sorted(address));
        assert!(!answer.pixels.is_empty());
    }
}
