# C-, O- and H-grids around aerofoils, in one command from their coordinates, and wakes.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh

# naca0012 [blunt]: coordinates in Selig's format.
naca0012() {
  awk -v last="$([ -n "${1-}" ] && echo 0.1015 || echo 0.1036)" -v n=40 '
    function line(k, side, x) {
      x = (1 + cos(atan2(0, -1) * k / n)) / 2
      printf "%.12f %.12f\n", x, side * 0.6 * (0.2969 * sqrt(x) - 0.126 * x - 0.3516 * x^2 + 0.2843 * x^3 - last * x^4)
    }
    BEGIN {
      print "NACA 0012"
      for (k = 0; k <= n; ++k) line(k, 1)
      for (k = n - 1; k >= 0; --k) line(k, -1)
    }'
}

# grid NAME 'FORMULA' OPTION...: meshes NAME.dat or NAME.xy; the formula of jq must hold for the report of the run.
grid() {
  "$quadmesh" -q "$1".[dx]* "${@:3}" --workdir stages -o a.msh --report a.json
  jq -e "$2" a.json >verdict || fail "$(jq -c '[.blocks, .irregular_nodes, .least_scaled_jacobian, .valid]' a.json)"
}

setup() {
  common_setup
  naca0012 >sharp.dat
  naca0012 blunt >blunt.dat
}

@test "a C-shaped far field has a C-grid without irregular nodes, around sharp and blunt aerofoils" {
  grid sharp '.valid and .blocks == 3 and .irregular_nodes == 0 and .least_scaled_jacobian > 0.5' --farfield cgrid:20
  assert_equal "$(jq -c '.corners | map(.valence)' stages/sharp.crit.json)" '[1,1,4]'
  grid blunt '.valid and .blocks == 4 and .irregular_nodes == 0 and .least_scaled_jacobian > 0.5' --farfield cgrid:20
  assert_equal "$(jq -c '.corners | map(.valence)' stages/blunt.crit.json)" '[1,1,3,3]'
}

@test "a C-grid does not depend on the incidence, nor on digits of a blunt trailing edge" {
  local angle
  for angle in -0.1 0.15; do
    awk -v a=$angle 'NR == 1 { print; next } { printf "%.4f %.4f\n", cos(a) * $1 - sin(a) * $2, sin(a) * $1 + cos(a) * $2 }' \
      blunt.dat >turned.dat
    grid turned '.valid and .blocks == 4 and .irregular_nodes == 0' --farfield cgrid:20
    assert_equal "$(jq -c '.corners | map(.valence)' stages/turned.crit.json)" '[1,1,3,3]'
  done
}

@test "lines around the nose are nearly normal to the layers" {
  for far in cgrid:20,0.68 circle:20,0.75 box:20,0.55; do
    grid sharp ".valid and .least_scaled_jacobian > ${far#*,}" --farfield "${far%,*}" \
      --wall upper,lower:first=1e-4,growth=1.2,layers=20
  done
}

# naca4412 DIGITS: coordinates in Selig's format, with so many decimals.
naca4412() {
  awk -v n=60 -v digits="$1" '
    function line(k, side, x, y, c, a) {
      x = (1 + cos(atan2(0, -1) * k / n)) / 2
      y = side * 0.6 * (0.2969 * sqrt(x) - 0.126 * x - 0.3516 * x^2 + 0.2843 * x^3 - 0.1036 * x^4)
      c = x < 0.4 ? 0.25 * (0.8 * x - x^2) : (0.2 + 0.8 * x - x^2) / 9
      a = atan2(x < 0.4 ? 0.25 * (0.8 - 2 * x) : (0.8 - 2 * x) / 9, 1)
      printf "%." digits "f %." digits "f\n", x - y * sin(a), c + y * cos(a)
    }
    BEGIN {
      print "NACA 4412"
      for (k = 0; k <= n; ++k) line(k, 1)
      for (k = n - 1; k >= 0; --k) line(k, -1)
    }'
}

@test "no element around a cambered aerofoil in a box is skew, whatever the last digits are" {
  for digits in 6 7; do
    naca4412 $digits >cambered.dat
    grid cambered '.valid and .least_scaled_jacobian > 0.65 and .greatest_edge_ratio.value < 16 and
      .resolution.ratio < 8' --farfield box:20
  done
}

@test "--nodes field and --topology none keep the nodes of the field in the same far field" {
  for rule in '--nodes field' '--topology none'; do
    # shellcheck disable=SC2086 # words
    "$quadmesh" -q sharp.dat --farfield cgrid:20 $rule --until critpoints --workdir stages
    assert_equal "$(jq '.critical_points | length > 0' stages/sharp.crit.json)" true
  done
}

@test "a circle has an O-grid, with a node in the wake of a sharp trailing edge" {
  grid sharp '.valid and .irregular_nodes == 1 and .blocks < 8 and .certificate.method == "traced"' --farfield circle:20
  jq -e '.critical_points[0] | .valence == 3 and .position[0] > 1' stages/sharp.crit.json
  grid blunt '.valid and .irregular_nodes == 0 and .blocks == 2' --farfield circle:20
}

@test "an O-grid in a rectangle has its node in the wake too, behind an outline of one curve" {
  "$quadmesh" -q "$DATA/naca0012.step" --topology o --workdir stages -o a.msh --report a.json
  jq -e '.valid and .irregular_nodes == 1' a.json
  jq -e '.critical_points[0] | .valence == 3 and .position[0] > 1.2' stages/naca0012.crit.json
}

@test "C- and O-grids in a box have no node at a nose that is smaller than the feature size" {
  grid sharp '.valid and .irregular_nodes == 0 and .blocks < 8 and .least_scaled_jacobian > 0.6' \
    --farfield box:5 --topology c
  assert_equal "$(jq '.boundary_nodes' stages/sharp.crit.json)" '[]'
  grid sharp '.valid and .irregular_nodes == 1 and .blocks < 12 and .least_scaled_jacobian > 0.54' \
    --farfield box:5 --topology o
  assert_equal "$(jq '.boundary_nodes' stages/sharp.crit.json)" '[]'
}

@test "a box has an H-grid with its nodes before the nose" {
  grid sharp '.valid and .irregular_nodes == 2 and .least_scaled_jacobian > 0.7' --farfield box:5
  assert_equal "$(jq '.boundary_nodes' stages/sharp.crit.json)" '[]'
}

# cambered CAMBER THICKNESS: a bent aerofoil, in chords.
cambered() {
  awk -v camber="$1" -v thick="$2" -v n=24 '
    function line(k, side, x, y) {
      x = (1 + cos(atan2(0, -1) * k / n)) / 2
      y = 5 * thick * (0.2969 * sqrt(x) - 0.126 * x - 0.3516 * x^2 + 0.2843 * x^3 - 0.1036 * x^4)
      printf "%.7f %.7f\n", x, 4 * camber * x * (1 - x) + side * y
    }
    BEGIN {
      for (k = 0; k <= n; ++k) line(k, 1)
      for (k = n - 1; k >= 0; --k) line(k, -1)
    }'
}

@test "where the H-grid of a box makes a poor mesh, another grid is taken, unless the user chose one" {
  cambered 0.1 0.06 >thin.dat
  grid thin '.valid and .remedy == "critpoints --topology o" and .least_scaled_jacobian > 0.45 and
    .resolution.ratio < 30 and (.trials[0].valid | not)' --farfield box:20
  grid thin '.remedy == null and .trials == []' --farfield box:20 --place keep
  grid thin '.remedy == null and (.trials | length) == 1' --farfield box:20 --topology h
  cambered 0.04 0.12 >thick.dat
  grid thick '.valid and (.remedy | startswith("critpoints --topology")) and .least_scaled_jacobian > 0.45 and
    .resolution.ratio < 30' --farfield box:20
}

@test "blocks and sizes follow a wake" {
  grid sharp '.valid and .blocks == 3 and .irregular_nodes == 0' --farfield cgrid:10 --wake auto \
    --size-near wake=0.1:1
  h5dump -A 0 -d /face/curve_names stages/sharp.quad.h5 | grep -q wake
}

@test "elements stay small along a wake by default" {
  local along
  for along in auto 0; do
    grid sharp .valid --farfield cgrid:10 --wake auto --per-curve $along --order 1 --format msh22
    # Half way downstream, at (6, 0): the longest edge with an end within a chord.
    awk '
      $1 == "$Nodes" { part = 1; next } $1 == "$Elements" { part = 2; next }
      part == 1 && NF == 4 { x[$1] = $2; y[$1] = $3 }
      part == 2 && $2 == 3 { n = split($0, v); for (k = 0; k < 4; ++k) { a = v[n - k]; b = v[n - (k + 1) % 4]
        if ((x[a] - 6)^2 + y[a]^2 < 1) { d = sqrt((x[a] - x[b])^2 + (y[a] - y[b])^2); if (d > most) most = d } } }
      END { print most + 0 }' a.msh >longest.$along
  done
  awk '{ v[NR] = $1 } END { exit !(v[1] > 0 && v[1] < 0.75 * v[2]) }' longest.auto longest.0 || fail "$(cat longest.*)"
}

@test "lines follow the wake of a round body, which begins anywhere on its closed curve" {
  local far_field
  awk 'BEGIN { for (k = 0; k < 60; ++k) { a = (k + 30) * atan2(0, -1) / 30; print cos(a), sin(a) } }' >round.xy
  for far_field in box:10=4 cgrid:10=2 circle:10=0; do
    grid round ".valid and .irregular_nodes == ${far_field#*=} and .blocks <= 14 and .least_scaled_jacobian > 0.69" \
      --farfield "${far_field%=*}" --wake auto --size-near wake=0.3:1
  done
}

@test "a given wake ends where it leaves the far field; lines bend where none would cross it" {
  awk 'BEGIN { for (k = 0; k < 60; ++k) { a = (k + 30) * atan2(0, -1) / 30; print cos(a), sin(a) } }' >round.xy
  printf '1 0\n2 0.3\n5 2\n20 8\n' >wake.xy
  "$ROOT/pipelines/points2step" round.xy --farfield circle:10 --wake wake.xy | cad2tri -q -o round.tri.h5
  h5dump -y -w 1 -d /face/joints/position round.tri.h5 | awk '
    /^ *-?[0-9.]+,?$/ { x[n++] = $1 }
    END { exit !(n > 1 && (d = x[0] * x[0] + x[1] * x[1]) > 399.99 && d < 400.01) }'
  grid round '.valid and .certificate.method == "traced" and .blocks <= 14 and .least_scaled_jacobian > 0.7' \
    --farfield box:10 --wake wake.xy
  printf '30 0\n40 0\n' >wake.xy
  run -3 "$ROOT/pipelines/points2step" round.xy --farfield circle:10 --wake wake.xy
  assert_output --partial 'wake.xy: line 1: the wake does not begin at the body, inside the far field'
}

@test "a given wake that falls short is continued, with a warning; one through the body is refused" {
  printf '1 0\n5 0\n' >wake.xy
  run -0 --separate-stderr "$quadmesh" sharp.dat --farfield cgrid:10 --wake wake.xy -o a.msh --report a.json
  assert_equal "${stderr_lines[0]}" "points2step: warning W-PTS-001: wake.xy: the wake ends at (5, 0), 6 before the far field: it is continued straight to (11, 0)"
  jq -e '.blocks == 3 and .irregular_nodes == 0 and .warnings[0].code == "W-PTS-001" and (.stages | has("points2step") | not)' \
    a.json
  # From inside the body, and with gaps of 1 percent at both ends.
  for points in '0.5 0\n5 0\n11 0' '1.01 0\n5 0\n10.99 0'; do
    printf '%b\n' "$points" >wake.xy
    grid sharp '.valid and .blocks == 3 and (.warnings | map(select(.tool == "points2step" or .tool == "cad2tri")) == [])' \
      --farfield cgrid:10 --wake wake.xy
  done
  printf '0.3 0.5\n0.4 -0.5\n11 0\n' >wake.xy
  run -3 "$quadmesh" sharp.dat --farfield cgrid:10 --wake wake.xy -o a.msh
  assert_output --partial 'quadmesh: wake.xy: the wake crosses the body from (0.3'
}

@test "behind a sharp trailing edge with a wake, quads without a field are found" {
  grid sharp '.valid and .certificate.method == "midpoint"' --farfield cgrid:10 --wake auto --layout midpoint
}

@test "points need no other command, and what is wrong with them is told" {
  grid sharp '.valid' --farfield circle:5 --size 1
  assert_file_exists stages/sharp.outline.step
  run -2 "$quadmesh" sharp.dat --farfield oval:5 -o a.msh
  assert_line --index 0 "quadmesh: --farfield: 'oval:5' is not circle:R, box:R or cgrid:R"
  assert_line --index 1 "try 'quadmesh --help'"
  printf 'points\n1 x\n' >bad.xy
  run -3 "$quadmesh" bad.xy -o a.msh
  assert_output --partial 'quadmesh: bad.xy: line 2: expected x and y'
  run -2 "$quadmesh" sharp.dat --farfield circle:5 --from separatrix --workdir stages -o a.msh
  assert_output --partial '--farfield makes a CAD file of points, which --from separatrix does not read'
  run -0 "$quadmesh" sharp.dat --farfield circle:5 --dry-run -o a.msh
  assert_line --index 0 'points2step sharp.dat -o ./sharp.outline.step --farfield circle:5'
}
