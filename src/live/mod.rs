//! A program that runs while somebody watches and works its inputs.
//!
//! Nothing in here knows a terminal: [`Live`] takes keys and the time that goes by, and draws
//! itself into a buffer of cells.

mod clock;
mod key;
mod ladder;
mod layout;
mod prompt;
mod session;
mod state;
mod values;
mod view;

pub use key::Key;
pub use layout::{LEAST_COLUMNS, LEAST_ROWS};
pub use session::Session;
pub use state::{Live, Options};
