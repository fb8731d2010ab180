//! The functions that a page calls. The page writes a request, and a file if there is one,
//! into the module's memory and reads the answer from there; no pointer is dereferenced
//! here.

use crate::answer;
use figures::Reply;
use std::cell::RefCell;

thread_local! {
    static ROOMS: RefCell<[Vec<u8>; 2]> = const { RefCell::new([vec![], vec![]]) };
    static ANSWER: RefCell<(Reply, [usize; 4])> = RefCell::default();
}

/// Makes room for this many bytes: of the next request, 0, or of its file, 1.
#[unsafe(no_mangle)]
extern "C" fn make_room(index: usize, length: usize) -> *mut u8 {
    ROOMS.with_borrow_mut(|rooms| {
        rooms[index] = vec![0; length];
        rooms[index].as_mut_ptr()
    })
}

/// Answers the request that was written into its room. At the address that it gives are those of
/// the answer's text and of its pixels, each with the length in bytes.
#[unsafe(no_mangle)]
extern "C" fn make_answer() -> *const usize {
    let [request, file] = ROOMS.take();
    let reply = answer(str::from_utf8(&request).unwrap_or_default(), &file);
    let [text, pixels] = [reply.text.as_bytes(), &reply.pixels];
    let ranges = [text.as_ptr() as usize, text.len(), pixels.as_ptr() as usize, pixels.len()];
    ANSWER.with_borrow_mut(|answer| {
        *answer = (reply, ranges);
        answer.1.as_ptr()
    })
}
