# cad2tri: one planar CAD face in, a valid curved triangle mesh out.
load common

shapes="half_disc square l_shape quarter_annulus annulus eccentric_annulus plate_hole cylinder_channel s_bend stadium
  geometry_1"

@test "writes a mesh silently and leaves nothing else" {
  run cad2tri "$DATA/half_disc.step" -o a.tri.h5
  assert_success
  assert_output ""
  assert_nothing_left a.tri.h5
}

@test "meshes of all shapes keep every rule of the format" {
  for shape in $shapes; do
    cad2tri "$DATA/$shape.step" -o "$shape.tri.h5"
    run stagecheck "$shape.tri.h5"
    assert_success
  done
}

@test "meshes are coarse, proved and on their curves" {
  for shape in $shapes; do
    cad2tri "$DATA/$shape.step" -o a.tri.h5 --report a.json
    run jq -c '.mesh | [.elements < 1000, .least_jacobian_ratio > 0, .curve_error < 1e-12]' a.json
    assert_output '[true,true,true]'
  done
}

@test "--offset embeds a curve around a hole; other curves keep their names" {
  cad2tri -q "$DATA/plate_hole.step" --offset curve_4=0.2 -o a.tri.h5 --report a.json
  run -0 stagecheck a.tri.h5
  run jq -c '[.regions.count, .offsets["0"].least, .warnings]' a.json
  assert_output '[2,0.2,[]]'
  run cad2tri "$DATA/plate_hole.step" --offset curve_4=3 -o b.tri.h5
  assert_success
  assert_output --partial W-CAD-009
}

@test "the report counts, times and names no warning" {
  cad2tri "$DATA/plate_hole.step" -o a.tri.h5 --report a.json
  run jq -c '[.tool, .face.curves, .face.loops, .face.corners, .mesh.corner_fans, .warnings,
    .timings.load.cpu_seconds > 0, .timings.triangulate.cpu_seconds > 0]' a.json
  assert_output '["cad2tri",5,2,4,0,[],true,true]'
}

@test "gives the same bytes through pipes and twice" {
  cad2tri "$DATA/stadium.step" -o a.tri.h5
  cad2tri "$DATA/stadium.step" > b.tri.h5
  cad2tri - < "$DATA/stadium.step" > c.tri.h5
  cmp a.tri.h5 b.tri.h5
  cmp a.tri.h5 c.tri.h5
}

@test "--order, --size, --growth, --fan-layers and --fan-factor shape the mesh" {
  elements() {
    cad2tri "$DATA/half_disc.step" -o a.tri.h5 --report a.json "$@" && jq .mesh.elements a.json
  }
  default=$(elements)
  (($(elements --size 0.1) > 4 * default))
  (($(elements --growth 0.1 --size 0.2) >= $(elements --growth 2 --size 0.2)))
  # Two sectors at each of the two corners: an apex triangle and two triangles a layer.
  elements --fan-layers 5
  assert_equal "$(jq .mesh.fan_elements a.json)" 44
  elements --fan-layers 0
  assert_equal "$(jq .mesh.fan_elements a.json)" 0
  (($(elements --fan-factor 0.5) > default))
  elements --order 4
  run stagecheck a.tri.h5
  assert_success
}

@test "a low order warns that its edges deviate from the curves" {
  run cad2tri "$DATA/half_disc.step" -o a.tri.h5 --order 2
  assert_success
  assert_output --partial "W-TRI-001"
  run cad2tri "$DATA/half_disc.step" -o a.tri.h5 --order 2 -q
  assert_output ""
}

@test "--corner-angle decides which jumps are corners of the layout" {
  cad2tri "$DATA/half_disc.step" -o a.tri.h5 --report a.json
  assert_equal "$(jq .face.corners a.json)" 2
  cad2tri "$DATA/half_disc.step" -o a.tri.h5 --report a.json --corner-angle 90
  assert_equal "$(jq .face.corners a.json)" 0
}

@test "many small kinks of a polyline start no line" {
  python3 - "$DATA" <<'END'
import cmath, math, sys
sys.path.insert(0, sys.argv[1])
from step_text import polygon, rectangle, step_text
hole = [50 + 50j + 30 * cmath.exp(-2j * math.pi * k / 240) for k in range(240)]
open("x.step", "w").write(step_text("x", [rectangle(0j, 100 + 100j), polygon(hole)]))
END
  cad2tri x.step -o a.tri.h5 --report a.json
  assert_equal "$(jq .face.corners a.json)" 4
  run cad2tri x.step -o a.tri.h5 -v
  assert_output --partial "240 corners of polylines, with small angles, start no line (--polyline-angle)"
  cad2tri x.step -o a.tri.h5 --report a.json --polyline-angle 1.4
  assert_equal "$(jq .face.corners a.json)" 244
}

@test "numbers outside their intervals end with 2" {
  for option in "--order 0" "--order 17" "--size -1" "--growth 0" "--fan-layers -2" "--fan-factor 1" "--corner-angle 91" \
    "--polyline-angle 44" "--size x"; do
    run cad2tri "$DATA/square.step" -o a.tri.h5 ${option}
    assert_failure 2
    assert_output --partial "${option%% *}"
  done
  assert_nothing_left
}

@test "odd but honest files are read" {
  for name in rectangle.step rectangle.brep inches.step metres.step tilted.step upright.step downwards.step far_away.step \
    names.step against_the_curve.step ellipse_arc.step closed_spline.step kinked_spline.step construction.step; do
    cad2tri "$DATA/bad/$name" -q -o a.tri.h5
    run stagecheck a.tri.h5
    assert_success
  done
}

@test "bad files end with 3, one message and no file" {
  for name in empty.step truncated.step garbage.step garbage.txt wrong_extension.iges wrong_extension.txt \
    unknown_entity.step unknown_point.step points_are_directions.step broken_reference.step mixed_units.step solid.step \
    sphere.step two_faces.step open_wire.step self_intersecting.step self_intersecting_curve.step \
    hole_outside.step hole_across.step hole_in_hole.step zero_area.step \
    swapped_coordinates.step; do
    run cad2tri "$DATA/bad/$name" -o a.tri.h5
    assert_failure 3
    assert_equal "${#lines[@]}" 1
    assert_output --regexp "^cad2tri: .*$name: "
  done
  assert_nothing_left
}

@test "a missing file ends with 3, a folder that is not there with 4" {
  run cad2tri nowhere.step -o a.tri.h5
  assert_failure 3
  assert_output --partial nowhere.step
  run cad2tri "$DATA/square.step" -o nowhere/a.tri.h5
  assert_failure 4
  assert_output --partial nowhere
  assert_nothing_left
}

@test "a full disk ends with 4" {
  [ -c /dev/full ] || skip "no /dev/full here"
  run bash -c 'cad2tri "$DATA/square.step" > /dev/full'
  assert_failure 4
  assert_output --partial "cad2tri: "
}

# curve_names FILE: one a line.
curve_names() {
  h5dump -y -A 0 -d /face/curve_names "$1" | sed '1,/DATA {/d' | grep -o '"[^"]*"' | sed 's/\\000//g'
}

@test "edges without a name are called by their layer or colour" {
  cad2tri "$DATA/labels.step" -o a.tri.h5
  assert_equal "$(curve_names a.tri.h5 | sed 1d | tr '\n' ' ')" '"outlet" "walls" "colour_ff8000" "colour_0000ff" '
  stageview a.tri.h5 -o a.svg
  grep -q 'Zufluß' a.svg
}

@test "--boundary-names names curves by old name, number, nearest point and all the rest" {
  echo '{"outlet": "far", "3": "inlet", "*": "wall"}' > names.json
  cad2tri "$DATA/labels.step" --boundary-names names.json -o a.tri.h5
  assert_equal "$(curve_names a.tri.h5 | tr -d '\n')" '"wall""far""wall""inlet""wall"'
  echo '[{"near": [1, 0.75], "name": "cylinder"}, {"old_name": "walls", "name": "lid"}, {"id": 0, "name": "floor"}]' |
    cad2tri "$DATA/labels.step" --boundary-names - -o a.tri.h5
  assert_equal "$(curve_names a.tri.h5 | tr -d '\n')" '"floor""outlet""lid""colour_ff8000""cylinder"'
  run stagecheck a.tri.h5
  assert_success
  # A face in space: points of the model and of the plane mean the same.
  echo '[{"near": [2, 2, 3], "name": "p"}]' > space.json
  echo '[{"near": [1, 0], "name": "p"}]' > plane.json
  for names in space plane; do cad2tri "$DATA/bad/tilted.step" --boundary-names $names.json -o $names.tri.h5; done
  assert_equal "$(curve_names space.tri.h5 | tr -d '\n')" '"p""curve_1""curve_2""curve_3"'
  assert_equal "$(curve_names space.tri.h5)" "$(curve_names plane.tri.h5)"
}

@test "--name names curves by number, range, pattern and nearest point, and wins over a file" {
  cad2tri "$DATA/labels.step" --name floor=0,3 --name 'side=wal?s' --name inner@1.1,0.75 -o a.tri.h5
  assert_equal "$(curve_names a.tri.h5 | tr -d '\n')" '"floor""outlet""side""floor""inner"'
  run stagecheck a.tri.h5
  assert_success
  echo '{"outlet": "far", "3": "inlet", "*": "wall"}' > names.json
  cad2tri "$DATA/labels.step" --boundary-names names.json --name '*out=outlet' --name low=3 -o a.tri.h5
  assert_equal "$(curve_names a.tri.h5 | tr -d '\n')" '"wall""*out""wall""low""wall"'
  cad2tri "$DATA/labels.step" --name 'wall=*' --name in=1-2 -o a.tri.h5
  assert_equal "$(curve_names a.tri.h5 | tr -d '\n')" '"wall""in""in""wall""wall"'
  cad2tri "$DATA/bad/tilted.step" --name p@2,2,3 -o a.tri.h5 # a point of the model's space
  assert_equal "$(curve_names a.tri.h5 | tr -d '\n')" '"p""curve_1""curve_2""curve_3"'
}

@test "--name and --boundary-names name circles by their diameter, and what lies in a box" {
  cad2tri "$DATA/plate_hole.step" --name 'hole=circles(<100)' -o a.tri.h5
  names=$(curve_names a.tri.h5)
  assert_equal "$(grep -c hole <<<"$names")" 1
  echo '{"circles()": "hole", "*": "wall"}' >names.json
  cad2tri "$DATA/plate_hole.step" --boundary-names names.json -o a.tri.h5
  assert_equal "$(curve_names a.tri.h5 | tr -d '\n')" '"wall""wall""wall""wall""hole"'
  run -3 cad2tri "$DATA/plate_hole.step" --name 'x=circles(>100)' -o a.tri.h5
  assert_output --partial 'no boundary curve fits circles(>100); the curves are'
}

@test "--name and --boundary-names name what continues a curve without a corner" {
  cad2tri "$DATA/stadium.step" --name 'rim=tangent(2)' -o a.tri.h5
  assert_equal "$(curve_names a.tri.h5 | tr -d '\n')" '"rim""rim""rim""rim"'
  echo '{"tangent(0)": "flat"}' >names.json
  cad2tri "$DATA/half_disc.step" --boundary-names names.json -o a.tri.h5
  assert_equal "$(curve_names a.tri.h5 | tr -d '\n')" '"flat""curve_1"'
  run -3 cad2tri "$DATA/half_disc.step" --name 'x=tangent(99)' -o a.tri.h5
  assert_output --partial 'no boundary curve fits tangent(99); the curves are'
  run -2 cad2tri "$DATA/half_disc.step" --name 'x=tangent()' -o a.tri.h5
  assert_output --partial 'expected tangent(N) or tangent(NAME)'
}

@test "a --name without a match ends with 3 and lists the curves, a mistaken one with 2" {
  refused() { # CODE OPTION MESSAGE
    run cad2tri "$DATA/labels.step" --name "$2" -o a.tri.h5
    assert_failure "$1"
    assert_output --partial "cad2tri: --name $2: $3"
  }
  refused 3 'x=edge_*' 'no boundary curve has the name edge_*; the curves are 0 "Zufluß", 1 "outlet"'
  refused 3 x=5 'no boundary curve has the number 5; the curves are 0 "Zufluß", 1 "outlet"'
  refused 3 x@2,0 '(2, 0) is equally near to the curves 0 "Zufluß" and 1 "outlet"'
  refused 3 x@3,0.5 '(3, 0.5) lies 1 away from the boundary'
  refused 2 x 'expected NAME=LIST'
  refused 2 x=1,,2 'an item of the list is empty'
  refused 2 x@1 'a point is X,Y or X,Y,Z'
  run cad2tri "$DATA/labels.step" --name x=1 --name y=outlet -o a.tri.h5
  assert_failure 3
  assert_output --partial '--name y=outlet names curve 1, as --name x=1 does: "y" or "x"?'
  assert_nothing_left
}

@test "names that fit no curve, several, or one twice end with 3 and say where" {
  refused() {
    echo "$1" > names.json
    run cad2tri "$DATA/labels.step" --boundary-names names.json -o a.tri.h5
    assert_failure 3
    assert_output --partial "cad2tri: names.json: $2"
  }
  refused '{"lid": "x"}' '"lid": no boundary curve has this name or number; the curves are 0 "Zufluß", 1 "outlet"'
  refused '[{"id": 5, "name": "x"}]' 'entry 0: no boundary curve'
  refused '[{"near": [2, 0], "name": "x"}]' 'entry 0: (2, 0) is equally near to the curves 0 "Zufluß" and 1 "outlet"'
  refused '[{"near": [20, 0], "name": "x"}]' 'entry 0: (20, 0) lies 18 away from the boundary'
  refused '[{"id": 1, "name": "x"}, {"near": [1.9, 0.5], "name": "y"}]' 'entry 1 names curve 1, as names.json: entry 0 does'
  refused '{"1": "x", "1": "y"}' 'the key "1" occurs twice'
  refused '[{"id": 1}]' 'entry 0: must be an object'
  refused 'x' 'not JSON'
  assert_nothing_left names.json
}

# rounder FACTOR: the stadium with a radius FACTOR times as large as its lines ask for, so that its edges do not meet.
rounder() {
  sed -E "s/^(#[0-9]+ = CIRCLE\('',#[0-9]+,)1\.\)/\1$1)/" "$DATA/stadium.step"
}

@test "edges that do not meet are healed, and the message, the report and the file tell where" {
  for radius in 1.0000007 1.000005 1.00001; do
    rounder $radius > slot.step
    run cad2tri slot.step -o slot.tri.h5 --report slot.json
    assert_success
    assert_output --regexp '^cad2tri: healed 4 joints; by at most [0-9.e-]+ millimetre \([0-9e-]+ diameters\)$'
    assert_equal "$(jq -c '[.heal.repairs, .heal.repair["3"].kind, .face.corners]' slot.json)" '[4,"joint",0]'
    run h5dump -d repairs/kind slot.tri.h5
    assert_output --partial '"joint", "joint", "joint", "joint"'
    run stagecheck slot.tri.h5
    assert_success
  done
}

@test "--heal-tolerance bounds what is healed, and 0 turns it off" {
  rounder 1.0003 > slot.step
  run cad2tri slot.step -o slot.tri.h5 --heal-tolerance 1e-5
  assert_failure 3
  assert_output --regexp 'slot.step: edge [0-9]: its vertex at .* lies 0.0003 off its curve .*: give --heal-tolerance 7.5e-05$'
  cad2tri slot.step -o slot.tri.h5 --heal-tolerance 7.6e-5
  rounder 1.000005 > slot.step
  run cad2tri slot.step -o none.tri.h5 --heal-tolerance 0
  assert_failure 3
  assert_output --partial 'off its curve'
  for value in -2 0.006; do
    run cad2tri slot.step -o none.tri.h5 --heal-tolerance $value
    assert_failure 2
    assert_output --partial '--heal-tolerance'
  done
  assert_nothing_left slot.step slot.tri.h5
}

# cusp: between a line and an arc of radius 1 that touches it at (0, 0).
cusp() {
  PYTHONPATH="$DATA" python3 -c '
from step_text import step_text
top = 0.8 + 0.4j
loop = [("line", 0j, 1 + 0j), ("line", 1 + 0j, 1 + 0.4j), ("line", 1 + 0.4j, top), ("arc", 1j, 1, top, 0j, -1)]
print(step_text("cusp", [loop]))'
}

@test "--blunt cuts the tip of a cusp off, by itself with a warning; --blunt 0 refuses it" {
  cusp > cusp.step
  run cad2tri cusp.step -o a.tri.h5 --report a.json
  assert_success
  assert_output --regexp 'W-CAD-011: cusp.step: .* meet in a cusp at \(0, 0\), 0.046 long and 0.0011 wide: give --blunt WIDTH'
  assert_equal "$(jq -c '[.heal.repairs, .heal.repair["0"].kind, .face.curves]' a.json)" '[1,"cusp",5]'
  run stagecheck a.tri.h5
  assert_success
  rm a.tri.h5 a.json
  run cad2tri cusp.step -o a.tri.h5 --blunt 0
  assert_failure 3
  assert_output --regexp 'cusp.step: edges 3 and 0 meet in a cusp at \(0, 0\), an angle of zero, .* give --blunt 0.001 to'
  run cad2tri cusp.step -o a.tri.h5 --blunt 0.001 --report a.json --write-healed blunt.step
  assert_success
  assert_output --partial 'healed 1 cusp cut off'
  assert_equal "$(jq -c '[.heal.repairs, .heal.repair["0"].kind, .face.curves, .face.corners]' a.json)" '[1,"cusp",5,5]'
  run h5dump -d repairs/kind a.tri.h5
  assert_output --partial '"cusp"'
  run stagecheck a.tri.h5
  assert_success
  cad2tri blunt.step -o b.tri.h5 --report b.json
  assert_equal "$(jq '.heal.repairs' b.json)" 0
  run cad2tri cusp.step -o c.tri.h5 --blunt 0.5
  assert_failure 3
  assert_output --partial 'give --blunt 0.37, the largest that would do'
  run cad2tri cusp.step -o c.tri.h5 --blunt -1
  assert_failure 2
  assert_nothing_left cusp.step a.tri.h5 a.json blunt.step b.tri.h5 b.json
}

# crescent DEGREES: between a half circle and an arc that meets it at this angle.
crescent() {
  PYTHONPATH="$DATA" python3 -c '
import math, sys
from step_text import step_text
angle = math.pi / 2 - math.radians(float(sys.argv[1]))
radius, centre = 1 / math.sin(angle), 1j / math.tan(angle)
print(step_text("crescent", [[("arc", 0j, 1, -1 + 0j, 1 + 0j, 1), ("arc", centre, radius, 1 + 0j, -1 + 0j, -1)]]))' "$1"
}

@test "a face too narrow to be meshed is refused with its width, and --blunt cuts its sharp corners off" {
  crescent 0.05 > narrow.step
  run cad2tri narrow.step -o a.tri.h5 --blunt 0
  assert_failure 1
  assert_output --regexp 'takes more than 10000 element edges: it is .* diameters\) wide at .*: the corner of 0.05 degrees at .* is sharp: cut its tip off with --blunt'
  cad2tri narrow.step --blunt 3e-4 -o a.tri.h5 --report a.json -q
  assert_equal "$(jq -c '[.heal.repairs, .face.curves]' a.json)" '[2,4]'
  run stagecheck a.tri.h5
  assert_success
  assert_nothing_left narrow.step a.tri.h5 a.json
}

# touching TIP: a plate of 4 x 3 with a hole in the form of a kite, from the lower edge up to y = TIP.
touching() {
  PYTHONPATH="$DATA" python3 -c '
import sys
from step_text import step_text
sides = lambda *p: [("line", a, b) for a, b in zip(p, p[1:] + p[:1])]
tip = float(sys.argv[1]) * 1j
print(step_text("touching", [sides(0j, 4 + 0j, 4 + 3j, 3j), sides(1.5 + 0j, 1 + 1j, 1.5 + tip, 2 + 1j)]))' "$1"
}

@test "--face chooses a piece of a face whose boundary touches itself, --blunt opens a single contact" {
  touching 3 > two.step
  run cad2tri two.step -o a.tri.h5
  assert_failure 3
  assert_output --partial 'touches itself, with no width in between, at (1.5, 0), and separates 2 pieces: choose one with --face 0.0 to 0.1'
  cad2tri two.step --face 0.0 -o a.tri.h5 --report a.json
  cad2tri two.step --face 0.1 -o b.tri.h5 --report b.json
  assert_equal "$(jq -c -s 'map([.face.curves, .face.loops, .face.area * 1000 | round])' a.json b.json)" \
    '[[5,1,6750],[5,1,3750]]'
  run cad2tri two.step --face 0.2 -o c.tri.h5
  assert_failure 3
  touching 2 > one.step
  run cad2tri one.step -o c.tri.h5 --blunt 0
  assert_failure 3
  assert_output --partial 'at (1.5, 0), where edges 0 and 4 meet: the face has a width of zero there: give --blunt 0.005 to'
  run cad2tri one.step --face 0.1 -o c.tri.h5
  assert_failure 3
  assert_output --partial 'the face has one piece, number 0'
  cad2tri one.step --face 0.0 --blunt 0.005 -o c.tri.h5 --report c.json
  assert_equal "$(jq -c '[.face.loops, .heal.repairs]' c.json)" '[1,2]'
  cad2tri -q one.step -o c.tri.h5 --report c.json
  assert_equal "$(jq -c '[.face.loops, .heal.repairs, .warnings[0].code]' c.json)" '[1,2,"W-CAD-011"]'
  assert_nothing_left two.step one.step a.tri.h5 b.tri.h5 c.tri.h5 a.json b.json c.json
}

@test "a hole with a side on the outline becomes a notch, with a warning; --blunt 0 refuses it" {
  PYTHONPATH="$DATA" python3 -c '
from step_text import step_text
sides = lambda *p: [("line", a, b) for a, b in zip(p, p[1:] + p[:1])]
print(step_text("beside", [sides(0j, 4 + 0j, 4 + 3j, 3j), sides(1 + 0j, 1 + 1j, 2 + 1j, 2 + 0j)]))' >beside.step
  run cad2tri beside.step -o a.tri.h5 --report a.json
  assert_success
  assert_output --partial 'W-CAD-011: beside.step: edges 0 and 7 run along each other from (1, 0) to (2, 0), 1 long,'
  assert_equal "$(jq -c '[.face.loops, .face.curves, (.face.area | round)]' a.json)" '[1,8,11]'
  run cad2tri beside.step -o b.tri.h5 --blunt 0
  assert_failure 3
  assert_output --partial 'the boundary touches itself at (1, 0)'
  assert_nothing_left beside.step a.tri.h5 a.json
}

@test "--write-healed writes a face that needs no healing" {
  rounder 1.000005 > slot.step
  cad2tri slot.step -o slot.tri.h5 --write-healed healed.step
  cad2tri slot.step -o slot.tri.h5 --write-healed healed.brep
  for file in healed.step healed.brep; do
    run cad2tri $file -o again.tri.h5 --report again.json
    assert_success
    assert_output ''
    assert_equal "$(jq '.heal.repairs' again.json)" 0
  done
  run cad2tri slot.step -o slot.tri.h5 --write-healed healed.txt
  assert_failure 2
  assert_output --partial '--write-healed healed.txt: the file must end in .step, .stp or .brep'
}

@test "--list prints faces and edges as a table, and the report has the same" {
  run cad2tri --list "$DATA/bad/solid.step" --report list.json
  assert_success
  assert_line --index 0 --regexp '^face +edge +kind +length +place +name +part +layer$'
  assert_line --regexp '^5 +plane +[0-9.]+ +\([-0-9.]+, [-0-9.]+, [-0-9.]+\)$'
  assert_equal "${#lines[@]}" 31
  run jq -c '.list | [.faces, .length_unit, .face["5"].kind, .face["5"].edges, .face["0"].edge["3"].kind]' list.json
  assert_output '[6,"millimetre","plane",4,"line"]'
  cad2tri "$DATA/bad/sphere.step" --list -o table.txt
  grep -qE '^0 +sphere' table.txt
  cad2tri --list "$DATA/labels.iges" | grep -q 'the wall'
  cad2tri --list "$DATA/bad/rectangle.brep" | grep -qE '^0 +plane +6 +\(1, 0.5, 0\)$'
  assert_nothing_left list.json table.txt
}

@test "--list planar and --list curved show these faces alone, with their numbers" {
  shape=$DATA/curved/half_cylinder.step
  numbers() { cad2tri "$@" | awk '$1 ~ /^[0-9]+$/ && $2 ~ /^[a-z]/ && $2 !~ /^(line|circle|spline|ellipse)$/ { print $1 }' | xargs; }
  planar=$(numbers --list planar "$shape") curved=$(numbers "$shape" --list=curved) all=$(numbers --list "$shape")
  assert_not_equal "$planar" ''
  assert_not_equal "$curved" ''
  assert_equal "$(xargs -n1 <<<"$planar $curved" | sort -n | xargs)" "$all"
  assert_equal "$(cad2tri "$shape" --list curved | grep -c plane)" 0
  run -2 cad2tri --list=flat "$shape"
  assert_output --partial "--list: 'flat' is not one of planar|curved"
}

@test "--face takes a face by number or name" {
  for face in 0 5; do
    cad2tri "$DATA/bad/solid.step" --face $face -o a.tri.h5
    run stagecheck a.tri.h5
    assert_success
  done
  sed "s/ADVANCED_FACE('',/ADVANCED_FACE('lid',/" "$DATA/bad/two_faces.step" > lids.step
  sed "0,/'lid'/s//'floor'/" lids.step > named.step
  cad2tri named.step --face lid -o lid.tri.h5 --report lid.json
  cad2tri named.step --face 1 -o one.tri.h5 --report one.json
  assert_equal "$(jq .face.area lid.json)" "$(jq .face.area one.json)"
  run cad2tri lids.step --face lid -o none.tri.h5
  assert_failure 3
  assert_output 'cad2tri: lids.step: --face lid: the faces 0, 1 have this name: choose one by its number'
  assert_file_not_exists none.tri.h5
}

@test "--list shows the parts and layers of faces, and --face takes them" {
  cad2tri --list "$DATA/assemblies/parts.step" --report list.json > table.txt
  grep -qE '^8 .* rig/plate/inlet +wet$' table.txt
  assert_equal "$(jq -c '.list.face["3"] | [.part, .layer]' list.json)" '["rig/bolt/shank","steel"]'
  cad2tri "$DATA/assemblies/parts.step" --face inlet -o inlet.tri.h5
  cad2tri "$DATA/assemblies/parts.step" --face 8 -o number.tri.h5
  assert_equal "$(stageview <inlet.tri.h5 | cksum)" "$(stageview <number.tri.h5 | cksum)"
  run cad2tri "$DATA/assemblies/parts.step" --face bolt -o none.tri.h5
  assert_failure 3
  assert_output --partial '--face bolt: the faces 0-7 lie in the part or layer of this name: choose one by its number'
}

@test "--list names the faces that cannot be built in a warning" {
  sed "s/^#202=ADVANCED_FACE('rim',(#200),#201/#202=ADVANCED_FACE('rim',(#200),\$/" "$DATA/assemblies/parts.step" > a.step
  cad2tri --list a.step --report list.json -o table.txt 2> messages.txt
  assert_equal "$(cat messages.txt)" "cad2tri: warning W-CAD-007: 1 face is not listed, because the CAD kernel could not build it: #202 'rim': repair or export it again"
  assert_equal "$(jq -c '.list | [.faces, .not_built]' list.json)" '[10,1]'
}

@test "placements that scale or mirror by an operator are refused" {
  cad2tri "$DATA/assemblies/mapped.step" -o a.tri.h5
  run stagecheck a.tri.h5
  assert_success
  sed 's/#51,1.,#52)/#51,2.,#52)/' "$DATA/assemblies/mapped.step" > scaled.step
  run cad2tri scaled.step -o none.tri.h5
  assert_failure 3
  assert_output --partial 'scaled.step: #54 places a part with #53 CARTESIAN_TRANSFORMATION_OPERATOR_3D, which scales it by 2'
  sed 's/^Locations 0$/Locations 1\n1\n2 0 0 0\n0 2 0 0\n0 0 2 0/; s/^+1 0 *$/+1 1/' "$DATA/bad/rectangle.brep" > scaled.brep
  run cad2tri scaled.brep -o none.tri.h5
  assert_failure 3
  assert_output --partial 'scaled.brep: the face is placed with a scale of 2'
}

@test "several faces, and a face that is not there, end with 3 and the options that help" {
  for arguments in "" "--face 6" "--face lid"; do
    run cad2tri "$DATA/bad/solid.step" -o a.tri.h5 $arguments
    assert_failure 3
    assert_output --partial "choose"
    assert_output --partial "--face NUMBER or --face NAME (cad2tri --list FILE shows numbers and names)"
  done
  run cad2tri "$DATA/bad/solid.step" --list --face 1
  assert_failure 2
  assert_output --partial "--list and --face exclude each other"
  run cad2tri "$DATA/bad/garbage.step" --list
  assert_failure 3
  assert_nothing_left
}

# libraries_of PROGRAM: the CAD kernel's libraries that the loader loads for it, one a line.
libraries_of() {
  ldd "$1" | sed -nE 's/^\s*lib(TK[A-Za-z0-9]+)\.so.*/\1/p'
}

@test "the CAD kernel's libraries are loaded by the program of the file's format alone" {
  local libexec=$BIN/../libexec
  for tool in cad2tri quadexport; do assert_equal "$(libraries_of "$BIN/$tool")" ''; done
  assert_equal "$(libraries_of "$libexec/cad2tri-step" | grep -E 'TKSTEP$|TKIGES')" TKSTEP
  assert_equal "$(libraries_of "$libexec/cad2tri-iges" | grep -E 'TKSTEP$|TKIGES')" TKIGES
  assert_equal "$(libraries_of "$libexec/cad2tri-brep" | grep -E 'TKBRep|TKXSBase|TKSTEP|TKIGES')" TKBRep
}

@test "without the program of its format a file ends with 70 and the path" {
  mkdir bin libexec
  cp "$BIN/cad2tri" bin
  cp "$BIN/../libexec/cad2tri-brep" libexec
  run bin/cad2tri "$DATA/square.step" -o a.tri.h5
  assert_failure 70
  assert_output "cad2tri: $PWD/bin/../libexec/cad2tri-step cannot be run: No such file or directory"
  bin/cad2tri "$DATA/bad/rectangle.brep" -o a.tri.h5
  assert_nothing_left a.tri.h5 bin bin/cad2tri libexec libexec/cad2tri-brep
}

@test "standard input, output and error may be closed" {
  cad2tri "$DATA/square.step" -o a.tri.h5
  cad2tri "$DATA/square.step" -o b.tri.h5 <&- >&- 2>&-
  cmp a.tri.h5 b.tri.h5
}

# disc_of_points N: a disc as points2step draws it, with a spline through N points.
disc_of_points() {
  awk -v n="$1" 'BEGIN { for (k = 0; k < n; ++k) { a = 8 * atan2(1, 1) * k / n; printf "%.17g %.17g\n", cos(a), sin(a) } }' |
    "$ROOT/pipelines/points2step" --name rim
}

@test "--fit-tolerance: a spline through many points gets few knots, and the files say how far it moved" {
  disc_of_points 600 > disc.step
  run cad2tri disc.step -o disc.tri.h5 --report disc.json
  assert_success
  assert_output ''
  jq -e '.fit.curves == 1 and .fit.knots_before == 599 and .fit.knots_after < 30 and .fit.greatest <= 1e-8
    and .fit.greatest > 0 and .heal.repair["0"].kind == "fit" and .heal.repair["0"].distance <= 2e-8
    and .heal.greatest == 0 and .mesh.elements < 100 and .face.curves == 1' disc.json
  stagecheck disc.tri.h5
  assert_equal "$(h5dump -d repairs/kind disc.tri.h5 | grep -o '"fit"')" '"fit"'
  h5dump -d face/fit_distance disc.tri.h5 | grep -q 'e-0[89]\|e-1'
  h5dump -d face/curve_names disc.tri.h5 | grep -q '"rim"'
  run cad2tri disc.step -o none.tri.h5 --fit-tolerance 0 --report none.json
  assert_success
  jq -e '.fit == null and .heal.repairs == 0 and .mesh.elements > 1000' none.json
  run h5dump -d face/fit_distance none.tri.h5
  assert_failure
  run cad2tri -v disc.step -o coarse.tri.h5 --fit-tolerance 1e-4 --report coarse.json
  assert_output --regexp 'cad2tri: fitted 1 spline with fewer knots, by at most [0-9.]+e-[0-9]+ diameters'
  jq -s -e '.[0].fit.knots_after > .[1].fit.knots_after' disc.json coarse.json
  for value in -1 0.01; do
    run cad2tri disc.step -o wrong.tri.h5 --fit-tolerance $value
    assert_failure 2
    assert_output --partial '--fit-tolerance'
  done
}

@test "the unit of a STEP file has its usual name, whatever the file calls it" {
  # unit PREFIX: unit and metres of the square in that unit; of_metres NAME METRES: in one that the file defines.
  unit() { sed "s/SI_UNIT(.MILLI.,.METRE.)/SI_UNIT($1,.METRE.)/" "$DATA/square.step" >a.step && names; }
  of_metres() {
    sed -e "s/( LENGTH_UNIT() NAMED_UNIT(\*) SI_UNIT(.MILLI.,.METRE.) )/( CONVERSION_BASED_UNIT('$1',#901) \
LENGTH_UNIT() NAMED_UNIT(#902) )/" -e "s/^#91 = /#901 = LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE($2),#903);\
#902 = DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.);\n#903 = ( LENGTH_UNIT() NAMED_UNIT(*) SI_UNIT($,.METRE.) );\n&/" \
      "$DATA/square.step" >a.step && names
  }
  names() { cad2tri -q a.step -o a.tri.h5 --report a.json && h5dump -y -d face/metres_per_unit a.tri.h5 |
    sed -n 's/^ *\([0-9][0-9.e+-]*\)$/\1/p' | head -n 1 | sed "s/^/$(jq -r .face.length_unit a.json) /"; }
  assert_equal "$(unit '$')" "metre 1"
  assert_equal "$(unit .NANO.)" "nanometre 1e-09"
  assert_equal "$(unit .PICO.)" "picometre 1e-12"
  assert_equal "$(unit .HECTO.)" "hectometre 100"
  assert_equal "$(of_metres INCHES 0.0254)" "inch 0.0254"
  assert_equal "$(of_metres Yard 0.9144)" "yard 0.9144"
  assert_equal "$(of_metres "" 0.9144)" "unit of 0.9144 m 0.9144"
}

@test "--section cuts solids, and its faces are listed, chosen and named as others" {
  cad2tri "$DATA/bad/solid.step" --section z=0.25 -o cut.tri.h5 --report cut.json
  run stagecheck cut.tri.h5
  assert_success
  assert_equal "$(jq -c '[.regions.count, .face.curves]' cut.json)" '[1,4]'
  run cad2tri "$DATA/bad/solid.step" --section 0,0,1@7,8,0.25 --list
  assert_line --regexp '^ +0 +line .* face_[0-5]$'
  run cad2tri "$DATA/bad/solid.step" --section z=100 -o no.tri.h5
  assert_failure 3
  assert_output --partial 'cuts no solid'
  run cad2tri "$DATA/bad/solid.step" --section w=1 -o no.tri.h5
  assert_failure 2
  assert_output --partial '--section w=1: expected x=VALUE'
  assert_nothing_left cut.tri.h5 cut.json
}
