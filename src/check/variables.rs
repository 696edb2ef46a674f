//! Inputs, outputs and variables: types, arrays, initial values, addresses.

use super::names::Entity;
use super::{Checked, Checker, Reported, literal};
use crate::diagnostic::{Diagnostic, code, shortened, similar_name};
use crate::model::{Array, Elements, Role, Variable, VariableId};
use crate::source::Span;
use crate::syntax::ast::{self, Amount, Declarator, Initial, TypeName, VariableKind, Variables};
use crate::types::Type;

/// Elements of the longest array: each is a register of its own.
const MOST_ELEMENTS: u32 = 1024;

/// Elements of all arrays together, and those that indexes choose among while the program runs: a
/// few characters ask for very much hardware there.
const MOST_TOGETHER: u64 = 65_536;

/// What the names of a declaration are.
#[derive(Clone, Copy)]
struct Kind {
    role: Role,
    ty: Type,
    /// The number of elements, if they are arrays.
    length: Option<u32>,
}

impl<'s> Checker<'s> {
    pub(super) fn declare_variables(&mut self, variables: &Variables<'s>) {
        let role = match variables.kind {
            VariableKind::Input => Role::Input,
            VariableKind::Output => Role::Output,
            VariableKind::Var => Role::Local,
        };
        let kind = match &variables.ty {
            None => Ok(Kind { role, ty: Type::Bool, length: None }),
            Some(name) => self.kind(role, name),
        };
        for declarator in &variables.names {
            let entity = match kind {
                Ok(kind) => self.variable(kind, declarator),
                Err(_) => Entity::Broken,
            };
            if let Err(diagnostic) = self.names.declare(declarator.name, entity) {
                self.report(*diagnostic);
            }
        }
    }

    fn kind(&mut self, role: Role, name: &TypeName<'s>) -> Checked<Kind> {
        let ty = self.type_named(name.name);
        let length = name.length.map(|length| self.array_length(length)).transpose();
        Ok(Kind { role, ty: ty?, length: length? })
    }

    fn array_length(&mut self, length: Amount<'s>) -> Checked<u32> {
        let number = u32::try_from(self.number_of(length)?).ok();
        number.filter(|number| (1..=MOST_ELEMENTS).contains(number)).ok_or_else(|| {
            let message = format!("an array has 1 to {MOST_ELEMENTS} elements");
            let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, length.span(), message)
                .label("not so many")
                .help("every element is a register of its own in the hardware");
            self.report(diagnostic)
        })
    }

    /// Counts elements that are declared, or that an index chooses among while the program runs.
    pub(super) fn count_elements(&mut self, length: u32, span: Span) -> Checked<()> {
        let before = self.elements;
        self.elements += u64::from(length);
        if self.elements <= MOST_TOGETHER {
            return Ok(());
        }
        if before > MOST_TOGETHER {
            return Err(Reported);
        }
        let message = format!("the arrays need hardware for more than {MOST_TOGETHER} elements");
        let diagnostic = Diagnostic::new(code::ARRAYS_TOO_LARGE, span, message)
            .label("too many with this")
            .help("an element is a register, and an index that changes chooses among all of them");
        Err(self.report(diagnostic))
    }

    /// The type of a constant.
    pub(super) fn scalar_type(&mut self, name: &TypeName<'s>) -> Checked<Type> {
        let ty = self.type_named(name.name)?;
        let Some(length) = name.length else { return Ok(ty) };
        let message = "a constant is one value and no array";
        let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, length.span(), message)
            .label("an array")
            .help("declare a variable with these initial values, and do not write it");
        Err(self.report(diagnostic))
    }

    fn type_named(&mut self, name: ast::Name<'s>) -> Checked<Type> {
        Type::named(name.text).ok_or_else(|| {
            let names = Type::ALL.map(Type::name);
            let message = format!("there is no type `{}`", shortened(name.text));
            let help = match similar_name(name.text, names) {
                Some(similar) => format!("is `{similar}` meant?"),
                None => format!("the types are {}", names.join(", ")),
            };
            self.report(
                Diagnostic::new(code::UNKNOWN_NAME, name.span, message)
                    .label("not a type")
                    .help(help),
            )
        })
    }

    fn variable(&mut self, kind: Kind, declarator: &Declarator<'s>) -> Entity {
        let length = kind.length.unwrap_or(1);
        if kind.length.is_some() && self.count_elements(length, declarator.name.span).is_err() {
            return Entity::Broken;
        }
        let initial = match &declarator.initial {
            None => Vec::new(),
            Some(initial) => self.initial_values(kind, initial).unwrap_or_default(),
        };
        let address = declarator
            .address
            .and_then(|address| self.address(kind, declarator.name, address).ok());
        let Declarator { name: ast::Name { text, span }, .. } = *declarator;
        let first = VariableId::from_raw((self.program.variables.len() as u32).into());
        for index in 0..length {
            let name = match kind.length {
                None => text.to_owned(),
                Some(_) => format!("{text}[{index}]"),
            };
            self.program.variables.alloc(Variable {
                name: name.into(),
                ty: kind.ty,
                initial: initial.get(index as usize).copied().unwrap_or(0),
                is_initialised: declarator.initial.is_some(),
                role: kind.role,
                address: address.map(|address| address + index as u16),
                span,
            });
        }
        if kind.length.is_none() {
            return Entity::Variable(first);
        }
        let elements = Elements { first, length };
        self.program.arrays.push(Array { name: text.into(), elements });
        Entity::Array(self.program.arrays.len() - 1)
    }

    /// The initial values of a variable or of the first elements of an array.
    fn initial_values(&mut self, kind: Kind, initial: &Initial<'s>) -> Checked<Vec<i64>> {
        let Kind { role, ty, length } = kind;
        let span = match initial {
            Initial::Value(value) => value.span,
            Initial::List(_, span) => *span,
        };
        if role == Role::Input {
            let diagnostic =
                Diagnostic::new(code::NOT_WRITABLE, span, "an input has no initial value")
                    .label("an input takes what comes from outside")
                    .help("remove it");
            return Err(self.report(diagnostic));
        }
        match (initial, length) {
            (Initial::Value(value), None) => Ok(vec![self.constant(value, Some(ty))?.1]),
            (Initial::List(values, _), Some(length)) => {
                let elements: Vec<_> =
                    values.iter().map(|value| self.constant(value, Some(ty))).collect();
                if let (Some(first), Some(last)) = (values.get(length as usize), values.last()) {
                    let rest = first.span.to(last.span);
                    return Err(self.too_many_values(rest, values.len(), length));
                }
                elements.into_iter().map(|value| value.map(|(_, value)| value)).collect()
            }
            (Initial::List(..), None) => {
                let message = "a list is for an array";
                let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, span, message)
                    .label("a list")
                    .help("give one value");
                Err(self.report(diagnostic))
            }
            (Initial::Value(_), Some(_)) => {
                let message = "an array has a list of initial values";
                let text = self.source.slice(span);
                let help = format!("write [{}], the value of element 0 first", shortened(text));
                let diagnostic = Diagnostic::new(code::TYPE_MISMATCH, span, message)
                    .label("one value")
                    .help(format!("{help}; what the list leaves out is 0"));
                Err(self.report(diagnostic))
            }
        }
    }

    fn too_many_values(&mut self, rest: Span, values: usize, length: u32) -> Reported {
        let elements =
            if length == 1 { "one element".into() } else { format!("{length} elements") };
        let message = format!("{values} initial values for {elements}");
        let diagnostic = Diagnostic::new(code::OUT_OF_RANGE, rest, message)
            .label("no element is left for what starts here")
            .help("shorten the list, or make the array longer");
        self.report(diagnostic)
    }

    /// The image address of a `BOOL`, or that of the first element of an array of them.
    fn address(
        &mut self,
        kind: Kind,
        name: ast::Name<'s>,
        literal: ast::Literal<'s>,
    ) -> Checked<u16> {
        let (low, high, what) = match kind.role {
            Role::Input => (0, 255, "inputs"),
            Role::Output => (256, 511, "outputs"),
            _ => (512, 1022, "variables"),
        };
        let last = u16::try_from(kind.length.unwrap_or(1) - 1).unwrap_or(u16::MAX);
        let inside = |address: &i128| (low..=high - i128::from(last)).contains(address);
        let first = literal::integer(literal).filter(inside).map(|address| address as u16);
        let problem = |message: String| Diagnostic::new(code::BAD_ADDRESS, literal.span, message);
        let another = "choose another address, or leave `at` out";
        let diagnostic = match first {
            _ if kind.ty != Type::Bool => problem("only a BOOL has an image address".to_owned())
                .label(format!("the address of a value of type {}", kind.ty))
                .help("leave `at` out"),
            None => problem(format!("{what} have the addresses {low} to {high}"))
                .label(match last {
                    0 => "outside that region".to_owned(),
                    _ => format!("{} addresses in a row do not fit there", last + 1),
                })
                .help(another),
            Some(first) => {
                let taken =
                    (first..=first + last).find(|address| self.addresses.contains_key(address));
                let Some(taken) = taken else {
                    self.addresses.extend((first..=first + last).map(|address| (address, name)));
                    return Ok(first);
                };
                let other = self.addresses[&taken];
                let which =
                    if last == 0 { "this address".into() } else { format!("address {taken}") };
                problem(format!("`{}` has {which} already", other.text))
                    .label("taken")
                    .also(other.span, "has the same address")
                    .help(another)
            }
        };
        Err(self.report(diagnostic))
    }
}
