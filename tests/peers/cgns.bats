# CGNS' own checker and VTK read our CGNS files.
load common

setup() {
  common_setup
}

# check FILE: cgnscheck ends with 0 whatever it finds.
check() {
  run -0 cgnscheck -v "$1"
  refute_output --partial ERROR
  refute_output --regexp '[1-9][0-9]* error'
  assert_output --partial 'checking complete'
}

@test "cgnscheck accepts every shape: unstructured of orders 1 to 4, structured, with blocks merged too" {
  need cgns-convert
  local file blocks order
  while read -r file; do
    echo "$file"
    blocks=$(blocks_of "$file")
    for order in 1 2 3 4; do
      quadrefine -q --order $order --geometry-tol 1 "$blocks" -o a.quad.h5
      quadexport -q a.quad.h5 -o a.cgns
      check a.cgns
    done
    quadexport -q --format cgns-structured a.quad.h5 -o a.cgns
    check a.cgns
    zones=$(grep -c 'reading zone' <<<"$output")
    quadexport -q --format cgns-structured --merge-blocks a.quad.h5 -o b.cgns
    check b.cgns
    ((zones >= $(grep -c 'reading zone' <<<"$output"))) || fail "more grids than blocks"
  done < <(shapes)
}

@test "cgnscheck accepts hexahedra of every shape, orders 1 to 4" {
  need cgns-convert
  local name order path
  while read -r name order path; do
    echo "$name, order $order"
    quadexport -q "$path.hex.h5" -o a.cgns
    check a.cgns
    assert_output --partial 'Cell Dimension=3'
  done < <(coarse 1 2 3 4)
}

@test "cgnscheck accepts structured grids of every shape, swept straight and twisted" {
  need cgns-convert
  local file motion option
  while read -r file; do
    echo "$file"
    quadrefine -q --order 2 --geometry-tol 1 "$(blocks_of "$file")" -o a.quad.h5
    for motion in "--height 1 --layers 2" "--one-layer --twist 10"; do
      # shellcheck disable=SC2086
      hexsweep -q a.quad.h5 $motion -o a.hex.h5
      for option in -q --merge-blocks; do
        quadexport -q $option --format cgns-structured a.hex.h5 -o a.cgns
        check a.cgns
      done
    done
  done < <(shapes)
}

@test "cgnscheck accepts structured grids of revolved sweeps, a full turn too" {
  need cgns-convert
  local shape motion
  for shape in half_disc plate_hole s_bend annulus; do
    quadrefine -q --order 2 --geometry-tol 1 "$(blocks_of "$DATA/$shape.step")" -o a.quad.h5
    for motion in "--revolve 60 --axis -9,0,-9,1 --layers 4" "--revolve 360 --axis -9,0,-9,1 --layers 12"; do
      # shellcheck disable=SC2086
      hexsweep -q a.quad.h5 $motion -o a.hex.h5
      quadexport -q --format cgns-structured a.hex.h5 -o a.cgns
      check a.cgns
    done
  done
}

# VTK 9.1 exchanges two upright edges of HEXA_64 and does not know HEXA_125.
@test "VTK reads hexahedra of every shape: positive Jacobians, and the volume of the stage file" {
  need python3-vtk9 python3-h5py
  local name order path cases=()
  while read -r name order path; do
    quadexport -q "$path.hex.h5" -o "$name.$order.cgns"
    cases+=("$path.hex.h5" "$name.$order.cgns")
  done < <(coarse 1 2)
  run "$PYTHON" "$ROOT/tests/peers/judge_vtk_reader_hex.py" "${cases[@]}"
  assert_success
}
