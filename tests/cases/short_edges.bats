# Edges of the boundary that are far shorter than elements: strips of blocks that start there become wider.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh

# A body of chord 100 with a tail WIDTH wide, in a circle or square of some 16 chords, as wind tunnels are drawn.
draw_tail() {
  PYTHONPATH="$DATA" PYTHONDONTWRITEBYTECODE=1 python3 - "$@" <<'END' >"$1.step"
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

# A plate with square holes whose rounded corners are hair-fine zigzags.
draw_zigzag() {
  PYTHONPATH="$DATA" PYTHONDONTWRITEBYTECODE=1 python3 - "$@" <<'END' >"$1.step"
import sys
from step_text import polygon, step_text

e = 0.0025
outline = [0, 80, 80 - e * 1j, 80.7 - (0.7 + e) * 1j, 80.7 + e - 0.7j, 120 - 0.7j, 120 + 60j, 60 + 60j,
           60 + (60 + e) * 1j, 59.3 + 60.7j, 59.3 - e + 60.7j, 60.7j]
places = [10 + 8j, 29 + 8.5j, 48 + 7j, 67 + 9j, 86 + 8j, 10 + 27j, 29 + 27.5j, 48 + 26j, 67 + 28j, 86 + 27j]
holes = [[z, z + 14j, z + 14 + 14j, z + 14] for z in places]
print(step_text(sys.argv[1], [polygon(outline)] + [polygon(hole) for hole in holes]))
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

@test "zigzags of the boundary leave no strips as thin across the face" {
  draw_zigzag zigzag
  # An edge 0.0025 long beside one of 0.99, which is one element: 1 : 396.
  meshed zigzag 400 0.3
}
