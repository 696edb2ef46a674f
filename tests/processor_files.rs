//! Images as files: every form comes back, what is damaged is refused, and an image draws the
//! ladder that it came from.

mod common;

use std::fs;
use std::path::Path;
use std::process::Command;

use common::relay;
use hotrail::backend::processor::{self, Form, Image, Memory, NotDrawn, Parameters, Part, Rom};
use hotrail::diagnostic;
use hotrail::source::Source;

fn image(text: &str) -> Image {
    let source = Source::new("test.ladder", text);
    let (program, findings) = hotrail::analyze(&source);
    let texts: String = findings.iter().map(|f| diagnostic::render(f, &source, false)).collect();
    let program = program.unwrap_or_else(|| panic!("{text}\n{texts}"));
    processor::compile(&program).unwrap_or_else(|findings| {
        let texts = findings.iter().map(|found| diagnostic::render(found, &source, false));
        panic!("{}", texts.collect::<String>())
    })
}

#[test]
fn every_form_comes_back() {
    for seed in 0..30 {
        let (program, _) = hotrail::analyze(&Source::new("test.ladder", relay::program(seed)));
        let Ok(image) = processor::compile(&program.unwrap()) else { continue };
        let comments = [Parameters::of(&image.rom).to_string()];
        let parameters = Parameters::read(&comments[0]).unwrap();
        for form in Form::ALL {
            let read = Part::ALL.map(|part| {
                let bytes = image.rom.memory(part).write(form, &comments);
                part.read(form, &bytes, parameters.sizes)
                    .unwrap_or_else(|wrong| panic!("{form:?}: {wrong:?}"))
            });
            let [code, registers, bits] = &read;
            let back = Rom::of_memories(code, registers, bits, &parameters);
            assert_eq!(back, image.rom, "{form:?}, seed {seed}");
        }
    }
}

fn refused(form: Form, text: &str) -> String {
    match Memory::read(form, text.as_bytes(), 16, 1024) {
        Ok(memory) => panic!("{text:?} is read as {memory:?}"),
        Err(wrong) => {
            let line = wrong.line.map(|line| format!("line {line}: ")).unwrap_or_default();
            line + &wrong.problem
        }
    }
}

#[test]
fn damaged_files_are_refused_with_their_line() {
    for (form, text, words) in [
        (Form::Hex, "1809\nxyz\n", "line 2: `xyz` is no number"),
        (Form::Hex, "12345\n", "no number of 16 bits"),
        (Form::Hex, "@400\n1809\n", "line 2: the address 400 is outside"),
        (Form::Hex, "@0\n1809\n@0\n1809\n", "line 4: the address 0 stands there twice"),
        (Form::IntelHex, "1809\n", "begins with a colon"),
        (Form::IntelHex, ":0200000009180000\n", "the checksum is wrong"),
        (Form::IntelHex, ":020000000918DD\n", "the last record is missing"),
        (Form::IntelHex, ":03000000091800DC\n:00000001FF\n", "half a word"),
        (Form::IntelHex, ":0200000009\n", "the checksum is wrong"),
        (Form::IntelHex, ":00000001FF\n:020000000918DD\n", "follows the last one"),
        (Form::Coe, "memory_initialization_vector=\n1809;\n", "outside of the vector"),
        (
            Form::Coe,
            "memory_initialization_radix=16;\nmemory_initialization_vector=\n1809,\n",
            "the semicolon",
        ),
        (
            Form::Coe,
            "memory_initialization_radix=16;\nmemory_initialization_vector=1;2;\n3;",
            "line 3: a word stands outside",
        ),
        (Form::Coe, "memory_initialization_radix=7;\n", "the radix `7`"),
        (Form::Mif, "WIDTH=16;\nCONTENT BEGIN\n0 : 1809;\n", "END is missing"),
        (Form::Mif, "CONTENT BEGIN\n0 1809;\nEND;\n", "an address and a word"),
        (Form::Mif, "WIDTH=8;\nCONTENT BEGIN\nEND;\n", "line 1: a word of this memory has 16 bits"),
        (Form::Mif, "DEPTH=2048;\nCONTENT BEGIN\nEND;\n", "line 1: this memory has 1024 words"),
        (Form::Mif, "DEPTH=4;\nCONTENT BEGIN\n4 : 1;\nEND;\n", "outside of 4 words"),
        (Form::Binary, "abc", "half a word"),
    ] {
        let found = refused(form, text);
        assert!(found.contains(words), "{text:?}: {found}");
    }
    assert!(Memory::read(Form::Binary, &[0; 2050], 16, 1024).is_err());
    let damaged = |bytes: &[u8]| Form::ALL.map(|form| Memory::read(form, bytes, 16, 1024).is_ok());
    let mut random = fastrand::Rng::with_seed(4);
    for _ in 0..2000 {
        let bytes: Vec<u8> = (0..random.usize(..60))
            .map(|_| {
                *[b':', b'0', b'1', b'F', b'@', b'\n', b' ', b';', b'=', b'-', 200][..]
                    .choose(&mut random)
            })
            .collect();
        damaged(&bytes);
    }
}

trait Choose {
    fn choose(&self, random: &mut fastrand::Rng) -> &u8;
}

impl Choose for [u8] {
    fn choose(&self, random: &mut fastrand::Rng) -> &u8 {
        &self[random.usize(..self.len())]
    }
}

/// What is wrong with these words, one by one.
fn faults(words: &[u16]) -> Vec<String> {
    let rom = Rom { code: words.to_vec(), ..Rom::default() };
    rom.faults().iter().map(|fault| format!("{}: {}", fault.at, fault.kind)).collect()
}

#[test]
fn images_that_cannot_run_are_told_apart() {
    const END: u16 = 0xBC00;
    assert_eq!(faults(&[0x1809, 0x1002, 0xA53C, END]), [""; 0]);
    assert_eq!(faults(&[0x0009, END]), ["0: no attribute has the code 0000"]);
    assert_eq!(faults(&[0x2409, END]), ["0: no attribute has the code 1001"]);
    assert_eq!(faults(&[0xB400, END]), ["0: no operation has the code 1101"]);
    assert_eq!(faults(&[0xD800, END]), ["0: no prefix has the code 0110"]);
    assert_eq!(faults(&[0x1001, END]), ["0: a bit is taken from the empty stack 2"]);
    assert_eq!(faults(&[0x0C01, END]), ["0: a bit is taken from the empty stack 1"]);
    let deep = [0x0801, 0x0801, 0x0801, 0x0801, 0x0801, END];
    assert_eq!(faults(&deep), ["4: stack 1 would hold more than 4 bits"]);
    assert_eq!(faults(&[0x0401, 0xA405, END]), ["1: 5 is an input"]);
    assert_eq!(faults(&[0x0401, 0xA7FF, END]), ["1: flag 1023 is the constant 1"]);
    assert_eq!(faults(&[0x0401, 0x8100, END]), ["1: the prefix REGISTER is missing"]);
    assert_eq!(faults(&[0x0401, 0xD000, 0x8100, END]), ["2: the prefix UNIT is missing"]);
    let twice = [0x0401, 0xC800, 0xD000, 0x8100, 0x0401, 0xC800, 0xD000, 0x8900, END];
    assert_eq!(faults(&twice), ["7: unit 0 is used by two functions"]);
    assert_eq!(faults(&[0x0401]), ["1: no word ends the scan"]);
    assert_eq!(faults(&[END, 0x0401]), ["1: words follow the end of the scan"]);
    let long: Vec<u16> = [vec![0x0401; 1024], vec![END]].concat();
    assert_eq!(faults(&long), ["1024: the code memory has 1024 words"]);
}

#[test]
fn an_image_draws_the_ladder_that_it_came_from() {
    for seed in 0..300 {
        let image = image(&relay::plain_program(seed));
        let text = processor::ladder(&image.rom, "again").expect("it can be drawn");
        assert_eq!(self::image(&text).rom, image.rom, "seed {seed}:\n{text}");
    }
}

/// A tick that is shorter than a clock where no clock is named.
#[test]
fn a_tick_of_nanoseconds_is_drawn_with_a_clock() {
    for tick_ns in [1, 2, 7, 83, 84, 1_000_000, 3_600_000_000_000] {
        let rom = Rom { code: vec![0x0401, 0xA500, 0xBC00], tick_ns, ..Rom::default() };
        let text = processor::ladder(&rom, "again").unwrap();
        assert_eq!(image(&text).rom.tick_ns, tick_ns, "{text}");
        assert_eq!(text.contains("clock"), tick_ns < 84, "{text}");
    }
}

/// The same ladder in other words, and words that no ladder draws.
#[test]
fn what_no_ladder_draws_is_told() {
    const END: u16 = 0xBC00;
    let ladder = |code: &[u16]| {
        let rom = Rom { code: [code, &[END]].concat(), ..Rom::default() };
        assert_eq!(rom.faults(), [], "{code:x?}");
        processor::ladder(&rom, "again").map_err(|not_drawn| not_drawn.to_string())
    };
    assert!(ladder(&[0x0801, 0x0402, 0xA500]).unwrap().ends_with("rung X1 X2 ( Y256 )\n"));
    for (code, told) in [
        (&[0xA500][..], "no contact stands before word 000, an output"),
        (&[0x0401], "the circuit from word 000 on has no output"),
        (&[0x0401, 0xA500, 0x0402, 0xD000, 0xCC00, 0x9100], "word 003 belongs to a function"),
    ] {
        assert_eq!(ladder(code), Err(told.to_owned()));
    }
    let rom = Rom { code: vec![0x0401, 0xA500, END], ..Rom::default() };
    let registers = [(2046, 1)].into_iter().collect();
    let told = processor::ladder(&Rom { registers, ..rom.clone() }, "again");
    assert_eq!(told, Err(NotDrawn::Register(2046)));
    let image = [3].into_iter().collect();
    assert_eq!(processor::ladder(&Rom { image, ..rom }, "again"), Err(NotDrawn::Input(3)));
}

/// The lines in front of an image are read, those of a record for forms without comments.
#[test]
fn the_record_beside_an_image_counts() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let ladder = "ladder slow tick 100ms input a, b, c output x, y rung a t:TT(PV := 5, EN := b) (y) rung c (x)";
    fs::write(path.join("slow.ladder"), ladder).unwrap();
    let build = ["build", "slow.ladder", "-o", "out", "--emit", "rom,ihex,bin"];
    assert_eq!(hotrail(path, &build), (0, String::new()));
    let shown = hotrail(path, &["rom", "out/slow.hex"]);
    assert!(shown.1.contains("3 inputs, 2 outputs, a tick of 100ms"), "{}", shown.1);
    for form in ["ihex", "bin"] {
        assert_eq!(hotrail(path, &["rom", &format!("out/slow.{form}")]), shown, "{form}");
    }
    let change = |name: &str, from: &str, to: &str| {
        let file = path.join("out").join(name);
        let text = fs::read_to_string(&file).unwrap();
        assert!(text.contains(from), "{text}");
        fs::write(file, text.replacen(from, to, 1)).unwrap();
    };
    // The preset, and the record itself.
    change("slow_regs.bin", "\u{5}", "\u{6}");
    let (code, text) = hotrail(path, &["rom", "out/slow.bin"]);
    assert!(code == 1 && text.contains("slow_regs.bin: its checksum"), "{text}");
    change("slow_ihex.txt", "TICK_NS 100000000", "TICK_NS 0");
    let (code, text) = hotrail(path, &["rom", "out/slow.ihex"]);
    assert!(
        code == 1 && text.contains("slow_ihex.txt: the first lines tell of `TICK_NS 0`"),
        "{text}"
    );
    // The longest tick is an hour.
    change("slow_ihex.txt", "TICK_NS 0", "TICK_NS 3600000000001");
    let (code, text) = hotrail(path, &["rom", "out/slow.ihex"]);
    assert!(code == 1 && text.contains("`TICK_NS 3600000000001`, which no processor"), "{text}");
    change("slow.hex", "OUTPUTS 2", "OUTPUTS 300");
    let (code, text) = hotrail(path, &["rom", "out/slow.hex"]);
    assert!(code == 1 && text.contains("`OUTPUTS 300`, which no processor has"), "{text}");
}

fn hotrail(folder: &Path, arguments: &[&str]) -> (i32, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_hotrail"));
    let output = command.args(arguments).current_dir(folder).output().unwrap();
    let text = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    (output.status.code().unwrap(), text)
}

#[test]
fn users_build_images_and_look_at_them() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let ladder = "ladder pump  input start, stop  output motor := 1  var used at 600
        rung \"seal-in\" [ start | motor ] !stop ( motor )  rung start (S used)
        rung used stop (R used)
        test \"runs\" pulse start  expect motor used";
    fs::write(path.join("pump.ladder"), ladder).unwrap();
    let emit = "rom,ihex,coe,mif,bin,listing";
    let (code, text) = hotrail(path, &["build", "pump.ladder", "-o", "out", "--emit", emit]);
    assert_eq!((code, text.as_str()), (0, ""));
    assert_eq!(fs::read_dir(path.join("out")).unwrap().count(), 5 * 3 + 2 + 1);
    let listing = fs::read_to_string(path.join("out/pump.lst")).unwrap();
    for words in ["rung 1 \"seal-in\", pump.ladder:2", "OPEN/RETURN", "256  motor", "600  used"] {
        assert!(listing.contains(words), "{listing}");
    }
    let first = hotrail(path, &["rom", "out/pump.hex", "--as", "ladder"]);
    assert!(first.0 == 0 && first.1.contains("output Y256 at 256 := 1"), "{}", first.1);
    for form in ["ihex", "coe", "mif", "bin"] {
        let (code, text) = hotrail(path, &["rom", &format!("out/pump.{form}"), "--as", "ladder"]);
        assert_eq!((code, text), first, "{form}");
    }
    fs::write(path.join("open.hex"), "0801 0402 A500 BC00\n").unwrap();
    let (code, text) = hotrail(path, &["rom", "open.hex", "--as", "ladder"]);
    assert!(code == 0 && text.contains("rung X1 X2 ( Y256 )"), "{text}");
    assert!(text.contains("note: open.hex: built again, this ladder has other words"), "{text}");
    let (code, text) = hotrail(path, &["test", "pump.ladder", "--on", "evaluator,processor"]);
    assert!(code == 0 && text.contains("on processor"), "{text}");
    fs::write(path.join("out/pump.hex"), "0102\nBC00\n").unwrap();
    let (code, text) = hotrail(path, &["rom", "out/pump.hex"]);
    assert!(code == 1 && text.contains("E0803") && text.contains("word 000 (0102)"), "{text}");
}

#[test]
fn a_build_replaces_its_own_images_in_every_form_and_no_others() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let build = |text: &str, emit: &str| {
        fs::write(path.join("pump.ladder"), text).unwrap();
        hotrail(path, &["build", "pump.ladder", "-o", "out", "--emit", emit])
    };
    let emit = "rom,ihex,coe,mif,bin,listing";
    let first = "ladder pump input a, b output y rung [ a | a b ] (y)";
    let second = "ladder pump input a, b output y rung b [ a | b ] (y)";
    assert_eq!(build(first, emit), (0, String::new()));
    assert_eq!(build(first, "bin"), (0, String::new()));
    assert_eq!(build(second, emit), (0, String::new()));
    let rebuilt = fs::read(path.join("out/pump.bin")).unwrap();
    assert_eq!(rebuilt[..2], [0x01, 0x04], "the second program");
    // Changed by somebody, or there without a record.
    for (file, changed) in
        [("pump.bin", "x"), ("pump_regs.ihex", ":00000001FF"), ("pump.ihex", "a")]
    {
        let file = path.join("out").join(file);
        let ours = fs::read(&file).unwrap();
        fs::write(&file, changed).unwrap();
        let (code, text) = build(first, emit);
        assert!(code != 0 && text.contains("was not made by hotrail"), "{text}");
        fs::write(&file, ours).unwrap();
    }
    assert_eq!(build(first, emit), (0, String::new()));
    fs::remove_file(path.join("out/pump_bin.txt")).unwrap();
    let (code, text) = build(second, "bin");
    assert!(code != 0 && text.contains("was not made by hotrail"), "{text}");
}

/// A bit, a register and the constant 1 stand in other places of the files.
#[test]
fn an_image_for_a_small_machine_comes_back() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let ladder = "ladder small input a output y var kept := 1 var word : WORD := 16#8001
        rung a n:UC(PV := 2, EN := a) [ kept | word.15 ] ( y )";
    fs::write(path.join("small.ladder"), ladder).unwrap();
    let build = |sizes: &str| {
        let emit = "rom,bin,listing";
        let options = ["build", "small.ladder", "-o", "out", "--emit", emit, "--processor", sizes];
        hotrail(path, &options)
    };
    let sizes = "CODE_WORDS=16,IMAGE_BITS=16,REGISTERS=8,STACK_DEPTH=2";
    assert_eq!(build(sizes), (0, String::new()));
    let file = |name: &str| fs::read_to_string(path.join("out").join(name)).unwrap();
    let head = "INPUTS 1, OUTPUTS 1, TICK_NS 1000000, CODE_WORDS 16, IMAGE_BITS 16, REGISTERS 8, \
        STACK_DEPTH 2\n";
    let contents = |name: &str| file(name).split_once(head).expect("the sizes").1.to_owned();
    // `kept` is flag 512; the preset is register 0, the word register 1024.
    assert_eq!(contents("small_image.hex"), "@008\n1\n@00F\n1\n");
    assert_eq!(contents("small_regs.hex"), "@000\n0002\n@004\n8001\n");
    let listing = file("small.lst");
    assert!(
        listing.contains(
            "\nat least CODE_WORDS 15, IMAGE_BITS 8, REGISTERS 8, STACK_DEPTH 2, BITS, COUNTERS\n"
        ),
        "{listing}"
    );
    let (code, shown) = hotrail(path, &["rom", "out/small.hex"]);
    assert!(
        code == 0 && shown.contains(" 1024  32769\n") && shown.contains("  512  flag"),
        "{shown}"
    );
    assert_eq!(hotrail(path, &["rom", "out/small.bin", "--processor", sizes]).1, shown);
    for (sizes, told) in [
        ("CODE_WORDS=14", "the program needs 15 words, the ladder processor has 14"),
        ("CODE_WORDS=14", "give the processor more with --processor"),
        ("IMAGE_BITS=4", "IMAGE_BITS is 8 to 1024"),
        ("REGISTERS=2048", "REGISTERS is 8 to 2047"),
        ("WORDS=13", "none of the sizes CODE_WORDS, IMAGE_BITS, REGISTERS, STACK_DEPTH"),
    ] {
        let (code, text) = build(sizes);
        assert!(code != 0 && text.contains(told), "{sizes}: {text}");
    }
}

#[test]
fn what_the_processor_cannot_do_is_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path();
    let ladder = "ladder level  input n : INT  output y  rung { n > 3 } ( y )
        test \"high\" n := 4  scan  expect y";
    fs::write(path.join("level.ladder"), ladder).unwrap();
    let (code, text) =
        hotrail(path, &["build", "level.ladder", "-o", "out", "--emit", "rom,verilog"]);
    assert!(code == 1 && text.contains("E0801") && text.contains("level.ladder:1"), "{text}");
    assert!(!path.join("out").exists());
    let (code, text) = hotrail(path, &["test", "level.ladder", "--on", "processor"]);
    assert!(code == 1 && text.contains("E0801"), "{text}");
}
