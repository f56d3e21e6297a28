# Gmsh, which shares no code with us, reads every shape in both versions of its format and measures the elements.
load common

setup() {
  common_setup
  need gmsh python3-gmsh python3-h5py
}

# judge BLOCKS NAME OPTION...: refines and exports in both versions, then compares what Gmsh sees with x.quad.h5.
judge() {
  quadrefine -q "$1" -o "$2.quad.h5" --report "$2.json" "${@:3}"
  quadexport "$2.quad.h5" -o "$2.msh"
  quadexport --format msh22 "$2.quad.h5" -o "$2.22.msh"
  run "$PYTHON" "$ROOT/tests/peers/judge_gmsh.py" "$2.quad.h5" "$2.json" "$2.msh" "$2.22.msh"
  assert_success # and shows what was said where it is not
}

@test "Gmsh takes every shape without a warning and finds our Jacobians" {
  local file blocks
  while read -r file; do
    echo "$file" # shown where the test fails
    blocks=$(blocks_of "$file")
    judge "$blocks" "$(basename "$file" .step)"
  done < <(shapes)
}

@test "Gmsh takes every order from 1 to 10" {
  local order blocks
  blocks=$(blocks_of "$DATA/half_disc.step")
  for order in 1 2 3 4 5 6 7 8 9 10; do
    judge "$blocks" "order_$order" --order "$order" --size 0.3 --geometry-tol 1
  done
}

@test "the commands of the page work" {
  quadrefine "$(blocks_of "$DATA/half_disc.step")" | quadexport -o x.msh
  example 1 sh msh | sed 's/^gmsh x.msh$/& -0/' >commands # -0: without a window
  run -0 bash -euo pipefail commands
  assert_output --partial "minJ/maxJ ="
}
