# Several regions: the whole chain on the shapes of tests/data/regions, judged by the checker that shares no code.
load ../tools/common

setup() {
  need_h5py
  common_setup
}

# mesh_of NAME [OPTION ...]: work/NAME.*.h5 and report.json of the shape.
mesh_of() {
  "$ROOT/pipelines/quadmesh" "$DATA/regions/$1.step" -o x.vtu --order 8 --workdir work --report report.json "${@:2}"
}

# has BLOCKS QUALITY NAME [OPTION ...]: at most so many blocks, the least scaled Jacobian of the blocks at least this,
# separatrices in each region (no fallback). Once vertices have moved it is at least that less 0.1, or 0.58, and the mesh
# is what the checker and stagecheck ask for.
has() {
  rm -rf work
  mesh_of "${@:3}" --relax none --inner-edges curved
  run -0 jq -r ".blocks <= $1 and .least_scaled_jacobian >= $2 and .valid and .certificate.method != \"midpoint\"" report.json
  assert_output true
  mesh_of "${@:3}"
  run -0 jq -r ".least_scaled_jacobian >= ([$2 - 0.1, 0.58] | min) and .valid" report.json
  assert_output true
  run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" "work/$3.quad.h5" --area-tolerance 3e-8
  refute_output --partial FAULT
  stagecheck -q work/*.h5 work/*.json
}

# keeps ALL NAME [OPTION ...]: the layout has all symmetries of the shape.
keeps() {
  run -0 "$BATS_TEST_DIRNAME/symmetric_layout.py" "work/$2.sep.json" "${@:3}"
  assert_output "kept $1 of $1"
}

@test "regions beside each other: squares, T-joints, cells" {
  has 20 0.91 chequerboard_2_hole
  keeps 8 chequerboard_2_hole
  has 40 0.91 chequerboard_4_hole
  keeps 8 chequerboard_4_hole
  has 4 0.99 t_joint
  has 4 0.99 t_joint_open
  has 8 0.79 half_disc_cut
  keeps 4 half_disc_cut
  has 210 0.5 voronoi_20
}

@test "vertices on interfaces slide: thin chords of many regions become wider" {
  mesh_of voronoi_20 --size 0.5 --order 2
  run -0 jq -r ".greatest_edge_ratio.value < 15 and .resolution.ratio < 10 and .least_scaled_jacobian > 0.4" report.json
  assert_output true
  mesh_of voronoi_20 --size 0.5 --order 2 --relax none
  run -0 jq -r ".greatest_edge_ratio.value > 60" report.json
  assert_output true
}

@test "regions inside each other: discs, rings, a channel" {
  has 17 0.83 disc_in_square
  keeps 8 disc_in_square
  has 13 0.85 nested_rings
  has 9 0.85 pipe_wall
  keeps 2 pipe_wall
  has 17 0.68 pin_in_channel
}

@test "layered parts" {
  has 132 0.75 coated_gear
  keeps 12 coated_gear
  has 12 0.75 coated_cam
  has 30 0.4 layered_beam
  has 125 0.79 layered_cable
  keeps 6 layered_cable --tolerance 1e-6
  has 57 0.75 layered_seal
  has 80 0.75 pins
  keeps 4 pins
}

@test "embedded curves, closed, open, and a wake" {
  has 17 0.83 plate_circle
  keeps 4 plate_circle
  has 20 0.58 plate_curve
  has 6 0.99 inner_curve
  has 8 0.44 slit
  has 12 0.8 aerofoil_wake --geometry-tol 1e-9
}

# names: the names of the curves, in the order of their first curves.
names() { jq -r '[.face.curve_names | to_entries | unique_by(.value) | sort_by(.key)[].value] | join(" ")' "$1"; }

@test "embedded curves that meet at acute angles: their sectors are corners, open or not" {
  # The sharpest corners have 35, 35 and 30 degrees.
  has 22 0.573 cracks_x
  has 15 0.573 cracks_y
  has 30 0.499 crack_from_hole
  has 18 0.6 crack_askew
  has 24 0.573 cracks_x --open one --open two
  has 17 0.573 cracks_y --open stem --open upper --open lower
  run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" work/cracks_y.quad.h5
  assert_output --regexp 'cracks: 6 sides, [1-9][0-9]+ doubled nodes'
}

@test "embedded curves that lie upon each other keep both names" {
  has 6 0.99 cracks_along
  run -0 names work/cracks_along.sep.json
  assert_output "curve_0 curve_1 curve_2 curve_3 long short"
  has 6 0.99 cracks_equal
  run -0 names work/cracks_equal.sep.json
  assert_output "curve_0 curve_1 curve_2 curve_3 one+two"
}

@test "a region that touches itself where embedded curves or other faces meet" {
  has 60 0.62 patch_touching
  run -0 names work/patch_touching.sep.json
  assert_output --regexp "leg.* patch|patch.* leg"
  has 50 0.7 patches_touching
  has 60 0.62 patch_touching --open patch
  # Drawn as faces of their own.
  has 60 0.3 wedges_in_plate
}

# The distance of the nodes on the two sides of the slit: those of its ends are one.
@test "a crack has nodes of its own on both sides, its ends have one" {
  has 4 0.99 plate_crack
  run -0 h5dump -A -d nodes work/plate_crack.quad.h5
  local closed
  closed=$(grep -oE 'DATASPACE +SIMPLE \{ \( [0-9]+' <<<"$output" | grep -oE '[0-9]+$')
  local name
  name=$(jq -r '.face as $f | $f.curve_names[[$f.partners | to_entries[] | select(.value >= 0).key][0]]' work/plate_crack.sep.json)
  has 4 0.99 plate_crack --open "$name"
  run -0 h5dump -A -d nodes work/plate_crack.quad.h5
  local opened
  opened=$(grep -oE 'DATASPACE +SIMPLE \{ \( [0-9]+' <<<"$output" | grep -oE '[0-9]+$')
  assert [ "$opened" -gt "$closed" ]
}

@test "a nonconforming interface: no line crosses it; mistakes are refused" {
  mesh_of t_joint
  cd work
  separatrix --interface base-left=nonconforming --interface base-right=nonconforming t_joint.field.h5 \
    t_joint.crit.json -o open.sep.json
  # The line that the joint of the upper two would send into the lower one is missing.
  run -0 jq '.certificate.face_valence_histogram | map(.faces) | add' open.sep.json
  assert_output 3
  blocksplit open.sep.json -o open.blocks.h5
  stagecheck open.sep.json open.blocks.h5
  run -2 separatrix --interface base-left t_joint.field.h5 t_joint.crit.json -o no.sep.json
  assert_output --partial "expected NAME=nonconforming"
  run -2 separatrix --open nowhere t_joint.field.h5 t_joint.crit.json -o no.sep.json
  assert_output --partial "there is no boundary \"nowhere\""
  run -2 separatrix --open curve_0 t_joint.field.h5 t_joint.crit.json -o no.sep.json
  assert_output --partial "is a boundary"
}

# Without has: many blocks, of no great quality.
@test "midpoint division of several regions: blocks share the nodes of interfaces and slits" {
  local shape
  for shape in disc_in_square chequerboard_2_hole plate_crack; do
    rm -rf work
    mesh_of "$shape" --layout midpoint
    run -0 jq -r '"\(.valid) \(.certificate.method) \(.certificate.t_junctions) \(.warnings | map(.code))"' report.json
    assert_output --regexp '^true midpoint 0 \[("W-QUA-005")?\]$'
    run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" "work/$shape.quad.h5"
    refute_output --partial FAULT
    stagecheck -q work/*.h5 work/*.json
  done
}

@test "midpoint division is what auto takes for triangles of several regions, with a warning" {
  cad2tri "$DATA/regions/t_joint.step" -q -o t.tri.h5
  run -0 --separate-stderr separatrix t.tri.h5 -o t.sep.json --report report.json
  run -0 jq -r '.warnings[].code' report.json
  assert_output W-SEP-002
  separatrix t.tri.h5 --interface base-left=nonconforming -q -o open.sep.json
  stagecheck -q t.sep.json open.sep.json
  run -2 separatrix --layout traced t.tri.h5 -o no.sep.json
  assert_output --partial "needs a field"
}
