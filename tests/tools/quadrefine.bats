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

@test "a size that asks for too many elements ends with 1 and a remedy" {
  run quadrefine --size 1e-7 "$blocks" -o a.quad.h5
  assert_failure 1
  assert_output --partial "raise --size by a factor of"
  assert_nothing_left
}

@test "numbers outside their interval end with 2" {
  for option in "--order 0" "--order 21" "--order x" "--size -1" "--geometry-tol -1"; do
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
  quadrefine --size-near 'curve_*=0.05' "$blocks" -o c.quad.h5
  quadrefine --size-near curve_0=0.05 --size-near curve_1=0.05 "$blocks" -o d.quad.h5
  cmp <(h5dump -d /nodes c.quad.h5 | sed 1d) <(h5dump -d /nodes d.quad.h5 | sed 1d)
  quadrefine --wall 'box(-2,-1,2,0):first=0.01,layers=3' "$blocks" -o c.quad.h5
  quadrefine --wall curve_0:first=0.01,layers=3 "$blocks" -o d.quad.h5
  cmp <(h5dump -d /nodes c.quad.h5 | sed 1d) <(h5dump -d /nodes d.quad.h5 | sed 1d)
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
  assert_output --regexp 'curve_0.*\(-?[0-9.e-]+, -?[0-9.e-]+\).*at most [0-9]+ fit, with a thickness of [0-9.]+'
  assert_nothing_left
  most=$(sed -E 's/.*at most ([0-9]+) fit.*/\1/' <<< "$output")
  quadrefine --wall "curve_0:first=1e-2,layers=$most" "$blocks" -o a.quad.h5
  run quadrefine --wall "curve_0:first=1e-2,layers=$((most + 1))" "$blocks" -o b.quad.h5
  assert_failure 1
}

@test "--target-growth limits the ratio of adjacent edges from wall to wall" {
  quadrefine --size 0.2 --wall curve_0,curve_1:first=1e-3,layers=8 --target-growth 0 "$blocks" -o a.quad.h5
  quadrefine --size 0.2 --wall curve_0,curve_1:first=1e-3,layers=8 "$blocks" -o b.quad.h5 --report b.json
  run jq '.growth.greatest <= 1.3001 and .growth.greatest < .growth.greatest_before and .valid' b.json
  assert_output true
  wall_heights a.quad.h5 1e-3 8 curve_0 curve_1 > a.heights.json
  wall_heights b.quad.h5 1e-3 8 curve_0 curve_1 > b.heights.json
  run jq -n 'input.growth_with_corners as $a | input.growth_with_corners as $b | $b < 1.4 and $b < $a' \
    a.heights.json b.heights.json
  assert_output true
}

@test "sizes near a boundary are met there and grow away from it" {
  quadrefine --size 0.3 "$blocks" -o a.quad.h5 --report a.json
  quadrefine --size 0.3 --size-near curve_0=0.03 "$blocks" -o b.quad.h5 --report b.json
  run jq -n 'input.quads as $a | input.quads as $b | $b > 3 * $a' a.json b.json
  assert_output true
  run jq '.least_jacobian_bound > 0 and .sizes.least_edge < 0.033 and .sizes.greatest_edge > 0.1' b.json
  assert_output true
  run stagecheck b.quad.h5
  assert_success
  quadrefine --size 0.3 --size-near curve_0=0.03 --growth 2 "$blocks" -o c.quad.h5 --report c.json
  run jq -n 'input.quads as $b | input.quads as $c | $c < $b' b.json c.json
  assert_output true
}

@test "boundaries may be named by their number; the same sizes give the same bytes" {
  quadrefine --size-near curve_0=0.05 --size-near curve_1=0.04 "$blocks" -o a.quad.h5
  quadrefine --size-near 1=0.04 --size-near 0=0.05 "$blocks" -o b.quad.h5
  h5diff a.quad.h5 b.quad.h5 /nodes
  quadrefine --size-near curve_0=0.05 --size-near curve_1=0.04 < "$blocks" > c.quad.h5
  cmp a.quad.h5 c.quad.h5
}

@test "sizes from a file: points and boxes, and the digest in the provenance" {
  sed -n '/^```json$/,/^```$/p' "$ROOT/formats/size-field.md" | sed '1d;$d' |
    jq '.points[0].position = [0, 0.3] | .boxes[0] |= {low: [-0.2, 0.4], high: [0.2, 0.6], size: 0.04}' > sizes.json
  quadrefine --size-field sizes.json "$blocks" -o a.quad.h5 --report a.json
  run jq '.quads > 500 and .least_jacobian_bound > 0' a.json
  assert_output true
  run h5dump -a /provenance a.quad.h5
  assert_output --partial "$(sha256sum sizes.json | cut -d' ' -f1)"
}

@test "a file that is no size field ends with 3 and the place in it" {
  for edit in '.points[0].size = 0' 'del(.points[0].position)' '.growth = 1' '.format = "field"' '.version = [2, 0]'; do
    sed -n '/^```json$/,/^```$/p' "$ROOT/formats/size-field.md" | sed '1d;$d' | jq "$edit" > sizes.json
    run quadrefine --size-field sizes.json "$blocks" -o a.quad.h5
    assert_failure 3
    assert_output --partial sizes.json
  done
  echo '{"format": "size-field", "version": [1, 0], "points": [{"position": [0, 0], "size": 1},' > sizes.json
  run quadrefine --size-field sizes.json "$blocks" -o a.quad.h5
  assert_failure 3
  assert_output --partial "line 2"
  echo '{"format": "size-field", "version": [1, 0], "points": [{"position": [0, 0], "size": "small"}]}' > sizes.json
  run quadrefine --size-field sizes.json "$blocks" -o a.quad.h5
  assert_failure 3
  assert_output --partial "points[0].size"
  run quadrefine --size-field nowhere.json "$blocks" -o a.quad.h5
  assert_failure 3
  assert_nothing_left sizes.json
}

@test "elements per turn follow the curvature" {
  for turn in 30 60; do
    quadrefine --size 1 --curvature $turn "$blocks" -o a.quad.h5 --report $turn.json
  done
  # The half disc has radius 1: its arc wants edges of 2 pi / 60.
  run jq -n 'input.quads as $a | input.quads as $b | $b > 1.5 * $a' 30.json 60.json
  assert_output true
  run jq '.sizes.least_ratio > 0.19 and .sizes.least_edge < 0.105' 60.json
  assert_output true
}

@test "a chord gets the count that is asked for" {
  quadrefine --size 0.2 --size-rule nearest "$blocks" -o a.quad.h5 --report a.json
  quadrefine --size 0.2 --size-rule nearest --count 0=17 --count 1=9 "$blocks" -o b.quad.h5 --report b.json
  run jq -n -c 'input.sizes.chord.count as $a | input.sizes.chord.count | [.[0], .[1], .[2:] == $a[2:]]' a.json b.json
  assert_output '[17,9,true]'
  chords=$(jq .chords a.json)
  run jq -c '[.sizes.chord[] | length] | unique' a.json
  assert_output "[$chords]"
  run quadrefine --count "$chords=3" "$blocks" -o c.quad.h5
  assert_failure 2
  assert_output --partial "numbered 0 to $((chords - 1))"
}

@test "a count that misses the tolerance rises with a warning" {
  quadrefine --count 0=1 --count 1=1 --count 2=1 --geometry-tol 1e-9 "$blocks" -o a.quad.h5 --report a.json 2> messages
  run jq '[.warnings[] | select(.code == "W-QUA-002")] | length > 0' a.json
  assert_output true
  grep -q "not the prescribed 1" messages
}

@test "edges deviate least, or are nowhere longer than wanted" {
  quadrefine --size 0.11 "$blocks" -o a.quad.h5 --report a.json
  quadrefine --size 0.11 --size-rule at-most "$blocks" -o b.quad.h5 --report b.json
  run jq '.sizes.greatest_ratio <= 1 and .sizes.mean_ratio < 1' b.json
  assert_output true
  run jq -n 'input.sizes as $a | input.sizes as $b | $a.deviation < $b.deviation' a.json b.json
  assert_output true
  run jq '.sizes.mean_ratio > 0.9 and .sizes.mean_ratio < 1.1' a.json
  assert_output true
}

@test "counts by the error lower the resolution ratio at the number of elements of the nearest counts" {
  quadrefine --size-rule nearest "$blocks" -o a.quad.h5 --report a.json
  quadrefine "$blocks" -o b.quad.h5 --report b.json
  quadrefine --count 0=9 "$blocks" -o c.quad.h5 --report c.json
  run jq -n 'input as $a | input as $b | input as $c | [$b.resolution.ratio < 0.9 * $a.resolution.ratio,
    ($b.quads / $a.quads | 0.94 < . and . < 1.06), $b.valid, $c.sizes.chord.count[0]]' -c a.json b.json c.json
  assert_output '[true,true,true,9]'
}

@test "mistakes in sizes end with 2" {
  run quadrefine --size-near roof=0.1 "$blocks" -o a.quad.h5
  assert_failure 2
  assert_output --partial roof
  assert_output --partial curve_0
  for option in "--size-near curve_0" "--size-near curve_0=0" "--size-near curve_0=x" "--size-near =1" "--growth 1" \
    "--growth 0.5" "--curvature -1" "--count 0" "--count 0=0" "--count x=3" "--size-rule mean"; do
    run quadrefine $option "$blocks" -o a.quad.h5
    assert_failure 2
  done
  assert_nothing_left
}

@test "the report tells the least of all elements and the worst ones with their places, -v prints them" {
  run --separate-stderr quadrefine -v "$blocks" -o a.quad.h5 --report a.json
  assert_success
  [[ $(grep -c "element .* of block_.* at (.*): scaled Jacobian" <<< "$stderr") == 5 ]]
  run jq '.valid and .unproved_elements == 0 and .least_jacobian_ratio > 0 and .least_jacobian_ratio <= 1 and
    (.worst["1"].scaled_jacobian - .least_scaled_jacobian | fabs) < 1e-6 and .mean_scaled_jacobian > .least_scaled_jacobian and
    (.worst | length) == 8 and ([.worst[].jacobian_bound] | min) >= .least_jacobian_bound and
    (.worst["1"].position | length) == 2' a.json
  assert_output true
  h5dump -d /is_valid -d /least_jacobian_bound a.quad.h5 | grep -q "(0): 1"
}

@test "an invalid mesh is written with --allow-invalid only, and says so from then on" {
  stage_chain eccentric_annulus
  ask="--order 1 --size 1000 --geometry-tol 1 eccentric_annulus.blocks.h5"
  # There would be more elements, did not every chord have a prescribed number.
  run -0 quadrefine $ask -o good.quad.h5 --report good.json
  run -0 jq -c '[.valid, .count_doublings > 0]' good.json
  assert_output '[true,true]'
  for ((chord = 0; chord < $(jq .chords good.json); ++chord)); do ask+=" --count $chord=1"; done
  run -1 quadrefine $ask -o bad.quad.h5 --report bad.json
  assert_output --partial "cannot be proved valid; the worst lies at ("
  assert_output --partial "--allow-invalid"
  assert_not_exists bad.quad.h5
  run jq '.valid == false and .unproved_elements == 1 and .worst["1"].jacobian_bound < 0' bad.json
  assert_output true

  run -0 quadrefine $ask --allow-invalid -o bad.quad.h5
  assert_output --partial "warning W-QUA-001: the mesh is not valid: 1 of 12 elements are not proved"
  run -0 stagecheck bad.quad.h5
  assert_output --partial "W-QUA-001"
  run -0 stageview bad.quad.h5 -o bad.svg
  assert_output --partial "W-QUA-001"
  grep -q "NOT VALID" bad.svg
  run -1 quadexport bad.quad.h5 -o bad.msh
  assert_output --partial "the mesh is not valid"
  assert_not_exists bad.msh
  run -0 quadexport --allow-invalid bad.quad.h5 -o bad.msh
  assert_output --partial "W-QUA-001"
  assert_exists bad.msh
}

@test "--allow-invalid changes nothing where the mesh is valid" {
  run -0 quadrefine --allow-invalid "$blocks" -o a.quad.h5
  assert_output ""
  run -0 quadexport --allow-invalid a.quad.h5 -o a.msh
  assert_output ""
}

@test "--relax shape betters elements, never the worst for worse, and gives the same bytes twice" {
  options=(--relax shape --relax-sweeps 20 --inner-edges curved)
  quadrefine "${options[@]}" "$blocks" -o a.quad.h5 --report a.json
  quadrefine "${options[@]}" "$blocks" -o b.quad.h5
  cmp a.quad.h5 b.quad.h5
  run jq '.relax.least_scaled_jacobian_before + 0.02 < .least_scaled_jacobian and
    .relax.mean_scaled_jacobian_before < .mean_scaled_jacobian and .relax.sweeps <= 20 and .least_jacobian_bound > 0' a.json
  assert_output true
  stagecheck a.quad.h5
  run -2 quadrefine --relax-sweeps -1 "$blocks" -o c.quad.h5
}

@test "--relax size, the default, makes elements more alike, twice the same; a number is answered with what it is now" {
  quadrefine "$blocks" -o a.quad.h5 --report a.json
  quadrefine --relax size "$blocks" -o b.quad.h5
  quadrefine --relax none "$blocks" -o c.quad.h5 --report c.json
  cmp a.quad.h5 b.quad.h5
  jq -e '.relax.energy_after < .relax.energy_before and .relax.sweeps > 0 and .valid' a.json
  jq -e '.relax == null' c.json
  stagecheck a.quad.h5
  run -2 quadrefine --relax 20 "$blocks" -o d.quad.h5
  assert_line --partial "--relax 20 is now --relax shape --relax-sweeps 20"
  run -2 quadrefine --relax sizes "$blocks" -o d.quad.h5
}

@test "--inner-edges: straight by default, curved as the blocks are, or fading; the boundary is the same" {
  quadrefine "$blocks" -o default.quad.h5
  for shape in straight curved fade; do quadrefine --inner-edges $shape "$blocks" -o $shape.quad.h5; done
  h5diff default.quad.h5 straight.quad.h5 /nodes
  for shape in curved fade; do run -1 h5diff -q straight.quad.h5 $shape.quad.h5 /nodes; done
  for shape in straight curved fade; do stagecheck $shape.quad.h5; done
  run -2 quadrefine --inner-edges bent "$blocks" -o x.quad.h5
  assert_output --partial "--inner-edges"
}

@test "--rings: rows around small holes in coarse meshes are thinner, and one more; none with other rules" {
  stage_chain cylinder_channel .
  blocks=cylinder_channel.blocks.h5
  for rings in auto none; do quadrefine --size 0.11 --rings $rings "$blocks" -o $rings.quad.h5 --report $rings.json; done
  quadrefine --size 0.11 "$blocks" -o default.quad.h5
  cmp default.quad.h5 auto.quad.h5
  stagecheck auto.quad.h5
  run jq -n 'input as $auto | input as $none | $auto.rings == {loop: [1], thickness: [$auto.rings.thickness[0]]} and
    ($auto.rings.thickness[0] - 0.045 | fabs) < 1e-6 and $none.rings == null and $auto.quads != $none.quads' auto.json none.json
  assert_output true
  for options in "--size 0.03" "--size 0.11 --relax none" "--size 0.11 --size-rule nearest" "--size 0.11 --blocks 0"; do
    quadrefine $options "$blocks" -o x.quad.h5 --report x.json
    jq -e '.rings == null' x.json
  done
  run -2 quadrefine --rings some "$blocks" -o x.quad.h5
  assert_output --partial "--rings"
}

@test "--blocks refines the chords through chosen blocks only" {
  quadrefine "$blocks" -o a.quad.h5 --report a.json
  quadrefine --blocks 0 "$blocks" -o b.quad.h5 --report b.json
  quadrefine --blocks block_0 "$blocks" -o c.quad.h5 --report c.json
  run jq -n 'input.quads as $all | input.quads as $some | input.quads as $same | $some < $all and $same == $some' a.json b.json c.json
  assert_output true
  stagecheck b.quad.h5
  for wrong in 99 nobody "0,,1"; do
    run -2 quadrefine --blocks "$wrong" "$blocks" -o d.quad.h5
    assert_output --partial "there is no block"
  done
  assert_not_exists d.quad.h5
}

@test "sides that elements share are the same nodes in exported text" {
  quadrefine --order 3 --size 0.3 "$blocks" -o a.quad.h5 --report a.json
  quadexport a.quad.h5 -o a.msh
  # Coordinates of all nodes: as many lines as nodes, none twice.
  sed -n '/^\$Nodes/,/^\$EndNodes/p' a.msh | awk 'NF == 3' | sort > places
  assert_equal "$(wc -l < places)" "$(jq .nodes a.json)"
  assert_equal "$(uniq -d places)" ""
}

@test "--min-scaled-jacobian and --max-edge-ratio end with 1, the place and the figure, and write nothing" {
  quadrefine "$blocks" -o a.quad.h5 --report a.json
  sj=$(jq .least_scaled_jacobian a.json)
  ratio=$(jq .greatest_edge_ratio.value a.json)
  quadrefine --min-scaled-jacobian "$sj" --max-edge-ratio "$ratio" "$blocks" -o b.quad.h5
  run -1 quadrefine --min-scaled-jacobian 0.999 "$blocks" -o c.quad.h5
  assert_output --regexp 'element [0-9]+ at \(.*\) has the scaled Jacobian 0\.[0-9]+, below --min-scaled-jacobian 0\.999'
  run -1 quadrefine --max-edge-ratio 1.01 "$blocks" -o c.quad.h5
  assert_output --regexp "element $(jq .greatest_edge_ratio.element a.json) at .* ratio [.0-9]+, above --max-edge-ratio 1\.01"
  assert_not_exists c.quad.h5
  run -2 quadrefine --max-edge-ratio 0.5 "$blocks" -o c.quad.h5
  run -2 quadrefine --target-edge-ratio 0.5 "$blocks" -o c.quad.h5
  run -2 quadrefine --min-scaled-jacobian 1.5 "$blocks" -o c.quad.h5
}

@test "a first height from y+: that of the flat plate's formula, in the unit of the file or of the mesh" {
  flow=(--velocity 30 --viscosity 1.5e-5 --length 1)
  quadrefine --wall curve_0:yplus=100,layers=4 "${flow[@]}" "$blocks" -o a.quad.h5 --report a.json
  run jq -c '[.walls["0"].first * 1e6, .flow.skin_friction * 1e6, .flow.reynolds_number] | map(round)' a.json
  assert_output '[1226,3326,2000000]'
  # The file is in millimetres: the same flow in metres has a height in metres.
  quadrefine --wall curve_0:layers=4 --yplus 0.1 --unit m "${flow[@]}" "$blocks" -o b.quad.h5 --report b.json
  run jq -n 'input.walls["0"].first / input.walls["0"].first * 1e6 | round / 1e6' a.json b.json
  assert_output 1
}

@test "outside the interval of the formula for y+ there is a warning" {
  run -0 quadrefine --wall curve_0:yplus=1,layers=2 --velocity 1 --viscosity 1e-4 --length 1 "$blocks" -o a.quad.h5
  assert_output --partial "W-SIZ-001: the Reynolds number 1e+04 lies outside"
}

@test "a boundary has elements of equal length by --count NAME=N,even, and not beside other lengths" {
  quadrefine --count curve_1=31,even "$blocks" -o a.quad.h5 --report a.json
  run jq -c '.counts["0"] | [.achieved, .unevenness < 1e-6]' a.json
  assert_output '[31,true]'
  run -0 stagecheck a.quad.h5
  quadrefine --count curve_1=31 "$blocks" -o b.quad.h5 --report b.json
  run jq -c '.counts["0"] | has("unevenness")' b.json
  assert_output false
  for other in "--size-near curve_1=0.05" "--grading curve_1=0.1:" "--wall curve_1:first=0.01,layers=2"; do
    run -2 quadrefine --count curve_1=31,even $other "$blocks" -o c.quad.h5
    assert_output --partial "${other%%[=:]*}: --count prescribes elements of equal length (even) along this boundary"
  done
}

@test "a boundary has the prescribed number of elements, and what cannot be is refused with the nearest numbers" {
  quadrefine --count curve_0=23 --count curve_1=31 "$blocks" -o a.quad.h5 --report a.json
  run jq -c '[.counts[] | [.boundary, .prescribed, .achieved]]' a.json
  assert_output '[["curve_0",23,23],["curve_1",31,31]]'
  run -0 stagecheck a.quad.h5
  run -2 quadrefine --count curve_0=1 "$blocks" -o b.quad.h5
  assert_output --regexp "--count curve_0=1: the boundary 'curve_0' cannot have 1 elements.*possible is"
  run -2 quadrefine --count hole=4 "$blocks" -o b.quad.h5
  assert_output --partial 'there is no boundary "hole"'
}

@test "a boundary that wall layers divide has the prescribed number of elements, layers included" {
  wall=curve_0:first=0.002,growth=1.2,layers=4
  for count in 60 131; do
    run quadrefine --size 0.2 --wall $wall --count curve_1=$count "$blocks" -o a.quad.h5 --report a.json
    assert_success
    refute_output --partial W-QUA-002
    run jq -c '[.counts["0"].achieved, .walls["0"].layers, .valid]' a.json
    assert_output "[$count,4,true]"
  done
  run -0 quadrefine --geometry-tol 0.1 --wall $wall --count curve_1=3 "$blocks" -o a.quad.h5 --report a.json
  least=$(jq '.counts["0"].achieved' a.json)
  assert_output --partial "--count curve_1=3: the boundary 'curve_1' has $least elements, not 3: its wall layers"
  assert_output --partial "need at least $least"
  run quadrefine --geometry-tol 0.1 --wall $wall --count curve_1="$least" "$blocks" -o a.quad.h5
  refute_output --partial W-QUA-002
}

@test "elements at the ends of a boundary have the prescribed lengths" {
  quadrefine --size 0.2 --grading curve_0=0.02:0.02 "$blocks" -o a.quad.h5 --report a.json
  run jq -c '.gradings["0"] | [.boundary, (.first * 1e3 | round), (.last * 1e3 | round)]' a.json
  assert_output '["curve_0",20,20]'
  run -0 stagecheck a.quad.h5
  # One number of elements cannot suit everything: the warning says so.
  run -0 quadrefine --size 0.2 --grading curve_0=0.001: --count 0=1 --count 1=1 --count 2=1 "$blocks" -o b.quad.h5
  assert_output --partial "W-SIZ-002: --grading curve_0: an element at its end is"
}

@test "adjacent edges that differ by a tenth more than the target are reported with the cause" {
  wall=curve_0:first=0.002,growth=1.2,layers=4
  run -0 quadrefine --size 0.2 --wall $wall --count curve_1=36 "$blocks" -o a.quad.h5 --report a.json
  assert_output --partial "W-QUA-004: adjacent edges differ by a factor of"
  assert_output --partial "chords with prescribed numbers of elements (--count, --grading, --blocks) got no more"
  run jq '.growth.greatest > 1.1 * 1.3 and .growth.greatest < 1.5 * 1.3' a.json
  assert_output true
  run -0 quadrefine --size 0.2 --wall $wall "$blocks" -o a.quad.h5
  assert_output ""
}

@test "every number of elements has the lengths at both ends, and one that makes them grow fast is reported" {
  for count in 30 37 44; do
    run quadrefine --count curve_1=$count --grading curve_1=0.03:0.03 "$blocks" -o a.quad.h5 --report a.json
    assert_success
    refute_output --partial W-SIZ-002
    run jq -c '.gradings["0"] | [(.first * 1e3 | round), (.last * 1e3 | round)]' a.json
    assert_output "[30,30]"
  done
  run -0 quadrefine --count curve_1=24 --grading curve_1=0.6:0.6 "$blocks" -o a.quad.h5
  assert_output --partial "W-SIZ-003: --grading curve_1: adjacent elements along it differ by a factor of"
}

@test "nested refinement: four times the elements, the vertices where they were, the same geometry" {
  quadrefine --size 0.4 "$blocks" -o a.quad.h5 --report a.json
  quadrefine --size 0.4 --refine 1 "$blocks" -o b.quad.h5 --report b.json
  run jq -n 'input as $a | input as $b | [$b.quads / $a.quads, $b.valid,
    $a.boundary.mesh_to_cad == $b.boundary.mesh_to_cad]' a.json b.json --compact-output
  assert_output '[4,true,true]'
  run -0 stagecheck b.quad.h5
  PYTHONPATH=$ROOT/pipelines/python run -0 /usr/bin/python3 -B -c '
import quadrille
a, b = (quadrille.read(name + ".quad.h5") for name in "ab")
vertices = lambda mesh: {tuple(mesh.nodes[k]) for e in mesh.elem_nodes.reshape(-1, (mesh.order + 1) ** 2)
                         for k in e[[0, mesh.order, -1, -1 - mesh.order]]}
print(vertices(a) < vertices(b))'
  assert_output True
  run -1 quadrefine --size 0.4 --refine 10 "$blocks" -o c.quad.h5
  assert_output --partial "lower --refine"
}

@test "a table of sizes is linear between its points, also where a VTU file made it" {
  printf 'x,y,size\n-1,0,0.02\n1,0,0.2\n1,1,0.2\n-1,1,0.02\n' >sizes.csv
  quadrefine --size-field sizes.csv --growth 1.5 "$blocks" -o a.quad.h5 --report a.json
  run jq '.sizes.least_edge < 0.04 and .sizes.greatest_edge > 0.12 and .valid' a.json
  assert_output true
  # Coarser than a twentieth of the diameter too, and from a pipe as from a file.
  printf '0 0 0.5\n1 1 0.5\n' | quadrefine --size-field - "$blocks" -o b.quad.h5 --report b.json
  run jq -s '.[0].quads < .[1].quads / 4' b.json a.json
  assert_output true
  printf '0,0,0.1\n0,1\n' >bad.csv
  run -3 quadrefine --size-field bad.csv "$blocks" -o c.quad.h5
  assert_output --partial "bad.csv:2: expected 3 numbers, found 2"
}

@test "--metric: elements have the lengths of a metric by direction, which other sizes limit" {
  stage_chain duct .
  printf 'x,y,h1,h2,angle\n1,0.5,0.2,0.05,0\n' >metric.csv
  quadrefine --metric metric.csv duct.blocks.h5 -o a.quad.h5 --report a.json
  jq -e '.quads == 300 and (.greatest_edge_ratio.value - 4 | fabs < 1e-6) and (.resolution.ratio - 1 | fabs < 1e-6)' a.json
  run -0 stagecheck a.quad.h5
  printf 'x y m11 m12 m22\n0 0 25 0 400\n' | quadrefine --metric - duct.blocks.h5 -o b.quad.h5
  h5diff a.quad.h5 b.quad.h5 /nodes
  quadrefine --metric metric.csv --size 0.1 duct.blocks.h5 -o c.quad.h5 --report c.json
  jq -e '.quads == 600 and (.sizes.greatest_ratio - 1 | fabs < 1e-6)' c.json
}

@test "--metric and --align: what has no lengths or breaks a rule is refused" {
  echo '{"format": "alignment", "version": [1, 0], "points": [{"position": [0, 0], "angle": 0}]}' >a.json
  run -3 --separate-stderr quadrefine --metric a.json "$blocks" -o a.quad.h5
  assert_regex "$stderr" '^quadrefine: a.json: .*a metric has lengths'
  printf 'x,y,h1,h2,angle\n0,0,1,1,0\n0,0,1,-1,0\n' >bad.csv
  run -3 --separate-stderr quadrefine --metric bad.csv "$blocks" -o a.quad.h5
  assert_regex "$stderr" '^quadrefine: bad.csv:3: .*ALN-R03'
  run -3 --separate-stderr quadrefine --align "$ROOT/formats/size-field.schema.json" "$blocks" -o a.quad.h5
  run -2 --separate-stderr quadrefine --align a.json --align-strength -1 "$blocks" -o a.quad.h5
  assert_regex "$stderr" 'align-strength'
  assert_nothing_left a.json bad.csv
}

@test "--per-curve makes elements follow short curves, with and without a size" {
  stage_chain s_bend .
  quadrefine --per-curve 4 s_bend.blocks.h5 -o a.quad.h5 --report a.json
  quadrefine --per-curve 0 s_bend.blocks.h5 -o b.quad.h5 --report b.json
  quadrefine s_bend.blocks.h5 -o d.quad.h5 --report d.json
  size=$(jq .sizes.prescribed b.json)
  quadrefine --size "$size" --per-curve 4 s_bend.blocks.h5 -o c.quad.h5 --report c.json
  run jq -c -s 'map(.quads) | [.[0] > .[1], .[2] == .[0], .[3] > .[1], .[3] <= 2 * .[1], .[3] < .[0]]' \
    a.json b.json c.json d.json
  assert_output '[true,true,true,true,true]'
}
