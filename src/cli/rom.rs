//! `hotrail rom`

use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

use hotrail::backend::processor::{
    self, Fault, Form, Memory, Parameters, Part, Rom, Sizes, Symbols, Unreadable,
};
use hotrail::diagnostic::code;
use hotrail::files::FileError;
use hotrail::source::Source;

use super::Verdict;
use super::report::Report;

/// Tell what an image of the ladder processor does: its words, or the ladder that they draw
#[derive(clap::Args)]
#[command(after_help = "Examples:
  hotrail rom out/conveyor.hex
  hotrail rom conveyor.ihex --as ladder > again.ladder")]
pub struct Options {
    /// The image of the code memory: .hex (for $readmemh), .ihex, .coe, .mif or .bin; FILE_regs
    /// and FILE_image beside it are read too
    #[arg(value_name = "FILE")]
    file: PathBuf,
    /// What to print
    #[arg(long = "as", value_enum, default_value_t = Shown::Listing)]
    shown: Shown,
    /// Sizes of the processor, as for build; else those that the file names in its comment
    #[arg(long, value_name = "SIZES")]
    processor: Option<Sizes>,
}

#[derive(ValueEnum, Clone, Copy, PartialEq, Eq)]
enum Shown {
    /// Each word with its meaning
    Listing,
    /// A program with the same image, where series and parallel can draw it
    Ladder,
}

/// No form needs more for 2047 words, comments included.
const LARGEST_FILE: u64 = 1 << 20;

pub fn run(options: &Options, report: &mut Report) -> anyhow::Result<Verdict> {
    let rom = read(&options.file, options.processor)?;
    let faults = rom.faults();
    if let Some(first) = faults.first() {
        let more = match faults.len() - 1 {
            0 => String::new(),
            more => format!("; and {more} more such words"),
        };
        return Err(bad(&options.file, describe(&rom, first) + &more).into());
    }
    let text = match options.shown {
        Shown::Listing => {
            let none = |_| None;
            let symbols =
                Symbols { bit: &none, register: &none, needs: rom.needs(), heading: &|_| None };
            processor::listing(&rom, &symbols)
        }
        Shown::Ladder => drawn(&options.file, &rom, report)?,
    };
    report.result(&text);
    Ok(Verdict::Good)
}

/// The ladder of an image. Words that the compiler would not write do the same as those that it
/// writes for the ladder, and are not the same.
fn drawn(path: &Path, rom: &Rom, report: &Report) -> Result<String, FileError> {
    let text = processor::ladder(rom, &name(path)).map_err(|not_drawn| FileError {
        code: code::NOT_DRAWN,
        path: path.to_owned(),
        problem: not_drawn.to_string(),
        help: Some("--as listing shows every word".to_owned()),
    })?;
    let (program, _) = hotrail::analyze(&Source::new("again.ladder", &*text));
    let again = program.and_then(|program| processor::compile_for(&program, &[], rom.sizes).ok());
    if again.is_none_or(|again| again.rom != *rom) {
        let file = path.display();
        report
            .remark(&format!("{file}: built again, this ladder has other words that do the same"));
    }
    Ok(text)
}

/// Reads the code, and what stands beside it.
fn read(path: &Path, sizes: Option<Sizes>) -> anyhow::Result<Rom> {
    let form = path.extension().and_then(|extension| extension.to_str());
    let form = form.map(str::to_ascii_lowercase).and_then(|form| Form::of_extension(&form));
    let Some(form) = form else {
        let error = bad(path, "the ending tells no form of image".to_owned());
        let help = "the forms are .hex, .ihex, .coe, .mif and .bin".to_owned();
        return Err(FileError { help: Some(help), ..error }.into());
    };
    let bytes = bytes(path)?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    let record = match form.has_comments() {
        true => None,
        false => Record::beside(path, &stem, form)?,
    };
    let comments = match &record {
        Some(record) => record.text.clone(),
        None => String::from_utf8_lossy(&bytes).into_owned(),
    };
    let told = Parameters::read(&comments).map_err(|problem| match &record {
        Some(record) => bad(&record.path, problem),
        None => bad(path, problem),
    })?;
    let parameters = Parameters { sizes: sizes.unwrap_or(told.sizes), ..told };
    let parse = |path: &Path, part, bytes: &[u8]| -> Result<Memory, FileError> {
        if let Some(record) = &record {
            record.vouch(path, bytes)?;
        }
        parse(path, part, form, bytes, parameters.sizes)
    };
    let code = parse(path, Part::Code, &bytes)?;
    let beside = |part: Part| -> Result<Memory, FileError> {
        let other = path.with_file_name(format!("{stem}{}.{extension}", part.suffix()));
        match other.exists() {
            true => parse(&other, part, &self::bytes(&other)?),
            false => Ok(Memory::new(1, 0)),
        }
    };
    let (registers, bits) = (beside(Part::Registers)?, beside(Part::Bits)?);
    Ok(Rom::of_memories(&code, &registers, &bits, &parameters))
}

/// What stands beside files without comments: it names them with their checksums.
struct Record {
    path: PathBuf,
    text: String,
}

impl Record {
    /// That of an image, if it is there.
    fn beside(image: &Path, stem: &str, form: Form) -> Result<Option<Record>, FileError> {
        let path = image.with_file_name(processor::record_name(stem, form));
        if !path.exists() {
            return Ok(None);
        }
        let text = String::from_utf8_lossy(&bytes(&path)?).into_owned();
        Ok(Some(Record { path, text }))
    }

    /// Refuses a file that is not what the record names.
    fn vouch(&self, file: &Path, contents: &[u8]) -> Result<(), FileError> {
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        if processor::vouches(&self.text, &name, contents) {
            return Ok(());
        }
        let record = self.path.file_name().unwrap_or_default().to_string_lossy();
        Err(bad(file, format!("its checksum is not the one that {record} names")))
    }
}

fn bytes(path: &Path) -> Result<Vec<u8>, FileError> {
    let unread = |problem: String| FileError {
        code: code::CANNOT_READ,
        path: path.to_owned(),
        problem,
        help: None,
    };
    let mut bytes = Vec::new();
    let file = fs::File::open(path).map_err(|error| unread(error.to_string()))?;
    file.take(LARGEST_FILE + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| unread(error.to_string()))?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(bad(path, "no image is larger than 1 MiB".to_owned()));
    }
    Ok(bytes)
}

fn parse(
    path: &Path,
    part: Part,
    form: Form,
    bytes: &[u8],
    sizes: Sizes,
) -> Result<Memory, FileError> {
    part.read(form, bytes, sizes).map_err(|Unreadable { line, problem }| {
        let place = line.map(|line| format!("line {line}: ")).unwrap_or_default();
        bad(path, place + &problem)
    })
}

fn bad(path: &Path, problem: String) -> FileError {
    let help = "build the image again from its ladder".to_owned();
    FileError { code: code::BAD_IMAGE, path: path.to_owned(), problem, help: Some(help) }
}

fn describe(rom: &Rom, fault: &Fault) -> String {
    match rom.code.get(fault.at) {
        Some(bits) => format!("word {:03X} ({bits:04X}): {}", fault.at, fault.kind),
        None => format!("behind the last word: {}", fault.kind),
    }
}

/// A name for the program: that of the file if it can be one.
fn name(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    match hotrail::check::program_name(&stem) {
        Ok(()) => stem.into_owned(),
        Err(_) => "image".to_owned(),
    }
}
