//! `AB_CTU` and `AB_CTD`, Allen-Bradley's counters, which may count on one instance.

use super::{Block, COUNTS, HIGHEST, LOWEST, Logic, Port, PortRole, Start, Step, ab};
use crate::circuit::Net;
use crate::types::Type;

/// The up counter of Allen-Bradley.
pub const AB_CTU: Block = Block {
    name: "AB_CTU",
    title: "up counter of Allen-Bradley",
    doc: "ACC counts the rises of the power, past PRE; DN is on while ACC is PRE or more, also \
          without power. From its largest value ACC goes on with its smallest: that clears UN if \
          it is on, else it sets OV. CU follows the power. A power that is on in the first scan \
          does not count. The power goes on to the right as it is: there is no Q. PRE and ACC may \
          be assigned anywhere. An AB_CTD may be called on the same instance, without arguments. (R \
          name) is RES: it puts ACC and all bits to 0, CU and CD among them, so that a held power \
          counts once more. Source: Rockwell Automation, SLC 500 Instruction Set and Logix 5000 \
          General Instructions, CTU and RES.",
    settings: &[ab::SIZE],
    ports: &ports(true),
    main: None,
    partner: Some("AB_CTD"),
    can_reset: true,
    keeps: |_| Some(&[]),
    step: count_up,
    build: build_up,
    waves: &[
        "\
PRE = 2
IN  _#_##_#_##_#
(R) ________#___
CU  _#_##_#__#_#
DN  ___#####___#
ACC 011222330112",
        "\
PRE = 1
IN  ##_#
CU  ##_#
DN  ___#
ACC 0001",
        "\
PRE = 5
ACC = 32766
IN        _#_#_#
DN        ###___
OV        ___###
UN        ______",
        "\
PRE = 0
ACC = -32768
IN        _#
DN        __
OV        __
ACC+32768 01",
        "\
SIZE = DINT
PRE = 5
ACC = 32766
IN        _#_#
DN        ####
OV        ____
ACC-32760 6778",
        "\
PRE = -1
IN _
DN #",
    ],
};

/// The down counter of Allen-Bradley.
pub const AB_CTD: Block = Block {
    name: "AB_CTD",
    title: "down counter of Allen-Bradley",
    doc: "ACC counts down with each rise of the power; DN is on while ACC is PRE or more, also \
          without power. From its smallest value ACC goes on with its largest: that clears OV if \
          it is on, else it sets UN. CD follows the power. A power that is on in the first scan \
          does not count. The power goes on to the right as it is: there is no Q. PRE and ACC may \
          be assigned anywhere. An AB_CTU may be called on the same instance, without arguments. (R \
          name) is RES: it puts ACC and all bits to 0, CU and CD among them, so that a held power \
          counts once more. Source: Rockwell Automation, SLC 500 Instruction Set and Logix 5000 \
          General Instructions, CTD and RES.",
    settings: &[ab::SIZE],
    ports: &ports(false),
    main: None,
    partner: Some("AB_CTU"),
    can_reset: true,
    keeps: |_| Some(&[]),
    step: count_down,
    build: build_down,
    waves: &[
        "\
PRE = 1
ACC = 2
IN    _#_##_#
CD    _#_##_#
DN    ###____
ACC+1 3221110",
        "\
PRE = 1
ACC = 2
IN    ##_#
CD    ##_#
DN    ####
ACC   2221",
        "\
PRE = 5
ACC = -32767
IN _#_#_
DN ___##
UN ___##
OV _____",
        "\
PRE = 2
ACC = 3
IN    ###
(R)   _#_
CD    #_#
DN    #__
ACC+1 410",
        "\
SIZE = DINT
PRE = 5
ACC = -32767
IN        _#_#
UN        ____
ACC+32770 3221",
    ],
};

/// The ports of both, of which one call writes its own half.
const fn ports(up: bool) -> [Port; 9] {
    const fn half(mine: bool, name: &'static str, doc: &'static str) -> Port {
        let port = Port::shared(name, Type::Bool, true, doc);
        if mine { port } else { Port { role: PortRole::Idle { shown: true }, ..port } }
    }
    const fn memory(mine: bool, name: &'static str) -> Port {
        let port = Port::shared(name, Type::Bool, false, "the power at the call before");
        // An input that is on in the first scan has not come on; after RES it comes on anew.
        let port = port.starting_at(Start::Value(1)).cleared_to(0);
        if mine { port } else { Port { role: PortRole::Idle { shown: false }, ..port } }
    }
    [
        Port::loaded("PRE", COUNTS, "the count at which DN comes on; negative acts as 0")
            .of_type("SIZE"),
        Port::accumulator("ACC", Some((LOWEST, HIGHEST)), "the count").of_type("SIZE"),
        half(up, "CU", "the power at the AB_CTU"),
        half(!up, "CD", "the power at the AB_CTD"),
        Port::shared("DN", Type::Bool, true, "the count is PRE or more"),
        Port::shared("OV", Type::Bool, true, "the count has gone past its largest value"),
        Port::shared("UN", Type::Bool, true, "the count has gone past its smallest value"),
        memory(up, "was_up"),
        memory(!up, "was_down"),
    ]
}

fn count_up(call: &mut Step) {
    let (lowest, highest) = call.shape.ty("ACC").range();
    if call.power && !call.is_on("was_up") {
        if call.get("ACC") < highest {
            call.set("ACC", call.get("ACC") + 1);
        } else {
            call.set("ACC", lowest);
            if call.is_on("UN") {
                call.set("UN", 0);
            } else {
                call.set("OV", 1);
            }
        }
    }
    call.set("CU", call.power);
    call.set("was_up", call.power);
    call.set("DN", call.get("ACC") >= call.preset("PRE"));
}

fn count_down(call: &mut Step) {
    let (lowest, highest) = call.shape.ty("ACC").range();
    if call.power && !call.is_on("was_down") {
        if call.get("ACC") > lowest {
            call.set("ACC", call.get("ACC") - 1);
        } else {
            call.set("ACC", highest);
            if call.is_on("OV") {
                call.set("OV", 0);
            } else {
                call.set("UN", 1);
            }
        }
    }
    call.set("CD", call.power);
    call.set("was_down", call.power);
    call.set("DN", call.get("ACC") >= call.preset("PRE"));
}

fn build_up(logic: &mut Logic) {
    let (power, count) = (logic.power, logic.get("ACC"));
    let rise = logic.rise(power, "was_up");
    let counted = logic.count_up(count, rise);
    let (_, highest) = logic.shape.ty("ACC").range();
    finish(logic, rise, counted, highest, ["OV", "UN"]);
    logic.set("CU", power);
    logic.set("was_up", power);
}

fn build_down(logic: &mut Logic) {
    let (power, count) = (logic.power, logic.get("ACC"));
    let rise = logic.rise(power, "was_down");
    let counted = logic.count_down(count, rise);
    let (lowest, _) = logic.shape.ty("ACC").range();
    finish(logic, rise, counted, lowest, ["UN", "OV"]);
    logic.set("CD", power);
    logic.set("was_down", power);
}

/// The new count, and what a step from `end` on does to the two bits: it clears the second if that
/// is on, else it sets the first.
fn finish(logic: &mut Logic, rise: Net, counted: Net, end: i64, [past, back]: [&str; 2]) {
    let (count, end, preset) = (logic.get("ACC"), logic.constant("ACC", end), logic.preset("PRE"));
    let is_end = logic.circuit.eq(count, end);
    let wraps = logic.circuit.and([rise, is_end]);
    let (was_past, was_back) = (logic.get(past), logic.get(back));
    let not_back = logic.circuit.not(was_back);
    let goes_past = logic.circuit.and([wraps, not_back]);
    let is_past = logic.circuit.or([was_past, goes_past]);
    let stays = logic.circuit.not(wraps);
    let is_back = logic.circuit.and([was_back, stays]);
    let done = logic.reached(counted, preset);
    logic.set("ACC", counted);
    logic.set(past, is_past);
    logic.set(back, is_back);
    logic.set("DN", done);
}
