//! What the tests of the book share: listings, events and commands of a page, and a workspace as a
//! reader types it.

pub mod listing;
pub mod page_events;
pub mod reader_workspace;
pub mod verified_command;
