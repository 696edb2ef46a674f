#!/bin/sh
# What a division in one clock costs on an iCE40 HX8K: logic cells and clock, by Yosys and nextpnr.
# Run it in the root of the repository: benches/divide.sh
set -eu
cargo build --quiet
hotrail=$PWD/target/debug/hotrail
folder=$(mktemp -d)
cd "$folder"
for type in UINT INT UDINT DINT; do
  for operation in '+ b' '* b' '/ b' 'MOD b' '/ 10' 'MOD 10' '/ 8' 'MOD 8'; do
    cat > divide.ladder <<END
ladder divide
input a, b : $type
output q : $type
var x, y : $type
rung { q := x $(echo "$operation" | tr b y) }
rung { x := a } { y := b }
END
    "$hotrail" build divide.ladder -o . --emit verilog --force > log 2>&1
    yosys -q -p 'read_verilog divide.v; synth_ice40 -top divide -json divide.json' >> log 2>&1
    nextpnr-ice40 --hx8k --package ct256 --pcf-allow-unconstrained --freq 1 --seed 1 \
      --json divide.json > log 2>&1
    cells=$(grep -o 'ICESTORM_LC: *[0-9]*' log | tail -1 | grep -o '[0-9]*$')
    clock=$(sed -n 's/.*Max frequency for clock.*: \([0-9.]*\) MHz.*/\1/p' log | tail -1)
    printf '%-6s a %-7s %6s cells %8s MHz\n' "$type" "$operation" "$cells" "$clock"
  done
done
rm -r "$folder"
