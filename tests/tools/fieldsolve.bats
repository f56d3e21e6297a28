# fieldsolve: the guiding field on a triangle mesh.
load common

setup_file() {
  cd "$BATS_FILE_TMPDIR" || return 1
  cad2tri "$DATA/half_disc.step" -o half_disc.tri.h5
  fieldsolve half_disc.tri.h5 | padapt -o half_disc.field.h5
  critpoints half_disc.field.h5 -o half_disc.crit.json
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

# nodes_of: the half disc's own nodes, edited by a jq program, as nodes.json.
nodes_of() {
  jq "$1" "$BATS_FILE_TMPDIR/half_disc.crit.json" > nodes.json
}

@test "--nodes solves for nodes that were moved by hand" {
  nodes_of '.critical_points[0].position[0] += 0.1'
  run fieldsolve --nodes nodes.json half_disc.tri.h5 -o a.phase.h5 --report report.json
  assert_success
  assert_output ''
  stagecheck a.phase.h5
  run -0 jq -c '[.phase.num_nodes, .phase.node_valences, .phase.corner_valences, .phase.hole_winding, .phase.hole_periods]' report.json
  assert_output '[2,[3,3],[1,1],[],[]]'
  run -0 --separate-stderr fieldsolve -v --nodes nodes.json half_disc.tri.h5 -o b.phase.h5
  assert_regex "$stderr" 'nodes: 2 of valence 3; corners: 2 of valence 1'
  cmp a.phase.h5 b.phase.h5
  fieldsolve --nodes - half_disc.tri.h5 < nodes.json > c.phase.h5
  cmp a.phase.h5 c.phase.h5
}

@test "--nodes: provenance has the digests of both inputs" {
  nodes_of .
  fieldsolve --nodes nodes.json half_disc.tri.h5 -o a.phase.h5
  for input in nodes.json half_disc.tri.h5; do
    h5dump -a /provenance a.phase.h5 | grep -q "$(sha256sum < "$input" | cut -d ' ' -f 1)"
  done
}

@test "--nodes: with orders of somebody else, and adapted" {
  nodes_of '.critical_points[0].position = [-0.4, 0.5]'
  fieldsolve --nodes nodes.json --field-order 5 half_disc.tri.h5 -o a.phase.h5 --report report.json
  assert_equal "$(jq .solve.field_order report.json)" 5
  padapt a.phase.h5 -o a.field.h5 --report report.json
  stagecheck a.field.h5
  run -0 jq -e '.adapt.max_error < 1e-6 and .warnings == []' report.json
  fieldsolve --nodes nodes.json --orders a.field.h5 half_disc.tri.h5 -o b.phase.h5
  h5diff a.field.h5 b.phase.h5 /elem_order
  h5diff a.field.h5 b.phase.h5 /phase/s
}

@test "--nodes: orders of a harmonic field are lowered to what the phase needs" {
  cad2tri "$DATA/annulus.step" -o r.tri.h5
  fieldsolve r.tri.h5 | padapt -o r.field.h5
  critpoints r.field.h5 | jq '.form = "phase"' > nodes.json
  fieldsolve --nodes nodes.json --orders r.field.h5 r.tri.h5 -o r.solve.h5 --report lowered.json
  padapt r.solve.h5 -o r.phase.h5 --report adapted.json
  h5diff r.solve.h5 r.phase.h5 /elem_order # one solution was enough
  n=$(jq .solve.num_elements lowered.json)
  h5dump -d /elem_order -y -w 0 r.field.h5 | grep -Eo '[0-9 ,]{20,}' | tr -d '\n' > orders.txt
  jq -n --argjson orders "[$(cat orders.txt)]" '{format: "order-map", version: [1, 0], elem_order: $orders}' > orders.json
  assert_equal "$(jq '.elem_order | length' orders.json)" "$n"
  fieldsolve --nodes nodes.json --orders orders.json r.tri.h5 -o s.solve.h5 --report whole.json
  run -0 jq -n -e --slurpfile lowered lowered.json --slurpfile whole whole.json \
    '$lowered[0].solve.num_unknowns < $whole[0].solve.num_unknowns and $lowered[0].solve.max_error < 1e-9'
}

@test "--nodes: winding and periods of holes are reported, offsets obeyed" {
  cad2tri "$DATA/annulus.step" -o r.tri.h5
  fieldsolve r.tri.h5 | padapt | critpoints - -o r.crit.json
  for offset in 0 1; do
    jq ".form = \"phase\" | .hole_winding_offsets = [$offset]" r.crit.json > nodes.json
    fieldsolve --nodes nodes.json r.tri.h5 -o $offset.phase.h5 --report $offset.json
  done
  run -0 jq -n --slurpfile a 0.json --slurpfile b 1.json '$b[0].phase.hole_winding[0] - $a[0].phase.hole_winding[0]'
  assert_output 1
  run -0 jq -e '.phase.hole_winding_energy < 1e-9 and (.phase.hole_periods[0] | fabs) < 1e-6' 0.json
  run -0 jq -e '.phase.hole_winding_energy > 1' 1.json
  jq '.form = "phase" | .hole_winding_offsets = [0, 0]' r.crit.json > nodes.json
  run --separate-stderr fieldsolve --nodes nodes.json r.tri.h5 -o c.phase.h5
  assert_equal "$status" 3
  assert_regex "$stderr" '^fieldsolve: nodes.json: CRT-R14: hole_winding_offsets has 2 entries for 1 holes'
  assert_file_not_exists c.phase.h5
}

# refused PROGRAM MESSAGE: nodes edited by a jq program are refused with 3 and one line that says this.
refused() {
  nodes_of "$1"
  run --separate-stderr fieldsolve --nodes nodes.json half_disc.tri.h5 -o a.phase.h5
  assert_equal "$status" 3
  assert_equal "${#stderr_lines[@]}" 1
  assert_regex "$stderr" "^fieldsolve: nodes.json: .*$2"
  assert_file_not_exists a.phase.h5
}

@test "--nodes: an impossible set is refused with the arithmetic" {
  refused 'del(.critical_points[1])' 'index_sum.value is 4, but the lists add up to 3: 4 - V over 1 critical points 1'
  refused 'del(.critical_points[1]) | .index_sum.value = 3' 'the index sum is 3, not 4'
  refused 'del(.critical_points[1], .corners[0]) | .index_sum = {value: 0, expected: 0}' 'add up'
}

@test "--nodes: nodes outside the face are refused with their place" {
  refused '.critical_points[0].position = [0.2, -0.3]' '\(0.2, -0.3\) is outside the face'
  refused '.critical_points[0].position = [0.2, 0]' 'near \(.*\) is on the boundary'
}

@test "--nodes: corners that no block fits are refused by name and angle" {
  # Valence 0 is degenerate and can be had; it takes the place of a node.
  nodes_of '.corners[0].valence = 0 | del(.critical_points[0])'
  fieldsolve --nodes nodes.json half_disc.tri.h5 -o b.phase.h5 --report report.json
  assert_equal "$(jq -c .phase.corner_valences report.json)" '[0,1]'
  cad2tri "$DATA/trapezoid.step" -o t.tri.h5
  fieldsolve t.tri.h5 | padapt | critpoints - -o t.crit.json
  sharpest=$(jq '[.corners[].angle_degrees] | index(min)' t.crit.json)
  jq ".corners[$sharpest].valence += 3 | .critical_points += [range(3) | {position: [0.5 + 0.1 * ., 0.5], valence: 3}]" \
    t.crit.json > nodes.json
  run --separate-stderr fieldsolve --nodes nodes.json t.tri.h5 -o c.phase.h5
  assert_equal "$status" 3
  assert_regex "$stderr" '^fieldsolve: nodes.json: the corner of curves [0-9] and [0-9] at \(.*\) cannot have valence [34]: its angle is [0-9.]+ degrees'
}

@test "--nodes: a face other than the mesh's is refused, and so are discontinuous elements" {
  nodes_of .
  cad2tri "$DATA/square.step" -o s.tri.h5
  run --separate-stderr fieldsolve --nodes nodes.json s.tri.h5 -o a.phase.h5
  assert_equal "$status" 3
  assert_regex "$stderr" '^fieldsolve: nodes.json was not made from s.tri.h5'
  run --separate-stderr fieldsolve --nodes nodes.json --method dg half_disc.tri.h5 -o a.phase.h5
  assert_equal "$status" 2
  assert_file_not_exists a.phase.h5
}

@test "where the field vanishes on curves it is solved all the same, with a warning" {
  cad2tri "$DATA/octagon.step" -o o.tri.h5
  run --separate-stderr fieldsolve o.tri.h5 -o o.solve.h5 --report report.json
  assert_success
  assert_regex "$stderr" 'W-SOLVE-001: .*vanishes on curves'
  assert_equal "$(jq -r '.warnings[].code' report.json)" W-SOLVE-001
  stagecheck o.solve.h5
}

# aligned JSON: a.align.json with these members.
aligned() { echo "{\"format\": \"alignment\", \"version\": [1, 0], $1}" >a.align.json; }

# refuses CODE WORDS FILE: fieldsolve --align FILE on the duct.
refuses() {
  run --separate-stderr fieldsolve --align "$3" duct.tri.h5 -o a.solve.h5
  assert_equal "$status" "$1"
  assert_regex "$stderr" "^fieldsolve: .*$2"
  assert_file_not_exists a.solve.h5
}

@test "--align: crosses follow a shock through a duct, whose field has the directions; |v| stays below 1" {
  cad2tri "$DATA/duct.step" -o duct.tri.h5
  for strength in 1 4; do
    fieldsolve --align "$DATA/alignment/duct.align.json" --align-strength $strength duct.tri.h5 |
      padapt -q -o $strength.solve.h5
    stagecheck $strength.solve.h5
    for name in position width rate angle; do h5dump -H -d /alignment/$name $strength.solve.h5 >/dev/null; done
  done
  need_h5py
  PYTHONPATH=$ROOT/pipelines/python /usr/bin/python3 -c "
import numpy, quadrille
along = numpy.linspace(-0.4, 0.4, 41)[:, None] * [[0.5, 0.75**0.5]] + [1.5, 0.5]
x, y = numpy.meshgrid(numpy.linspace(0.01, 2.99, 100), numpy.linspace(0.01, 0.99, 40))
for strength, bar in (1, 8), (4, 1):
    field = quadrille.read(f'{strength}.solve.h5')
    u, v = field.value(along).T
    angles = numpy.angle((u + 1j * v) * numpy.exp(-4j * numpy.pi / 3)) / 4
    rms = numpy.degrees(numpy.sqrt((angles**2).mean()))
    assert rms < bar, (strength, rms)
    assert numpy.hypot(*field.value(numpy.column_stack([x.ravel(), y.ravel()])).T).max() < 1 + 1e-4"
}

@test "--align: a point, a box and a metric have directions too" {
  cad2tri "$DATA/duct.step" -o duct.tri.h5
  aligned '"points": [{"position": [1, 0.5], "angle": 30}], "boxes": [{"low": [2, 0.3], "high": [2.5, 0.7], "angle": -30}]'
  fieldsolve --align a.align.json --align-strength 5 duct.tri.h5 -o json.solve.h5
  awk -v OFS=, 'BEGIN { print "x,y,h1,h2,angle"; for (i = 0; i < 900; ++i) print i % 45 / 15, int(i / 45) / 19, 0.1, 0.01, 30 }' >metric.csv
  fieldsolve --align metric.csv --align-strength 5 duct.tri.h5 -o metric.solve.h5
  awk -F, 'NR == 1 { print "m12 m11 x m22 y"; next } { a = atan2(0, -1) / 6; c = cos(a); s = sin(a); p = 100; q = 10000
    print c * s * (p - q), c * c * p + s * s * q, $1, s * s * p + c * c * q, $2 }' metric.csv >tensor.txt
  fieldsolve --align tensor.txt --align-strength 5 duct.tri.h5 -o tensor.solve.h5
  for file in json metric tensor; do stagecheck $file.solve.h5; done
  h5diff -d 1e-4 metric.solve.h5 tensor.solve.h5 /u
  h5diff -d 1e-4 metric.solve.h5 tensor.solve.h5 /v
  need_h5py
  PYTHONPATH=$ROOT/pipelines/python /usr/bin/python3 -c "
import numpy, quadrille
def angle(file, place):
    (u, v), = quadrille.read(file + '.solve.h5').value(numpy.array([place]))
    return numpy.degrees(numpy.angle(u + 1j * v) / 4)
found = [angle('json', [1, 0.5]), -angle('json', [2.25, 0.5]), angle('metric', [1.5, 0.5])]
assert max(abs(numpy.array(found) - 30)) < 5, found"
}

@test "--align: each broken rule is an error of the file, with its key or line" {
  cad2tri "$DATA/duct.step" -o duct.tri.h5
  while IFS='|' read -r rule members; do
    aligned "$members"
    refuses 3 "$rule" a.align.json
  done <<'END'
ALN-R01|"points": [{"position": [1, 0.5], "angle": 30, "width": 0}]
ALN-R01|"points": [{"position": [1, 0.5], "angle": 30, "strength": -1}]
ALN-R02|"curves": [{"positions": [[1, 0]]}]
ALN-R02|"boxes": [{"low": [1, 0], "high": [1, 1], "angle": 0}]
ALN-R04|"points": [], "boxes": []
angle|"points": [{"position": [1, 0.5]}]
version|"version": [2, 0]
END
  printf '%s\n' 'x,y,h1,h2,angle' '1,0.5,0.1,0,30' >a.csv
  refuses 3 'a.csv:2: .*ALN-R03' a.csv
  printf '%s\n' 'x,y,m11,m12,m22' '1,0.5,1,0,1' '1,0.6,1,2,1' >a.csv
  refuses 3 'a.csv:3: .*ALN-R03' a.csv
  echo '<VTKFile type="UnstructuredGrid">' >a.vtu
  refuses 3 'python3 -m quadrille.vtu_sizes a.vtu --array metric' a.vtu
  refuses 3 'not be "alignment"|must be "alignment"' "$ROOT/formats/size-field.schema.json"
  aligned '"curves": [{"positions": [[0, 0], [3, 1]], "width": 1e-6}]'
  refuses 3 '200,000' a.align.json
  aligned '"points": [{"position": [1, 0.5], "angle": 30, "width": 1e-200}]'
  refuses 3 'mu is not finite' a.align.json
}

@test "--align needs continuous elements; at strength 0 the arrays are those without it" {
  cad2tri "$DATA/duct.step" -o duct.tri.h5
  run --separate-stderr fieldsolve --align "$DATA/alignment/duct.align.json" --method dg duct.tri.h5 -o a.solve.h5
  assert_equal "$status" 2
  assert_regex "$stderr" '^fieldsolve: --align needs --method cg'
  fieldsolve half_disc.tri.h5 -o a.solve.h5
  aligned '"points": [{"position": [0, 0.5], "angle": 30}]'
  fieldsolve --align a.align.json --align-strength 0 half_disc.tri.h5 -o b.solve.h5
  for name in u v elem_order coef_offsets elem_error liftings; do h5diff a.solve.h5 b.solve.h5 /$name; done
  h5dump -n b.solve.h5 >names
  run ! grep -q alignment names
}

@test "--nodes and --align: the phase follows directions as well" {
  cad2tri "$DATA/bow_shock.step" -o b.tri.h5
  fieldsolve b.tri.h5 | padapt | critpoints - -o b.crit.json
  fieldsolve --align "$DATA/alignment/bow_shock.align.json" --nodes b.crit.json b.tri.h5 -o b.phase.h5
  stagecheck b.phase.h5
  padapt b.phase.h5 -o c.phase.h5
  h5diff b.phase.h5 c.phase.h5 /alignment
}
