use crate::expressions::expression::Expression;
use crate::expressions::refusal::{Refusal, refuse};
use crate::expressions::steps::{
    step01_rays, step02_sphere, step03_nearest, step04_diffuse, step05_phong,
};
use crate::expressions::value::Value;
use image::RgbImage;
use std::ops::Range;
use std::sync::atomic::{AtomicI64, AtomicU64, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError, RwLock};

/// All of a text.
const WHOLE: Range<usize> = 0..usize::MAX;

/// Sentence about a picture that takes more steps than it may.
pub const TOO_LONG: &str = "That takes longer than a page should.";

/// The places that are edited: a bit for the index of each.
static PLACES: AtomicU64 = AtomicU64::new(0);

/// The reader's expressions.
static LINES: RwLock<Vec<Expression>> = RwLock::new(vec![]);

/// The name of the place where the reader's program would stop, and why.
static STOP: Mutex<Option<(&str, Refusal)>> = Mutex::new(None);

/// The steps that the picture may still take.
static REMAINING_STEPS: AtomicI64 = AtomicI64::new(0);

/// Held while a picture is drawn, as there is one set of edits.
static DRAWING: Mutex<()> = Mutex::new(());

/// Whether the place with this index is edited.
#[inline(always)]
pub fn is_edited(place: usize) -> bool {
    PLACES.load(Relaxed) >> place & 1 != 0
}

/// Counts steps of a picture; gives those that remain.
pub fn spend(steps: i64) -> i64 {
    REMAINING_STEPS.fetch_sub(steps, Relaxed) - steps
}

/// Whether a picture is refused: then nothing is evaluated for it.
fn is_over() -> bool {
    REMAINING_STEPS.load(Relaxed) < i64::MIN / 4
}

/// The value of the reader's expression at a place where its variables have these.
#[inline(never)]
pub fn evaluate<T: Default + TryFrom<Value>>(place: usize, variables: Vec<Value>) -> T {
    let lines = LINES.read().unwrap_or_else(PoisonError::into_inner);
    let line = lines.iter().find(|line| line.place.index == place && !is_over());
    let evaluate = |line: &Expression| {
        let is_too_long = spend(line.steps) < 0;
        let value = if is_too_long { refuse(WHOLE, TOO_LONG) } else { line.evaluate(variables) };
        value.map_err(|refusal| stop(line.place.name, refusal)).ok()
    };
    line.and_then(evaluate).and_then(|value| T::try_from(value).ok()).unwrap_or_default()
}

/// Notes why the reader's program would stop in the code around the lines.
#[cold]
pub fn stop_outside(sentence: &str) {
    let lines = LINES.read().unwrap_or_else(PoisonError::into_inner);
    if let Some(line) = lines.first().filter(|_| !is_over()) {
        let sentence = format!("Here your program would stop: {sentence}.");
        stop(line.place.name, Refusal { range: WHOLE, sentence });
    }
}

fn stop(name: &'static str, refusal: Refusal) {
    STOP.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert((name, refusal));
    REMAINING_STEPS.store(i64::MIN / 2, Relaxed);
}

/// The picture of a step with expressions in place of the book's; or the name of the place where
/// the reader's program would stop, and why. A step is a function, or an operator, at a pixel. The
/// first line is the one that is told of what goes wrong around them.
pub fn draw_edited(
    lines: &[Expression],
    columns: u32,
    most_steps: i64,
) -> Result<RgbImage, (&'static str, Refusal)> {
    let _alone = DRAWING.lock();
    *LINES.write().unwrap_or_else(PoisonError::into_inner) = lines.to_vec();
    REMAINING_STEPS.store(most_steps, Relaxed);
    PLACES.store(lines.iter().fold(0, |bits, line| bits | 1 << line.place.index), Relaxed);
    let picture = match lines.first().map_or("", |line| line.place.step_name()) {
        "step01_rays" => step01_rays::picture,
        "step02_sphere" => step02_sphere::picture,
        "step03_nearest" => step03_nearest::picture,
        "step04_diffuse" => step04_diffuse::picture,
        _ => step05_phong::picture,
    };
    let angle = 60_f64.to_radians();
    let picture = picture(&step01_rays::Camera::new(columns, columns * 9 / 16, angle), 1);
    PLACES.store(0, Relaxed);
    let stop = STOP.lock().unwrap_or_else(PoisonError::into_inner).take();
    stop.map_or(Ok(picture), Err)
}
