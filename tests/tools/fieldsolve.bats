# fieldsolve: the guiding field on a triangle mesh.
load common

setup_file() {
  cad2tri "$DATA/half_disc.step" -o "$BATS_FILE_TMPDIR/half_disc.tri.h5"
}

setup() {
  common_setup
  ln -s "$BATS_FILE_TMPDIR/half_disc.tri.h5" half_disc.tri.h5
}

@test "writes a valid field, silently, of order 8 by default" {
  run fieldsolve half_disc.tri.h5 -o a.solve.h5
  assert_success
  assert_output ''
  assert_nothing_left a.solve.h5 half_disc.tri.h5
  stagecheck a.solve.h5
  fieldsolve --field-order 8 half_disc.tri.h5 -o b.solve.h5 --report report.json
  assert_equal "$(jq .solve.field_order report.json)" 8
  run h5diff a.solve.h5 b.solve.h5
  assert_success
}

@test "files, pipes and a second run give the same bytes" {
  fieldsolve half_disc.tri.h5 -o a.solve.h5
  fieldsolve half_disc.tri.h5 -o b.solve.h5
  fieldsolve < half_disc.tri.h5 > c.solve.h5
  cat half_disc.tri.h5 | fieldsolve - -o - > d.solve.h5
  for other in b c d; do cmp a.solve.h5 $other.solve.h5; done
}

@test "every order from 1 to 20 solves, with more unknowns the higher it is" {
  last=0
  for order in 1 2 3 7 13 20; do
    fieldsolve --field-order $order half_disc.tri.h5 -o a.solve.h5 --report report.json
    stagecheck a.solve.h5
    unknowns=$(jq .solve.num_unknowns report.json)
    ((unknowns > last))
    last=$unknowns
  done
}

@test "the report has unknowns, residual and timings" {
  fieldsolve half_disc.tri.h5 -o a.solve.h5 --report report.json
  run -0 jq -e '.solve.num_unknowns > 100 and .solve.residual < 1e-13 and .solve.num_liftings == 0
    and .timings.solve.cpu_seconds >= 0 and .warnings == []' report.json
}

@test "orders outside 1..20 are usage errors" {
  for order in 0 21 -3 8.5 many; do
    run --separate-stderr fieldsolve --field-order $order half_disc.tri.h5 -o a.solve.h5
    assert_equal "$status" 2
    assert_equal "${stderr_lines[1]}" "try 'fieldsolve --help'"
    assert_file_not_exists a.solve.h5
  done
}

@test "a field instead of a mesh is refused with 3" {
  fieldsolve half_disc.tri.h5 -o a.solve.h5
  run --separate-stderr fieldsolve a.solve.h5 -o b.solve.h5
  assert_equal "$status" 3
  assert_equal "${#stderr_lines[@]}" 1
  assert_regex "$stderr" '^fieldsolve: .*a.solve.h5'
  assert_file_not_exists b.solve.h5
}
