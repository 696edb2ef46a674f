#!/usr/bin/env bash
# Prints what the ladder processor takes on an iCE40 HX8K: cells, block RAM and the fastest clock.
# Needs yosys and nextpnr-ice40.
set -euo pipefail
cd "$(dirname "$0")"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

figures() { # title, then parameters as NAME VALUE
  local title=$1 parameters=""
  shift
  while [ $# -gt 0 ]; do
    parameters+="chparam -set $1 $2 ladder_processor; "
    shift 2
  done
  yosys -q -p "read_verilog *.v; ${parameters}synth_ice40 -top ladder_processor -json $folder/a.json;
    tee -q -o $folder/stat.txt stat" 2>"$folder/errors.txt" || { cat "$folder/errors.txt" >&2; exit 1; }
  nextpnr-ice40 -q --hx8k --package ct256 --json "$folder/a.json" --freq 100 \
    --timing-allow-fail --pcf-allow-unconstrained --log "$folder/log.txt" 2>/dev/null
  count() { awk -v kind="$1" '$1 ~ kind { sum += $2 } END { print sum + 0 }' "$folder/stat.txt"; }
  local clock
  clock=$(grep "Max frequency" "$folder/log.txt" | tail -1 | sed 's/.*: \([0-9]*\)\..*/\1/')
  printf '| %-44s | %4d | %9d | %9d | %4d MHz |\n' \
    "$title" "$(count SB_LUT4)" "$(count SB_DFF)" "$(count SB_RAM40_4K)" "$clock"
}

# Contacts, coils, stacks, image and host bus; then with some of the functions.
with() { # title, then 1 or 0 for timers, counters, drums, shifts, bits
  figures "$1" INPUTS 8 OUTPUTS 8 TIMERS "$2" COUNTERS "$3" DRUMS "$4" SHIFTS "$5" BITS "$6"
}

printf '| %-44s | %4s | %9s | %9s | %8s |\n' "eight inputs and outputs" LUT4 flip-flops "block RAM" clock
echo "|---|---|---|---|---|"
with "contacts, coils, stacks, image, host bus" 0 0 0 0 0
with "and bits of registers"                    0 0 0 0 1
with "and 64 timers"                            1 0 0 0 0
with "and 64 counters"                          0 1 0 0 0
with "and 16 drums"                             0 0 1 0 0
with "and shifts over 32 registers"             0 0 0 1 0
with "and timers and counters"                  1 1 0 0 0
with "with all functions"                       1 1 1 1 1
