# Edges of the boundary that are far shorter than elements: strips of blocks that start there become wider.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh

# A body of chord 100 with a tail WIDTH wide, in a circle or square of some 16 chords, as wind tunnels are drawn.
draw_tail() {
  PYTHONPATH="$DATA" python3 - "$@" <<'END' >"$1.step"
import sys
from step_text import rectangle, step_text


def arc(a, b, rise):
    """From a to b, clockwise."""
    half = abs(b - a) / 2
    radius = (half**2 + rise**2) / (2 * rise)
    return ("arc", (a + b) / 2 - (b - a) / abs(b - a) * 1j * (radius - rise), radius, a, b, -1)


name, width, outline = sys.argv[1], float(sys.argv[2]), sys.argv[3]
nose, top, bottom = 0j, complex(100, width / 2), complex(100, -width / 2)
body = [arc(nose, top, 9), ("line", top, bottom), arc(bottom, nose, 3)]
around = [("circle", 50 + 0j, 800.0, 1)] if outline == "circle" else rectangle(-700 - 800j, 900 + 800j)
print(step_text(name, [around, body]))
END
}

# meshed NAME RATIO SCALED_JACOBIAN: by separatrices, within these limits.
meshed() {
  run -0 --separate-stderr "$quadmesh" "$1.step" -o "$1.msh" --report "$1.json"
  run -0 jq -c '[.certificate.method, .valid]' "$1.json"
  assert_output '["traced",true]'
  jq -e ".greatest_edge_ratio.value <= $2" "$1.json"
  jq -e ".least_scaled_jacobian >= $3" "$1.json"
}

@test "a tail two millionths of the diameter wide leaves no strip as thin behind it" {
  draw_tail circle 0.0035 circle
  meshed circle 100 0.3
  draw_tail square 0.004 square
  meshed square 100 0.3
}
