# Gmsh, which shares no code with us, reads every shape in both versions of its format and measures the elements.
load common

setup() {
  common_setup
  need gmsh python3-gmsh python3-h5py
}

# refined BLOCKS NAME OPTION...: refines and exports in both versions; judge compares what Gmsh sees with x.quad.h5.
refined() {
  quadrefine -q "$1" -o "$2.quad.h5" --report "$2.json" "${@:3}"
  quadexport "$2.quad.h5" -o "$2.msh"
  quadexport --format msh22 "$2.quad.h5" -o "$2.22.msh"
  cases+=("$2.quad.h5" "$2.json" "$2.msh" "$2.22.msh")
}

judge() {
  run "$PYTHON" "$ROOT/tests/peers/judge_gmsh.py" "${cases[@]}"
  assert_success # and shows what was said where it is not
}

@test "Gmsh takes every shape without a warning and finds our Jacobians" {
  local file cases=()
  while read -r file; do
    refined "$(blocks_of "$file")" "$(basename "$file" .step)"
  done < <(shapes)
  judge
}

@test "Gmsh reads every shape at every order, quads and hexahedra, with all names, from both versions" {
  local name order path kind cases=()
  while read -r name order path; do
    for kind in quad hex; do
      [[ $kind$order != hex10 ]] || continue
      quadexport -q "$path.$kind.h5" -o "$name.$order.$kind.msh"
      quadexport -q --format msh22 "$path.$kind.h5" -o "$name.$order.$kind.22.msh"
      cases+=("$path.$kind.h5" "$name.$order.$kind.msh" "$name.$order.$kind.22.msh")
    done
  done < <(coarse 1 2 3 4 5 6 7 8 9 10)
  run "$PYTHON" "$ROOT/tests/peers/judge_gmsh_shapes.py" "${cases[@]}"
  assert_success
}

@test "Gmsh takes every order from 1 to 10" {
  local order blocks cases=()
  blocks=$(blocks_of "$DATA/half_disc.step")
  for order in 1 2 3 4 5 6 7 8 9 10; do
    refined "$blocks" "order_$order" --order "$order" --size 0.3 --geometry-tol 1
  done
  judge
}

@test "the commands of the page work" {
  quadrefine "$(blocks_of "$DATA/half_disc.step")" | quadexport -o x.msh
  example 1 sh msh | sed 's/^gmsh x.msh$/& -0/' >commands # -0: without a window
  run -0 bash -euo pipefail commands
  assert_output --partial "minJ/maxJ ="
}
