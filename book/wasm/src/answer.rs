use live::Answer;

/// Answers a request.
///
/// - `check NAME FILE` is about the file whose bytes came with it: see
///   [`check`](crate::check()).
/// - `draw NAME` gives a picture of ours: see [`draw`](crate::draw).
/// - `drawn NAME` brings its pixels: see [`keep`](crate::keep).
/// - Every other goes to [`live::answer`].
#[cfg_attr(not(feature = "check"), expect(unused_variables))]
pub fn answer(request: &str, file: &[u8]) -> Answer {
    match request.split_once(' ') {
        #[cfg(feature = "check")]
        Some(("check", words)) => crate::check(words, file),
        #[cfg(feature = "check")]
        Some(("drawn", name)) => crate::keep(name, file),
        #[cfg(feature = "pictures")]
        Some(("draw", name)) => crate::draw(name),
        #[cfg(feature = "live")]
        _ => live::answer(request),
        #[cfg(not(feature = "live"))]
        _ => Answer::default(),
    }
}
