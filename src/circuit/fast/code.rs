//! A circuit as a list of small instructions over slots of 64 bits.
//!
//! Instructions of one kind stand together in runs, as far as what they read allows, so that
//! hardly anything is decided while a scan runs.

/// What an instruction computes from the slots `a`, `b` and `c`. A slot that holds bits of
/// conditions has all its bits meaning the same thing: another lane each, or one bit 64 times.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    /// `a AND b`
    And,
    /// `a AND b AND c`
    And3,
    /// `a AND NOT b`
    AndNot,
    /// `a OR b`
    Or,
    /// `a OR b OR c`
    Or3,
    /// `a XOR b`
    Xor,
    /// Bit by bit: that of `b` where `a` has 1, else that of `c`.
    Mux,
    /// `a + b`, of that the bits in `c`.
    Add,
    /// `a - b`, of that the bits in `c`.
    Sub,
    /// `a * b`, of that the bits in `c`.
    Mul,
    /// `a / b`, unsigned; 0 where `b` is 0.
    Div,
    /// What that division leaves; 0 where `b` is 0.
    Rem,
    /// `a` shifted left by the number in `c`, with `b` in the bits that are free then.
    Join,
    /// All ones if `a` equals `b`, else 0.
    Eq,
    /// All ones if `a` is less than `b`, both unsigned, else 0.
    Less,
    /// `a` shifted right by the number in `b`, of that the bits in `c`.
    Shift,
    /// All ones if the bit of `a` whose number is in `b` is 1, else 0.
    Bit,
}

impl Kind {
    /// Every kind; a kind's place is its number.
    const ALL: [Kind; 17] = [
        Kind::And,
        Kind::And3,
        Kind::AndNot,
        Kind::Or,
        Kind::Or3,
        Kind::Xor,
        Kind::Mux,
        Kind::Add,
        Kind::Sub,
        Kind::Mul,
        Kind::Div,
        Kind::Rem,
        Kind::Join,
        Kind::Eq,
        Kind::Less,
        Kind::Shift,
        Kind::Bit,
    ];
}

/// Where a value is kept.
pub(super) type Slot = u32;

/// An instruction that has no place in a run yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Instruction {
    pub(super) kind: Kind,
    /// What it reads; a kind that takes two reads its first twice.
    pub(super) from: [Slot; 3],
}

/// An instruction in a run.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line<I> {
    from: [I; 3],
    to: I,
}

/// Instructions in their order of execution.
#[derive(Clone, Debug)]
pub(super) struct Code<I> {
    /// Each kind with the number of lines that it goes on for.
    runs: Vec<(Kind, usize)>,
    lines: Vec<Line<I>>,
}

/// Slots and the code that works on them. Few slots are addressed with 16 bits in an array of
/// exactly as many, where no address can be wrong.
#[derive(Clone, Debug)]
pub(super) enum Machine {
    Small(Box<[u64; 1 << 16]>, Code<u16>),
    Large(Vec<u64>, Code<u32>),
}

impl Machine {
    /// Arranges instructions. The one at index `i` writes the slot `first + i`; it reads slots
    /// before its own.
    pub(super) fn new(first: Slot, instructions: &[Instruction]) -> Machine {
        let order = schedule(first, instructions);
        let slots = first as usize + instructions.len();
        match u16::try_from(slots) {
            Ok(_) => {
                let array = vec![0; 1 << 16].into_boxed_slice();
                let array = array.try_into().expect("it has the length of the array");
                let index = |slot: Slot| slot as u16;
                Machine::Small(array, Code::new(first, instructions, &order, index))
            }
            Err(_) => {
                Machine::Large(vec![0; slots], Code::new(first, instructions, &order, |slot| slot))
            }
        }
    }

    pub(super) fn get(&self, slot: Slot) -> u64 {
        match self {
            Machine::Small(slots, _) => slots[slot as usize],
            Machine::Large(slots, _) => slots[slot as usize],
        }
    }

    pub(super) fn set(&mut self, slot: Slot, value: u64) {
        match self {
            Machine::Small(slots, _) => slots[slot as usize] = value,
            Machine::Large(slots, _) => slots[slot as usize] = value,
        }
    }

    /// Copies slots, all of them at once.
    pub(super) fn copy(&mut self, copies: &Copies) {
        match self {
            Machine::Small(slots, _) => copies.run(&mut slots[..]),
            Machine::Large(slots, _) => copies.run(slots),
        }
    }

    /// Executes every instruction once.
    pub(super) fn run(&mut self) {
        match self {
            Machine::Small(slots, code) => execute(code, slots.as_mut()),
            Machine::Large(slots, code) => execute(code, slots),
        }
    }
}

/// Something that slots are kept in.
trait Slots {
    type Index: Copy;

    fn read(&self, slot: Self::Index) -> u64;
    fn write(&mut self, slot: Self::Index, value: u64);
}

impl Slots for [u64; 1 << 16] {
    type Index = u16;

    fn read(&self, slot: u16) -> u64 {
        self[usize::from(slot)]
    }

    fn write(&mut self, slot: u16, value: u64) {
        self[usize::from(slot)] = value;
    }
}

impl Slots for Vec<u64> {
    type Index = u32;

    fn read(&self, slot: u32) -> u64 {
        self[slot as usize]
    }

    fn write(&mut self, slot: u32, value: u64) {
        self[slot as usize] = value;
    }
}

fn execute<S: Slots>(code: &Code<S::Index>, slots: &mut S) {
    let mut rest = &code.lines[..];
    for &(kind, length) in &code.runs {
        let (run, behind) = rest.split_at(length);
        rest = behind;
        match kind {
            Kind::And => each(run, slots, |a, b, _| a & b),
            Kind::And3 => each(run, slots, |a, b, c| a & b & c),
            Kind::AndNot => each(run, slots, |a, b, _| a & !b),
            Kind::Or => each(run, slots, |a, b, _| a | b),
            Kind::Or3 => each(run, slots, |a, b, c| a | b | c),
            Kind::Xor => each(run, slots, |a, b, _| a ^ b),
            Kind::Mux => each(run, slots, |a, b, c| c ^ (a & (b ^ c))),
            Kind::Add => each(run, slots, |a, b, c| a.wrapping_add(b) & c),
            Kind::Sub => each(run, slots, |a, b, c| a.wrapping_sub(b) & c),
            Kind::Mul => each(run, slots, |a, b, c| a.wrapping_mul(b) & c),
            Kind::Div => each(run, slots, |a, b, _| a.checked_div(b).unwrap_or(0)),
            Kind::Rem => each(run, slots, |a, b, _| a.checked_rem(b).unwrap_or(0)),
            Kind::Join => each(run, slots, |a, b, c| a << (c & 63) | b),
            Kind::Eq => each(run, slots, |a, b, _| all_ones(a == b)),
            Kind::Less => each(run, slots, |a, b, _| all_ones(a < b)),
            Kind::Shift => each(run, slots, |a, b, c| a >> (b & 63) & c),
            Kind::Bit => each(run, slots, |a, b, _| all_ones(a >> (b & 63) & 1 == 1)),
        }
    }
}

#[inline(always)]
fn each<S: Slots>(run: &[Line<S::Index>], slots: &mut S, f: impl Fn(u64, u64, u64) -> u64) {
    for &Line { from: [a, b, c], to } in run {
        let value = f(slots.read(a), slots.read(b), slots.read(c));
        slots.write(to, value);
    }
}

fn all_ones(condition: bool) -> u64 {
    u64::from(condition).wrapping_neg()
}

impl<I: Copy> Code<I> {
    fn new(
        first: Slot,
        instructions: &[Instruction],
        order: &[usize],
        index: impl Fn(Slot) -> I,
    ) -> Code<I> {
        let mut code = Code { runs: Vec::new(), lines: Vec::with_capacity(order.len()) };
        for &at in order {
            let Instruction { kind, from } = instructions[at];
            match code.runs.last_mut() {
                Some((last, length)) if *last == kind => *length += 1,
                _ => code.runs.push((kind, 1)),
            }
            code.lines.push(Line { from: from.map(&index), to: index(first + at as Slot) });
        }
        code
    }
}

/// An order in which every instruction stands behind those that it reads, with long runs of one
/// kind: all that is ready of the kind of which most is ready, again and again.
fn schedule(first: Slot, instructions: &[Instruction]) -> Vec<usize> {
    let mut waits_for = vec![0_u32; instructions.len()];
    let mut readers: Vec<Vec<u32>> = vec![Vec::new(); instructions.len()];
    for (at, Instruction { from, .. }) in instructions.iter().enumerate() {
        for slot in from {
            if let Some(read) = slot.checked_sub(first) {
                debug_assert!((read as usize) < at, "an instruction reads what is before it");
                readers[read as usize].push(at as u32);
                waits_for[at] += 1;
            }
        }
    }
    let mut ready: [Vec<usize>; Kind::ALL.len()] = Default::default();
    for (at, instruction) in instructions.iter().enumerate() {
        if waits_for[at] == 0 {
            ready[instruction.kind as usize].push(at);
        }
    }
    let mut order = Vec::with_capacity(instructions.len());
    loop {
        let most = Kind::ALL.into_iter().max_by_key(|&kind| ready[kind as usize].len());
        let kind = most.expect("there are kinds") as usize;
        if ready[kind].is_empty() {
            return order;
        }
        let mut next = 0;
        while let Some(&at) = ready[kind].get(next) {
            next += 1;
            order.push(at);
            for &reader in &readers[at] {
                waits_for[reader as usize] -= 1;
                if waits_for[reader as usize] == 0 {
                    let reader = reader as usize;
                    ready[instructions[reader].kind as usize].push(reader);
                }
            }
        }
        ready[kind].clear();
    }
}

/// Copies between slots that all happen at once.
#[derive(Clone, Debug, Default)]
pub(super) struct Copies {
    /// From a slot that no copy writes.
    plain: Vec<(Slot, Slot)>,
    /// From a slot that another copy may write.
    crossing: Vec<(Slot, Slot)>,
}

impl Copies {
    /// Copies from the first to the second of each pair; `is_target` tells which slots are written.
    pub(super) fn new(
        pairs: impl Iterator<Item = (Slot, Slot)>,
        is_target: impl Fn(Slot) -> bool,
    ) -> Copies {
        let (crossing, plain) = pairs.partition(|&(from, _)| is_target(from));
        Copies { plain, crossing }
    }

    fn run(&self, slots: &mut [u64]) {
        let crossing: Vec<u64> =
            self.crossing.iter().map(|&(from, _)| slots[from as usize]).collect();
        for &(from, to) in &self.plain {
            slots[to as usize] = slots[from as usize];
        }
        for (&(_, to), value) in self.crossing.iter().zip(crossing) {
            slots[to as usize] = value;
        }
    }
}
