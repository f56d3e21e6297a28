# Several regions and curves inside a face, tool by tool.
load common

regions="disc_in_square nested_rings chequerboard_2_hole chequerboard_4_hole t_joint t_joint_open coated_gear pipe_wall
  voronoi_20 half_disc_cut coated_cam layered_cable layered_seal layered_beam pins pin_in_channel plate_circle"
slits="aerofoil_wake plate_curve plate_crack slit inner_curve"

# figures KEYS FILE [OPTIONS...]: what cad2tri reports of a file in tests/data/regions, as one line.
figures() {
  local keys=$1 file=$2
  shift 2
  cad2tri "$DATA/regions/$file" -q -o a.tri.h5 --report a.json "$@"
  jq -c "[$keys]" a.json
}

# ---- cad2tri

@test "cad2tri reads several faces in one plane as the regions of one face" {
  for shape in $regions; do
    cad2tri "$DATA/regions/$shape.step" -o a.tri.h5 --report a.json
    run jq -c '[.regions.count > 1, .sew.interfaces > 0, .sew.greatest < 1e-5, .heal.repairs, .warnings]' a.json
    assert_output '[true,true,true,0,[]]'
  done
}

@test "cad2tri embeds free edges and inner wires that bound nothing" {
  for shape in $slits; do
    cad2tri "$DATA/regions/$shape.step" -o a.tri.h5 --report a.json
    run jq -c '[.regions.count, .sew.inner_curves, .warnings]' a.json
    assert_output '[1,1,[]]'
  done
}

@test "cad2tri cuts embedded curves where they meet, and embeds what lies upon another once" {
  assert_equal "$(figures '.regions.count, .sew.inner_curves' cracks_x.step)" '[1,4]'
  assert_equal "$(figures '.regions.count, .sew.inner_curves' cracks_y.step)" '[1,3]'
  assert_equal "$(figures '.regions.count, .sew.inner_curves' cracks_along.step)" '[1,3]'
  assert_equal "$(figures '.regions.count, .sew.inner_curves, .sew.interfaces' patches_touching.step)" '[3,0,6]'
}

@test "cad2tri names common curves and counts them" {
  run cad2tri "$DATA/regions/t_joint.step" -v -o a.tri.h5
  assert_line --partial 'sewed 3 regions along 3 curves'
  assert_equal "$(figures '.regions.count, .face.curves, .face.area' t_joint.step)" '[3,13,4.000000000000001]'
}

@test "cad2tri --face picks one face, with the curves inside; others are ignored with a warning" {
  assert_equal "$(figures '.regions.count, .face.curves, .sew' t_joint.step --face base)" '[1,4,null]'
  assert_equal "$(figures '.sew.inner_curves' plate_crack.step --face 0)" '[1]'
  run cad2tri "$DATA/bad/construction.step" --face 0 -o a.tri.h5
  assert_success
  assert_output --partial 'W-CAD-001'
}

@test "cad2tri refuses faces that do not fit, with the place, the size and a remedy" {
  refuse() {
    run cad2tri "$DATA/regions/bad/$1.step" -o a.tri.h5
    assert_failure 3
    assert_equal "${#lines[@]}" 1
    assert_output --regexp "^cad2tri: .*/$1.step: .*$2"
  }
  refuse overlap "face 0 'one' and face 1 'two' overlap at \(1.5, 0.515625\)"
  refuse disc_on_square "overlap"
  refuse twice "overlap"
  refuse gap "up to 0.0002 apart at .*: give --heal-tolerance 9e-05"
  refuse gap_around "up to 0.0005 apart at .*: give --heal-tolerance 0.00018"
  refuse crevice "up to 0.0004 apart .*; if the gap is meant, give --heal-tolerance 3e-06"
  refuse disjoint "several faces \(2\) that do not touch: .* are 0.5 apart.*choose one face with --face"
  refuse corner_contact "touch at \(1, 1\) in a point only"
  refuse two_planes "not in one plane: .*choose one face with --face"
  refuse dangling "the curve of edge 4 ends at \(1.5, 0.0005\), 0.0005 before edge 0"
  assert_nothing_left
  assert_equal "$(figures .regions.count bad/gap.step --heal-tolerance 9e-5)" '[2]'
  assert_equal "$(figures .regions.count bad/gap_around.step --heal-tolerance 1.8e-4)" '[2]'
  assert_equal "$(figures .sew.inner_curves bad/dangling.step --heal-tolerance 1.4e-4)" '[1]'
}

@test "cad2tri warns of an inner wire that is not closed, and embeds it" {
  run cad2tri "$DATA/regions/open_inner_wire.step" -o a.tri.h5 --report a.json
  assert_success
  assert_output --partial 'W-CAD-008'
  assert_equal "$(jq -c '[.regions.count, .sew.inner_curves]' a.json)" '[1,2]'
}

@test "cad2tri --write-healed writes faces that share edges, and slits" {
  for shape in t_joint_open disc_in_square voronoi_20 aerofoil_wake plate_curve plate_crack cracks_x \
    patches_touching; do
    for ending in step brep; do
      cad2tri "$DATA/regions/$shape.step" -o a.tri.h5 --report a.json --write-healed "healed.$ending"
      cad2tri "healed.$ending" -q -o b.tri.h5 --report b.json
      keys='[.regions.count, .face.curves, .face.loops, .sew.interfaces, .sew.inner_curves]'
      assert_equal "$(jq -c "$keys" b.json)" "$(jq -c "$keys" a.json)"
      run jq '.sew.greatest < 1e-15' b.json
      assert_output true
    done
  done
  cad2tri "$DATA/regions/t_joint_open.step" -o a.tri.h5 --write-healed healed.step
  assert_equal "$(grep -c 'EDGE_CURVE(' healed.step)" 10
  assert_equal "$(grep -c "ADVANCED_FACE('\(base\|left\|right\)'" healed.step)" 3
}

# names ARRAY FILE: the strings of a dataset, one a line.
names() {
  h5dump -y -A 0 -d "/face/$1" "$2" | sed '1,/DATA {/d' | grep -o '"[^"]*"' | sed 's/\\000//g'
}

@test "cad2tri --region-name names regions, and --name both sides of a common curve" {
  cad2tri "$DATA/regions/t_joint.step" --region-name floor=0 --region-name 'top@1,1.5' --region-name 'rest=*' \
    --name 'bond=rest-top' -o a.tri.h5
  assert_equal "$(names curve_names a.tri.h5 | sort | uniq -c | sed 's/^ *//' | grep -v curve_ | tr '\n' ' ')" \
    '2 "bond" 2 "floor-rest" 2 "floor-top" '
  cad2tri "$DATA/regions/t_joint.step" --name seam@1,1 -o a.tri.h5
  assert_equal "$(names curve_names a.tri.h5 | grep -c '"seam"')" 2
  cad2tri "$DATA/regions/plate_crack.step" --name 'split=crack' -o a.tri.h5
  assert_equal "$(names curve_names a.tri.h5 | grep -c '"split"')" 2
  cad2tri "$DATA/square.step" --region-name plate=0 -o a.tri.h5
  assert_equal "$(names name a.tri.h5)" '"plate"'
  refused() { # CODE OPTION MESSAGE
    run cad2tri "$DATA/regions/t_joint.step" --region-name "$2" -o a.tri.h5
    assert_failure "$1"
    assert_output --partial "cad2tri: --region-name $2: $3"
  }
  refused 3 x=3 'no region has the number 3; the regions are 0 "base", 1 "left", 2 "right"'
  refused 3 x@3,3 '(3, 3) is in no region'
  refused 2 x 'expected NAME=LIST'
}

@test "regions that --region-name gives one name are one, unless --keep-joints" {
  parts=(--region-name metal=0-3 --region-name chip=4)
  run cad2tri "$DATA/regions/finned_plate.step" "${parts[@]}" --name 'air=*' --report a.json -o a.tri.h5
  assert_success
  assert_output ""
  assert_equal "$(jq -c '[.regions.count, .face.curves]' a.json)" '[2,22]'
  assert_equal "$(names region_names a.tri.h5 | tr '\n' ' ')" '"metal" "chip" '
  assert_equal "$(names curve_names a.tri.h5 | sort | uniq -c | sed 's/^ *//' | tr '\n' ' ')" '20 "air" 2 "metal-chip" '
  run stagecheck a.tri.h5
  assert_success
  assert_equal "$(figures .regions.count finned_plate.step "${parts[@]}" --keep-joints)" '[5]'
  assert_equal "$(figures .regions.count finned_plate.step --region-name 'all=*')" '[1]'
  assert_equal "$(figures .regions.count finned_plate.step --region-name metal=0)" '[5]'
}

@test "--name '*' names no interface, interface:* nothing else, and one name for both is a warning" {
  cad2tri -q "$DATA/regions/finned_plate.step" --name 'air=*' --name 'joint=interface:*' -o a.tri.h5
  assert_equal "$(names curve_names a.tri.h5 | sort | uniq -c | sed 's/^ *//' | tr '\n' ' ')" '20 "air" 8 "joint" '
  printf '{"*": "air", "interface:*": "joint"}' >names.json
  cad2tri -q "$DATA/regions/finned_plate.step" --boundary-names names.json -o b.tri.h5
  assert_equal "$(names curve_names b.tri.h5)" "$(names curve_names a.tri.h5)"
  run cad2tri "$DATA/regions/finned_plate.step" --name 'air=*e*' -o a.tri.h5
  assert_success
  assert_output --partial 'W-CAD-010: --name air=*e* names'
  run cad2tri "$DATA/regions/plate_crack.step" --name 'edge=*' -o a.tri.h5
  assert_output ""
  assert_equal "$(names curve_names a.tri.h5 | grep -c crack)" 2
  run -3 cad2tri "$DATA/square.step" --name 'x=interface:*' -o b.tri.h5
  assert_output --partial 'the face has no interface'
}

@test "curves without a face are its boundary if they close, with a warning; else the gap is named" {
  run cad2tri "$DATA/regions/loose_curves.step" -o a.tri.h5 --report a.json
  assert_success
  assert_output --partial 'W-CAD-012: '
  assert_output --partial 'the file holds no face: 6 curves that close, in 3 loops, were taken as the boundary of one'
  assert_equal "$(jq -c '[.face.loops, .face.curves, (.face.area * 1000 | round)]' a.json)" '[3,6,9571]'
  assert_equal "$(names curve_names a.tri.h5 | sort | uniq -c | sed 's/^ *//' | tr '\n' ' ')" \
    '1 "curve_4" 1 "curve_5" 2 "flank" 2 "head" '
  run stagecheck a.tri.h5
  assert_success
  assert_equal "$(figures '.face.loops, .face.curves' loose_curves.iges)" '[1,4]'
  assert_equal "$(names curve_names a.tri.h5 | grep -c level_3)" 1
  refuse() { # NAME MESSAGE
    run cad2tri "$DATA/regions/bad/$1.step" -o x.tri.h5
    assert_failure 3
    assert_output --regexp "$2"
  }
  refuse loose_gap "its curves leave 1 gap: edge 4 ends at \(-2, -1\), 0.001 from edge 5 at \(-1.999, -1\) .*: give --heal-tolerance 0.00017"
  refuse loose_branch "its curves bound none: 3 curves end at \(2, 1\), such as edges 0 and"
  assert_equal "$(figures .face.loops bad/loose_gap.step --heal-tolerance 0.00017)" '[3]'
}

@test "cad2tri gives the same bytes with any number of threads" {
  cad2tri "$DATA/regions/voronoi_20.step" -o a.tri.h5 --threads 1
  cad2tri "$DATA/regions/voronoi_20.step" -o b.tri.h5 --threads 4
  cmp a.tri.h5 b.tri.h5
}
