# Acceptance: quadmesh on every shape in tests/data, with default size and order.
#
# The expected numbers are facts about the shapes (index sum, symmetry, closed forms), not stored output.
load ../tools/common

# mesh SHAPE [OPTION...]: the mesh with its stage files in the test's folder. It may be poor by its sizes (W-QUA-005).
mesh() {
  run -0 --separate-stderr "$ROOT/pipelines/quadmesh" "${@:2}" "$DATA/$1.step" -o "$1.msh" --workdir . --report "$1.json"
  assert_equal "$(grep -v W-QUA-005 <<<"$stderr")" ""
  assert_line --regexp '^[0-9]+ blocks?, [0-9]+ irregular nodes?, [0-9]+ quads?, worst scaled Jacobian 0?[.0-9]+, greatest edge ratio [.0-9]+; (good|usable: .*|poor: .*)$'
  assert_equal "${#lines[@]}" 1
  assert [ "$(jq '.least_jacobian_bound > 0' "$1.json")" = true ]
  for file in "$1".{tri.h5,solve.h5,field.h5,crit.json,sep.json,blocks.h5,quad.h5}; do
    run -0 stagecheck "$file"
  done
}

# expect SHAPE BLOCKS IRREGULAR: counts of the report; "any" where they are not known beforehand.
expect() {
  [[ $2 == any ]] || assert_equal "$(jq .blocks "$1.json") blocks" "$2 blocks"
  [[ $3 == any ]] || assert_equal "$(jq .irregular_nodes "$1.json") irregular nodes" "$3 irregular nodes"
}

# judge SHAPE: the independent checker, if it and the package that it needs are there.
judge() {
  local checker=$ROOT/../shared/check/mesh_report.py
  if [[ ! -f $checker ]] || ! /usr/bin/python3 -c 'import gmsh' 2>/dev/null; then return 0; fi
  run -0 /usr/bin/python3 "$checker" "$1.msh" --cad "$DATA/$1.step"
}

# truth SHAPE: critical points within 1e-7 of the diameter, the same valences, none missing, none extra; corners too.
truth() {
  jq -n -e --arg shape "$1" --slurpfile truth "$DATA/truth.json" --slurpfile found "$1.crit.json" \
    --slurpfile graph "$1.sep.json" '
    (1e-7 * $graph[0].face.diameter) as $tolerance |
    def is_near($a; $b): ($a.x - $b.position[0] | fabs) < $tolerance and ($a.y - $b.position[1] | fabs) < $tolerance
      and $a.valence == $b.valence;
    def match($a; $b): ($a | length) == ($b | length) and
      all($a[]; . as $p | [$b[] | select(is_near($p; .))] | length == 1);
    match($truth[0][$shape].critical_points; $found[0].critical_points) and
    match($truth[0][$shape].corners; $found[0].corners)'
}

case_of() {
  mesh "$1" "${@:4}"
  expect "$@"
  run -0 truth "$1"
  judge "$1"
}

@test "half_disc: two nodes of valence 3 and one block each side of them" { case_of half_disc 4 2; }
@test "square: one block" { case_of square 1 0; }
@test "l_shape: three blocks around the reflex corner" { case_of l_shape 3 0; }
@test "quarter_annulus: one block" { case_of quarter_annulus 1 0; }
@test "annulus: no node, cut into four-sided blocks" { case_of annulus any 0; }
@test "eccentric_annulus" { case_of eccentric_annulus any any --place keep; }
@test "plate_hole" { case_of plate_hole any any; }
@test "cylinder_channel" { case_of cylinder_channel any any; }
@test "s_bend" { case_of s_bend any any; }
@test "stadium: two nodes of valence 3 at each end" { case_of stadium any 4; }
@test "geometry_1" { case_of geometry_1 any any; }
@test "geometry_2: a disc's four nodes of valence 3 in a spiral" { case_of geometry_2 any 4; }
