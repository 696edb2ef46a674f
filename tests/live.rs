//! `hotrail run`: what keys do, what is seen, what is written down, and that a terminal is left as
//! it was.

mod common;

#[cfg(target_os = "linux")]
use std::{
    io::{Read, Write},
    process::{Command, Stdio},
};

use common::folder::Folder;
use common::generate;
use fastrand::Rng;
use hotrail::draw::Glyphs;
use hotrail::eval::{Evaluator, Machine, Stimulus};
use hotrail::live::{Key, LEAST_COLUMNS, LEAST_ROWS, Live, Options, Session};
use hotrail::model::Program;
use hotrail::source::Source;
use ratatui_core::buffer::Buffer;
use ratatui_core::layout::Rect;
use ratatui_core::style::{Color, Modifier};

const SMALL: (u16, u16) = (80, 24);
const LOOKS: Options = Options { glyphs: Glyphs::Unicode, has_color: false };

const LIFT: &str = "ladder lift
    input up  input load : INT  input patience : TIME
    output motor  output weight : INT
    rung \"wait\" up delay:TON(PT := patience) ( motor )
    rung up { weight := load }
";

fn program(text: &str) -> (Source, Program) {
    let source = Source::new("live.ladder", text);
    let program = hotrail::analyze(&source).0.expect("the program is good");
    (source, program)
}

fn start_stop() -> (Source, Program) {
    program(&std::fs::read_to_string("examples/start_stop/start_stop.ladder").unwrap())
}

/// Presses keys: characters, and names in angle brackets.
fn press(live: &mut Live<'_>, keys: &str) {
    let mut rest = keys;
    while let Some(first) = rest.chars().next() {
        let named = rest.strip_prefix('<').and_then(|named| named.split_once('>'));
        let (key, behind) = match named {
            Some(("up", behind)) => (Key::Up, behind),
            Some(("down", behind)) => (Key::Down, behind),
            Some(("tab", behind)) => (Key::Tab, behind),
            Some(("enter", behind)) => (Key::Enter, behind),
            Some(("escape", behind)) => (Key::Escape, behind),
            Some(("backspace", behind)) => (Key::Backspace, behind),
            Some(("home", behind)) => (Key::Home, behind),
            Some(("end", behind)) => (Key::End, behind),
            Some(("pageup", behind)) => (Key::PageUp, behind),
            Some(("pagedown", behind)) => (Key::PageDown, behind),
            Some(("interrupt", behind)) => (Key::Interrupt, behind),
            _ => (Key::Char(first), &rest[first.len_utf8()..]),
        };
        live.key(key);
        rest = behind;
    }
}

fn screen(live: &Live<'_>, (columns, rows): (u16, u16)) -> Buffer {
    let mut screen = Buffer::empty(Rect::new(0, 0, columns, rows));
    live.draw(&mut screen);
    screen
}

/// The lines of a screen.
fn text(screen: &Buffer) -> String {
    let width = usize::from(screen.area.width);
    let lines = screen.content().chunks(width).map(|row| {
        row.iter().map(|cell| cell.symbol()).collect::<String>().trim_end().to_owned() + "\n"
    });
    lines.collect()
}

/// A screen as text, with another text behind it: `b` for bold, `r` for reversed.
fn picture(live: &Live<'_>, size: (u16, u16)) -> String {
    let screen = screen(live, size);
    let style = |modifier: Modifier| match () {
        () if modifier.contains(Modifier::REVERSED) => 'r',
        () if modifier.contains(Modifier::BOLD) => 'b',
        () => '.',
    };
    let rows = screen.content().chunks(size.0.into());
    let styles = rows.map(|row| row.iter().map(|cell| style(cell.modifier)).collect::<String>());
    let styles: Vec<String> = styles.map(|row| row.trim_end_matches('.').to_owned()).collect();
    format!("{}\n{}\n", text(&screen), styles.join("\n").trim_end())
}

#[test]
fn screens() {
    let (source, program) = start_stop();
    let mut live = Live::new(Session::new(&program, Stimulus::default()), &source, LOOKS, SMALL);
    insta::assert_snapshot!("at_reset", picture(&live, SMALL));
    press(&mut live, "1");
    insta::assert_snapshot!("before_the_scan", text(&screen(&live, SMALL)));
    press(&mut live, "s");
    insta::assert_snapshot!("with_power", picture(&live, SMALL));
    press(&mut live, "f<tab><tab> ");
    live.elapse(3_000_000);
    live.run_due(100);
    live.resize((150, 30));
    insta::assert_snapshot!("wide", text(&screen(&live, (150, 30))));
    press(&mut live, "?");
    let least = (LEAST_COLUMNS, LEAST_ROWS);
    live.resize(least);
    insta::assert_snapshot!("help", text(&screen(&live, least)));
    live.resize((60, 20));
    insta::assert_snapshot!("too_small", text(&screen(&live, (60, 20))));
    let ascii = Options { glyphs: Glyphs::Ascii, ..LOOKS };
    let mut live = Live::new(Session::new(&program, Stimulus::default()), &source, ascii, SMALL);
    press(&mut live, "1s1");
    let shown = text(&screen(&live, SMALL));
    assert!(shown.is_ascii(), "{shown}");
}

/// The manual shows a screen that there is, and every key as the help has it.
#[test]
fn the_page_shows_what_is_seen() {
    let page = include_str!("../docs/live.md");
    let (source, program) = start_stop();
    let mut live = Live::new(Session::new(&program, Stimulus::default()), &source, LOOKS, SMALL);
    press(&mut live, "1s");
    let shown = text(&screen(&live, SMALL));
    assert!(page.contains(&format!("```text\n{shown}```")), "{shown}");
    press(&mut live, "?");
    live.resize((LEAST_COLUMNS, LEAST_ROWS));
    let shown = text(&screen(&live, (LEAST_COLUMNS, LEAST_ROWS)));
    let keys: Vec<&str> = shown.lines().filter(|line| line.starts_with("  ")).collect();
    assert!(keys.len() > 12 && page.contains(&keys.join("\n")), "{shown}");
}

#[test]
fn colour_is_there_only_if_it_may_be() {
    let (source, program) = start_stop();
    for has_color in [false, true] {
        let looks = Options { has_color, ..LOOKS };
        let session = Session::new(&program, Stimulus::default());
        let mut live = Live::new(session, &source, looks, SMALL);
        press(&mut live, "1sx");
        let shown = screen(&live, SMALL);
        let is_green = |cell: &ratatui_core::buffer::Cell| cell.fg == Color::Green;
        assert_eq!(shown.content().iter().any(is_green), has_color);
        let has_own = |cell: &ratatui_core::buffer::Cell| {
            ![cell.fg, cell.bg].iter().all(|&color| color == Color::Reset)
        };
        assert_eq!(shown.content().iter().any(has_own), has_color);
    }
}

#[test]
fn numbers_and_times_are_typed() {
    let (source, program) = program(LIFT);
    let mut live = Live::new(Session::new(&program, Stimulus::default()), &source, LOOKS, SMALL);
    let footer = |live: &Live<'_>| text(&screen(live, SMALL)).lines().last().unwrap().to_owned();
    press(&mut live, "<down><enter>40000<enter>");
    assert!(footer(&live).contains("load : INT :=: 40000_  write a whole number, -32768 to 32767"));
    press(&mut live, "<backspace>");
    assert!(footer(&live).contains("4000_  enter takes it"), "{}", footer(&live));
    press(&mut live, "<enter>++-<down><enter>3ms<enter>1ss");
    let shows = |live: &Live<'_>, value: &str| text(&screen(live, SMALL)).contains(value);
    assert!(shows(&live, "weight       4001"), "{}", text(&screen(&live, SMALL)));
    assert!(shows(&live, "Q 0  ET 1ms  PT 3ms"), "{}", text(&screen(&live, SMALL)));
    press(&mut live, "<enter>7<escape>p");
    assert!(footer(&live).contains("only a BOOL can be pulsed"));
    press(&mut live, "ss");
    assert!(shows(&live, "Q 1  ET 3ms  PT 3ms"), "{}", text(&screen(&live, SMALL)));
    let recorded = "tick,up,load,patience\n1,1,4001,3\n1,,,\n1,,,\n1,,,\n";
    assert_eq!(live.past().to_csv(&program), recorded);
}

#[test]
fn a_pulse_is_one_scan_long_and_time_can_stand_still() {
    let (source, program) = start_stop();
    let mut live = Live::new(Session::new(&program, Stimulus::default()), &source, LOOKS, SMALL);
    press(&mut live, "psSb<down>ps");
    assert_eq!(live.past().to_csv(&program), "tick,start,stop\n1,1,0\n1,0,1\n");
    press(&mut live, "RsS");
    assert_eq!(live.past().to_csv(&program), "tick,start,stop\n1,0,0\n0,,\n");
}

#[test]
fn a_stimulus_goes_first_and_hands_can_join() {
    let (source, program) = start_stop();
    let rows = Source::new("s.csv", "start,stop,tick\n0,0,1\n1,,0\n0,,\n");
    let stimulus = Stimulus::parse(&program, &rows).unwrap();
    let mut live = Live::new(Session::new(&program, stimulus), &source, LOOKS, SMALL);
    assert!(text(&screen(&live, SMALL)).contains("stimulus 3 to come"));
    press(&mut live, "ss2ss");
    let recorded = "tick,start,stop\n1,0,0\n0,1,\n1,0,1\n1,,\n";
    assert_eq!(live.past().to_csv(&program), recorded);
    assert!(!text(&screen(&live, SMALL)).contains("to come"));
    press(&mut live, "Rs");
    assert!(text(&screen(&live, SMALL)).contains("stimulus 2 to come"));
}

#[test]
fn the_ladder_scrolls_to_what_is_asked_for_and_to_what_changes() {
    let rungs: String =
        (0..30).map(|n| format!("rung \"title {n}\" x{} ( y{n} )\n", n % 2)).collect();
    let outputs: Vec<String> = (0..30).map(|n| format!("y{n}")).collect();
    let text_of = format!("ladder t input x0, x1 output {}\n{rungs}", outputs.join(", "));
    let (source, program) = program(&text_of);
    let mut live = Live::new(Session::new(&program, Stimulus::default()), &source, LOOKS, SMALL);
    let shown = |live: &Live<'_>| text(&screen(live, SMALL));
    press(&mut live, "gTITLE 20<enter>");
    assert!(shown(&live).lines().nth(1).unwrap().starts_with("21  title 20"), "{}", shown(&live));
    press(&mut live, "f2s");
    assert!(shown(&live).contains("2  title 1 "), "{}", shown(&live));
    press(&mut live, "g31<enter>");
    assert!(shown(&live).contains("write a number, 1 to 30"), "{}", shown(&live));
    press(&mut live, "<backspace><backspace>30<enter>");
    let end = shown(&live);
    assert!(end.contains("30  title 29"));
    press(&mut live, "<home><end>");
    assert_eq!(shown(&live), end);
    press(&mut live, "<pageup><pagedown>");
    assert_eq!(shown(&live), end);
    press(&mut live, "<home>");
    assert!(shown(&live).contains("1  title 0 "));
}

#[test]
fn it_is_over_when_somebody_leaves() {
    let (source, program) = program(LIFT);
    let leaves = ["q", "<interrupt>", "?<interrupt>", "g<interrupt>", "?qq", "gq<escape>q"];
    let stays = ["?q", "gq", "<down><enter>q", "<escape>"];
    for (keys, leave) in
        leaves.map(|keys| (keys, true)).into_iter().chain(stays.map(|k| (k, false)))
    {
        let session = Session::new(&program, Stimulus::default());
        let mut live = Live::new(session, &source, LOOKS, SMALL);
        press(&mut live, keys);
        assert_eq!(live.is_over(), leave, "{keys}");
    }
}

/// What hands may press.
const HANDS: &[&str] = &[
    "s",
    "S",
    "b",
    " ",
    "<",
    ">",
    "1",
    "2",
    "3",
    "9",
    "p",
    "+",
    "-",
    "f",
    "<up>",
    "<down>",
    "<tab>",
    "<enter>",
    "<enter>-3<enter>",
    "<enter>16#F<enter><escape>",
    "<pageup>",
    "<pagedown>",
    "<home>",
    "<end>",
    "?",
    "g",
    "g2<enter>",
    "<escape>",
    "é",
    "<backspace>",
];

/// Any keys at any time on any screen: nothing panics, and what was written down leads to the
/// same state wherever it runs.
#[test]
fn what_hands_did_can_be_run_again() {
    for seed in 0..60 {
        let mut random = Rng::with_seed(seed);
        let (source, program) = program(&generate::program(seed));
        let session = Session::new(&program, Stimulus::default());
        let mut live = Live::new(session, &source, LOOKS, SMALL);
        let mut size = SMALL;
        for _ in 0..120 {
            match random.u8(..12) {
                0 => {
                    size = (random.u16(1..200), random.u16(1..60));
                    live.resize(size);
                }
                1 => live.elapse(random.u64(..20 * program.tick_ns)),
                2 | 3 => live.run_due(random.usize(..20)),
                _ => press(&mut live, HANDS[random.usize(..HANDS.len())]),
            }
            screen(&live, size);
        }
        if seed % 8 == 0 {
            press(&mut live, "<escape><escape>R");
        }
        let csv = Source::new("past.csv", live.past().to_csv(&program));
        let again = Stimulus::parse(&program, &csv).unwrap_or_default();
        assert_eq!(again.len(), live.past().len(), "seed {seed}");
        let mut evaluator = Evaluator::new(&program);
        for scan in 0..again.len() {
            let row = again.row(scan);
            evaluator.drive_row(row);
            evaluator.scan(row.tick);
        }
        for (id, variable) in program.named_variables() {
            let is_input = variable.role == hotrail::model::Role::Input;
            let (meant, shown) = (evaluator.value(id), live.value(id));
            // An input may have been changed since the last scan.
            assert!(is_input || meant == shown, "seed {seed}: {} is {shown}", variable.name);
        }
    }
}

#[test]
fn without_a_terminal_it_says_so() {
    let folder = Folder::new();
    folder.write("lift.ladder", LIFT);
    let run = folder.run(&["run", "lift.ladder"]);
    assert_eq!((run.code, run.out.as_str()), (2, ""));
    assert!(run.err.contains("`hotrail sim FILE STIMULUS`"), "{}", run.err);
    assert_eq!(folder.run(&["run", "-"]).code, 2);
}

/// The real program in the pseudo terminal of `script`, as a person would use it. Elsewhere that
/// tool takes other options.
#[test]
#[cfg(target_os = "linux")]
fn a_terminal_is_left_as_it_was() {
    if !common::require_tool("script") {
        return;
    }
    let folder = Folder::new();
    folder.write("lift.ladder", LIFT);
    let hotrail = env!("CARGO_BIN_EXE_hotrail");
    for leave in ["q", "\x03"] {
        let record = if leave == "q" { "q.csv" } else { "interrupt.csv" };
        let commands = format!(
            "stty rows 24 cols 80; stty -g > before; '{hotrail}' run lift.ladder --record {record}; \
             echo code $?; stty -g > after"
        );
        let mut script = Command::new("script")
            .args(["-qec", &commands, "typescript"])
            .current_dir(folder.path("."))
            .env("TERM", "xterm")
            .env("SHELL", "/bin/sh")
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (mut keys, mut shown) = (script.stdin.take().unwrap(), script.stdout.take().unwrap());
        let mut output = Vec::new();
        let mut sent = false;
        let mut piece = [0; 4096];
        while let Ok(length @ 1..) = shown.read(&mut piece) {
            output.extend_from_slice(&piece[..length]);
            // The picture is there: the terminal is in the hands of the program.
            if !sent && String::from_utf8_lossy(&output).contains("at reset") {
                keys.write_all(format!("1s{leave}").as_bytes()).unwrap();
                keys.flush().unwrap();
                sent = true;
            }
        }
        script.wait().unwrap();
        let output = String::from_utf8_lossy(&output).into_owned();
        assert!(output.contains("\x1b[?1049h") && output.contains("\x1b[?25l"), "{output}");
        let end = &output[output.rfind("\x1b[?1049l").expect("the screen is given back")..];
        assert!(end.contains("\x1b[?25h") && end.contains("code 0"), "{end}");
        assert_eq!(folder.read("before"), folder.read("after"));
        assert_eq!(folder.read(record), "tick,up,load,patience\n1,1,0,0\n");
    }
}
