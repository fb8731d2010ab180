use crate::expressions::node::{Expression, REMAINING_STEPS};
use crate::expressions::refusal::Refusal;
use crate::expressions::steps::{
    FAULTS, step01_rays, step02_sphere, step03_nearest, step04_diffuse, step05_phong,
};
use crate::expressions::value::Value;
use course::{Place, all_listed_places};
use image::RgbImage;
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError, RwLock};

/// Sentence about a picture that takes more steps than it may.
pub const TOO_LONG: &str = "That takes longer than a page should.";

/// The places that are edited: a bit for the index of each.
static PLACES: AtomicU64 = AtomicU64::new(0);

/// The edits: the index of the place, and the reader's expression there.
static EDITS: RwLock<Vec<(usize, Expression)>> = RwLock::new(vec![]);

/// The place where the reader's program would stop, and why.
static STOP: Mutex<Option<(usize, Refusal)>> = Mutex::new(None);

/// Held while a picture is drawn, as there is one set of edits.
static DRAWING: Mutex<()> = Mutex::new(());

/// The places that can be edited.
pub fn editable_places() -> Vec<Place> {
    let mut places = all_listed_places();
    places.retain(|place| FAULTS.iter().all(|(name, _)| *name != place.name));
    places
}

/// A sentence about each place that can't be edited, since the steps have changed.
pub fn place_faults() -> Vec<&'static str> {
    FAULTS.iter().map(|(_, fault)| *fault).collect()
}

/// Whether the place with this index is edited.
#[inline(always)]
pub(crate) fn is_edited(place: usize) -> bool {
    PLACES.load(Relaxed) >> place & 1 != 0
}

/// The value of the reader's expression at a place where its variables have these.
#[inline(never)]
pub(crate) fn evaluate<T: Default + TryFrom<Value>>(place: usize, variables: Vec<Value>) -> T {
    let is_over = || REMAINING_STEPS.load(Relaxed) < 0;
    let edits = EDITS.read().unwrap_or_else(PoisonError::into_inner);
    let edit = edits.iter().find(|(index, _)| *index == place);
    let mut value = Value::Unfit;
    // Once a picture is refused, nothing is evaluated for it.
    if let Some((_, line)) = edit.filter(|_| !is_over()) {
        match line.evaluate(variables) {
            Ok(_) if is_over() => stop(place, 0..line.length, TOO_LONG),
            Ok(result) => value = result,
            Err((range, sentence)) => stop(place, range, sentence),
        }
    }
    T::try_from(value).unwrap_or_default()
}

/// Notes why the reader's program would stop in the code around the edits.
#[cold]
pub(crate) fn stop_outside(sentence: &str) {
    let edits = EDITS.read().unwrap_or_else(PoisonError::into_inner);
    if let Some((place, expression)) = edits.first() {
        stop(*place, 0..expression.length, &format!("Here your program would stop: {sentence}."));
    }
}

fn stop(place: usize, range: Range<usize>, sentence: &str) {
    let mut stop = STOP.lock().unwrap_or_else(PoisonError::into_inner);
    stop.get_or_insert((place, Refusal { range, sentence: sentence.to_owned() }));
    REMAINING_STEPS.store(i64::MIN / 2, Relaxed);
}

/// The picture of a step with expressions in place of the book's; or where the reader's program
/// would stop, and why. A step is a function, or an operator, at a pixel. The first edit is the one
/// that is told of what goes wrong around them.
pub fn draw_edited(
    edits: &[(Place, Expression)],
    columns: u32,
    most_steps: i64,
) -> Result<RgbImage, (&'static str, Refusal)> {
    let _alone = DRAWING.lock();
    let places = all_listed_places();
    let index_of = |place: &Place| places.iter().position(|one| one == place);
    let indexed_edits = edits
        .iter()
        .filter_map(|(place, expression)| Some((index_of(place)?, expression.clone())))
        .collect::<Vec<_>>();
    let bits = indexed_edits.iter().fold(0, |bits, (index, _)| bits | 1 << index);
    *EDITS.write().unwrap_or_else(PoisonError::into_inner) = indexed_edits;
    REMAINING_STEPS.store(most_steps, Relaxed);
    PLACES.store(bits, Relaxed);
    let picture = match edits.first().map_or("", |(place, _)| place.step_name()) {
        "step01_rays" => step01_rays::picture,
        "step02_sphere" => step02_sphere::picture,
        "step03_nearest" => step03_nearest::picture,
        "step04_diffuse" => step04_diffuse::picture,
        _ => step05_phong::picture,
    };
    let angle = 60_f64.to_radians();
    let picture = picture(&step01_rays::Camera::new(columns, columns * 9 / 16, angle), 1);
    PLACES.store(0, Relaxed);
    match STOP.lock().unwrap_or_else(PoisonError::into_inner).take() {
        Some((place, refusal)) => Err((places[place].name, refusal)),
        None => Ok(picture),
    }
}
