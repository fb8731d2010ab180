//! Draws the picture of a step with the reader's lines in place of the book's.

use crate::expressions::evaluation::{CompiledLine, Evaluation, Interruption};
use crate::expressions::refusal::{Fault, Refusal};
use crate::expressions::steps::{
    step01_rays, step02_sphere, step03_nearest, step04_diffuse, step05_phong,
};
use crate::expressions::value::Value;
use course::{FOV_DEGREES, Step};
use image::{Rgb, RgbImage};
use std::cell::{Cell, RefCell};
use step01_rays::Camera;
use thiserror::Error;

/// A refusal, with the place of the refused line.
#[derive(Clone, Debug, Error)]
#[error("{place}: {refusal}")]
pub struct LineRefusal {
    /// The name of the line's place.
    pub place: &'static str,
    /// What is wrong with the line.
    #[source]
    pub refusal: Refusal,
}

/// The state that the copied steps use while drawing.
struct Context {
    /// The places that the reader has edited: the bit at a place's index in places.txt is 1 if the
    /// place is edited. The build script makes sure that a u64 has enough bits. A list of the
    /// edited places would be too slow. It doubled the time for a picture, because in step 5, we
    /// check more than sixty times per ray whether a place is edited.
    edited: Cell<u64>,
    /// The horizontal and vertical distance between the pixels that are drawn. If it is 1, all
    /// pixels are drawn.
    pixel_spacing: Cell<u32>,
    picture: RefCell<EditedPicture>,
}

/// A picture in progress.
struct EditedPicture {
    /// The reader's lines.
    lines: Vec<CompiledLine>,
    evaluation: Evaluation,
    /// Why drawing stopped early, if it did.
    refusal: Option<LineRefusal>,
}

thread_local! {
    /// The context of the picture that this thread is drawing. While the thread draws nothing, no
    /// place counts as edited. The context is thread-local because it can't be passed to the steps'
    /// functions as an argument: the book shows these functions, and they have no parameter for it.
    static CONTEXT: Context = const {
        Context {
            edited: Cell::new(0),
            pixel_spacing: Cell::new(1),
            picture: RefCell::new(EditedPicture::new(vec![], 0)),
        }
    };
}

impl EditedPicture {
    /// Creates a picture that may take at most this many operations.
    const fn new(lines: Vec<CompiledLine>, max_operations: u64) -> Self {
        Self { lines, evaluation: Evaluation::new(max_operations), refusal: None }
    }

    /// Evaluates the reader's line at a place. Returns None if the line is refused now, or if any
    /// line was refused earlier in the picture.
    fn evaluate(&mut self, place_index: usize, variables: &[Value]) -> Option<Value> {
        if self.refusal.is_some() {
            return None;
        }
        let line = self.lines.iter().find(|line| line.place_index == place_index)?;
        let interruption = match self.evaluation.evaluate(&line.computation, variables) {
            Ok(value) => return Some(value),
            Err(interruption) => interruption,
        };
        let (range, fault) = match interruption {
            Interruption::NoResult(range) => (range, Fault::NoResult),
            Interruption::OutOfOperations => (0..line.length, Fault::OutOfOperations),
        };
        let refusal = Refusal { range, fault };
        self.refusal = Some(LineRefusal { place: line.place_name, refusal });
        None
    }
}

/// Evaluates the reader's line at a place, given the values of the place's variables. Returns None
/// if the reader hasn't edited the place.
#[inline(always)]
pub fn value_of_line<T, const N: usize>(
    place_index: usize,
    variables: impl FnOnce() -> [Value; N],
) -> Option<T>
where
    T: Default + TryFrom<Value>,
{
    if CONTEXT.with(|context| context.edited.get() >> place_index & 1 == 0) {
        return None;
    }
    Some(evaluate_line(place_index, &variables()))
}

/// Evaluates the reader's line at a place. Once any line has been refused, values no longer matter,
/// so this function returns a default value. It isn't inlined, so that the code at each place stays
/// small.
#[inline(never)]
fn evaluate_line<T: Default + TryFrom<Value>>(place_index: usize, variables: &[Value]) -> T {
    let evaluate =
        |context: &Context| context.picture.borrow_mut().evaluate(place_index, variables);
    let value = CONTEXT.with(evaluate);
    value.and_then(|value| T::try_from(value).ok()).unwrap_or_default()
}

/// Replaces `debug_assert!` in the copied steps. If `condition` is false, a debug build of the
/// reader's program would panic. Then this function refuses the first of the reader's lines, since
/// `condition` doesn't tell which line is at fault. The refusal stops the drawing.
pub fn assert_or_refuse_first_line(condition: bool, sentence: &'static str) {
    if condition {
        return;
    }
    CONTEXT.with(|context| {
        let EditedPicture { lines, refusal, .. } = &mut *context.picture.borrow_mut();
        let Some(line) = lines.first() else { return };
        let fault = Fault::Assertion(sentence);
        refusal.get_or_insert(LineRefusal {
            place: line.place_name,
            refusal: Refusal { range: 0..line.length, fault },
        });
    });
}

/// Draws every pixel whose column and row are multiples of the context's `pixel_spacing`, until a
/// line is refused. In the copied steps, this function replaces step 1's `draw_pixels`, which draws
/// the rows on several threads. This function draws all rows on one thread, because the context is
/// thread-local.
pub fn draw_spaced_pixels_until_refusal(
    camera: &Camera,
    pixel: impl Fn(f64, f64) -> Rgb<u8> + Sync,
) -> RgbImage {
    let mut picture = RgbImage::new(camera.h_res, camera.v_res);
    let pixel_spacing = CONTEXT.with(|context| context.pixel_spacing.get());
    for (i, j, rgb) in picture.enumerate_pixels_mut() {
        if i % pixel_spacing != 0 || j % pixel_spacing != 0 {
            continue;
        }
        *rgb = pixel(i.into(), j.into());
        if CONTEXT.with(|context| context.picture.borrow().refusal.is_some()) {
            break;
        }
    }
    picture
}

/// Draws the step to which the first of `lines` belongs, with these lines instead of the book's.
/// For the whole picture, the lines may take at most `max_operations`. If `lines` is empty, draws
/// step 1 as in the book. If an assertion in the step fails, refuses the first line.
pub fn draw_step_of_first_line(
    lines: &[CompiledLine],
    columns: u32,
    max_operations: u64,
) -> Result<RgbImage, LineRefusal> {
    let step = lines.first().map_or(Step::Rays, |line| line.step);
    draw_step(step, lines, columns, max_operations)
}

/// Draws some pixels of a step's picture, `pixel_spacing` apart both horizontally and vertically.
/// The other pixels stay black.
pub fn draw_some_pixels(
    step: Step,
    lines: &[CompiledLine],
    pixel_spacing: u32,
    columns: u32,
    max_operations: u64,
) -> Result<RgbImage, LineRefusal> {
    CONTEXT.with(|context| context.pixel_spacing.set(pixel_spacing));
    let picture = draw_step(step, lines, columns, max_operations);
    CONTEXT.with(|context| context.pixel_spacing.set(1));
    picture
}

/// Draws a step with the reader's lines instead of the book's. Returns an error if a line is
/// refused while the picture is drawn.
fn draw_step(
    step: Step,
    lines: &[CompiledLine],
    columns: u32,
    max_operations: u64,
) -> Result<RgbImage, LineRefusal> {
    let draw = match step {
        Step::Rays => step01_rays::picture,
        Step::Sphere => step02_sphere::picture,
        Step::Nearest => step03_nearest::picture,
        Step::Diffuse => step04_diffuse::picture,
        Step::Phong => step05_phong::picture,
    };
    let edited = lines.iter().fold(0, |bits, line| bits | 1 << line.place_index);
    let picture = CONTEXT.with(|context| {
        context.picture.replace(EditedPicture::new(lines.to_vec(), max_operations));
        context.edited.set(edited);
        let camera = Camera::new(columns, columns * 9 / 16, FOV_DEGREES.to_radians());
        let picture = draw(&camera, 1);
        context.edited.set(0);
        picture
    });
    let finished = CONTEXT.with(|context| context.picture.replace(EditedPicture::new(vec![], 0)));
    match finished.refusal {
        Some(refusal) => Err(refusal),
        None => Ok(picture),
    }
}
