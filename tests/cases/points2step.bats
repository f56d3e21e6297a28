# pipelines/points2step: points in, a STEP face out whose curves pass through all of them.
load ../tools/common

points2step=$ROOT/pipelines/points2step

# naca0012 closed|blunt SIDES selig|lednicer: coordinates from the formula, with its own nose and cosine spacing.
naca0012() {
  awk -v closed="$([ "$1" = closed ] && echo 1)" -v n="$2" -v form="$3" '
    function half(k, x) {
      x = at(k)
      if (closed && k == 0) return 0
      return 0.6 * (0.2969 * sqrt(x) - 0.1260 * x - 0.3516 * x^2 + 0.2843 * x^3 - (closed ? 0.1036 : 0.1015) * x^4)
    }
    function at(k) { return k == n ? 0 : (1 + cos(atan2(0, -1) * k / n)) / 2 }  # k = 0: the trailing edge
    function line(k, side) { printf "%.12f %.12f\n", at(k), side * half(k) }
    BEGIN {
      print "NACA 0012"
      if (form == "selig") {
        for (k = 0; k <= n; ++k) line(k, 1)
        for (k = n - 1; k >= 0; --k) line(k, -1)
      } else {
        printf " %d. %d.\n\n", n + 1, n + 1
        for (k = n; k >= 0; --k) line(k, 1)
        print ""
        for (k = n; k >= 0; --k) line(k, -1)
      }
    }'
}

# circle POINTS [RADIUS X Y]: counter-clockwise.
circle() {
  awk -v n="$1" -v r="${2:-1}" -v x="${3:-0}" -v y="${4:-0}" '
    BEGIN { for (k = 0; k < n; ++k) { a = 2 * atan2(0, -1) * k / n; printf "%.17g %.17g\n", x + r * cos(a), y + r * sin(a) } }'
}

# fits TRI POINTS: on the points, with tangent and curvature continuous but for corners.
fits() {
  "$BATS_TEST_DIRNAME/points_on_curves.py" "$1" "$2" >fit.json
  jq -e '.off < 1e-14 and .turn < 1e-9 and .bend < 1e-7' fit.json >verdict || fail "$(cat fit.json)"
}

names() { jq -c .names fit.json; }

@test "an aerofoil, sharp or blunt, in either format, is two smooth sides through its points" {
  for edge in closed blunt; do
    for form in selig lednicer; do
      naca0012 $edge 30 $form >$form.dat
      run -0 --separate-stderr "$points2step" -q $form.dat -o $form.step
      assert_equal "$output$stderr" ""
    done
    cmp <(sed /sha256/d selig.step) <(sed /sha256/d lednicer.step)
    cad2tri selig.step -o $edge.tri.h5
    stagecheck $edge.tri.h5
    sed 1d selig.dat >points
    fits $edge.tri.h5 points
    [ $edge = closed ] && assert_equal "$(names)" '["upper","lower"]'
    [ $edge = blunt ] && assert_equal "$(names)" '["upper","lower","trailing_edge"]'
  done
  "$points2step" selig.dat --name main -o a.step
  cad2tri a.step -o a.tri.h5
  fits a.tri.h5 points
  assert_equal "$(names)" '["main_upper","main_lower","main_trailing_edge"]'
  # Upper is upper, whichever side comes first.
  { head -1 selig.dat; tac points; } | "$points2step" -o turned.step
  cad2tri turned.step -o turned.tri.h5
  fits turned.tri.h5 points
  assert_equal "$(names | jq -c sort)" '["lower","trailing_edge","upper"]'
}

@test "between its points the spline is the aerofoil: four times as near with every half of the spacing, at least" {
  for n in 20 40 80; do
    naca0012 closed $n selig | "$points2step" -o a.step
    cad2tri a.step -o a.tri.h5 --report $n.json
  done
  naca0012 closed 4000 selig | sed 1d >fine
  exact=$(awk '{ if (NR > 1) s += x * $2 - y * $1; x = $1; y = $2 } END { printf "%.17g", s / 2 }' fine)
  jq -n --argjson exact "$exact" 'def error: input.face.area - $exact | fabs;
    [error, error, error] | .[1] < .[0] / 4 and .[2] < .[1] / 4 and .[2] < 1e-5' 20.json 40.json 80.json >verdict
  assert_equal "$(cat verdict)" true
}

@test "a closed smooth loop is one periodic spline of fourth order, its seam as smooth as the rest" {
  for n in 16 32; do
    circle $n >points
    "$points2step" points -o a.step
    cad2tri a.step -o a.tri.h5 --report $n.json
    fits a.tri.h5 points
    jq -e '.face.curves == 1 and .face.corners == 0' $n.json
  done
  jq -n -e '[input, input] | map(.face.area - 3.141592653589793 | fabs) | .[1] < .[0] / 12 and .[1] < 2e-5' 16.json 32.json
}

@test "loops of straight and curved sides, holes either way round, a single corner, comments and commas" {
  { echo '# plate'; printf '0 0\n4, 0 # corner\n4;2\n0 2\n0 0\n\n'; circle 24 0.4 1 1; echo '# no end of a loop'; echo; echo
    awk 'BEGIN { for (k = 0; k <= 32; ++k) { t = 8 * atan2(1, 1) * k / 32
      printf "%.17g %.17g\n", 2.75 + 0.5 * cos(t), 1 + 0.3 * sin(t) * sin(t / 2)^1.5 } }'; } >loops
  "$points2step" loops --name 'wall,pipe,blade' -o a.step
  cad2tri a.step -o a.tri.h5 --report a.json
  sed 's/#.*//; s/[,;]/ /' loops >points
  fits a.tri.h5 points
  assert_equal "$(names)" '["wall","wall","wall","wall","pipe","blade"]'
  jq -e '.face | .loops == 3 and .curves == 6 and .corners == 5' a.json
  # One that is listed the other way round is the same hole.
  { sed -n '1,/^$/p' loops; circle 24 0.4 1 1 | tac; } | "$points2step" -o b.step
  cad2tri b.step -o b.tri.h5
  run -0 stagecheck b.tri.h5
  "$points2step" loops -o plain.step
  cad2tri plain.step -o plain.tri.h5
  fits plain.tri.h5 points
  assert_equal "$(names | jq -r '.[0]')" curve_0
}

@test "--corner-angle finds corners, a limit that is met is none, --straight makes them all" {
  circle 12 >points
  has_corners() { # '[CURVES,CORNERS]' OPTION...
    "$points2step" points "${@:2}" -o a.step
    cad2tri a.step -o a.tri.h5 --report a.json
    fits a.tri.h5 points
    assert_equal "$(jq -c '[.face.curves, .face.corners]' a.json)" "$1"
  }
  has_corners '[1,0]'
  has_corners '[12,12]' --corner-angle 29
  has_corners '[12,12]' --straight
  circle 3 >points
  has_corners '[3,3]'
  has_corners '[1,0]' --corner-angle 150
  printf '0 0\n1 0\n2 0.2\n2 1\n' >points # the bend at (1, 0) is a point of a parabola
  has_corners '[3,3]'
}

@test "smooth curves leave a corner at least half of the polygon's angle" {
  # At (15.5, 14.5) the polygon has 45 degrees, but turns by 72 degrees the other way at the point before: curves that are
  # smooth there would leave less than 2 degrees.
  printf '22.5 16\n20.5 16\n19 14\n17 13\n15.5 14.5\n15.5 14\n13.5 11\n11 12\n10 11.5\n6 0\n26.5 0\n' >points
  "$points2step" points --corner-angle 80 -o a.step
  cad2tri a.step -o a.tri.h5
  fits a.tri.h5 points
  fieldsolve a.tri.h5 | critpoints -o a.crit.json
  jq -e '[.corners[] | select(.position[0] < 16 and .position[0] > 15).angle_degrees] | length == 1 and .[0] > 22' \
    a.crit.json
}

@test "far fields take the shape out; the face is called fluid, and so is the region of the mesh" {
  naca0012 blunt 20 selig >a.dat
  for far in circle:5:1:78.54 box:5:4:100 cgrid:5:4:89.27; do
    IFS=: read -r kind radius edges area <<<"$far"
    "$points2step" a.dat --farfield $kind:$radius -o $kind.step
    cad2tri $kind.step -o $kind.tri.h5 --report $kind.json
    stagecheck $kind.tri.h5
    jq -e --argjson edges $edges --argjson area $area '.face | .loops == 2 and .curves == $edges + 3
      and (.area + 0.0822 - $area | fabs < 0.01)' $kind.json
    h5dump -A 0 -d /face/curve_names $kind.tri.h5 | grep -o 'farfield' | wc -l | grep -qx $edges
  done
  "$ROOT/pipelines/quadmesh" -q cgrid.step -o a.msh --size 2
  assert_equal "$(sed -n '/PhysicalNames/,/EndPhysicalNames/s/^[12] [0-9]* //p' a.msh | sort | tr -d '\n')" \
    '"farfield""fluid""lower""trailing_edge""upper"'
  # The half circle is about the trailing edge, the others about the middle of the chord.
  assert_equal "$(jq '.face.diameter * 1e6 | round' circle.json)" 10000000
  "$points2step" a.dat --farfield box:2 --face-name air -o air.step
  grep -q "ADVANCED_FACE('air'" air.step
  circle 12 | "$points2step" - --farfield box:2 | grep -q "EDGE_CURVE('body'"
  circle 12 | "$points2step" - --farfield box:2 --name tube | grep -q "EDGE_CURVE('tube'"
}

@test "--chord scales, --unit says what 1 is, -v tells what was found" {
  naca0012 blunt 20 selig >a.dat
  run -0 "$points2step" -v a.dat --chord 0.5 --unit in -o a.step
  assert_line --index 0 "points2step: an aerofoil from the trailing edge around the nose and back, 41 points"
  assert_line "points2step: selig: 41 points, chord 0.5 in, 1 loop, 3 edges, 2 of them splines"
  cad2tri a.step -o a.tri.h5 --report a.json
  jq -e '.face.length_unit == "inch" and (.face.diameter - 0.5 | fabs < 1e-4)' a.json
  for unit in m:metre mm:millimetre cm:centimetre um:micrometre ft:foot; do
    "$points2step" a.dat --unit ${unit%:*} | cad2tri -o a.tri.h5 --report a.json
    assert_equal "$(jq -r .face.length_unit a.json)" ${unit#*:}
  done
}

@test "names and titles in any script arrive" {
  { echo "Flügel 'A' \\ 翼"; naca0012 closed 20 selig | sed 1d; } >a.dat
  "$points2step" a.dat --name "Flügel" -o a.step
  run -1 grep -P '[^\x00-\x7F]' a.step
  cad2tri a.step -o a.tri.h5
  stageview a.tri.h5 -o a.svg
  grep -q 'Flügel_upper' a.svg
}

@test "what is wrong with the points ends with 3 and the line" {
  refused() { # MESSAGE OPTION... < points
    local message=$1
    shift
    cat >points
    run -3 --separate-stderr "$points2step" points "$@" -o a.step
    assert_equal "$output" ""
    assert_equal "$stderr" "points2step: points: $message"
  }
  refused 'there are no points' </dev/null
  printf '\n# nothing\n' | refused 'there are no points'
  printf 'title\n' | refused 'there are no points'
  printf '0 0\n1 0\n' | refused 'line 1: a loop needs three different points, this one has 2'
  printf '0 0\n1 0\n0 0\n' | refused 'line 1: a loop needs three different points, this one has 2'
  printf '0 0\n1 0\n1 nan\n' | refused "line 3: '1 nan' is not finite"
  printf '0 0\n1 inf\n1 1\n' | refused "line 2: '1 inf' is not finite"
  printf '0 0\n1 0\n1 1 3\n' | refused "line 3: expected x and y, found '1 1 3'"
  printf '0 0\n1 0\n1 one\n' | refused "line 3: expected x and y, found '1 one'"
  printf '0 0\n1 0\n1 0\n0 0\n' | refused 'line 1: a loop needs three different points, this one has 2'
  printf '0 0 0\n1 0 0\n1 1 3\n' | refused "line 3: expected x and y, found '1 1 3': its third number is not 0"
  printf '0 0\n2 0\n1 0\n1 1\n' | refused 'line 2: the loop turns back on itself'
  printf '0 0\n1 0\n2 0\n' | refused 'line 3: the loop turns back on itself'
  printf '0 0\n2 0\n0 2\n2 2\n' | refused 'line 4: the loop crosses or touches itself: the segment from here meets the segment from line 2'
  printf '0 0\n4 0\n2 2\n4 4\n0 4\n2 2\n' |
    refused 'line 5: the loop crosses or touches itself: the segment from here meets the segment from line 2'
  printf '0 0\n4 0\n4 4\n0 4\n\n3 1\n5 1\n5 2\n' | refused 'line 6: two loops cross or touch: the segment from here meets the segment from line 2'
  printf '0 0\n4 0\n4 4\n0 4\n\n5 1\n6 1\n6 2\n' | refused 'line 6: this loop is not inside the largest one'
  { printf '0 0\n9 0\n9 9\n0 9\n\n'; circle 8 3 4 4; echo; circle 8 1 4 4; } |
    refused 'line 15: this loop lies inside the hole that begins in line 6'
  printf 'title\n3. 3.\n0 0\n1 1\n2 0\n0 0\n1 -1\n' | refused 'line 2: expected 3 + 3 points, found 5' --format lednicer
  printf 'title\n0 0\n1 1\n2 0\n' | refused 'line 2: expected the numbers of points of the upper and lower side' --format lednicer
  printf 'title\n1 0\n0.5 0.1\n0 0\n' | refused 'line 2: the nose is the first or the last point: one side has no points' \
    --format selig
  run -3 "$points2step" nowhere.txt
  assert_output "points2step: nowhere.txt: cannot be read: No such file or directory"
  assert_nothing_left points
}

@test "mistakes on the command line are exit 2 with a hint" {
  circle 8 >points
  for arguments in "--frob" "points points" "points -o" "points --format xml" "points --unit mile" "points --chord 0" \
    "points --chord x" "points --corner-angle 181" "points --farfield circle" "points --farfield ball:3" \
    "points --farfield circle:1" "points --farfield box:nan" "points --name a,b" "points --points-format xml" \
    "points --points-tolerance -1" "points --simplify-outline x"; do
    # shellcheck disable=SC2086
    run -2 --separate-stderr "$points2step" $arguments
    assert_regex "${stderr_lines[0]}" '^points2step: '
    assert_equal "${stderr_lines[1]}" "try 'points2step --help'"
    assert_equal "$output" ""
  done
}

@test "a CAD file is no file of points, and a far field needs a radius: both are said" {
  for file in square.step labels.iges; do
    run -3 --separate-stderr "$points2step" "$ROOT/tests/data/$file" --farfield circle:20
    assert_regex "$stderr" "$file: a CAD file: --farfield and the other options of points do not apply: draw"
  done
  circle 8 >points
  run -2 --separate-stderr "$points2step" points --farfield cgrid
  assert_regex "$stderr" "'cgrid' has no radius: .* cgrid:20"
}

@test "output is whole or not at all, and the same every time" {
  circle 8 >points
  "$points2step" points -o a.step
  "$points2step" <points >b.step
  "$points2step" - -o - <points >c.step
  cmp a.step b.step
  cmp a.step c.step
  run -4 "$points2step" points -o nowhere/a.step
  assert_output "points2step: nowhere/a.step: cannot be written: there is no folder nowhere"
  if [ -c /dev/full ]; then
    run -4 "$points2step" points -o /dev/full
    run -4 bash -c '"$1" -q points >/dev/full' - "$points2step"
    assert_output "points2step: standard output: cannot be written: No space left on device"
  fi
  mkfifo pipe
  "$points2step" points -o pipe &
  timeout 60 cat pipe >d.step
  wait $!
  assert [ -p pipe ]
  cmp a.step d.step
  rm pipe d.step
  cp a.step old.step
  run -3 "$points2step" /dev/null -o old.step
  cmp a.step old.step
  assert_nothing_left a.step b.step c.step old.step points
}

@test "the examples of --help run" {
  circle 8 >points.txt
  naca0012 closed 20 selig >aerofoil.dat
  PATH=$ROOT/pipelines:$PATH
  "$points2step" --help | sed '1,/^EXAMPLES$/d' >examples
  [ "$(wc -l <examples)" -ge 3 ]
  while read -r example; do
    run -0 bash -c "$example" </dev/null
  done <examples
  run -0 "$points2step" --version
  assert_output --regexp '^points2step \(Quadrille\) [0-9]'
}

@test "thousands of points cost no more than few, and the distance from their spline is counted" {
  circle 3000 >points
  "$points2step" points -o a.step
  "$ROOT/pipelines/quadmesh" -q a.step -o a.msh --report a.json --workdir stages
  jq -e '.boundary | .mesh_to_cad <= .tolerance and .cad_to_mesh <= .tolerance' a.json
  for file in a.tri.h5 a.field.h5 a.blocks.h5 a.quad.h5; do stagecheck stages/$file; done
  moved=$(h5dump -A 0 -m %.17g -d face/fit_distance stages/a.quad.h5 | sed -n 's/.*(0): //p')
  jq -e --argjson moved "$moved" '$moved > 0 and .boundary.mesh_to_cad >= $moved and .boundary.cad_to_mesh >= $moved' a.json
  # A tolerance that the fit alone misses is a warning that says what to lower.
  "$ROOT/pipelines/quadmesh" a.step -o a.msh --fit-tolerance 1e-6 --geometry-tol 1e-8 >words 2>&1
  grep -q 'W-QUA-003.*lower --fit-tolerance of cad2tri' words
}

# says FILE OPTION... : the sentences of points2step, which makes FILE.step.
says() {
  run -0 --separate-stderr "$points2step" "$@" -o "$1.step"
  output=$stderr
  mapfile -t lines <<<"$stderr"
}

# edges FILE: names of the edges of a STEP file, and how many have each.
edges() { sed -n "s/.*EDGE_CURVE('\([^']*\)'.*/\1/p" "$1" | sort | uniq -c | awk '{ printf "%s:%d ", $2, $1 }'; }

@test "no heading makes points an aerofoil, and none is needed" {
  local heading
  naca0012 closed 20 selig >wing
  for heading in '' 'barn' 'x,y' '"X [m]"; "Y [m]"'; do
    { [ -z "$heading" ] || echo "$heading"; printf '0,0\n6,0\n6,4\n3,5.5\n0,4\n'; } >barn.dat
    says barn.dat
    assert_line --index 0 'points2step: 1 closed loop through 5 points'
    [ -z "$heading" ] || assert_line "points2step: line 1 is a heading: '$heading'"
    assert_equal "$(grep -c "LINE(" barn.dat.step)" 5
    { [ -z "$heading" ] || echo "$heading"; sed 1d wing; } >wing.dat
    says wing.dat
    assert_line --index 0 'points2step: an aerofoil from the trailing edge around the nose and back, 40 points'
    assert_equal "$(edges wing.dat.step)" 'lower:1 upper:1 '
  done
  says wing.dat --points-format points --name shell
  assert_line --index 0 'points2step: 1 closed loop through 40 points'
  assert_regex "$(edges wing.dat.step)" '^shell:[0-9] $'
  says wing.dat -q
  assert_output ''
}

@test "columns of zeros, rows of 999, repeated points, a start at the nose, sides that cross: each with a sentence" {
  naca0012 closed 20 selig | sed 1d >wing
  "$points2step" -q wing -o wing.step
  same() { # FILE SENTENCE
    says "$1"
    assert_line "points2step: $2"
    diff <(sed 1,5d wing.step) <(sed 1,5d "$1.step") || fail "$1 is another shape"
  }
  sed 's/$/ 0.0/' wing >columns.dat
  same columns.dat 'the third column, zeros, is left out'
  sed '7p; 9p' wing >twice.dat
  same twice.dat '2 repeated points are left out, line 8 the first'
  { sed -n '21,41p' wing; sed -n '2,21p' wing; } >nose.dat
  same nose.dat 'the points from line 1 on start at the nose: they are read from the trailing edge on'
  { echo two; echo '-3 6 -3 3'; cat wing; echo '999.0 999.0'; awk '{ print 1.05 + $1 / 4, $2 / 4 - 0.1 }' wing; } >elements.dat
  says elements.dat --farfield box:4 --wake auto
  assert_line --index 0 'points2step: 2 aerofoils, each from the trailing edge around the nose and back, 80 points'
  assert_line 'points2step: line 2 holds four numbers, the region of a grid: it is left out'
  assert_line 'points2step: line 44, 999 in both columns, separates loops'
  # Coordinates with four decimals, whose sides change places at the trailing edge.
  awk 'NR == 1 { $2 = -0.0002 } NR == 41 { $2 = 0.0002 } { printf "%.4f %.4f\n", $1, $2 }' wing >crossing.dat
  says crossing.dat
  assert_line 'points2step: the sides cross by 0.00039 at the trailing edge, by rounding: both end at their middle'
  assert_equal "$(edges crossing.dat.step)" 'lower:1 upper:1 '
  # By more than that it is no rounding.
  awk 'NR == 1 { $2 = -0.02 } NR == 41 { $2 = 0.02 } { print }' wing >crossing.dat
  run -3 "$points2step" crossing.dat -o crossing.step
  assert_output --partial 'the loop crosses or touches itself'
}

@test "sharp noses are corners, and straight sides beside them stay straight" {
  # A wedge of 16 degrees with a circular back, and a hexagonal section whose corners turn by 9 degrees.
  awk 'BEGIN { pi = atan2(0, -1); r = 2; a = pi / 12
    for (k = 0; k <= 30; ++k) { t = a * (1 - k / 15); print (1 + sin(t) / sin(a)) / 2, r * (cos(t) - cos(a)) * 0.966 }
    for (k = 1; k <= 25; ++k) print k / 25, 0 }' >bow.dat
  awk 'function y(x) { return x < 0.3 ? x / 0.3 * 0.047 : x > 0.7 ? (1 - x) / 0.3 * 0.047 : 0.047 }
    BEGIN { for (k = 0; k <= 40; ++k) { x = 1 - k / 40; printf "%.6f %.6f\n", x, y(x) }
      for (k = 1; k <= 40; ++k) printf "%.6f %.6f\n", k / 40, -y(k / 40) }' >hexagon.dat
  local shape name
  for shape in 'bow lower:1 upper:1 ' 'hexagon lower:3 upper:3 '; do
    name=${shape%% *}
    "$ROOT/pipelines/quadmesh" $name.dat --farfield cgrid:8 --wall upper,lower:first=2e-3,growth=1.2,layers=10 \
      -o a.msh --report a.json --workdir . 2>words
    grep -q 'points2step: an aerofoil' words
    assert_equal "$(edges $name.outline.step)" "farfield:4 ${shape#* }"
    jq -e '.valid and .least_scaled_jacobian > 0.7' a.json >verdict || fail "$(jq -c '[.blocks, .least_scaled_jacobian]' a.json)"
  done
  # All poles of the flat side are on its line.
  assert [ "$(grep -c "CARTESIAN_POINT('',([0-9.]*,0\.0,0.))" bow.outline.step)" -ge 26 ]
}

@test "a noisy coast with quays is smoothed or simplified within the tolerance; quays stay straight" {
  # A basin with quays at the bottom and the sides, a jetty that is thinner than the tolerance, a coast with noise of 0.02.
  awk 'function noise() { seed = (seed * 1103515245 + 12345) % 2147483648; return (seed / 1073741824 - 1) * 0.02 }
    BEGIN { seed = 7; print "0 0\n2.5 0\n2.5 1\n2.53 1\n2.53 0\n5 0\n5 2\n4 2"
      for (k = 0; k <= 60; ++k) { t = k / 60; printf "%.4f %.4f\n", 4 - 3 * t + noise(), 2 + 3 * t * (1 - t) + 0.3 * t + noise() }
      print "0 2.3" }' >coast.xy
  local option
  for option in --points-tolerance --simplify-outline; do
    "$ROOT/pipelines/quadmesh" coast.xy $option 0.08 --points-corner-angle 50 --points-unit mm --face-name water -o a.msh \
      --report a.json --workdir . 2>words
    jq -e '.valid and .certificate.method != "midpoint" and .least_scaled_jacobian > 0.2' a.json
    grep -q "ADVANCED_FACE('water'" coast.outline.step
    grep -q 'SI_UNIT(.MILLI.,.METRE.)' coast.outline.step
    assert_equal "$(grep -c "= LINE(" coast.outline.step)" 9
  done
  grep -q ' points are left out, which are up to 0.0[0-9]* beside the simplified outline' words
  run -0 "$points2step" coast.xy --simplify-outline 0.08 --straight -o straight.step
  assert_output --regexp '[4-6][0-9] of 70 points are left out'
  assert_equal "$(grep -c B_SPLINE straight.step)" 0
}

@test "sixty thousand points take seconds, and a budget of quadmesh stops them" {
  circle 60000 >many.xy
  run -0 bash -c 'ulimit -t 20; "$1" many.xy -o many.step' - "$points2step"
  run -1 --separate-stderr "$ROOT/pipelines/quadmesh" many.xy -o many.msh --max-seconds 0.3 --report many.json
  assert_regex "$stderr" '^quadmesh: points2step was stopped after 0\.[0-9]* s .*of all stages: --max-seconds is 0.3'
  jq -e '.exit_code == 1 and (.error | startswith("points2step was stopped"))' many.json
}

@test "the history of a mesh from points names points2step with its options, and repeats the mesh" {
  circle 40 >ring.dat
  "$ROOT/pipelines/quadmesh" -q ring.dat --farfield circle:5 --workdir stages -o ring.msh
  mkdir again && cp ring.dat again && cd again
  stagecheck --history ../stages/ring.crit.json ../stages/ring.quad.h5 >commands
  run -0 grep -c '^points2step --farfield=circle:5 ring.dat -o ring.step$' commands
  grep -v '^#' commands >run
  PATH=$ROOT/pipelines:$PATH run -0 sh -e run
  cmp ring.quad.h5 ../stages/ring.quad.h5
}
