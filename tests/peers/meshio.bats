# meshio, the converter between formats, counts and names as we do.
load common

setup() {
  common_setup
  need python3-meshio python3-h5py
}

# judge BLOCKS NAME OPTION...
judge() {
  quadrefine -q "$1" -o "$2.quad.h5" "${@:3}"
  quadexport "$2.quad.h5" -o "$2.msh"
  quadexport --format msh22 "$2.quad.h5" -o "$2.22.msh"
  run "$PYTHON" "$ROOT/tests/peers/judge_meshio.py" "$2.quad.h5" "$2.msh" "$2.22.msh"
  assert_success # and shows what was said where it is not
}

@test "meshio reads both versions of MSH with all names, for every shape" {
  local file blocks
  while read -r file; do
    echo "$file"
    blocks=$(blocks_of "$file")
    judge "$blocks" "$(basename "$file" .step)" --order 3
  done < <(shapes)
}

@test "meshio reads every order from 1 to 10" {
  local order blocks
  blocks=$(blocks_of "$DATA/annulus.step")
  for order in 1 2 3 4 5 6 7 8 9 10; do
    judge "$blocks" "order_$order" --order "$order" --size 0.5 --geometry-tol 1
  done
}

@test "the commands of the page work" {
  quadrefine "$(blocks_of "$DATA/half_disc.step")" | quadexport -o x.msh
  example 2 python msh >commands.py
  run -0 "$PYTHON" commands.py
  assert_output --partial "'curve_0'"
}
