//! General networks: the bridge in all states of its contacts, and networks with very many paths.

mod common;

use common::node_name;
use fastrand::Rng;
use hotrail::circuit::Simulator;
use hotrail::eval::Evaluator;
use hotrail::expand;
use hotrail::model::{Program, Role, VariableId};
use hotrail::source::Source;

fn analyze(text: &str) -> Program {
    let (program, findings) = hotrail::analyze(&Source::new("network.ladder", text));
    program.unwrap_or_else(|| panic!("{findings:?}"))
}

/// Evaluator and circuit of a program that has `BOOL` inputs and one output.
struct Both<'p> {
    evaluator: Evaluator<'p>,
    circuit: Simulator,
    inputs: Vec<VariableId>,
    output: VariableId,
}

impl<'p> Both<'p> {
    fn new(program: &'p Program) -> Self {
        Both {
            evaluator: Evaluator::new(program),
            circuit: Simulator::new(&hotrail::compile(program, &expand::Options::default())),
            inputs: program.with_role(Role::Input).map(|(id, _)| id).collect(),
            output: program.with_role(Role::Output).next().unwrap().0,
        }
    }

    /// The output after a scan, on which both agree.
    fn scan(&mut self, contacts: &[bool]) -> bool {
        let mut bits = vec![0];
        for (&input, &contact) in self.inputs.iter().zip(contacts) {
            self.evaluator.drive(input, contact.into());
            bits.push(contact.into());
        }
        self.evaluator.scan(false);
        self.circuit.settle(&bits);
        self.circuit.clock();
        let meant = self.evaluator.value(self.output) == 1;
        assert_eq!(self.circuit.output(0) == 1, meant, "{contacts:?}");
        meant
    }
}

#[test]
fn the_bridge_conducts_on_its_six_paths() {
    let paths: [&[usize]; 6] =
        [&[9, 1], &[2, 3, 4, 1], &[5, 6, 1], &[5, 7, 8], &[9, 6, 7, 8], &[2, 3, 4, 6, 7, 8]];
    let text = std::fs::read_to_string("examples/bridge/bridge.ladder").unwrap();
    let program = analyze(&text);
    let mut both = Both::new(&program);
    for state in 0..512 {
        let contacts: Vec<bool> = (0..9).map(|contact| state >> contact & 1 == 1).collect();
        let meant = paths.iter().any(|path| path.iter().all(|&contact| contacts[contact - 1]));
        assert_eq!(both.scan(&contacts), meant, "{contacts:?}");
    }
}

/// Every node connected with every other one, and the number of connections.
fn mesh(nodes: usize, arrow: &str) -> (String, usize) {
    let (mut inputs, mut connections) = (Vec::new(), String::new());
    for from in 0..nodes {
        for to in (0..nodes).filter(|&to| if arrow == "->" { to != from } else { to > from }) {
            inputs.push(format!("c_{from}_{to}"));
            connections +=
                &format!("{} {arrow} {} : c_{from}_{to}\n", node_name(from), node_name(to));
        }
    }
    let inputs = (inputs.join(", "), inputs.len());
    (format!("ladder mesh input {} output y\nrung net {{ {connections} }} (y)", inputs.0), inputs.1)
}

/// A complete network of 20 nodes has some 10^16 paths.
#[test]
fn many_paths_are_no_long_equations() {
    for (arrow, most) in [("<->", 2_600), ("->", 5_000)] {
        let (text, connections) = mesh(20, arrow);
        let program = analyze(&text);
        let design = hotrail::compile(&program, &expand::Options::default());
        let cells = design.top().len();
        assert!(cells < most, "{arrow}: {cells} cells");
        let mut both = Both::new(&program);
        let mut random = Rng::with_seed(1);
        let mut conducted = 0;
        for round in 0..400 {
            // From hardly any contact closed, where paths are long, to many.
            let closed = 2 + round % 20;
            let contacts: Vec<bool> =
                (0..connections).map(|_| random.usize(..200) < closed).collect();
            conducted += u32::from(both.scan(&contacts));
        }
        assert!((50..350).contains(&conducted), "{arrow}: {conducted} of 400");
    }
}

/// A rail of 60 nodes that is one long path: closed, then open at each place in turn.
#[test]
fn a_long_path_conducts_both_ways_and_is_as_short_as_a_series() {
    let mut text = "ladder long input ".to_owned();
    text += &(0..61).map(|contact| format!("c{contact}")).collect::<Vec<_>>().join(", ");
    text += " output y\nrung net { left <-> n0 : c0\n";
    (0..59).for_each(|node| text += &format!("n{} <-> n{node} : c{}\n", node + 1, node + 1));
    text += "right <-> n59 : c60 } (y)";
    let program = analyze(&text);
    let equations = hotrail::equations::lower(&program);
    // 61 reads, and what takes all of them.
    assert_eq!(equations.exprs.len(), 62);
    let mut both = Both::new(&program);
    assert!(both.scan(&[true; 61]));
    for open in 0..61 {
        let mut contacts = [true; 61];
        contacts[open] = false;
        assert!(!both.scan(&contacts));
    }
}

/// Three ways lead to a node and two away from it: what reaches it is computed once.
#[test]
fn a_node_where_ways_meet_is_computed_once() {
    let text = "ladder meeting input a, b, c, d, e, f, g, h, i output y rung net {
        left -> hub : a   left -> one : b   left -> two : c   one -> hub : d   two -> hub : e
        hub -> right : f  hub -> three : g  three -> right : h  two -> three : i } (y)";
    let equations = hotrail::equations::lower(&analyze(text));
    // 9 reads; hub is a | b d | c e, y is hub f | (hub g | c i) h.
    assert_eq!(equations.exprs.len(), 9 + 3 + 6);
}
