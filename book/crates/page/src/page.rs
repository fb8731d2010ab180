//! The functions that a page calls. The page writes a request, and a file if there is one,
//! into the module's memory and reads the answer from there; no pointer is dereferenced
//! here.

use crate::answer;
use figures::Reply;
use std::cell::RefCell;

thread_local! {
    static REQUEST: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
    static FILE: RefCell<Vec<u8>> = const { RefCell::new(vec![]) };
    static ANSWER: RefCell<Reply> = RefCell::default();
}

/// Makes room for a request of this many bytes.
#[unsafe(no_mangle)]
extern "C" fn live_request(length: usize) -> *mut u8 {
    REQUEST.with_borrow_mut(|request| {
        *request = vec![0; length];
        request.as_mut_ptr()
    })
}

/// Makes room for the file of the next request, of this many bytes.
#[unsafe(no_mangle)]
extern "C" fn live_file(length: usize) -> *mut u8 {
    FILE.with_borrow_mut(|file| {
        *file = vec![0; length];
        file.as_mut_ptr()
    })
}

/// Answers the request that was written into its room.
#[unsafe(no_mangle)]
extern "C" fn live_answer() {
    let file = FILE.take();
    let answer =
        REQUEST.with_borrow(|request| answer(str::from_utf8(request).unwrap_or_default(), &file));
    ANSWER.set(answer);
}

/// The address of the answer's text.
#[unsafe(no_mangle)]
extern "C" fn live_text() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.text.as_ptr())
}

/// The length of the answer's text in bytes.
#[unsafe(no_mangle)]
extern "C" fn live_text_length() -> usize {
    ANSWER.with_borrow(|answer| answer.text.len())
}

/// The address of the answer's pixels.
#[unsafe(no_mangle)]
extern "C" fn live_pixels() -> *const u8 {
    ANSWER.with_borrow(|answer| answer.pixels.as_ptr())
}

/// The length of the answer's pixels in bytes.
#[unsafe(no_mangle)]
extern "C" fn live_pixels_length() -> usize {
    ANSWER.with_borrow(|answer| answer.pixels.len())
}
