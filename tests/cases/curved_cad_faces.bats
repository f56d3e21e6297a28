# Curved faces from a CAD file to a mesh on the surface.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh
curved=$DATA/curved

# nodes MSH: x y z of each node.
nodes() { awk '/^\$Nodes/ { on = 1 } /^\$EndNodes/ { on = 0 } on && NF == 3 { print }' "$1"; }

@test "a file that holds one curved face alone needs no --face" {
  "$quadmesh" "$curved/sphere_cap.step" -o a.msh
  "$quadmesh" "$curved/sphere_cap.step" --face 0 -o b.msh
  cmp <(nodes a.msh) <(nodes b.msh)
  run -0 "$quadmesh" "$curved/sphere_cap.step" -o a.msh --dry-run
  assert_line --regexp '^cad2chart .*/sphere_cap.step -o '
}

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

@test "elements at the tip of a cone are small enough to be within the tolerance of the surface" {
  "$quadmesh" -q "$curved/cone_tip.step" --face 0 --workdir stages -o fine.msh
  quadrefine stages/cone_tip.blocks.h5 -o a.quad.h5 --report fine.json
  run -0 jq -e '.surface.distance <= .surface.tolerance and .least_scaled_jacobian > 0.75 and .warnings == []' fine.json
  quadrefine stages/cone_tip.blocks.h5 --geometry-tol 0.01 -o a.quad.h5 --report coarse.json
  # Rings of elements around the tip alone.
  (( $(jq .quads fine.json) < $(jq .quads coarse.json) + 150 ))
}

# Across the seam of the surface, and with its pole inside a block.
@test "blocks of a STEP model are faces that can be meshed, wherever seams and poles are" {
  for shape in tube sphere_cap; do
    "$quadmesh" -q "$curved/$shape.step" --face 0 --block-groups -o $shape.blocks.step
  done
  assert_equal "$(grep -c "ADVANCED_FACE('block_" tube.blocks.step)" 4
  assert_equal "$(grep -c "ADVANCED_FACE('block_" sphere_cap.blocks.step)" 5
  for i in 0 1 2 3; do cad2chart tube.blocks.step --face block_$i -o block.chart.h5; done
  cad2chart sphere_cap.blocks.step --face block_4 -o block.chart.h5
}

# z = 1/2 - sqrt((x - 1)^2 + 1e-4) / 2 about: elements are 50 times as long as the radius of curvature at x = 1.
@test "elements become as short as a sharp bend of the surface" {
  "$quadmesh" -q "$curved/bend.step" --face 0 --size 0.5 -o a.msh --report a.json
  jq -e '.surface.distance <= .surface.tolerance and .quads < 1000' a.json
}

@test "refusals name the face and say how to cut it" {
  run -1 cad2chart "$curved/ramp.step" --face 0 -o a.chart.h5
  assert_output --partial 'ramp.step: face 0: the chart of the face'
  assert_output --partial 'cut it in two in the CAD'
  run -3 cad2chart "$curved/roof.step" --face 0 -o a.chart.h5
  assert_output --regexp 'roof.step: face 0: the surface of the face has a kink of 53.1 degrees along u = 1, at .*: cut the face there'
  run -1 cad2chart "$curved/half_sphere.step" --face 0 --scale-range 1.5 -o a.chart.h5
  assert_output --partial 'half_sphere.step: face 0: the chart of the face would have scales between'
  assert_output --partial 'cut the face between them in the CAD'
  run -3 "$quadmesh" "$curved/sphere.step" --face 0 -o a.msh
  assert_output --partial 'sphere.step: face 0: the face is closed'
  assert_file_not_exist a.chart.h5
}

@test "cad2tri --list shows the size of curved faces, and which are closed" {
  run -0 cad2tri --list "$curved/half_cylinder.step"
  assert_line --regexp '^0 +cylinder .* radius 1$'
  run -0 cad2tri --list "$curved/sphere.step"
  assert_line --regexp '^0 +sphere .* radius 1, closed: cut it to mesh it$'
}

@test "symmetric faces have symmetric meshes" {
  for face in "sphere_cap x y" "half_cylinder_hole x z" "saddle x y" "tube x y z"; do
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
    assert_output --partial '5 blocks, 4 irregular nodes, 128 quads'
    assert_equal "$(nodes_of $name.crit.json)" "$(nodes_of pole.crit.json)"
  done
  assert_not_equal "$(sed -n '/^#32=/p' none.step)" "$(sed -n '/^#32=/p' pole.step)"
}

@test "on the half sphere the nodes of least energy are corners of a cube" {
  cad2chart "$curved/half_sphere.step" --face 0 --closedness 1e-8 | cad2tri | fieldsolve | padapt -o a.field.h5
  critpoints --place-weight 0 a.field.h5 -o a.crit.json
  run -0 jq -c '[.critical_points[].position | (map(. * .) | add | sqrt) - ((3 | sqrt) - 1) / (2 | sqrt) |
    fabs < 1e-10]' a.crit.json
  assert_output '[true,true,true,true]'
}

@test "--clearance is a length in space" {
  cad2chart "$curved/half_sphere.step" --face 0 | cad2tri | fieldsolve | padapt -o a.field.h5
  critpoints --clearance curve_0=0.8 a.field.h5 -o a.crit.json
  # The rim of the half sphere is pi / 2 - 2 atan(r) from a point, r its distance from the middle of the chart.
  run -0 jq -c '[.critical_points[].position | 3.141592653589793 / 2 - 2 * (map(. * .) | add | sqrt | atan) - 0.8 |
    fabs < 1e-5]' a.crit.json
  assert_output '[true,true,true,true]'
}
