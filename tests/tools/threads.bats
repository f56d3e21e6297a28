# --threads: the same bytes, whatever their number.
load common

setup() {
  common_setup
  cad2tri --size 0.2 "$DATA/half_disc.step" -o a.tri.h5
}

same_bytes_on_any_number_of_threads() {
  "$@" --threads 1 -o one.h5
  for threads in 2 3 auto; do
    "$@" --threads $threads -o other.h5
    cmp one.h5 other.h5
  done
  "$@" -o other.h5
  cmp one.h5 other.h5
}

@test "fieldsolve, continuous and discontinuous" {
  same_bytes_on_any_number_of_threads fieldsolve a.tri.h5
  same_bytes_on_any_number_of_threads fieldsolve --method dg --field-order 5 a.tri.h5
}

@test "work that lasts longer than 0.2 s, where threads are started by default" {
  cad2tri --size 0.05 "$DATA/half_disc.step" -o a.tri.h5
  same_bytes_on_any_number_of_threads fieldsolve --field-order 16 a.tri.h5 --report report.json
  run -0 jq '.timings.total.cpu_seconds > 0.2' report.json
  assert_output true
  fieldsolve a.tri.h5 -o a.solve.h5
  same_bytes_on_any_number_of_threads padapt --target-error 1e-12 a.solve.h5
}

@test "padapt" {
  fieldsolve --field-order 4 a.tri.h5 -o a.solve.h5
  same_bytes_on_any_number_of_threads padapt a.solve.h5
}
