//! The one canonical layout of a program: syntax tree to text.
//!
//! The tree is walked and the source is followed token by token (`reader.rs`); what comes out is
//! a list of instructions (`script.rs`) that is then laid out on lines (`page.rs`). What the
//! layout is, docs/formatting.md says.

mod declarations;
mod expression;
mod network;
mod page;
mod reader;
mod script;
mod statements;

use super::ast::{File, Item, Name};
use super::fault::is_reserved;
use super::parse;
use crate::diagnostic::Diagnostic;
use crate::source::Source;
use reader::{Cluster, Reader};
use script::Script;

/// The source in the canonical layout: the same program, the same comments.
///
/// # Errors
/// The mistakes of the parser: a text that is no program has no layout.
pub fn format(source: &Source) -> Result<String, Vec<Diagnostic>> {
    let (file, diagnostics) = parse(source);
    if !diagnostics.is_empty() {
        return Err(diagnostics);
    }
    let reader = Reader::new(source.text(), &file.comments);
    let mut printer = Printer { reader, script: Script::default() };
    printer.file(&file);
    Ok(page::lay_out(&printer.script.ops))
}

/// How far what belongs to an item is indented.
const INDENT: usize = 4;

/// Turns the tree into instructions.
struct Printer<'s> {
    reader: Reader<'s>,
    script: Script<'s>,
}

/// Items that stand together without a blank line between them.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Group {
    /// With the header, the clock and the tick.
    Declarations,
    Rungs,
    Test,
    Reserved,
}

impl Group {
    fn of(item: &Item<'_>) -> Group {
        match item {
            Item::Header(_) | Item::Clock(_) | Item::Tick(_) => Group::Declarations,
            Item::Variables(_) | Item::Constant(_) => Group::Declarations,
            Item::Rung(_) => Group::Rungs,
            Item::Test(_) => Group::Test,
            Item::Reserved(_) => Group::Reserved,
        }
    }
}

/// How one item, or one statement, is set off from the next.
#[derive(Clone, Copy)]
enum Separator {
    /// The line may end here.
    Line { blanks: usize, offset: usize },
    /// The line may end here, before a mark that closes or parts what stands before it.
    Mark { blanks: usize, offset: usize },
    /// The line ends here.
    Break { offset: usize },
    /// The line ends here, and a blank line of the author is kept.
    Paragraph,
    /// The line ends here only if a comment demands it.
    Start,
}

impl Separator {
    /// The usual one between elements.
    const BLANK: Separator = Separator::Line { blanks: 1, offset: 0 };

    fn offset(self) -> usize {
        match self {
            Separator::Line { offset, .. }
            | Separator::Mark { offset, .. }
            | Separator::Break { offset } => offset,
            Separator::Paragraph | Separator::Start => 0,
        }
    }
}

impl<'s> Printer<'s> {
    fn file(&mut self, file: &File<'s>) {
        let mut before = None;
        for item in &file.items {
            let group = Group::of(item);
            self.between_items(before, Some(group));
            self.item(item);
            before = Some(group);
        }
        self.between_items(before, None);
    }

    fn item(&mut self, item: &Item<'s>) {
        match item {
            Item::Header(header) => self.header(header),
            Item::Clock(frequency) => self.quantity("clock", frequency),
            Item::Tick(time) => self.quantity("tick", time),
            Item::Variables(variables) => self.variables(variables),
            Item::Constant(constant) => self.constant(constant),
            Item::Rung(rung) => self.rung(rung),
            Item::Test(test) => self.test(test),
            Item::Reserved(reserved) => {
                let (start, end) = (reserved.span.start as usize, reserved.span.end as usize);
                let text = self.reader.take_until(end);
                let column = if text.contains('\n') { self.reader.column(start) } else { 0 };
                self.script.comment(text, column);
            }
        }
    }

    /// What stands between two items. Comments on the line of the item before stay there, and so
    /// do those that are indented below it; all others stand above the next item.
    fn between_items(&mut self, before: Option<Group>, next: Option<Group>) {
        let gap = self.reader.take_gap();
        let wants_blank = match (before, next) {
            (Some(before), Some(next)) => before != next || next == Group::Test,
            _ => false,
        };
        let has_blank = gap.blank || gap.clusters.iter().any(|cluster| cluster.blank_before);
        let mut force_blank = wants_blank && !has_blank;
        let margin = match gap.clusters.iter().any(|cluster| cluster.newline_before) {
            true if next.is_some() => {
                let start = self.reader.position();
                self.reader.column(start)
            }
            _ => 0,
        };
        let mut is_below = before.is_some();
        for cluster in gap.clusters {
            if before.is_some() && !cluster.newline_before && cluster.newline_after {
                self.cluster(&cluster);
                continue;
            }
            is_below &= cluster.continues
                || cluster.newline_before
                    && self.reader.comment_column(cluster.comments.start) > margin;
            let blank = cluster.blank_before || force_blank && !is_below;
            force_blank &= is_below;
            self.own_cluster(&cluster, if is_below { INDENT } else { 0 }, blank);
        }
        if next.is_some() {
            self.script.line_break(0, gap.blank || force_blank);
        }
    }

    /// Comments that stand on one line.
    fn cluster(&mut self, cluster: &Cluster) {
        let mut must_end = false;
        for index in cluster.comments.clone() {
            let text = self.reader.comment(index);
            let is_long = text.contains('\n');
            let column = if is_long { self.reader.comment_column(index) } else { 0 };
            self.script.comment(text, column);
            // After a long comment the line ends if the author's did: what comes then would
            // otherwise belong to the comment when it is read again.
            must_end |= text.starts_with("//") || cluster.newline_after && is_long;
        }
        if must_end {
            self.script.end_line();
        }
    }

    /// Comments that have their line for themselves.
    fn own_cluster(&mut self, cluster: &Cluster, offset: usize, blank: bool) {
        if cluster.continues {
            self.script.below();
        } else {
            self.script.own(offset, blank);
        }
        self.cluster(cluster);
        self.script.end_line();
    }

    /// Goes on to the next token by way of a place where the line may end. A comment stays at the
    /// end of its line, on its own line, or before the token that it stands before.
    fn separate(&mut self, separator: Separator) {
        let gap = self.reader.take_gap();
        self.script.end_piece();
        let keeps_blanks = matches!(separator, Separator::Paragraph);
        let at_mark = matches!(separator, Separator::Mark { .. } | Separator::Start);
        let mut with_next = None;
        for cluster in gap.clusters {
            if cluster.is_alone() {
                let blank = keeps_blanks && cluster.blank_before;
                self.own_cluster(&cluster, separator.offset(), blank);
            } else if cluster.newline_after || at_mark && !cluster.newline_before {
                self.cluster(&cluster);
            } else {
                with_next = Some(cluster);
            }
        }
        match separator {
            Separator::Line { blanks, offset } | Separator::Mark { blanks, offset } => {
                self.script.line(blanks, offset);
            }
            Separator::Break { offset } => self.script.line_break(offset, false),
            Separator::Paragraph => self.script.line_break(0, gap.blank),
            Separator::Start => self.script.start(),
        }
        if let Some(cluster) = with_next {
            self.cluster(&cluster);
        }
    }

    /// Comments at the end of what a bracket closes: they stay inside.
    fn comments_before_end(&mut self, offset: usize) {
        let gap = self.reader.take_gap();
        self.script.end_piece();
        for cluster in gap.clusters {
            if cluster.newline_before {
                self.own_cluster(&cluster, offset, false);
            } else {
                self.cluster(&cluster);
            }
        }
    }

    /// Comments in the middle of something that is not broken by itself.
    fn comments_here(&mut self) {
        let gap = self.reader.take_gap();
        for cluster in gap.clusters {
            if cluster.is_alone() {
                self.own_cluster(&cluster, 0, false);
            } else {
                self.cluster(&cluster);
            }
        }
    }

    /// A token that is printed as it stands.
    fn token(&mut self, token: &str) {
        self.comments_here();
        let text = self.reader.take(token);
        self.script.text(text);
    }

    /// A token that is printed in another form.
    fn token_as(&mut self, token: &str, form: &'static str) {
        self.comments_here();
        self.reader.take(token);
        self.script.text(form);
    }

    /// A comma, which comes before the comments that end its line.
    fn comma(&mut self) {
        let gap = self.reader.take_gap();
        let mut later = Vec::new();
        for cluster in gap.clusters {
            let last = self.reader.comment(cluster.comments.end - 1);
            if later.is_empty() && !cluster.newline_before && !last.starts_with("//") {
                let stays = Cluster { newline_after: false, ..cluster };
                self.cluster(&stays);
            } else {
                later.push(cluster);
            }
        }
        self.reader.take(",");
        self.script.comma();
        self.reader.join_gap(later);
    }

    /// A name. Back-ticks that a plain name does not need are dropped.
    fn name(&mut self, name: &Name<'s>) {
        self.comments_here();
        let written = self.reader.take_until(name.span.end as usize);
        let mut letters = name.text.bytes();
        let is_plain = letters.next().is_some_and(|b| b.is_ascii_alphabetic() || b == b'_')
            && letters.all(|b| b.is_ascii_alphanumeric() || b == b'_');
        self.script.text(if is_plain && !is_reserved(name.text) { name.text } else { written });
    }
}
