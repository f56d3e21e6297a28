# Irregular nodes: all of them, once each, the same however the shape lies, and where a user wants them.
load ../tools/common

# field SHAPE.step NAME: NAME.field.h5 and its NAME.crit.json with further options for critpoints.
field() { cad2tri "$1" | fieldsolve -q | padapt -q -o "$2.field.h5"; }
nodes() {
  field "$1" "$2"
  critpoints -q "${@:3}" "$2.field.h5" -o "$2.crit.json"
}

# The greatest distance between two points of the outline: what tolerances are shares of.
diameter() { cad2tri "$1" -o d.tri.h5 --report - | jq .face.diameter; }

# same_when_moved SHAPE [OPTION]: turned, mirrored, scaled, moved far away; the nodes move along.
same_when_moved() {
  local shape=$DATA/$1.step extent
  extent=$(diameter "$shape")
  nodes "$shape" original
  while read -r tolerance motion; do
    # shellcheck disable=SC2086  # a list of words
    "$DATA/move_step.py" $motion "$shape" moved.step
    nodes moved.step moved
    # shellcheck disable=SC2086
    run -0 "$BATS_TEST_DIRNAME/same_nodes.py" $motion --extent "$extent" ${2-} original.crit.json moved.crit.json "$tolerance"
  done <<END
1e-8 --rotate 37
1e-8 --mirror
1e-8 --mirror --rotate 71
1e-8 --scale 1e-3
1e-8 --scale 1e3
1e-7 --move 60000 -30000
END
}

@test "the disc's nodes are the same when it moves, up to its own symmetries" { same_when_moved disc --congruent; }
@test "the hexagon's node is the same when it moves" { same_when_moved hexagon; }
@test "the ellipse's nodes are the same when it moves" { same_when_moved ellipse; }
@test "plate_hole's nodes are the same when it moves" { same_when_moved plate_hole; }
@test "geometry_4's corners are the same when it moves" { same_when_moved geometry_4; }
@test "chamfered_plate's corners are the same when it moves" { same_when_moved chamfered_plate; }
@test "chamfered_plate_hole's nodes and corners are the same when it moves" { same_when_moved chamfered_plate_hole; }

@test "a disc has four nodes of valence 3 on a square, by energy alone at radius (3/11)^(1/8)" {
  field "$DATA/disc.step" disc
  # Two pairs of opposite nodes, at one radius, on lines at right angles.
  square='[.critical_points[] | .position] as $p | ($p | length == 4) and ([.critical_points[].valence] | all(. == 3)) and
    ($p | map(.[0] * .[0] + .[1] * .[1] | sqrt) | max - min < 1e-9) and (($p | map(.[0]) | add | fabs) < 1e-9) and
    (($p | map(.[1]) | add | fabs) < 1e-9) and ([range(1; 4) as $i | $p[0][0] * $p[$i][0] + $p[0][1] * $p[$i][1]]
    | sort | (.[1] | fabs < 1e-9) and (.[2] | fabs < 1e-9) and .[0] < -0.1)'
  critpoints disc.field.h5 -o disc.crit.json
  jq -e "$square" disc.crit.json
  jq -e '.form == "phase" and .clusters[0].index == 4 and ([.changes[].kind] | unique == ["cluster", "place"])' disc.crit.json
  critpoints --place energy --place-weight 0 disc.field.h5 -o energy.crit.json
  jq -e "$square" energy.crit.json
  jq -e 'def root8: sqrt | sqrt | sqrt; [.critical_points[].position | .[0] * .[0] + .[1] * .[1] | sqrt] |
    all(. - (3 / 11 | root8) | fabs < 1e-6)' energy.crit.json
}

@test "the hexagon has one node of valence 6 in its centre, or what --max-valence allows" {
  nodes "$DATA/hexagon.step" hexagon
  jq -e '.critical_points | length == 1 and .[0].valence == 6 and (.[0].position | map(fabs) | max < 1e-9)' hexagon.crit.json
  critpoints --max-valence 5 hexagon.field.h5 -o split.crit.json
  jq -e '[.critical_points[].valence] == [5, 5] and (.critical_points | map(.position[0]) | add | fabs < 1e-9)' split.crit.json
}

@test "with nothing absorbed the nodes are those of an independent solver" {
  local count=0
  for step in "$DATA"/*.step; do
    shape=$(basename "$step" .step)
    # Multiple zeros and line fields have no simple zeros to compare.
    jq -e --arg shape "$shape" '.[$shape] and ([.[$shape].flags[] | select(test("multiple|critical_lines"))] == [])' \
      "$DATA/truth.json" >/dev/null || continue
    nodes "$step" "$shape" --corner-absorb 0 --cluster-distance 0 --degenerate keep --ties field
    jq -n -e --arg shape "$shape" --slurpfile truth "$DATA/truth.json" --slurpfile found "$shape.crit.json" \
      --argjson diameter "$(diameter "$step")" '
      def is_near($a; $b): ($a.x - $b.position[0] | fabs) < 1e-8 * $diameter and
        ($a.y - $b.position[1] | fabs) < 1e-8 * $diameter and $a.valence == $b.valence;
      $found[0].index_sum.value == $found[0].index_sum.expected and $found[0].form == "harmonic" and
      ($found[0].changes == []) and
      ($truth[0][$shape].critical_points | length) == ($found[0].critical_points | length) and
      all($truth[0][$shape].critical_points[], ($truth[0][$shape].corners[] | select(.valence != null)); . as $p |
        [($found[0].critical_points, $found[0].corners)[] | select(is_near($p; .))] | length == 1)
      ' >/dev/null || fail "$shape"
    rm -f "$shape".*
    count=$((count + 1))
  done
  assert [ "$count" -ge 12 ]
}

@test "with default options the index sum holds, and what differs from the field's zeros is listed with its reason" {
  for step in "$DATA"/*.step; do
    nodes "$step" default
    run -0 stagecheck default.crit.json
    jq -e '.index_sum.value == .index_sum.expected' default.crit.json
    jq -e 'if .form == "harmonic" then (.zeros == []) or (.changes != []) else .changes != [] end' default.crit.json
    jq -e '[.changes[].reason | length > 20] | all' default.crit.json
  done
}

@test "equal holes in rows have four nodes of valence 5 each, whatever their radius, and regular blocks" {
  for radius in 0.19 0.2 0.22; do
    python3 - "$DATA" $radius >plate.step <<'EOF'
import sys
sys.path.insert(0, sys.argv[1])
from step_text import rectangle, step_text
centres = [complex(i + 0.5, j + 0.5) for j in range(5) for i in range(6)]
print(step_text("plate", [rectangle(0j, 6 + 5j)] + [[("circle", z, float(sys.argv[2]), -1)] for z in centres]), end="")
EOF
    "$ROOT/pipelines/quadmesh" -q plate.step -o $radius.msh --workdir w$radius --report $radius.json
    jq -e '[.critical_points[].valence] == [range(120) | 5]' w$radius/plate.crit.json
    jq -e '.blocks <= 400' $radius.json
  done
}

# apart SHAPE SIZE: no node nearer to another than half the size.
apart() {
  jq -e --argjson size "$2" '[.critical_points[].position, .boundary_nodes[].position] | . as $p |
    [range(length) as $i | range($i) as $j | ($p[$i][0] - $p[$j][0]) as $x | ($p[$i][1] - $p[$j][1]) as $y |
    $x * $x + $y * $y | sqrt] | all(. >= 0.5 * $size)' "$1"
}

@test "below the fillets' radius --feature-size changes nothing, above it the nodes stand apart" {
  for row in "small_fillets 0.002 0.1" "bracket 0.1 1" "gear_filleted 0.05 0.5"; do
    read -r shape below above <<<"$row"
    field "$DATA/$shape.step" "$shape"
    critpoints "$shape.field.h5" --feature-size "$below" -o below.crit.json
    jq -e --arg shape "$shape" --slurpfile truth "$DATA/truth.json" '.form == "harmonic" and
      ([.critical_points[].valence] | sort) == ([$truth[0][$shape].critical_points[].valence] | sort)' below.crit.json
    critpoints "$shape.field.h5" --feature-size "$above" -o above.crit.json
    apart above.crit.json "$above"
    jq -e '.form == "phase" and .index_sum.value == .index_sum.expected' above.crit.json
  done
}

@test "a greater --feature-size gives no more blocks, and none that are much worse" {
  cad2tri "$DATA/small_fillets.step" -o x.tri.h5
  fieldsolve x.tri.h5 | padapt -o x.field.h5
  local last=24 size
  for size in 0 0.1 0.3 1; do
    critpoints x.field.h5 --feature-size "$size" -o x.crit.json
    fieldsolve x.tri.h5 --nodes x.crit.json | padapt -o x.phase.h5
    [[ $size != 0 ]] || cp x.field.h5 x.phase.h5
    separatrix x.phase.h5 x.crit.json --report x.json | blocksplit -o x.blocks.h5
    quadrefine --relax none --size-rule nearest x.blocks.h5 --report quads.json -o x.quad.h5
    jq -e '.least_scaled_jacobian > 0.68' quads.json
    run -0 jq .blocks quads.json
    assert [ "$output" -le "$last" ]
    last=$output
  done
  assert [ "$last" -le 15 ]
  jq -e '.fillets.lines_moved == 4' x.json
}

@test "a fillet below a five-hundredth of the diameter shapes no blocks, whatever the element size" {
  python3 - "$DATA" >tiny.step <<'EOF'
import sys
sys.path.insert(0, sys.argv[1])
from step_text import polygon, step_text
print(step_text("tiny", [polygon([0, 4, 4 + 1j, 1 + 1j, 1 + 4j, 4j], [0, 0, 0, 0.004, 0, 0])]), end="")
EOF
  field tiny.step tiny
  critpoints tiny.field.h5 --feature-size 0 -o off.crit.json
  jq -e '.form == "harmonic" and .changes == [] and [.critical_points[].valence] == [5]' off.crit.json
  critpoints tiny.field.h5 -o auto.crit.json --report auto.json
  jq -e '.form == "phase" and .critical_points == [] and [.boundary_nodes[].valence] == [3]' auto.crit.json
  jq -e '.feature_size * 500 / (32 | sqrt) - 1 | fabs < 1e-9' auto.json
  run -2 critpoints tiny.field.h5 --feature-size -1
  assert_output --partial 'expected "auto" or a length'
  for size in 0.4 0.2 0.1; do
    "$ROOT/pipelines/quadmesh" -q tiny.step --size $size -o $size.msh --report $size.json --workdir w$size
    jq -c '[.blocks, .irregular_nodes, .certificate]' $size.json >$size.layout
    jq '.arcs, [.nodes[].position]' w$size/tiny.sep.json >$size.graph
  done
  cmp 0.4.layout 0.2.layout
  cmp 0.4.layout 0.1.layout
  cmp 0.4.graph 0.2.graph
  cmp 0.4.graph 0.1.graph
}

@test "a gear's feature nodes have the symmetry of the gear" {
  nodes "$DATA/gear_filleted.step" gear --feature-size 0.5
  run -0 "$BATS_TEST_DIRNAME/same_nodes.py" --mirror gear.crit.json gear.crit.json 1e-8
  run -0 "$BATS_TEST_DIRNAME/same_nodes.py" --rotate 60 gear.crit.json gear.crit.json 1e-8
}

@test "a corner valence that was asked for is set, the nodes make up for it, and the mesh is valid" {
  field "$DATA/square.step" square
  critpoints square.field.h5 --corner-valence 0:1=2 -o asked.crit.json
  jq -e '[.corners[] | select(.curves == [0, 1])][0] | .valence == 2 and .source == "corner"' asked.crit.json
  jq -e '[.critical_points[].valence] == [3]' asked.crit.json
  run -0 "$ROOT/pipelines/quadmesh" "$DATA/square.step" --corner-valence 0:1=2 -o square.msh --report square.json
  jq -e '.least_jacobian_bound > 0 and .irregular_nodes == 1' square.json
  run -2 --separate-stderr critpoints square.field.h5 --corner-valence 0:1=7 -o bad.crit.json
  assert_regex "$stderr" '90 degrees'
  run -2 --separate-stderr critpoints square.field.h5 --corner-valence 0:2=1 -o bad.crit.json
  assert_regex "$stderr" '0.*2'
  run -2 --separate-stderr critpoints square.field.h5 --corner-valence 0-1 -o bad.crit.json
  assert_not_exists bad.crit.json
}
