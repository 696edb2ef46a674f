//! What was wanted where the text goes wrong, in words for people.

use super::super::fault::{first_token, found, is_invisible};
use super::Lower;
use super::grammar::Rule;
use crate::diagnostic::{Diagnostic, code};
use crate::source::Span;

/// Stands in every message before what was found.
pub(super) const FOUND: &str = ", found ";

const ITEM_STARTS: &str = "an item starts with `ladder`, `clock`, `tick`, `input`, `output`, `var`, \
                           `const`, `rung` or `test`";

pub(super) const STATEMENTS: &str = "statements are `x := 1`, `scan`, `wait 1s`, `pulse x`, \
                                     `repeat 4 { }`, `reset`, `expect a !b`";

impl Lower<'_> {
    /// The diagnostic for a `want_` rule at a place in the body of the item.
    pub(super) fn wanted(&self, rule: Rule, at: usize, body: &str) -> Diagnostic {
        let rest = &body[at..];
        let start = self.base + at + rest.len() - rest.trim_ascii_start().len();
        let token = first_token(&self.text[start..self.base + body.len()]);
        let span = Span::new(start, start + token.len());
        if let Some(diagnostic) = self.meant(rule, body, at, token) {
            return diagnostic;
        }
        let wanted = |phrase: &str| {
            let message = format!("expected {phrase}{FOUND}{}", found(token));
            Diagnostic::new(code::SYNTAX, span, message).label("not expected here")
        };
        if rule == Rule::want_declaration_end && matches!(token, "," | ":") {
            let word = &self.text[self.word.range()];
            return wanted("the next item").help(format!(
                "one declaration has one type, after all its names: start a new `{word}` for the \
                 rest"
            ));
        }
        let diagnostic = wanted(phrase(rule));
        match help(rule, token) {
            Some(help) => diagnostic.help(help),
            None => diagnostic,
        }
    }

    /// The diagnostic for text before the first item.
    pub(super) fn outside_item(&self, body: &str) -> Diagnostic {
        let start = self.base + body.len() - body.trim_ascii_start().len();
        let token = first_token(&self.text[start..]);
        let span = Span::new(start, start + token.len());
        let message = format!("expected an item{FOUND}{}", found(token));
        Diagnostic::new(code::SYNTAX, span, message).label("not expected here").help(ITEM_STARTS)
    }
}

fn phrase(rule: Rule) -> &'static str {
    match rule {
        Rule::want_address => "an image address such as 316",
        Rule::want_argument => "a parameter such as `PT := 5s`",
        Rule::want_argument_end => "`,` or `)` after the argument",
        Rule::want_argument_or_close => "a parameter such as `PT := 5s`, or `)`",
        Rule::want_argument_value => "`:=` and a value for the parameter",
        Rule::want_arrow => "`->` or `<->` after the node",
        Rule::want_brace_end => "an operator, `:=` or `}`",
        Rule::want_branch_end => "a contact, a coil, a list, `|` or `]`",
        Rule::want_call_open => "`(` after the kind of block",
        Rule::want_close => "`)`",
        Rule::want_coil_end => "`)` after the coil's variable",
        Rule::want_coil_operand => "the variable of the coil",
        Rule::want_colon => "`:` and what stands in the connection",
        Rule::want_connection => "a contact, a connection such as `left -> n1 : a`, or `}`",
        Rule::want_constant_name => "the name of the constant",
        Rule::want_constant_value => "`:=` and the constant's value",
        Rule::want_constants_end => "`,` or `]` after the constant",
        Rule::want_count => "how often to repeat, such as 4",
        Rule::want_declaration_end => "`,`, a type after `:`, `at`, `:=` or the next item",
        Rule::want_drive => "`:=` and the value to drive the input with",
        Rule::want_element => "a contact, a coil, a list or the next item",
        Rule::want_frequency => "a frequency such as 50MHz",
        Rule::want_function_end => "an operator, `,` or `)`",
        Rule::want_group_end => "an operator or `)`",
        Rule::want_index_end => "an operator or `]`",
        Rule::want_input => "the input to pulse",
        Rule::want_kind => "a kind of block such as `TON`",
        Rule::want_length => "the number of elements, such as 3",
        Rule::want_length_end => "`]` after the number of elements",
        Rule::want_member => "a member's name or a bit's number after `.`",
        Rule::want_net_open => "`{` after `net`",
        Rule::want_next_item => "the next item",
        Rule::want_node => "the node at the other end",
        Rule::want_operand => "a variable, a number or `(`",
        Rule::want_program_name => "the program's name",
        Rule::want_repeat_end => "a statement or `}`",
        Rule::want_repeat_open => "`{` and the statements to repeat",
        Rule::want_statement => "a statement or the next item",
        Rule::want_tick | Rule::want_time => "a time such as 500ms",
        Rule::want_title => "the test's title in double quotes",
        Rule::want_type => "a type such as `INT`",
        Rule::want_variable => "a name",
        _ => "something else",
    }
}

fn help(rule: Rule, token: &str) -> Option<&'static str> {
    help_about_token(rule, token).or_else(|| help_about_place(rule))
}

/// Help where what was found shows what was meant.
fn help_about_token(rule: Rule, token: &str) -> Option<&'static str> {
    let first = token.chars().next()?;
    let in_network = matches!(
        rule,
        Rule::want_element
            | Rule::want_branch_end
            | Rule::want_connection
            | Rule::want_argument_end
    );
    Some(match token {
        ";" => "nothing ends an item or a statement: white space separates",
        "==" | "=" if rule == Rule::want_operand => "`=` compares, `>=` is greater or equal",
        "!=" | "!" if is_in_expression(rule) => "in an expression `<>` is not equal, `NOT` inverts",
        "&&" | "&" | "||" | "|" if is_in_expression(rule) => "the operators are `AND`, `OR`, `XOR`",
        "and" | "And" if is_in_expression(rule) => "operators have capital letters: `a AND b`",
        "or" | "Or" if is_in_expression(rule) => "operators have capital letters: `a OR b`",
        "xor" | "Xor" if is_in_expression(rule) => "operators have capital letters: `a XOR b`",
        "mod" | "Mod" if is_in_expression(rule) => "operators have capital letters: `n MOD 3`",
        "%" if is_in_expression(rule) => "the remainder of a division is `MOD`: `n MOD 3`",
        "=" | "==" if rule == Rule::want_declaration_end => {
            "an initial value stands after `:=`: `var total : INT := 3`"
        }
        "=" | "==" if matches!(rule, Rule::want_drive | Rule::want_argument_value) => {
            "a value is given with `:=`"
        }
        "[" if is_in_expression(rule) => {
            "only a name that is declared as an array has elements: `var w : WORD[3]`"
        }
        ":=" if rule == Rule::want_function_end => "arguments of a function go by their order",
        ":=" if rule == Rule::want_brace_end => "one pair of braces holds one assignment",
        ":=" if in_network => "an assignment stands in braces: `{ total := total + 1 }`",
        "=" | "<" | ">" | "<=" | ">=" | "<>" | "==" | "!=" if in_network => {
            "a comparison stands in braces: `{ count >= 10 }`"
        }
        "=" | "<" | ">" | "<=" | ">=" | "<>" | "==" | "!="
            if matches!(rule, Rule::want_statement | Rule::want_repeat_end) =>
        {
            "a comparison stands in braces: `expect { count >= 10 }`"
        }
        "+" | "-" | "*" if in_network => "an expression stands in braces: `{ count >= top - 1 }`",
        "->" | "<->" if in_network => "connections stand in a network: `net { left -> n1 : a }`",
        ":=" if rule == Rule::want_coil_end => {
            "a coil names one variable; a block has a name of its own: `delay:TON(PT := 5s)`"
        }
        "|" if in_network || rule == Rule::want_coil_end => {
            "branches stand in square brackets: `[ a | b ]`"
        }
        "," if in_network => "elements of a rung are separated by white space",
        "!" if in_network => "`!` stands right before a contact",
        _ if is_invisible(first) => {
            "remove this invisible character; white space is blanks, tabs and line ends"
        }
        _ if first == '"' && in_network => "a title stands right after the word `rung` or `test`",
        _ if first.is_ascii_digit() && in_network => {
            "only 0 and 1 are elements; `x[2]` needs `x` to be declared as an array, and a \
             comparison stands in braces"
        }
        _ if first == '"' && rule == Rule::want_program_name => "the title comes after the name",
        _ => return None,
    })
}

/// Help that shows how it is written.
fn help_about_place(rule: Rule) -> Option<&'static str> {
    Some(match rule {
        Rule::want_address => "an image address is a number, such as `output y at 316`",
        Rule::want_argument
        | Rule::want_argument_end
        | Rule::want_argument_or_close
        | Rule::want_argument_value
        | Rule::want_call_open
        | Rule::want_kind => {
            "a block is written with its parameters by name: `delay:TON(PT := 5s)`"
        }
        Rule::want_coil_end | Rule::want_coil_operand => {
            "the coils are `( y )`, `( !y )`, `(S y)`, `(R y)`, `(rise y)` and `(fall y)`"
        }
        Rule::want_constant_name | Rule::want_constant_value => {
            "a constant is written `const FULL : INT := 10`"
        }
        Rule::want_count | Rule::want_repeat_open => {
            "write for instance `repeat 4 { pulse start }`"
        }
        Rule::want_declaration_end => "names are separated by commas: `input start, stop`",
        Rule::want_length => "an array is declared with its length: `var w : WORD[3]`",
        Rule::want_frequency => "a frequency has a unit: 12MHz, 50MHz",
        Rule::want_next_item => ITEM_STARTS,
        Rule::want_arrow | Rule::want_colon | Rule::want_connection | Rule::want_node => {
            "a connection is written `left -> n1 : a b`"
        }
        Rule::want_program_name => "a program starts with its name: `ladder conveyor`",
        Rule::want_statement | Rule::want_repeat_end | Rule::want_drive => STATEMENTS,
        Rule::want_tick | Rule::want_time => "a time has a unit: 500ms, 1.3s, 2m30s",
        Rule::want_title => "a test has a title: `test \"the motor stops\"`",
        Rule::want_type => "the types are BOOL, INT, UINT, DINT, UDINT, WORD, DWORD, TIME",
        Rule::want_variable => {
            "a name is letters, digits and `_`; after the last one stands no comma"
        }
        Rule::want_brace_end | Rule::want_group_end | Rule::want_operand => {
            "a comparison is written `{ count >= 10 }`, an assignment `{ total := total + 1 }`"
        }
        Rule::want_branch_end | Rule::want_element => {
            "a rung is written with contacts `a` and `!a`, lists `[ a | b ]`, comparisons \
             `{ n > 1 }`, blocks and coils `( y )`"
        }
        _ => return None,
    })
}

pub(super) fn is_in_expression(rule: Rule) -> bool {
    matches!(
        rule,
        Rule::want_operand
            | Rule::want_brace_end
            | Rule::want_function_end
            | Rule::want_group_end
            | Rule::want_index_end
    )
}
