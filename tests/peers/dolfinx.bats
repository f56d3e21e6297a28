# dolfinx integrates and solves on our meshes, of the orders that it knows.
load common

setup() {
  common_setup
  export XDG_CACHE_HOME=$PWD # dolfinx compiles forms and keeps them there
  need python3-dolfinx python3-gmsh
}

# judge LIMIT ORDER GEOMETRY_TOL: area and named lengths of every shape against the CAD model.
judge() {
  local file name blocks cases=()
  while read -r file; do
    name=$(basename "$file" .step)
    blocks=$(blocks_of "$file")
    quadrefine -q --order "$2" --geometry-tol "$3" "$blocks" -o "$name.quad.h5"
    quadexport --frame 3d "$name.quad.h5" -o "$name.msh"
    cases+=("$file" "$name.msh" "$2")
  done < <(shapes)
  run "$PYTHON" "$ROOT/tests/peers/judge_dolfinx.py" "$1" "${cases[@]}"
  assert_success # and shows what was said where it is not
}

# Small fillets ask most: 9e-5 at order 2 (7e-7 diameters, where edges use the tolerance), 5e-7 at order 3.
@test "area and named lengths are those of the CAD model, order 1" { judge 1e-2 1 1e-4; }
@test "area and named lengths are those of the CAD model, order 2" { judge 1e-4 2 5e-7; }
@test "area and named lengths are those of the CAD model, order 3" { judge 2e-6 3 5e-7; }

@test "a Poisson solve converges at the order plus one" {
  run -0 "$ROOT/tests/benchmarks/poisson" --bin "$BIN" -o .
  run -0 jq -r '.rows[] | select(.rate) | select(.rate < .order + 0.8) | tostring' poisson.json
  assert_output ""
  run -0 jq '[.rows[] | select(.rate)] | length' poisson.json
  assert_output 16 # four shapes, two orders, two refinements
}

@test "hexahedra of order 2, straight, twisted and revolved: a Poisson solve converges at order 3" {
  run -0 "$ROOT/tests/benchmarks/poisson_hexes" --bin "$BIN" -o .
  run -0 jq -r '.rows[] | select(.rate) | select(.rate - 3 | fabs > 0.2) | tostring' poisson_hexes.json
  assert_output ""
  run -0 jq '[.rows[] | select(.rate)] | length' poisson_hexes.json
  assert_output 6 # three sweeps, two refinements
}

@test "wall layers make the error of a boundary layer less than a tenth, at equal unknowns" {
  run -0 "$ROOT/tests/benchmarks/boundary_layer" --bin "$BIN" -o .
  run -0 jq -c '[.rows[] | .layers.unknowns <= .without.unknowns and .ratio < 0.1] | [length, all]' boundary_layer.json
  assert_output '[8,true]'
}

# three_meshes ORDER: a.msh, b.msh and c.msh of disc_in_square, each with twice the elements of the one before along
# every chord of blocks, as exact at the circle as the order makes them.
three_meshes() {
  local name sizes=(--size 0.3)
  for name in a b c; do
    quadrefine -q --order "$1" --geometry-tol 1 "${sizes[@]}" --report report.json "$blocks" -o "$name.quad.h5"
    quadexport "$name.quad.h5" -o "$name.msh"
    mapfile -t sizes < <(jq -r '.sizes.chord | [.id, .count] | transpose[] | "--count", "\(.[0])=\(.[1] * 2)"' report.json)
  done
}

# rates ORDER: solves on the three meshes, into the file `solved`; $rates are those of the second and the third.
rates() {
  "$PYTHON" "$ROOT/tests/peers/two_materials.py" "$1" a.msh b.msh c.msh >solved
  mapfile -t rates < <(cut -d ' ' -f 3 solved | tail -n 2)
  assert_equal "${#rates[@]}" 2
}

@test "two materials: a solution with a kink converges at the order plus one, and not with the materials swapped" {
  local order blocks rate length
  blocks=$(blocks_of "$DATA/regions/disc_in_square.step")
  for order in 2 3; do
    three_meshes "$order"
    rates "$order"
    for rate in "${rates[@]}"; do
      jq -en "($rate - $order - 1) | fabs < 0.2" >/dev/null || fail "order $order, rate $rate"
    done
    length=$(tail -n 1 solved | cut -d ' ' -f 4)
    jq -en "$length < 1e-5" >/dev/null || fail "length of the interface: $length"
    sed -i -e 's/^\(2 [0-9]* \)"matrix"$/\1"other"/' -e 's/"fibre"$/"matrix"/' -e 's/"other"$/"fibre"/' [abc].msh
    rates "$order"
    for rate in "${rates[@]}"; do
      jq -en "$rate < 0.5" >/dev/null || fail "order $order, swapped, rate $rate"
    done
  done
}

@test "the commands of the page work" {
  quadrefine --order 3 "$(blocks_of "$DATA/half_disc.step")" | quadexport -o x.msh
  example 1 python msh >commands.py
  echo 'print(len(facets.find(tags["curve_0"])) > 0, len(cells.values))' >>commands.py
  run -0 "$PYTHON" commands.py
  assert_line --regexp '^True [0-9]+$'
}
