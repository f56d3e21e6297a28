# VTK's own shape functions on our files: positive determinants, areas and lengths, one map in both kinds of cells.
load common

setup() {
  common_setup
  need python3-vtk9 python3-h5py
}

# refined BLOCKS NAME OPTION...
refined() {
  quadrefine -q "$1" -o "$2.quad.h5" "${@:3}"
  quadexport "$2.quad.h5" -o "$2.vtu"
  quadexport --format vtu-bezier "$2.quad.h5" -o "$2.bezier.vtu"
  cases+=("$2.quad.h5" "$2.vtu" "$2.bezier.vtu")
}

judge() {
  run "$PYTHON" "$ROOT/tests/peers/judge_vtk.py" "${cases[@]}"
  assert_success # and shows what was said where it is not
}

@test "VTK finds positive determinants and our area in every shape" {
  local file cases=()
  while read -r file; do
    refined "$(blocks_of "$file")" "$(basename "$file" .step)"
  done < <(shapes)
  judge
}

@test "VTK reads every order from 1 to 10" {
  local order blocks cases=()
  blocks=$(blocks_of "$DATA/half_disc.step")
  for order in 1 2 3 4 5 6 7 8 9 10; do
    refined "$blocks" "order_$order" --order "$order" --size 0.5 --geometry-tol 1
  done
  judge
}

@test "VTK reads every shape at every order, quads and hexahedra, Lagrange and Bezier cells, with all names" {
  local name order path kind format file cases=()
  while read -r name order path; do
    for kind in quad hex; do
      for format in vtu vtu-bezier; do
        file=$name.$order.$kind.$format.vtu
        quadexport -q --format $format "$path.$kind.h5" -o "$file"
        cases+=("$path.$kind.h5" "$file")
      done
    done
  done < <(coarse 1 2 3 4 5 6 7 8 9 10)
  run "$PYTHON" "$ROOT/tests/peers/judge_vtk_shapes.py" "${cases[@]}"
  assert_success
}

@test "the commands of the page work" {
  quadrefine "$(blocks_of "$DATA/half_disc.step")" | quadexport --format vtu -o x.vtu
  example 1 python vtu >commands.py
  echo "print(names.GetValue(0))" >>commands.py
  run -0 "$PYTHON" commands.py
  assert_line --regexp '^[0-9]+ cells$'
  assert_line block_0
}
