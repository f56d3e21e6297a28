# Damaged stage files through every tool that reads them (tests/stress/damaged_files).
# All 10,000: tests/stress/damaged_files --count 10000 --jobs 2 -o tests/benchmarks/results/damaged_files.json
load ../tools/common

damaged_files() {
  "$ROOT/tests/stress/damaged_files" --bin "$BIN" "$@"
}

@test "100 damaged files: 0, 1 or 3, below 500 MB and 20 s" {
  run -0 damaged_files --count 100 --jobs 2
  assert_output --regexp '(99|1[0-9][0-9]) damaged files, [34][0-9][0-9] runs, 0 failures; at most '
}

@test "500 damaged files, bytes and values: every tool ends with 0, 1 or 3 and leaves nothing behind" {
  [[ -n ${QUADRILLE_LONG-} ]] || skip "long: part of tests/run --all"
  run damaged_files --count 500
  assert_success
  assert_output --regexp '[45][0-9][0-9] damaged files, 1[0-9]+ runs, 0 failures'
}

@test "damage: the same every time, of values with the right checksum" {
  run -0 damaged_files -v field_0001 crit_0002 quad_0003
  grep -oE '^[a-z]+_[0-9]+ \(.*\): [0-9]' <<<"$output" >first
  run -0 damaged_files -v field_0001 crit_0002 quad_0003
  grep -oE '^[a-z]+_[0-9]+ \(.*\): [0-9]' <<<"$output" >second
  diff first second
  stage_chain square
  for seed in 1 2 3; do
    run -0 "$BIN/damage_hdf5" square.quad.h5 $seed damaged.quad.h5
    run stagecheck damaged.quad.h5
    refute_output --partial checksum
    run ! cmp -s square.quad.h5 damaged.quad.h5
  done
}

@test "a tool that crashes, or leaves a file behind, is a failure" {
  mkdir bin
  ln -s "$BIN"/* bin/
  rm bin/stageview
  printf '#!/bin/sh\nkill -SEGV $$\n' >bin/stageview
  chmod +x bin/stageview
  run -1 "$ROOT/tests/stress/damaged_files" --bin bin crit_0000
  assert_output --partial "ended with -11"
  printf '#!/bin/sh\ntouch "$TMPDIR/left"; echo "stageview: no" >&2; exit 3\n' >bin/stageview
  run -1 "$ROOT/tests/stress/damaged_files" --bin bin crit_0000
  assert_output --partial "left behind left"
}
