# code_saturne's preprocessor reads our hexahedra with their names.
load common

setup() {
  common_setup
  need code-saturne-bin python3-numpy python3-h5py
}

@test "code_saturne's preprocessor reads every shape of orders 1 and 2 with all names, from MSH 4.1 and CGNS" {
  local name order path cases=()
  while read -r name order path; do
    quadexport -q "$path.hex.h5" -o "$name.$order.msh"
    quadexport -q "$path.hex.h5" -o "$name.$order.cgns"
    cases+=("$path.hex.h5" "$name.$order.msh" "$path.hex.h5" "$name.$order.cgns")
  done < <(coarse 1 2)
  run "$PYTHON" "$ROOT/tests/peers/judge_saturne.py" "${cases[@]}"
  assert_success
}
