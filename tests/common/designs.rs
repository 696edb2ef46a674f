//! Designs made by hand, to try the back ends on.

use hotrail::blocks::{self, Shape};
use hotrail::circuit::{Circuit, Design, Net, Signal, Valid, Version};

/// Gives a net a name.
pub fn name(circuit: &mut Circuit, net: Net, name: &str, version: Version, section: usize) {
    circuit.signals.push(Signal { net, name: name.into(), version, section });
}

/// A design of a single circuit.
pub fn single(circuit: Circuit) -> Valid<Design> {
    let mut design = Design::default();
    design.modules.alloc(circuit);
    design.validate().expect("the test's design is valid")
}

/// A motor with seal-in, and a lamp that follows five seconds later.
pub fn start_stop() -> Valid<Design> {
    let mut design = Design::default();
    let ton = design.modules.alloc(blocks::module(&Shape::plain(blocks::ALL[0]), &[0; 4]));
    let mut top = Circuit::new("start_stop");
    top.comment.push("Start and stop, and a lamp.".to_owned());
    let tick = top.input("tick", 1);
    let (start, stop) = (top.input("start", 1), top.input("stop", 1));
    let (motor, was_on) = top.register("motor", 1, 0);
    let (lamp, lamp_was) = top.register("lamp", 1, 0);

    top.section("rung 1 \"seal-in\" (start_stop.ladder:7)", 1);
    let either = top.or([start, was_on]);
    let running = top.not(stop);
    let motor_next = top.and([either, running]);
    top.drive(motor, motor_next);
    name(&mut top, motor_next, "motor", Version::Last, 0);

    top.section("rung 2 \"lamp after five seconds\" (start_stop.ladder:11)", 2);
    let delay = top.instance("delay", ton);
    let (preset, off) = (top.constant(5000, 32), top.bit(false));
    top.instances[delay].inputs = vec![tick, motor_next, preset, off, off];
    let q = top.port(delay, 0, 1);
    name(&mut top, q, "lamp", Version::Last, 1);
    top.drive(lamp, q);

    top.output("motor", was_on);
    top.output("lamp", lamp_was);
    design.modules.alloc(top);
    design.validate().expect("the test's design is valid")
}

/// A circuit of operations on words and bits of several widths, without instances.
pub fn random(seed: u64) -> Valid<Design> {
    random_of(seed, false)
}

/// The same with products and quotients, which a solver cannot prove equal bit by bit.
pub fn random_with_products(seed: u64) -> Valid<Design> {
    random_of(seed, true)
}

fn random_of(seed: u64, has_products: bool) -> Valid<Design> {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut circuit = Circuit::new(format!("random_{seed}"));
    let widths = [1, 1, 2, 7, 16, 32, 33, 64];
    let mut nets = vec![circuit.input("tick", 1)];
    for index in 0..6 {
        nets.push(circuit.input(format!("in{index}"), widths[random.usize(..widths.len())]));
    }
    let mut registers = Vec::new();
    for index in 0..8 {
        let width = widths[random.usize(..widths.len())];
        let (id, net) = circuit.register(format!("r{index}"), width, random.u64(..));
        registers.push(id);
        nets.push(net);
    }
    for step in 0..80 {
        if step % 8 == 0 {
            let rung = step / 8 + 1;
            circuit.section(format!("rung {rung}"), rung);
        }
        let net = random_cell(&mut circuit, &mut random, &nets, has_products);
        if random.u32(..10) == 0 {
            let version = if random.bool() { Version::Last } else { Version::Rung(step / 8 + 1) };
            let name = format!("s{}", random.u32(..20));
            circuit.signals.push(Signal {
                net,
                name: name.into(),
                version,
                section: step as usize / 8,
            });
        }
        nets.push(net);
    }
    for id in registers {
        let next = of_width(&mut circuit, &mut random, &nets, None);
        let width = circuit.registers[id].width;
        let next = circuit.resize(next, width, random.bool());
        circuit.drive(id, next);
        if random.bool() {
            let enable = of_width(&mut circuit, &mut random, &nets, Some(1));
            circuit.drive_where(enable, id, next);
        }
    }
    for index in 0..8 {
        let net = of_width(&mut circuit, &mut random, &nets, None);
        circuit.output(format!("r{}", index * 3), net);
    }
    single(circuit)
}

fn of_width(
    circuit: &mut Circuit,
    random: &mut fastrand::Rng,
    nets: &[Net],
    width: Option<u32>,
) -> Net {
    // The newest are the most likely, so that expressions become deep.
    let back = random.usize(..nets.len()).min(random.usize(..nets.len()));
    let net = nets[nets.len() - 1 - back];
    let Some(width) = width else { return net };
    match random.u32(..8) {
        0 => {
            let value = random.u64(..) >> random.u32(..64);
            circuit.constant(value, width)
        }
        1 => circuit.constant(random.u64(..), width),
        _ => circuit.resize(net, width, random.bool()),
    }
}

fn random_cell(
    circuit: &mut Circuit,
    random: &mut fastrand::Rng,
    nets: &[Net],
    has_products: bool,
) -> Net {
    let a = of_width(circuit, random, nets, None);
    let width = circuit.width(a);
    let mut other = |circuit: &mut Circuit, width| of_width(circuit, random, nets, Some(width));
    let (b, c, select) = (other(circuit, width), other(circuit, width), other(circuit, 1));
    match random.u32(..17) {
        0 => circuit.not(a),
        1 | 2 => circuit.and([a, b, c]),
        3 | 4 => circuit.or([b, a]),
        5 => circuit.xor(a, b),
        6 => circuit.mux(select, b, a),
        7 => circuit.add(a, b),
        8 => circuit.sub(b, a),
        9 => {
            let equal = circuit.eq(a, b);
            if random.bool() { circuit.not(equal) } else { equal }
        }
        10 => {
            let less = circuit.less(a, b, random.bool());
            if random.bool() { circuit.not(less) } else { less }
        }
        11 if has_products => circuit.mul(a, b),
        12 if has_products => circuit.div(a, b),
        13 if has_products => circuit.rem(b, a),
        14 if width < 32 => circuit.concat([a, select, b]),
        15 => circuit.with_bit(a, random.u32(..width), select),
        _ => {
            let low = random.u32(..width);
            circuit.slice(a, low, random.u32(1..=width - low))
        }
    }
}

/// A timer of three ticks, bare.
pub fn timer() -> Valid<Design> {
    let mut design = Design::default();
    let ton = design.modules.alloc(blocks::module(&Shape::plain(blocks::ALL[0]), &[0; 4]));
    let mut top = Circuit::new("timer");
    let (tick, power) = (top.input("tick", 1), top.input("IN", 1));
    let delay = top.instance("delay", ton);
    let (preset, off) = (top.constant(3, 32), top.bit(false));
    top.instances[delay].inputs = vec![tick, power, preset, off, off];
    let q = top.port(delay, 0, 1);
    top.output("Q", q);
    design.modules.alloc(top);
    design.validate().expect("the test's design is valid")
}

/// Counts ticks, and shows a button and a word one scan late.
pub fn echo() -> Valid<Design> {
    let mut circuit = Circuit::new("echo");
    let tick = circuit.input("tick", 1);
    let (button, word) = (circuit.input("button", 1), circuit.input("word", 4));
    let (ticks, count) = circuit.register("ticks", 8, 0);
    let one = circuit.resize(tick, 8, false);
    let next = circuit.add(count, one);
    circuit.drive(ticks, next);
    circuit.output("ticks", count);
    for (name, input) in [("light", button), ("shown", word)] {
        let (id, net) = circuit.register(name, circuit.width(input), 0);
        circuit.drive(id, input);
        circuit.output(name, net);
    }
    single(circuit)
}

/// A program whose author means no good.
pub fn hostile() -> Valid<Design> {
    let mut circuit = Circuit::new("module");
    circuit.comment.push("verilator lint_off WIDTH\nendmodule */ -- \\".to_owned());
    let mut nets = vec![circuit.input("tick", 1)];
    for name in
        ["clk", "CLK", "rst", "rst_n", "Tick", "out", "wire", "_a__b_", "a b", "1", "ü", "auto"]
    {
        nets.push(circuit.input(name, 1));
    }
    circuit.section("rung 1 \"x\nassign y = 0;\u{2028}\u{202e}\" \\", 1);
    let all = circuit.and(nets);
    let (id, was) = circuit.register("module_u", 1, 0);
    circuit.drive(id, all);
    name(&mut circuit, all, "module_u", Version::Last, 0);
    circuit.output("std_logic", was);
    circuit.output("a_b_2", all);
    single(circuit)
}

/// Two timers that start each other: the first reads what the second showed a scan ago.
pub fn blinker() -> Valid<Design> {
    let mut design = Design::default();
    let ton = design.modules.alloc(blocks::module(&Shape::plain(blocks::ALL[0]), &[0; 4]));
    let mut top = Circuit::new("blinker");
    let (tick, run) = (top.input("tick", 1), top.input("run", 1));
    let (preset, none) = (top.constant(2, 32), top.bit(false));
    let (lamp, lamp_was) = top.register("lamp", 1, 0);

    top.section("rung 1", 1);
    let pause = top.instance("pause", ton);
    let flash = top.instance("flash", ton);
    let flashed = top.port(flash, 1, 1);
    let dark = top.not(flashed);
    let power = top.and([run, dark]);
    let (q, elapsed) = (top.port(pause, 0, 1), top.port(pause, 2, 32));
    let bit = top.slice(elapsed, 0, 1);

    top.section("rung 2", 2);
    top.instances[pause].inputs = vec![tick, power, preset, none, none];
    top.instances[flash].inputs = vec![tick, q, preset, none, bit];
    top.drive(lamp, q);
    name(&mut top, q, "lamp", Version::Last, 1);
    name(&mut top, q, "beacon", Version::Rung(2), 1);
    top.output("lamp", lamp_was);
    design.modules.alloc(top);
    design.validate().expect("the test's design is valid")
}
