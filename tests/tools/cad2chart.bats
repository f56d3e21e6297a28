# cad2chart: the chart of one face of a CAD file.
load common

@test "a curved face of a solid, by its number: a valid chart, silently" {
  run cad2chart "$DATA/curved/half_cylinder.step" --face 0 -o a.chart.h5 --report report.json
  assert_success
  assert_output ''
  assert_nothing_left a.chart.h5 report.json
  stagecheck a.chart.h5
  run -0 jq -e '.surface.kind == "cylinder" and .surface.deviation < 1e-12 and .heal.repairs == 0
    and .warnings == []' report.json
}

@test "files, pipes, threads and a second run give the same bytes" {
  cad2chart "$DATA/curved/torus_patch.step" -o a.chart.h5
  cad2chart "$DATA/curved/torus_patch.step" -o b.chart.h5 --threads 3
  cad2chart < "$DATA/curved/torus_patch.step" > c.chart.h5
  for other in b c; do cmp a.chart.h5 $other.chart.h5; done
}

@test "planar faces have charts too, and cad2tri reads them" {
  cad2chart "$DATA/half_disc.step" | cad2tri -o a.tri.h5
  stagecheck a.tri.h5
  cad2chart "$DATA/curved/half_cylinder.step" --face 1 | cad2tri -o b.tri.h5
  stagecheck b.tri.h5
}

@test "knots of arcs may be vertices of the kernel's triangles, but for rounding" {
  cad2chart "$DATA/curved_regions/half_turn.step" -o a.chart.h5 --report report.json
  stagecheck a.chart.h5
  run -0 jq -e '.chart.scale_range - 1 < 1e-6' report.json # unrolled
}

@test "what has no chart is refused, with a remedy" {
  run -3 cad2chart "$DATA/curved/sphere.step" --face 0 -o a.chart.h5
  assert_output --partial 'the face is closed, without a boundary'
  assert_output --partial 'cut it into faces with a boundary'
  run -3 cad2chart "$DATA/curved/half_cylinder.step" -o a.chart.h5
  assert_output --partial 'the file holds a solid'
  run -3 cad2chart "$DATA/curved/half_cylinder.step" --face 99 -o a.chart.h5
  assert_output --partial '--face 99: no face has this name or number'
  run -1 cad2chart "$DATA/curved/half_sphere.step" --scale-range 1.1 -o a.chart.h5
  assert_nothing_left
}

@test "a chart that misses its closedness is written with a warning" {
  run -0 cad2chart "$DATA/curved/sphere_cap.step" --closedness 1e-12 -o a.chart.h5 --report report.json
  assert_output --partial 'warning W-CAD-016'
  run -0 jq -e '[.warnings[].code] == ["W-CAD-016"] and .chart.closedness > 1e-12' report.json
}

@test "cad2tri names the kind of a curved face and the command for it; --list has a hint" {
  run -3 cad2tri "$DATA/curved/half_cylinder.step" --face 0 -o a.tri.h5
  assert_output --partial 'not planar (a cylinder): cad2chart --face 0 makes a chart of it, which cad2tri reads'
  run -0 --separate-stderr cad2tri --list "$DATA/curved/half_cylinder.step"
  assert_line --regexp '^0 +cylinder '
  assert_equal "$stderr" "cad2tri: 1 curved face: give the number of one to cad2chart --face, or to quadmesh --face"
  run -0 --separate-stderr cad2tri --list "$DATA/half_disc.step"
  assert_equal "$stderr" ""
}
