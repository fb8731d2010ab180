use crate::projection::{SIZE, place_of_point, point_at_place};
use crate::{Handle, Mark, Numbers, Output, Parameter};
use glam::{DVec2, DVec3};
use step01_rays::Camera;

/// What a figure or picture shows, made from the values of its parameters.
///
/// Here numbers get their names: `from_values` takes those of all parameters, in order. The
/// other items are the fields of [`Figure`], which says what each is.
///
/// [`Figure`]: crate::Figure
pub trait Interactive: Sized + 'static {
    const NAME: &'static str;
    const TITLE: &'static str = "";
    const CAPTION: &'static str = "";
    const FOLLOWED: Option<&'static str> = None;

    /// The column and the row of the probe at first; its parameters and its handle come before
    /// the others.
    const PROBE: Option<[f64; 2]> = None;

    fn from_values(values: &[f64]) -> Self;

    fn draw(&self) -> Output;

    fn parameters() -> Vec<Parameter> {
        vec![]
    }

    fn handles() -> Vec<Handle> {
        vec![]
    }

    fn is_allowed(&self) -> bool {
        true
    }

    fn numbers(&self) -> Numbers {
        Numbers::new()
    }

    fn group_at(&self, _place: DVec2) -> Option<&'static str> {
        None
    }

    /// A handle that sets two parameters; the second grows upwards. See the fields of [`Handle`].
    fn handle(
        words: &str,
        parameters: [usize; 2],
        locate: impl Fn(&Self) -> Option<DVec2> + Send + Sync + 'static,
        coordinates_at: impl Fn(&Self, DVec2) -> DVec2 + Send + Sync + 'static,
    ) -> Handle {
        Handle {
            words: words.to_owned(),
            parameters,
            is_down: false,
            mark: Mark::Point,
            locate: Box::new(move |values| locate(&Self::from_values(values))),
            coordinates_at: Box::new(move |values, place| {
                coordinates_at(&Self::from_values(values), place)
            }),
        }
    }

    /// A handle that sets one parameter.
    fn handle_of_one(
        words: &str,
        parameter: usize,
        locate: impl Fn(&Self) -> DVec2 + Send + Sync + 'static,
        value_at: impl Fn(&Self, DVec2) -> f64 + Send + Sync + 'static,
    ) -> Handle {
        let value_at = move |figure: &Self, place| DVec2::splat(value_at(figure, place));
        Self::handle(words, [parameter; 2], move |figure| Some(locate(figure)), value_at)
    }

    /// The handle of a point of the world in a picture, whose x and y are the parameter `x`
    /// and the next; its z stays. It is dragged at most to `margin` from the border, and stays
    /// where no point at its z is ahead. There is nothing to drag where the function gives None.
    fn handle_in_picture(
        words: &str,
        x: usize,
        margin: f64,
        camera_and_point: impl Fn(&Self) -> Option<(Camera, DVec3)> + Send + Sync + Copy + 'static,
    ) -> Handle {
        let locate = move |figure: &Self| {
            let (camera, point) = camera_and_point(figure)?;
            place_of_point(&camera, point)
        };
        Self::handle(words, [x, x + 1], locate, move |figure, place| {
            let Some((camera, point)) = camera_and_point(figure) else { return DVec2::NAN };
            let inside = place.clamp(DVec2::splat(margin), SIZE - margin);
            point_at_place(&camera, inside, point.z).unwrap_or(point.truncate())
        })
    }
}
