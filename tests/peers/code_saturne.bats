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

# figure TITLE: the greatest value of the histogram of that title.
figure() {
  grep -F -A 3 "Histogram of the $1" run_solver.log | sed -nE 's/.*maximum value = *([0-9.e+-]+).*/\1/p'
}

@test "--check-for code_saturne measures its angles, and counts its bad cells" {
  quadrefine -q --order 1 "$(blocks_of "$DATA/half_disc.step")" -o a.quad.h5
  hexsweep -q a.quad.h5 --height 0.5 --layers 4 --twist 80 -o a.hex.h5
  run -0 quadexport a.hex.h5 --check-for code_saturne -o a.msh --report a.json
  assert_output --regexp 'gradient condition .* reaches the limit 0.1 of code_saturne \([0-9]+ places do\)'
  count=$(grep -oP 'gradient condition.*\(\K[0-9]+' <<<"$output")
  /usr/lib/code_saturne/cs_preprocess a.msh --out mesh_input
  /usr/lib/code_saturne/cs_solver --quality >/dev/null 2>&1 || true # its log tells
  run -0 grep -A 1 'Criterion 3: Least-Squares Gradient Quality' run_solver.log
  assert_output --partial "bad cells detected: $count "
  for pair in 'non_orthogonality:interior faces non-ortho' 'boundary_non_orthogonality:boundary faces non-ortho'; do
    jq -e --argjson wanted "$(figure "${pair#*:}")" \
      ".check_for.${pair%%:*}.value | . / \$wanted - 1 | fabs < 1e-4" a.json >/dev/null || fail "$pair: $(figure "${pair#*:}")"
  done
}
