//! Makes cells of word operations: parts put side by side, products, quotients.

use super::{Circuit, Net, Op, Operands, mask};

/// The number of zeros below the only 1 of a number.
fn power_of_two(value: u64) -> Option<u32> {
    value.is_power_of_two().then(|| value.trailing_zeros())
}

impl Circuit {
    /// The parts side by side, the highest bits first.
    ///
    /// # Panics
    /// If there is no part.
    pub fn concat(&mut self, parts: impl IntoIterator<Item = Net>) -> Net {
        let mut flat: Vec<Net> = Vec::new();
        for part in parts {
            let inner = match self.cell(part).op {
                Op::Concat(operands) => self.list(operands).to_vec(),
                _ => vec![part],
            };
            for part in inner {
                match flat.last().and_then(|&last| self.joined(last, part)) {
                    Some(joined) => *flat.last_mut().expect("it has a last part") = joined,
                    None => flat.push(part),
                }
            }
        }
        let width = flat.iter().map(|&part| self.width(part)).sum();
        match flat.as_slice() {
            [] => panic!("there is a part"),
            &[only] => only,
            &[zeros, rest] if self.constant_value(zeros) == Some(0) => {
                self.resize(rest, width, false)
            }
            parts => {
                let start = self.operands.len() as u32;
                let len = parts.len() as u32;
                self.operands.extend_from_slice(&flat);
                self.add_cell(Op::Concat(Operands { start, len }), width)
            }
        }
    }

    /// Two neighbours as one part, if they are that: constants, or parts of one net.
    fn joined(&mut self, high: Net, low: Net) -> Option<Net> {
        let (high_width, low_width) = (self.width(high), self.width(low));
        if let (Some(x), Some(y)) = (self.constant_value(high), self.constant_value(low)) {
            return Some(self.constant(x << low_width | y, high_width + low_width));
        }
        let part = |net: Net| match self.cell(net).op {
            Op::Slice { from, low } => (from, low),
            _ => (net, 0),
        };
        let ((from, above), (other, below)) = (part(high), part(low));
        let is_next = from == other && high != from && above == below + low_width;
        is_next.then(|| self.slice(from, below, high_width + low_width))
    }

    /// The net with one bit replaced.
    pub fn with_bit(&mut self, whole: Net, bit: u32, value: Net) -> Net {
        let width = self.width(whole);
        let mut parts = Vec::with_capacity(3);
        if bit + 1 < width {
            parts.push(self.slice(whole, bit + 1, width - bit - 1));
        }
        parts.push(value);
        if bit > 0 {
            parts.push(self.slice(whole, 0, bit));
        }
        self.concat(parts)
    }

    /// The product, wrapped. A constant stands at the right.
    pub fn mul(&mut self, a: Net, b: Net) -> Net {
        let width = self.width(a);
        if width == 1 {
            return self.and([a, b]);
        }
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(x), Some(y)) => self.constant(x.wrapping_mul(y), width),
            (Some(_), None) => self.mul(b, a),
            (None, Some(0)) => b,
            (None, Some(1)) => a,
            (None, Some(y)) if y == mask(width) => {
                let zero = self.constant(0, width);
                self.sub(zero, a)
            }
            (None, Some(y)) if let Some(zeros) = power_of_two(y) => {
                let (kept, zeros) = (self.slice(a, 0, width - zeros), self.constant(0, zeros));
                self.concat([kept, zeros])
            }
            _ => self.add_cell(Op::Mul(a, b), width),
        }
    }

    /// The quotient of unsigned numbers; 0 for the divisor 0.
    pub fn div(&mut self, a: Net, b: Net) -> Net {
        let width = self.width(a);
        if width == 1 {
            return self.and([a, b]);
        }
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(x), Some(y)) => self.constant(x.checked_div(y).unwrap_or(0), width),
            (Some(0), None) => a,
            (None, Some(0)) => b,
            (None, Some(y)) if let Some(zeros) = power_of_two(y) => {
                let quotient = self.slice(a, zeros, width - zeros);
                self.resize(quotient, width, false)
            }
            _ => self.add_cell(Op::Div(a, b), width),
        }
    }

    /// The rest of a division of unsigned numbers; 0 for the divisor 0.
    pub fn rem(&mut self, a: Net, b: Net) -> Net {
        let width = self.width(a);
        if width == 1 {
            return self.bit(false);
        }
        match (self.constant_value(a), self.constant_value(b)) {
            (Some(x), Some(y)) => self.constant(x.checked_rem(y).unwrap_or(0), width),
            (Some(0), None) => a,
            (None, Some(0)) => b,
            (None, Some(1)) => self.constant(0, width),
            (None, Some(y)) if let Some(zeros) = power_of_two(y) => {
                let rest = self.slice(a, 0, zeros);
                self.resize(rest, width, false)
            }
            _ => self.add_cell(Op::Rem(a, b), width),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_written_one_by_one_become_one_word() {
        let mut circuit = Circuit::new("bits");
        let (word, a, b) = (circuit.input("w", 4), circuit.input("a", 1), circuit.input("b", 1));
        let first = circuit.with_bit(word, 0, a);
        let second = circuit.with_bit(first, 1, b);
        let Op::Concat(parts) = circuit.cell(second).op else { panic!("it has parts") };
        assert_eq!(circuit.list(parts)[1..], [b, a]);
        assert_eq!(circuit.slice(second, 0, 1), a);
        let rest = circuit.slice(second, 2, 2);
        assert_eq!(circuit.cell(rest).op, Op::Slice { from: word, low: 2 });
        let again = [(3, 1), (0, 3)].map(|(low, width)| circuit.slice(word, low, width));
        assert_eq!(circuit.concat(again), word);
    }

    #[test]
    fn constants_spare_multipliers_and_dividers() {
        let mut circuit = Circuit::new("constants");
        let a = circuit.input("a", 16);
        for value in [0, 1, 2, 8, 0x8000] {
            let value = circuit.constant(value, 16);
            circuit.mul(value, a);
            circuit.div(a, value);
            circuit.rem(a, value);
        }
        let is_costly = |op| matches!(op, Op::Mul(..) | Op::Div(..) | Op::Rem(..));
        assert!(!circuit.cells().any(|(_, cell)| is_costly(cell.op)));
        let ten = circuit.constant(10, 16);
        let product = circuit.mul(ten, a);
        assert_eq!(circuit.cell(product).op, Op::Mul(a, ten));
    }
}
