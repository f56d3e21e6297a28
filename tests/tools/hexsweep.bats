# hexsweep: quads in, curved hexahedra out.
load common

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
}

setup() {
  common_setup
  quads=$BATS_FILE_TMPDIR/half_disc.quad.h5
}

# names_of FILE: its groups of faces.
names_of() {
  h5dump -A 0 -d /face_groups/name "$1" | sed 's/\\000//g' | grep -oE '"[a-z_0-9]+"' | tr -d '"' | xargs
}

# heights_of FILE: those of its nodes, each once, ascending.
heights_of() {
  h5dump -A 0 -d /nodes -m %.9g -w 200 "$1" | sed -nE 's/.*\([0-9]+,0\): [^,]+, [^,]+, ([^,]+),?$/\1/p' | sort -gu
}

@test "writes a mesh silently, which is valid and has all names" {
  run hexsweep "$quads" --height 0.5 --layers 2 -o a.hex.h5
  assert_success
  assert_output ""
  assert_nothing_left a.hex.h5
  run stagecheck a.hex.h5
  assert_success
  run -0 names_of a.hex.h5
  assert_output 'curve_0 curve_1 bottom top'
}

@test "gives the same bytes through pipes, twice and on two threads" {
  hexsweep "$quads" --height 1 --twist 40 --taper 0.8 --layers 3 -o a.hex.h5 --threads 1
  hexsweep --height 1 --twist 40 --taper 0.8 --layers 3 --threads 2 <"$quads" >b.hex.h5
  cmp a.hex.h5 b.hex.h5
}

@test "every motion is proved valid and passes the check" {
  printf 'x,y,z\n0,0.5,0\n0,0.6,0.5\n0.1,0.8,1\n0.2,1.2,1.4\n' >curve.csv
  for motion in "--along 0.3,0.1,1" "--along 0,0,-1" "--curve curve.csv" "--revolve 90 --axis -3,0,-3,1" \
    "--revolve -90 --axis -3,0,-3,1" "--revolve 360 --axis -3,0,-3,1" "--height 1 --twist 90" "--height 1 --taper 0.3"; do
    hexsweep "$quads" $motion --layers 6 -o a.hex.h5 --report a.json
    run jq -c '[.layers, .valid, .unproved_elements, .least_jacobian_bound > 0]' a.json
    assert_output "[6,true,0,true]"
    run stagecheck a.hex.h5
    assert_success
  done
}

@test "layers have the heights that are prescribed at both ends" {
  hexsweep "$quads" --height 1 --bottom-layers first=0.01,growth=1.3,layers=4 --top-layers first=0.02,layers=2 -o a.hex.h5
  stagecheck a.hex.h5
  heights_of a.hex.h5 >heights
  for height in 0 0.01 0.023 0.0399 0.06187 0.956 0.98 1; do grep -qx "$height" heights; done
}

@test "terrain moves the bottom, the top stays flat" {
  for x in -2 -1 0 1 2; do for y in -2 -1 0 1 2; do echo "$x,$y,0.$((x * x + y * y))"; done; done >hills.csv
  hexsweep "$quads" --height 2 --terrain hills.csv --layers 2 -o a.hex.h5
  stagecheck a.hex.h5
  run -2 hexsweep "$quads" --height 0.1 --terrain hills.csv -o b.hex.h5
  assert_output --partial "the top must lie above it"
  head -n 24 hills.csv >broken.csv
  run -2 hexsweep "$quads" --height 2 --terrain broken.csv -o b.hex.h5
  assert_output --partial "24 points are no rectangular grid, which has a height at each pair of its x and y, here 5 different x and 5"
  awk 'BEGIN { srand(1); for (i = 0; i < 200000; ++i) print 4 * rand() - 2 "," 4 * rand() - 2 ",0" }' >scattered.csv
  run -2 hexsweep "$quads" --height 2 --terrain scattered.csv -o b.hex.h5
  assert_output --partial "interpolate them to one of at least 2 x 2 points first"
  printf '0,0,0\n0,.1,0\n.1,0,0\n.1,.1,0\n' >small.csv
  run -2 hexsweep "$quads" --height 2 --terrain small.csv -o b.hex.h5
  assert_output --partial "the face reaches beyond its points"
}

@test "without a motion, layers are as high as the quads are long" {
  hexsweep "$quads" -o a.hex.h5 --report a.json
  assert_equal "$(jq .layers a.json)" 1
  hexsweep "$quads" --layers 3 -o b.hex.h5 --report b.json
  assert_equal "$(jq .layers b.json)" 3
  run jq -n '[inputs.least_jacobian_bound] | .[0] / .[1] | . > 0.999 and . < 1.001' a.json b.json
  assert_output true
}

@test "one layer has periodic ends" {
  hexsweep "$quads" --one-layer -o a.hex.h5 --report a.json
  assert_equal "$(jq .layers a.json)" 1
  stagecheck a.hex.h5
  h5dump -d /face_groups/periodic_with a.hex.h5 | grep -qE '\(0\): -1, -1, 3, -1|-1, [1-9]'
}

@test "a full turn whose end is not its beginning, or that shall have ends, is refused" {
  for options in "--taper 0.5" "--twist 180"; do
    run -2 hexsweep "$quads" --revolve 360 --axis -3,0,-3,1 $options --layers 8 -o a.hex.h5
    assert_output --partial "its end is not its beginning"
  done
  for options in --one-layer --periodic-ends "--bottom-name inlet" "--top-name outlet"; do
    run -2 hexsweep "$quads" --revolve -360 --axis -3,0,-3,1 $options -o a.hex.h5
    assert_output --partial "has no ends"
  done
  assert_nothing_left
}

@test "a sweep that is a rounding error is refused" {
  run -2 hexsweep "$quads" --height 1e-300 -o a.hex.h5
  assert_output --partial "diameters of the face long"
  run -2 hexsweep "$quads" --revolve 1e-200 --axis -3,0,-3,1 -o a.hex.h5
  assert_output --partial "radians long"
  assert_nothing_left
}

@test "a sweep that is too long for layers like the quads is refused at once" {
  run -2 hexsweep "$quads" --height 1e160 -o a.hex.h5
  assert_output --partial "give --layers or a shorter sweep"
  assert_nothing_left
}

@test "a mesh that would fill the memory is refused at once, with how much it takes" {
  if nm "$BIN/hexsweep" | grep -q __asan_init; then skip "built with sanitizers, which take terabytes of addresses"; fi
  run -1 bash -c "ulimit -v 4000000; exec hexsweep '$quads' --height 1 --layers 2000 -o a.hex.h5"
  assert_output --regexp '^hexsweep: [0-9]+ quads of order 4 in 2000 layers take about [0-9.]+ GiB of memory, and there are 3.8 GiB: take fewer layers, coarser quads or a lower order$'
  run -1 hexsweep "$quads" --height 1 --layers 100000 -o a.hex.h5
  assert_output --partial 'in 100000 layers have too many nodes for one mesh'
  assert [ ! -e a.hex.h5 ]
  run -0 bash -c "ulimit -v 4000000; exec hexsweep '$quads' --height 1 --layers 100 -o a.hex.h5"
}

@test "a sweep that does not lead out of the face is refused, on a curved face too" {
  printf '0,0,0\n1,0,0\n2,1,0\n' >flat.csv
  for motion in "--along 1,0,0" "--curve flat.csv" "--along 1,2,1e-9" "--revolve 90 --axis 5,0,0,5,0,1"; do
    run -2 hexsweep "$quads" $motion -o a.hex.h5
    assert_output --regexp 'hexsweep: at \(.*\) the sweep does not lead out of the face, whose normal is \(0, 0, 1\) there: choose a direction or an axis'
  done
  "$ROOT/pipelines/quadmesh" -q --face 0 "$DATA/curved/cap_circle.step" --until quadrefine --workdir .
  run -2 hexsweep cap_circle.quad.h5 --along 1,0,0 -o a.hex.h5
  assert_output --partial 'the sweep does not lead out of the face, whose normal is ('
  hexsweep cap_circle.quad.h5 --along 0.2,0,1 -o a.hex.h5
  hexsweep cap_circle.quad.h5 --along=-0.2,0,-1 -o b.hex.h5
}

@test "a curve that turns back is refused" {
  printf '0,0,0\n0,0,1\n0,0,0\n' >back.csv
  run -1 hexsweep "$quads" --curve back.csv -o a.hex.h5
  assert_output --partial "--curve must not turn back on itself"
  assert_nothing_left back.csv
}

@test "a face that touches or crosses the axis is refused with a remedy" {
  for axis in 0,0,0,1 0,0,1,0; do
    run -2 hexsweep "$quads" --revolve 90 --axis $axis -o a.hex.h5
    assert_output --regexp "the face (touches|crosses) the axis"
    assert_output --partial "move --axis"
  done
  assert_nothing_left
}

@test "an element that cannot be proved ends with 1, and is written only if that is asked for" {
  quadrefine --order 1 "$BATS_FILE_TMPDIR/half_disc.blocks.h5" -o a.quad.h5
  run -1 hexsweep a.quad.h5 --height 1 --twist 180 --layers 1 -o a.hex.h5
  assert_output --partial "cannot be proved valid; the worst lies at"
  assert_output --partial "take more layers"
  assert_nothing_left a.quad.h5
  run -0 hexsweep a.quad.h5 --height 1 --twist 180 --layers 1 -o a.hex.h5 --allow-invalid
  assert_output --partial "warning W-QUA-001"
  run -0 stagecheck a.hex.h5
  assert_output --partial "warning W-QUA-001"
}

@test "too few layers for the motion are told, and as many as it needs are the default" {
  run -0 hexsweep "$quads" --height 1 --twist 700 --layers 1 -o a.hex.h5 --report a.json
  assert_output --partial "warning W-HEX-002"
  assert [ "$(jq '.motion_error > 0.01' a.json)" = true ]
  run -0 hexsweep "$quads" --height 1 --twist 700 -o a.hex.h5 --report a.json
  assert_output ""
  assert [ "$(jq '.layers >= 47 and .motion_error < 1e-4' a.json)" = true ]
}

@test "options that exclude each other end with 2" {
  for options in "--height 1 --along 0,0,1" "--revolve 90" "--axis 0,0,0,1 --height 1" "--along 1,2" "--along 0,0,0" \
    "--height 1 --taper 0" "--height 1 --taper 0.5 --periodic-ends" "--one-layer --layers 2" "--height 1 --centre 0,0" \
    "--revolve 90 --axis 3,0,3,1 --bottom-layers first=0.1,layers=2" "--height 1 --bottom-layers layers=2" \
    "--height 1 --bottom-layers first=1,layers=2" "--height 1 --bottom-name top" "--revolve 361 --axis 3,0,3,1" \
    "--revolve 360 --axis 3,0,3,1 --layers 2" "--revolve 360 --axis 3,0,3,1 --periodic-ends" "--terrain x.csv"; do
    run hexsweep "$quads" $options -o a.hex.h5
    assert_failure 2
  done
  assert_nothing_left
}

@test "other input ends with 3" {
  run -3 hexsweep "$BATS_FILE_TMPDIR/half_disc.blocks.h5" --height 1 -o a.hex.h5
  echo "1,2" >points.csv
  run -3 hexsweep "$quads" --curve points.csv -o a.hex.h5
  assert_nothing_left points.csv
}

@test "pictures and pages show the outer faces" {
  hexsweep "$quads" --height 1 --twist 30 --layers 2 -o a.hex.h5
  stageview a.hex.h5 -o a.svg
  grep -q "Hexahedral mesh" a.svg
  stageview a.hex.h5 --view 0,-1,0 -o b.svg
  run ! cmp a.svg b.svg
  stageview a.hex.h5 -o a.html
  grep -q '"space":' a.html
}
