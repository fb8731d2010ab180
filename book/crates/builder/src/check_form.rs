//! The form that says whether a reader's picture is right.

use crate::Sources;
use crate::fault::{ChapterError, ChapterResult};

/// The value of `data-check` in a form that accepts any picture. In a form for a single picture,
/// `data-check` is the name of that picture. book/theme/check_form.js has the same constant.
const ANY_PICTURE: &str = "*";

/// Returns the HTML for `{{#check name}}`: a form in which a reader drops a picture to learn
/// whether that picture is right. If `picture_name` is empty, the form accepts any picture, and the
/// name of the reader's file says which picture the file should contain.
///
/// The HTML hides the form, since it doesn't work without scripts. If scripts are enabled,
/// book/theme/css/live.css shows the form from the start.
pub fn check_form_html(picture_name: &str, sources: &Sources) -> ChapterResult<String> {
    let mut scene_field = "";
    let (checked_picture, words) = match picture_name {
        "" => {
            scene_field = "<label>If your teacher gave you a scene, the name on its sheet: \
                           <input name=\"scene\" autocomplete=\"off\"></label>";
            let words = "Drop the picture of a step or an exercise here, or choose its \
                         file. The file’s name tells which picture it should be.";
            (ANY_PICTURE, words.to_owned())
        }
        name if sources.generated.0.contains_key(&format!("{name}.png")) => {
            (name, format!("Drop your <code>{name}.png</code> here, or choose it."))
        }
        name => return Err(ChapterError::UnknownLockedPicture(name.to_owned())),
    };
    Ok(format!(
        "<form class=\"check\" data-check=\"{checked_picture}\" hidden>\
         <label><b>Is it right?</b> {words} The picture stays on your computer. \
         <input type=\"file\" accept=\"image/png\"></label>{scene_field}\
         <button type=\"reset\" class=\"reset\" disabled>Reset</button>\
         <output></output></form>\n"
    ))
}
