# Half models: faces with curves called symmetry on one line have half of the grid of the mirrored whole.
load ../tools/common

halves=$ROOT/tests/cases/halves.py

# mesh PART 'FORMULA' OPTION...: meshes PART.step; the formula of jq must hold for the report of the run.
mesh() {
  "$ROOT/pipelines/quadmesh" -q "$1.step" "${@:3}" --workdir stages -o "$1.msh" --report "$1.json"
  jq -e "$2" "$1.json" >verdict ||
    fail "$(jq -c '[.blocks, .irregular_nodes, .least_scaled_jacobian, .valid, .warnings]' "$1.json")"
}

# nodes_agree OPTION...: the nodes and corners of half.step are those of whole.step, to a millionth of its size.
nodes_agree() {
  local part
  for part in half whole; do
    "$ROOT/pipelines/quadmesh" -q $part.step "$@" --until critpoints --workdir stages
    run -0 stagecheck stages/$part.crit.json
  done
  run -0 "$halves" compare stages/half.crit.json stages/whole.crit.json 2e-5
}

@test "a half C-shaped far field around half an aerofoil has half a C-grid, with and without --topology" {
  local options
  "$halves" aerofoil_c
  for options in '' '--topology c'; do
    # shellcheck disable=SC2086 # words
    mesh half '.valid and .blocks == 2 and .irregular_nodes == 0 and .least_scaled_jacobian > 0.5 and
      (.warnings | map(select(.code != "W-QUA-005"))) == []' \
      $options
    assert_equal "$(jq -c '.corners | map(.valence)' stages/half.crit.json)" '[2,1,1,1,1]'
  done
  "$halves" blunt_c
  mesh half '.valid and .blocks == 3 and .irregular_nodes == 0 and .least_scaled_jacobian > 0.5'
}

@test "the nodes of a half are those of the whole, in every kind of far field and without one" {
  local shape
  for shape in aerofoil_box blunt_o ellipse_box ellipse_o square_box cylinder_channel channel pair; do
    "$halves" $shape
    nodes_agree
  done
}

@test "kinds of grid, the fewest nodes and walls with layers are those of the whole" {
  "$halves" ellipse_box
  nodes_agree --topology c
  nodes_agree --topology o
  nodes_agree --nodes none
  nodes_agree --topology none
  nodes_agree --clearance body=2.5
  # Nodes of odd valence on the line leave it in pairs, of which the half has one each.
  "$halves" thin_ellipse
  nodes_agree --clearance body=0.1
  assert_equal "$(jq -c '[.critical_points | map(.valence), length]' stages/half.crit.json)" '[[3,5,5,3],4]'
}

@test "a half has half of the blocks, sizes and quality of the whole" {
  "$halves" ellipse_box
  mesh whole '.valid and .blocks == 12' --inner-edges curved --relax none
  mesh half '.valid and .blocks == 8 and .irregular_nodes == 2' --inner-edges curved --relax none
  jq -e -s '(.[0].least_scaled_jacobian - .[1].least_scaled_jacobian | fabs) < 0.01 and
    (2 * .[0].quads / .[1].quads | . > 0.9 and . < 1.1)' half.json whole.json
}

@test "a circle around a sharp tail has its node beside the line, where the whole has it on the line" {
  "$halves" aerofoil_o
  mesh half '.valid and .blocks == 5 and .irregular_nodes == 1 and .least_scaled_jacobian > 0.45 and .warnings == []'
}

# as_good: the worst element of half.json is as good as that of whole.json, or nearly so.
as_good() { jq -e -s '.[0].least_scaled_jacobian > .[1].least_scaled_jacobian - 0.02' half.json whole.json; }

@test "where the whole has nodes of odd valence on the line, the half has nodes of its own, at the least energy of the whole" {
  "$halves" disc
  mesh whole '.blocks == 5' --size-rule nearest --relax none
  # Unrelaxed, R is above 5 and the mesh says so; no other warning is due.
  mesh half '.valid and .blocks == 4 and .irregular_nodes == 2 and (.warnings | map(.code) - ["W-QUA-005"]) == []' \
    --size-rule nearest --relax none
  as_good
  # The nodes of the whole, turned by 45 degrees.
  jq -e -s 'def radius: .critical_points[0].position | map(. * .) | add | sqrt;
    (.[0] | radius) - (.[1] | radius) | fabs < 1e-6' stages/half.crit.json stages/whole.crit.json
  "$halves" ellipse
  mesh whole .valid --size-rule nearest --relax none
  # Unrelaxed, R is above 5 and the mesh says so; no other warning is due.
  mesh half '.valid and .blocks == 4 and .irregular_nodes == 2 and (.warnings | map(.code) - ["W-QUA-005"]) == []' \
    --size-rule nearest --relax none
  as_good
  "$halves" quarter_disc
  mesh quarter '.valid and .blocks == 3 and .irregular_nodes == 1 and .warnings == []'
}

@test "an interface that crosses the line of symmetry" {
  "$halves" inclusion
  mesh whole '.blocks == 17 and .least_scaled_jacobian > 0.8'
  mesh half '.valid and .blocks == 12 and .irregular_nodes == 4 and .least_scaled_jacobian > 0.7 and .warnings == []'
}

@test "blocks of wall layers are those of the whole, around a sharp tail, and with another name of the line" {
  local layers='body:first=1e-3,growth=1.2,layers=12,blocks=own'
  "$halves" blunt_c
  mesh half '.valid and .blocks == 8 and .least_scaled_jacobian > 0.64 and .warnings == []' --wall $layers
  "$halves" aerofoil_c
  mesh whole .valid --wall $layers
  mesh half '.valid and .blocks == 6 and .irregular_nodes == 0' --wall $layers
  as_good
  sed "s/'symmetry'/'axis'/" half.step >other.step
  mesh other '.irregular_nodes == 0' --wall $layers --symmetry axis
}

@test "wall layers in the blocks of a half, without a limit on their growth, are those of the whole" {
  local layers='body:first=1e-3,growth=1.2,layers=12'
  "$halves" aerofoil_c
  mesh whole .valid --wall $layers --target-growth 0
  mesh half '.valid and .blocks == 2' --wall $layers --target-growth 0
  as_good
}

@test "--symmetry names the curves, by name, pattern or number; none turns it off" {
  "$halves" aerofoil_c
  cp half.step other.step
  sed -i "s/'symmetry'/'axis'/" other.step
  mesh other '.blocks == 2' --symmetry axis
  mesh other '.blocks == 2' --symmetry 'ax*'
  mesh other '.blocks == 2' --symmetry 0
  run -2 "$ROOT/pipelines/quadmesh" other.step --topology c -o a.msh
  assert_line --partial 'a C-, O- or H-grid is made around a hole, and the face has none'
  run -2 "$ROOT/pipelines/quadmesh" half.step --topology c --symmetry none -o a.msh
  run -2 "$ROOT/pipelines/quadmesh" other.step --symmetry axes -o a.msh
  assert_line --index 0 --partial 'there is no boundary "axes" (did you mean axis?)'
  run -2 "$ROOT/pipelines/quadmesh" other.step --symmetry body -o a.msh
  assert_line --index 0 --partial 'quadmesh: --symmetry body: curve 5 "body" is not straight: at ('
  assert_line --index 0 --partial ' off the line between its ends: a half has the curves of its symmetry on one line'
}

@test "curves called symmetry that are bent or inside the face are reported, and the face is meshed for itself" {
  "$halves" aerofoil_c
  run -0 --separate-stderr "$ROOT/pipelines/quadmesh" half.step --name symmetry=5 -o a.msh --report a.json
  assert_regex "$stderr" 'critpoints: warning W-NODE-005: curve 5 "symmetry" is not straight'
  "$halves" channel
  run -0 --separate-stderr "$ROOT/pipelines/quadmesh" half.step --name symmetry=1 -o a.msh --report a.json
  assert_equal "$stderr" ""
  assert_equal "$(jq -c '[.blocks, .warnings]' a.json)" '[1,[]]'
}

@test "groups keep their names, and a quarter has a quarter of the grid" {
  "$halves" cylinder_channel
  mesh half '.valid and .blocks == 8'
  assert_equal "$(grep -c '"symmetry"' half.msh)" 1
  "$halves" quarter
  mesh quarter '.valid and .blocks == 5 and .irregular_nodes == 1 and .least_scaled_jacobian > 0.45 and .warnings == []'
  jq -e '.critical_points[0] | .valence == 5 and (.position[0] - .position[1] | fabs) < 1e-6' stages/quarter.crit.json
}
