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

# regions FILE: each name once, on one line.
regions() {
  h5dump -y -A 0 -d /block_names "$1" | sed '1,/DATA {/d' | grep -o '"[^"]*"' | sed 's/\\000//g' | sort | uniq -c | tr -s ' \n' '  '
}

@test "--block-names names blocks by number, by a point inside and all at once" {
  echo '[{"at": [0, 0.2], "name": "core"}, {"id": "*", "name": "ring"}]' > names.json
  blocksplit "$sep" --block-names names.json -o a.blocks.h5
  assert_equal "$(regions a.blocks.h5)" ' 1 "core" 3 "ring" '
  run stagecheck a.blocks.h5
  assert_success
  quadrefine a.blocks.h5 | quadexport -o a.msh
  assert_equal "$(grep -cE '^2 [0-9]+ "(core|ring)"$' a.msh)" 2
  echo '"fluid"' | blocksplit "$sep" --block-names - -o b.blocks.h5
  assert_equal "$(regions b.blocks.h5)" ' 4 "fluid" '
  quadrefine b.blocks.h5 | quadexport -o b.msh
  assert_equal "$(grep -cE '^2 [0-9]+ "' b.msh)" 1
}

@test "blocks are called as the face is" {
  jq '.face.name = "air"' "$sep" > named.sep.json
  blocksplit named.sep.json -o a.blocks.h5
  assert_equal "$(regions a.blocks.h5)" ' 4 "air" '
  echo '{"1": "solid"}' | blocksplit named.sep.json --block-names - -o a.blocks.h5
  assert_equal "$(regions a.blocks.h5)" ' 3 "air" 1 "solid" '
}

@test "names that fit no block or one twice end with 3 and say where" {
  refused() {
    echo "$1" > names.json
    run -3 blocksplit "$sep" --block-names names.json -o a.blocks.h5
    assert_output --partial "blocksplit: names.json: $2"
  }
  refused '{"4": "x"}' '"4": no block has this number; blocks are numbered 0 to 3'
  refused '{"core": "x"}' '"core": must be the number of a block'
  refused '[{"at": [2, 0], "name": "x"}]' 'entry 0: (2, 0) lies in no block'
  refused '[{"at": [0, 0], "name": "x"}]' 'entry 0: (0, 0) lies on a side of block'
  refused '[{"at": [0, 0.2], "name": "x"}, {"at": [0.01, 0.2], "name": "x"}]' 'entry 1 names block'
  refused '[{"near": [0, 0.2], "name": "x"}]' 'entry 0: "near" is not one of "id", "at", and "name"'
  assert_nothing_left names.json
}
