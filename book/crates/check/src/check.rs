use crate::explain::explain;
use crate::target::{Target, find_equal, find_name_in_file_name, hash_if_small};
use crate::{Answer, Picture, Verdict, escape_for_terminal, read_png};
use course::{find_mistakes_with_hash, locked_names};
use image::RgbImage;

/// Compares the picture in a PNG file with the locked picture `expected_name`; where that is
/// left out, with the one that the file's own name tells, or that it is, with a listed mistake or
/// without.
///
/// A function gives the locked pictures by their names, or why it can't. Nothing else is read: no
/// file, no argument, no time.
pub fn check_png(
    png: &[u8],
    file_name: &str,
    expected_name: Option<&str>,
    locked_picture: fn(&str) -> Result<RgbImage, String>,
) -> Answer {
    answer_for_file(png, file_name, |picture| {
        let yours = &picture.rgb;
        let mistakes = || hash_if_small(yours).map(find_mistakes_with_hash).unwrap_or_default();
        let name = expected_name
            .or_else(|| find_name_in_file_name(file_name, locked_names().into_iter()))
            .or_else(|| find_equal(yours))
            .or_else(|| mistakes().first().map(|(_, name)| *name));
        let unknown = "no name tells which picture it should be, such as step02_sphere";
        let Some(name) = name else { return Answer::error(unknown) };
        match locked_picture(name).map(|ours| Target::of_locked(name, ours)) {
            Err(why) => Answer::error(why),
            Ok(target) if target.picture == *yours => right(&target.title),
            Ok(target) => explain(yours, &target),
        }
    })
}

/// Compares the picture in a PNG file with the scene that belongs to a name.
pub fn check_scene_png(png: &[u8], file_name: &str, name: &str) -> Answer {
    answer_for_file(png, file_name, |picture| {
        let target = Target::of_scene(name);
        if target.picture == picture.rgb {
            return right(&target.title);
        }
        explain(&picture.rgb, &target)
    })
}

/// The answer of a function about the picture in a file, with what is to be said of the file.
fn answer_for_file(png: &[u8], file_name: &str, check: impl FnOnce(&Picture) -> Answer) -> Answer {
    let picture = match read_png(png) {
        Ok(picture) => picture,
        Err(what) => return Answer::error(format!("{} {what}", escape_for_terminal(file_name))),
    };
    let mut answer = check(&picture);
    if answer.verdict == Verdict::Unreadable {
        return answer;
    }
    if picture.is_transparent && answer.verdict != Verdict::NotRight {
        answer.verdict = Verdict::NotRight;
        answer.text = format!("Not right. Without alpha: {}", answer.text);
    }
    // What the file is explains the most of a wrong picture, and qualifies a right one.
    let notes = picture.notes.iter().map(|note| format!("{note}\n")).collect::<String>();
    let (start, rest) = match answer.text.strip_prefix("Not right. ") {
        Some(rest) => ("Not right. ", rest),
        None => answer.text.split_once('\n').unwrap_or((&answer.text, "")),
    };
    let between = if start.ends_with(' ') { "" } else { "\n" };
    answer.text = format!("{start}{between}{notes}{rest}").trim_end().to_owned();
    let feedback = picture.notes.join(" ") + " " + &answer.feedback;
    answer.feedback = feedback.trim().to_owned();
    answer
}

fn right(title: &str) -> Answer {
    let text = format!("Right: this is {title}, in every pixel.");
    Answer { feedback: String::new(), ..Answer::new(Verdict::Right, text) }
}
