//! Where the scans of `hotrail sim` go: a table, a dump, pictures.

use hotrail::backend::Vcd;
use hotrail::draw::{Drawing, Timing};
use hotrail::eval::Machine;
use hotrail::files::NewFile;
use hotrail::model::{Program, Role, VariableId};

use super::pictures;
use super::report::Report;
use super::sim::Options;
use super::table::Table;

/// How much of a result is kept back before it is written, in bytes.
const PIECE: usize = 1 << 16;

/// The variables that are to be seen.
pub struct Shown {
    /// Those of the table and of the timing diagram.
    columns: Vec<VariableId>,
    /// Those of the dump, if there is to be one.
    dumped: Vec<VariableId>,
}

impl Shown {
    /// What is watched, or else inputs and outputs; in a dump, every variable.
    pub fn new(program: &Program, watched: Option<Vec<VariableId>>, options: &Options) -> Shown {
        let ports = || {
            let inputs = program.with_role(Role::Input);
            inputs.chain(program.with_role(Role::Output)).map(|(id, _)| id).collect()
        };
        let named = || program.named_variables().map(|(id, _)| id).collect();
        let dumped = match (&options.vcd, &watched) {
            (None, _) => Vec::new(),
            (Some(_), Some(watched)) => watched.clone(),
            (Some(_), None) => named(),
        };
        Shown { columns: watched.unwrap_or_else(ports), dumped }
    }

    /// All of them.
    pub fn all(&self) -> Vec<VariableId> {
        [&self.columns[..], &self.dumped[..]].concat()
    }
}

/// Where the scans go.
pub struct Sink {
    table: Option<Table>,
    dump: Option<(Vcd, Option<NewFile>)>,
    /// What of the dump is not written yet.
    piece: Vec<u8>,
    timing: Option<Timing>,
    /// The ladder in the scan that is shown.
    power: Option<Drawing>,
}

impl Sink {
    /// Nothing yet. The file of a dump is made.
    pub fn new(program: &Program, shown: &Shown, options: &Options) -> anyhow::Result<Sink> {
        let to_stdout = options.vcd.as_ref().is_some_and(|path| path.as_os_str() == "-");
        let dump = match &options.vcd {
            None => None,
            Some(path) => {
                let sources = options.sources();
                let file = (!to_stdout).then(|| NewFile::create(path, &sources)).transpose()?;
                Some((Vcd::new(program, &shown.dumped), file))
            }
        };
        let timing = options.waves.is_some().then(|| Timing::new(program, &shown.columns));
        let table =
            (!to_stdout).then(|| Table::new(program, shown.columns.clone(), options.format));
        Ok(Sink { table, dump, piece: Vec::new(), timing, power: None })
    }

    /// Keeps the ladder with the power of the scan that is shown.
    pub fn draw(&mut self, power: Drawing) {
        self.power = Some(power);
    }

    /// One more scan.
    pub fn scan(&mut self, tick: bool, machine: &impl Machine) {
        if let Some(table) = &mut self.table {
            table.row(tick, |variable| machine.value(variable));
        }
        if let Some((dump, _)) = &mut self.dump {
            dump.scan(tick, |variable| machine.value(variable));
            self.piece.append(&mut dump.take());
        }
        if let Some(timing) = &mut self.timing {
            timing.scan(tick, |variable| machine.value(variable));
        }
    }

    /// True if it is time to write something.
    pub fn is_full(&self) -> bool {
        self.piece.len() > PIECE || self.table.as_ref().is_some_and(|t| t.text.len() > PIECE)
    }

    /// Writes what has come together.
    pub fn flush(&mut self, report: &Report) -> anyhow::Result<()> {
        if let Some(table) = &mut self.table {
            report.result(&std::mem::take(&mut table.text));
        }
        if let Some((_, file)) = &mut self.dump {
            let piece = std::mem::take(&mut self.piece);
            match file {
                Some(file) => file.write(&piece)?,
                None => report.result(&String::from_utf8_lossy(&piece)),
            }
        }
        Ok(())
    }

    /// Writes the rest, and the pictures.
    pub fn finish(mut self, report: &Report, options: &Options) -> anyhow::Result<()> {
        self.flush(report)?;
        let power = options.svg.as_ref().zip(self.power.map(|power| power.svg()));
        let timing = options.waves.as_ref().zip(self.timing.map(|timing| timing.svg()));
        for (path, picture) in power.into_iter().chain(timing) {
            pictures::write(path, &picture, &options.sources())?;
        }
        if let Some((dump, file)) = self.dump {
            let rest = dump.finish();
            match file {
                Some(mut file) => {
                    file.write(&rest)?;
                    file.finish()?;
                }
                None => report.result(&String::from_utf8_lossy(&rest)),
            }
        }
        Ok(())
    }
}
