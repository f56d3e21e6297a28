# Loaded by every Bats file: `load common` in tests/tools, `load ../tools/common` elsewhere.
#
#   $ROOT  the project       $BIN   the folder of the tools, also first on PATH; $QUADRILLE_BIN overrides build/bin
#   $DATA  tests/data        each test starts in an empty folder of its own, removed when it has passed
bats_require_minimum_version 1.5.0
bats_load_library bats-support
bats_load_library bats-assert
bats_load_library bats-file

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
BIN=${QUADRILLE_BIN:-$ROOT/build/bin}
DATA=$ROOT/tests/data
PATH=$BIN:$PATH
export ROOT BIN DATA PATH LC_ALL=C PYTHONDONTWRITEBYTECODE=1

# Not BATS_TEST_TMPDIR itself, where Bats leaves files of its own.
common_setup() {
  mkdir "$BATS_TEST_TMPDIR/here" && cd "$BATS_TEST_TMPDIR/here" || return 1
}

# A file with a setup of its own calls common_setup in it.
setup() {
  common_setup
}

need_h5py() { /usr/bin/python3 -c 'import numpy, h5py' || skip "no numpy or h5py: apt-get install python3-h5py"; }

# stage_chain SHAPE [FOLDER]: runs the chain with default settings on tests/data/SHAPE.step, through files SHAPE.tri.h5
# ... SHAPE.msh in FOLDER (default: the current one). For a setup_file: stage_chain half_disc "$BATS_FILE_TMPDIR".
stage_chain() {
  local x=${2:-.}/$1
  cad2tri "$DATA/$1.step" -o "$x.tri.h5" &&
    fieldsolve "$x.tri.h5" -o "$x.solve.h5" &&
    padapt "$x.solve.h5" -o "$x.field.h5" &&
    critpoints "$x.field.h5" -o "$x.crit.json" &&
    separatrix "$x.field.h5" "$x.crit.json" -o "$x.sep.json" &&
    blocksplit "$x.sep.json" -o "$x.blocks.h5" &&
    quadrefine "$x.blocks.h5" -o "$x.quad.h5" &&
    quadexport "$x.quad.h5" -o "$x.msh"
}

# stage_blocks FOLDER SHAPE...: the files of tests/data/SHAPE.step that lead to SHAPE.blocks.h5, without x.tri.h5 and
# x.solve.h5.
stage_blocks() {
  local shape x
  for shape in "${@:2}"; do
    x=$1/$shape
    cad2tri -q "$DATA/$shape.step" | fieldsolve -q | padapt -q -o "$x.field.h5" &&
      critpoints -q "$x.field.h5" -o "$x.crit.json" &&
      separatrix -q "$x.field.h5" "$x.crit.json" -o "$x.sep.json" &&
      blocksplit -q "$x.sep.json" -o "$x.blocks.h5" || return
  done
}

# blocks_of_size SHAPE PARTS: SHAPE.blocks.h5 of tests/data/SHAPE.step, and $size, its diameter over PARTS.
blocks_of_size() {
  "$ROOT/pipelines/quadmesh" -q "$DATA/$1.step" --until blocksplit --workdir . &&
    size=$(jq ".face.diameter / $2" "$1.sep.json")
}

# replace_tool TOOL LINE...: makes fake/, a folder of the tools in which TOOL is a script of these lines.
replace_tool() {
  local tool
  mkdir fake
  for tool in "$BIN"/*; do [[ $tool == */unit_* || $tool == */"$1" ]] || ln -s "$tool" fake; done
  printf '%s\n' '#!/bin/sh' "${@:2}" >"fake/$1"
  chmod +x "fake/$1"
}

# replace_stage STAGE LINE...: adds to $replaced the option with which quadmesh runs a script of these lines, in the folder
# fake, in place of the stage.
replace_stage() {
  mkdir -p fake
  printf '%s\n' '#!/bin/bash' "${@:2}" >"fake/$1"
  chmod +x "fake/$1"
  replaced+=("--stage=$1=fake/$1")
}

# ends_with_signal COMMAND...: ends with 143 after SIGTERM, sent when the file `started` exists, and leaves nothing but
# what is removed here.
ends_with_signal() {
  TMPDIR=$PWD "$@" 3>&- &
  local pid=$! code=0
  until [[ -e started ]]; do sleep 0.05; done
  kill -TERM $pid
  wait $pid || code=$?
  assert_equal $code 143
  rm -r fake started
  assert_equal "$(find . -mindepth 1)" ""
}

# assert_nothing_left [NAME...]: the current folder holds these files and nothing else, hidden ones included.
assert_nothing_left() {
  assert_equal "$(find . -mindepth 1 | sed 's|^\./||' | sort)" "$( (($#)) && printf '%s\n' "$@" | sort)"
}

# assert_on_space_curves FILE: the nodes of a mesh on a curved face that are on boundaries and interfaces lie on their
# curves in space.
assert_on_space_curves() {
  run -0 "$ROOT/tests/cases/nodes_on_space_curves.py" "$1"
  run -0 awk '$NF > 1e-12 { print }' <<<"$output"
  assert_output ''
}

# reported_loss REPORT PATTERN: the share of the diameter by which the report says that what PATTERN names is moved; 0 for
# none.
reported_loss() {
  jq -r --arg what "$2" '[.warnings[].message | select(test($what)) | capture("\\((?<x>\\S+) of the diameter").x][0] // "0"' "$1"
}

# each_motion SHAPE.step COMMAND...: for each line of standard input, options of move_step.py, calls COMMAND with them
# behind; moved.step is the shape after that motion.
each_motion() {
  local motion
  while read -r motion; do
    # shellcheck disable=SC2086  # a list of words
    "$DATA/move_step.py" $motion "$1" moved.step
    # shellcheck disable=SC2086
    "${@:2}" $motion
  done
}
