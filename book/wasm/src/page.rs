//! What a page calls. It writes a request, and a file if there is one, into our memory and
//! reads the answer from there; nothing here looks behind a pointer.

use crate::answer;
use live::Answer;
use std::cell::RefCell;

thread_local! {
    static REQUEST: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
    static FILE: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
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

/// Room for a file of this many bytes, of which the next request speaks.
#[unsafe(no_mangle)]
extern "C" fn live_file(length: usize) -> *mut u8 {
    FILE.with_borrow_mut(|file| {
        *file = vec![0; length];
        file.as_mut_ptr()
    })
}

/// Answers the request that was written there.
#[unsafe(no_mangle)]
extern "C" fn live_answer() {
    let file = FILE.take();
    let answer = REQUEST.with_borrow(|request| {
        answer(str::from_utf8(request).unwrap_or_default(), &file)
    });
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
