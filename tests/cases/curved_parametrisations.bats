# One face in several parametrisations of its surface and of its edges, with seams and poles elsewhere.
load ../tools/common

# blocks_agree TOLERANCE CLOSEDNESS OPTION...: each face of parametrised_faces.py, with charts of this closedness, has the
# same blocks in all of its files, with corners in the same places in space, and as many quads.
blocks_agree() {
  local file face
  local -A first
  /usr/bin/python3 "$ROOT/tests/cases/parametrised_faces.py" .
  for file in *.step; do
    file=${file%.step} face=${file%%.*}
    cad2chart -q "$file.step" --closedness "$2" -o "$file.chart.h5"
    quadmesh -q "$file.chart.h5" "${@:3}" --workdir . -o a.msh
    [ -v "first[$face]" ] || first[$face]=$file
    run -0 "$ROOT/tests/cases/same_surface_blocks.py" "${first[$face]}.chart.quad.h5" "$file.chart.quad.h5" "$1"
    run -0 "$ROOT/tests/cases/same_layout.py" "${first[$face]}.chart.sep.json" "$file.chart.sep.json" "$1"
  done
  assert_equal "${#first[@]}" 5
}

@test "a face has as many quads, the same blocks and nodes, to 1e-5, in every parametrisation" {
  blocks_agree 1e-5 1e-6
}

# Relaxed vertices are the same to 1e-6 then, for want of steps.
@test "with charts of closedness 1e-8 blocks and nodes are the same to 1e-7" {
  blocks_agree 1e-7 1e-8 --relax none
}
