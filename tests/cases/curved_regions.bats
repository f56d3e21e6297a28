# Cracks and several regions on curved faces: the shapes of tests/data/curved_regions.
load ../tools/common

setup() {
  need_h5py
  common_setup
}

shapes=$DATA/curved_regions

# mesh_of NAME [OPTION ...]: work/NAME.*.h5 and report.json of the shape.
mesh_of() {
  rm -rf work
  "$ROOT/pipelines/quadmesh" -q "$shapes/$1.step" -o x.msh --order 5 --size .2 --workdir work --report report.json "${@:2}"
}

# holds NAME [OPTION ...]: every element is proved, stage files keep their rules, both sides of interfaces have the same
# nodes, and nodes are on the curves in space.
holds() {
  mesh_of "$@"
  run -0 jq -r '"\(.valid) \(.certificate.method != "midpoint")"' report.json
  assert_output "true true"
  stagecheck -q work/*.h5 work/*.json
  run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" "work/$1.quad.h5" --area-tolerance 1e-5
  refute_output --partial FAULT
  assert_on_space_curves "work/$1.quad.h5"
}

# nodes MSH: x y z of each node.
nodes() { awk '/^\$Nodes/ { on = 1 } /^\$EndNodes/ { on = 0 } on && NF == 3 { print }' "$1"; }

# curves NAME: number of regions, and the names of all curves that have two sides.
curves() {
  jq -r '.face as $f | [$f.region_names // [] | length, ([$f.partners | to_entries[] | select(.value >= 0) |
    $f.curve_names[.key]] | unique | join(" "))] | join(" ")' "work/$1.sep.json"
}

@test "the sample files are made by their generator" {
  mkdir made
  /usr/bin/python3 "$shapes/make_curved_regions.py" made
  diff -x '*.py' -x README.md made "$shapes"
}

@test "a crack inside, from a rim, on the line where the parameters close: elements end there from both sides" {
  for shape in crack crack_on_seam crack_from_rim tube_crack; do
    holds $shape
    run -0 curves $shape
    assert_output "0 crack"
  done
}

@test "--open makes two nodes of each on a crack, but at its tips" {
  holds crack
  assert_equal "$("$BATS_TEST_DIRNAME/nodes_on_space_curves.py" work/crack.quad.h5 | awk '$1 == "crack" { print $3 }')" 0
  holds crack --open crack
  run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" work/crack.quad.h5 --area-tolerance 1e-5
  assert_output --regexp 'cracks: 2 sides, [1-9][0-9]* doubled nodes'
}

@test "curves beside the face are embedded where they lie on it, and cut where they cross" {
  run -0 cad2chart "$shapes/cracks_free.step" -o a.chart.h5
  assert_output --partial "ignored 1 curve beside the face"
  holds cracks_free
  run -0 curves cracks_free
  assert_output "0 falling upright"
  assert_equal "$(jq '[.face.partners[] | select(. >= 0)] | length' work/cracks_free.sep.json)" 8
  holds ring_inside
  assert_equal "$(jq -c '.face.region_names' work/ring_inside.sep.json)" '["tube","tube"]'
}

@test "faces of one surface are regions of one chart, whatever entity each has for it" {
  for shape in halves halves_own halves_turned; do
    holds $shape
    run -0 curves $shape
    assert_output "2 front-back"
  done
  holds stack
  assert_equal "$(jq -c '.face.region_names' work/stack.sep.json)" '["lower","upper"]'
  run -0 curves stack
  assert_output "2 slant"
  holds window
  run -0 curves window
  assert_output "2 wall-pane"
  holds spline
  run -0 curves spline
  assert_output "2 one-two"
}

@test "tubes, also bent, of one face or two have no nodes inside, and elements of the prescribed size" {
  while read -r shape blocks options; do
    # shellcheck disable=SC2086
    "$ROOT/pipelines/quadmesh" -q "$shapes/$shape.step" $options -o "$shape.msh" --report report.json
    run -0 jq -c '[.irregular_nodes, .blocks, .resolution.ratio < 2.6, .least_scaled_jacobian > .98]' report.json
    assert_output "[0,$blocks,true,true]"
  done <<<'halves 2
tube_crack 3
elbow 4
elbow_halves 2'
  for shape in elbow elbow_halves; do
    run -0 "$BATS_TEST_DIRNAME/symmetric_surface.py" "$shape.msh" y z
    assert_equal "$(awk '$1 > 1e-6' <<<"$output")" ''
  done
}

@test "--face 0,1 chooses among more faces, of planes likewise" {
  "$ROOT/pipelines/quadmesh" -q "$shapes/halves.step" --face 0,1 -o both.msh
  "$ROOT/pipelines/quadmesh" -q "$shapes/halves.step" -o all.msh
  cmp <(nodes both.msh) <(nodes all.msh)
  "$ROOT/pipelines/quadmesh" -q "$shapes/halves.step" --face back -o one.msh
  assert [ "$(nodes one.msh | wc -l)" -lt "$(nodes both.msh | wc -l)" ]
  cad2tri -q "$DATA/regions/half_disc_cut.step" --face 0,1 -o two.tri.h5
  h5dump -d /face/region_names two.tri.h5 | grep -q '"upper", "lower"'
  run -3 cad2chart "$shapes/halves.step" --face 0,0 -o no.chart.h5
  assert_output --partial "--face 0,0: face 0 is there twice"
  run -3 cad2chart "$shapes/halves.step" --face 0,7 -o no.chart.h5
  assert_output --partial "--face 7: no face has this name or number"
}

@test "names and regions are given as in the plane" {
  mesh_of window --region-name shell=wall --region-name shell=pane
  assert_equal "$(jq -c '[.face.region_names, .face.name]' work/window.sep.json)" '[null,"shell"]'
  stagecheck -q work/*.h5 work/*.json
  mesh_of halves --region-name shell=front --region-name shell=back # two joints where the rims are smooth
  stagecheck -q work/*.h5 work/*.json
  mesh_of halves --name 'joint=interface:*'
  run -0 curves halves
  assert_output "2 joint"
}

@test "what is not one surface, overlaps or has gaps is refused with the remedy" {
  run -3 cad2chart "$shapes/bad_surfaces.step" --face 0,1 -o no.chart.h5
  assert_output --partial "face 0 'round' and face 1 'flat' lie on different surfaces"
  assert_output --partial "mesh these one by one"
  run -3 cad2chart "$shapes/bad_surfaces.step" -o no.chart.h5
  assert_output --partial "several faces (2 with 1 shared edges)"
  run -3 cad2chart "$shapes/bad_gap.step" -o no.chart.h5
  assert_output --regexp "face 0 'one' and face 1 'two' share no edge: they are 0.2 apart"
  run -3 cad2chart "$shapes/bad_overlap.step" -o no.chart.h5
  assert_output --partial "share no edge: they overlap, or only touch"
  assert_file_not_exist no.chart.h5
}

@test "C-, O- and H-grids around a blade on a cylinder, and layers along it" {
  mesh_of blade --wall blade:first=0.005,layers=4
  run -0 jq -r '.valid' report.json
  assert_output true
  stagecheck -q work/*.h5 work/*.json
  for topology in "o 6" "h 14" "c 8"; do
    read -r kind blocks <<<"$topology"
    mesh_of blade --topology "$kind" --size .3 --order 3
    run -0 jq -c '[.valid, .blocks, .certificate.method]' report.json
    assert_output "[true,$blocks,\"traced\"]"
  done
}

@test "the same bytes with any number of threads" {
  mesh_of stack
  mv work one
  mesh_of stack --threads 2
  cmp one/stack.sep.json work/stack.sep.json
  cmp one/stack.quad.h5 work/stack.quad.h5
}
