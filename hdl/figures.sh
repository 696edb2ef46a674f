#!/usr/bin/env bash
# Prints what the ladder processor takes on an iCE40 HX8K: cells, block RAM and the fastest clock.
# Needs yosys and nextpnr-ice40.
set -euo pipefail
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

figures() { # title, then parameters as NAME VALUE
  local title=$1
  shift
  local parameters=""
  while [ $# -gt 0 ]; do
    parameters+="chparam -set $1 $2 ladder_processor; "
    shift 2
  done
  yosys -q -p "read_verilog *.v; ${parameters}synth_ice40 -top ladder_processor -json $folder/a.json;
    tee -q -o $folder/stat.txt stat"
  nextpnr-ice40 -q --hx8k --package ct256 --json "$folder/a.json" --freq 100 \
    --timing-allow-fail --pcf-allow-unconstrained --log "$folder/log.txt"
  echo "$title"
  grep -E "SB_LUT4|SB_RAM40_4K|SB_DFF" "$folder/stat.txt"
  grep "Max frequency" "$folder/log.txt" | tail -1
}

figures "contacts, coils, stacks and bus, 8 inputs and outputs" FUNCTIONS 0 INPUTS 8 OUTPUTS 8
figures "with all functions, 8 inputs and outputs" INPUTS 8 OUTPUTS 8
