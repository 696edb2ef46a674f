//! Who reads and writes what: built once, looked up by every rule.

use super::walk::{Comparison, Division, Part, Read, Size, Walk, Write};
use crate::index::index;
use crate::model::{Argument, Call, InstanceId, Net, Program, VariableId};

/// Everything that rules ask for. All lists are in text order, which is execution order.
pub(super) struct Index<'p> {
    pub program: &'p Program,
    /// Frequency of the board's clock in Hz.
    pub clock_hz: u64,
    pub reads: Vec<Read>,
    pub writes: Vec<Write>,
    pub comparisons: Vec<Comparison<'p>>,
    pub divisions: Vec<Division>,
    pub nets: Vec<&'p Net>,
    /// For each rung.
    pub sizes: Vec<Size>,
    /// For each variable, the number of its reads in rungs.
    read_counts: Vec<u32>,
    /// For each rung and one more, where its reads and its writes start.
    rungs: Vec<(usize, usize)>,
    /// For each variable, whether a test looks at it.
    read_by_tests: Vec<bool>,
    /// The writes again, those of one variable next to each other.
    writes_by_variable: Vec<Write>,
    /// For each variable and one more, where its writes start in `writes_by_variable`.
    starts: Vec<u32>,
    /// For each instance, whether there is an `(R name)`.
    reset: Vec<bool>,
    /// For each instance, its call; where it has two, the first.
    call_of: Vec<Option<&'p Call>>,
}

impl<'p> Index<'p> {
    pub fn new(program: &'p Program, clock_hz: u64) -> Self {
        let mut walk = Walk::new(program);
        let mut sizes = Vec::with_capacity(program.rungs.len());
        let mut rungs = vec![(0, 0)];
        for (number, rung) in program.rungs.iter().enumerate() {
            sizes.push(walk.rung(number as u32, rung));
            rungs.push((walk.reads.len(), walk.writes.len()));
        }
        let mut tests = Walk::new(program);
        program.tests.iter().for_each(|test| tests.statements(&test.statements));
        let mut read_by_tests = vec![false; program.variables.len()];
        tests.reads.iter().for_each(|read| read_by_tests[index(read.variable)] = true);
        let mut read_counts = vec![0; program.variables.len()];
        walk.reads.iter().for_each(|read| read_counts[index(read.variable)] += 1);
        let Walk { reads, writes, calls, comparisons, divisions, nets, reset, .. } = walk;
        let mut call_of = vec![None; program.instances.len()];
        for &call in &calls {
            call_of[index(call.instance)].get_or_insert(call);
        }
        let mut writes_by_variable = writes.clone();
        // The sort is stable, so the writes of a variable stay in text order.
        writes_by_variable.sort_by_key(|write| index(write.variable));
        let mut starts = vec![0; program.variables.len() + 1];
        writes.iter().for_each(|write| starts[index(write.variable) + 1] += 1);
        for variable in 1..starts.len() {
            starts[variable] += starts[variable - 1];
        }
        Index {
            program,
            clock_hz,
            reads,
            writes,
            divisions,
            comparisons,
            nets,
            sizes,
            read_counts,
            rungs,
            read_by_tests,
            writes_by_variable,
            starts,
            reset,
            call_of,
        }
    }

    /// The name of a variable as a user declares it.
    pub fn name(&self, variable: VariableId) -> &'p str {
        match self.program.array_of(variable) {
            Some(array) => &self.program.arrays[array].name,
            None => &self.program.variables[variable].name,
        }
    }

    /// The name of a part of a variable as a user writes it.
    pub fn part_name(&self, variable: VariableId, part: Part) -> String {
        let name = match part.element {
            Some(element) => &self.program.variables[element].name,
            None => self.name(variable),
        };
        match part.bit {
            Some(bit) => format!("{name}.{bit}"),
            None => name.to_owned(),
        }
    }

    /// The value at reset of a part that is always the same.
    pub fn initial(&self, part: Part) -> i64 {
        let value = part.element.map_or(0, |element| self.program.variables[element].initial);
        part.bit.map_or(value, |bit| value >> bit & 1)
    }

    /// True for every element of an array but the first, which stands for all.
    pub fn is_further_element(&self, variable: VariableId) -> bool {
        let array = self.program.array_of(variable);
        array.is_some_and(|array| self.program.arrays[array].elements.first != variable)
    }

    /// True if a rung looks at the variable.
    pub fn is_read(&self, variable: VariableId) -> bool {
        self.read_counts[index(variable)] > 0
    }

    /// True if a test looks at the variable.
    pub fn is_read_by_tests(&self, variable: VariableId) -> bool {
        self.read_by_tests[index(variable)]
    }

    /// The reads in a rung.
    pub fn reads_in(&self, rung: u32) -> &[Read] {
        let rung = rung as usize;
        &self.reads[self.rungs[rung].0..self.rungs[rung + 1].0]
    }

    /// The writes in a rung.
    pub fn writes_in(&self, rung: u32) -> &[Write] {
        let rung = rung as usize;
        &self.writes[self.rungs[rung].1..self.rungs[rung + 1].1]
    }

    /// The writes of a variable in text order.
    pub fn writes_of(&self, variable: VariableId) -> &[Write] {
        let range =
            self.starts[index(variable)] as usize..self.starts[index(variable) + 1] as usize;
        &self.writes_by_variable[range]
    }

    /// Every part that is written and always the same, with all the writes that may change it.
    pub fn written(&self) -> Vec<Written> {
        let mut written = Vec::new();
        for writes in self.writes_by_variable.chunk_by(|a, b| a.variable == b.variable) {
            let mut by_element = writes.to_vec();
            by_element.sort_by_key(|write| write.part.element.map(index));
            let chosen = by_element.partition_point(|write| write.part.element.is_none());
            let (chosen, known) = by_element.split_at(chosen);
            for of_element in known.chunk_by(|a, b| a.part.element == b.part.element) {
                let mut parts: Vec<Part> = Vec::new();
                for write in of_element {
                    if !parts.contains(&write.part) {
                        parts.push(write.part);
                    }
                }
                written.extend(parts.into_iter().map(|part| {
                    let all = chosen.iter().chain(of_element).copied();
                    let writes = all.filter(|write| write.part.overlaps(part)).collect();
                    Written { variable: of_element[0].variable, part, writes }
                }));
            }
        }
        written
    }

    /// What the call of an instance gives to a parameter.
    pub fn argument(&self, instance: InstanceId, port: usize) -> Option<&'p Argument> {
        let call = self.call_of[index(instance)]?;
        call.arguments.iter().chain(&call.starts).find(|argument| argument.port == port)
    }

    /// The call of each instance, without second calls.
    pub fn calls(&self) -> impl Iterator<Item = &'p Call> {
        self.call_of.iter().flatten().copied()
    }

    /// True if a coil resets the instance.
    pub fn is_reset(&self, instance: InstanceId) -> bool {
        self.reset[index(instance)]
    }
}

/// A part of a variable and what writes it.
pub(super) struct Written {
    pub variable: VariableId,
    pub part: Part,
    pub writes: Vec<Write>,
}
