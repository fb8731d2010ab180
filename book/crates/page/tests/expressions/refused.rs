use course::{Place, all_listed_places};
use page::expressions::parse_expression;

/// A place, a text, the part of it that is underlined, and words of what is said.
const REFUSED: [(&str, &str, &str, &str); 51] = [
    // Whole numbers and others.
    ("reflected", "2 * n.dot(l) * n - l", "2", "Write 2.0"),
    ("b", "2 * s.dot(v)", "2", "Write 2.0"),
    ("misses", "d < 0", "0", "Write 0.0"),
    ("gate", "n.dot(l) > 0", "0", "Write 0.0"),
    ("sky", "DVec3::new(0, v.y, 1.0)", "0", "Write 0.0"),
    ("a", "1", "1", "Write 1.0"),
    (
        "specular",
        "material.shininess * light.specular",
        "material.shininess",
        "f64::from(material.shininess)",
    ),
    ("specular", "light.specular * cosine.powi(2.0)", "2.0", "takes a whole number here"),
    ("cosine", "99999999999 as f64", "99999999999", "too large"),
    // Numbers whose type is open.
    ("a", "2.0.sqrt()", "2.0", "2.0_f64"),
    ("a", "(1.0 + 2.0).sqrt()", "(1.0 + 2.0)", "_f64"),
    ("a", "-2.0.abs()", "2.0", "2.0_f64"),
    // Kinds.
    ("normal", "p.length()", "p.length()", "DVec3::splat"),
    ("normal", "1.0", "1.0", "a vector belongs here"),
    ("c", "s - v", "s - v", "a number belongs here"),
    ("c", "s < v", "<", "can't stand between a vector and a vector"),
    ("gate", "n.dot(l)", "n.dot(l)", "Compare"),
    ("gate", "n && true", "&&", "between a vector and true or false"),
    ("cosine", "r.x.dot(v)", ".dot", "belongs to a vector"),
    ("cosine", "r.dot(1.0)", "1.0", "takes a vector here, not a number"),
    ("cosine", "r.dot()", ".dot", "takes 1 in its parentheses, not 0"),
    ("normal", "DVec3::new(1.0, 2.0)", "DVec3::new", "takes 3"),
    ("gate", "0.0 < n.x < 1.0", "<", "a < b && b < c"),
    // Names.
    ("normal", "(p - sphere.center) / sphere.radius", "sphere.center", "sphere.centre"),
    ("cosine", "cos(r.x)", "cos", "r.x.cos()"),
    ("cosine", "dot(r, v)", "dot", "r.dot(…)"),
    ("cosine", "r.dot(v).sine()", ".sine", "sin"),
    ("cosine", "r.length", ".length", "Write .length()"),
    ("cosine", "r.x()", ".x", "without the ()"),
    ("cosine", "PI", "PI", "std::f64::consts::PI"),
    ("sky", "vec3(1.0, 0.0, 0.0)", "vec3", "DVec3::new"),
    // Signs that are not Rust's.
    ("cosine", "r·v", "·", "a.dot(b)"),
    ("cosine", "d²", "²", ".powi(2)"),
    ("cosine", "d^2", "^", ".powi(2)"),
    ("gate", "n = l", "=", "=="),
    ("attenuation", "self.c * d**2", "*", "Powers are .powi(2)"),
    ("attenuation", "d.pow(2)", ".pow", ".powi"),
    ("attenuation", "pow(d, 2)", "pow", "d.powi(…)"),
    ("sum", "self.specular * (self.specular.x < 0.5)", "*", "f64::from(a < b)"),
    ("sky", "DVec3::RED", "DVec3::RED", "DVec3::new"),
    ("a", "v * v", "v * v", "a.dot(b)"),
    // Parentheses and gaps.
    ("a", "(v.dot(v)", "(", "The ) for this is missing"),
    ("a", "v.dot(v", "(", "The ) for this is missing"),
    ("a", "v.dot(v))", ")", "closes nothing"),
    ("a", "2.0 v.dot(v)", "v", "such as *"),
    ("a", "v.dot(v) *", "*", "missing behind"),
    ("a", "", "", "missing"),
    // More than one expression.
    ("gate", "let x = 1.0; 0.0 < x", "let", "One expression fits here"),
    ("a", "if v.x < 0.0 { 1.0 } else { 2.0 }", "if", "f64::from(a < b)"),
    ("a", "{ 1.0 }", "{", "One expression fits here"),
    ("a", "v.dot(&v)", "&", "One expression fits here"),
];

#[test]
fn refused_text_has_its_range_and_sentence() {
    for (name, text, part, words) in REFUSED {
        let Err(mistake) = parse_expression(&find_place(name), text) else {
            panic!("{name}: {text} is not refused");
        };
        let part_and_sentence = (&text[mistake.range.clone()], &*mistake.sentence);
        assert_eq!(part_and_sentence.0, part, "{text}: {}", part_and_sentence.1);
        assert!(part_and_sentence.1.contains(words), "{text}: {}", part_and_sentence.1);
    }
}

/// Texts that are read; those that the book says to write come first.
const ACCEPTED: [(&str, &str); 25] = [
    ("sky", "0.7 + 0.3 * DVec3::new(v.x, v.y, -v.z).normalize()"),
    ("sky", "DVec3::splat((40.0 * v.x).sin())"),
    ("sky", "(4.0 * v).fract().abs()"),
    ("byte", "51.0 * (5.0 * intensity).floor()"),
    ("d_v", "DVec3::new(0.0, 2.0 * tan / columns, 0.0)"),
    ("v", "ray.direction.normalize()"),
    ("disc", "1.0 - direction_colour(ray)"),
    ("c", "s.dot(s) - self.radius * self.radius - 0.3 * (40.0 * v.x).sin()"),
    ("misses", "d < 0.0 || (2.0 * d).fract() < 0.5"),
    ("flat", "hit.object.material * (6.0 / hit.t)"),
    ("flat", "hit.object.material * (4.0 * ray.at(hit.t)).fract().abs()"),
    ("nearer", "best.is_none()"),
    ("nearer", "object.sphere.radius < 1.0"),
    ("normal", "(p - sphere.centre) / sphere.radius + 0.2 * (20.0 * p).sin()"),
    ("diffuse", "material.diffuse * (3.0 * n.dot(l).max(0.0)).ceil() / 3.0"),
    ("attenuation", "0.02 * d * d"),
    ("reflected", "2.0 * n.dot(l) * n - l + 0.1 * (60.0 * n).sin()"),
    ("cosine", "r.dot(v).max((3.0 * r.x).sin())"),
    ("sum", "(5.0 * self.specular).fract()"),
    ("sum", "self.ambient + (3.0 * self.diffuse).ceil() / 4.0 + self.specular"),
    ("sky", "DVec3::splat(f64::from((20.0 * v.x).floor() as i32 % 2 == 0))"),
    ("gate", "!(n.dot(l) <= 0.0) || 1e-3 < d && true"),
    ("cosine", "-r.dot(v).powi(-2).clamp(0.0, 1.0).max(2.0_f64.sqrt())"),
    ("specular", "cosine.powi(material.shininess / 4) * DVec3::Y"),
    ("diffuse", "material.diffuse / light.attenuation.divisor(2.0 * d % 7.0)"),
];

#[test]
fn valid_expressions_parse() {
    for (name, text) in ACCEPTED {
        let read = parse_expression(&find_place(name), text);
        assert!(read.is_ok(), "{text}: {:?}", read.err());
    }
}

#[test]
fn too_long_or_too_deep_text_is_refused() {
    for (text, words) in [
        ("(".repeat(300), "inside each other"),
        ("-".repeat(300), "inside each other"),
        ("1.0.max(".repeat(48), "inside each other"),
        (format!("v.x{}", " + v.x".repeat(100_000)), "longer than a line"),
    ] {
        let mistake = parse_expression(&find_place("a"), &text).err().expect("it is refused");
        assert!(mistake.sentence.contains(words), "{}", mistake.sentence);
    }
}

fn find_place(name: &str) -> Place {
    let found_place = all_listed_places().into_iter().find(|place| place.name == name);
    found_place.unwrap_or_else(|| panic!("no place {name}"))
}
