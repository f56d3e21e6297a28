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

@test "symmetric faces have symmetric meshes" {
  for face in "sphere_cap x y" "half_cylinder_hole x z" "saddle x y"; do
    read -r shape axes <<<"$face"
    "$quadmesh" -q "$curved/$shape.step" --face 0 -o $shape.msh
    run -0 "$ROOT/tests/cases/symmetric_surface.py" $shape.msh $axes
    run -0 awk '$1 > 1e-8 { exit 1 }' <<<"$output"
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

@test "a cap has the same blocks and nodes wherever pole and seam of its parameters are" {
  nodes_of() { jq -c '[.critical_points[].position | map(. * 1e5 | round)] | sort' "$1"; }
  # The pole in the middle; the seam through it; neither in the face; the pole beside the middle.
  local -A places=([pole]="0.,0.,1. 1.,0.,0." [seam]="0.,1.,0. 0.,0.,1." [none]="0.,1.,0. 1.,0.,0." [beside]=".6,0.,.8 .8,0.,-.6")
  for name in pole seam none beside; do
    read -r axis across <<<"${places[$name]}"
    sed -E "s/^(#32=DIRECTION\('',).*/\1($axis));/; s/^(#33=DIRECTION\('',).*/\1($across));/" \
      "$curved/cap_circle.step" >$name.step
    run -0 "$quadmesh" $name.step --face 0 --size .15 --order 3 -o $name.msh --workdir .
    assert_output --partial '5 blocks, 4 irregular nodes, 105 quads'
    assert_equal "$(nodes_of $name.crit.json)" "$(nodes_of pole.crit.json)"
  done
  assert_not_equal "$(sed -n '/^#32=/p' none.step)" "$(sed -n '/^#32=/p' pole.step)"
}
