//! The environment variables that control the tests. No other Rust file reads them, and
//! CONTRIBUTING lists them.

use std::env;

/// Whether this process runs on CI, decided by the same rules as in insta.
pub fn is_ci() -> bool {
    match env::var("CI").as_deref() {
        Ok("" | "0" | "false") => false,
        Ok(_) => true,
        Err(_) => env::var_os("TF_BUILD").is_some(),
    }
}

/// Whether tests should try every case instead of a sample, because `THOROUGH=1` is set.
pub fn is_thorough() -> bool {
    env::var_os("THOROUGH").is_some_and(|value| !value.is_empty())
}

/// The identifier of this run of `cargo nextest`, which is the same in the processes of all tests.
/// None under a different test runner.
pub fn nextest_run_id() -> Option<String> {
    env::var("NEXTEST_RUN_ID").ok()
}

/// What insta does with a snapshot that no longer matches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SnapshotUpdate {
    /// Overwrites the snapshot.
    InPlace,
    /// Writes the new snapshot beside the old one, for review.
    NewFile,
    /// Writes nothing.
    No,
}

/// The behaviour that `INSTA_UPDATE` asks for.
pub fn snapshot_update() -> SnapshotUpdate {
    parse_snapshot_update(env::var("INSTA_UPDATE").as_deref().unwrap_or_default(), is_ci())
}

/// Interprets a value of `INSTA_UPDATE` as insta does for a snapshot that already exists. Invalid
/// values need no handling, because insta itself rejects them.
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
