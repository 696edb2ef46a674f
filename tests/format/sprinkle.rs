//! Odd white space and comments between the tokens of a program, and items of the language that
//! random programs do not have.

use fastrand::Rng;

use super::text::{Piece, pieces};

const BLANKS: [&str; 8] = ["", "", " ", "  ", "\n", "\t", " \r\n ", "\n \n\n\n  "];

/// Items that need not make sense together: the formatter only reads them.
const ITEMS: [&str; 14] = [
    "clock 50MHz\n",
    "tick 1ms\n",
    "var array, other : TIME[2] := [1ms, 2s]\n",
    "output at_316 : BOOL at 316 := 1 output at_317 at 317, z := FALSE\n",
    "const FULL : TIME := T#1.5s\n",
    "input `I:0/3`, `plain`, `rung` : INT\n",
    "rung w[2] w[i + 1].5 !w[w[0]] (S w[1].4) /z (/z) rise(w[1]) 0 1 TRUE\n",
    "rung \"net\" net { left -> n1 : [ c9 | c2 c3 c4 ] left -> n2 : c5 n1 <-> n2 : c6 \
     n2 -> right : c7 t:TON(PT := 5s) } (CR316)\n",
    "rung { LIMIT(0, x.5, MAX(a, b)) <> t.CV / 2 - -3 } t:KIND(A := [10, 200, N], B := a / b, \
     C := !a [ b | c ] { n > 3 }, D := ((a)) / (b + 1), E := [ a ], F := w[1])\n",
    "rung a b:CTU( ) net { } [ ] t:TON(R := , S := )\n",
    "use \"a file\"\n",
    "assert always a [ b | c ] { n > 5 }\n",
    "test \"a title\" start := 1 n := -5 + a scan scan 10 wait 1.5s pulse `a b` reset \
     repeat 4 { scan repeat 2 { } } expect a !b { n = 3 } [ c | d ] b.5 := 1 expect w x := 2\n",
    "test \"lines\"\n start := 1 scan\n expect a\n\n repeat 3 {\n pulse a scan }\n reset\n",
];

/// Some of those items.
pub fn more_items(random: &mut Rng) -> String {
    let items: String =
        (0..random.usize(..5)).map(|_| ITEMS[random.usize(..ITEMS.len())]).collect();
    "var w : WORD[3] := [16#FFFF, 16#0F0F, -1]\n".to_owned() + &items
}

/// The program with other white space.
pub fn blanks(program: &str, random: &mut Rng) -> String {
    mix(program, random, |random| BLANKS[random.usize(..BLANKS.len())].to_owned())
}

/// The program with other white space and with comments.
pub fn sprinkle(program: &str, random: &mut Rng) -> String {
    let one_in = random.usize(1..30);
    let mut count = 0;
    let mark = ["", "", "\u{FEFF}"][random.usize(..3)];
    let text = mix(program, random, |random| {
        let mut text = BLANKS[random.usize(..BLANKS.len())].to_owned();
        while random.usize(..one_in + 1) == 0 {
            count += 1;
            text += &match random.u32(..6) {
                0..2 => format!("// c{count} (é) \n"),
                2 => format!("//{count}\r\n"),
                3 => format!("/* c{count}\n\t  goes on  \n\n end */"),
                4 => format!("/* c{count} /* nested // */ */"),
                _ => format!("/*{count}*/"),
            };
            text += BLANKS[random.usize(..BLANKS.len())];
        }
        text
    });
    mark.to_owned() + &text
}

/// Puts something between any two tokens; words stay apart.
fn mix(program: &str, random: &mut Rng, mut between: impl FnMut(&mut Rng) -> String) -> String {
    let mut text = between(random);
    for piece in pieces(program) {
        let Piece::Token(token) = piece else { continue };
        let is_word = |c: char| c == '_' || c == '`' || c.is_alphanumeric();
        // An operator and a comment would make another comment.
        if text.ends_with(is_word) && token.starts_with(is_word) || text.ends_with('/') {
            text.push(' ');
        }
        text += token;
        let gap = between(random);
        if token.ends_with('/') && gap.starts_with('/') {
            text.push(' ');
        }
        text += &gap;
    }
    text
}
