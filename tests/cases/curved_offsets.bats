# Layers in blocks of their own along walls of curved faces.
load ../tools/common

setup() {
  need_h5py
  common_setup
}

shapes=$DATA/curved_regions

# own FILE WALL LAYERS [OPTION ...]: work/*.h5 and report.json, with the layers in blocks of their own; nodes on offset
# curves lie on these in space.
own() {
  rm -rf work
  "$ROOT/pipelines/quadmesh" -q "$1" --wall "$2:$3,blocks=own" --workdir work --report report.json -o x.msh "${@:4}"
  run -0 jq -c '[.valid, .certificate.method]' report.json
  assert_output '[true,"traced"]'
  stagecheck -q work/*.h5 work/*.json
  assert_on_space_curves "$(echo work/*.quad.h5)"
}

# heights NAME SURFACE HEIGHT TOLERANCE: of the curve at a distance from the wall NAME, and all layers have theirs.
heights() {
  run -0 jq '.walls["0"] | .least_thickness / .thickness > 0.99999' report.json
  assert_output true
  run -0 /usr/bin/python3 "$BATS_TEST_DIRNAME/curved_heights.py" "$(echo work/*.quad.h5)" "$@"
  assert_output "ok"
}

@test "an O-grid around a hole in a cylinder, at its height in space" {
  own "$DATA/curved/half_cylinder_hole.step" curve_4 first=0.005,growth=1.2,layers=6 --size 0.2
  heights curve_4 cylinder 0.06457952 1e-7
  run -0 jq -c .blocks report.json
  assert_output 16
}

@test "around a hole in a part of a sphere" {
  own "$shapes/cap_hole.step" hole first=0.004,growth=1.2,layers=6 --size 0.15
  # Straight lines of the chart are no great circles: their difference is of third order.
  heights hole sphere 0.0516636 2e-6
}

@test "around a blade with two sharp ends on a cylinder, and at both ends of a tube" {
  own "$shapes/blade.step" blade first=0.004,growth=1.2,layers=6 --size 0.25
  own "$DATA/curved/tube.step" 0,1 first=0.004,growth=1.2,layers=6 --size 0.25
}

@test "along a wall from corner to corner, in each of two regions" {
  own "$shapes/halves.step" top first=0.005,growth=1.2,layers=4 --size 0.3
  own "$ROOT/tests/formats/chart/passed/cap.chart.h5" axis first=0.005,growth=1.2,layers=4
}

@test "curves with less room name the place in space, and those too near to their wall are refused" {
  run -0 cad2tri "$ROOT/tests/formats/chart/passed/cap.chart.h5" --offset rim=0.95 -o near.tri.h5
  assert_output --regexp 'W-CAD-009: --offset rim=0.95: .* near \([-.0-9e]+, [-.0-9e]+, [-.0-9e]+\)'
  run -2 cad2tri -q "$ROOT/tests/formats/chart/passed/cap.chart.h5" --offset rim=1e-9 -o no.tri.h5
  assert_output --partial "the distance is less than 1e-06 diameters of the face"
  assert_file_not_exist no.tri.h5
}
