//! The functions that a page calls. The page writes a request, and possibly a file, into the
//! module's memory and reads the reply from the same memory. These functions dereference no
//! pointers. They only return addresses.

use crate::reply;
use figures::Reply;
use std::cell::RefCell;

thread_local! {
    static INPUTS: RefCell<[Vec<u8>; 2]> = const { RefCell::new([vec![], vec![]]) };
    static REPLY: RefCell<(Reply, [usize; 4])> = RefCell::default();
}

/// Allocates `length` bytes for an input, and returns their address. The input with index 0 is the
/// next request, and the input with index 1 is the file that comes with the request.
#[unsafe(no_mangle)]
extern "C" fn allocate_input(index: usize, length: usize) -> *mut u8 {
    INPUTS.with_borrow_mut(|inputs| {
        inputs[index] = vec![0; length];
        inputs[index].as_mut_ptr()
    })
}

/// Replies to the request that the page has written into memory. Returns the address of four
/// numbers: the address and length of the reply's text, and the address and length of its pixels.
/// The lengths are in bytes.
#[unsafe(no_mangle)]
extern "C" fn make_reply() -> *const usize {
    let [request, file] = INPUTS.take();
    let reply = reply(str::from_utf8(&request).unwrap_or_default(), &file);
    let [text, pixels] = [reply.text.as_bytes(), &reply.pixels];
    let ranges = [text.as_ptr() as usize, text.len(), pixels.as_ptr() as usize, pixels.len()];
    REPLY.with_borrow_mut(|kept| {
        *kept = (reply, ranges);
        kept.1.as_ptr()
    })
}
