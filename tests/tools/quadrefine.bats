# quadrefine: blocks in, curved quads out.
load common

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
}

setup() {
  common_setup
  blocks=$BATS_FILE_TMPDIR/half_disc.blocks.h5
}

@test "writes a mesh silently" {
  run quadrefine "$blocks" -o a.quad.h5
  assert_success
  assert_output ""
  assert_nothing_left a.quad.h5
  run stagecheck a.quad.h5
  assert_success
}

@test "gives the same bytes through pipes and twice" {
  quadrefine --size 0.2 "$blocks" -o a.quad.h5
  quadrefine --size 0.2 < "$blocks" > b.quad.h5
  cmp a.quad.h5 b.quad.h5
}

@test "half the size gives about four times the quads" {
  quadrefine --size 0.2 "$blocks" -o a.quad.h5 --report a.json
  quadrefine --size 0.1 "$blocks" -o b.quad.h5 --report b.json
  run jq -n 'input.quads as $a | input.quads as $b | $b / $a | . > 3 and . < 5' a.json b.json
  assert_output true
}

@test "every element is proved valid at every order" {
  for order in 1 2 4 8 12; do
    quadrefine --order $order --geometry-tol 1e-4 "$blocks" -o a.quad.h5 --report a.json
    run jq '.least_jacobian_bound > 0 and .least_scaled_jacobian > 0.3' a.json
    assert_output true
  done
}

@test "a size that asks for too many elements ends with 1 and a place" {
  run quadrefine --size 1e-7 "$blocks" -o a.quad.h5
  assert_failure 1
  assert_output --partial "("
  assert_nothing_left
}

@test "numbers outside their interval end with 2" {
  for option in "--order 0" "--order 21" "--order x" "--size -1" "--geometry-tol 0"; do
    run quadrefine $option "$blocks" -o a.quad.h5
    assert_failure 2
  done
  assert_nothing_left
}

@test "other input ends with 3" {
  run quadrefine "$BATS_FILE_TMPDIR/half_disc.sep.json" -o a.quad.h5
  assert_failure 3
  head -c 2000 "$blocks" > cut.blocks.h5
  run quadrefine cut.blocks.h5 -o a.quad.h5
  assert_failure 3
  assert_not_exists a.quad.h5
}

@test "an output that cannot be written ends with 4" {
  run quadrefine "$blocks" -o nowhere/a.quad.h5
  assert_failure 4
}

@test "layers along a wall: the report says what was made" {
  quadrefine --wall curve_0:first=1e-3,growth=1.3,layers=6 "$blocks" -o a.quad.h5 --report a.json
  run jq -c '.walls["0"] | [.names, .layers, .first, (.thickness * 1e6 | round)]' a.json
  assert_output '["curve_0",6,0.001,12756]'
  run jq '.least_jacobian_bound > 0' a.json
  assert_output true
  run stagecheck a.quad.h5
  assert_success
}

@test "a boundary may be named by its number, and several at once" {
  quadrefine --wall curve_0,curve_1:first=1e-3,layers=4 "$blocks" -o a.quad.h5
  quadrefine --wall 0,1:first=1e-3,layers=4 "$blocks" -o b.quad.h5 --report b.json
  run jq -r '.walls["0"].names' b.json
  assert_output 0,1
  quadrefine --wall 0:first=1e-3,layers=4 --wall 1:first=2e-3,layers=fit "$blocks" -o c.quad.h5 --report c.json
  run jq '.walls["1"].layers > 10' c.json
  assert_output true
}

@test "walls that no boundary has, or that make no sense, end with 2" {
  run quadrefine --wall roof:first=1e-3,layers=4 "$blocks" -o a.quad.h5
  assert_failure 2
  assert_output --partial roof
  assert_output --partial curve_1
  for wall in curve_0 curve_0:layers=4 curve_0:first=1e-3 curve_0:first=0,layers=4 curve_0:first=x,layers=4 \
    curve_0:first=1e-3,layers=0 curve_0:first=1e-3,layers=4,growth=3 curve_0:first=1e-3,layers=4,law=cubic; do
    run quadrefine --wall "$wall" "$blocks" -o a.quad.h5
    assert_failure 2
    assert_output --partial "$wall"
  done
  assert_nothing_left
}

@test "layers that do not fit end with 1, a place and the largest number that does" {
  run quadrefine --wall curve_0:first=1e-2,layers=60 "$blocks" -o a.quad.h5
  assert_failure 1
  assert_output --regexp 'curve_0.*\(-?[0-9.e-]+, -?[0-9.e-]+\).*at most [0-9]+ do, with a thickness of [0-9.]+'
  assert_nothing_left
  most=$(sed -E 's/.*at most ([0-9]+) do.*/\1/' <<< "$output")
  quadrefine --wall "curve_0:first=1e-2,layers=$most" "$blocks" -o a.quad.h5
  run quadrefine --wall "curve_0:first=1e-2,layers=$((most + 1))" "$blocks" -o b.quad.h5
  assert_failure 1
}
