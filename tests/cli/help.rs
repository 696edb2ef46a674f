//! What the tool tells of itself: help, completions, blocks.

use std::fs;

use crate::common::folder::Folder;

/// The names of all sub-commands, as the help lists them.
fn commands(folder: &Folder) -> Vec<String> {
    let help = folder.run(&["--help"]).out;
    let list = help.split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let names = list.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    names.map(|line| line.split_whitespace().next().unwrap().to_owned()).collect()
}

#[test]
fn help_ends_with_an_example() {
    let folder = Folder::new();
    let commands = commands(&folder);
    assert!(commands.len() > 5, "{commands:?}");
    for command in commands.iter().filter(|command| *command != "help") {
        let help = folder.run(&[command, "--help"]).out;
        let last = help.trim_end().rsplit("\n\n").next().unwrap();
        let shows = last.starts_with("Example") && last.contains(&format!("\n  hotrail {command}"));
        assert!(shows, "{command}: {last}");
    }
}

#[test]
fn completions_know_every_command() {
    let folder = Folder::new();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let run = folder.run(&["completions", shell]);
        assert_eq!(run.code, 0, "{shell}");
        for command in commands(&folder) {
            assert!(run.out.contains(&command), "{shell} does not know {command}");
        }
    }
    assert_eq!(folder.run(&["completions", "csh"]).code, 2);
}

#[test]
fn blocks_tells_what_the_block_reference_says() {
    let folder = Folder::new();
    let list = folder.run(&["blocks"]);
    assert_eq!(list.out.lines().count(), hotrail::blocks::ALL.len());
    assert!(list.out.contains("CTUD    up-down counter\n"), "{}", list.out);
    let one = folder.run(&["blocks", "ctd"]);
    assert_eq!((list.code, one.code), (0, 0));
    let page = fs::read_to_string("docs/blocks.md");
    assert!(one.out.starts_with("## CTD, the down counter\n"), "{}", one.out);
    assert!(page.unwrap().contains(&one.out), "{}", one.out);
    let unknown = folder.run(&["blocks", "TOFF"]);
    assert_eq!(unknown.code, 2);
    assert!(unknown.err.contains("'TOF'"), "{}", unknown.err);
}
