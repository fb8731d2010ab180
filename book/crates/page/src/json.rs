//! A JSON reader that supports only what requests need. The JSON writer for replies is in `course`.
//! A value remains text until one of its methods parses it, so the parts of a request that no code
//! reads aren't checked.

use std::str::FromStr;

/// The text of a JSON value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Json<'a>(&'a str);

impl<'a> Json<'a> {
    /// The value `null`.
    pub const NULL: Self = Self("null");

    /// Takes the text of one value, which may have whitespace around it.
    pub fn new(text: &'a str) -> Self {
        Self(text.trim_matches([' ', '\t', '\n', '\r']))
    }

    /// Reads a number. Returns None if the value isn't a number, or doesn't parse as a `T`.
    pub fn number<T: FromStr>(self) -> Option<T> {
        // `str::parse` would also accept +1, and words such as -inf.
        let is_number = !self.0.starts_with('+') && self.0.ends_with(|c: char| c.is_ascii_digit());
        if is_number { self.0.parse().ok() } else { None }
    }

    /// Reads a string. An escape sequence for half of a surrogate pair becomes U+FFFD. Browsers
    /// escape only lone halves, never whole pairs.
    pub fn string(self) -> Option<String> {
        let mut string = String::new();
        let mut chars = self.0.strip_prefix('"')?.strip_suffix('"')?.chars();
        while let Some(c) = chars.next() {
            string.push(match c {
                '"' => return None,
                '\\' => match chars.next()? {
                    'b' => '\u{8}',
                    'f' => '\u{c}',
                    'n' => '\n',
                    'r' => '\r',
                    't' => '\t',
                    'u' => {
                        let mut code = 0;
                        for _ in 0..4 {
                            code = 16 * code + chars.next()?.to_digit(16)?;
                        }
                        char::from_u32(code).unwrap_or(char::REPLACEMENT_CHARACTER)
                    }
                    c => c,
                },
                c => c,
            });
        }
        Some(string)
    }

    /// Reads an array.
    pub fn array(self) -> Option<Vec<Self>> {
        split_outside_strings_and_brackets(self.0.strip_prefix('[')?.strip_suffix(']')?, b',')
    }

    /// Reads an object.
    pub fn object(self) -> Option<Vec<(String, Self)>> {
        let read_field = |field: Json<'a>| {
            let [name, value] = split_outside_strings_and_brackets(field.0, b':')?[..] else {
                return None;
            };
            Some((name.string()?, value))
        };
        let fields =
            split_outside_strings_and_brackets(self.0.strip_prefix('{')?.strip_suffix('}')?, b',')?;
        fields.into_iter().map(read_field).collect()
    }
}

/// Splits a text at a separator, except within strings and brackets. Returns None if a string or a
/// bracket isn't closed.
fn split_outside_strings_and_brackets(text: &str, separator: u8) -> Option<Vec<Json<'_>>> {
    let (mut parts, mut start) = (vec![], 0);
    let (mut depth, mut is_string, mut is_escaped) = (0, false, false);
    for (index, byte) in text.bytes().enumerate() {
        match byte {
            _ if is_escaped => is_escaped = false,
            b'\\' => is_escaped = true,
            b'"' => is_string = !is_string,
            _ if is_string => {}
            b'[' | b'{' => depth += 1,
            b']' | b'}' => depth -= 1,
            _ if byte == separator && depth == 0 => {
                parts.push(Json::new(&text[start..index]));
                start = index + 1;
            }
            _ => {}
        }
    }
    let last_part = Json::new(&text[start..]);
    if !parts.is_empty() || !last_part.0.is_empty() {
        parts.push(last_part);
    }
    (depth == 0 && !is_string).then_some(parts)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_of_each_kind_are_read() {
        let json = Json::new(" { \"a\" : [ {\"b,]\":-0.5}, \"]\\\"\" ,[ ]], \"c:\":null}\n");
        let [(a, list), (c, null)] = &json.object().expect("an object")[..] else { panic!() };
        assert_eq!((&a[..], &c[..], *null), ("a", "c:", Json::NULL));
        let [object, string, empty] = list.array().expect("an array")[..] else { panic!() };
        let [(name, number)] = &object.object().expect("an object")[..] else { panic!() };
        assert_eq!((&name[..], number.number()), ("b,]", Some(-0.5)));
        assert_eq!(string.string().as_deref(), Some("]\""));
        assert_eq!(empty.array(), Some(vec![]));
        assert_eq!(Json::new("{}").object(), Some(vec![]));
    }

    #[test]
    fn numbers_are_read_as_browsers_write_them() {
        let numbers = ["0", "-0.5", "640", "1e-7", "1e+21", "1.7976931348623157e+308"];
        let values = numbers.map(|text| Json::new(text).number());
        assert_eq!(values, [0.0, -0.5, 640.0, 1e-7, 1e21, f64::MAX].map(Some));
        for text in ["", "null", "inf", "NaN", "-", "-inf", "+1", "1.2.3", "1 2", "\"1\"", "[1]"] {
            assert_eq!(Json::new(text).number::<f64>(), None, "{text}");
        }
        assert_eq!(
            ["640", "640.5", "-1", "5000000000"].map(|text| Json::new(text).number()),
            [Some(640_u32), None, None, None]
        );
    }

    #[test]
    fn string_is_unescaped() {
        let json = Json::new(r#""a \"\\\/ θ 🙂 \b\f\n\r\t\u001f\ud83d""#);
        let expected = "a \"\\/ θ 🙂 \u{8}\u{c}\n\r\t\u{1f}\u{fffd}";
        assert_eq!(json.string().as_deref(), Some(expected));
        for text in ["", "a", "\"", "\"a\"b\"", "\"\\\"", "\"\\u12\"", "\"\\u12g4\"", "null"] {
            assert_eq!(Json::new(text).string(), None, "{text}");
        }
    }

    #[test]
    fn array_and_object_refuse_any_other_text() {
        for text in ["", "[", "]", "[[]", "[]]", "[\"]", "[\"\\\"]", "{}"] {
            assert_eq!(Json::new(text).array(), None, "{text}");
        }
        for text in ["", "{", "{{}", "{1}", "{1:2}", "{\"a\"}", "{\"a\":1,}", "{\"a\":1:2}", "[]"] {
            assert_eq!(Json::new(text).object(), None, "{text}");
        }
    }

    #[test]
    fn deep_nesting_is_read() {
        let nested = "[".repeat(1_000_000) + &"]".repeat(1_000_000);
        assert_eq!(Json::new(&nested).array().expect("an array").len(), 1);
    }
}
