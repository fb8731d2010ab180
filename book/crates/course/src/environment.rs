//! The environment variables that switch tests. Rust reads them here and nowhere else, and
//! CONTRIBUTING lists them.

use std::env;

/// Whether this is a machine of CI, by the rule that insta has.
pub fn is_ci() -> bool {
    match env::var("CI").as_deref() {
        Ok("" | "0" | "false") => false,
        Ok(_) => true,
        Err(_) => env::var_os("TF_BUILD").is_some(),
    }
}

/// Whether tests try all their cases, and not only some: `THOROUGH=1`.
pub fn is_thorough() -> bool {
    env::var_os("THOROUGH").is_some_and(|value| !value.is_empty())
}

/// What identifies this run of `cargo nextest`, which gives each test a process of its own. None
/// if another program runs the tests.
pub fn nextest_run_id() -> Option<String> {
    env::var("NEXTEST_RUN_ID").ok()
}

/// What insta does with a snapshot that differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SnapshotUpdate {
    /// Replaces the snapshot.
    InPlace,
    /// Writes the new one beside it, for review.
    NewFile,
    /// Writes nothing.
    No,
}

/// What `INSTA_UPDATE` asks for.
pub fn snapshot_update() -> SnapshotUpdate {
    parse_snapshot_update(env::var("INSTA_UPDATE").as_deref().unwrap_or_default(), is_ci())
}

/// The meaning that insta gives to a value of `INSTA_UPDATE`, for a snapshot that exists. It
/// refuses other values by itself.
fn parse_snapshot_update(value: &str, is_ci: bool) -> SnapshotUpdate {
    match value {
        "always" | "1" | "force" => SnapshotUpdate::InPlace,
        "no" => SnapshotUpdate::No,
        "" | "auto" if is_ci => SnapshotUpdate::No,
        _ => SnapshotUpdate::NewFile,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn snapshots_are_updated_as_insta_does() {
        for is_ci in [false, true] {
            for value in ["always", "1", "force"] {
                assert_eq!(parse_snapshot_update(value, is_ci), SnapshotUpdate::InPlace);
            }
            for value in ["new", "unseen"] {
                assert_eq!(parse_snapshot_update(value, is_ci), SnapshotUpdate::NewFile);
            }
            assert_eq!(parse_snapshot_update("no", is_ci), SnapshotUpdate::No);
        }
        for value in ["", "auto"] {
            assert_eq!(parse_snapshot_update(value, false), SnapshotUpdate::NewFile);
            assert_eq!(parse_snapshot_update(value, true), SnapshotUpdate::No);
        }
    }
}
