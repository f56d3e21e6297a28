# VTK's own shape functions on our files: positive determinants, areas and lengths, one map in both kinds of cells.
load common

setup() {
  common_setup
  need python3-vtk9 python3-h5py
}

# judge BLOCKS NAME OPTION...
judge() {
  quadrefine -q "$1" -o "$2.quad.h5" "${@:3}"
  quadexport "$2.quad.h5" -o "$2.vtu"
  quadexport --format vtu-bezier "$2.quad.h5" -o "$2.bezier.vtu"
  run "$PYTHON" "$ROOT/tests/peers/judge_vtk.py" "$2.quad.h5" "$2.vtu" "$2.bezier.vtu"
  assert_success # and shows what was said where it is not
}

@test "VTK finds positive determinants and our area in every shape" {
  local file blocks
  while read -r file; do
    echo "$file"
    blocks=$(blocks_of "$file")
    judge "$blocks" "$(basename "$file" .step)"
  done < <(shapes)
}

@test "VTK reads every order from 1 to 10" {
  local order blocks
  blocks=$(blocks_of "$DATA/half_disc.step")
  for order in 1 2 3 4 5 6 7 8 9 10; do
    judge "$blocks" "order_$order" --order "$order" --size 0.5 --geometry-tol 1
  done
}

@test "VTK finds the volumes and areas of hexahedra, whose nodes are in its order" {
  local order format
  for order in 1 2 3 4; do
    quadrefine -q --order "$order" --size 0.5 --geometry-tol 1 "$(blocks_of "$DATA/half_disc.step")" -o a.quad.h5
    hexsweep -q a.quad.h5 --height 1 --twist 20 --layers 2 -o a.hex.h5
    for format in vtu vtu-bezier; do quadexport -q --format "$format" a.hex.h5 -o "$format.vtu"; done
    run "$PYTHON" "$ROOT/tests/peers/judge_vtk_hex.py" a.hex.h5 vtu.vtu vtu-bezier.vtu
    assert_success
  done
}

@test "the commands of the page work" {
  quadrefine "$(blocks_of "$DATA/half_disc.step")" | quadexport --format vtu -o x.vtu
  example 1 python vtu >commands.py
  echo "print(names.GetValue(0))" >>commands.py
  run -0 "$PYTHON" commands.py
  assert_line --regexp '^[0-9]+ cells$'
  assert_line block_0
}
