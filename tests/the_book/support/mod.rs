//! What the tests of the book share: listings, items and commands of a page, and a workspace as a
//! reader types it.

pub mod listing;
pub mod page_items;
pub mod reader_workspace;
pub mod verified_command;
