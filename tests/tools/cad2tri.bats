# cad2tri: one planar CAD face in, a valid curved triangle mesh out.
load common

shapes="half_disc square l_shape quarter_annulus annulus eccentric_annulus plate_hole cylinder_channel s_bend stadium
  geometry_1"

@test "writes a mesh silently and leaves nothing else" {
  run cad2tri "$DATA/half_disc.step" -o a.tri.h5
  assert_success
  assert_output ""
  assert_nothing_left a.tri.h5
}

@test "meshes of all shapes keep every rule of the format" {
  for shape in $shapes; do
    cad2tri "$DATA/$shape.step" -o "$shape.tri.h5"
    run stagecheck "$shape.tri.h5"
    assert_success
  done
}

@test "meshes are coarse, proved and on their curves" {
  for shape in $shapes; do
    cad2tri "$DATA/$shape.step" -o a.tri.h5 --report a.json
    run jq -c '.mesh | [.elements < 1000, .least_jacobian_ratio > 0, .curve_error < 1e-12]' a.json
    assert_output '[true,true,true]'
  done
}

@test "the report counts, times and names no warning" {
  cad2tri "$DATA/plate_hole.step" -o a.tri.h5 --report a.json
  run jq -c '[.tool, .face.curves, .face.loops, .face.corners, .mesh.corner_fans, .warnings,
    .timings.load.cpu_seconds > 0, .timings.triangulate.cpu_seconds > 0]' a.json
  assert_output '["cad2tri",5,2,4,0,[],true,true]'
}

@test "gives the same bytes through pipes and twice" {
  cad2tri "$DATA/stadium.step" -o a.tri.h5
  cad2tri "$DATA/stadium.step" > b.tri.h5
  cad2tri - < "$DATA/stadium.step" > c.tri.h5
  cmp a.tri.h5 b.tri.h5
  cmp a.tri.h5 c.tri.h5
}

@test "--order, --size, --growth, --fan-layers and --fan-factor shape the mesh" {
  elements() {
    cad2tri "$DATA/half_disc.step" -o a.tri.h5 --report a.json "$@" && jq .mesh.elements a.json
  }
  default=$(elements)
  (($(elements --size 0.1) > 4 * default))
  (($(elements --growth 0.1 --size 0.2) >= $(elements --growth 2 --size 0.2)))
  # Two sectors at each of the two corners: an apex triangle and two triangles a layer.
  elements --fan-layers 5
  assert_equal "$(jq .mesh.fan_elements a.json)" 44
  elements --fan-layers 0
  assert_equal "$(jq .mesh.fan_elements a.json)" 0
  (($(elements --fan-factor 0.5) > default))
  elements --order 4
  run stagecheck a.tri.h5
  assert_success
}

@test "a low order warns that its edges leave the curves" {
  run cad2tri "$DATA/half_disc.step" -o a.tri.h5 --order 2
  assert_success
  assert_output --partial "W-TRI-001"
  run cad2tri "$DATA/half_disc.step" -o a.tri.h5 --order 2 -q
  assert_output ""
}

@test "--corner-angle decides which jumps are corners of the layout" {
  cad2tri "$DATA/half_disc.step" -o a.tri.h5 --report a.json
  assert_equal "$(jq .face.corners a.json)" 2
  cad2tri "$DATA/half_disc.step" -o a.tri.h5 --report a.json --corner-angle 90
  assert_equal "$(jq .face.corners a.json)" 0
}

@test "numbers outside their intervals end with 2" {
  for option in "--order 0" "--order 17" "--size -1" "--growth 0" "--fan-layers -2" "--fan-factor 1" "--corner-angle 91" \
    "--size x"; do
    run cad2tri "$DATA/square.step" -o a.tri.h5 ${option}
    assert_failure 2
    assert_output --partial "${option%% *}"
  done
  assert_nothing_left
}

@test "odd but honest files are read" {
  for name in rectangle.step rectangle.brep inches.step metres.step tilted.step upright.step downwards.step far_away.step \
    names.step against_the_curve.step ellipse_arc.step closed_spline.step kinked_spline.step construction.step; do
    cad2tri "$DATA/bad/$name" -q -o a.tri.h5
    run stagecheck a.tri.h5
    assert_success
  done
}

@test "bad files end with 3, one message and no file" {
  for name in empty.step truncated.step garbage.step garbage.txt wrong_extension.iges wrong_extension.txt \
    unknown_entity.step unknown_point.step points_are_directions.step broken_reference.step mixed_units.step solid.step \
    sphere.step two_faces.step shared_edge.step open_wire.step self_intersecting.step self_intersecting_curve.step \
    slit.step inner_curve.step hole_outside.step hole_across.step hole_touching.step hole_in_hole.step zero_area.step \
    swapped_coordinates.step; do
    run cad2tri "$DATA/bad/$name" -o a.tri.h5
    assert_failure 3
    assert_equal "${#lines[@]}" 1
    assert_output --regexp "^cad2tri: .*$name: "
  done
  assert_nothing_left
}

@test "a missing file ends with 3, a folder that is not there with 4" {
  run cad2tri nowhere.step -o a.tri.h5
  assert_failure 3
  assert_output --partial nowhere.step
  run cad2tri "$DATA/square.step" -o nowhere/a.tri.h5
  assert_failure 4
  assert_output --partial nowhere
  assert_nothing_left
}

@test "a full disk ends with 4" {
  [ -c /dev/full ] || skip "no /dev/full here"
  run bash -c 'cad2tri "$DATA/square.step" > /dev/full'
  assert_failure 4
  assert_output --partial "cad2tri: "
}
