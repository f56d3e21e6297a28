# Exodus' own library, NetCDF's and VTK read our Exodus files.
load common

setup() {
  common_setup
}

# exported: $cases of every shape: quads of orders 1 to 4, of which the last two are split, and hexahedra of 1 and 2.
exported() {
  local name order path kind
  while read -r name order path; do
    for kind in quad hex; do
      [[ $kind != hex || $order -le 2 ]] || continue
      quadexport -q "$path.$kind.h5" -o "$name.$order.$kind.exo"
      cases+=("$path.$kind.h5" "$name.$order.$kind.exo")
    done
  done < <(coarse 1 2 3 4)
}

@test "Exodus' own library reads every shape, quads and hexahedra: blocks, side sets, their names and places" {
  need libexodusii-dev libnetcdf-dev python3-netcdf4 python3-h5py
  local cases=()
  gcc -Wall "$ROOT/tests/peers/read_exodus.c" -o read_exodus -lexoIIv2c
  exported
  run "$PYTHON" "$ROOT/tests/peers/judge_exodus.py" ./read_exodus "${cases[@]}"
  assert_success
}

@test "VTK reads Exodus files of every shape: det J of every element, blocks, and side sets by name" {
  need python3-vtk9 python3-h5py
  local cases=()
  exported
  run "$PYTHON" "$ROOT/tests/peers/judge_vtk_exodus.py" "${cases[@]}"
  assert_success
}
