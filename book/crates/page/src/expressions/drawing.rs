use crate::expressions::Expression;
use crate::expressions::steps::{
    FAULTS, step01_rays, step02_sphere, step03_nearest, step04_diffuse, step05_phong,
};
use crate::expressions::value::Value;
use course::{Place, all_listed_places};
use glam::DVec3;
use image::RgbImage;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError, RwLock};

/// The index of the place that is edited.
static PLACE: AtomicUsize = AtomicUsize::new(usize::MAX);

/// The reader's expression there.
static EXPRESSION: RwLock<Option<Expression>> = RwLock::new(None);

/// Held while a picture is drawn, as there is one place and one expression.
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

/// Whether the place with this index is the one that is edited.
#[inline(always)]
pub(crate) fn is_edited(place: usize) -> bool {
    PLACE.load(Relaxed) == place
}

/// The value of the reader's expression where its variables have these.
#[inline(never)]
pub(crate) fn evaluate<T: Value>(variables: &[DVec3]) -> T {
    let expression = EXPRESSION.read().unwrap_or_else(PoisonError::into_inner);
    T::unpack(expression.as_ref().map_or(DVec3::ZERO, |code| code.evaluate(variables)))
}

/// The picture of the step of `place`, with an expression there in place of the book's.
pub fn draw_edited(place: &Place, expression: Expression, columns: u32) -> RgbImage {
    let _alone = DRAWING.lock();
    let index = all_listed_places().iter().position(|one| one == place);
    set_expression(Some(expression));
    PLACE.store(index.unwrap_or(usize::MAX), Relaxed);
    let picture = match place.step_name() {
        "step01_rays" => step01_rays::picture,
        "step02_sphere" => step02_sphere::picture,
        "step03_nearest" => step03_nearest::picture,
        "step04_diffuse" => step04_diffuse::picture,
        _ => step05_phong::picture,
    };
    let (rows, angle) = (columns * 9 / 16, 60_f64.to_radians());
    let picture = picture(&step01_rays::Camera::new(columns, rows, angle), 1);
    PLACE.store(usize::MAX, Relaxed);
    set_expression(None);
    picture
}

fn set_expression(expression: Option<Expression>) {
    *EXPRESSION.write().unwrap_or_else(PoisonError::into_inner) = expression;
}
