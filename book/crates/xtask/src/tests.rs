//! Tests that the checked-in files are up to date with the code that they are made from.

use crate::mistakes::{DrawnMistakes, redraw_key};
use crate::mistakes_program::title_and_file;
use crate::wasm_modules;
use course::environment::is_ci;
use course::{MistakePicture, Step, WASM_MODULES, mistake_files, mistakes};
use std::collections::HashSet;
use std::fs;
use std::io::{Write, stderr};

#[test]
fn wasm_modules_are_up_to_date_with_their_sources() {
    let note =
        "The pages' modules are older than their source code. Run `cargo xtask` to compile them.";
    let is_stale = wasm_modules::are_stale().expect("the sources can be read");
    assert!(!is_stale || !is_ci(), "{note}");
    if is_stale {
        // Unlike the output of println!, this note is shown even if the test passes.
        let _ = writeln!(stderr(), "\nNote: {note}");
    }
}

#[test]
fn wasm_modules_export_the_functions_that_pages_call() {
    let script = include_str!("../../../theme/wasm.js");
    let calls = script.split("module.").skip(1).filter_map(|call| call.split_once('('));
    let names: HashSet<_> = calls.map(|(name, _)| name).filter(|name| name.contains('_')).collect();
    assert_eq!(names.len(), 2, "{names:?}");
    for module in WASM_MODULES {
        let path = wasm_modules::page_package_folder().join(format!("{module}.wasm"));
        let bytes = fs::read(path).expect("the module can be read");
        for name in &names {
            let is_exported = bytes.windows(name.len()).any(|part| part == name.as_bytes());
            assert!(
                is_exported,
                "{module}.wasm has no {name}. Run `cargo xtask` to compile it again."
            );
        }
    }
}

#[test]
fn table_of_mistakes_is_up_to_date() {
    let drawn_mistakes = DrawnMistakes::read()
        .expect("each mistake's code occurs once, and each picture can be read");
    let new: Vec<_> =
        drawn_mistakes.mistakes_to_draw().map(|(_, mistake)| title_and_file(mistake)).collect();
    let note = "These mistakes haven't been drawn yet. Run `cargo xtask` to draw them:";
    assert!(new.is_empty(), "{note}\n{}", new.join("\n"));
    let texts = mistake_files().expect("this program includes the texts");
    assert!(
        drawn_mistakes.table_text() == texts.table,
        "table.txt is out of date. Run `cargo xtask` to write it."
    );
}

#[test]
fn mistake_is_redrawn_if_the_name_or_step_of_its_picture_changes() {
    let mut mistake = mistakes()[0].clone();
    let original_key = redraw_key(&mistake, &[]).ok();
    let presentation = mistake.presentation.as_mut().expect("the book shows the first mistake");
    let picture = presentation.pictures[0];
    for changed in [
        MistakePicture { step: Step::Phong, ..picture },
        MistakePicture { name: "another", ..picture },
    ] {
        let mut mistake = mistakes()[0].clone();
        mistake.presentation.as_mut().expect("the book shows the first mistake").pictures =
            vec![changed];
        assert_ne!(original_key, redraw_key(&mistake, &[]).ok(), "{changed:?}");
    }
}

#[test]
fn each_mistake_changes_code_has_all_texts_and_is_listed_once() {
    let mut changes = HashSet::new();
    for mistake in mistakes() {
        let title = title_and_file(mistake);
        assert_ne!(mistake.old, mistake.new, "{title}");
        if let Some(presentation) = &mistake.presentation {
            let is_valid = |picture: &MistakePicture| picture.step >= mistake.step;
            assert!(
                presentation.pictures.iter().all(is_valid),
                "{title}: {:?}",
                presentation.pictures
            );
            let texts = [presentation.reason, presentation.section, presentation.effect];
            assert!(
                texts.iter().all(|text| !text.is_empty()),
                "{title} has an empty text: {texts:?}"
            );
        }
        let is_new = changes.insert((mistake.file.clone(), mistake.format_as_diff()));
        assert!(is_new, "{title} is listed twice");
    }
}
