//! Finds the name that a reader most likely meant.

/// The minimum length of a name in which wrong letters are tolerated.
const MIN_LETTERS: usize = 3;

/// Words from other languages and libraries, each with the names that Rust and glam use for the
/// same thing.
const SYNONYMS: &[(&str, &[&str])] = &[
    ("arccos", &["acos"]),
    ("arcsin", &["asin"]),
    ("arctan", &["atan"]),
    ("b", &["z"]),
    ("ceiling", &["ceil"]),
    ("fabs", &["abs"]),
    ("g", &["y"]),
    ("inverse", &["recip"]),
    ("len", &["length"]),
    ("length2", &["length_squared"]),
    ("log", &["ln"]),
    ("magnitude", &["length"]),
    ("magnitude_squared", &["length_squared"]),
    ("mix", &["lerp"]),
    ("norm", &["length"]),
    ("norm_squared", &["length_squared"]),
    ("pow", &["powi", "powf"]),
    ("r", &["x"]),
    ("sign", &["signum"]),
    ("sum", &["element_sum"]),
    ("unit", &["normalize"]),
];

/// Returns the lowercased name, followed by the names that Rust and glam use for the same thing.
pub fn name_and_synonyms(name: &str) -> Vec<String> {
    let lowercase = name.to_ascii_lowercase();
    let row = SYNONYMS.iter().find(|(word, _)| *word == lowercase);
    let synonyms = row.map_or(&[][..], |(_, names)| names).iter().map(|name| (*name).to_owned());
    let synonyms: Vec<_> = synonyms.collect();
    [vec![lowercase], synonyms].concat()
}

/// Returns the known name that is closest to `name`, if any known name is close enough. A known
/// name is close if one of these statements is true:
///
/// - It equals `name`, ignoring case.
/// - It is a synonym of `name`.
/// - It differs from `name` by one letter, or by two if `name` has six letters or more.
/// - It is a prefix of `name`, and has more than half as many letters.
///
/// The last two statements count only if both names have at least `MIN_LETTERS` letters.
pub fn find_near_name<'a>(
    name: &str,
    known_names: impl Iterator<Item = &'a str>,
) -> Option<&'a str> {
    let accepted_names = name_and_synonyms(name);
    let distance = |known_name: &str| {
        let lowercase = known_name.to_ascii_lowercase();
        if let Some(index) = accepted_names.iter().position(|word| *word == lowercase) {
            return Some(index);
        }
        if lowercase.len().min(name.len()) < MIN_LETTERS {
            return None;
        }
        let distance = strsim::osa_distance(&accepted_names[0], &lowercase);
        let max_distance = if name.len() < 6 { 1 } else { 2 };
        let is_long_prefix = accepted_names[0].starts_with(&lowercase)
            && 2 * lowercase.len() > accepted_names[0].len();
        // A synonym ranks ahead of a typo, and a typo ranks ahead of a prefix.
        (distance <= max_distance || is_long_prefix).then_some(10 * distance)
    };
    let distances = known_names.filter_map(|known_name| Some((distance(known_name)?, known_name)));
    distances.min_by_key(|(distance, _)| *distance).map(|(_, known_name)| known_name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_name_is_found() {
        let known_names =
            ["x", "dot", "length", "length_squared", "lerp", "normalize", "powi", "powf"];
        let find = |name| find_near_name(name, known_names.into_iter());
        for (name, near_name) in [
            ("X", "x"),
            ("r", "x"),
            ("normalise", "normalize"),
            ("normalized", "normalize"),
            ("lenght", "length"),
            ("len", "length"),
            ("norm", "length"),
            ("length_sqared", "length_squared"),
            ("pow", "powi"),
            ("dotty", "dot"),
        ] {
            assert_eq!(find(name), Some(near_name), "{name}");
        }
        for name in ["q", "name", "tan", "do", "centre"] {
            assert_eq!(find(name), None, "{name}");
        }
    }
}
