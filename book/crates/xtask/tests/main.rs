//! What is checked in and made from the code is what the code says today: the table of the
//! mistakes and the modules that the pages load. Each failure names the command that makes it
//! anew.

mod expressions;
mod modules_up_to_date;
mod support;
mod table;

use std::env;

/// Whether all cases of long lists are tried, as before a change lands: THOROUGH is set.
fn tries_all_cases() -> bool {
    env::var_os("THOROUGH").is_some()
}
