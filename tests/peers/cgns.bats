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

# hexes ORDER: a.hex.h5 and a.cgns of twisted layers.
hexes() {
  quadrefine -q --order "$1" --geometry-tol 1 "$(blocks_of "$DATA/half_disc.step")" -o a.quad.h5
  hexsweep -q a.quad.h5 --height 1 --twist 40 --layers 3 -o a.hex.h5
  quadexport -q a.hex.h5 -o a.cgns
}

@test "cgnscheck accepts hexahedra of orders 1 to 4" {
  need cgns-convert
  local order
  for order in 1 2 3 4; do
    hexes $order
    check a.cgns
    assert_output --partial 'Cell Dimension=3'
  done
}

# VTK 9.1 exchanges two upright edges of HEXA_64 and does not know HEXA_125.
@test "VTK reads hexahedra: positive Jacobians, and the volume of the stage file" {
  need python3-vtk9
  local order
  for order in 1 2; do
    hexes $order
    run -0 "$PYTHON" "$ROOT/tests/peers/judge_vtk_reader_hex.py" a.hex.h5 a.cgns
  done
}
