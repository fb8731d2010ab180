//! What a page of the book calls. It writes a request into our memory and reads the
//! answer from there; nothing here looks behind a pointer.

use crate::{Answer, answer};
use std::cell::RefCell;

thread_local! {
    static REQUEST: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
    static ANSWER: RefCell<Answer> = RefCell::default();
}

/// Room for a request of this many bytes.
#[unsafe(no_mangle)]
extern "C" fn live_request(length: usize) -> *mut u8 {
    REQUEST.with_borrow_mut(|request| {
        *request = vec![0; length];
        request.as_mut_ptr()
    })
}

/// Answers the request that was written there.
#[unsafe(no_mangle)]
extern "C" fn live_answer() {
    let answer = REQUEST
        .with_borrow(|request| answer(str::from_utf8(request).unwrap_or_default()));
    ANSWER.set(answer);
}

/// Where the text of the answer is.
#[unsafe(no_mangle)]
extern "C" fn live_text() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.text.as_ptr())
}

/// How many bytes of text there are.
#[unsafe(no_mangle)]
extern "C" fn live_text_length() -> usize {
    ANSWER.with_borrow(|answer| answer.text.len())
}

/// Where its pixels are.
#[unsafe(no_mangle)]
extern "C" fn live_pixels() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.pixels.as_ptr())
}

/// How many bytes of pixels there are.
#[unsafe(no_mangle)]
extern "C" fn live_pixels_length() -> usize {
    ANSWER.with_borrow(|answer| answer.pixels.len())
}
