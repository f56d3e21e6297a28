# The checker of regions, which shares no code with the library, and meshes of the tools before it.
load ../tools/common

setup() {
  /usr/bin/python3 -c 'import numpy, h5py' || skip "no numpy or h5py: apt-get install python3-h5py"
  common_setup
  export PYTHONDONTWRITEBYTECODE=1
}

@test "every check of the checker fails on a damaged mesh" {
  run -0 /usr/bin/python3 "$ROOT/tests/check_regions_test.py"
  assert_line --regexp '^Ran 1[0-9] tests in '
}

@test "the checker accepts what quadrefine makes of a layout of two regions" {
  blocks=$ROOT/tests/formats/block_layout/passed/regions.blocks.h5
  for options in "--order 1 --size 0.3" "--order 4 --size 0.5 --relax 5" \
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
