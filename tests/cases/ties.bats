# Corners of 45 + 90 k degrees: chamfers anywhere, the same layout for 44.98 and 45 degrees, symmetric parts symmetric.
load ../tools/common

points2step=$ROOT/pipelines/points2step
quadmesh=$ROOT/pipelines/quadmesh

# plate NAME W H LEG ANGLE [FILE]: a plate with its upper right corner cut off, the leg along x; then the loops in FILE.
plate() {
  {
    awk -v w="$2" -v h="$3" -v leg="$4" -v angle="$5" 'BEGIN {
      angle *= atan2(0, -1) / 180
      rise = leg * sin(angle) / cos(angle)
      printf "0 0\n%.12f 0\n%.12f %.12f\n%.12f %.12f\n0 %.12f\n", w, w, h - rise, w - leg, h, h
    }'
    if [ $# -gt 5 ]; then echo && cat "$6"; fi
  } | "$points2step" -o "$1.step"
}

# circle X Y R: 48 points
circle() {
  awk -v x="$1" -v y="$2" -v r="$3" \
    'BEGIN { for (k = 0; k < 48; ++k) { a = k * atan2(0, -1) / 24; print x + r * cos(a), y + r * sin(a) } }'
}

# mesh NAME: NAME.json is the report, NAME/ has the files of the stages
mesh() {
  mkdir "$1" && "$quadmesh" -q "$1.step" -o "$1.msh" --report "$1.json" --workdir "$1"
}

# graph NAME: what the layout is made of
graph() {
  jq -c '[[.corners[].valence], ([.critical_points[].valence] | sort)]' "$1/$1.crit.json"
  jq '.blocks' "$1.json"
}

@test "a chamfer far from a round hole is meshed, with one layout for 44.98, 45 and 45.02 degrees" {
  circle 3 3 1 > hole.txt
  for angle in 44.98 45 45.02; do
    plate a$angle 20 6 0.5 $angle hole.txt
    mesh a$angle
    assert_equal "$angle $(graph a$angle)" "$angle $(graph a44.98)"
  done
  jq -e '.valid and .blocks <= 12' a45.json
}

@test "chamfers of all sizes are meshed" {
  circle 3 3 1.2 > hole.txt
  for leg in 0.02 0.3 2 5.5; do
    plate b$leg 10 6 $leg 45 hole.txt
    mesh b$leg
    jq -e '.valid' b$leg.json
  done
}

@test "a square with four chamfers and a hole has the layout of its symmetry" {
  {
    printf '%s\n' '0.5 0' '5.5 0' '6 0.5' '6 5.5' '5.5 6' '0.5 6' '0 5.5' '0 0.5' ''
    circle 3 3 1
  } | "$points2step" -o square.step
  mesh square
  run -0 "$ROOT/tests/cases/symmetric_layout.py" --tolerance 1e-5 square/square.sep.json
  assert_line 'kept 8 of 8'
}

@test "an octagon and an L with a chamfer in its reflex corner are meshed" {
  awk 'BEGIN { for (k = 0; k < 8; ++k) { a = (k + 0.5) * atan2(0, -1) / 4; printf "%.12f %.12f\n", cos(a), sin(a) } }' |
    "$points2step" -o octagon.step
  printf '%s\n' '0 0' '8 0' '8 3' '5 3' '4 4' '4 8' '0 8' | "$points2step" -o l.step
  for shape in octagon l; do
    mesh $shape
    jq -e '.valid' $shape.json
  done
  jq -e '.blocks == 12' octagon.json
  jq -e '.blocks == 4' l.json
}

@test "unequal chamfers round a square hole" {
  printf '%s\n' '0 0.5' '0.5 0' '9 0' '10 1' '10 5' '8 7' '0.2 7' '0 6.8' '' '3 2' '5 2' '5 4' '3 4' |
    "$points2step" -o unequal.step
  mesh unequal
  jq -e '.valid and .blocks <= 14' unequal.json
}

@test "the choice and its reasons stand in the file of the nodes" {
  plate a 10 6 1 45
  mesh a
  run -0 jq -r '.changes[].reason' a/a.crit.json
  assert_line --partial 'valence 2, because'
  assert_line --partial 'valence 1, because'
}

@test "--ties field keeps the valences of the field" {
  circle 4 2.5 1.5 > hole.txt
  plate a 10 6 2 45 hole.txt
  mesh a
  run -0 critpoints -q --ties field a/a.field.h5 -o plain.crit.json
  jq -e '.form == "harmonic" and (any(.changes[]; .kind == "line") | not)' plain.crit.json
  jq -e '.form == "phase" and any(.changes[]; .kind == "line")' a/a.crit.json
}
