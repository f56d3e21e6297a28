# Curved faces from a CAD file to a mesh on the surface.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh
curved=$DATA/curved

# nodes MSH: x y z of each node.
nodes() { awk '/^\$Nodes/ { on = 1 } /^\$EndNodes/ { on = 0 } on && NF == 3 { print }' "$1"; }

@test "quadmesh --face meshes a curved face of a solid, on its surface" {
  run -0 "$quadmesh" "$curved/half_cylinder.step" --face 0 -o a.msh
  assert_output --regexp '^[0-9]+ blocks?, [0-9]+ irregular nodes, [0-9]+ quads, '
  run -0 awk '{ off = sqrt($1 * $1 + $2 * $2) - 1; if (off < 0) off = -off; if (off > most) most = off }
    END { print (NR > 20 && most < 1e-8) }' <(nodes a.msh)
  assert_output 1
}

@test "the single commands give the same stage files" {
  "$quadmesh" "$curved/sphere_cap.step" --face 0 --workdir stages -o a.msh
  cad2chart "$curved/sphere_cap.step" --face 0 -o stages/sphere_cap.chart.h5.again
  cmp stages/sphere_cap.chart.h5 stages/sphere_cap.chart.h5.again
  run -0 "$quadmesh" "$curved/sphere_cap.step" --face 0 --workdir stages -o b.msh --dry-run
  assert_line --index 0 --regexp 'cad2chart .*sphere_cap.step --face 0 -o stages/sphere_cap.chart.h5$'
  assert_line --index 1 --regexp '^cad2tri stages/sphere_cap.chart.h5 -o stages/sphere_cap.tri.h5'
  stagecheck stages/sphere_cap.chart.h5 stages/sphere_cap.tri.h5 stages/sphere_cap.quad.h5
}

@test "every sample of a curved face is meshed" {
  for shape in tube cone_tip half_sphere sphere_cap torus_patch hills_hole; do
    run -0 "$quadmesh" -q "$curved/$shape.step" --face 0 -o $shape.msh --report $shape.json
    run -0 jq -e '[.. | .valid? // empty] | all' $shape.json
  done
}

@test "names and files: --name works on the curves of the chart, --workdir keeps it" {
  "$quadmesh" "$curved/sphere_cap.step" --face 0 --name 'rim=*' --workdir stages -o a.msh
  run -0 grep -c '"rim' a.msh
  assert_exist stages/sphere_cap.chart.h5
}

@test "make: x.curved.msh" {
  cp "$curved/half_cylinder.step" .
  run -0 make -f "$ROOT/Makefile.example" BIN="$BIN" half_cylinder.curved.msh cad2chart='--face 0'
  assert_exist half_cylinder.curved.chart.h5
}
