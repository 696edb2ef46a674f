//! Writes what moves several flip-flops together as a choice.
//!
//! Before: any circuit. After: the same outputs in every scan; where one condition clears or sets
//! several registers, the next value of each is `condition ? 0 : ...` instead of gates, and where
//! they keep their values unless a condition holds, `condition ? ... : itself`. Synthesis finds
//! the reset and the enable of flip-flops in choices only, and one that several share costs less
//! than gates around each. A condition that moves one register alone stays in its gates.

use std::collections::{BTreeMap, HashMap};

use super::rebuild::{Rebuild, rebuild};
use crate::circuit::flatten::copy_cell;
use crate::circuit::{Cell, Circuit, Net, Op, RegisterId};
use crate::index::index;

/// How many bits a condition moves before it is worth a choice.
const BITS: u32 = 3;
/// How deep a next value is searched for conditions.
const DEPTH: u32 = 4;
/// How many operands of a list, and conditions of a net, are looked at.
const LIST: usize = 8;

/// The circuit with choices, if some registers have a condition in common.
pub fn share(circuit: &Circuit) -> Option<Circuit> {
    let mut moved: Vec<Moved> = Vec::new();
    let mut values: Vec<Option<Net>> = vec![None; circuit.registers.len()];
    for (net, cell) in circuit.cells() {
        if let Op::Register(id) = cell.op {
            values[index(id)] = Some(net);
        }
    }
    for (id, register) in circuit.registers.iter() {
        if let Some(own) = values[index(id)] {
            moved.push(Moved::of(circuit, id, register.next, own));
        }
    }
    let mut bits: HashMap<(Kind, Net), u32> = HashMap::new();
    for register in &moved {
        for key in register.keys() {
            *bits.entry(key).or_default() += circuit.registers[register.id].width;
        }
    }
    let mut chosen: HashMap<Net, Chosen> = HashMap::new();
    for register in &moved {
        if let Some(choice) = register.choose(circuit, &bits) {
            chosen.insert(circuit.registers[register.id].next, choice);
        }
    }
    if chosen.is_empty() {
        return None;
    }
    let mut made = Made::new();
    Some(rebuild(circuit, |rebuild, net, cell| match chosen.get(&net) {
        None => rebuild.copy(cell),
        Some(choice) => choice.make(rebuild, &mut made, net, cell),
    }))
}

/// What a condition does to registers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Kind {
    /// They are 0 or 1 where it holds.
    Forces,
    /// They keep their values where it does not hold.
    Enables,
}

/// The conditions that move a register.
struct Moved {
    id: RegisterId,
    own: Net,
    /// It takes that bit where the condition holds.
    forced: Vec<(Net, bool)>,
    /// It keeps its value where one of these is 0, whatever else forces it.
    enabled: Vec<Net>,
}

impl Moved {
    fn of(circuit: &Circuit, id: RegisterId, next: Net, own: Net) -> Self {
        let forced = match circuit.cell(next) {
            Cell { op: Op::And(list), width: 1 } => circuit
                .list(list)
                .iter()
                .take(LIST)
                .filter_map(|&net| match circuit.cell(net).op {
                    Op::Not(from) => Some((from, false)),
                    _ => None,
                })
                .collect(),
            Cell { op: Op::Or(list), width: 1 } => {
                circuit.list(list).iter().take(LIST).map(|&net| (net, true)).collect()
            }
            _ => Vec::new(),
        };
        let conditions = Conditions { circuit, own };
        let enabled = match conditions.keep(next, DEPTH) {
            Keep::Where(nets) => nets,
            Keep::Always | Keep::Never => Vec::new(),
        };
        Moved { id, own, forced, enabled }
    }

    fn keys(&self) -> impl Iterator<Item = (Kind, Net)> {
        let forced = self.forced.iter().map(|&(net, _)| (Kind::Forces, net));
        forced.chain(self.enabled.iter().map(|&net| (Kind::Enables, net)))
    }

    /// The condition that moves most bits, if it moves enough, and the next value is not a choice
    /// by it already.
    fn choose(&self, circuit: &Circuit, bits: &HashMap<(Kind, Net), u32>) -> Option<Chosen> {
        let best = self.keys().max_by_key(|&key| (bits[&key], std::cmp::Reverse(key.1)))?;
        if bits[&best] < BITS {
            return None;
        }
        let (kind, condition) = best;
        let next = circuit.registers[self.id].next;
        let is_done =
            matches!(circuit.cell(next).op, Op::Mux { select, .. } if select == condition);
        let force = match kind {
            Kind::Forces => Some(self.forced.iter().find(|(net, _)| *net == condition)?.1),
            Kind::Enables => None,
        };
        (!is_done).then_some(Chosen { condition, force, own: self.own })
    }
}

/// When a next value is the register's own value.
enum Keep {
    Always,
    Never,
    /// Where one of these is 0.
    Where(Vec<Net>),
}

/// A search for what keeps a register as it is.
struct Conditions<'c> {
    circuit: &'c Circuit,
    own: Net,
}

impl Conditions<'_> {
    fn keep(&self, net: Net, depth: u32) -> Keep {
        if net == self.own {
            return Keep::Always;
        }
        if depth == 0 {
            return Keep::Never;
        }
        let Cell { op, width } = self.circuit.cell(net);
        match op {
            Op::And(list) if width == 1 => self.keep_in_list(self.circuit.list(list), depth, true),
            Op::Or(list) if width == 1 => self.keep_in_list(self.circuit.list(list), depth, false),
            Op::Mux { select, on, off } => {
                let (on, off) = (self.keep(on, depth - 1), self.keep(off, depth - 1));
                let where_off = both(off, || self.forcing(select, false, depth - 1));
                let where_on = both(on, || self.forcing(select, true, depth - 1));
                match (where_on, where_off) {
                    (Keep::Where(mut nets), Keep::Where(more)) => {
                        nets.extend(more);
                        Keep::Where(nets)
                    }
                    (Keep::Never, keep) | (keep, _) => keep,
                }
            }
            _ => Keep::Never,
        }
    }

    /// One operand is the register's value, and the others say nothing.
    fn keep_in_list(&self, list: &[Net], depth: u32, neutral: bool) -> Keep {
        if list.len() > LIST {
            return Keep::Never;
        }
        let mut result = Keep::Never;
        let kept = list.iter().enumerate().find_map(|(at, &net)| match self.keep(net, depth - 1) {
            Keep::Never => None,
            keep => Some((at, keep)),
        });
        if let Some((at, keep)) = kept {
            result = keep;
            for (other, &net) in list.iter().enumerate() {
                if other != at {
                    result = both(result, || self.forcing(net, neutral, depth - 1));
                }
            }
        }
        result
    }

    /// The nets that make a net that value where they are 0.
    fn forcing(&self, net: Net, value: bool, depth: u32) -> Vec<Net> {
        let mut nets = Vec::new();
        if !value {
            nets.push(net);
        }
        if depth == 0 {
            return nets;
        }
        match self.circuit.cell(net).op {
            Op::Not(from) => nets.extend(self.forcing(from, !value, depth - 1)),
            Op::And(list) | Op::Or(list) => {
                let is_and = matches!(self.circuit.cell(net).op, Op::And(_));
                let list = self.circuit.list(list);
                let mut parts =
                    list.iter().take(LIST).map(|&operand| self.forcing(operand, value, depth - 1));
                if is_and != value {
                    // One operand is enough.
                    nets.extend(parts.flatten());
                } else if list.len() <= LIST {
                    let first = parts.next().unwrap_or_default();
                    nets.extend(parts.fold(first, common));
                }
            }
            _ => {}
        }
        nets.truncate(LIST);
        nets
    }
}

fn common(mut nets: Vec<Net>, others: Vec<Net>) -> Vec<Net> {
    nets.retain(|net| others.contains(net));
    nets
}

fn both(keep: Keep, forcing: impl FnOnce() -> Vec<Net>) -> Keep {
    let nets = match keep {
        Keep::Never => return Keep::Never,
        Keep::Always => forcing(),
        Keep::Where(nets) => common(nets, forcing()),
    };
    if nets.is_empty() { Keep::Never } else { Keep::Where(nets) }
}

/// What becomes of a next value.
struct Chosen {
    condition: Net,
    /// The bit that the condition makes of it; nothing if it keeps its value without it.
    force: Option<bool>,
    own: Net,
}

impl Chosen {
    fn make(&self, rebuild: &mut Rebuild<'_>, made: &mut Made, net: Net, cell: Cell) -> Net {
        let known = (self.condition, self.force.is_none());
        let moved = copy_where(rebuild, made, known, cell, DEPTH);
        // Who reads this one under the same condition reads what is behind the choice.
        made.insert((known, net), moved);
        let condition = rebuild.net(self.condition);
        match self.force {
            Some(bit) => {
                let bit = rebuild.to.bit(bit);
                rebuild.to.choice(condition, bit, moved)
            }
            None => {
                let own = rebuild.net(self.own);
                rebuild.to.choice(condition, moved, own)
            }
        }
    }
}

/// A condition that holds or does not.
type Known = (Net, bool);

/// The copies of nets as simple as they are under a condition.
type Made = HashMap<(Known, Net), Net>;

/// The copy of a cell as simple as it is where a condition is known.
fn copy_where(
    rebuild: &mut Rebuild<'_>,
    made: &mut Made,
    known: Known,
    cell: Cell,
    depth: u32,
) -> Net {
    let from = rebuild.from;
    let mut operands = BTreeMap::new();
    from.for_each_operand(cell, |net| {
        operands.insert(net, net);
    });
    for (&net, copy) in &mut operands {
        *copy = net_where(rebuild, made, known, net, depth);
    }
    copy_cell(&mut rebuild.to, from, cell, |net| operands[&net])
}

fn net_where(
    rebuild: &mut Rebuild<'_>,
    made: &mut Made,
    known: Known,
    net: Net,
    depth: u32,
) -> Net {
    if net == known.0 {
        return rebuild.to.bit(known.1);
    }
    if let Some(&copy) = made.get(&(known, net)) {
        return copy;
    }
    let cell = rebuild.from.cell(net);
    if depth == 0 || !is_gate(cell) || !depends(rebuild.from, known.0, net, depth) {
        return rebuild.net(net);
    }
    let copy = copy_where(rebuild, made, known, cell, depth - 1);
    made.insert((known, net), copy);
    copy
}

fn is_gate(cell: Cell) -> bool {
    matches!(cell.op, Op::Not(_) | Op::And(_) | Op::Or(_) | Op::Mux { .. })
}

/// True if a net is among what the other one is made of, not too deep.
fn depends(circuit: &Circuit, on: Net, net: Net, depth: u32) -> bool {
    if net == on {
        return true;
    }
    // What stands in front of it cannot depend on it.
    if depth == 0 || net < on || !is_gate(circuit.cell(net)) {
        return false;
    }
    let mut found = false;
    circuit.for_each_operand(circuit.cell(net), |operand| {
        found = found || depends(circuit, on, operand, depth - 1);
    });
    found
}
