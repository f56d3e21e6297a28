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
  python3 - "$ROOT/formats" "$stem" <<'PYTHON'
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
  for option in "--face 0" "--offset rim=0.1" "--periodic axis=rim" "--write-healed x.step"; do
    run -2 cad2tri "$CAP" $option -o no.tri.h5
    assert_output --partial "is not for charts"
  done
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

@test "places of a plane are refused on a curved face" {
  printf 'x,y,h1,h2,angle\n0,0,.1,.2,0\n1,0,.1,.2,0\n0,1,.1,.2,0\n' >metric.csv
  printf 'x,y,size\n0,0,.1\n1,0,.1\n0,1,.1\n' >sizes.csv
  run -2 quadrefine "$stem.blocks.h5" --metric metric.csv -o no.quad.h5
  assert_output --partial "this face is curved"
  run -2 quadrefine "$stem.blocks.h5" --size-field sizes.csv -o no.quad.h5
  assert_output --partial "this face is curved"
  run -2 fieldsolve "$stem.tri.h5" --align metric.csv -o no.field.h5
  assert_output --partial "this face is curved"
}
