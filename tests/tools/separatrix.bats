# separatrix: a field and its critical points in, a planar graph out.
load common

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
}

setup() {
  common_setup
  field=$BATS_FILE_TMPDIR/half_disc.field.h5
  crit=$BATS_FILE_TMPDIR/half_disc.crit.json
}

@test "writes a valid graph silently" {
  run separatrix "$field" "$crit" -o a.sep.json
  assert_success
  assert_output ""
  assert_nothing_left a.sep.json
  run stagecheck a.sep.json
  assert_success
}

@test "the half disc has five lines, four faces and one merged pair" {
  separatrix "$field" "$crit" -o a.sep.json --report a.json
  run jq -c '.trace | [.launched, .lines, .merged, .faces]' a.json
  assert_output '[6,5,1,4]'
  run jq -c '[.lines[].kind] | sort' a.sep.json
  assert_output '["merged","traced","traced","traced","traced"]'
}

@test "the half disc's graph is its own mirror image" {
  separatrix "$field" "$crit" -o a.sep.json
  run jq -e '[.nodes[].position] as $all |
    all($all[]; . as [$x, $y] | any($all[]; ((.[0] + $x) | fabs) < 1e-6 and ((.[1] - $y) | fabs) < 1e-6))' a.sep.json
  assert_success
}

@test "gives the same bytes through pipes and twice" {
  separatrix "$field" "$crit" -o a.sep.json
  critpoints "$field" | separatrix "$field" - > b.sep.json
  separatrix "$field" < "$crit" > c.sep.json
  cmp a.sep.json b.sep.json
  cmp a.sep.json c.sep.json
}

@test "a bound on the number of arcs exits 1 with the count" {
  run separatrix "$field" "$crit" --layout traced --max-lines 3 -o a.sep.json
  assert_failure 1
  assert_output "separatrix: 5 separatrices cut each other into 5 arcs, more than the 3 allowed"
  assert_nothing_left
}

@test "a bound on the length exits 1 with the place" {
  run separatrix "$field" "$crit" --layout traced --max-length 0.01 -o a.sep.json
  assert_failure 1
  assert_output --partial "has reached neither boundary nor node after"
  assert_nothing_left
}

@test "a bound on the total length exits 1 with the sum, and leads to the quantized layout" {
  run separatrix "$field" "$crit" --layout traced --max-total-length 0.1 -o a.sep.json
  assert_failure 1
  assert_output --regexp "^separatrix: 6 separatrices are [0-9.]+ diameters long together, more than the 0.1 allowed"
  assert_nothing_left
  run -0 separatrix "$field" "$crit" --max-total-length 0.1 -o a.sep.json --report a.json
  run jq -r '.layout.method' a.json
  assert_output quantized
}

@test "a bound on the steps exits 1 with their number, for both layouts that need separatrices" {
  for layout in traced quantized; do
    run separatrix "$field" "$crit" --layout $layout --max-line-steps 1 -o a.sep.json
    assert_failure 1
    assert_output --regexp "^separatrix: [1-6] separatrices take [0-9]+ steps, more than the 100 allowed"
    assert_nothing_left
  done
  run -2 separatrix "$field" "$crit" --max-line-steps 0 -o a.sep.json
}

@test "lines that meet exactly are one whatever the options say" {
  separatrix "$field" "$crit" --merge-angle 0 -o a.sep.json --report a.json
  run jq -c '.trace | [.merged, .faces]' a.json
  assert_output '[1,4]'
}

@test "aggressive merging connects nodes with corners across a distance" {
  stage_chain geometry_1 .
  for distance in 0.01 0.3 0.7; do
    separatrix geometry_1.field.h5 geometry_1.crit.json --merge-angle 1 --merge-distance $distance --simplify none \
      -o a.sep.json --report a.json
    jq -c '.trace | [.merged, .faces]' a.json
  done > counts
  run cat counts
  assert_output $'[1,25]\n[3,15]\n[5,11]'
  # The two irregular nodes are connected: one line is theirs.
  run jq '[.lines[] | select(.kind == "merged" and .origin <= 1 and .end <= 1)] | length' a.sep.json
  assert_output 1
}

@test "a node that was moved is refused" {
  jq '.critical_points[0].position[0] += 0.01' "$crit" > moved.crit.json
  run separatrix "$field" moved.crit.json -o a.sep.json
  assert_failure 3
  assert_output --partial "run fieldsolve --nodes"
  assert_nothing_left moved.crit.json
}

# phase SHAPE CRIT: SHAPE.phase.h5, the field that has the nodes of CRIT; SHAPE's stage files are here.
phase() {
  fieldsolve --nodes "$2" --orders "$1.field.h5" "$1.tri.h5" | padapt -o "$1.phase.h5"
}

# The nodes of CRIT moved along x by a twentieth of geometry_1's diameter: one of two that mirror each other.
move_node() {
  jq '.form = "phase" | .critical_points[0].position[0] += '"$2" "$1"
}

@test "a node that was moved is where the file says, in a field made for it" {
  stage_chain geometry_1 .
  move_node geometry_1.crit.json 0.48 > moved.crit.json
  phase geometry_1 moved.crit.json
  separatrix geometry_1.phase.h5 moved.crit.json -o a.sep.json
  run -0 stagecheck a.sep.json
  run -0 jq -c --slurpfile asked moved.crit.json \
    '[.nodes[] | select(.kind == "irregular").position] == [$asked[0].critical_points[].position]' a.sep.json
  assert_output true
  blocksplit a.sep.json | quadrefine --report a.json -o a.quad.h5
  run -0 jq '.irregular_nodes == 2 and .least_jacobian_bound > 0' a.json
  assert_output true
}

@test "nodes of valence 3 on a hole leave eight blocks about it" {
  stage_chain plate_hole .
  jq '.form = "phase" | .critical_points = [] | .boundary_nodes = [range(4) | (2 * . + 1) * atan2(1; 1) |
    {curve: 4, t: ., position: [2.1 + 0.7 * cos, 1.4 - 0.7 * sin], valence: 3, source: "feature"}]' \
    plate_hole.crit.json > hole.crit.json
  phase plate_hole hole.crit.json
  separatrix plate_hole.phase.h5 hole.crit.json -o a.sep.json --report a.json
  run -0 jq -c '.trace | [.lines, .faces]' a.json
  assert_output '[8,8]'
  run -0 jq -c '[.nodes[] | select(.kind == "boundary").valence] | sort' a.sep.json
  assert_output '[2,2,2,2,2,2,2,2,3,3,3,3]'
  run -0 stagecheck a.sep.json
}

@test "the form phase beside a harmonic field is refused" {
  jq '.form = "phase"' "$crit" > asked.crit.json
  run separatrix "$field" asked.crit.json -o a.sep.json
  assert_failure 3
  assert_output --partial 'form "phase"'
  assert_output --partial "run fieldsolve --nodes"
  assert_nothing_left asked.crit.json
}

@test "a field made for other nodes is refused" {
  cp "$BATS_FILE_TMPDIR"/half_disc.{tri,field}.h5 .
  move_node "$crit" -0.1 > moved.crit.json
  phase half_disc moved.crit.json
  for other in "$crit" <(move_node moved.crit.json 1e-6) <(jq 'del(.critical_points[0])' moved.crit.json); do
    run separatrix half_disc.phase.h5 - -o a.sep.json < "$other"
    assert_failure 3
  done
  run separatrix half_disc.phase.h5 "$crit" -o a.sep.json
  assert_failure 3
  assert_output --partial "is not what the field was solved for: run fieldsolve --nodes"
  assert_file_not_exists a.sep.json
}

@test "critical points of another shape are refused" {
  stage_chain square .
  run separatrix "$field" square.crit.json -o a.sep.json
  assert_failure 3
}

@test "numbers outside their interval are mistakes of the command line" {
  run separatrix "$field" "$crit" --merge-angle 50
  assert_failure 2
  run separatrix "$field" "$crit" --tolerance 0
  assert_failure 2
}

@test "a domain without nodes and corners is cut four times" {
  stage_chain annulus .
  run jq -c '[.lines[].kind]' annulus.sep.json
  assert_output '["cut","cut","cut","cut"]'
}

@test "the examples of the help run" {
  cp "$field" "$crit" .
  separatrix half_disc.field.h5 half_disc.crit.json -o half_disc.sep.json
  critpoints half_disc.field.h5 | separatrix half_disc.field.h5 - | blocksplit -o half_disc.blocks.h5
  assert_file_exists half_disc.blocks.h5
}

@test "the half disc is the same four blocks when its lines race" {
  separatrix "$field" "$crit" --layout quantized -o a.sep.json --report a.json
  run jq -c '[.t_mesh.faces_of_4_corners, .t_mesh.t_junctions, .quantize.faces]' a.json
  assert_output '[4,0,4]'
  separatrix "$field" "$crit" -o b.sep.json
  run jq -sc '.[0].arcs == .[1].arcs' a.sep.json b.sep.json
  assert_output true
  run stagecheck a.sep.json
  assert_success
}

@test "says so where whole lines make no layout and stopped ones do" {
  run separatrix "$field" "$crit" --layout auto --max-lines 3 -o a.sep.json --report a.json
  assert_success
  assert_output --partial "W-SEP-001"
  assert_output --partial "more than the 3 allowed"
  run jq -r '.layout.method' a.json
  assert_output quantized
  run separatrix "$field" "$crit" --layout auto -o b.sep.json --report b.json
  assert_output ""
  run jq -r '.layout.method' b.json
  assert_output traced
}

@test "an ellipse has lines that stop at others, and blocks when they go on" {
  stage_chain ellipse
  separatrix ellipse.field.h5 ellipse.crit.json --layout t-mesh -o t.sep.json --report t.json
  run jq -c '.t_mesh | [.t_junctions > 0, (keys | map(select(startswith("faces_of"))))]' t.json
  assert_output '[true,["faces_of_4_corners"]]'
  separatrix ellipse.field.h5 ellipse.crit.json --layout quantized -o q.sep.json
  run jq -c '.t_junctions' q.sep.json
  assert_output '[]'
  blocksplit q.sep.json | quadrefine - -o q.quad.h5
}

# certificate FILE: what programs read first.
certificate() { jq -c '.certificate | [.method, .index_sum, [.face_valence_histogram[] | [.corners, .faces]], .t_junctions]' "$1"; }

@test "a graph carries its certificate, and the report repeats it" {
  separatrix "$field" "$crit" -o a.sep.json --report a.json
  run -0 certificate a.sep.json
  assert_output '["traced",4,[[4,4]],0]'
  run -0 jq -sc '.[0].certificate as $c | .[1].certificate | [.method == $c.method, .index_sum == $c.index_sum,
    .faces_of_4_corners == $c.face_valence_histogram[0].faces, .merged_lines == 1, $c.merged_lines == 1,
    .largest_deviation_degrees == $c.largest_deviation_degrees, $c.largest_deviation_degrees < 1e-6]' a.sep.json a.json
  assert_output '[true,true,true,true,true,true,true]'
  run -0 jq -e '.trace.largest_merge_deviation_degrees >= 0' a.json
  separatrix "$field" "$crit" --layout quantized -o q.sep.json --report q.json
  run -0 certificate q.sep.json
  assert_output '["quantized",4,[[4,4]],0]'
  run -0 jq -e '.quantize.rejected_merges == 0' q.json
  run -0 separatrix -q "$field" "$crit" --max-lines 3 -o r.sep.json
  run -0 jq -r '.certificate | .method, .reason' r.sep.json
  assert_output $'quantized\n5 separatrices cut each other into 5 arcs, more than the 3 allowed'
}

@test "a T-mesh is certified as one, and a certificate of another graph is refused" {
  stage_chain ellipse
  separatrix ellipse.field.h5 ellipse.crit.json --layout t-mesh -o t.sep.json
  run -0 stagecheck t.sep.json
  run -0 jq -c '.certificate | [.method, .t_junctions > 0, .index_sum, (.face_valence_histogram | map(.corners))]' t.sep.json
  assert_output '["t-mesh",true,4,[4]]'
  separatrix ellipse.field.h5 ellipse.crit.json --layout quantized -o q.sep.json
  run -0 jq -c '.certificate.largest_deviation_degrees | . > 0 and . <= 90' q.sep.json
  assert_output true
  jq --slurpfile t t.sep.json '.certificate = $t[0].certificate' q.sep.json > wrong.sep.json
  run -3 stagecheck wrong.sep.json
  assert_output --partial SEP-R13
}

@test "where whole lines cut each other too often, stopped ones that make fewer blocks are taken" {
  python3 -B "$ROOT/tests/stress/families.py" . smooth_077
  cad2tri -q smooth_077.step -o x.tri.h5
  fieldsolve -q x.tri.h5 | padapt -q -o x.field.h5
  critpoints -q x.field.h5 -o x.crit.json
  for layout in traced auto; do
    run -0 separatrix x.field.h5 x.crit.json --layout $layout -o $layout.sep.json --report $layout.json
    assert_output ""
    run -0 stagecheck $layout.sep.json
  done
  run -0 jq -r '.certificate | .method, .reason' auto.sep.json
  assert_output --regexp '^quantized
[0-9]+ separatrices that are followed to their ends make [0-9]+ blocks, [0-9]+ will do$'
  run -0 jq -sc '[(.[1].certificate.faces_of_4_corners < .[0].certificate.faces_of_4_corners),
    (.[1].simplify.least_scaled_jacobian >= .[0].simplify.least_scaled_jacobian)]' traced.json auto.json
  assert_output '[true,true]'
}

@test "--layout midpoint needs triangles only: the same graph from x.tri.h5 and x.field.h5" {
  separatrix --layout midpoint "$BATS_FILE_TMPDIR/half_disc.tri.h5" -o a.sep.json --report a.json
  run --separate-stderr separatrix --layout midpoint "$field" -o b.sep.json
  assert_success
  assert_equal "$stderr" ""
  run cmp <(jq -c 'del(.provenance)' a.sep.json) <(jq -c 'del(.provenance)' b.sep.json)
  assert_success
  run -0 stagecheck a.sep.json b.sep.json
  run jq -c '[.certificate.method, .certificate.reason, (.lines | length)]' a.sep.json
  assert_output '["midpoint","",0]'
  run jq -c '[.midpoint.blocks == 3 * .midpoint.triangles, .midpoint.origin]' a.json
  assert_output '[true,"coarse"]'
}

@test "blocks of a midpoint division make valid meshes of every order and size" {
  separatrix --layout midpoint "$BATS_FILE_TMPDIR/half_disc.tri.h5" | blocksplit -o a.blocks.h5
  for options in "--order 1" "--order 2 --geometry-tol 5e-7" "--order 7" "--size 1" "--size 0.03 --order 3"; do
    # shellcheck disable=SC2086 # words
    quadrefine $options a.blocks.h5 -o a.quad.h5
    run -0 stagecheck a.quad.h5
  done
}

@test "auto ends with a midpoint division: where both other layouts fail, and without a field" {
  run --separate-stderr separatrix "$field" "$crit" --max-length 0.01 -o a.sep.json
  assert_success
  assert_regex "$stderr" '^separatrix: warning W-SEP-002: .*has reached neither boundary nor node after.*three blocks'
  run jq -c '[.certificate.method, (.certificate.reason | length > 0)]' a.sep.json
  assert_output '["midpoint",true]'
  run --separate-stderr separatrix "$BATS_FILE_TMPDIR/half_disc.tri.h5" -o b.sep.json
  assert_success
  assert_regex "$stderr" '^separatrix: warning W-SEP-002: there is no field'
}

@test "a layout of separatrices from triangles alone is a mistake" {
  for layout in traced quantized t-mesh; do
    run separatrix --layout $layout "$BATS_FILE_TMPDIR/half_disc.tri.h5" -o a.sep.json
    assert_failure 2
    assert_line "separatrix: --layout $layout needs a field, not a triangle mesh"
  done
  assert_nothing_left
}
