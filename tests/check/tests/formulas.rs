//! The formulas as data: they draw what the steps draw, and an edit of them is found.

use ::check::{Verdict, by_formulas, stages};
use gallery::{Step, camera};
use tests::is_thorough;

#[test]
fn the_formulas_draw_the_pictures_of_the_steps() {
    for step in Step::ALL {
        for (size, samples) in [((160, 90), 1), ((64, 48), 2), ((40, 22), 3)] {
            let ours = by_formulas(step, size, samples, None).expect("a picture");
            let right = step.picture(&camera(size.0, size.1), samples);
            assert!(ours == right, "{step:?} {size:?} {samples}");
        }
    }
}

#[test]
fn an_edit_of_a_formula_is_told_and_no_other_stage_is_called_wrong_beside_it() {
    let size = (160, 90);
    for (step, by) in [(Step::Rays, 797), (Step::Sphere, 1401), (Step::Phong, 3999)]
    {
        let right = by_formulas(step, size, 1, None);
        let by = if is_thorough() { by } else { 3 * by };
        for edit in (by / 2..).step_by(by) {
            let Some(yours) = by_formulas(step, size, 1, Some(edit)) else { break };
            if Some(&yours) == right.as_ref() {
                continue;
            }
            let stages = stages(&yours, step);
            let wrong = stages.iter().filter(|s| s.verdict == Verdict::Wrong);
            let told: Vec<_> = wrong.flat_map(|stage| &stage.numbers).collect();
            let is_told = |text: &&&String| text.starts_with("in every pixel, ");
            // One thing is done otherwise: so one is told.
            assert_eq!(
                told.iter().filter(is_told).count(),
                1,
                "{step:?} {edit}: {told:#?}"
            );
        }
    }
}
