//! The requests that a page sends to a module. Each is a JSON object, whose field `request`
//! contains the kind of request. For the pages' scripts, the type `ModuleRequest` in
//! tests/browser/theme.d.ts describes the same objects.

use crate::json::Json;
#[cfg(feature = "live")]
use figures::{FigureRequest, FigureRequestError};
use thiserror::Error;

/// A request from a page. Some requests come with a file, which isn't part of the JSON.
///
/// A module knows only the requests that it replies to, so that its code stays small.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Loads the lists of mistakes from the file that comes with the request. The lists aren't
    /// compiled into any module.
    Mistakes,
    /// Checks the file that comes with the request.
    #[cfg(feature = "check")]
    Check {
        /// The name of the file.
        file_name: String,
        /// The name of the expected picture, or None if the crate `check` should find out which
        /// picture the file shows.
        picture: Option<String>,
    },
    /// Checks whether the file that comes with the request is the picture of a person's scene.
    #[cfg(feature = "check")]
    CheckScene {
        /// The name of the file.
        file_name: String,
        /// The name of the person.
        person: String,
    },
    /// Draws a step with edited lines in it.
    #[cfg(feature = "expressions")]
    Edit {
        /// The number of columns in the picture.
        columns: u32,
        /// The edited lines. The reader is editing the first of these now.
        lines: Vec<EditedLine>,
    },
    /// Asks for something about a figure.
    #[cfg(feature = "live")]
    Figure {
        /// The name of the figure.
        figure: String,
        /// The page's request to the figure.
        request: FigureRequest,
    },
}

/// A line that a reader has edited.
#[derive(Clone, Debug, PartialEq)]
pub struct EditedLine {
    /// The name of the line's place.
    pub place: String,
    /// The text that the reader has written at the place.
    pub text: String,
}

/// Why there is no reply to a request.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum RequestError {
    /// The request isn't a JSON object.
    #[error("A request has to be a JSON object.")]
    NoObject,
    /// The module doesn't know this request.
    #[error("There is no request “{0}”.")]
    UnknownRequest(String),
    /// A field is missing, or its value has the wrong type.
    #[error("The field “{name}” has to be {expected}.")]
    Field {
        /// The name of the field.
        name: &'static str,
        /// What the field's value should be.
        expected: &'static str,
    },
    /// A picture with edited lines can't have this many columns.
    #[error("A picture with edited lines can't have {0} columns.")]
    Columns(u32),
    /// No line is edited, or there are more lines than places.
    #[error("A page can't have {0} edited lines.")]
    LineCount(usize),
    /// No place has this name.
    #[error("There is no place “{0}” to edit.")]
    UnknownPlace(String),
    /// The request is about a figure, and there is no reply to it.
    #[cfg(feature = "live")]
    #[error(transparent)]
    Figure(#[from] FigureRequestError),
}

impl Request {
    /// Parses a request.
    pub fn parse(text: &str) -> Result<Self, RequestError> {
        let fields = Fields(Json::new(text).object().ok_or(RequestError::NoObject)?);
        let name: String = fields.get("request")?;
        match &*name {
            "mistakes" => Ok(Self::Mistakes),
            #[cfg(feature = "check")]
            "check" => Ok(Self::Check {
                file_name: fields.get("fileName")?,
                picture: fields.get("picture")?,
            }),
            #[cfg(feature = "check")]
            "check-scene" => Ok(Self::CheckScene {
                file_name: fields.get("fileName")?,
                person: fields.get("person")?,
            }),
            #[cfg(feature = "expressions")]
            "edit" => {
                Ok(Self::Edit { columns: fields.get("columns")?, lines: fields.get("lines")? })
            }
            #[cfg(feature = "live")]
            _ => {
                let request = parse_figure_request(name, &fields)?;
                Ok(Self::Figure { figure: fields.get("figure")?, request })
            }
            #[cfg(not(feature = "live"))]
            _ => Err(RequestError::UnknownRequest(name)),
        }
    }
}

/// Parses a request about a figure.
#[cfg(feature = "live")]
fn parse_figure_request(name: String, fields: &Fields) -> Result<FigureRequest, RequestError> {
    Ok(match &*name {
        "about" => FigureRequest::About,
        "show" => {
            FigureRequest::Show { values: fields.get("values")?, columns: fields.get("columns")? }
        }
        "read" => FigureRequest::Read { values: fields.get("values")? },
        "drag" => FigureRequest::Drag {
            values: fields.get("values")?,
            handle: fields.get("handle")?,
            position: fields.get("position")?,
            columns: fields.get("columns")?,
        },
        "pick" => {
            FigureRequest::Pick { values: fields.get("values")?, position: fields.get("position")? }
        }
        "open" => FigureRequest::Open { address: fields.get("address")? },
        _ => return Err(RequestError::UnknownRequest(name)),
    })
}

/// The fields of a JSON object.
struct Fields<'a>(Vec<(String, Json<'a>)>);

impl Fields<'_> {
    /// Reads a field. A missing field is read as null.
    fn get<T: FromJson>(&self, name: &'static str) -> Result<T, RequestError> {
        let field = self.0.iter().find(|(key, _)| key == name);
        let value = T::from_json(field.map_or(Json::NULL, |(_, value)| *value));
        value.ok_or(RequestError::Field { name, expected: T::NAME })
    }
}

/// A type that a field can have.
trait FromJson: Sized {
    /// The type in words, for an error message.
    const NAME: &'static str;

    /// Reads a JSON value. Returns None if it has the wrong type.
    fn from_json(json: Json) -> Option<Self>;
}

impl FromJson for String {
    const NAME: &'static str = "a string";

    fn from_json(json: Json) -> Option<Self> {
        json.string()
    }
}

impl FromJson for u32 {
    const NAME: &'static str = "a whole number";

    fn from_json(json: Json) -> Option<Self> {
        json.number()
    }
}

impl<T: FromJson> FromJson for Option<T> {
    const NAME: &'static str = T::NAME;

    fn from_json(json: Json) -> Option<Self> {
        if json == Json::NULL { Some(None) } else { T::from_json(json).map(Some) }
    }
}

impl FromJson for [f64; 2] {
    const NAME: &'static str = "a list of two numbers";

    fn from_json(json: Json) -> Option<Self> {
        let [first, second] = json.array()?[..] else { return None };
        Some([first.number()?, second.number()?])
    }
}

impl FromJson for Vec<(String, f64)> {
    const NAME: &'static str = "an object with numbers";

    fn from_json(json: Json) -> Option<Self> {
        let fields = json.object()?.into_iter();
        fields.map(|(name, value)| Some((name, value.number()?))).collect()
    }
}

impl FromJson for Vec<EditedLine> {
    const NAME: &'static str = "a list of edited lines";

    fn from_json(json: Json) -> Option<Self> {
        let lines = json.array()?.into_iter().map(|line| {
            let fields = Fields(line.object()?);
            Some(EditedLine { place: fields.get("place").ok()?, text: fields.get("text").ok()? })
        });
        lines.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn values<const N: usize>(values: [(&str, f64); N]) -> Vec<(String, f64)> {
        values.map(|(name, value)| (name.to_owned(), value)).into()
    }

    #[test]
    fn requests_are_parsed() {
        let (file_name, picture) = ("my.png".to_owned(), Some("mirror".to_owned()));
        let person = "Zoë \"Z\" O'Hara\n".to_owned();
        let line = |place: &str, text: &str| EditedLine { place: place.into(), text: text.into() };
        for (text, request) in [
            (r#"{"request":"mistakes"}"#, Request::Mistakes),
            (
                r#"{"request":"check","fileName":"my.png","picture":"mirror"}"#,
                Request::Check { file_name: file_name.clone(), picture },
            ),
            (
                r#"{"request":"check","fileName":"my.png","picture":null}"#,
                Request::Check { file_name: file_name.clone(), picture: None },
            ),
            (
                r#"{"request":"check-scene","fileName":"my.png","person":"Zoë \"Z\" O'Hara\n"}"#,
                Request::CheckScene { file_name, person },
            ),
            (
                r#"{"request":"edit","columns":640,"lines":[{"place":"a","text":"v.dot(v)"},{"place":"b","text":""}]}"#,
                Request::Edit { columns: 640, lines: vec![line("a", "v.dot(v)"), line("b", "")] },
            ),
        ] {
            assert_eq!(Request::parse(text), Ok(request), "{text}");
        }
    }

    #[test]
    fn requests_about_figures_are_parsed() {
        let values = values([("rays", 7.0), ("field-of-view", -0.5)]);
        let (columns, position) = (Some(320), [1.5, -2.0]);
        for (fields, request) in [
            (r#""request":"about""#, FigureRequest::About),
            (
                r#""request":"show","values":{"rays":7,"field-of-view":-0.5}"#,
                FigureRequest::Show { values: values.clone(), columns: None },
            ),
            (
                r#""request":"show","values":{"rays":7,"field-of-view":-0.5},"columns":320"#,
                FigureRequest::Show { values: values.clone(), columns },
            ),
            (
                r#""request":"read","values":{"rays":7,"field-of-view":-0.5},"columns":null"#,
                FigureRequest::Read { values: values.clone() },
            ),
            (
                r#""request":"drag","values":{"rays":7,"field-of-view":-0.5},"columns":320,"handle":2,"position":[1.5,-2]"#,
                FigureRequest::Drag { values: values.clone(), handle: 2, position, columns },
            ),
            (
                r#""request":"pick","values":{"rays":7,"field-of-view":-0.5},"position":[1.5,-2]"#,
                FigureRequest::Pick { values: values.clone(), position },
            ),
            (
                r#""request":"open","address":"rays:7""#,
                FigureRequest::Open { address: "rays:7".to_owned() },
            ),
        ] {
            let expected = Request::Figure { figure: "row".to_owned(), request };
            let text = format!(r#"{{"figure":"row",{fields}}}"#);
            assert_eq!(Request::parse(&text), Ok(expected), "{text}");
        }
    }

    #[test]
    fn malformed_request_is_an_error_that_says_what_is_wrong() {
        for (text, message) in [
            ("", "A request has to be a JSON object."),
            ("show row rays:7", "A request has to be a JSON object."),
            ("[]", "A request has to be a JSON object."),
            ("{}", "The field “request” has to be a string."),
            (r#"{"request":"dance"}"#, "There is no request “dance”."),
            (r#"{"request":"about"}"#, "The field “figure” has to be a string."),
            (
                r#"{"request":"show","figure":"row"}"#,
                "The field “values” has to be an object with numbers.",
            ),
            (
                r#"{"request":"show","figure":"row","values":{"rays":null}}"#,
                "The field “values” has to be an object with numbers.",
            ),
            (
                r#"{"request":"show","figure":"row","values":{},"columns":"8"}"#,
                "The field “columns” has to be a whole number.",
            ),
            (
                r#"{"request":"drag","figure":"row","values":{},"handle":-1,"position":[0,0]}"#,
                "The field “handle” has to be a whole number.",
            ),
            (
                r#"{"request":"drag","figure":"row","values":{},"handle":0,"position":[0,0,0]}"#,
                "The field “position” has to be a list of two numbers.",
            ),
            (
                r#"{"request":"edit","columns":640.5,"lines":[]}"#,
                "The field “columns” has to be a whole number.",
            ),
            (
                r#"{"request":"edit","columns":640,"lines":[{"place":"a"}]}"#,
                "The field “lines” has to be a list of edited lines.",
            ),
            (r#"{"request":"check","picture":null}"#, "The field “fileName” has to be a string."),
        ] {
            let error = Request::parse(text).expect_err(text);
            assert_eq!(error.to_string(), message, "{text}");
        }
    }

    /// Fails if a request is renamed only in Rust. Without this test, the first failure would be in
    /// a browser.
    #[test]
    fn each_request_that_scripts_send_is_known() {
        let types = include_str!("../../../../tests/browser/theme.d.ts");
        let names: Vec<_> = types.split("request: \"").skip(1).collect();
        assert!(names.len() >= 10, "{names:?}");
        for name in names {
            let (name, _) = name.split_once('"').expect("a name in quotes");
            let parsed = Request::parse(&format!("{{\"request\":{name:?}}}"));
            assert_ne!(parsed, Err(RequestError::UnknownRequest(name.to_owned())));
        }
    }
}
