//! Turns the source of a crate into the source of a module.

/// Rewrites a source file of a crate, so that the crate can be a module of another crate. `path` is
/// the path of the module, such as `steps::step03_nearest`. If the name of an imported crate starts
/// with one of `siblings`, the import refers to a sibling module instead. Imports of all other
/// crates stay as they are.
///
/// Replaces only `crate::` and `use SIBLING`. The steps don't refer to themselves or to each other
/// in any other way.
pub fn crate_as_module<'a>(
    text: &str,
    path: &str,
    siblings: impl IntoIterator<Item = &'a str>,
) -> String {
    let text = text.replace("crate::", &format!("crate::{path}::"));
    let parent = path.rsplit_once("::").map_or(String::new(), |(parent, _)| format!("::{parent}"));
    siblings.into_iter().fold(text, |text, sibling| {
        text.replace(&format!("use {sibling}"), &format!("use crate{parent}::{sibling}"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_lead_into_the_module_and_to_its_siblings() {
        let text = "use crate::Ray;\nuse step01_rays::Camera;\nuse glam::DVec3;\n";
        let module = crate_as_module(text, "steps::step02_sphere", ["step01_rays"]);
        assert_eq!(
            module,
            "use crate::steps::step02_sphere::Ray;\nuse crate::steps::step01_rays::Camera;\n\
             use glam::DVec3;\n"
        );
    }

    #[test]
    fn module_at_the_root_has_its_siblings_at_the_root() {
        let module = crate_as_module("use step01_rays::Ray;", "step02_sphere", ["step01_rays"]);
        assert_eq!(module, "use crate::step01_rays::Ray;");
    }
}
