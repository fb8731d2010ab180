use check::Locked;
use course::workspace;
use course::{
    Mistake, TableRow, find_mistakes_with_hash, hash_picture, locked_hashes, mistakes, table_rows,
};
use std::fs;

const AGAIN: &str = "`cargo xtask` makes it anew";

#[test]
fn the_table_knows_each_mistake() {
    let (all, rows) = (mistakes(), table_rows().collect::<Vec<_>>());
    let is_known = |mistake: &Mistake, row: Option<&TableRow>| {
        let text = fs::read_to_string(workspace().join(&mistake.file));
        let pictures = mistake.book_entry.iter().flat_map(|shown| &shown.pictures);
        let mut pictures = pictures.map(|(name, _)| {
            workspace().join(format!("book/crates/course/mistakes/pictures/{name}.png"))
        });
        row.is_some_and(|row| {
            row.key == TableRow::compute_key(mistake, &text.unwrap_or_default())
                && row.hashes.iter().any(Option::is_some)
        }) && pictures.all(|path| path.exists())
    };
    let pairs = all.iter().zip(0..).filter(|(one, k)| !is_known(one, rows.get(*k)));
    let wrong: Vec<_> = pairs.map(|(one, _)| format!("{}: {}", one.file, one.title)).collect();
    assert!(wrong.is_empty(), "the table is old, {AGAIN}:\n{}", wrong.join("\n"));
    assert_eq!(all.len(), rows.len(), "{AGAIN}");
}

#[test]
fn the_table_knows_what_is_right() {
    let locked = Locked::read_all().expect("locked pictures");
    let names: Vec<_> = locked_hashes().map(|(name, _)| name).collect();
    for (Locked { name, picture }, (_, right)) in locked.iter().zip(locked_hashes()) {
        assert_eq!(right, hash_picture(picture), "{name} has changed: {AGAIN}");
        assert!(
            find_mistakes_with_hash(right).iter().all(|(_, drawn_name)| drawn_name != name),
            "{name}: it is right"
        );
    }
    let drawn_names: Vec<_> = course::PICTURES.iter().map(|(name, _)| *name).collect();
    assert_eq!(drawn_names, names, "the table is old, {AGAIN}");
}
