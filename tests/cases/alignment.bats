# quadmesh --align: blocks follow directions inside the domain.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh
shock=$DATA/alignment/bow_shock.align.json

# follows MESH BAR: the sides of its elements at the shock deviate from it by less than so many degrees.
follows() {
  /usr/bin/python3 -c 'import numpy, h5py' || skip "no numpy or h5py: apt-get install python3-h5py"
  angle=$(/usr/bin/python3 "$ROOT/tests/cases/aligned_sides.py" "$1" "$shock")
  awk -v angle="$angle" -v bar="$2" 'BEGIN { exit !(angle < bar) }' || fail "$1: $angle degrees"
}

@test "blocks follow a shock before a cylinder, with the nodes outside it" {
  run -0 "$quadmesh" "$DATA/bow_shock.step" -o a.msh --align "$shock" --workdir aligned
  assert_output --regexp '^8 blocks, 2 irregular nodes, '
  follows aligned/bow_shock.quad.h5 10
  jq -e '[.critical_points[].position | (.[0] - 0.25) * (.[0] - 0.25) + .[1] * .[1] | sqrt] | all(. > 1.3)' \
    aligned/bow_shock.crit.json
  "$quadmesh" -q "$DATA/bow_shock.step" -o b.msh --workdir plain
  run ! follows plain/bow_shock.quad.h5 20
}

@test "the stages one by one give the same bytes as quadmesh" {
  "$quadmesh" -q "$DATA/bow_shock.step" -o a.msh --align "$shock" --align-strength 2 --workdir .
  cad2tri -q "$DATA/bow_shock.step" | fieldsolve -q --align "$shock" --align-strength 2 | padapt -q -o b.field.h5
  critpoints -q b.field.h5 -o b.crit.json
  separatrix -q b.field.h5 b.crit.json | blocksplit -q | quadrefine -q --relax none -o b.quad.h5
  quadexport -q b.quad.h5 -o b.msh
  cmp b.field.h5 bow_shock.field.h5
  cmp b.quad.h5 bow_shock.quad.h5
  cmp a.msh b.msh
}

@test "--dry-run prints the file of directions and --relax none; stagecheck --history prints commands with it" {
  cp "$shock" shock.json
  "$quadmesh" --dry-run "$DATA/bow_shock.step" -o a.msh --align shock.json >commands
  grep -q '^fieldsolve .*--align shock.json' commands
  grep -q '^quadrefine .*--relax none' commands
  bash -e commands
  mv a.msh dry.msh
  "$quadmesh" -q "$DATA/bow_shock.step" -o a.msh --align shock.json
  cmp a.msh dry.msh
  stagecheck --history bow_shock.solve.h5 >history
  assert_equal "$(grep -c "alignment, SHA-256 $(sha256sum <shock.json | cut -d ' ' -f 1)$" history)" 1
  cp shock.json bow_shock.align.json
  cp "$DATA/bow_shock.step" .
  mv bow_shock.solve.h5 first.solve.h5
  bash -e history
  cmp first.solve.h5 bow_shock.solve.h5
}

@test "vertices stay on the traced lines, unless --relax is given" {
  for rule in none size shape; do
    "$quadmesh" -q "$DATA/bow_shock.step" -o $rule.msh --align "$shock" --relax $rule
  done
  "$quadmesh" -q "$DATA/bow_shock.step" -o a.msh --align "$shock"
  cmp a.msh none.msh
  run ! cmp a.msh size.msh
  run ! cmp a.msh shape.msh
}

@test "nodes that were given get a field that follows the shock too" {
  "$quadmesh" -q "$DATA/bow_shock.step" -o a.msh --align "$shock" --workdir . --until critpoints
  jq '.critical_points |= map(.position[0] -= 0.02)' bow_shock.crit.json >moved.crit.json
  "$quadmesh" -q "$DATA/bow_shock.step" -o b.msh --align "$shock" --nodes moved.crit.json --workdir .
  h5dump -H -d /alignment/rate bow_shock.phase.h5 >/dev/null
  follows bow_shock.quad.h5 10
}

@test "on several threads the aligned field has the same bytes" {
  cad2tri -q "$DATA/bow_shock.step" -o a.tri.h5
  for threads in 1 3; do
    fieldsolve -q --threads $threads --align "$shock" a.tri.h5 | padapt -q --threads $threads -o $threads.field.h5
  done
  cmp 1.field.h5 3.field.h5
}

@test "a symmetric shock gives nodes at mirrored places" {
  cad2tri -q "$DATA/bow_shock.step" | fieldsolve -q --align "$shock" | padapt -q | critpoints -q - -o a.crit.json
  jq -e '[.critical_points[].position] | length == 2 and (.[0][0] - .[1][0] | fabs < 1e-7) and
    (.[0][1] + .[1][1] | fabs < 1e-7)' a.crit.json
}

@test "where a strip of blocks contains itself, or the mesh is poor, nodes of the least energy are not tried" {
  echo '{"format": "alignment", "version": [1, 0], "curves": [{"positions": [[-1.2, -1.2], [0.8, 1.2]]}],
    "points": [{"position": [1.2, -0.4], "angle": 20}]}' >align.json
  run -0 --separate-stderr "$quadmesh" "$DATA/stadium.step" -o a.msh --align align.json
  [[ $stderr != *energy* ]] || fail "$stderr"
  "$quadmesh" -q "$DATA/stadium.step" --align align.json --workdir . --until padapt
  run -0 --separate-stderr "$quadmesh" --from critpoints --workdir . -o b.msh
  [[ $stderr != *energy* ]] || fail "$stderr"
}

@test "what quadmesh cannot do with directions is refused before any work" {
  echo '{"format": "alignment", "version": [1, 0], "curves": []}' >empty.json
  run -3 --separate-stderr "$quadmesh" "$DATA/bow_shock.step" -o a.msh --align empty.json
  assert_regex "$stderr" '^quadmesh: .*ALN-R04'
  run -3 "$quadmesh" "$DATA/bow_shock.step" -o a.msh --align missing.json
  run -2 --separate-stderr "$quadmesh" "$DATA/bow_shock.step" -o a.msh --align "$shock" --place energy
  assert_regex "$stderr" 'place energy'
  assert_nothing_left empty.json
}
