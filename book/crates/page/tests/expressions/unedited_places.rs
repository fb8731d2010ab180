use check::LockedPictures;
use page::expressions::{draw_edited, editable_places, parse_expression, place_faults};

#[test]
fn no_place_has_a_fault() {
    let faults = place_faults();
    assert!(
        faults.is_empty(),
        "The steps have changed; mend book/crates/course/places.txt:\n{}",
        faults.join("\n")
    );
    assert_eq!(editable_places().len(), 30);
}

#[test]
fn unedited_places_draw_the_locked_pictures() {
    let locked = LockedPictures::in_workspace();
    for place in editable_places() {
        let expression = parse_expression(&place, place.code).expect("it stands in the book");
        let locked = locked.get(place.step_name()).expect("a locked picture");
        let (step, edits) = (place.step_name(), vec![(place.clone(), expression)]);
        let is_same = draw_edited(step, edits, 640, u64::MAX).as_ref() == Ok(&*locked);
        assert!(is_same, "{}: {} draws another picture", place.name, place.code);
    }
}
