# padapt: orders by prediction, and by Algorithm 1 of the paper.
load common

setup_file() {
  cad2tri "$DATA/half_disc.step" | fieldsolve -o "$BATS_FILE_TMPDIR/half_disc.solve.h5"
}

setup() {
  common_setup
  ln -s "$BATS_FILE_TMPDIR/half_disc.solve.h5" half_disc.solve.h5
}

@test "writes a valid field, silently" {
  run padapt half_disc.solve.h5 -o a.field.h5
  assert_success
  assert_output ''
  assert_nothing_left a.field.h5 half_disc.solve.h5
  stagecheck a.field.h5
}

@test "files, pipes and a second run give the same bytes" {
  padapt half_disc.solve.h5 -o a.field.h5
  padapt half_disc.solve.h5 -o b.field.h5
  padapt < half_disc.solve.h5 > c.field.h5
  cad2tri "$DATA/half_disc.step" | fieldsolve | padapt -o d.field.h5
  for other in b c d; do cmp a.field.h5 $other.field.h5; done
}

@test "stops when no order changes, every element within its limits" {
  padapt half_disc.solve.h5 -o a.field.h5 --report report.json
  run -0 jq -e '.adapt.min_order >= 2 and .adapt.max_order <= 20 and .adapt.num_unresolved == 0 and .warnings == []
    and .adapt.max_sensor <= 1e-16 and (.adapt.num_elements_by_order | add) > 0' report.json
  # Adapting once more finds nothing to do.
  padapt a.field.h5 -o b.field.h5 --report report.json
  assert_equal "$(jq '.adapt.cpu_seconds_by_step | length' report.json)" 0
}

@test "looser thresholds and lower limits give fewer unknowns" {
  padapt half_disc.solve.h5 -o a.field.h5 --report tight.json
  padapt --raise-above 1e-10 --lower-below 1e-14 half_disc.solve.h5 -o a.field.h5 --report loose.json
  padapt --max-order 9 half_disc.solve.h5 -o a.field.h5 --report low.json
  tight=$(jq .adapt.num_unknowns tight.json)
  (($(jq .adapt.num_unknowns loose.json) < tight))
  (($(jq .adapt.num_unknowns low.json) < tight))
  assert_equal "$(jq .adapt.max_order low.json)" 9
}

@test "the sensor of one component or of both" {
  for sensor in u v vector; do
    padapt --sensor $sensor half_disc.solve.h5 -o $sensor.field.h5
    stagecheck $sensor.field.h5
  done
  run cmp u.field.h5 v.field.h5
  assert_failure
  run -2 padapt --sensor w half_disc.solve.h5 -o a.field.h5
  assert_file_not_exists a.field.h5
}

@test "a bound on the steps is a warning with a code" {
  run --separate-stderr padapt --policy paper --max-steps 1 half_disc.solve.h5 -o a.field.h5 --report report.json
  assert_success
  assert_regex "$stderr" 'orders still change after 1 step'
  assert_equal "$(jq -r '.warnings[].code' report.json)" W-ADAPT-001
  stagecheck a.field.h5
}

@test "one step at a time is the same as all at once" {
  cad2tri -q "$DATA/half_disc.step" | fieldsolve -q --field-order 5 -o coarse.h5 # needs more than one new solution
  for options in "--raise-above 1e-23 --lower-below 1e-30" "--policy paper"; do
    padapt $options coarse.h5 -o all.field.h5 --report report.json
    (($(jq .adapt.steps report.json) > 2))
    cp coarse.h5 a.field.h5
    for ((step = 1; step < $(jq .adapt.steps report.json); ++step)); do
      padapt -q $options --max-steps 1 a.field.h5 -o next.field.h5
      mv next.field.h5 a.field.h5
    done
    padapt $options a.field.h5 -o b.field.h5 # would add something if it were not finished
    for dataset in elem_order u adapt_steps/num_raised adapt_steps/elem_order adapt_steps/elem_sensor; do
      for field in a b; do h5diff all.field.h5 $field.field.h5 /$dataset; done
    done
  done
}

@test "prediction needs few solutions for nearly the orders of the paper" {
  padapt half_disc.solve.h5 -o a.field.h5 --report predict.json
  padapt --policy paper half_disc.solve.h5 -o b.field.h5 --report paper.json
  (($(jq .adapt.steps predict.json) <= 3))
  (($(jq .adapt.steps paper.json) > 3))
  jq -e --slurp '.[0].adapt.num_unknowns < 1.2 * .[1].adapt.num_unknowns' predict.json paper.json
  run -2 padapt --policy none half_disc.solve.h5 -o c.field.h5
}

@test "a discontinuous field goes up to order 12" {
  cad2tri "$DATA/half_disc.step" | fieldsolve --method dg --field-order 11 | padapt -q -o a.field.h5 --report report.json
  assert_equal "$(jq .adapt.max_order report.json)" 12
}

@test "the sensor's scale" {
  padapt half_disc.solve.h5 -o a.field.h5
  padapt --sensor v --sensor-scale relative half_disc.solve.h5 -o b.field.h5
  stagecheck b.field.h5
  run cmp a.field.h5 b.field.h5
  assert_failure
  run -2 padapt --sensor-scale none half_disc.solve.h5 -o a.field.h5
}

@test "thresholds and limits that contradict each other are usage errors" {
  for options in "--raise-above 1e-20 --lower-below 1e-10" "--min-order 9 --max-order 8" "--max-order 21"; do
    run --separate-stderr padapt $options half_disc.solve.h5 -o a.field.h5
    assert_equal "$status" 2
    assert_equal "${stderr_lines[1]}" "try 'padapt --help'"
    assert_file_not_exists a.field.h5
  done
}

@test "-v tells each step" {
  run --separate-stderr padapt -v half_disc.solve.h5 -o a.field.h5 --report report.json
  assert_success
  assert_equal "$(grep -c 'raised, .* lowered' <<<"$stderr")" "$(jq .adapt.steps report.json)"
}

@test "says so when the estimated error misses its target at the highest order" {
  cad2tri "$DATA/half_disc.step" | fieldsolve --field-order 4 > coarse.solve.h5
  run -0 --separate-stderr padapt --max-order 5 --report report.json coarse.solve.h5 -o a.field.h5
  assert_equal "$(jq -r '.warnings[].code' report.json)" W-ADAPT-002
  [[ $stderr =~ "up to "[0-9.e-]+", above the target 1.0e-08, although the order is at its highest, 5".*"worst near (" ]]
  run -0 --separate-stderr padapt --max-order 5 --target-error 0.1 coarse.solve.h5 -o a.field.h5
  assert_equal "$stderr" ''
}

@test "keeps the history of orders and sensors in the file, their times in the report alone" {
  cad2tri "$DATA/half_disc.step" | fieldsolve --field-order 6 > a.solve.h5
  padapt --policy paper --max-steps 2 --report report.json a.solve.h5 -o a.field.h5 2> warning
  assert_equal "$(jq '.adapt.cpu_seconds_by_step | length' report.json)" 2
  assert_equal "$(jq '.adapt.num_unknowns_by_step | length' report.json)" 3
  m=$(h5dump -H -d /elem_order a.field.h5 | grep -oE 'SIMPLE \{ \( [0-9]+' | grep -oE '[0-9]+')
  h5dump -d /adapt_steps/elem_order_offsets a.field.h5 | grep -q "(0): 0, $m, $((2 * m)), $((3 * m))"
  h5dump -H -d /elem_error a.field.h5 | grep -q "SIMPLE { ( $m )"
}

@test "a phase field is adapted for its own nodes" {
  critpoints half_disc.solve.h5 | jq '.critical_points[0].position[0] += 0.1' > nodes.json
  cad2tri "$DATA/half_disc.step" | fieldsolve --field-order 6 --nodes nodes.json -o a.phase.h5
  padapt a.phase.h5 -o b.phase.h5 --report report.json
  stagecheck b.phase.h5
  run -0 jq -e '.adapt.steps > 1 and .adapt.max_sensor <= 1e-16 and .warnings == []' report.json
  h5diff a.phase.h5 b.phase.h5 /phase/prescribed
  padapt b.phase.h5 -o c.phase.h5 --report report.json # finds nothing to do
  assert_equal "$(jq '.adapt.cpu_seconds_by_step | length' report.json)" 0
  h5diff b.phase.h5 c.phase.h5 /phase
}
