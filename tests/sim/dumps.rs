//! Dumps for a wave viewer, read again by the parser of another maker.

use std::fs;

use crate::common::folder::Folder;
use crate::folder;

/// The values of a variable in a dump, read by the parser of another maker.
pub fn values(dump: &str, path: &[&str], scans: usize) -> Vec<i64> {
    let mut parser = vcd::Parser::new(dump.as_bytes());
    let header = parser.parse_header().unwrap();
    let var = header.find_var(path).unwrap_or_else(|| panic!("{path:?} is not in {dump}"));
    let (mut values, mut value) = (Vec::new(), 0);
    for command in parser {
        match command.unwrap() {
            vcd::Command::Timestamp(time) => values.resize(time as usize, value),
            vcd::Command::ChangeScalar(id, bit) if id == var.code => {
                value = (bit == vcd::Value::V1).into();
            }
            vcd::Command::ChangeVector(id, bits) if id == var.code => {
                let bits =
                    bits.iter().fold(0, |all, bit| all << 1 | i64::from(bit == vcd::Value::V1));
                let spare = 64 - var.size;
                value = bits << spare >> spare;
            }
            _ => {}
        }
    }
    values.truncate(scans);
    values
}

#[test]
fn a_dump_shows_what_the_table_shows() {
    let folder = folder();
    folder.write("s.csv", "up,load,patience,tick\n0,,-2,1\n1,-5,3,0\n,,,\n0,7,,1\n1,9,1,\n,,,\n");
    let run = |output: &str| {
        let run = folder.run(&["sim", "lift.ladder", "s.csv", "--scans", "9", "--vcd", output]);
        assert_eq!((run.code, run.err.as_str()), (0, ""));
        run.out
    };
    let (table, dump) = (run("waves/lift.vcd"), run("-"));
    assert_eq!(folder.read("waves/lift.vcd"), dump, "same input, same bytes");
    let mut rows = table.lines();
    let names: Vec<&str> = rows.next().unwrap().split(',').skip(1).collect();
    let rows: Vec<Vec<i64>> = rows
        .map(|row| row.split(',').skip(1).map(|cell| cell.parse().unwrap()).collect())
        .collect();
    for (name, column) in names.iter().zip(0..) {
        let shown = values(&dump, &["lift", name], rows.len());
        let meant: Vec<i64> = rows.iter().map(|row| row[column]).collect();
        assert_eq!(shown, meant, "{name}");
    }
    assert_eq!(values(&dump, &["lift", "delay", "PT"], 2), [-2, 3]);
}

#[test]
fn a_dump_never_replaces_what_is_not_ours() {
    let folder = folder();
    folder.write("lift.vcd", "precious");
    let arguments = ["sim", "lift.ladder", "--scans", "1", "--vcd", "lift.vcd"];
    let run = folder.run(&arguments);
    assert_eq!((run.code, run.out.as_str()), (1, ""));
    assert!(run.err.contains("E0602") && run.err.contains("remove it first"), "{}", run.err);
    assert_eq!(folder.read("lift.vcd"), "precious");
    fs::remove_file(folder.path("lift.vcd")).unwrap();
    assert_eq!(folder.run(&arguments).code, 0);
    assert_eq!(folder.run(&arguments).code, 0, "our own is replaced");
}

#[test]
fn hostile_names_are_legal_in_a_dump() {
    let folder = Folder::new();
    let program = "ladder h  input `$end`, `a b`, `a_b`, wire  output `größer #1`  \
                   rung `$end` `a b` `a_b` wire ( `größer #1` )";
    folder.write("h.ladder", program);
    let run = folder.run(&["sim", "h.ladder", "--scans", "1", "--vcd", "-"]);
    let header = vcd::Parser::new(run.out.as_bytes()).parse_header().unwrap();
    for name in ["end_u", "a_b", "a_b_2", "wire_u", "gr_er_1"] {
        assert!(header.find_var(&["h", name]).is_some(), "{name}: {}", run.out);
    }
}
