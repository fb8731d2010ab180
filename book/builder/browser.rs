use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

/// Opens a page in the reader's browser; false where no browser is found.
pub fn open(page: &Path) -> bool {
    open::commands(page).iter_mut().any(starts)
}

/// Starts a program, and says whether it does not fail within two seconds.
///
/// Where there is a browser, its starter ends well or lives on; where there is
/// none, it fails.
fn starts(command: &mut Command) -> bool {
    let command =
        command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let Ok(mut child) = command.spawn() else { return false };
    for _ in 0..20 {
        sleep(Duration::from_millis(100));
        match child.try_wait() {
            Ok(None) => {}
            Ok(Some(status)) => return status.success(),
            Err(_) => return false,
        }
    }
    true
}
