# --threads: the same bytes, whatever their number.
load common

setup() {
  common_setup
  cad2tri --size 0.2 "$DATA/half_disc.step" -o a.tri.h5
}

same_bytes_on_any_number_of_threads() {
  "$@" --threads 1 -o one.h5
  for threads in 2 3; do
    "$@" --threads $threads -o other.h5
    cmp one.h5 other.h5
  done
}

@test "fieldsolve, continuous and discontinuous" {
  same_bytes_on_any_number_of_threads fieldsolve a.tri.h5
  same_bytes_on_any_number_of_threads fieldsolve --method dg --field-order 5 a.tri.h5
}

@test "padapt" {
  fieldsolve --field-order 4 a.tri.h5 -o a.solve.h5
  same_bytes_on_any_number_of_threads padapt a.solve.h5
}
