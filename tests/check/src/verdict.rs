use crate::fov::FOV;
use crate::measure::number;
use crate::recognise::ROUNDING;
use crate::{Found, Mistake, Rest};
use std::fmt::Write;

/// Says what went wrong, as far as it is known, and where to go back to.
pub(crate) fn verdict(found: &Found) -> String {
    let (first, others) = (&found.causes[0], &found.causes[1..]);
    let (name, rest) = (&found.name, rest(&found.rest));
    if first.is_empty() {
        let but = match (found.rest.is_none(), found.samples) {
            (false, _) => "Nearly right",
            _ if found.fov != FOV => "Right but for its field of view",
            (true, 1) => "Right but for its size",
            (true, _) => "Right but for its rays",
        };
        return format!("{but}: this is the picture of {name}{rest}.\n");
    }
    let when = |mistakes: &[&Mistake]| {
        let all: Vec<_> = mistakes.iter().map(|mistake| mistake.when).collect();
        all.join(", and ")
    };
    let mut text = format!(
        "Not right yet: your picture of {name} is{rest} what you get when {}.\n",
        when(first)
    );
    first.iter().for_each(|mistake| text += &back(mistake));
    for other in others {
        let pages: Vec<_> = other.iter().map(|one| one.section.page()).collect();
        let (when, pages) = (when(other), pages.join(", "));
        let _ = writeln!(text, "You get the same picture when {when} ({pages}).");
    }
    if let Some(fov) = found.same_fov {
        let fov = number(fov);
        let _ = writeln!(text, "You get the same picture with --fov {fov}.");
    }
    text
}

/// The pixels that the known causes do not explain, or that were not compared.
fn rest(rest: &Rest) -> String {
    let by = match rest.most() {
        by @ 1..=ROUNDING => format!(" (off by {by} of 255 at most)"),
        _ => String::new(),
    };
    let compared = match rest.compared() {
        all if all == rest.all => String::new(),
        some => format!(" of the {some} that were compared"),
    };
    match rest.beyond(0) {
        0 if compared.is_empty() => String::new(),
        0 => format!(" in all pixels{compared}"),
        1 => format!(" in all but 1 pixel{compared}{by}"),
        pixels => format!(" in all but {pixels} pixels{compared}{by}"),
    }
}

/// Where to go back to, to find one mistake.
fn back(mistake: &Mistake) -> String {
    let Mistake { says, section, .. } = mistake;
    format!(
        "  {says}\n  Go back to step {}, \"{}\" ({}), and compare with {}.\n",
        section.step.number(),
        section.heading,
        section.page(),
        section.path(),
    )
}
