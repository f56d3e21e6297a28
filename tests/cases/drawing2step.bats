# pipelines/drawing2step: a drawing in, DXF or SVG, faces of exact curves out.
load ../tools/common

drawing2step=$ROOT/pipelines/drawing2step
quadmesh=$ROOT/pipelines/quadmesh

# dxf: a DXF file of the entities on standard input, one a line, as KIND CODE=VALUE...; numbers before a word of capitals
# alone begin a section.
dxf() {
  awk 'function pair(text) { print substr(text, 1, index(text, "=") - 1); print substr(text, index(text, "=") + 1) }
    function section(name) { if (open) print "0\nENDSEC"; open = name != ""; if (open) print "0\nSECTION\n2\n" name }
    /^ *$/ { next }
    $1 == "SECTION" { section($2); next }
    !open { section("ENTITIES") }
    { first = 1; if ($1 !~ /=/) { print "0\n" $1; first = 2 } for (i = first; i <= NF; ++i) pair($i) }
    END { section(""); print "0\nEOF" }'
}

# rectangle LAYER X Y WIDTH HEIGHT: its lines.
rectangle() {
  echo "LINE 8=$1 10=$2 20=$3 11=$(($2 + $4)) 21=$3"
  echo "LINE 8=$1 10=$(($2 + $4)) 20=$3 11=$(($2 + $4)) 21=$(($3 + $5))"
  echo "LINE 8=$1 10=$(($2 + $4)) 20=$(($3 + $5)) 11=$2 21=$(($3 + $5))"
  echo "LINE 8=$1 10=$2 20=$(($3 + $5)) 11=$2 21=$3"
}

# svg BODY [ATTRIBUTES]: of a page of 100 mm times 50 mm.
svg() {
  echo "<svg xmlns=\"http://www.w3.org/2000/svg\" ${2-width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\"}>$1</svg>"
}

# has_area FILE AREA [OPTION...]: that of its only face, or of its regions; $edges: name, kind and number of its edges.
has_area() {
  run -0 --separate-stderr "$drawing2step" "$1" -o a.step "${@:3}"
  cad2tri -q a.step -o a.tri.h5 --report a.json
  jq -e --argjson area "$(awk "BEGIN { pi = atan2(0, -1); printf \"%.17g\", $2 }")" \
    '.face.area as $found | ($found - $area) / $area | fabs < 1e-9' a.json >verdict ||
    fail "$1 $2: area $(jq .face.area a.json)"
  edges=$(cad2tri --list a.step | awk '$1 ~ /^[0-9]+$/ && $2 ~ /^(line|circle|ellipse|spline)$/ {
    name = $NF ~ /\)$/ ? "-" : $NF; ++count[name ":" $2] }
    END { for (key in count) print key ":" count[key] }' | sort | xargs)
}

@test "every kind of entity of DXF gives its exact area, kinds of curves and names" {
  rectangle wall 0 0 20 10 | dxf >lines.dxf
  has_area lines.dxf '20 * 10'
  assert_equal "$edges" 'wall:line:4'

  dxf >arcs.dxf <<'END'
LINE 8=side 10=0 20=0 11=20 21=0
ARC 8=end 10=20 20=5 40=5 50=270 51=90
LINE 8=side 10=20 20=10 11=0 21=10
ARC 8=end 10=0 20=5 40=5 50=90 51=270
CIRCLE 8=hole 10=5 20=5 40=2
END
  has_area arcs.dxf '200 + pi * 21'
  assert_equal "$edges" 'end:circle:2 hole:circle:1 side:line:2'

  dxf >ellipses.dxf <<'END'
ELLIPSE 8=oval 100=AcDbEntity 100=AcDbEllipse 10=0 20=0 30=0 11=6 21=8 31=0 40=0.5 41=0 42=3.141592653589793
LINE 8=cut 10=-6 20=-8 11=6 21=8
ELLIPSE 8=hole 100=AcDbEntity 100=AcDbEllipse 10=-2 20=1 30=0 11=0 21=1 31=0 40=0.75 41=0 42=6.283185307179586
END
  has_area ellipses.dxf 'pi * 10 * 5 / 2 - 0.75 * pi'
  assert_equal "$edges" 'cut:line:1 hole:ellipse:1 oval:ellipse:1'

  echo 'LWPOLYLINE 8=rim 100=AcDbEntity 100=AcDbPolyline 90=4 70=1 10=0 20=0 10=20 20=0 42=1 10=20 20=10 10=0 20=10 42=-0.5' |
    dxf >lwpolyline.dxf
  has_area lwpolyline.dxf '200 + 12.5 * pi - 625 / 32 * (4 * atan2(1, 2) - sin(4 * atan2(1, 2)))'
  assert_equal "$edges" 'rim:circle:2 rim:line:2'

  dxf >polyline.dxf <<'END'
POLYLINE 8=rim 66=1 70=1
VERTEX 8=rim 10=0 20=0
VERTEX 8=rim 10=4 20=0 42=0.41421356237309503
VERTEX 8=rim 10=0 20=4
SEQEND
END
  has_area polyline.dxf '4 * pi'
  assert_equal "$edges" 'rim:circle:1 rim:line:2'

  # A quarter of a circle as a rational quadratic, and a closed quadratic with knots that are not repeated at its ends.
  dxf >spline.dxf <<'END'
LINE 8=side 10=0 20=0 11=2 21=0
SPLINE 8=arc 100=AcDbEntity 100=AcDbSpline 70=12 71=2 72=6 73=3 74=0 40=0 40=0 40=0 40=1 40=1 40=1 41=1 41=0.7071067811865476 41=1 10=2 20=0 30=0 10=2 20=2 30=0 10=0 20=2 30=0
LINE 8=side 10=0 20=2 11=0 21=0
END
  has_area spline.dxf pi
  assert_equal "$edges" 'arc:spline:1 side:line:2'
  echo 'SPLINE 8=round 100=AcDbEntity 100=AcDbSpline 70=11 71=2 72=9 73=6 74=0 40=0 40=1 40=2 40=3 40=4 40=5 40=6 40=7 40=8' \
    '10=0 20=0 30=0 10=6 20=0 30=0 10=6 20=6 30=0 10=0 20=6 30=0 10=0 20=0 30=0 10=6 20=0 30=0' | dxf >periodic.dxf
  has_area periodic.dxf '36 * 5 / 6'
  assert_equal "$edges" 'round:spline:1'
}

@test "blocks are inserted where they belong: nested, scaled, turned, mirrored, in rows" {
  {
    cat <<'END'
SECTION BLOCKS
BLOCK 8=0 2=pair 70=0 10=1 20=0
CIRCLE 8=0 10=1 20=0 40=1
LWPOLYLINE 8=slot 100=AcDbEntity 100=AcDbPolyline 90=4 70=1 10=3 20=0 10=5 20=0 42=0.5 10=5 20=1 10=3 20=1
ENDBLK
BLOCK 8=0 2=outer 70=0 10=0 20=0
INSERT 8=0 2=pair 10=2 20=0 41=-1 42=1
ENDBLK
SECTION ENTITIES
INSERT 8=bolts 2=outer 10=30 20=10 41=2 42=2 50=90
INSERT 8=bolts 2=pair 10=60 20=10 41=1 42=3
INSERT 8=bolts 2=pair 10=60 20=30 70=2 71=2 44=10 45=8
END
    rectangle plate 0 0 100 50
  } | dxf >blocks.dxf
  # A circle and a slot of each: the segment of a bulge of 0.5 on a chord of 1 has radius 5/8 and 4 atan 0.5.
  local pair='(pi + 2 + 25 / 128 * (4 * atan2(1, 2) - sin(4 * atan2(1, 2))))'
  has_area blocks.dxf "5000 - $pair * (4 + 3 + 4)"
  assert_equal "$edges" 'bolts:circle:5 bolts:ellipse:1 plate:line:4 slot:circle:5 slot:ellipse:1 slot:line:18'
  cad2tri --list a.step | grep -q ' circle  *12.5664 *(30, 16, 0) *bolts' || fail "$(cad2tri --list a.step)"

  # A normal that points down mirrors what is drawn in its plane.
  dxf >mirrored.dxf <<'END'
ARC 8=arc 10=-3 20=0 40=2 50=0 51=90 210=0 220=0 230=-1
LINE 8=side 10=1 20=0 11=3 21=0
LINE 8=side 10=3 20=0 11=3 21=2
END
  has_area mirrored.dxf pi
  echo 'CIRCLE 8=a 10=0 20=0 40=2 210=0 220=1 230=1' | dxf >tilted.dxf
  run -3 "$drawing2step" tilted.dxf
  assert_output --regexp '^drawing2step: tilted.dxf: CIRCLE [0-9A-F]+ \(layer a\) is tilted: .*--drawing-layers'
}

@test "every shape and command of SVG gives its exact area, with y upwards" {
  svg '<path id="wall" d="M10 10h20v10H10z"/>' >path.svg
  has_area path.svg 200
  assert_equal "$edges" 'wall:line:4'
  grep -q 'CARTESIAN_POINT(.*,(10.0,40.0,0.))' a.step
  svg '<path class="rim" d="M5 10a5 5 0 1 1 10 0 5 5 0 1 1-10 0"/>' >arc.svg
  has_area arc.svg '25 * pi'
  assert_equal "$edges" 'rim:circle:2'
  svg '<g id="oval"><path d="M5 10a5 2 30 1 0 10 0l-4-3z"/></g>' >ellipse.svg
  run -0 "$drawing2step" ellipse.svg -o a.step
  grep -q 'ELLIPSE' a.step
  svg '<path d="M0 0Q5 10 10 0T20 0L20 20 0 20z"/>' >quadratic.svg # above and below by two thirds of 10 times 5
  has_area quadratic.svg 400
  svg '<path d="M0 10C2 5 8 5 10 10S18 15 20 10V0H0z"/>' >cubic.svg
  has_area cubic.svg 200
  svg '<rect id="a" x="2" y="3" width="10" height="8" rx="2" ry="1"/>' >rect.svg
  has_area rect.svg '80 - (4 - pi) * 2'
  assert_equal "$edges" 'a:ellipse:4 a:line:4'
  svg '<circle id="a" cx="9" cy="9" r="3"/>' >circle.svg
  has_area circle.svg '9 * pi'
  svg '<ellipse id="a" cx="9" cy="9" rx="3" ry="1"/>' >oval.svg
  has_area oval.svg '3 * pi'
  svg '<polygon id="a" points="0,0 10,0 0,10"/>' >polygon.svg
  has_area polygon.svg 50
  svg '<polyline id="a" points="0,0 10,0 0,10"/><line id="b" y1="10" x2="0"/>' >open.svg
  has_area open.svg 50
  assert_equal "$edges" 'a:line:2 b:line:1'
  svg '<g transform="translate(50 25) rotate(30)"><g transform="scale(2 -1)"><circle id="a" r="3"/></g></g>' >groups.svg
  has_area groups.svg '18 * pi'
  assert_equal "$edges" 'a:ellipse:1'
  svg '<g transform="skewX(20) scale(3)"><use href="#r" x="1"/></g><defs><rect id="r" width="2" height="4"/></defs>' >use.svg
  has_area use.svg 72
}

@test "units of the drawing are those of the STEP file; --unit takes the numbers as they are" {
  local row unit
  for row in 1:INCH 2:FOOT 4:.MILLI. 5:.CENTI. 6:'$' 13:.MICRO.; do
    { printf 'SECTION HEADER\n9=$INSUNITS 70=%d\nSECTION ENTITIES\n' "${row%:*}" && rectangle a 0 0 2 1; } | dxf >a.dxf
    has_area a.dxf 2
    assert_equal "$stderr" ''
    grep -qF "${row#*:}" a.step
  done
  { printf 'SECTION HEADER\n9=$INSUNITS 70=10\nSECTION ENTITIES\n' && rectangle a 0 0 2 1; } | dxf >yards.dxf
  has_area yards.dxf 18
  grep -q FOOT a.step
  has_area yards.dxf 2 --unit m
  rectangle a 0 0 2 1 | dxf >none.dxf
  has_area none.dxf 2
  assert_equal "$stderr" 'drawing2step: the drawing states no unit: its numbers are taken as mm (--drawing-unit)'
  { printf 'SECTION HEADER\n9=$INSUNITS 70=20\nSECTION ENTITIES\n' && rectangle a 0 0 2 1; } | dxf >parsec.dxf
  run -3 "$drawing2step" parsec.dxf
  assert_output 'drawing2step: parsec.dxf: its unit ($INSUNITS 20) is none of those that STEP files have: give --drawing-unit'
  for row in '2in:.*INCH:8' '20mm:.MILLI.:800' '2cm:.CENTI.:8' '192:.MILLI.:5161.28'; do
    unit=${row#*:}
    svg '<rect id="a" width="10" height="20"/>' "width=\"${row%%:*}\" viewBox=\"0 0 10 20\"" >a.svg
    has_area a.svg "${unit#*:}"
    grep -q "${unit%:*}" a.step
    has_area a.svg 200 --unit um
  done
}

@test "gaps are named with place, size, both curves and the tolerance that closes them" {
  dxf >gap.dxf <<'END'
LINE 5=2A 8=wall 10=0 20=0 11=100 21=0
LINE 5=2B 8=wall 10=100 20=0 11=100 21=50
ARC 5=2C 8=bow 10=50 20=50 40=50 50=0 51=179.99
LINE 5=2D 8=wall 10=0 20=50 11=0 21=0
END
  run -3 "$drawing2step" gap.dxf -o a.step
  assert_output --regexp '^drawing2step: gap.dxf: a gap of 0.00873 mm at \(.*\): (ARC 2C \(layer bow\) ends 0.00873 mm from LINE 2D \(layer wall\)|LINE 2D \(layer wall\) ends 0.00873 mm from ARC 2C \(layer bow\)): close it in the drawing, join what is as near by --drawing-tolerance 0.009, leave its layer out'
  assert_file_not_exists a.step
  run -0 "$drawing2step" gap.dxf -o a.step --tolerance 0.009
  assert_line --regexp 'drawing2step: ends up to 0.00873 mm apart are joined, most at \('
  run -3 "$quadmesh" gap.dxf -o a.msh
  assert_output --regexp '^quadmesh: gap.dxf: a gap of 0.00873 mm'
  run -0 "$quadmesh" gap.dxf -o a.msh --drawing-tolerance 0.009 --report a.json
  jq -e '.valid' a.json

  { rectangle wall 0 0 10 10 && echo 'LINE 8=axis 10=5 20=-1 11=5 21=11'; } | dxf >axis.dxf
  run -3 "$drawing2step" axis.dxf
  assert_output --regexp ': LINE [0-9A-F]+ \(layer wall\) crosses LINE [0-9A-F]+ \(layer axis\) at \(5, (0|10)\): trim them'
  has_area axis.dxf 100 --layers '!axis'
  has_area axis.dxf 100 --layers 'w*'
  run -3 "$drawing2step" axis.dxf --layers walls
  assert_output "drawing2step: axis.dxf: --drawing-layers: no curve is called 'walls'; there are axis, wall"
  svg '<path id="rim" d="M0 0h10v10h-10z"/><path id="stub" d="M2 2h3"/>' >open.svg
  run -3 "$drawing2step" open.svg
  assert_output --regexp "^drawing2step: open.svg: a gap of 2 mm at \(2, 48\): path 'stub' ends 2 mm from path 'rim': close it in the drawing, leave its layer out"
}

@test "repeated, short and idle curves are left out with a warning" {
  { rectangle wall 0 0 10 10 && echo 'LINE 8=again 10=10 20=0 11=0 21=0' && echo 'LINE 8=dot 10=3 20=0 11=3 21=0'; } | dxf >a.dxf
  has_area a.dxf 100
  assert_equal "$edges" 'wall:line:4'
  [[ $stderr == *'warning W-DRW-001: left out, as no longer than 0.000141 mm: LINE '*' (layer dot) at (3, 0)'* ]]
  [[ $stderr == *'warning W-DRW-002: kept once, although drawn several times: LINE '*' (layer again) on LINE '*' (layer wall) at (5, 0)'* ]]
  "$quadmesh" -q a.dxf -o a.msh --report a.json
  jq -e '[.warnings[].code] | index("W-DRW-001") != null and index("W-DRW-002") != null' a.json
  { rectangle wall 0 0 10 10 && rectangle hole 4 4 2 2 && echo 'LINE 8=idle 10=4 20=4 11=6 21=6'; } | dxf >idle.dxf
  has_area idle.dxf 96
  [[ $stderr == *'warning W-DRW-003: left out, as they lie inside holes and bound no face: LINE '*' (layer idle) at (5, 5)'* ]]
  { rectangle wall 0 0 10 10 && echo 'MLINE 8=wall 100=AcDbEntity 100=AcDbMline 10=1 20=1 30=0' && echo 'CIRCLE 8=hole 10=5 20=5 30=2 40=1' && echo 'TEXT 8=0 10=1 20=1 40=1 1=A'; } | dxf >other.dxf
  has_area other.dxf '100 - pi'
  [[ $stderr == *'warning W-DRW-004: what is not read is left out: 1 MLINE'* ]]
  [[ $stderr == *'warning W-DRW-005: curves lie at heights from z = 0 to 2: they are taken as seen from above'* ]]
  [[ $stderr == *'left out: 1 TEXT'* ]]
}

@test "loops in loops are faces and holes, with --regions regions; what touches is a region" {
  { rectangle plate 0 0 100 50 && echo 'CIRCLE 8=hole 10=50 20=25 40=20' && echo 'CIRCLE 8=pin 10=50 20=25 40=5'; } | dxf >nested.dxf
  "$drawing2step" -q nested.dxf -o a.step
  run -0 bash -c "cad2tri --list a.step | grep -c ' plane '"
  assert_output 2
  cad2tri -q a.step --face plate -o a.tri.h5 --report a.json
  jq -e '.face.area - (5000 - 400 * 3.14159265358979) | fabs < 1e-6' a.json
  has_area nested.dxf 5000 --regions
  assert_equal "$edges" 'hole:circle:2 pin:circle:2 plate:line:4'
  "$quadmesh" -q nested.dxf --regions -o a.msh --report a.json
  jq -e '.valid' a.json
  for name in plate hole pin; do grep -q "^2 [0-9]* \"$name\"" a.msh; done

  { rectangle steel 0 0 10 10 && rectangle air 10 2 10 5; } | dxf >touching.dxf
  has_area touching.dxf 150
  { rectangle wall 0 0 10 10 && echo 'ARC 8=bow 10=0 20=0 40=4 50=0 51=90'; } | dxf >divided.dxf
  has_area divided.dxf 100
  "$quadmesh" -q divided.dxf -o a.msh --report a.json
  jq -e '.valid' a.json
}

@test "embedded curves bound nothing, but elements follow them" {
  { rectangle wall 0 0 20 10 && echo 'ARC 8=bow 10=10 20=0 40=6 50=30 51=150' && echo 'LINE 8=cut 10=8 20=8 11=12 21=8.5'; } | dxf >a.dxf
  has_area a.dxf 200 --embed bow,cut
  "$quadmesh" -q a.dxf --embed bow,cut -o a.msh --report a.json
  jq -e '.valid' a.json
  for name in bow cut wall; do grep -q "^1 [0-9]* \"$name\"" a.msh; done
  run -3 "$drawing2step" a.dxf --embed bow,cuts
  assert_output --regexp "--embed: no curve is called 'cuts'; there are bow, cut, wall"
}

@test "names of layers and elements become names of the mesh's boundary" {
  { printf 'SECTION TABLES\nTABLE 2=LAYER 70=1\nLAYER 2=notes 70=1 62=7 6=CONTINUOUS\nLAYER 2=Wand 70=0 62=7 6=CONTINUOUS\nENDTAB\nSECTION ENTITIES\n'
    rectangle WAND 0 0 10 10 && echo 'CIRCLE 8=0 10=5 20=5 40=2' && echo 'LINE 8=notes 10=3 20=20 11=4 21=30'; } | dxf >a.dxf
  run -0 "$quadmesh" a.dxf -o a.msh
  assert_output --partial 'drawing2step: layers that are off or frozen are left out: notes'
  grep -q '^1 [0-9]* "Wand"' a.msh
  grep -q '^1 [0-9]* "curve_4"' a.msh
  svg '<g id="g12" inkscape:label="duct" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"><path id="path3" d="M0 0h9v9h-9z"/></g>' >a.svg
  "$quadmesh" -q a.svg -o a.msh
  grep -q '^1 [0-9]* "duct"' a.msh
}

@test "2,000 entities" {
  {
    rectangle frame 0 0 1000 1000
    awk 'BEGIN { for (i = 0; i < 20; ++i) for (k = 0; k < 20; ++k) { x = 30 + 48 * i; y = 30 + 48 * k
      printf "LINE 8=slot 10=%d 20=%d 11=%d 21=%d\n", x, y, x + 16, y
      printf "ARC 8=slot 10=%d 20=%d 40=5 50=270 51=90\n", x + 16, y + 5
      printf "LINE 8=slot 10=%d 20=%d 11=%d 21=%d\n", x + 16, y + 10, x, y + 10
      printf "ARC 8=slot 10=%d 20=%d 40=5 50=90 51=270\n", x, y + 5
      printf "CIRCLE 8=round 10=%d 20=%d 40=6\n", x + 8, y + 26 } }'
  } | dxf >many.dxf
  assert_equal "$(grep -cxE 'LINE|ARC|CIRCLE' many.dxf)" 2004
  run -0 bash -c 'ulimit -t 10; "$1" -v many.dxf -o many.step 2>&1' - "$drawing2step"
  assert_line --partial 'many: 2004 curves, diagonal 1414.21 mm, 1 face, 800 holes, 2004 edges'
  assert_equal "$(grep -c 'FACE_BOUND' many.step)" 800
}

@test "files, pipes, names in capitals and lines of DOS give the same" {
  rectangle rim 0 0 2 1 | dxf >a.dxf
  sed 's/$/\r/' a.dxf >dos.dxf
  svg '<rect id="rim" width="2" height="1"/>' >a.svg
  local file
  for file in a.dxf a.svg dos.dxf; do
    "$drawing2step" -q $file -o a.step
    "$drawing2step" -q <$file | sed "s/'drawing'/'${file%.*}'/g" | cmp - a.step
    "$quadmesh" -q $file -o a.msh
    "$quadmesh" -q - --drawing-tolerance 1e-5 -o b.msh <$file
    cmp a.msh b.msh
    cp $file other.txt
    "$quadmesh" -q other.txt --drawing-tolerance 1e-5 -o b.msh
    cmp a.msh b.msh
  done
  cp a.dxf A.DXF
  "$quadmesh" -q A.DXF -o b.msh --workdir .
  assert_file_exists A.outline.step
  run -0 "$quadmesh" a.dxf --regions --dry-run -o a.msh
  assert_line --index 0 'drawing2step a.dxf -o ./a.outline.step --regions'
  run -2 "$quadmesh" a.dxf --chord 2 -o a.msh
  assert_line --index 0 'quadmesh: --chord is an option for points (.dat, .xy), but the shape is a drawing: leave it out'
}

@test "what is no drawing is refused with exit code 3" {
  printf 'AC1018' >dwg.dxf
  echo '<html/>' >page.svg
  echo '<svg xmlns="http://www.w3.org/2000/svg">' >cut.svg
  echo 'no drawing' >words.dxf
  : >empty.dxf
  cp "$DATA/half_disc.step" step.dxf
  echo 'TEXT 8=0 10=1 20=1 40=1 1=A' | dxf >text.dxf
  svg '<path d="M0 0L1"/>' >path.svg
  svg '<line x2="1"/>' >line.svg
  { rectangle a 0 0 2 1 | dxf | head -30; } >half.dxf
  while read -r file message; do
    run -3 --separate-stderr "$drawing2step" "$file" -o a.step
    assert_equal "$file ${stderr_lines[0]:0:$((16 + ${#file} + ${#message}))}" "$file drawing2step: $file: $message"
    assert_file_not_exists a.step
  done <<'END'
dwg.dxf is a DWG file: save it as DXF
page.svg is XML, but not SVG: its root is html
cut.svg line 2: is not well-formed XML
words.dxf is no DXF file that ezdxf can read
empty.dxf is empty
step.dxf is a CAD file, not a drawing
text.dxf there is no curve that could bound a face
path.svg line 1: path of line 1: its path data: a number expected at its end
line.svg line of line 1 ends at (0, 50), and there is no other curve: close it
nowhere.dxf cannot be read: No such file or directory
END
}

@test "without ezdxf DXF files are refused with the package, and SVG is read" {
  rectangle a 0 0 2 1 | dxf >a.dxf
  svg '<rect width="2" height="1"/>' >a.svg
  mkdir ezdxf && echo 'raise ImportError' >ezdxf/__init__.py
  PYTHONPATH=$PWD run -1 "$drawing2step" a.dxf
  assert_output 'drawing2step: DXF files need python3-ezdxf: apt-get install python3-ezdxf'
  PYTHONPATH=$PWD run -0 "$drawing2step" a.svg -o a.step
}

@test "the examples of --help run" {
  cp "$ROOT/pipelines/examples/plate.dxf" shipped.dxf # with layers that the example leaves out
  rectangle plate 0 0 100 50 | dxf >plain.dxf
  svg '<rect width="9" height="9"/><circle cx="4" cy="4" r="2"/>' >pin.svg
  PATH=$ROOT/pipelines:$PATH
  "$drawing2step" --help | sed '1,/^EXAMPLES$/d' >examples
  [ "$(wc -l <examples)" -ge 4 ]
  while read -r example; do
    if [[ $example == *layers* ]]; then cp shipped.dxf plate.dxf; else cp plain.dxf plate.dxf; fi
    run -0 bash -c "$example" </dev/null
  done <examples
  run -0 "$drawing2step" --version
  assert_output --regexp '^drawing2step \(Quadrille\) [0-9]'
}
