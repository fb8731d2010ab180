//! Compares the fields of replies with the types in tests/browser/theme.d.ts, on which the pages'
//! scripts rely. If a field were renamed only in Rust, a script would read `undefined` under the
//! field's old name.

use crate::json::Json;
use crate::reply;
use image::ImageFormat;
use image::metadata::Orientation;
use std::collections::BTreeSet;
use std::io::Cursor;
use std::sync::LazyLock;

/// The types in theme.d.ts, without the comments.
static TYPES: LazyLock<String> = LazyLock::new(|| {
    let types = include_str!("../../../../tests/browser/theme.d.ts").lines();
    let code = types.filter(|line| !line.trim_start().starts_with(['/', '*']));
    code.map(|line| format!("{line}\n")).collect()
});

/// A picture that is right for step 2, and wrong for step 1.
const PICTURE: &[u8] = include_bytes!("../../../../tests/snapshots/step02_sphere.snap.png");

/// The picture of step 2, upside down. When it is checked, the reply links to a section of the
/// book.
static UPSIDE_DOWN: LazyLock<Vec<u8>> = LazyLock::new(|| {
    let mut picture = image::load_from_memory(PICTURE).expect("a picture");
    picture.apply_orientation(Orientation::FlipVertical);
    let mut png = Cursor::new(vec![]);
    picture.write_to(&mut png, ImageFormat::Png).expect("a picture");
    png.into_inner()
});

/// Requests, each with its file. Every field that a reply can have occurs in the reply to at least
/// one of these requests.
static REQUESTS: LazyLock<[(&str, &[u8]); 16]> = LazyLock::new(|| {
    [
        (r#"{"request":"mistakes"}"#, b""),
        (r#"{"request":"check","fileName":"my.png","picture":"step02_sphere"}"#, PICTURE),
        (r#"{"request":"check","fileName":"my.png","picture":"step02_sphere"}"#, &UPSIDE_DOWN),
        (r#"{"request":"check","fileName":"my.png","picture":"step01_rays"}"#, PICTURE),
        (r#"{"request":"check","fileName":"my.png","picture":"step01_rays"}"#, b"no picture"),
        (r#"{"request":"check-scene","fileName":"my.png","person":"Ada"}"#, b"no picture"),
        (r#"{"request":"edit","columns":16,"lines":[{"place":"a","text":"1.0"}]}"#, b""),
        (r#"{"request":"edit","columns":16,"lines":[{"place":"a","text":"1"}]}"#, b""),
        (r#"{"request":"about","figure":"row"}"#, b""),
        (r#"{"request":"about","figure":"own_scene"}"#, b""),
        (r#"{"request":"show","figure":"row","values":{},"columns":null}"#, b""),
        (r#"{"request":"show","figure":"own_scene","values":{},"columns":16}"#, b""),
        (r#"{"request":"read","figure":"own_scene","values":{}}"#, b""),
        (
            r#"{"request":"drag","figure":"own_scene","values":{},"columns":16,"handle":0,"position":[1,2]}"#,
            b"",
        ),
        (r#"{"request":"pick","figure":"own_scene","values":{},"position":[1,2]}"#, b""),
        (r#"{"request":"open","figure":"row","address":""}"#, b""),
    ]
});

/// A field of a type in theme.d.ts.
struct Field {
    name: &'static str,
    is_optional: bool,
    type_name: &'static str,
}

/// Returns the fields of an interface, or None if no interface has this name. Instead of a name,
/// `type_name` may be an object type that is written out, such as `{ object: string | null }`.
fn find_interface_fields(type_name: &'static str) -> Option<Vec<Field>> {
    let written_body =
        type_name.strip_prefix('{').and_then(|object_type| object_type.strip_suffix('}'));
    let (mut fields, body) = match written_body {
        Some(body) => (vec![], body),
        None => {
            let (_, interface) = TYPES.split_once(&format!("\ninterface {type_name} "))?;
            let (parent, interface_body) = interface.split_once("{\n").expect(type_name);
            let (body, _) = interface_body.split_once("\n}\n").expect(type_name);
            let parent = parent.trim().strip_prefix("extends ");
            (parent.and_then(find_interface_fields).unwrap_or_default(), body)
        }
    };
    let lines = body.split(';').filter(|line| !line.trim().is_empty());
    fields.extend(lines.map(|line| {
        let (name, type_name) = line.split_once(':').expect(line);
        let (name, type_name) = (name.trim().trim_matches('"'), type_name.trim());
        match name.strip_suffix('?') {
            Some(name) => Field { name, is_optional: true, type_name },
            None => Field { name, is_optional: false, type_name },
        }
    }));
    Some(fields)
}

/// The results of comparing replies with their types.
#[derive(Default)]
struct Comparison {
    /// The types of the replies and of the objects in them.
    types: BTreeSet<&'static str>,
    /// The fields that at least one reply had, such as `EditReply.line`.
    reply_fields: BTreeSet<String>,
    faults: Vec<String>,
}

impl Comparison {
    /// Compares the names of an object's fields with the names in the object's type. If a field is
    /// a list of objects, compares each object in the list with its type, too.
    fn compare(&mut self, type_name: &'static str, object: &[(String, Json)]) {
        let fields = find_interface_fields(type_name).expect(type_name);
        self.types.insert(type_name);
        for (name, _) in object {
            if fields.iter().all(|field| field.name != name) {
                self.faults.push(format!("{type_name} has no field {name}."));
            }
        }
        for Field { name, is_optional, type_name: field_type } in fields {
            match object.iter().find(|(key, _)| key == name) {
                Some((_, value)) => {
                    self.reply_fields.insert(format!("{type_name}.{name}"));
                    let item_type = field_type.strip_suffix("[]");
                    if let Some(item_type) =
                        item_type.filter(|name| find_interface_fields(name).is_some())
                    {
                        for item in value.array().expect(name) {
                            self.compare(item_type, &item.object().expect(item_type));
                        }
                    }
                }
                None if is_optional => {}
                None => self.faults.push(format!("A reply lacks {type_name}.{name}.")),
            }
        }
    }

    /// Returns all faults, including each field that no reply had.
    fn into_faults_with_unseen_fields(mut self) -> Vec<String> {
        for type_name in self.types {
            for Field { name, .. } in find_interface_fields(type_name).expect(type_name) {
                let field = format!("{type_name}.{name}");
                if !self.reply_fields.contains(&field) {
                    self.faults.push(format!("No reply has {field}."));
                }
            }
        }
        self.faults
    }
}

#[test]
fn replies_have_the_fields_that_the_scripts_expect() {
    let kinds = find_interface_fields("ModuleReplies").expect("the replies");
    let mut comparison = Comparison::default();
    let mut requested = BTreeSet::new();
    for &(request, file) in &*REQUESTS {
        let fields = Json::new(request).object().expect(request);
        let (_, name) = &fields[0];
        let name = name.string().expect(request);
        let kind = kinds.iter().find(|kind| kind.name == name).expect(request);
        requested.insert(kind.name);
        let reply = reply(request, file);
        let mut object = Json::new(&reply.text).object().expect(request);
        // The reply's text doesn't contain the pixels. The script wasm.js adds them as a field.
        if !reply.pixels.is_empty() {
            object.push(("pixels".to_owned(), Json::NULL));
        }
        comparison.compare(kind.type_name, &object);
    }
    assert_eq!(comparison.into_faults_with_unseen_fields(), [""; 0]);
    assert_eq!(requested, kinds.iter().map(|kind| kind.name).collect());
}
