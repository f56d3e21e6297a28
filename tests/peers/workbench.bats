# The page of quadbench in Chromium: curves, corners and nodes by pointer and keys; the saved command makes the mesh that
# is shown. The server without a browser is tested in tests/cases/quadbench.bats.
load common

setup() {
  common_setup
  need chromium chromium-driver python3-selenium
  mkdir tmp shapes
}

teardown() {
  [[ -z ${bench-} ]] || kill -KILL "$bench" 2>/dev/null || :
}

# work_with SCENARIO SHAPE [OPTION...]: judge_workbench.py; then the mesh of the saved command is that of the page, and the
# server has ended with it.
work_with() {
  local scenario=$1 name
  shift
  name=$(basename "${1%.*}")
  TMPDIR=$PWD/tmp "$ROOT/pipelines/quadbench" "$@" --no-browser >address 2>messages 3>&- &
  bench=$!
  until [[ -s address ]]; do kill -0 $bench || fail "$(cat messages)"; sleep 0.1; done
  TMPDIR=$PWD/tmp run --separate-stderr "$PYTHON" "$ROOT/tests/peers/judge_workbench.py" \
    "$(sed 's/^quadbench: //' address)" "$scenario"
  echo "# $stderr" >&3
  assert_output ''
  assert_success
  wait $bench
  bench=
  "shapes/$name.quadmesh.sh" >/dev/null
  cmp shown.msh "shapes/$name.msh"
}

@test "circles, tangents, boxes, layers, drags, undo and failures on a flange" {
  cp "$DATA/flange_3_holes.step" shapes
  work_with flange shapes/flange_3_holes.step
}

@test "names, a corner and a node of two regions" {
  cp "$DATA/regions/pin_in_channel.step" shapes
  work_with regions shapes/pin_in_channel.step
}

@test "layers of an aerofoil, by keys alone" {
  awk 'BEGIN { print "foil"; for (k = 0; k <= 60; ++k) { a = k * atan2(0, -1) / 30
    printf "%.9f %.9f\n", (1 + cos(a)) / 2, sin(a) * sin(a / 2) / 8 } }' >shapes/foil.dat
  work_with aerofoil shapes/foil.dat --farfield cgrid:20
}

@test "a node by arrows, undo, redo, every button that saves; other pages are refused" {
  cp "$DATA/half_disc.step" shapes
  work_with keys shapes/half_disc.step
  assert_equal "$(ls shapes | paste -sd ' ')" \
    "half_disc.crit.json half_disc.mk half_disc.msh half_disc.quadmesh.sh half_disc.step"
  rm shapes/half_disc.msh
  (cd shapes && PATH=$BIN:$PATH make -s -f half_disc.mk >/dev/null)
  cmp shown.msh shapes/half_disc.msh
  run -0 stagecheck shapes/half_disc.crit.json
  (cd shapes && "$ROOT/pipelines/quadmesh" -q half_disc.step --nodes half_disc.crit.json -o nodes.msh)
  cmp shown.msh shapes/nodes.msh
}
