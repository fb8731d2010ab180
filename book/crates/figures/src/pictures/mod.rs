//! The pictures. Each is drawn by the code of its step or example.

pub mod mirror;
mod pixel_trace;
pub mod step01;
pub mod step02;
pub mod step03;
pub mod step04;
pub mod step05;
