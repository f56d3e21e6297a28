# Periodic sides, from the options of cad2tri to meshes that the checker of regions accepts.
load ../tools/common

setup() {
  need_h5py
  common_setup
}

# accepted SHAPE OPTION...: a mesh of tests/data/regions/periodic_SHAPE.step whose nodes are images of each other.
accepted() {
  local shape=$1
  mkdir -p "$shape"
  "$ROOT/pipelines/quadmesh" "$DATA/regions/periodic_$shape.step" --order 8 --geometry-tol 1e-9 "${@:2}" --workdir "$shape" \
    -o "$shape/$shape.msh" 2>"$shape/log"
  stagecheck "$shape"/*.tri.h5 "$shape"/*.sep.json "$shape"/*.blocks.h5 "$shape"/*.quad.h5
  run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" "$(echo "$shape"/*.quad.h5)" --face "$(echo "$shape"/*.tri.h5)"
  refute_output --partial FAULT
  assert_line --regexp '^ok +periodic nodes: [1-9][0-9]+ pairs'
}

@test "a box with a hole is periodic in both directions" {
  accepted box --periodic left=right --periodic bottom=top
}

@test "a blade passage and a wavy channel are periodic along curves and lines" {
  accepted blade --periodic below=above --geometry-tol 1e-10
  accepted wave --periodic inflow=outflow --geometry-tol 1e-10
}

@test "a sector of 30 degrees of a perforated disc is periodic about its centre" {
  accepted sector --periodic from=to
}

@test "sides in several parts are paired by the motion, and named by patterns" {
  accepted bank --periodic 'below*=above_?'
  assert_line --regexp '^ok +periodic nodes'
  cad2tri "$DATA/regions/periodic_bank.step" --periodic 'below*=above*:translate=0,2' -o a.tri.h5 --report a.json
  assert_equal "$(jq .face.periodic_pairs a.json)" 3
  run -2 cad2tri "$DATA/regions/periodic_bank.step" --periodic 'below*=above_1' -o x.tri.h5
  assert_line --partial "'below*' has 3 parts and 'above_1' has 1 part"
  run -3 cad2tri "$DATA/regions/periodic_bank.step" --periodic 'below*=above*:translate=0,2.1' -o x.tri.h5
  assert_line --partial "the ends of the sides give translate=0,2"
}

@test "periodic sides of two regions have nodes in the same places" {
  accepted layers --periodic left=right
  accepted pin --periodic left=right --periodic bottom=top
}

@test "sizes, layers and relaxation keep the nodes of both sides" {
  accepted wave --periodic inflow=outflow --geometry-tol 1e-10
  for options in "--wall wall:first=0.01,layers=4" "--size 0.1 --relax shape --relax-sweeps 10" "--size-near wall=0.04"; do
    # shellcheck disable=SC2086  # several options
    quadrefine --order 4 $options wave/*.blocks.h5 -o x.quad.h5
    run -0 /usr/bin/python3 "$ROOT/tests/check_regions.py" x.quad.h5 --area-tolerance 1e-8
    refute_output --partial FAULT
  done
}

@test "sides that differ are refused with the place and the distance" {
  run -3 cad2tri "$DATA/regions/bad/periodic_unequal.step" --periodic bottom=top -o x.tri.h5
  assert_line --partial "the point (1, 0) of 'bottom' would be 0.414"
  assert_line --partial "Draw one side as a copy of the other"
  run -3 cad2tri "$DATA/regions/bad/periodic_unequal.step" --periodic left=right:translate=2,0.1 -o x.tri.h5
  assert_line --partial "the ends of the sides give translate=2,0"
  cad2tri "$DATA/regions/bad/periodic_unequal.step" --periodic left=right:translate=2,0 -o x.tri.h5
}

@test "closed and embedded curves, and sides of different direction, are refused" {
  run -2 cad2tri "$DATA/regions/periodic_box.step" --name hole=4 --periodic hole=left -o x.tri.h5
  assert_line --regexp "'hole' at \(2\.3, 1\.4\) are closed.*; cut the shape along two lines"
  run -2 cad2tri "$DATA/regions/plate_curve.step" --periodic baffle=curve_1 -o x.tri.h5
  assert_line --regexp "'baffle' at \(.*\) is not on the boundary.*free periodic curves.*; cut the shape there"
  run -3 cad2tri "$DATA/regions/periodic_box.step" --periodic left=top -o x.tri.h5
  assert_line --partial "of 'left' would be 0.5"
  assert_line --partial "Draw one side as a copy of the other"
  run -3 cad2tri "$DATA/regions/periodic_box.step" --periodic left=right:translate=4,1 -o x.tri.h5
  assert_line --partial "the ends of the sides give translate=4,0"
  run -2 cad2tri "$DATA/regions/periodic_box.step" --name sides=left --name sides=right --periodic sides=top -o x.tri.h5
  assert_line --partial "'sides' has 2 parts and 'top' has 1 part that do not follow each other ((4, 0) to (4, 3), (0, 3) to (0, 0); (4, 3) to (0, 3))"
  run -2 cad2tri "$DATA/regions/periodic_box.step" --periodic 'l*=*t' -o x.tri.h5
  assert_line --partial "'left' is on both sides"
  run -2 cad2tri "$DATA/regions/periodic_box.step" --periodic left=right --periodic right=left -o x.tri.h5
  assert_line --partial "'right' is already a side of another periodic pair"
  assert_file_not_exists x.tri.h5
}

@test "wrong names and motions are refused" {
  for pair in left left=left left=right:translate=1 left=right:rotate=x,0,0 =right left=none; do
    run -2 cad2tri "$DATA/regions/periodic_box.step" --periodic "$pair" -o x.tri.h5
    assert_line --partial "--periodic $pair"
  done
  run -2 cad2tri "$DATA/regions/periodic_box.step" --periodic left=right --periodic left=top -o x.tri.h5
  assert_line --partial "already a side of another periodic pair"
}

# exported NAME OPTION...: files of a periodic mesh in all formats, and how many pairs of edges it has.
exported() {
  "$ROOT/pipelines/quadmesh" -q "$DATA/regions/$1.step" "${@:2}" --inner-edges curved --workdir . -o x.msh
  quadexport -q --format msh22 "$1.quad.h5" -o x22.msh
  quadexport -q --frame 3d "$1.quad.h5" -o space.msh
  for format in re2 mesh xml ism inp; do quadexport -q "$1.quad.h5" -o "x.$format" 2>>messages; done
  quadexport -q --format mfem13 "$1.quad.h5" -o x13.mesh
}

@test "each format says that sides are periodic in its own way" {
  exported periodic_box --periodic left=right --periodic bottom=top --size 0.7
  refute grep periodic messages
  run -0 python3 "$ROOT/tests/exports/check_periodic.py" x.msh x22.msh space.msh
  run -0 python3 "$ROOT/tests/exports/check_periodic.py" --stage periodic_box.quad.h5 --composites left=right \
    --composites bottom=top x.re2 x.mesh x13.mesh x.xml x.ism x.inp
  assert_equal "$(sed -E 's/[^:]*: //; s/,.*//' <<<"$output" | sort -u | wc -l)" 1 # as many pairs of sides in each
}

@test "a rotation is written where the solver can use it, and reported elsewhere" {
  exported periodic_sector --periodic from=to
  run -0 python3 "$ROOT/tests/exports/check_periodic.py" x.msh x22.msh space.msh
  run -0 python3 "$ROOT/tests/exports/check_periodic.py" --composites from=to x.re2 x.xml
  run -0 quadexport --format mfem13 periodic_sector.quad.h5 -o y.mesh
  assert_output --partial 'sides that meet in a corner stay apart' # in the centre
  for format in vtu vtu-bezier ism-v2 ism-mm inp; do
    run -0 quadexport --format "$format" periodic_sector.quad.h5 -o y
    assert_output --partial 'that sides are periodic is not stored, their nodes are images of each other: "from" and "to"'
  done
  run -0 "$ROOT/tests/exports/compare" --off 1e-10 inp x.inp periodic_sector.quad.h5 ism x.ism periodic_sector.quad.h5
}

@test "files of a periodic mesh with few elements, and of several regions" {
  "$ROOT/pipelines/quadmesh" -q "$DATA/square.step" --periodic curve_1=curve_3 --size 10 --workdir . -o x.msh
  run -0 quadexport --format mfem13 square.quad.h5 -o few.mesh
  assert_output --partial '(MFEM identifies edges by their ends, and the edge from'
  run -0 "$ROOT/tests/exports/compare" mfem few.mesh square.quad.h5
  "$ROOT/pipelines/quadmesh" -q "$DATA/regions/periodic_layers.step" --periodic left=right --workdir . -o x.msh
  quadexport -q --format mfem13 periodic_layers.quad.h5 -o layers.mesh
  run -0 python3 "$ROOT/tests/exports/check_periodic.py" --stage periodic_layers.quad.h5 layers.mesh
}

@test "periodic boundaries are OpenFOAM's cyclic patches, unless an option gives them a type" {
  "$ROOT/pipelines/quadmesh" "$DATA/regions/periodic_box.step" --periodic left=right --periodic bottom=top --workdir . -o x.msh
  run -0 quadexport --format blockmesh periodic_box.quad.h5 -o x
  refute_output --partial periodic
  run -0 grep -c 'type cyclic;' x
  assert_output 4
  run -0 grep -A 4 '^    left$' x
  assert_line --index 3 '        neighbourPatch right;'
  run -0 grep '^scale' x # positions and separations have one unit
  assert_output 'scale 1;'
  run -0 python3 "$ROOT/tests/exports/read_blockmesh.py" x periodic_box.quad.h5
  run -0 quadexport --format blockmesh --patch-type 'left=wall' periodic_box.quad.h5 -o x
  assert_output --partial 'that sides are periodic is not stored, their nodes are images of each other: "left" and "right" (a cyclic patch'
  run -0 grep -c 'type cyclic;' x
  assert_output 2
}
