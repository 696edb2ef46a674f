//! Which pins the box of a block has.

use super::call::{Fed, Input, Output, Room};
use super::cells::Form;
use crate::blocks::{Block, Follows, Port, PortRole};
use crate::eval::Reading;
use crate::syntax::ast::{ArgumentValue, Call, Expr, ExprKind};

/// The pins of a block besides those for the power, in the order of its ports: a box looks the same
/// wherever it stands. What is fixed or has a start only has a pin where the call says it, or where
/// there is a value to show.
#[derive(Default)]
pub(super) struct Pins {
    pub inputs: Vec<Input>,
    pub outputs: Vec<Output>,
}

impl Pins {
    /// The pins of a call that gives these.
    pub fn of(
        block: &'static Block,
        call: &Call<'_>,
        mut given: Vec<(&str, Fed)>,
        readings: &[Reading],
    ) -> Pins {
        let mut take = |name: &str| {
            let found = given.iter().position(|(given, _)| *given == name);
            found.map(|index| given.swap_remove(index).1)
        };
        let mut pins = Pins::default();
        for port in block.ports.iter().filter(|port| is_there(port, call)) {
            let (fed, is_loaded) = (take(port.name), port.role.is_loaded());
            let name = port.name.to_owned();
            let value = |form| room(readings, port.name, form);
            match fed.or((port.role.is_parameter() && !is_loaded).then_some(Fed::Open)) {
                Some(fed) => {
                    let value = match &fed {
                        Fed::Circuit(_) | Fed::Elsewhere(..) => None,
                        Fed::Value(_) if !is_loaded && is_literal(call, port.name) => None,
                        Fed::Value(_) | Fed::Open => value(Form::Equal),
                    };
                    pins.inputs.push(Input { name, fed, value });
                }
                None if block.main == Some(port.name) => {}
                None if is_shown(port) => {
                    pins.outputs.push(Output { name, value: value(Form::Alone) });
                }
                None if is_loaded && !readings.is_empty() => {
                    pins.outputs.push(Output { name, value: value(Form::Alone) });
                }
                None => {}
            }
        }
        for setting in block.settings {
            if let Some(fed) = take(setting.name) {
                pins.inputs.push(Input { name: setting.name.to_owned(), fed, value: None });
            }
        }
        pins
    }
}

/// True for what is drawn at the right.
fn is_shown(port: &Port) -> bool {
    matches!(port.role, PortRole::Output | PortRole::Shared { shown: true })
}

/// True if a call has the port.
fn is_there(port: &Port, call: &Call<'_>) -> bool {
    let items = |setting: &str| match argument(call, setting) {
        Some(ArgumentValue::List(items, _)) => items.len(),
        _ => 0,
    };
    match port.follows {
        Follows::ItemOf(setting, item) => item < items(setting),
        Follows::Nothing | Follows::TypeOf(_) => true,
    }
}

/// True if what a call gives is a number or a time as it is written.
fn is_literal(call: &Call<'_>, name: &str) -> bool {
    matches!(
        argument(call, name),
        Some(ArgumentValue::Expr(Expr { kind: ExprKind::Literal(_), .. }))
    )
}

fn argument<'c, 's>(call: &'c Call<'s>, name: &str) -> Option<&'c ArgumentValue<'s>> {
    let found = call.arguments.iter().find(|argument| argument.name.text == name);
    found.map(|argument| &argument.value)
}

/// The room of a port's value, if it is to be seen.
fn room(readings: &[Reading], port: &str, form: Form) -> Option<Room> {
    let place = readings.iter().position(|reading| reading.name == port)?;
    Some((place, form.room(&readings[place])))
}
