# quadmesh --align: blocks follow directions inside the domain.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh
shock=$DATA/alignment/bow_shock.align.json

# follows MESH BAR: the sides of its elements at the shock deviate from it by less than so many degrees.
follows() {
  need_h5py
  angle=$(/usr/bin/python3 "$ROOT/tests/cases/aligned_sides.py" "$1" "$shock")
  awk -v angle="$angle" -v bar="$2" 'BEGIN { exit !(angle < bar) }' || fail "$1: $angle degrees"
}

@test "blocks follow a shock before a cylinder, with the nodes outside it" {
  run -0 "$quadmesh" "$DATA/bow_shock.step" -o a.msh --align "$shock" --workdir aligned
  assert_output --regexp '^8 blocks, 2 irregular nodes, '
  follows aligned/bow_shock.quad.h5 11
  jq -e '[.critical_points[].position | (.[0] - 0.25) * (.[0] - 0.25) + .[1] * .[1] | sqrt] | all(. > 1.3)' \
    aligned/bow_shock.crit.json
  "$quadmesh" -q "$DATA/bow_shock.step" -o b.msh --workdir plain
  run ! follows plain/bow_shock.quad.h5 20
}

@test "the stages one by one give the same bytes as quadmesh" {
  "$quadmesh" -q "$DATA/bow_shock.step" -o a.msh --align "$shock" --align-strength 2 --workdir .
  cad2tri -q "$DATA/bow_shock.step" | fieldsolve -q --align "$shock" --align-strength 2 | padapt -q -o b.field.h5
  critpoints -q b.field.h5 -o b.crit.json
  separatrix -q b.field.h5 b.crit.json | blocksplit -q |
    quadrefine -q --align "$shock" --align-strength 2 -o b.quad.h5
  quadexport -q b.quad.h5 -o b.msh
  cmp b.field.h5 bow_shock.field.h5
  cmp b.quad.h5 bow_shock.quad.h5
  cmp a.msh b.msh
}

@test "--dry-run prints the file of directions for both stages; stagecheck --history prints commands with it" {
  cp "$shock" shock.json
  "$quadmesh" --dry-run "$DATA/bow_shock.step" -o a.msh --align shock.json >commands
  grep -q '^fieldsolve .*--align shock.json' commands
  grep -q '^quadrefine .*--align shock.json' commands
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

@test "crosses follow shocks within the bars of the benchmark, more closely the stronger, with as many nodes as without" {
  need_h5py
  /usr/bin/python3 "$ROOT/tests/benchmarks/alignment" --bin "$BIN" -o . >rows
  jq -e '[.rows[] | select(.form == "harmonic")] | group_by(.shape) | map(map(.degrees)) |
    length == 3 and all(length == 3 and .[0] > 1.9 * .[1] and .[1] > 1.9 * .[2])' alignment.json
  assert_equal "$(jq -c '[.rows[].nodes | values]' alignment.json)" '[0,0,0,0,0,0,2,2,2]'
  assert_equal "$(jq -c '[.rows[].bar | values]' alignment.json)" '[13,6,17,8,5,5,5]'
}

@test "the vertices of finer meshes follow the shock more closely, and less without --align" {
  "$quadmesh" -q "$DATA/bow_shock.step" -o a.msh --align "$shock" --size 0.1 --workdir .
  follows bow_shock.quad.h5 5
  quadrefine -q --size 0.1 bow_shock.blocks.h5 -o plain.quad.h5
  run ! follows plain.quad.h5 15
}

@test "a metric has elements of its lengths, along its directions, and R is measured in it" {
  cat >metric.py <<'END'
import math
print("x,y,h1,h2,angle")
for i in range(61):
    for j in range(101):
        x, y = -2 + 0.035 * i, -2.05 + 0.041 * j
        away = abs(math.hypot(x - 0.25, y) - 1.15)
        print(x, y, 0.2, min(0.2, 0.04 + 0.15 * max(0, away - 0.05)), math.degrees(math.atan2(y, x - 0.25)) + 90, sep=",")
END
  python3 metric.py >metric.csv
  "$quadmesh" -q "$DATA/bow_shock.step" -o a.msh --metric metric.csv --align metric.csv --workdir . --report a.json
  follows bow_shock.quad.h5 10
  jq -e '.valid and .quads < 700 and .resolution.ratio < 4 and .greatest_edge_ratio.value > 3' a.json
  stagecheck bow_shock.quad.h5
  assert_equal "$(h5dump -d /elem_prescribed_stretch/xx bow_shock.quad.h5 | grep -c 'SIMPLE')" 1
  quadrefine -q --size 0.14 bow_shock.blocks.h5 -o plain.quad.h5 --report plain.json
  jq -e '.greatest_edge_ratio.value < 3' plain.json
}

@test "nodes that were given get a field that follows the shock too" {
  "$quadmesh" -q "$DATA/bow_shock.step" -o a.msh --align "$shock" --workdir . --until critpoints
  jq '.critical_points |= map(.position[0] -= 0.02)' bow_shock.crit.json >moved.crit.json
  "$quadmesh" -q "$DATA/bow_shock.step" -o b.msh --align "$shock" --nodes moved.crit.json --workdir .
  h5dump -H -d /alignment/rate bow_shock.phase.h5 >/dev/null
  follows bow_shock.quad.h5 11
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

@test "nodes at zeros that follow directions stay there: --place energy and remedies move none of them" {
  "$quadmesh" -q "$DATA/bow_shock.step" --align "$shock" --workdir . --until critpoints
  critpoints -q --place energy bow_shock.field.h5 -o energy.crit.json
  assert_equal "$(jq -c .critical_points energy.crit.json)" "$(jq -c .critical_points bow_shock.crit.json)"
  echo '{"format": "alignment", "version": [1, 0], "curves": [{"positions": [[-1.2, -1.2], [0.8, 1.2]]}],
    "points": [{"position": [1.2, -0.4], "angle": 20}]}' >align.json
  "$quadmesh" -q "$DATA/stadium.step" -o a.msh --align align.json --report a.json
  jq -e .valid a.json
}

@test "an aligned plate with small fillets has no thin elements" {
  echo '{"format": "alignment", "version": [1, 0], "curves": [{"positions": [[-2.4, -0.2], [2.4, 2.2]], "width": 0.2}]}' \
    >align.json
  "$quadmesh" -q "$DATA/filleted_plate.step" -o a.msh --align align.json --report a.json
  jq -e '.valid and .greatest_edge_ratio.value < 30 and .least_scaled_jacobian > 0.5' a.json
}

@test "what quadmesh cannot do with directions is refused before any work" {
  echo '{"format": "alignment", "version": [1, 0], "curves": []}' >empty.json
  run -3 --separate-stderr "$quadmesh" "$DATA/bow_shock.step" -o a.msh --align empty.json
  assert_regex "$stderr" '^quadmesh: .*ALN-R04'
  run -3 "$quadmesh" "$DATA/bow_shock.step" -o a.msh --align missing.json
  run -3 --separate-stderr "$quadmesh" "$DATA/bow_shock.step" -o a.msh --metric "$shock"
  assert_regex "$stderr" 'a metric has lengths'
  printf 'x,y,h1,h2,angle\n0,0,0.1,0,0\n' >bad.csv
  run -3 --separate-stderr "$quadmesh" "$DATA/bow_shock.step" -o a.msh --metric bad.csv
  assert_regex "$stderr" '^quadmesh: bad.csv:2: .*ALN-R03'
  assert_nothing_left empty.json bad.csv
}
