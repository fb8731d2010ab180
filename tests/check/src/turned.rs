use crate::apart;
use crate::fov::FOV;
use crate::recognise::ROUNDING;
use crate::view::View;
use crate::{Found, Locked, Mistake, Rest, mistakes};

/// The mistakes that can be told from two pictures alone: those of an exercise too.
pub(crate) fn turned(yours: &View, ours: &Locked) -> Option<Found> {
    if yours.size != ours.picture.dimensions() {
        return None;
    }
    let choices = (0..8).map(|bits| [1, 2, 4].map(|bit| bits & bit != 0));
    // Some of the pixels tell which, all of them whether it is.
    let some = yours.scattered(4000);
    let beyond = |choice: &[bool; 3]| {
        rest(yours, ours, *choice, some.iter().copied()).beyond(ROUNDING)
    };
    let choice = choices.min_by_key(beyond)?;
    let all = yours.kept.enumerate_pixels().map(|(i, j, _)| (i, j));
    let rest = rest(yours, ours, choice, all);
    let chosen = |one: &&Mistake| {
        let mut names = ["y-down", "mirrored", "bgr"].iter().zip(choice);
        names.any(|(name, is_chosen)| is_chosen && *name == one.name)
    };
    let mistakes: Vec<_> = mistakes().filter(chosen).collect();
    // Only of what is right it is said that it may be rounded.
    let rounding = if mistakes.is_empty() { ROUNDING } else { 0 };
    let (name, causes) = (ours.name.clone(), vec![mistakes]);
    let few = rest.is_few(rounding).then_some(rest)?;
    Some(Found { name, samples: 1, fov: FOV, causes, same_fov: None, rest: few })
}

/// How far the picture is from ours where that is upside down, or mirrored, or has red
/// and blue in each other's places.
fn rest(
    yours: &View,
    ours: &Locked,
    [is_down, is_left, is_swapped]: [bool; 3],
    places: impl Iterator<Item = (u32, u32)>,
) -> Rest {
    let (width, height) = yours.size;
    let mut rest = Rest::new(yours.pixels());
    for (i, j) in places {
        let yours = yours.pixel(i, j);
        let i = if is_left { width - 1 - i } else { i };
        let j = if is_down { height - 1 - j } else { j };
        let mut ours = *ours.picture.get_pixel(i, j);
        if is_swapped {
            ours.0.reverse();
        }
        rest.add(apart(yours, &ours));
    }
    rest
}
