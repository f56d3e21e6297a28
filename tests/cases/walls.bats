# Layers along walls, measured from the mesh's vertices and the CAD curves alone (benchmarks/wall_heights).
load ../tools/common

# blocks SHAPE: x.blocks.h5.
blocks() {
  cad2tri -q "$DATA/$1.step" -o a.tri.h5
  fieldsolve -q a.tri.h5 | padapt -q -o a.field.h5
  critpoints -q a.field.h5 -o a.crit.json
  separatrix -q a.field.h5 a.crit.json | blocksplit -q -o x.blocks.h5
}

# layers FIRST NAMES: x.quad.h5 with as many layers as fit, and their number.
layers() {
  quadrefine -q x.blocks.h5 --wall "$2:first=$1,growth=1.2,layers=fit" -o x.quad.h5 --report x.json
  run -0 stagecheck x.quad.h5
  number=$(jq '.walls["0"].layers' x.json)
}

# good_layers FIRST GROWTH NAME...: first height within 5 %, GROWTH at most between adjacent edges of all lines from wall
# to wall, and quality.
good_layers() {
  wall_heights x.quad.h5 "$1" "$number" "${@:3}" > heights.json
  run jq ".deviation <= 0.05 and .growth_with_corners <= $2" heights.json
  assert_output true
  run jq '.valid and .least_scaled_jacobian > 0.8' x.json
  assert_output true
}

@test "around the NACA 0012: a first cell of 1e-4 chords, and as many layers as fit" {
  blocks geometry_5
  layers 1e-4 curve_4,curve_5
  assert [ "$number" -ge 12 ]
  good_layers 1e-4 1.4 curve_4 curve_5
}

@test "around four holes at once" {
  blocks plate_4_holes
  layers 1e-3 curve_4,curve_5,curve_6,curve_7
  assert [ "$number" -ge 12 ]
  good_layers 1e-3 1.6 curve_4 curve_5 curve_6 curve_7
}

@test "along all walls of a channel with a step, through its corners" {
  blocks backward_step
  layers 2e-3 curve_0,curve_1,curve_2,curve_3,curve_4,curve_5
  good_layers 2e-3 1.3 curve_0 curve_1 curve_2 curve_3 curve_4 curve_5
}

@test "along all sides of a gear with fillets" {
  blocks gear_filleted
  names=$(seq -f curve_%g -s, 0 36)
  layers 3e-4 "$names"
  good_layers 3e-4 1.3 ${names//,/ }
}

# own SHAPE NAMES LAYERS: work/SHAPE.quad.h5 with layers in blocks of their own.
own() {
  "$ROOT/pipelines/quadmesh" -q "$DATA/$1.step" --wall "$2:$3,blocks=own" --workdir work -o x.vtu
  quadrefine -q work/"$1.blocks.h5" --wall "$2:$3,blocks=own" -o x.quad.h5 --report x.json
  run -0 stagecheck x.quad.h5
  number=$(jq '.walls["0"].layers' x.json)
}

@test "40 layers in blocks of their own around a hole, no irregular node among them" {
  own plate_hole curve_4 first=1e-4,growth=1.15,layers=40
  assert_equal "$number" 40
  good_layers 1e-4 1.31 curve_4
  run jq '.critical_points | length' work/plate_hole.crit.json
  assert_output 4
}

@test "quadmesh moves irregular nodes away from walls, so that all layers fit" {
  local wall=curve_4:first=1e-4,growth=1.15,layers=40
  "$ROOT/pipelines/quadmesh" -q "$DATA/plate_hole.step" --wall $wall --workdir work -o x.vtu --report x.json
  run jq -c '[.valid, .least_scaled_jacobian > 0.9]' x.json
  assert_output '[true,true]'
  wall_heights work/plate_hole.quad.h5 1e-4 40 curve_4 >heights.json
  run jq '.deviation < 0.01 and .growth < 1.2 and .growth_with_corners < 1.35' heights.json
  assert_output true
  run -0 "$ROOT/pipelines/quadmesh" "$DATA/plate_hole.step" --wall $wall --dry-run -o x.vtu
  assert_output --regexp 'critpoints .* --clearance curve_4=0.4[0-9]* '
  run -0 "$ROOT/pipelines/quadmesh" "$DATA/plate_hole.step" --wall $wall --clearance curve_4=0.5 --dry-run -o x.vtu
  assert_output --regexp 'critpoints .* --clearance curve_4=0.5 '
  refute_output --partial 'curve_4=0.4'
  run -0 "$ROOT/pipelines/quadmesh" "$DATA/plate_hole.step" --wall curve_4:first=1e-4,layers=fit --dry-run -o x.vtu
  refute_output --partial clearance
}

@test "along walls, elements are so short that straight sides for OpenFOAM do not cross the layers" {
  local wall=curve_4:first=1e-3,layers=3
  run -0 "$ROOT/pipelines/quadmesh" "$DATA/plate_hole.step" --wall $wall --dry-run -o blockMeshDict
  assert_output --regexp 'quadrefine .* --straight-sides'
  run -0 "$ROOT/pipelines/quadmesh" "$DATA/plate_hole.step" --wall $wall --dry-run -o x.msh
  refute_output --partial straight-sides
  run -0 "$ROOT/pipelines/quadmesh" "$DATA/plate_hole.step" --dry-run -o blockMeshDict
  refute_output --partial straight-sides
  # Elements of order 1 have straight sides: a third of the first height, and more where lengths are uneven.
  "$ROOT/pipelines/quadmesh" -q "$DATA/plate_hole.step" --wall $wall --workdir work -o blockMeshDict --order 1 \
    --report straight.json
  quadrefine -q work/plate_hole.blocks.h5 --wall $wall -o x.quad.h5 --order 1 --report x.json
  run jq -n '[inputs.boundary.mesh_to_cad] | .[0] < 6e-4 and .[1] > 2 * .[0]' straight.json x.json
  assert_output true
}

@test "layers in blocks of their own have the height that y+ requires" {
  local flow=(--velocity 30 --viscosity 1e-5 --length 1)
  "$ROOT/pipelines/quadmesh" -q "$DATA/plate_hole.step" --wall curve_4:yplus=200,layers=8,blocks=own "${flow[@]}" \
    --workdir work -o x.vtu
  quadrefine -q work/plate_hole.blocks.h5 --wall curve_4:yplus=200,layers=8,blocks=own "${flow[@]}" -o x.quad.h5 \
    --report x.json
  assert_equal "$(jq '.walls["0"].layers' x.json)" 8
  good_layers "$(jq '.walls["0"].first' x.json)" 1.35 curve_4
  run -0 h5dump -d /face/region_names x.quad.h5
  assert_output --partial '"domain", "domain"' # one region to a solver, as without blocks of their own
  run -2 "$ROOT/pipelines/quadmesh" "$DATA/plate_hole.step" --wall curve_4:yplus=200,layers=8,blocks=own "${flow[@]}" \
    --unit cm -o x.vtu
  assert_output --partial 'blocks=own with yplus needs the flow in units of the CAD file: leave --unit out'
}

@test "layers in blocks of their own along walls with corners, up to inlet and outlet" {
  own backward_step curve_0,curve_1,curve_2 first=1e-3,growth=1.2,layers=12
  good_layers 1e-3 1.3 curve_0 curve_1 curve_2
}

@test "around a sharp aerofoil layers in blocks of their own go around the tail" {
  own geometry_5 curve_4,curve_5 first=1e-4,growth=1.2,layers=25
  run jq -c '[.valid, .least_scaled_jacobian > 0.5, .walls["0"].layers]' x.json
  assert_output '[true,true,25]'
  run jq '.critical_points | length' work/geometry_5.crit.json
  assert_output 2
}

@test "two aerofoils share their gap, with layers of their own thicker than half of it" {
  own two_elements main,flap first=1e-3,growth=1.2,layers=11
  assert_equal "$number" 11
  good_layers 1e-3 1.3 main flap
  run jq -c '[.quads < 40000, .walls["0"].least_thickness < 0.4 * .walls["0"].thickness]' x.json
  assert_output '[true,true]'
  run jq '.critical_points | length' work/two_elements.crit.json
  assert_output 4
}

# elements: points of the aerofoil of make_shapes.py and of its flap.
elements() {
  awk 'function half(x) { return 0.6 * (0.2969 * sqrt(x) - 0.1260 * x - 0.3516 * x^2 + 0.2843 * x^3 - 0.1036 * x^4) }
    BEGIN {
      pi = atan2(0, -1); n = 60
      for (body = 0; body < 2; ++body) {
        c = body ? 0.3 * cos(pi / 9) : 1; s = body ? -0.3 * sin(pi / 9) : 0
        for (k = 0; k < 2 * n; ++k) {
          x = (1 + cos(pi * k / n)) / 2; y = (k < n ? 1 : -1) * (k ? half(x) : 0)
          printf "%.9f %.9f\n", (body ? 0.96 : 0) + c * x - s * y, (body ? -0.05 : 0) + s * x + c * y
        }
        print ""
      }
    }'
}

@test "two aerofoils in a far field: edges grow evenly in the gap and around both" {
  elements > elements.txt
  for far in cgrid:20,1.3 box:5,1.3; do
    "$ROOT/pipelines/points2step" -q elements.txt --name main,flap --farfield "${far%,*}" -o far.step
    "$ROOT/pipelines/quadmesh" -q far.step --wall main,flap:first=1e-3,growth=1.2,layers=11,blocks=own \
      --workdir work --until quadrefine --report x.json
    # Chords that carry the layers into the far field are thin on purpose, and not divided for their side ratios.
    run jq -c '[.valid, .least_scaled_jacobian > 0.5, .quads < 80000]' x.json
    assert_output '[true,true,true]'
    wall_heights work/far.quad.h5 1e-3 11 main flap > heights.json
    run jq ".deviation <= 0.01 and .growth_with_corners <= ${far#*,}" heights.json
    assert_output true
  done
}

# close_layers FARFIELD BLOCKS QUADS: layers with blocks of their own around the bodies of bodies.xy; at most that many.
close_layers() {
  "$ROOT/pipelines/quadmesh" -q bodies.xy --farfield "$1" --wall body:first=1e-3,growth=1.2,layers=12,blocks=own \
    --workdir work --until quadrefine --report x.json
  run jq -c "[.valid, .least_scaled_jacobian > 0.4, .blocks <= $2, .quads <= $3]" x.json
  assert_output '[true,true,true,true]'
  wall_heights work/bodies.quad.h5 1e-3 12 body >heights.json
  run jq '.deviation < 1e-6 and .growth_with_corners <= 1.32' heights.json
  assert_output true
}

@test "around several bodies layers in blocks of their own close at the corners" {
  printf '%s\n' '0 0' '1 0' '1 1' '0 1' '' '2.5 0.2' '3.5 0.2' '3.5 1.2' '2.5 1.2' '' '5 -1' '6 -1' '5.5 0' >bodies.xy
  close_layers box:6 36 40000
  close_layers circle:6 64 120000
}

@test "layers that close around two equal squares are symmetric" {
  printf '%s\n' '0 0' '1 0' '1 1' '0 1' '' '2.5 0' '3.5 0' '3.5 1' '2.5 1' >bodies.xy
  close_layers box:6 21 24000
  run -0 "$BATS_TEST_DIRNAME/symmetric_layout.py" --tolerance 1e-6 work/bodies.sep.json
  assert_output --regexp '^kept ([0-9]+) of \1'
}
