//! `hotrail run`

use std::io::{self, IsTerminal};
use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::CommandFactory;
use clap::error::ErrorKind;
use ratatui_core::terminal::Terminal;
use ratatui_crossterm::CrosstermBackend;
use ratatui_crossterm::crossterm::event::{
    self, Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers,
};
use ratatui_crossterm::crossterm::terminal::{
    EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode, enable_raw_mode, size,
};
use ratatui_crossterm::crossterm::{cursor, execute};

use hotrail::draw::Glyphs;
use hotrail::files::NewFile;
use hotrail::lint;
use hotrail::live::{self, Key, Live, Session};

use super::report::Report;
use super::sim::read_stimulus;
use super::{Cli, Verdict};

/// Run a program in the terminal, work its inputs and watch the power in its rungs
#[derive(clap::Args)]
#[command(after_help = EXAMPLES)]
pub struct Options {
    /// Ladder file
    file: PathBuf,
    /// Start with these values for the inputs, one row a scan, as for `hotrail sim`
    #[arg(long, value_name = "FILE")]
    stimulus: Option<PathBuf>,
    /// When you leave, write what drove every scan since reset into this file, for `hotrail sim`
    /// and `hotrail why`
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
    /// Draw with ASCII characters only
    #[arg(long)]
    ascii: bool,
}

const EXAMPLES: &str = "\
Space runs the program in real time, s runs one scan. 1 to 9 or enter switch an input over, p
switches it on for one scan. ? shows every key, q leaves.

Examples:
  hotrail run conveyor.ladder
  hotrail run conveyor.ladder --record jam.csv
  hotrail why conveyor.ladder jam.csv motor
  hotrail run conveyor.ladder --stimulus jam.csv";

/// How long a picture stands while the program runs.
const FRAME: Duration = Duration::from_millis(40);

/// How long nothing may happen while it does not.
const PAUSE: Duration = Duration::from_secs(60);

/// How many scans run before somebody looks at the clock.
const PIECE: usize = 64;

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    let is_stdin = |path: &PathBuf| path.as_os_str() == "-";
    if is_stdin(&options.file) || options.stimulus.as_ref().is_some_and(is_stdin) {
        wrong_use("standard input is the keyboard here: name a file");
    }
    if !io::stdout().is_terminal() || !io::stdin().is_terminal() {
        wrong_use(
            "`hotrail run` needs a terminal; `hotrail sim FILE STIMULUS` runs a program without one",
        );
    }
    let lints = lint::Options { off: true, ..lint::Options::default() };
    let Some((source, program)) = report.analyze(&options.file, &lints) else {
        return Ok(Verdict::Bad);
    };
    let Some(stimulus) = read_stimulus(&program, options.stimulus.as_ref(), report)? else {
        return Ok(Verdict::Bad);
    };
    let sources: Vec<PathBuf> =
        [Some(&options.file), options.stimulus.as_ref()].into_iter().flatten().cloned().collect();
    // Better to know now that it cannot be written than at the end.
    let record = options.record.as_ref().map(|path| NewFile::create(path, &sources)).transpose()?;
    let glyphs = if options.ascii { Glyphs::Ascii } else { Glyphs::Unicode };
    let looks = live::Options { glyphs, has_color: report.colors_results() };
    let session = Session::new(&program, stimulus);
    let mut live = Live::new(session, &source, looks, size()?);
    watch(&mut live)?;
    if let Some(mut file) = record {
        file.write(live.past().to_csv(&program).as_bytes())?;
        file.finish()?;
    }
    Ok(Verdict::Good)
}

/// Ends the program with the exit code of wrong use.
fn wrong_use(what: &str) -> ! {
    Cli::command().error(ErrorKind::Io, what).exit()
}

/// Takes keys and shows the program until somebody leaves.
fn watch(live: &mut Live<'_>) -> io::Result<()> {
    let _screen = Screen::take()?;
    let mut terminal = Terminal::new(CrosstermBackend::new(io::stdout()))?;
    let mut last = Instant::now();
    while !live.is_over() {
        terminal.draw(|frame| live.draw(frame.buffer_mut()))?;
        let mut is_there = event::poll(if live.is_running() { FRAME } else { PAUSE })?;
        // The time until now belongs to what was so until now, not to what a key makes of it.
        let now = Instant::now();
        live.elapse(u64::try_from((now - last).as_nanos()).unwrap_or(u64::MAX));
        last = now;
        while is_there {
            take(live, &event::read()?);
            is_there = event::poll(Duration::ZERO)?;
        }
        while live.is_due() && now.elapsed() < FRAME {
            live.run_due(PIECE);
        }
    }
    Ok(())
}

fn take(live: &mut Live<'_>, event: &Event) {
    match event {
        Event::Resize(columns, rows) => live.resize((*columns, *rows)),
        Event::Key(key) if key.kind != KeyEventKind::Release => {
            if let Some(key) = meaning(key) {
                live.key(key);
            }
        }
        _ => {}
    }
}

fn meaning(key: &KeyEvent) -> Option<Key> {
    if key.modifiers.contains(KeyModifiers::CONTROL) {
        return (key.code == KeyCode::Char('c')).then_some(Key::Interrupt);
    }
    Some(match key.code {
        KeyCode::Char(c) => Key::Char(c),
        KeyCode::Enter => Key::Enter,
        KeyCode::Esc => Key::Escape,
        KeyCode::Backspace => Key::Backspace,
        KeyCode::Tab => Key::Tab,
        KeyCode::Up => Key::Up,
        KeyCode::Down => Key::Down,
        KeyCode::PageUp => Key::PageUp,
        KeyCode::PageDown => Key::PageDown,
        KeyCode::Home => Key::Home,
        KeyCode::End => Key::End,
        _ => return None,
    })
}

/// The terminal as it is needed here; dropped, it is as it was.
struct Screen;

impl Screen {
    fn take() -> io::Result<Screen> {
        let usual = std::panic::take_hook();
        std::panic::set_hook(Box::new(move |panic| {
            Screen::give_back();
            usual(panic);
        }));
        // From here on an error gives back what has been taken.
        let screen = Screen;
        enable_raw_mode()?;
        execute!(io::stdout(), EnterAlternateScreen, cursor::Hide)?;
        Ok(screen)
    }

    /// There is nobody to tell if that fails.
    fn give_back() {
        let _ = execute!(io::stdout(), LeaveAlternateScreen, cursor::Show);
        let _ = disable_raw_mode();
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        Screen::give_back();
    }
}
