//! `hotrail equations`: the document computes what the program does, and the text is what people
//! expect to read.

mod common;

use std::collections::HashMap;

use common::{amount, generate};
use fastrand::Rng;
use hotrail::equations::{self, Graph, Kind};
use hotrail::eval::Evaluator;
use hotrail::model::{BinaryOp, Function, Names, Program, Role, VariableId, convert};
use hotrail::report::Report;
use hotrail::source::Source;
use hotrail::types::Type;
use serde_json::Value;

fn analyze(text: &str) -> Program {
    let (program, findings) = hotrail::analyze(&Source::new("demo.ladder", text));
    program.unwrap_or_else(|| panic!("{findings:?}"))
}

fn document(program: &Program, flat: bool) -> Value {
    serde_json::from_str(&Report::new(program, flat).json()).unwrap()
}

/// Runs the equations of a document, scan by scan, with nothing but what the document says.
struct Machine<'p> {
    names: Names<'p>,
    document: Value,
    /// What the last scan left, and the inputs.
    values: HashMap<VariableId, i64>,
    is_first_scan: bool,
    /// What each edge saw in the last scan, by the text of what it looks at.
    seen: HashMap<String, i64>,
    /// In this scan: what edges see, what equations and parts are.
    sees: HashMap<String, i64>,
    written: HashMap<u64, i64>,
    parts: HashMap<u64, i64>,
}

impl<'p> Machine<'p> {
    fn new(program: &'p Program, flat: bool) -> Self {
        Machine {
            names: Names::of(program),
            document: document(program, flat),
            values: program.variables.iter().map(|(id, one)| (id, one.initial)).collect(),
            is_first_scan: true,
            seen: HashMap::new(),
            sees: HashMap::new(),
            written: HashMap::new(),
            parts: HashMap::new(),
        }
    }

    fn variable(&self, name: &Value) -> VariableId {
        let name = name.as_str().unwrap();
        self.names.variable(name).unwrap_or_else(|| panic!("no variable {name}"))
    }

    fn scan(&mut self) {
        let document = std::mem::take(&mut self.document);
        let mut left = self.values.clone();
        for equation in document["equations"].as_array().unwrap() {
            for part in equation["parts"].as_array().unwrap() {
                let value = self.evaluate(&part["value"]);
                self.parts.insert(part["part"].as_u64().unwrap(), value);
            }
            assert_eq!(equation["kind"], "assign");
            let value = self.evaluate(&equation["value"]);
            self.written.insert(equation["number"].as_u64().unwrap(), value);
            left.insert(self.variable(&equation["target"]), value);
        }
        self.document = document;
        self.values = left;
        self.is_first_scan = false;
        self.seen = std::mem::take(&mut self.sees);
    }

    fn evaluate(&mut self, expression: &Value) -> i64 {
        let map = expression.as_object().unwrap();
        let mut list = |key: &str| -> Vec<i64> {
            map[key].as_array().unwrap().iter().map(|one| self.evaluate(one)).collect()
        };
        let ty = || Type::named(map["type"].as_str().unwrap()).unwrap();
        if let Some(number) = map.get("number") {
            number.as_i64().unwrap()
        } else if let Some(name) = map.get("variable") {
            match map["written_by"].as_u64() {
                Some(equation) => self.written[&equation],
                None if name == "first_scan" => self.is_first_scan.into(),
                None => self.values[&self.variable(name)],
            }
        } else if let Some(part) = map.get("part") {
            self.parts[&part.as_u64().unwrap()]
        } else if let Some(now) = map.get("rise").or(map.get("fall")) {
            let value = self.evaluate(now);
            let before = self.seen.get(&now.to_string()).copied().unwrap_or(0);
            self.sees.insert(now.to_string(), value);
            let (on, off) =
                if map.contains_key("rise") { (value, before) } else { (before, value) };
            i64::from(on == 1 && off == 0)
        } else if let Some(bit) = map.get("bit") {
            self.evaluate(&map["of"]) >> bit.as_i64().unwrap() & 1
        } else if let Some(operand) = map.get("not") {
            1 - self.evaluate(operand)
        } else if map.contains_key("all") {
            list("all").into_iter().min().unwrap()
        } else if map.contains_key("any") {
            list("any").into_iter().max().unwrap()
        } else if let Some(function) = map.get("function") {
            apply(function.as_str().unwrap(), ty(), &list("operands"))
        } else {
            let [a, b] = list("operands")[..] else { panic!("an operator has two operands") };
            combine(map["operator"].as_str().unwrap(), ty(), a, b)
        }
    }
}

/// The value of a function, one of the language or of the document alone.
fn apply(name: &str, ty: Type, operands: &[i64]) -> i64 {
    let function = match name {
        "NOT" => return ty.wrap(!operands[0]),
        "WITH_BIT" => {
            let mask = 1 << operands[1];
            return ty.wrap((operands[0] & !mask) | (operands[2] * mask));
        }
        "ELEMENT" => {
            let at = usize::try_from(operands[0]).ok();
            return at.and_then(|at| operands.get(at + 1)).copied().unwrap_or(0);
        }
        name if name.starts_with("TO_") => return convert(ty, operands[0]),
        "SEL" => Function::Select,
        "ABS" => Function::Abs,
        "MIN" => Function::Min,
        "MAX" => Function::Max,
        "LIMIT" => Function::Limit,
        "SHL" => Function::ShiftLeft,
        "SHR" => Function::ShiftRight,
        "ROL" => Function::RotateLeft,
        "ROR" => Function::RotateRight,
        other => panic!("{other}"),
    };
    function.apply(ty, operands)
}

/// The value of an operator between two values.
fn combine(symbol: &str, ty: Type, a: i64, b: i64) -> i64 {
    let op = match symbol {
        "=" => return (a == b).into(),
        "<>" => return (a != b).into(),
        "<" => return (a < b).into(),
        "<=" => return (a <= b).into(),
        ">" => return (a > b).into(),
        ">=" => return (a >= b).into(),
        "+" => BinaryOp::Add,
        "-" => BinaryOp::Subtract,
        "*" => BinaryOp::Multiply,
        "/" => BinaryOp::Divide,
        "MOD" => BinaryOp::Modulo,
        "AND" => BinaryOp::And,
        "OR" => BinaryOp::Or,
        "XOR" => BinaryOp::Xor,
        other => panic!("{other}"),
    };
    op.apply(ty, a, b)
}

/// Programs without blocks: what a block does is not in the document.
#[test]
fn the_document_computes_what_the_program_does() {
    let mut programs = 0;
    let seeds = amount("HOTRAIL_RANDOM_PROGRAMS", 1000).min(2000);
    for seed in 0..seeds {
        let text = generate::program(seed);
        let program = analyze(&text);
        if !program.instances.is_empty() {
            continue;
        }
        programs += 1;
        let mut machines = [Machine::new(&program, false), Machine::new(&program, true)];
        let mut evaluator = Evaluator::new(&program);
        let mut random = Rng::with_seed(seed);
        for scan in 0..20 {
            for (input, variable) in program.with_role(Role::Input) {
                let value = variable.ty.wrap(random.i64(-2..3));
                evaluator.drive(input, value);
                machines.iter_mut().for_each(|one| *one.values.get_mut(&input).unwrap() = value);
            }
            evaluator.scan(false);
            for machine in &mut machines {
                machine.scan();
                for (output, variable) in program.with_role(Role::Output) {
                    assert_eq!(
                        machine.values[&output],
                        evaluator.value(output),
                        "seed {seed}, scan {scan}, {}:\n{text}",
                        variable.name
                    );
                }
            }
        }
    }
    assert!(programs * 10 > seeds, "{programs} of {seeds}");
}

const MANY_THINGS: &str = "ladder demo
    input  a, b, `I:0/3`
    input  price : INT
    output y, z, w
    output total : INT
    output mask : WORD
    rung a !y [ ( y ) | b ( z ) ] rising ( w )
    rung \"sum\" rise(a) { total := total + price } { mask := NOT mask OR 16#F }
    rung a t.Q (R t)
    rung [ `I:0/3` | a b ] t:TON(PT := 1500ms) c:CTU(R := fall(b), PV := 3) (S w)
    rung b (R t)
    rung t.Q [ a | !a ] { t.ET > 10ms } (R w)";

#[test]
fn equations_read_as_kept() {
    let program = analyze(MANY_THINGS);
    insta::assert_snapshot!("equations", Report::new(&program, false).text());
    insta::assert_snapshot!("equations_flat", Report::new(&program, true).text());
    insta::assert_snapshot!("equations_dot", Report::new(&program, false).dot());
    let json = Report::new(&program, false).json();
    insta::assert_snapshot!("equations_json", json);
}

/// Four outputs of which one reads another one: the FPGA paper's table has three orders, though
/// two levels are enough.
#[test]
fn the_excite_order_of_four_outputs() {
    let program = analyze(
        "ladder demo  input X1, X2, X3, X4  output Y1, Y2, Y3, Y4
         rung X1 X2 X3 X4 ( Y1 )
         rung X1 X2 ( Y2 )
         rung X3 ( Y3 )
         rung Y2 X4 ( Y4 )",
    );
    let document = document(&program, false);
    assert_eq!(document["excite_order"], serde_json::json!([[1, 3], [2], [4]]));
    assert_eq!(document["levels"], serde_json::json!([[1, 2, 3], [4]]));
    assert_eq!(document["longest_chain"]["rungs"], serde_json::json!([2, 4]));
}

/// The dependencies of a program as `from kind to`, rungs from 1.
fn dependencies(text: &str) -> Vec<String> {
    let program = analyze(text);
    let graph = Graph::new(&program, &equations::lower(&program));
    let kind = |kind| match kind {
        Kind::ReadAfterWrite => "raw",
        Kind::WriteAfterRead => "war",
        Kind::WriteAfterWrite => "waw",
    };
    let line = |one: &hotrail::equations::Dependency| {
        format!("{} {} {}", one.from + 1, kind(one.kind), one.to + 1)
    };
    graph.dependencies.iter().map(line).collect()
}

#[test]
fn dependencies_are_of_three_kinds() {
    let start = "ladder demo  input a, b  output x, y  ";
    let cases: [(&str, &[&str]); 8] = [
        ("rung a (x) rung x (y)", &["1 raw 2"]),
        ("rung x (y) rung a (x)", &["1 war 2"]),
        ("rung a (x) rung b (x)", &["1 waw 2"]),
        ("rung a (x) rung b (y)", &[]),
        // A seal-in reads and writes in one rung.
        ("rung [ a | x ] (x) rung x (y)", &["1 raw 2"]),
        // A set coil reads what it keeps.
        ("rung a (S x) rung b (R x)", &["1 raw 2", "1 waw 2"]),
        // What stands behind the last coil of a rung decides nothing.
        ("rung a (x) rung b (y) !x rung a (y)", &["2 waw 3"]),
        ("rung rise(a) (x) rung rise(a) (y)", &[]),
    ];
    for (rungs, expected) in cases {
        assert_eq!(dependencies(&format!("{start}{rungs}")), expected, "{rungs}");
    }
}

#[test]
fn all_that_touches_an_instance_is_in_order() {
    let start = "ladder demo  input a, b  output x, y  ";
    let cases: [(&str, &[&str]); 4] = [
        ("rung a t:TON(PT := 5ms) rung t.Q (x) rung { t.ET > 1ms } (y)", &["1 raw 2", "1 raw 3"]),
        ("rung t.Q (x) rung a t:TON(PT := 5ms) (y)", &["1 war 2"]),
        ("rung a (R t) rung a t:TON(PT := 5ms) rung b (R t)", &["1 waw 2", "2 waw 3"]),
        ("rung a { t.PT := 5ms } rung b t:TON() (x)", &["1 waw 2"]),
    ];
    for (rungs, expected) in cases {
        assert_eq!(dependencies(&format!("{start}{rungs}")), expected, "{rungs}");
    }
}

#[test]
fn a_shift_register_changes_words_of_the_program() {
    let start = "ladder demo  input a, b  output x, y  var w : WORD  ";
    let cases: [(&str, &[&str]); 3] = [
        ("rung a s:SHL(REG := w) rung w.3 (y)", &["1 raw 2"]),
        ("rung w.3 (y) rung a s:SHL(REG := w)", &["1 war 2"]),
        ("rung a (w.0) rung a s:SHL(REG := w)", &["1 raw 2", "1 waw 2"]),
    ];
    for (rungs, expected) in cases {
        assert_eq!(dependencies(&format!("{start}{rungs}")), expected, "{rungs}");
    }
}

/// The page shows a program and what the command prints of it.
#[test]
fn the_page_is_true() {
    let page = std::fs::read_to_string("docs/equations.md").unwrap();
    let block = |start: &str| page.split(start).nth(1).unwrap().split("```").next().unwrap();
    let program = analyze(block("```ladder\n"));
    let [text, flat] = [false, true].map(|flat| Report::new(&program, flat).text());
    assert_eq!(text.split("\ndependencies").next(), Some(block("<!-- equations -->\n```text\n")));
    let shown = block("<!-- equations flat -->\n```text\n");
    assert_eq!(flat.split("\ndependencies").next(), Some(shown));
    assert!(text.ends_with(block("## The dependencies\n\n```text\n")), "{text}");
}

/// Written out, the last one would have some 10^80 names.
#[test]
fn shared_parts_have_names() {
    let mut text = "ladder demo  input a, b  output y  var v0, v1".to_owned();
    (2..200).for_each(|number| text += &format!(", v{number}"));
    text += "\nrung a (v0)\nrung b (v1)\n";
    for number in 2..200 {
        let (one, two) = (number - 1, number - 2);
        text += &format!("rung [ v{one} !v{two} | !v{one} v{two} ] (v{number})\n");
    }
    text += "rung v199 (y)";
    let program = analyze(&text);
    let report = Report::new(&program, true).text();
    assert!(report.len() < 40_000, "{}", report.len());
    assert!(report.contains("@3 <- @2 & !@1 | !@2 & @1\n"), "{report}");
}
