# Sharp corners: any angle above zero gets a block, with straight and bent sides.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh

# wedge NAME ANGLE BULGE_OUT BULGE_IN: sides of length 1 from (0, 0), ANGLE degrees apart there, and a straight base. A
# side bulges by this part of its length, outwards if positive.
# crescent NAME ANGLE: between two arcs, ANGLE degrees apart at both ends.
draw() {
  PYTHONPATH="$DATA" python3 - "$@" <<'END' >"$2.step"
import cmath, math, sys
from step_text import step_text


def side(a, b, bulge):
    """From a to b, bulging to the right."""
    if not bulge:
        return ("line", a, b)
    length = abs(b - a)
    rise = bulge * length
    radius = (length**2 / 4 + rise**2) / (2 * abs(rise))
    right = (b - a) / length * -1j
    return ("arc", (a + b) / 2 + right * (rise - math.copysign(radius, rise)), radius, a, b, 1 if rise > 0 else -1)


kind, name, angle = sys.argv[1], sys.argv[2], math.radians(float(sys.argv[3]))
if kind == "wedge":
    out, back = map(float, sys.argv[4:6])
    chords = angle - 2 * math.atan(2 * out) - 2 * math.atan(2 * back)
    a, b = cmath.exp(-0.5j * chords), cmath.exp(0.5j * chords)
    loop = [side(0j, a, out), ("line", a, b), side(b, 0j, back)]
else:
    half = 2 * math.atan(0.6) - angle
    loop = [side(0j, 1 + 0j, 0.3), side(1 + 0j, 0j, -math.tan(half / 2) / 2)]
print(step_text(name, [loop]))
END
}

# meshed ANGLE BLOCKS RATIO NAME: by separatrices, in so many blocks, with elements that are as good as a corner of ANGLE
# degrees permits and an edge ratio of at most RATIO; below 15 degrees with a warning.
meshed() {
  run -0 --separate-stderr "$quadmesh" "$4.step" -o "$4.msh" --report "$4.json"
  if (($1 < 15)); then
    assert_regex "$stderr" "^critpoints: warning W-NODE-003: .* below 15 degrees: that of $1 degrees at"
  else
    [[ ! $stderr =~ warning\ W-(NODE|SEP|CAD)- ]]
  fi
  run -0 jq -c '[.certificate.method, .blocks, .valid]' "$4.json"
  assert_output "[\"traced\",$2,true]"
  jq -e --argjson w "$1" '.least_scaled_jacobian > 0.95 * ($w * atan2(0; -1) / 180 | sin)' "$4.json"
  jq -e ".greatest_edge_ratio.value <= $3" "$4.json"
}

@test "wedges between straight sides, down to one degree" {
  while read -r angle ratio; do
    draw wedge straight "$angle" 0 0
    meshed "$angle" 3 "$ratio" straight
  done <<END
20 6
10 12
2 60
1 120
END
}

@test "wedges between sides that bulge, bend in or bend together" {
  draw wedge together 5 0.03 -0.03
  meshed 5 3 30 together
  draw wedge inwards 2 -0.02 -0.02
  meshed 2 3 60 inwards
  draw wedge outwards 10 0.02 0.02
  meshed 10 3 40 outwards
}

@test "a crescent with tips of 5 degrees gets a node in the middle of each, as mirror images" {
  draw crescent crescent 5
  meshed 5 4 40 crescent
  cad2tri crescent.step | fieldsolve -q | padapt -q | critpoints -q -o crescent.crit.json
  jq -e '[.critical_points[].position] | length == 2 and
    (.[0][0] + .[1][0] - 1 | fabs) < 1e-9 and (.[0][1] - .[1][1] | fabs) < 1e-9' crescent.crit.json
}
