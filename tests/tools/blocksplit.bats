# blocksplit: a graph in, four-sided blocks out.
load common

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
}

setup() {
  common_setup
  sep=$BATS_FILE_TMPDIR/half_disc.sep.json
}

@test "writes blocks silently" {
  run blocksplit "$sep" -o a.blocks.h5
  assert_success
  assert_output ""
  assert_nothing_left a.blocks.h5
  run stagecheck a.blocks.h5
  assert_success
}

@test "the half disc has four blocks and two irregular nodes" {
  blocksplit "$sep" -o a.blocks.h5 --report a.json
  run jq -c '[.blocks, .irregular_nodes, .least_jacobian_bound > 0]' a.json
  assert_output '[4,2,true]'
}

@test "measures every block and tells the worst" {
  blocksplit -v "$sep" -o a.blocks.h5 --report a.json 2>err
  assert_equal "$(wc -l <err)" 1
  grep -E '^blocksplit: 4 blocks, least scaled Jacobian 0\.81 \(block [0-9] near \(.*\)\), smallest block [0-9]: a side of .* near \(.*\) (at|between) ' err
  h5dump -d /block_scaled_jacobian -d /block_boundary_distance a.blocks.h5 | grep -c 'DATASPACE.*( 4 )' | grep -x 2
  jq -e '.least_scaled_jacobian > 0.8 and .greatest_boundary_distance < 1e-8 and .proved.as_one_quad == 4
    and .blocks_added_to_mend == 0 and (.least_scaled_jacobian_place | length) == 2
    and .smallest_block.shortest_side > 0.2 and (.smallest_block.first.curve | type) == "number"' a.json
}

@test "gives the same bytes through pipes and twice" {
  blocksplit "$sep" -o a.blocks.h5
  blocksplit < "$sep" > b.blocks.h5
  cat "$sep" | blocksplit - -o c.blocks.h5
  cmp a.blocks.h5 b.blocks.h5
  cmp a.blocks.h5 c.blocks.h5
}

@test "a face that is not four-sided ends with 1 and its place, and no file" {
  jq '.arcs |= map(select(.is_boundary)) | .lines = []' "$sep" > open.sep.json  # nothing divides the half disc
  run blocksplit open.sep.json -o a.blocks.h5
  assert_failure 1
  assert_output --regexp '^blocksplit: .*four corners.*\(.*\)'
  assert_nothing_left open.sep.json
}

@test "other input ends with 3" {
  echo '{}' > empty.json
  run blocksplit empty.json -o a.blocks.h5
  assert_failure 3
  run blocksplit "$DATA/square.step" -o a.blocks.h5
  assert_failure 3
  run blocksplit nowhere.sep.json -o a.blocks.h5
  assert_failure 3
  assert_not_exists a.blocks.h5
}

@test "an unknown option ends with 2" {
  run blocksplit --sizes 3 "$sep" -o a.blocks.h5
  assert_failure 2
}

@test "an output that cannot be written ends with 4" {
  run blocksplit "$sep" -o nowhere/a.blocks.h5
  assert_failure 4
}
