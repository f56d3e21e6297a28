# tests/benchmarks/peers runs, and its judge, which shares no code with the tools, finds what they report.
load common

setup() {
  common_setup
  need python3-gmsh python3-numpy
  mkdir faces
  cp "$DATA/half_disc.step" faces/
}

peers() {
  "$ROOT/tests/benchmarks/peers" --bin "$BIN" -o . --faces faces --repeats 1 --no-gmsh "$@"
}

# row MESHER [KEY]
row() {
  jq --arg mesher "$1" "[.rows[] | select(.mesher == \$mesher)][0]${2:+.$2}" peers.json
}

@test "the judge of the comparison finds what quadmesh reports, for us and for a peer with the same mesh" {
  "$ROOT/pipelines/quadmesh" -q --order 3 faces/half_disc.step -o half_disc.msh --report quadmesh.json
  printf '#!/bin/sh\ncp "%s" "$2"\n' "$PWD/half_disc.msh" >copy
  chmod +x copy
  run -0 peers --peer "copy=$PWD/copy {step} {msh}"
  for mesher in quadrille copy; do
    jq -e --arg mesher "$mesher" --slurpfile made quadmesh.json '$made[0] as $made
      | .rows[] | select(.mesher == $mesher) | .verdict == "accepted" and .cpu_seconds >= 0 and .quads == $made.quads
        and .irregular_nodes == $made.irregular_nodes and (.scaled_jacobian - $made.least_scaled_jacobian | fabs) < 2e-3
        and (.edge_ratio / $made.greatest_edge_ratio.value - 1 | fabs) < 1e-3
        and (.resolution_ratio / $made.resolution.ratio - 1 | fabs) < 1e-3
        and .least_size < .median_size and .median_size < .greatest_size' peers.json
  done
  assert_equal "$(row copy quads)" "$(row quadrille quads)"
  xmllint --noout peers.svg
  assert_file_contains "$PWD/peers.md" '| half_disc | copy |'
}

@test "the number of quads of a peer is brought to ours by its size" {
  cat >coarse <<'END'
#!/bin/sh
exec "$1" -q --order "$5" --size "$(awk "BEGIN { print 2 * $4 }")" "$2" -o "$3"
END
  chmod +x coarse
  run -0 peers --peer "coarse=$PWD/coarse $ROOT/pipelines/quadmesh {step} {msh} {size} {order}"
  jq -e '.rows | .[1].verdict == "accepted" and (.[1].quads / .[0].quads | . > 0.9 and . < 1.1)
    and (.[1].size / .[0].size | . > 0.4 and . < 0.6)' peers.json
}

@test "meshes that miss the face, folded or torn ones and triangles are not accepted; peers that fail are rows" {
  "$ROOT/pipelines/quadmesh" -q --order 3 "$DATA/stadium.step" -o other.msh
  "$ROOT/pipelines/quadmesh" -q --order 3 faces/half_disc.step --format msh22 -o good.msh
  # A vertex inside, moved by a third of the extent: elements fold.
  awk '/^\$Nodes/ { inside = 1 } /^\$EndNodes/ { inside = 0 }
    inside && NF == 4 && !moved && $2 * $2 < 0.05 && $3 > 0.3 && $3 < 0.6 { $2 += 0.6; moved = 1 } { print }' \
    good.msh >folded.msh
  # An element inside with a node of its own in place of a vertex.
  "$PYTHON" - <<'END'
lines = open("good.msh").read().split("\n")
first = lines.index("$Nodes")
count, nodes = int(lines[first + 1]), lines[first + 2 : lines.index("$EndNodes")]
place = {line.split()[0]: line.split()[1:] for line in nodes}
quads = []  # number of the line, words, the node that comes first
for k in range(lines.index("$Elements") + 2, lines.index("$EndElements")):
    words = lines[k].split()
    first_node = 3 + int(words[2])
    if words[1] == "36":
        quads.append((k, words, first_node))
uses = lambda node: sum(node in words[first : first + 4] for _, words, first in quads)
elem, words, vertex = max(quads, key=lambda quad: uses(quad[1][quad[2]]))
added = " ".join([str(count + 1), *place[words[vertex]]])
words[vertex] = str(count + 1)
lines[elem] = " ".join(words)
lines[first + 1 : first + 2] = [str(count + 1), added]
open("torn.msh", "w").write("\n".join(lines))
END
  printf '#!/bin/sh\ncp "$1" "$2"\n' >copy
  echo 'no mesh at all' >garbage.msh
  "$ROOT/pipelines/quadmesh" -q --order 4 faces/half_disc.step -o finer.msh
  printf '#!/bin/sh\nkill -9 $$\n' >crash
  printf '#!/bin/sh\necho "Error: no such thing" >&2\nexit 1\n' >refuse
  cat >triangles <<END
#!$PYTHON
import gmsh, sys
gmsh.initialize()
gmsh.option.setNumber("General.Terminal", 0)
gmsh.model.occ.importShapes(sys.argv[1])
gmsh.model.occ.synchronize()
gmsh.model.mesh.generate(2)
gmsh.write(sys.argv[2])
END
  chmod +x copy crash refuse triangles
  run -0 peers --peer "other=$PWD/copy $PWD/other.msh {msh} {step}" \
    --peer "folded=$PWD/copy $PWD/folded.msh {msh} {step}" \
    --peer "torn=$PWD/copy $PWD/torn.msh {msh} {step}" --peer "good=$PWD/copy $PWD/good.msh {msh} {step}" \
    --peer "garbage=$PWD/copy $PWD/garbage.msh {msh} {step}" --peer "finer=$PWD/copy $PWD/finer.msh {msh} {step}" \
    --peer "crash=$PWD/crash {step} {msh}" --peer "refuse=$PWD/refuse {step} {msh}" \
    --peer "triangles=$PWD/triangles {step} {msh}" --peer "absent=no-such-mesher {step} {msh}"
  assert_output --partial 'not installed: absent'
  assert_equal "$(row other verdict)" '"not accepted"'
  assert_regex "$(row other reason)" 'diameters off the curves'
  assert_equal "$(row folded verdict)" '"not accepted"'
  assert_regex "$(row folded reason)" 'not proved valid'
  assert_equal "$(row torn verdict)" '"not accepted"'
  assert_regex "$(row torn reason)" 'closed loops|Euler'
  assert_equal "$(row good verdict)" '"accepted"'
  assert_equal "$(row finer verdict)" '"accepted"'
  assert_equal "$(row garbage verdict)" '"failed"'
  assert_regex "$(row garbage reason)" 'no MSH file'
  assert_equal "$(row crash reason)" '"ended by signal 9"'
  assert_equal "$(row refuse reason)" '"Error: no such thing"'
  assert_equal "$(row triangles verdict)" '"failed"'
  assert_regex "$(row triangles reason)" 'no quads among'
  assert_equal "$(jq '.rows | length' peers.json)" 10
}

# The samples at both ends of a closed curve are as near to points beside its seam: which comes first is chance.
@test "points beside the seam of a closed curve have the distances that they have from it" {
  "$PYTHON" - "$ROOT/tests/benchmarks" "$DATA"/{annulus,cylinder_channel,disc,ellipse,plate_hole}.step <<'END'
import sys
sys.path.insert(0, sys.argv[1])
import cad_outline, numpy, quad_judge
quad_judge.initialise()
for path in sys.argv[2:]:
    outline = cad_outline.Outline(path)
    closed = [edge for edge in outline.edges if edge.is_closed]
    assert closed, path
    for edge in closed:
        step = (edge.high - edge.low) / 512 * numpy.linspace(0.1, 0.9, 9)
        at = numpy.concatenate([edge.low + step, edge.high - step])
        slopes = edge.slopes(at)
        normals = numpy.stack([slopes[:, 1], -slopes[:, 0]], axis=1) / numpy.linalg.norm(slopes, axis=1)[:, None]
        for height in (0, 1e-5, -1e-5):
            found = outline.distances(edge.values(at) + height * outline.diameter * normals) / outline.diameter
            assert numpy.abs(found - abs(height)).max() < 1e-9, (path, height, found)
END
}

# The error of waves is 1.6e-4 k^4 sqrt(E) within a few per cent, E the numerator of R (lib/method.md §10); here the area
# is pi / 2 and k = 8 pi.
@test "Gmsh and the Poisson problem take part where they are installed; errors are compared with the best peer's" {
  need gmsh python3-gmsh python3-dolfinx
  cp "$DATA/tilted_half_disc.step" faces/
  run -0 "$ROOT/tests/benchmarks/peers" --bin "$BIN" -o . --faces faces --repeats 1
  jq -e '3.14159265 as $pi | .rows | length == 10 and all(.verdict == "accepted" or .reason)
    and ([.[] | select(.verdict == "accepted")] | length >= 6 and all(.smooth_p3 > 1e-9 and .smooth_p3 < 1e-4
      and .smooth_p5 < .smooth_p3 / 100 and .waves_p5 < .waves_p3 / 5 and .unknowns_p5 > 2 * .unknowns_p3
      and ((.resolution_ratio * $pi * pow($pi / 2 / .quads; 4) | sqrt) as $root_of_e
        | .waves_p3 / (1.6e-4 * pow(8 * $pi; 4) * $root_of_e) - 1 | fabs) < 0.2))
    and (map(select(.mesher != "quadrille" and .smooth_p3)) | length >= 4 and all(has("waves_p5_ratio")))
    and (group_by(.shape) | all(([.[] | select(.mesher != "quadrille") | .smooth_p3_ratio // empty] | min) == 1))
    and all(.[] | select(.mesher == "quadrille"); .smooth_p3_ratio < 2)' peers.json
  assert_file_contains "$PWD/peers.md" '| geometric mean |'
}

@test "a command of a peer without its files is refused" {
  run -2 peers --peer 'half=mesher {step}'
  assert_output --partial 'the command of half lacks {msh}'
}

@test "real_faces counts the faces of a folder whose meshes its judge accepts, and prints the others with their faults" {
  head -c 2000 faces/half_disc.step >faces/torn.step
  run -1 "$ROOT/tests/benchmarks/real_faces" --bin "$BIN" -o . --faces faces
  assert_output --partial "'face': 'torn', 'accepted': False, 'fault': 'cad2tri: torn.step"
  "$ROOT/pipelines/quadmesh" -q faces/half_disc.step -o half_disc.msh --report made.json
  jq -e --slurpfile made made.json '$made[0] as $made | .summary.faces == 2 and .summary.accepted == 1
    and (.rows[0] | .face == "half_disc" and .accepted and .quads == $made.quads
      and (.R / $made.resolution.ratio - 1 | fabs) < 1e-3
      and (.edge_ratio / $made.greatest_edge_ratio.value - 1 | fabs) < 1e-3
      and (.scaled_jacobian - $made.least_scaled_jacobian | fabs) < 2e-3 and .cpu > 0)' real_faces.json
  run -0 "$ROOT/tests/benchmarks/real_faces" --bin "$BIN" -o none --faces faces --only half_disc
  assert_not_exist none
}
