//! The record beside files whose form has no place for our header: it bears the header and names
//! them with a checksum, so that a later build knows them again as long as nobody has changed them.

use std::fmt::Write;

use super::memory::Form;
use crate::backend::Artifact;

/// The name of the record of files of one form.
pub fn record_name(program: &str, form: Form) -> String {
    format!("{program}_{}.txt", form.extension())
}

/// The record of these files, all of one form.
pub fn record(program: &str, form: Form, comments: &[String], files: &[Artifact]) -> Artifact {
    let mut text = String::new();
    comments.iter().for_each(|line| writeln!(text, "// {line}").expect("fits"));
    text.push_str(
        "// These files bear no such lines; a build replaces them while they are as here.\n",
    );
    for Artifact { file_name, contents } in files {
        writeln!(text, "{:016x}  {file_name}", checksum(contents)).expect("fits");
    }
    Artifact::of_text(record_name(program, form), text)
}

/// The names that a record of this file may have; none for forms that bear the header themselves.
pub fn records_of(file_name: &str) -> Vec<String> {
    let Some((stem, extension)) = file_name.rsplit_once('.') else { return Vec::new() };
    let Some(form) = Form::of_extension(extension).filter(|form| !form.has_comments()) else {
        return Vec::new();
    };
    let programs = ["", "_regs", "_image"].iter().filter_map(|suffix| stem.strip_suffix(suffix));
    programs.map(|program| record_name(program, form)).collect()
}

/// True if the text of a record names the file with these contents.
pub fn vouches(record: &str, file_name: &str, contents: &[u8]) -> bool {
    let line = format!("{:016x}  {file_name}", checksum(contents));
    record.lines().any(|named| named == line)
}

/// FNV-1a of 64 bits: it tells changed files from unchanged ones, not forged ones.
fn checksum(contents: &[u8]) -> u64 {
    contents.iter().fold(0xCBF2_9CE4_8422_2325, |sum, byte| {
        (sum ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01B3)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The test values of the authors of FNV.
    #[test]
    fn checksums_are_those_of_fnv_1a() {
        assert_eq!(checksum(b""), 0xCBF2_9CE4_8422_2325);
        assert_eq!(checksum(b"a"), 0xAF63_DC4C_8601_EC8C);
        assert_eq!(checksum(b"foobar"), 0x8594_4171_F739_67E8);
    }
}
