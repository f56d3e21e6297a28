# quadexport: files of other programs.
load common

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
}

setup() {
  common_setup
  quad=$BATS_FILE_TMPDIR/half_disc.quad.h5
  blocks=$BATS_FILE_TMPDIR/half_disc.blocks.h5
}

@test "writes a Gmsh file silently, the same through pipes" {
  run quadexport "$quad" -o a.msh
  assert_success
  assert_output ""
  assert_nothing_left a.msh
  quadexport < "$quad" > b.msh
  cmp a.msh b.msh
  quadexport --format msh "$quad" -o c.out
  cmp a.msh c.out
}

@test "names boundaries and blocks" {
  quadexport "$quad" -o a.msh
  run grep -c '^2 [0-9]* "block_' a.msh
  assert_output 4
  run grep -c '^1 [0-9]* "' a.msh
  assert_output 2
}

@test "Gmsh reads every order that it knows" {
  command -v gmsh || skip "no gmsh"
  for order in 1 2 3 4 5 6 7 8 9 10; do
    quadrefine --order $order --size 0.5 --geometry-tol 1e-3 "$blocks" | quadexport -o a.msh
    run gmsh -check a.msh
    assert_success
    refute_output --partial "Warning"
    refute_output --partial "Error"
  done
}

@test "an order above 10 ends with 1 and no file" {
  quadrefine --order 11 "$blocks" -o a.quad.h5
  run quadexport a.quad.h5 -o a.msh
  assert_failure 1
  assert_output --partial "order"
  assert_nothing_left a.quad.h5
}

@test "blocks become a STEP model, also through a pipe" {
  run quadexport "$blocks" -o a.step
  assert_success
  assert_output ""
  run head -n 1 a.step
  assert_output "ISO-10303-21;"
  quadexport --format step < "$blocks" > b.step
  cmp a.step b.step
}

@test "an unknown ending ends with 2" {
  run quadexport "$quad" -o a.stl
  assert_failure 2
  assert_output --partial ".msh"
  assert_nothing_left
}

@test "the wrong stage's file ends with 3" {
  run quadexport "$blocks" -o a.msh
  assert_failure 3
  run quadexport "$quad" -o a.step
  assert_failure 3
  assert_nothing_left
}

@test "an output that cannot be written ends with 4" {
  run quadexport "$quad" -o nowhere/a.msh
  assert_failure 4
  run --separate-stderr quadexport "$blocks" -o nowhere/a.step --report a.json
  assert_failure 4
  assert_equal "quadexport: $(jq -r '[.error, .exit_code] | join(" ")' a.json)" "$stderr 4"
  [[ $stderr == "quadexport: nowhere/a.step: "* ]]
}
