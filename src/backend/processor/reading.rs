//! How memory contents come back from files of each form.

use super::memory::{Form, Memory, Unreadable};

type Read<T> = Result<T, Unreadable>;

fn wrong<T>(line: usize, problem: impl Into<String>) -> Read<T> {
    Err(Unreadable { line: Some(line + 1), problem: problem.into() })
}

impl Memory {
    /// Reads a file.
    ///
    /// # Errors
    /// Where it does not follow its form or does not fit the memory.
    pub fn read(form: Form, bytes: &[u8], width: u32, depth: usize) -> Read<Memory> {
        let mut memory = Memory::new(width, depth);
        if form == Form::Binary {
            memory.take_bytes(0, bytes, None)?;
            return Ok(memory);
        }
        let text = str::from_utf8(bytes)
            .map_err(|_| Unreadable { line: None, problem: "it is no text".to_owned() })?;
        match form {
            Form::Hex => memory.read_hex(text)?,
            Form::IntelHex => memory.read_intel_hex(text)?,
            Form::Coe => memory.read_coe(text)?,
            Form::Mif | Form::Binary => memory.read_mif(text)?,
        }
        Ok(memory)
    }

    fn set(&mut self, at: usize, word: u16, line: usize) -> Read<()> {
        if at >= self.depth {
            return wrong(line, format!("the address {at:X} is outside of {} words", self.depth));
        }
        if self.width == 1 && word > 1 {
            return wrong(line, format!("{word:X} is more than one bit"));
        }
        match self.words.insert(at, word) {
            None => Ok(()),
            Some(_) => wrong(line, format!("the address {at:X} stands there twice")),
        }
    }

    fn take_bytes(&mut self, start: usize, bytes: &[u8], line: Option<usize>) -> Read<()> {
        let place = line.unwrap_or(0);
        let result = if self.width == 1 {
            let bits =
                bytes.iter().flat_map(|byte| (0..8).map(move |bit| u16::from(byte >> bit & 1)));
            (start * 8..).zip(bits).try_for_each(|(at, bit)| self.set(at, bit, place))
        } else if !start.is_multiple_of(2) || !bytes.len().is_multiple_of(2) {
            wrong(place, "half a word of 16 bits")
        } else {
            let words = bytes.chunks(2).map(|pair| u16::from_le_bytes([pair[0], pair[1]]));
            (start / 2..).zip(words).try_for_each(|(at, word)| self.set(at, word, place))
        };
        result.map_err(|found| Unreadable { line: line.map(|line| line + 1), ..found })
    }

    fn read_hex(&mut self, text: &str) -> Read<()> {
        let mut at = 0;
        for (line, words) in text.lines().enumerate() {
            let words = words.split("//").next().unwrap_or("");
            for word in words.split_whitespace() {
                if let Some(address) = word.strip_prefix('@') {
                    at = number(address, 16, line)?.into();
                } else {
                    self.set(at, number(word, 16, line)?, line)?;
                    at += 1;
                }
            }
        }
        Ok(())
    }

    fn read_intel_hex(&mut self, text: &str) -> Read<()> {
        let mut ended = false;
        for (line, record) in text.lines().enumerate() {
            let record = record.trim();
            if record.is_empty() {
                continue;
            }
            if ended {
                return wrong(line, "a record follows the last one");
            }
            let bytes = record_bytes(record, line)?;
            let [count, high, low, kind, data @ .., _] = bytes.as_slice() else {
                return wrong(line, "the record is too short");
            };
            if usize::from(*count) != data.len() {
                return wrong(
                    line,
                    format!("the record says {count} bytes and has {}", data.len()),
                );
            }
            match kind {
                0 => {
                    let start = usize::from(u16::from_be_bytes([*high, *low]));
                    self.take_bytes(start, data, Some(line))?;
                }
                1 => ended = true,
                // Segment and linear addresses; a memory of the processor needs none but 0.
                2 | 4 if data.iter().all(|byte| *byte == 0) => {}
                3 | 5 => {}
                _ => return wrong(line, "the record leads outside of the memory"),
            }
        }
        if ended {
            Ok(())
        } else {
            Err(Unreadable { line: None, problem: "the last record is missing".to_owned() })
        }
    }

    fn read_coe(&mut self, text: &str) -> Read<()> {
        let mut radix = None;
        let (mut in_vector, mut has_ended) = (false, false);
        let mut at = 0;
        for (line, content) in text.lines().enumerate() {
            let mut content = content.trim();
            let is_comment = content.starts_with(';');
            if is_comment {
                has_ended |= in_vector;
                continue;
            }
            if let Some((name, value)) = content.split_once('=') {
                match name.trim().to_ascii_lowercase().as_str() {
                    "memory_initialization_radix" => {
                        let value = value.trim().trim_end_matches(';').trim();
                        radix = match value {
                            "2" => Some(2),
                            "10" => Some(10),
                            "16" => Some(16),
                            _ => {
                                return wrong(
                                    line,
                                    format!("the radix `{value}` is none of 2, 10, 16"),
                                );
                            }
                        };
                        continue;
                    }
                    "memory_initialization_vector" => (in_vector, content) = (true, value),
                    other => return wrong(line, format!("nothing is called `{other}`")),
                }
            }
            let (words, ends) = match content.split_once(';') {
                Some((words, _)) => (words, true),
                None => (content, false),
            };
            for word in words.split([',', ' ', '\t']).filter(|word| !word.is_empty()) {
                let Some(radix) = radix.filter(|_| in_vector && !has_ended) else {
                    return wrong(line, "a word stands outside of the vector");
                };
                self.set(at, number(word, radix, line)?, line)?;
                at += 1;
            }
            has_ended |= in_vector && ends;
        }
        if has_ended {
            Ok(())
        } else {
            let problem = "the semicolon behind the vector is missing".to_owned();
            Err(Unreadable { line: None, problem })
        }
    }

    fn read_mif(&mut self, text: &str) -> Read<()> {
        let mut in_content = false;
        for (line, content) in text.lines().enumerate() {
            let content = content.split("--").next().unwrap_or("").trim();
            let upper = content.to_ascii_uppercase();
            if upper.starts_with("CONTENT") {
                in_content = true;
            } else if !in_content || content.is_empty() || upper == "BEGIN" {
                self.mif_setting(&upper, line)?;
            } else if upper.starts_with("END") {
                return Ok(());
            } else {
                let pair = content.trim_end_matches(';').split_once(':');
                let Some((at, word)) = pair else {
                    return wrong(line, "here an address and a word should stand");
                };
                let word = number(word.trim(), 16, line)?;
                let at = at.trim();
                match at.strip_prefix('[').and_then(|range| range.strip_suffix(']')) {
                    None => self.set(number(at, 16, line)?.into(), word, line)?,
                    Some(range) => {
                        let Some((first, last)) = range.split_once("..") else {
                            return wrong(line, "a range is [first..last]");
                        };
                        let (first, last) = (number(first, 16, line)?, number(last, 16, line)?);
                        (first..=last).try_for_each(|at| self.set(at.into(), word, line))?;
                    }
                }
            }
        }
        Err(Unreadable { line: None, problem: "END is missing".to_owned() })
    }

    /// A line in front of the words.
    fn mif_setting(&mut self, setting: &str, line: usize) -> Read<()> {
        let Some((name, value)) = setting.trim_end_matches(';').split_once('=') else {
            return Ok(());
        };
        let (name, value) = (name.trim(), value.trim());
        match name {
            "ADDRESS_RADIX" | "DATA_RADIX" if value != "HEX" => {
                wrong(line, "only the radix HEX is read")
            }
            "WIDTH" if value.parse() != Ok(self.width) => {
                wrong(line, format!("a word of this memory has {} bits", self.width))
            }
            "DEPTH" => match value.parse() {
                Ok(depth) if depth <= self.depth => {
                    self.depth = depth;
                    Ok(())
                }
                _ => wrong(line, format!("this memory has {} words", self.depth)),
            },
            _ => Ok(()),
        }
    }
}

fn number(text: &str, radix: u32, line: usize) -> Read<u16> {
    let plain = text.trim().replace('_', "");
    match u16::from_str_radix(&plain, radix) {
        Ok(number) if !plain.starts_with('+') => Ok(number),
        _ => {
            let shown: String = text.chars().take(20).collect();
            wrong(line, format!("`{shown}` is no number of 16 bits in base {radix}"))
        }
    }
}

/// The bytes of a record, the last of them its checksum.
fn record_bytes(record: &str, line: usize) -> Read<Vec<u8>> {
    let Some(digits) = record.strip_prefix(':').filter(|digits| digits.is_ascii()) else {
        return wrong(line, "a record begins with a colon");
    };
    let pairs = digits.as_bytes().chunks(2).map(|pair| {
        let pair =
            str::from_utf8(pair).ok().filter(|pair| pair.len() == 2 && !pair.starts_with('+'));
        pair.and_then(|pair| u8::from_str_radix(pair, 16).ok())
    });
    let Some(bytes) = pairs.collect::<Option<Vec<u8>>>() else {
        return wrong(line, "a record is pairs of hexadecimal digits");
    };
    match bytes.iter().fold(0_u8, |sum, byte| sum.wrapping_add(*byte)) {
        0 => Ok(bytes),
        _ => wrong(line, "the checksum is wrong"),
    }
}
