# Layouts: the same graph whatever the mesh and however the shape lies, with the symmetries of the shape.
load ../tools/common

# layout SHAPE.step NAME [SIZE ORDER]: NAME.sep.json through all stages, with a size (diameters) of the triangles and an
# order to begin with.
layout() {
  local order=${4-8} size=0
  if (($# > 2)); then
    cad2tri -q "$1" -o "$2.tri.h5" --report d.json
    size=$(jq "$3 * .face.diameter" d.json)
  fi
  cad2tri -q "$1" -o "$2.tri.h5" --size "$size"
  fieldsolve -q --field-order "$order" "$2.tri.h5" | padapt -q -o "$2.field.h5"
  critpoints -q "$2.field.h5" -o "$2.crit.json"
  if [[ $(jq -r .form "$2.crit.json") == phase ]]; then
    fieldsolve -q --nodes "$2.crit.json" --orders "$2.field.h5" "$2.tri.h5" | padapt -q -o "$2.phase.h5"
    mv "$2.phase.h5" "$2.field.h5"
  fi
  separatrix -q "$2.field.h5" "$2.crit.json" -o "$2.sep.json"
}

same() { run -0 "$BATS_TEST_DIRNAME/same_layout.py" "$@"; }

# same_when_moved SHAPE: turned, mirrored, scaled, moved far away.
same_when_moved() {
  local step=$DATA/$1.step
  layout "$step" original
  same_layout_moved() {
    layout moved.step moved
    same "$@" original.sep.json moved.sep.json 1e-7
  }
  each_motion "$step" same_layout_moved <<END
--rotate 37
--mirror
--mirror --rotate 71
--scale 1e-3
--scale 1e3
--move 60000 -30000
END
}

@test "the half disc's layout is the same when it moves" { same_when_moved half_disc; }
@test "the disc's layout is the same when it moves" { same_when_moved disc; }
@test "the annulus' layout is the same when it moves" { same_when_moved annulus; }
@test "plate_hole's layout is the same when it moves" { same_when_moved plate_hole; }
@test "geometry_1's layout is the same when it moves" { same_when_moved geometry_1; }
@test "geometry_3's layout is the same when it moves" { same_when_moved geometry_3; }
@test "small_fillets' layout is the same when it moves" { same_when_moved small_fillets; }

# same_on_meshes SHAPE...: with triangles of half and of twice the default size, orders 4 and 12 to begin with.
same_on_meshes() {
  for name in "$@"; do
    layout "$DATA/$name.step" default
    while read -r size order; do
      layout "$DATA/$name.step" other "$size" "$order"
      same default.sep.json other.sep.json 1e-7
    done <<END
0.125 4
0.5 12
END
  done
}

@test "layouts of smooth shapes do not depend on the mesh" { same_on_meshes half_disc disc ellipse stadium; }
@test "layouts of shapes with corners do not depend on the mesh" { same_on_meshes geometry_1 geometry_3 geometry_4 l_shape; }
@test "layouts of shapes with holes do not depend on the mesh" { same_on_meshes annulus eccentric_annulus plate_hole; }
@test "layouts of shapes with fillets do not depend on the mesh" { same_on_meshes small_fillets gear_filleted; }

# symmetric SHAPE EXPECTED: how many isometries of the shape its layout has.
symmetric() {
  local step=$DATA/$1.step
  layout "$step" here
  run -0 "$BATS_TEST_DIRNAME/symmetric_layout.py" here.sep.json
  assert_output "kept $2"
}

@test "half_disc's layout has its one mirror" { symmetric half_disc "2 of 2"; }
@test "the square's layout has all its symmetries" { symmetric square "8 of 8"; }
@test "l_shape's layout has its mirror" { symmetric l_shape "2 of 2"; }
@test "quarter_annulus' layout has its mirror" { symmetric quarter_annulus "2 of 2"; }
@test "s_bend's layout has its half turn" { symmetric s_bend "2 of 2"; }
@test "the ellipse's layout has all its symmetries" { symmetric ellipse "4 of 4"; }
@test "the stadium's layout has all its symmetries" { symmetric stadium "4 of 4"; }
@test "the hexagon's layout has all its symmetries" { symmetric hexagon "12 of 12"; }
@test "geometry_1's layout has its mirror" { symmetric geometry_1 "2 of 2"; }
@test "geometry_4's layout has all symmetries of seven teeth" { symmetric geometry_4 "14 of 14"; }
@test "geometry_5's layout has its mirror" { symmetric geometry_5 "2 of 2"; }
@test "gear_filleted's layout has all symmetries of six teeth" { symmetric gear_filleted "12 of 12"; }
@test "eccentric_annulus' layout has its mirror" { symmetric eccentric_annulus "2 of 2"; }
@test "plate_4_holes' layout has all symmetries of the square" { symmetric plate_4_holes "8 of 8"; }
@test "flange_3_holes' layout has all symmetries of three holes" { symmetric flange_3_holes "6 of 6"; }
# Four nodes of valence 3 or four cuts have no larger finite group than the square's.
@test "the disc's layout has the symmetries of a square" { symmetric disc "8 of all"; }
@test "the annulus' layout has the symmetries of a square" { symmetric annulus "8 of all"; }

@test "the comparison sees a motion, a node and an arc that are not the same" {
  layout "$DATA/half_disc.step" a
  same a.sep.json a.sep.json 1e-12
  run -1 "$BATS_TEST_DIRNAME/same_layout.py" --rotate 1e-4 a.sep.json a.sep.json 1e-7
  assert_output --partial "off by"
  jq '(first(.nodes[] | select(.kind == "irregular")) | .position) |= [.[0] + 1e-5, .[1]]' a.sep.json >node.sep.json
  run -1 "$BATS_TEST_DIRNAME/same_layout.py" a.sep.json node.sep.json 1e-7
  assert_output --partial "irregular node at"
  jq '.splines[0].poles[1:-1] |= map([.[0] + 1e-5, .[1] + 2e-5])' a.sep.json >arc.sep.json
  run -1 "$BATS_TEST_DIRNAME/same_layout.py" a.sep.json arc.sep.json 1e-7
  assert_output --partial "arc by"
  jq '.arcs |= .[1:]' a.sep.json >fewer.sep.json
  run -1 "$BATS_TEST_DIRNAME/same_layout.py" a.sep.json fewer.sep.json 1e-7
  assert_output --partial "not the same graph"
  run -0 "$BATS_TEST_DIRNAME/symmetric_layout.py" node.sep.json
  assert_line "kept 1 of 2"
}

@test "a corner that absorbed a node launches lines beyond it: every face has four corners" {
  # A triangular hole in a narrow strip: its lowest corner absorbs a node of valence 5.
  printf '%s\n' '-3 -0.3' '3 -0.3' '3 0.3' '-3 0.3' '' '-1.7 0.2' '-1.3 0.2' '-1.5 -0.2' |
    "$ROOT/pipelines/points2step" --straight -o hole.step
  cad2tri hole.step | fieldsolve - | padapt - -o hole.field.h5
  critpoints hole.field.h5 -o hole.crit.json
  run -0 jq -c '[.corners[] | select(.source == "absorb") | .valence]' hole.crit.json
  assert_output '[4]'
  for layout in traced quantized; do
    separatrix hole.field.h5 hole.crit.json --layout $layout -o hole.sep.json
    run -0 jq -c '[.certificate.face_valence_histogram[].corners]' hole.sep.json
    assert_output '[4]'
    run -0 --separate-stderr blocksplit hole.sep.json -o hole.blocks.h5
    run -0 --separate-stderr quadrefine hole.blocks.h5 -o hole.quad.h5
  done
}

@test "a plate with unequal chamfers around a large hole has a layout of separatrices, soon" {
  printf '%s\n' '10 -3.6' '10 4.2' '8.3 5.868' '7.2 5.868' '3.6 9.468' '-10 9.468' '-10 -9.4' '3.3 -9.4' \
    '7.432 -5.268' '8.3 -5.268' '' '-6 -5.2' '6 -5.2' '6 5.2' '-6 5.2' |
    "$ROOT/pipelines/points2step" --straight --corner-angle 1 -o spiral.step
  run -0 --separate-stderr timeout 60 "$ROOT/pipelines/quadmesh" spiral.step -o spiral.msh --report spiral.json
  run -0 jq -r '.certificate.method' spiral.json
  assert_output --regexp '^(traced|quantized)$'
}

@test "zeros that the field does not decide cancel, symmetrically" {
  # All sides near the middle are at multiples of 45 degrees, so that v nearly vanishes on the curve u = 0 around the
  # turned hole; only the far circles make it change its sign there, with four zeros.
  awk 'BEGIN { pi = atan2(0, -1)
    print "-60 -10\n60 -10\n60 10\n-60 10\n\n0 -4\n4 0\n0 4\n-4 0"
    for (side = -1; side <= 1; side += 2) { print ""
      for (k = 0; k < 64; ++k) print side * 50 + 2 * cos(pi * k / 32), 2 * sin(pi * k / 32) } }' |
    "$ROOT/pipelines/points2step" -o turned.step
  run -0 --separate-stderr "$ROOT/pipelines/quadmesh" turned.step -o turned.msh --workdir . --report turned.json
  run -0 jq -c '[.certificate.method, .irregular_nodes, [.warnings[].code] - ["W-QUA-005"]]' turned.json
  assert_output '["traced",8,["W-NODE-004"]]'
  run -0 jq -c '[(.changes[] | select(.kind == "cancel") | [.kind, (.before | map(4 - .valence) | add), (.after | length)])]' turned.crit.json
  assert_output '[["cancel",0,0]]'
  # Both reflections keep the nodes. They do not keep the layout: without nodes the cross turns one way all round the hole.
  run -0 jq -c '[.critical_points[].position] as $all | [[1, -1], [-1, 1]] | map(. as $by | all($all[]; . as $p
    | any($all[]; (.[0] - $by[0] * $p[0] | fabs < 1e-6) and (.[1] - $by[1] * $p[1] | fabs < 1e-6))))' turned.crit.json
  assert_output '[true,true]'
}
