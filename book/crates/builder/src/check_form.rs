//! The form that says whether a reader's picture is right.

use crate::Sources;
use crate::fault::{ChapterError, ChapterResult};

/// The value of `data-check` in the form that accepts any picture. Other forms have the name of a
/// picture there. book/theme/check_form.js has the same constant.
const ANY_PICTURE: &str = "*";

/// Returns the HTML for `{{#check name}}`: a form onto which a reader drops a picture to find out
/// whether it is right. If `picture_name` is empty, the name of the reader's file says which
/// picture it should be.
///
/// The form is hidden until book/theme/check_form.js shows it, since it doesn't work without
/// scripts.
pub fn check_form_html(picture_name: &str, sources: &Sources) -> ChapterResult<String> {
    let mut scene_field = "";
    let (checked_picture, words) = match picture_name {
        "" => {
            scene_field = "<label>If your teacher gave you a scene, the name on its sheet: \
                           <input name=\"scene\" autocomplete=\"off\"></label>";
            let words = "Drop the picture of a step or an exercise here, or choose its file, \
                         whose name tells which it should be.";
            (ANY_PICTURE, words.to_owned())
        }
        name if sources.generated.0.contains_key(&format!("{name}.png")) => {
            (name, format!("Drop your <code>{name}.png</code> here, or choose it."))
        }
        name => return Err(ChapterError::UnknownLockedPicture(name.to_owned())),
    };
    Ok(format!(
        "<form class=\"check\" data-check=\"{checked_picture}\" hidden>\
         <label><b>Is it right?</b> {words} It stays on your computer. \
         <input type=\"file\" accept=\"image/png\"></label>{scene_field}\
         <button type=\"reset\" class=\"reset\" disabled>Reset</button>\
         <output></output></form>\n"
    ))
}
