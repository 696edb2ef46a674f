//! A report as a JSON document. Its form is described in `docs/equations.md`; a change that a
//! reader would notice raises [`FORMAT`].

use serde::Serialize;

use super::Report;
use super::formula::{Formula, FormulaId};
use super::listing::{Equation, Left};
use super::order::OrderItem;
use super::parts::Parts;
use crate::equations::Kind;
use crate::model::Edge;

/// The version of the document's form.
const FORMAT: u32 = 1;

#[derive(Serialize)]
struct Document<'r> {
    format: u32,
    program: &'r str,
    flat: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    order: Option<OrderItem>,
    rungs: Vec<RungItem<'r>>,
    equations: Vec<EquationItem>,
    dependencies: Vec<DependencyItem>,
    levels: Vec<Vec<u32>>,
    excite_order: Vec<Vec<u32>>,
    longest_chain: ChainItem,
}

#[derive(Serialize)]
struct RungItem<'r> {
    number: u32,
    title: Option<&'r str>,
    line: u32,
    writes: Vec<String>,
}

#[derive(Serialize)]
struct EquationItem {
    number: u32,
    rung: u32,
    #[serde(flatten)]
    left: LeftItem,
    parts: Vec<PartItem>,
    value: Expression,
    text: String,
}

#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum LeftItem {
    Assign {
        target: String,
    },
    Call {
        instance: String,
        block: &'static str,
        arguments: Vec<ArgumentItem>,
        settings: Vec<SettingItem>,
    },
    Reset {
        instance: String,
    },
}

#[derive(Serialize)]
struct ArgumentItem {
    parameter: &'static str,
    value: Expression,
}

#[derive(Serialize)]
struct SettingItem {
    parameter: &'static str,
    value: String,
}

#[derive(Serialize)]
struct PartItem {
    part: u32,
    value: Expression,
}

#[derive(Serialize)]
#[serde(untagged)]
enum Expression {
    Number { number: i64, r#type: &'static str },
    Value { variable: String, written_by: Option<u32> },
    Part { part: u32 },
    Rise { rise: Box<Expression> },
    Fall { fall: Box<Expression> },
    Not { not: Box<Expression> },
    Bit { bit: u32, of: Box<Expression> },
    All { all: Vec<Expression> },
    Any { any: Vec<Expression> },
    Operator { operator: &'static str, r#type: &'static str, operands: Vec<Expression> },
    Function { function: &'static str, r#type: &'static str, operands: Vec<Expression> },
}

#[derive(Serialize)]
struct DependencyItem {
    from: u32,
    to: u32,
    kind: &'static str,
    through: String,
}

#[derive(Serialize)]
struct ChainItem {
    gates: u32,
    rungs: Vec<u32>,
}

impl Report<'_> {
    /// The whole report as one JSON object.
    pub fn json(&self) -> String {
        let rungs = self.program.rungs.iter().zip(self.written());
        let rungs = rungs.map(|(rung, writes)| RungItem {
            number: rung.number,
            title: rung.title.as_deref(),
            line: rung.line,
            writes,
        });
        let dependencies = self.graph.dependencies.iter().map(|one| DependencyItem {
            from: self.number(one.from),
            to: self.number(one.to),
            kind: match one.kind {
                Kind::ReadAfterWrite => "read-after-write",
                Kind::WriteAfterRead => "write-after-read",
                Kind::WriteAfterWrite => "write-after-write",
            },
            through: self.through(one),
        });
        let document = Document {
            format: FORMAT,
            program: &self.program.name,
            flat: self.is_flat,
            order: self.order().map(|order| order.item()),
            rungs: rungs.collect(),
            equations: self.equation_items(),
            dependencies: dependencies.collect(),
            levels: self.numbered(self.levels()),
            excite_order: self.numbered(self.excite_order()),
            longest_chain: ChainItem {
                gates: self.chain.gates,
                rungs: self.chain.rungs.iter().map(|&rung| self.number(rung)).collect(),
            },
        };
        let text = serde_json::to_string_pretty(&document);
        text.expect("strings and numbers can be written as JSON") + "\n"
    }

    fn numbered(&self, lists: Vec<Vec<u32>>) -> Vec<Vec<u32>> {
        let numbers = |list: Vec<u32>| list.into_iter().map(|rung| self.number(rung)).collect();
        lists.into_iter().map(numbers).collect()
    }

    fn equation_items(&self) -> Vec<EquationItem> {
        let mut parts = Parts::new(&self.listing);
        let mut newest = self.names.start();
        let mut items = Vec::with_capacity(self.listing.equations.len());
        for equation in self.listing.shown() {
            self.names.go_to(&mut newest, equation);
            let new = parts.introduce(&self.listing.formulas, equation);
            items.push(EquationItem {
                number: equation.number,
                rung: self.number(equation.rung),
                left: self.left_item(&parts, equation),
                parts: new
                    .into_iter()
                    .map(|part| PartItem {
                        part: parts.number(part).expect("it was introduced"),
                        value: self.inside(&parts, part),
                    })
                    .collect(),
                value: self.expression(&parts, equation.right),
                text: self.line(&parts, &newest, equation),
            });
        }
        items
    }

    fn left_item(&self, parts: &Parts, equation: &Equation) -> LeftItem {
        match &equation.left {
            Left::Variable(variable) => LeftItem::Assign { target: self.names.variable(*variable) },
            Left::Reset(instance) => LeftItem::Reset { instance: self.names.instance(*instance) },
            Left::Call(instance, shape) => {
                let argument = |&(parameter, value): &(&'static str, FormulaId)| ArgumentItem {
                    parameter,
                    value: self.expression(parts, value),
                };
                let setting = |(parameter, value)| SettingItem { parameter, value };
                LeftItem::Call {
                    instance: self.names.instance(*instance),
                    block: shape.block.name,
                    arguments: equation.arguments.iter().map(argument).collect(),
                    settings: self.names.settings(shape).into_iter().map(setting).collect(),
                }
            }
        }
    }

    fn expression(&self, parts: &Parts, id: FormulaId) -> Expression {
        match parts.number(id) {
            Some(part) => Expression::Part { part },
            None => self.inside(parts, id),
        }
    }

    fn inside(&self, parts: &Parts, id: FormulaId) -> Expression {
        let list =
            |list: &[FormulaId]| list.iter().map(|&one| self.expression(parts, one)).collect();
        let one = |one: FormulaId| Box::new(self.expression(parts, one));
        match &self.listing.formulas.arena[id] {
            Formula::Number(value, ty) => Expression::Number { number: *value, r#type: ty.name() },
            Formula::Value(variable, writer) => Expression::Value {
                variable: self.names.variable(*variable),
                written_by: self.names.writer(*writer),
            },
            Formula::Edge(Edge::Rise, now) => Expression::Rise { rise: one(*now) },
            Formula::Edge(Edge::Fall, now) => Expression::Fall { fall: one(*now) },
            Formula::Not(operand) => Expression::Not { not: one(*operand) },
            Formula::All(operands) => Expression::All { all: list(operands) },
            Formula::Any(operands) => Expression::Any { any: list(operands) },
            Formula::Bit(whole, bit) => Expression::Bit { bit: *bit, of: one(*whole) },
            Formula::Infix(operator, pair, ty) => {
                Expression::Operator { operator, r#type: ty.name(), operands: list(pair) }
            }
            Formula::Apply(function, operands, ty) => {
                Expression::Function { function, r#type: ty.name(), operands: list(operands) }
            }
        }
    }
}
