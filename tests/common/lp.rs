//! What the ladder processor's hardware is driven with, and what it should show, by the emulator.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use fastrand::Rng;
use hotrail::backend::processor::{
    self, Form, Image, Machine, Parameters, Part, Sizes, clocks_of_scan,
};
use hotrail::model::{Program, Role};
use hotrail::source::Source;

use super::emulated::compile;
use super::relay;

/// The registers that are compared: presets, counts, and the first words.
const REGISTERS: u16 = 660;

/// Those of so many random programs that the processor can do, with their images and what to drive
/// them with.
pub fn random_programs(count: u64) -> impl Iterator<Item = (String, Program, Image, Rng)> {
    (0..count).filter_map(|seed| {
        let (program, image) = compile(&relay::program(seed)).ok()?;
        Some((format!("seed {seed}"), program, image, Rng::with_seed(seed)))
    })
}

/// The examples that it can do, in the same way.
///
/// # Panics
/// If there are hardly any.
pub fn examples() -> Vec<(String, Program, Image, Rng)> {
    let examples = super::examples().into_iter().filter_map(|example| {
        let (program, image) = compile(&fs::read_to_string(&example.ladder).unwrap()).ok()?;
        Some((example.name(), program, image, Rng::with_seed(1)))
    });
    let examples: Vec<_> = examples.collect();
    assert!(examples.len() > 5, "{} examples", examples.len());
    examples
}

/// The program and its image for a processor of these sizes, if it can do it.
fn image_for(text: &str, sizes: Sizes) -> Option<(Program, Image)> {
    let (program, _) = hotrail::analyze(&Source::new("test.ladder", text));
    let program = program?;
    processor::compile_for(&program, &[], sizes).ok().map(|image| (program, image))
}

/// The same for the smallest processor with stacks of so many bits.
pub fn smallest(text: &str, stack_depth: usize) -> Option<(Program, Image)> {
    let usual = Sizes { stack_depth, ..Sizes::default() };
    let needs = image_for(text, usual)?.1.needs();
    // Words have another place where there are few registers.
    let registers = (3..11).map(|bits| 1 << bits).chain([2047]);
    let sizes = |registers| Sizes { registers, stack_depth, ..needs };
    let found = registers.into_iter().find_map(|registers| image_for(text, sizes(registers)));
    Some(found.expect("what it needs is enough"))
}

/// The bits from the outputs on that the image has, and of its registers the first.
pub fn held(sizes: Sizes) -> (Vec<u16>, Vec<u16>) {
    let registers = (0..2047).filter(|register| sizes.has_register(*register));
    let bits = (256..1024).filter(|bit| sizes.has_bit(*bit)).collect();
    (bits, registers.take(REGISTERS.into()).collect())
}

/// Ticks in a tenth of a second and in a second; 0 where a tick does not divide it.
pub fn ticks(image: &Image) -> [u64; 2] {
    let tick = image.rom.tick_ns;
    [100_000_000, 1_000_000_000].map(|unit| if unit % tick == 0 { unit / tick } else { 0 })
}

/// One scan: inputs, tick, and registers that the host writes before it.
pub struct Row {
    /// In the order of their addresses.
    pub inputs: Vec<bool>,
    /// Whether it has the tick.
    pub tick: bool,
    /// Registers and words.
    pub written: Vec<(u16, u16)>,
}

impl Row {
    /// The inputs as digits, the highest address first; `0` if there are none.
    pub fn digits(&self) -> String {
        let digits: String =
            self.inputs.iter().rev().map(|&on| if on { '1' } else { '0' }).collect();
        if digits.is_empty() { "0".to_owned() } else { digits }
    }
}

/// Random scans.
pub fn rows(program: &Program, image: &Image, scans: usize, mut random: Rng) -> Vec<Row> {
    let inputs: Vec<u16> = program
        .with_role(Role::Input)
        .filter_map(|(input, _)| image.layout.register(input))
        .collect();
    let row = |_| Row {
        inputs: (0..image.rom.pins.inputs).map(|_| random.bool()).collect(),
        tick: random.bool(),
        written: inputs
            .iter()
            .filter_map(|&register| {
                let word = [0, 1, 2, 5, 20_000, 0xFFFF][random.usize(..6)];
                (random.u8(..5) == 0).then_some((register, word))
            })
            .collect(),
    };
    (0..scans).map(row).collect()
}

/// Puts the image into a folder, as `test.hex` and what stands beside it.
pub fn write_image(folder: &Path, image: &Image) {
    let comments = ["a0 comment".to_owned(), Parameters::of(&image.rom).to_string()];
    for part in Part::ALL {
        let file = folder.join(format!("test{}.hex", part.suffix()));
        fs::write(file, image.rom.memory(part).write(Form::Hex, &comments)).unwrap();
    }
}

/// What a bench should print: the outputs at reset; then for each scan its clocks, the outputs, the
/// image from the outputs on, and the registers in hexadecimal.
pub fn meant(image: &Image, rows: &[Row]) -> Vec<String> {
    let mut machine = Machine::new(&image.rom).unwrap();
    let bit = |on: bool| if on { '1' } else { '0' };
    let outputs = |machine: &Machine<'_>| -> String {
        let all: Vec<bool> = machine.outputs().collect();
        all.into_iter().rev().map(bit).collect()
    };
    let (bits, registers) = held(image.rom.sizes);
    let mut lines = vec![format!("reset {}", outputs(&machine))];
    for row in rows {
        for &(register, word) in &row.written {
            machine.write_register(register, word);
        }
        (0..).zip(&row.inputs).for_each(|(input, &on)| machine.drive(input, on));
        machine.scan(row.tick);
        let mut line = format!("{} {} ", clocks_of_scan(&image.rom), outputs(&machine));
        line.extend(bits.iter().map(|&address| bit(machine.bit(address))));
        for &register in &registers {
            write!(line, " {:x}", machine.register(register)).unwrap();
        }
        lines.push(line);
    }
    lines
}

/// Panics where a bench has printed something else.
pub fn compare(name: &str, printed: &str, meant: &[String]) {
    let lines: Vec<&str> = printed.lines().filter(|line| !line.contains("$finish")).collect();
    for (scan, (shown, meant)) in lines.iter().zip(meant).enumerate() {
        assert_eq!(shown.trim_end(), meant.trim_end(), "{name}, line {scan} (0 is reset)");
    }
    assert_eq!(lines.len(), meant.len(), "{name}: {printed}");
}
