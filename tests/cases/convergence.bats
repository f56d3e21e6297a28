# How the error of the field falls with its order, and that the studies in tests/benchmarks run.
load ../tools/common

setup() {
  common_setup
  benchmarks=$BATS_TEST_DIRNAME/../benchmarks
}

@test "the error falls exponentially with the order, on a smooth curved domain and beside singular corners" {
  "$benchmarks/convergence" --bin "$BIN" -o . > slopes
  # Measured: 0.79 and 0.83 decades per order on the ellipse, 0.43 and 0.46 on the polygon. The higher orders gain as much
  # as the lower ones, or nearly so: a power of the order would keep 0.6 of it.
  jq -e '.slopes | length == 4 and all(.decades_per_order <= (if .shape == "ellipse" then -0.72 else -0.39 end)
    and .upper_half <= 0.75 * .decades_per_order)' convergence.json
  jq -e '[.rows[] | select(.method == "cg" and .order == 16)] | length == 2 and all(.max_error < 1e-9)' convergence.json
  jq -e '[.rows[] | select(.method == "dg" and .order == 12)] | length == 2 and all(.max_error < 2e-8)' convergence.json
  # Lifted DG is as good as CG of the same order.
  jq -e '[.rows[] | select(.method == "dg")] as $dg | [.rows[] | select(.method == "cg")] as $cg
    | all($dg[]; . as $d | $cg[] | select(.shape == $d.shape and .order == $d.order) | $d.max_error < 1.5 * .max_error)' convergence.json
  xmllint --noout convergence.svg
}

@test "on Cartesian sides the sensor on v asks for needless orders on the scale of the paper, the vector does not" {
  "$benchmarks/sensors" --bin "$BIN" -o . > rows
  order() { jq "[.rows[] | select(.scale == \"$1\" and .sensor == \"$2\")][0].mean_order_wings" sensors.json; }
  # Measured: 12.0 on v, 7.5 on u, 7.6 on the vector.
  jq -ne "$(order relative v) > 1.4 * $(order relative u)"
  jq -ne "$(order relative v) > 1.4 * $(order relative vector)"
  jq -ne "$(order absolute vector) < 1.1 * $(order absolute u)"
  jq -ne "$(order absolute v) < 1.1 * $(order absolute u)"
  xmllint --noout sensors_*.svg
}

@test "studies that need the shared geometries say so where there are none, and end well" {
  for study in adaptivity corner_methods; do
    run -0 --separate-stderr "$benchmarks/$study" --bin "$BIN" -o . nowhere
    assert_regex "$stderr" "$study: no truth.json in nowhere"
    assert_output ''
  done
}
