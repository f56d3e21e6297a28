# Charts of curved faces through the whole chain: half of a cap of the unit sphere, in stereographic projection.
load ../tools/common

CAP=$ROOT/tests/formats/chart/passed/cap.chart.h5

setup_file() {
  cd "$BATS_FILE_TMPDIR"
  cp "$CAP" cap.chart.h5
  cad2tri cap.chart.h5 -o cap.tri.h5
  fieldsolve cap.tri.h5 | padapt -o cap.field.h5
  critpoints cap.field.h5 -o cap.crit.json
  separatrix cap.field.h5 cap.crit.json -o cap.sep.json
  blocksplit cap.sep.json -o cap.blocks.h5
  quadrefine cap.blocks.h5 -o cap.quad.h5 --report cap.json
}

setup() {
  common_setup
  stem=$BATS_FILE_TMPDIR/cap
}

@test "every stage carries the chart along and keeps the rules" {
  for file in tri.h5 field.h5 crit.json sep.json blocks.h5 quad.h5; do
    run -0 stagecheck "$stem.$file"
  done
  h5dump -H "$stem.blocks.h5" | grep -q space_nodes
  assert_equal "$(jq '.face.chart.closedness' "$stem.sep.json")" 1e-09
  assert_equal "$(jq -r '[.provenance[].tool] | join(" ")' "$stem.sep.json")" \
    "cad2chart cad2tri fieldsolve padapt separatrix"
}

@test "the chart in JSON keeps the schema and is that of HDF5; critical points are without it" {
  assert_equal "$(jq '.face | has("chart")' "$stem.crit.json")" false
  /usr/bin/python3 - "$ROOT/formats" "$stem" <<'PYTHON'
import base64, json, sys, h5py, jsonschema, numpy
formats, stem = sys.argv[1:]
for name, file in ("separatrix-graph", "sep"), ("critical-points", "crit"):
    content = json.load(open(f"{stem}.{file}.json"))
    jsonschema.Draft7Validator(json.load(open(f"{formats}/{name}.schema.json"))).validate(content)
chart = json.load(open(f"{stem}.sep.json"))["face"]["chart"]
with h5py.File(f"{stem}.chart.h5") as file:
    for name in "nodes", "space_nodes", "uv", "log_scale":
        assert numpy.array_equal(numpy.frombuffer(base64.b64decode(chart[name]), "<f8"), file[f"face/chart/{name}"][()].ravel())
PYTHON
}

@test "elements are proved in space, within the tolerance of the surface" {
  assert_equal "$(jq -c '[.valid, .surface.distance <= .surface.tolerance, .warnings]' "$stem.json")" '[true,true,[]]'
}

@test "quadmesh makes the same of the chart in one command" {
  quadmesh -q "$CAP" -o cap.msh
  quadexport "$stem.quad.h5" -o stages.msh
  cmp cap.msh stages.msh
}

@test "quadmesh takes sizes and layers of a curved face" {
  quadmesh -q "$CAP" --wall axis:first=0.01,layers=3 --size 0.2 -o walls.msh --report walls.json
  grep -q '"valid": true' walls.json
}

@test "nodes of the mesh are on the unit sphere, in every format with coordinates in space" {
  for format in msh msh22 mfem nektar vtu vtu-bezier; do
    quadexport "$stem.quad.h5" --format $format -o cap.$format
  done
  sed -n '/^\$Nodes/,/^\$EndNodes/p' cap.msh22 | awk 'NF == 4 { r = sqrt($2^2 + $3^2 + $4^2); if (r < .99999 || r > 1.00001) exit 1; n++ } END { exit n < 100 }'
  grep -q 'VDim: 3' cap.mfem
  grep -q 'SPACE="3"' cap.nektar
  for format in ism-v2 inp re2 blockmesh; do
    run -1 quadexport "$stem.quad.h5" --format $format -o no
    assert_output --partial "meshes of the plane only, but this face is curved"
  done
  assert_file_not_exist no
}

@test "quadmesh refuses formats of the plane before the work begins" {
  run -2 quadmesh "$CAP" -o no.re2 --report no.json
  assert_output --partial "the format re2 supports meshes of the plane only"
  assert_file_not_exist no.re2
  assert_equal "$(jq -c '.stages | keys' no.json)" '["cad2tri"]'
}

@test "blocks are faces of the exact surface in a STEP model, with their names" {
  quadexport "$stem.blocks.h5" -o cap.step
  quadexport - --format step <"$stem.blocks.h5" >piped.step
  cmp cap.step piped.step
  grep -q B_SPLINE_SURFACE cap.step
  assert_equal "$(grep -c "ADVANCED_FACE('cap'" cap.step)" "$(h5dump -d /block2nodes "$stem.blocks.h5" | sed -nE 's/.*SIMPLE \{ \( ([0-9]+), 4 .*/\1/p')"
  grep -q "EDGE_CURVE('rim'" cap.step
  quadexport "$stem.blocks.h5" --block-groups -o named.step
  # Each is a face that is meshed by itself.
  for name in block_0 block_1; do cad2chart named.step --face $name -o $name.chart.h5; done
  stagecheck block_0.chart.h5 block_1.chart.h5
}

@test "messages and reports name places in space" {
  run -0 jq -e '[.. | objects | to_entries[] | select(.key | test("(position|place)$")) | .value
    | (length == 3) and (([.[] | . * .] | add) - 1 | fabs < 1e-4)] | length > 5 and all' "$stem.json"
  run -0 quadrefine "$stem.blocks.h5" -v -o again.quad.h5
  assert_output --regexp 'element [0-9]+ of cap at \(-?[.0-9]+, [.0-9]+, [.0-9]+\): scaled Jacobian'
}

@test "names are given as in the plane; options that change curves are refused" {
  cad2tri "$CAP" --name wall=rim -o named.tri.h5
  h5dump -d /face/curve_names named.tri.h5 | grep -q '"wall", "wall"\|"wall'
  for option in "--face 0" "--write-healed x.step"; do
    run -2 cad2tri "$CAP" $option -o no.tri.h5
    assert_output --partial "is not for charts"
  done
  assert_output --partial "cad2chart reports what it moves"
}

@test "options of healing are refused with a chart, whose curves are those in space" {
  for option in "--heal-tolerance 1e-4" "--fit-tolerance 0" "--blunt 0.1"; do
    run -2 cad2tri "$CAP" $option -o no.tri.h5
    assert_output --partial "${option% *} is not for charts"
  done
  for option in "--fit-tolerance 0" "--blunt 0.1"; do
    run -2 quadmesh -q "$DATA/curved/sphere_cap.step" $option -o no.msh
    assert_output --partial "${option% *} is not for charts"
  done
  quadmesh -q "$DATA/curved/sphere_cap.step" --heal-tolerance 1e-4 -o healed.msh
}

@test "sizes are lengths in space" {
  for size in 0.2 0.1; do
    quadrefine "$stem.blocks.h5" --size $size --size-rule nearest --relax none -o a.quad.h5 --report a.json
    jq .quads a.json
  done >counts
  # The area of the half cap is 2 pi 0.8^2 / (1 + 0.8^2) = 2.45.
  run -0 awk '{ r = $1 / (2.4519 / (NR == 1 ? .04 : .01)); if (r < .7 || r > 1.5) exit 1 }' counts
}

@test "--view shows the mesh in space, without it both" {
  stageview "$stem.quad.h5" -o both.svg
  assert_equal "$(grep -c ' in the chart<' both.svg)" 1
  grep -q 'id="a-elem-0"' both.svg
  grep -q 'id="b-elem-0"' both.svg
  for view in iso 1,0,0 0,0,-1; do
    stageview "$stem.quad.h5" --view $view -o view.svg
    assert_equal "$(grep -c 'id="elem-0"' view.svg)" 1
  done
  run -2 stageview "$stem.quad.h5" --view 0,0,0 -o no.svg
  run -2 stageview "$stem.quad.h5" --view iso -o no.html
  run -2 stageview "$stem.quad.h5" --view iso --window 0,0,1,1 -o no.svg
  run -2 stageview "$stem.tri.h5" --view iso -o no.svg
  stageview "$CAP" -o chart.svg
  stageview "$CAP" "$stem.tri.h5" "$stem.quad.h5" -o page.html
}

@test "wrong charts are refused with the rule" {
  for file in "$ROOT"/tests/formats/chart/failed/CHA-*; do
    run -3 cad2tri "$file" -o no.tri.h5
    assert_output --partial "CHA-R05"
  done
}

@test "positions in space name curves, regions and blocks; those of a plane are refused" {
  # The arc's ends are (+-0.976, 0, 0.22) on the sphere, its middle (0, 0.976, 0.22).
  cad2tri "$CAP" --name top@0.7,0.7,0.22 --name flat@0,0.01,1.01 -o named.tri.h5
  run -0 h5dump -d /face/curve_names named.tri.h5
  assert_output --regexp '"flat", "top[\\0"]*, "rim'
  printf '[{"near": [0.7, 0.7, 0.22], "name": "top"}]' >names.json
  cad2tri "$CAP" --boundary-names names.json -o same.tri.h5
  run -0 h5dump -d /face/curve_names same.tri.h5
  assert_output --regexp '"axis", "top[\\0"]*, "rim'
  run -3 cad2tri "$CAP" --name top@0.5,0.6 -o no.tri.h5
  assert_output --partial "--name top@0.5,0.6: (0.5, 0.6) has two coordinates, and this face is curved"
  run -3 cad2tri "$CAP" --name top@9,9,9 -o no.tri.h5
  assert_output --partial "away from the boundary"
  cad2tri "$CAP" --region-name shell@0,0.6,0.8 -o shell.tri.h5
  run -3 cad2tri "$CAP" --region-name shell@0,0.6,0.9 -o no.tri.h5
  assert_output --partial "off the face"
  printf '[{"at": [0.1, 0.1], "name": "first"}]' >blocks.json
  run -3 blocksplit "$stem.sep.json" --block-names blocks.json -o no.blocks.h5
  assert_output --partial "has two coordinates, and this face is curved"
  run -2 cad2tri "$CAP" --name farfield=rim -o no.tri.h5
  assert_output --partial "outer flow in the plane"
}

@test "sizes at points, in boxes and in tables are those at positions in space" {
  quadrefine "$stem.blocks.h5" --size 0.2 -o coarse.quad.h5 --report coarse.json
  printf '{"format": "size-field", "version": [1, 1], "points": [{"position": [0, 0.6, 0.8], "size": 0.03}]}' >point.json
  quadrefine "$stem.blocks.h5" --size 0.2 --size-field point.json -o point.quad.h5 --report point.json.report
  # The element that contains the point is nearly as small as prescribed.
  quadexport point.quad.h5 --format msh22 -o point.msh22
  run -0 awk '/^\$Nodes/ { on = 1 } /^\$End/ { on = 0 } on && NF == 4 && ($2^2 + ($3 - .6)^2 + ($4 - .8)^2 < .03^2) { n++ } END { exit n < 9 }' point.msh22
  (( $(jq .quads point.json.report) > 2 * $(jq .quads coarse.json) ))
  # A table of the same sizes everywhere is --size.
  { echo x,y,z,size; for x in -.9 -.5 0 .5 .9; do for y in .05 .3 .6 .9; do
    awk -v x=$x -v y=$y 'BEGIN { r = x * x + y * y; if (r < 1) print x "," y "," sqrt(1 - r) ",0.1" }'; done; done; } >table.csv
  quadrefine "$stem.blocks.h5" --size-field table.csv -o table.quad.h5 --report table.json
  quadrefine "$stem.blocks.h5" --size 0.1 -o constant.quad.h5 --report constant.json
  assert_equal "$(jq .quads table.json)" "$(jq .quads constant.json)"
  printf 'x,y,size\n0,0,.1\n1,0,.1\n0,1,.1\n' >sizes.csv
  run -2 quadrefine "$stem.blocks.h5" --size-field sizes.csv -o no.quad.h5
  assert_output --partial "--size-field: this face is curved: positions on it are those in space"
}

@test "a metric in space has lengths by direction; one of a plane is refused" {
  # Edges of 0.05 along the z axis, of 0.2 across.
  { echo x,y,z,m11,m12,m13,m22,m23,m33; for x in -.9 -.5 0 .5 .9; do for y in .05 .3 .6 .9; do
    awk -v x=$x -v y=$y 'BEGIN { r = x * x + y * y; if (r < 1) print x "," y "," sqrt(1 - r) ",25,0,0,25,0,400" }'
  done; done; } >metric.csv
  quadrefine "$stem.blocks.h5" --metric metric.csv -o metric.quad.h5
  stagecheck metric.quad.h5
  fieldsolve "$stem.tri.h5" --align metric.csv -o aligned.field.h5 --report aligned.json
  (( $(jq '.["align.rms_degrees"] < 45' aligned.json | grep -c true) == 1 ))
  printf 'x,y,h1,h2,angle\n0,0,.1,.2,0\n1,0,.1,.2,0\n0,1,.1,.2,0\n' >plane.csv
  run -2 quadrefine "$stem.blocks.h5" --metric plane.csv -o no.quad.h5
  assert_output --partial "--metric: this face is curved: a metric on it has the columns x, y, z, m11"
  run -2 fieldsolve "$stem.tri.h5" --align plane.csv -o no.field.h5
  assert_output --partial "--align: this face is curved"
  printf '{"format": "alignment", "version": [1, 0], "points": [{"position": [0, 0], "angle": 0}]}' >angle.json
  run -2 fieldsolve "$stem.tri.h5" --align angle.json -o no.field.h5
  assert_output --partial "have positions and angles in a plane"
}

@test "sides of elements on a surface are not straight" {
  run -2 quadrefine "$stem.blocks.h5" --straight-sides -o no.quad.h5
  assert_output --partial "--straight-sides: this face is curved"
}

@test "heights of layers are lengths in space where the scale varies along the wall" {
  # The axis is a great circle, along which lengths in space are 1.2 to 2 times those of the chart: the distance of a
  # point from it is asin y.
  quadrefine "$stem.blocks.h5" --wall axis:first=0.01,layers=3 --order 4 -o wall.quad.h5
  quadexport wall.quad.h5 --format msh22 -o wall.msh22
  run -0 awk '/^\$Nodes/ { on = 1 } /^\$End/ { on = 0 }
    on && NF == 4 && $3 > .009 && $3 < .0115 { n++; h = atan2($3, sqrt(1 - $3^2)); if (h < .00999 || h > .01001) exit 1 }
    END { exit n < 20 }' wall.msh22
}
