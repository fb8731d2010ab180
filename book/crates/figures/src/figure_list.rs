//! The list of all figures.

use crate::figures::*;
use crate::pictures::*;
use crate::{Figure, own_scene};
use std::sync::LazyLock;

/// Every figure: first the drawings, then the pictures, both in the order of the book.
pub static FIGURES: LazyLock<Vec<Figure>> = LazyLock::new(|| {
    vec![
        ray::figure(),
        pinhole::figure(),
        frustum::figure(),
        row_of_rays::figure(),
        right_hand::figure(),
        camera::figure(),
        three_cases::figure(),
        hits_along_a_ray::figure(),
        scene_from_above::figure(),
        ball_outlines::figure(),
        lambert::figure(),
        attenuation::figure(),
        phong_vectors::figure(),
        specular_lobes::figure(),
        rim::figure(),
        flat_world::figure(),
        step01::figure(),
        step01::figure_with_probe(),
        step01::checkerboard_figure(),
        step02::figure(),
        step03::figure(),
        step04::figure(),
        step05::figure(),
        mirror::figure(),
        own_scene::figure(),
    ]
});

/// Finds the figure with this name.
pub fn find_figure(name: &str) -> Option<&'static Figure> {
    FIGURES.iter().find(|figure| figure.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::row_readout_name;
    use std::collections::HashSet;

    #[test]
    fn names_of_figures_and_of_their_parameters_are_unique() {
        let mut names = HashSet::new();
        for figure in FIGURES.iter() {
            assert!(names.insert(figure.name), "{}", figure.name);
            let mut ids = HashSet::new();
            for parameter in &figure.parameters {
                let id = parameter.id.to_string();
                assert!(!id.contains([' ', ',', ':']), "{id}");
                assert!(ids.insert(id.clone()), "{}: {id}", figure.name);
            }
        }
    }

    #[test]
    fn handles_set_parameters_of_their_figure() {
        for figure in FIGURES.iter() {
            let values = figure.default_values();
            for handle in &figure.handles {
                let ids =
                    [Some(handle.horizontal), Some(handle.vertical), handle.depth, handle.presence];
                // Indexing `values` panics if the figure has no parameter with this id.
                assert!(
                    ids.into_iter().flatten().all(|id| values[id].is_finite()),
                    "{}",
                    figure.name
                );
            }
        }
    }

    #[test]
    fn row_count_of_each_figure_is_that_of_its_readouts() {
        for figure in FIGURES.iter() {
            let readouts = (figure.readouts)(&figure.default_values());
            // The table of the figure `mirror` has a column `k`, and every other table has a column
            // `a`.
            let has_row = |row| {
                ["a", "k"].iter().any(|name| readouts.contains_key(&row_readout_name(name, row)))
            };
            assert!((0..figure.row_count).all(has_row), "{}", figure.name);
            assert!(!has_row(figure.row_count), "{}", figure.name);
        }
    }
}
