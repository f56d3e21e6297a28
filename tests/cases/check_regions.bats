# The checker of regions, which shares no code with the library, and meshes of the tools before it.
load ../tools/common

setup() {
  need_h5py
  common_setup
}

@test "every check of the checker fails on a damaged mesh" {
  run -0 /usr/bin/python3 "$ROOT/tests/check_regions_test.py"
  assert_line --regexp '^Ran 1[0-9] tests in '
}

@test "the checker accepts what quadrefine makes of a layout of two regions" {
  blocks=$ROOT/tests/formats/block_layout/passed/regions.blocks.h5
  for options in "--order 1 --size 0.3" "--order 4 --size 0.5 --relax shape --relax-sweeps 5" \
    "--order 3 --size 0.3 --wall fluid-solid@fluid:first=0.02,layers=3"; do
    # shellcheck disable=SC2086  # several options
    quadrefine $options "$blocks" -o x.quad.h5
    run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" x.quad.h5
    refute_output --partial FAULT
    stagecheck x.quad.h5
  done
}

@test "the checker sees a wrong region, and needs a file" {
  run -1 /usr/bin/python3 "$ROOT/tests/check_regions.py" "$ROOT/tests/formats/quad_mesh/failed/QUA-R13.quad.h5"
  assert_line --partial "FAULT regions"
  run -3 /usr/bin/python3 "$ROOT/tests/check_regions.py" none.h5
}

# judged SHAPE OPTION...: the checker and stagecheck accept the mesh of tests/data/regions/SHAPE.step.
judged() {
  local shape=$1
  mkdir -p "$shape"
  "$ROOT/pipelines/quadmesh" "$ROOT/tests/data/regions/$shape.step" --order 6 "${@:2}" --workdir "$shape" \
    -o "$shape/$shape.msh" 2>"$shape/log"
  stagecheck "$shape/$shape.sep.json" "$shape/$shape.blocks.h5" "$shape/$shape.quad.h5"
  run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" "$shape/$shape.quad.h5" --face "$shape/$shape.tri.h5"
  refute_output --partial FAULT
}

@test "the checker accepts regions, embedded curves, cracks and interfaces that need not conform" {
  judged disc_in_square
  assert_line --partial "2 regions, 2 parts between interfaces"
  judged chequerboard_2_hole
  judged plate_circle
  judged aerofoil_wake --geometry-tol 1e-9
  judged plate_curve --open baffle
  assert_line --regexp '^ok +cracks: 2 sides, [1-9][0-9]+ doubled nodes'
  judged t_joint --interface left-right=nonconforming
  assert_line --regexp '^ok +open interface left-right: '
}

@test "layers and sizes on one side of an interface keep the nodes of both sides" {
  judged pin_in_channel
  name=$(/usr/bin/python3 -c '
import h5py
face = h5py.File("pin_in_channel/pin_in_channel.quad.h5")["face"]
curve = next(c for c, p in enumerate(face["partners"][:]) if p >= 0)
print(face["curve_names"][:][curve].decode())')
  judged_with() {
    quadrefine --order 6 "$@" pin_in_channel/pin_in_channel.blocks.h5 -o x.quad.h5
    run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" x.quad.h5
    refute_output --partial FAULT
  }
  judged_with --wall "$name@0:first=0.01,layers=3"
  judged_with --wall "$name@1:first=0.01,layers=3"
  judged_with --size-near "$name@1=0.03"
}
