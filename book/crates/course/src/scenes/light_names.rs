//! The names of the steps' two lights.

/// A light's name, in the forms that a sentence may need.
#[derive(Clone, Copy, Debug)]
pub struct LightName {
    /// For example `warm`.
    pub adjective: &'static str,
    /// For example `warm light`.
    pub name: &'static str,
    /// For example `the warm light`.
    pub with_article: &'static str,
}

macro_rules! light_name {
    ($adjective:literal) => {
        LightName {
            adjective: $adjective,
            name: concat!($adjective, " light"),
            with_article: concat!("the ", $adjective, " light"),
        }
    };
}

/// The names of the two lights in steps 4 and 5, in the order of the scene's `lights`.
pub const LIGHT_NAMES: [LightName; 2] = [light_name!("warm"), light_name!("cool")];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lights_are_named_in_the_order_of_the_scene() {
        use step04_diffuse::{COOL_LIGHT, WARM_LIGHT};
        let lights = [("the warm light", WARM_LIGHT), ("the cool light", COOL_LIGHT)];
        let names = LIGHT_NAMES.map(|light| light.with_article).into_iter();
        let diffuse = names.clone().zip(step04_diffuse::scene().lights);
        assert_eq!(diffuse.collect::<Vec<_>>(), lights);
        let positions = step05_phong::scene().lights.into_iter().map(|light| light.point_light);
        assert_eq!(names.zip(positions).collect::<Vec<_>>(), lights);
    }
}
