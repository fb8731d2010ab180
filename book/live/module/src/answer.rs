use live::Answer;

/// Answers a request: `check NAME FILE` is about the file whose bytes came with it, and
/// goes to [`check`](crate::check()); every other goes to [`live::answer`].
#[cfg_attr(not(feature = "check"), expect(unused_variables))]
pub fn answer(request: &str, file: &[u8]) -> Answer {
    match request.strip_prefix("check ") {
        #[cfg(feature = "check")]
        Some(words) => crate::check(words, file),
        #[cfg(feature = "live")]
        _ => live::answer(request),
        #[cfg(not(feature = "live"))]
        _ => Answer::default(),
    }
}
