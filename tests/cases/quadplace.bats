# pipelines/quadplace: irregular nodes moved to where the blocks are best, and never to where they are worse.
load ../tools/common

quadplace=$ROOT/pipelines/quadplace

# here COMMAND...: with the test's folder for temporaries too, so that what is left is seen.
here() { TMPDIR=$PWD "$@"; }

@test "the half disc's blocks get better in two rounds, symmetric still, and the nodes lead to the mesh again" {
  run -0 --separate-stderr here "$quadplace" "$DATA/half_disc.step" -o out.msh --nodes out.crit.json --report out.json \
    --workdir kept --rounds 2 --size 0.2
  assert_equal "$stderr" ""
  assert_output --regexp '^least scaled Jacobian of the blocks 0\.[0-9]+ -> 0\.[0-9]+, 2 of 2 nodes moved, (1 trial|([2-9]|[0-9]{2,}) trials)$'
  jq -e '.best > .start + 0.01 and .rounds <= 2 and (.moves[-1].quality == .best)' out.json
  jq -e '.form == "phase" and ([.critical_points[].valence] == [3, 3]) and
    ([.critical_points[].position[0]] | add | fabs < 1e-9) and
    (.critical_points[0].position[1] - .critical_points[1].position[1] | fabs < 1e-9)' out.crit.json
  run -0 "$BATS_TEST_DIRNAME/symmetric_layout.py" kept/sep.json
  assert_output "kept 2 of 2"
  for file in kept/*; do run -0 stagecheck "$file"; done
  quadrefine kept/blocks.h5 --size 0.2 | quadexport -o again.msh
  cmp out.msh again.msh
  # What the report says of the blocks is what they are.
  quadrefine kept/blocks.h5 --relax none --size-rule nearest --size 1e9 --order 8 --geometry-tol 1 -o coarse.quad.h5 --report coarse.json
  jq -n -e --slurpfile a coarse.json --slurpfile b out.json '$a[0].least_scaled_jacobian == $b[0].best'
  rm -r kept again.msh coarse.*
  assert_nothing_left out.crit.json out.json out.msh
}

@test "without rounds, and where nothing can be moved, the result is quadmesh's" {
  "$quadplace" -q "$DATA/half_disc.step" -o placed.msh --rounds 0
  "$ROOT/pipelines/quadmesh" -q "$DATA/half_disc.step" -o mesh.msh
  cmp placed.msh mesh.msh
  run -0 "$quadplace" "$DATA/square.step" -o placed.msh
  assert_output "least scaled Jacobian of the blocks 1 -> 1, 0 of 0 nodes moved, 0 trials: there is no irregular node inside"
  "$ROOT/pipelines/quadmesh" -q "$DATA/square.step" -o mesh.msh
  cmp placed.msh mesh.msh
}

@test "nodes that a user put badly are moved to better places; the mesh goes to standard output" {
  cad2tri "$DATA/half_disc.step" | fieldsolve -q | padapt -q | critpoints -o field.crit.json
  jq '.form = "phase" | .critical_points |= map({position: [.position[0] * 1.5, .position[1] * 0.8], valence})' \
    field.crit.json >start.crit.json
  "$quadplace" "$DATA/half_disc.step" --start start.crit.json --rounds 1 --report out.json >out.msh 2>words
  jq -e '.best > .start' out.json
  run -0 head -1 out.msh
  assert_output '$MeshFormat'
  run -0 cat words
  assert_output --regexp '^least scaled Jacobian'
}

@test "the goal is the user's choice: the ratio of the sides of blocks falls, the report names it" {
  run -0 "$quadplace" "$DATA/half_disc.step" -o out.msh --rounds 1 --goal edge-ratio --report out.json
  assert_output --regexp '^greatest ratio of the sides of a block [0-9.]+ -> [0-9.]+, '
  jq -e '.goal == "edge-ratio" and .best < .start and .moves[-1].quality == .best' out.json
}

@test "nodes move to where crosses follow the directions of a file" {
  run -0 "$quadplace" "$DATA/bow_shock.step" --align "$DATA/alignment/bow_shock.align.json" --goal alignment --rounds 6 \
    -o out.msh --report out.json
  assert_output --regexp '^angle between crosses and directions, degrees 2[67][.0-9]* -> [0-9.]+, 2 of 2 nodes moved, '
  jq -e '.goal == "alignment" and .best < 9' out.json
  run -2 --separate-stderr "$quadplace" "$DATA/bow_shock.step" -o out.msh --align "$DATA/alignment/bow_shock.align.json"
  assert_equal "${stderr_lines[0]}" "quadplace: --goal alignment and --align FILE go together"
  run -3 --separate-stderr "$quadplace" "$DATA/bow_shock.step" -o out.msh --goal alignment --align no.json
}

@test "mistakes on the command line are exit 2 with a hint" {
  for arguments in "" "--frob" "a.step b.step" "a.step -o" "a.step --rounds -1" "a.step --rounds x" "a.step --step 0" \
    "a.step --goal beauty"; do
    # shellcheck disable=SC2086
    run -2 --separate-stderr "$quadplace" $arguments
    assert_equal "${stderr_lines[1]}" "try 'quadplace --help'"
  done
}

@test "the options of critpoints are passed on to it, and listed by --help" {
  run -2 --separate-stderr here "$quadplace" "$DATA/square.step" -o out.msh --max-valence=3
  [[ ${stderr_lines[0]} == "quadplace: --max-valence: "* ]] || fail "$stderr"
  run -0 "$quadplace" -q "$DATA/half_disc.step" -o out.msh --rounds 0 --place energy --nodes energy.crit.json
  jq -e '.form == "phase"' energy.crit.json
  run -2 "$quadplace" "$DATA/square.step" --max-valence
  assert_line "quadplace: --max-valence needs a value"
  "$quadplace" --help | sed -n '/^OPTIONS OF CRITPOINTS$/,/^$/p' >shown
  "$ROOT/pipelines/quadmesh" --help-all | sed -n '/^OPTIONS OF CRITPOINTS$/,/^$/p' | diff - shown
  assert [ -s shown ]
}

@test "the options that choose and heal the face go to cad2tri" {
  run -0 "$quadplace" "$DATA/bad/solid.step" --face 4 -o side.msh --rounds 0 --heal-tolerance 0 --workdir kept
  cad2tri "$DATA/bad/solid.step" --face 4 --heal-tolerance 0 -o side.tri.h5
  cmp kept/tri.h5 side.tri.h5
  run -3 "$quadplace" "$DATA/bad/solid.step" -o side.msh
  run -2 "$quadplace" "$DATA/square.step" --blunt much -o side.msh
}

@test "what a stage has against its input, and what cannot be written, comes through with its exit code" {
  run -3 --separate-stderr here "$quadplace" missing.step -o out.msh
  assert_equal "$stderr" "quadplace: missing.step: no such file"
  head -c 3000 "$DATA/half_disc.step" >truncated.step
  run -3 --separate-stderr here "$quadplace" truncated.step -o out.msh
  [[ $stderr == "cad2tri: "* ]] || fail "$stderr"
  rm truncated.step
  echo '{}' >start.crit.json
  run -3 --separate-stderr here "$quadplace" "$DATA/half_disc.step" --start start.crit.json -o out.msh
  run -3 --separate-stderr here "$quadplace" "$DATA/half_disc.step" --start nowhere.crit.json -o out.msh
  [[ $stderr == "quadplace: nowhere.crit.json"* ]] || fail "$stderr"
  run -4 --separate-stderr here "$quadplace" "$DATA/square.step" --rounds 0 -o nowhere/out.msh
  run -4 --separate-stderr here "$quadplace" "$DATA/square.step" --rounds 0 -o out.msh --nodes nowhere/crit.json
  assert_nothing_left start.crit.json
}

@test "a failure is in the report, with its stage" {
  # failed CODE STAGE MESSAGE OPTION...: the report of quadplace has these, and what is printed is the message.
  failed() {
    local code=$1 stage=$2 message=$3
    shift 3
    run -"$code" --separate-stderr here "$quadplace" "$@" -o out.msh --report out.json
    [[ ${stderr_lines[0]} == *"$message"* ]] || fail "$stderr"
    assert_equal "$(jq -c '[.tool, .exit_code, .stage]' out.json)" "[\"quadplace\",$code,\"$stage\"]"
    [[ ${stderr_lines[0]} == "$stage: $(jq -r .error out.json)" ]] || fail "$(cat out.json)"
  }
  head -c 3000 "$DATA/half_disc.step" >truncated.step
  failed 3 cad2tri "truncated.step" truncated.step
  failed 3 quadplace "missing.step: no such file" missing.step
  failed 2 quadplace "--feature-size big" "$DATA/half_disc.step" --feature-size big
  failed 2 quadplace "no corner between curves 0 and 2" "$DATA/square.step" --corner-valence 0:2=1
  run -2 "$quadplace" truncated.step -o out.msh --report truncated.step
  cmp -n 3000 truncated.step "$DATA/half_disc.step"
  "$quadplace" -q "$DATA/square.step" -o out.msh --report out.json
  jq -e '.exit_code == 0 and .stage == null and .error == null' out.json
}

@test "a pipe stays a pipe, and is written into" {
  mkfifo report.json
  "$quadplace" -q "$DATA/square.step" -o out.msh --rounds 0 --report report.json &
  timeout 60 cat report.json >got.json
  wait $!
  assert [ -p report.json ]
  jq -e '.best == 1' got.json
}

@test "a signal ends the stage that runs, and nothing is left" {
  replace_tool separatrix 'echo >started' 'exec sleep 30'
  QUADRILLE_BIN=$PWD/fake ends_with_signal "$quadplace" "$DATA/half_disc.step" -o out.msh
}

@test "the help's examples work" {
  cp "$DATA/half_disc.step" "$DATA/bow_shock.step" .
  cp "$DATA/alignment/bow_shock.align.json" shock.json
  "$quadplace" --help | sed -n '/^EXAMPLES/,$p' | grep '^  quadplace' >examples
  assert [ "$(wc -l <examples)" -ge 2 ]
  while read -r _ arguments; do
    # shellcheck disable=SC2086
    run -0 "$quadplace" $arguments
  done <examples
  run -0 "$quadplace" --version
  assert_output --regexp '^quadplace .*[0-9]+\.[0-9]+\.[0-9]+$'
}
