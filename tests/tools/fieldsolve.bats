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

@test "discontinuous elements solve to the same field, up to order 12" {
  fieldsolve --method dg --field-order 12 half_disc.tri.h5 -o a.solve.h5 --report report.json
  stagecheck a.solve.h5
  run -0 jq -r '.solve.method' report.json
  assert_output dg
  fieldsolve --field-order 12 half_disc.tri.h5 -o b.solve.h5
  for name in a b; do
    critpoints $name.solve.h5 | jq -c '[.critical_points[] | .valence, (.position[] * 1e9 | round)]' > $name.txt
  done
  cmp a.txt b.txt
  run --separate-stderr fieldsolve --method dg --field-order 13 half_disc.tri.h5 -o c.solve.h5
  assert_equal "$status" 2
  assert_file_not_exists c.solve.h5
}

@test "jumps left in the data need discontinuous elements" {
  cad2tri "$DATA/trapezoid.step" -o t.tri.h5
  fieldsolve --method dg --corners dg t.tri.h5 -o a.solve.h5 --report report.json
  stagecheck a.solve.h5
  run -0 jq '.solve.num_liftings' report.json
  assert_output 0
  run --separate-stderr fieldsolve --corners dg t.tri.h5 -o b.solve.h5
  assert_equal "$status" 1
  assert_regex "$stderr" '^fieldsolve: the boundary data jump at 2 corners, the first at \(2, 0\): .*--method dg'
  assert_file_not_exists b.solve.h5
  fieldsolve --corners dg half_disc.tri.h5 -o c.solve.h5 # no jump there
}

@test "an order map of somebody else is followed" {
  n=$(fieldsolve half_disc.tri.h5 -o a.solve.h5 --report /dev/stdout | jq .solve.num_elements)
  jq -n --argjson n "$n" '{format: "order-map", version: [1, 0], elem_order: [range($n) | 3 + . % 5]}' > orders.json
  fieldsolve --orders orders.json half_disc.tri.h5 -o b.solve.h5
  stagecheck b.solve.h5
  run -0 h5dump -d /elem_order -y -w 0 b.solve.h5
  assert_output --partial '3, 4, 5, 6, 7, 3, 4, 5, 6, 7'
  fieldsolve --orders b.solve.h5 half_disc.tri.h5 -o c.solve.h5 # a field's own orders
  run h5diff b.solve.h5 c.solve.h5 /u
  assert_success
}

@test "an order map that does not fit is refused with 3" {
  echo '{"format": "order-map", "version": [1, 0], "elem_order": [8, 8]}' > short.json
  echo '{"format": "order-map", "version": [2, 0], "elem_order": [8, 8]}' > newer.json
  echo '{"format": "order-map", "version": [0, 9], "elem_order": [8, 8]}' > older.json
  echo '{"format": "order-map", "version": "1.0", "elem_order": [8, 8]}' > unnumbered.json
  echo '[8, 8]' > bare.json
  echo 'eight' > words.json
  for name in short newer older unnumbered bare words; do
    run --separate-stderr fieldsolve --orders $name.json half_disc.tri.h5 -o a.solve.h5
    assert_equal "$status" 3
    assert_equal "${#stderr_lines[@]}" 1
    assert_regex "$stderr" "^fieldsolve: .*$name.json"
    assert_file_not_exists a.solve.h5
    case $name in
      newer) assert_regex "$stderr" 'version 2\.0 is newer than this program' ;;
      older) assert_regex "$stderr" 'version 0\.9 is from an older program' ;;
    esac
  done
}
