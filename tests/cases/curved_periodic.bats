# Periodic sides of curved faces: a motion of space maps the nodes of one side onto those of the other.
load ../tools/common

TURN="math.cos(math.pi/5),-math.sin(math.pi/5),0,math.sin(math.pi/5),math.cos(math.pi/5),0,0,0,1" # 36 degrees
SAME="1,0,0,0,1,0,0,0,1"

setup() {
  need_h5py
  common_setup
}

# meshed SHAPE OPTION...: a proved mesh of a face of tests/data/curved, with its stages in the folder SHAPE.
meshed() {
  "$ROOT/pipelines/quadmesh" -q "$DATA/curved/$1.step" --face 0 "${@:2}" --workdir "$1" -o "$1.msh" --report "$1.json"
  grep -q '"valid": true' "$1.json"
  stagecheck "$1"/*.tri.h5 "$1"/*.crit.json "$1"/*.sep.json "$1"/*.blocks.h5 "$1"/*.quad.h5
}

# repeats FILE FROM TO MATRIX SHIFT
repeats() {
  run -0 /usr/bin/python3 "$ROOT/tests/cases/curved_periodic.py" "$@"
  assert_output --partial nodes
}

# names SHAPE: the options that name its sides.
names() {
  case $1 in
    sector_cylinder) echo --name from@1,0,0.5 --name to@0.809,0.588,0.5 ;;
    half_cylinder_hole) echo --name from=1 --name to=3 --name top=0 --name bottom=2 ;;
    sector_cone) echo --name from@0.75,0,0.5 --name to@0.607,0.441,0.5 ;;
    sector_vase) echo --name from@1.29,0.12,0.75 --name to@0.97,0.86,0.75 ;;
    sheet) echo --name from@1,0,0 --name to@1.3,1.5,0 ;;
  esac
}

@test "sectors of a cylinder and a cone repeat by a rotation" {
  # shellcheck disable=SC2046  # several options
  meshed sector_cylinder $(names sector_cylinder) --periodic from=to
  repeats sector_cylinder/*.quad.h5 from to "$TURN" 0,0,0
  # shellcheck disable=SC2046
  meshed sector_cone $(names sector_cone) --periodic from=to --order 3
  repeats sector_cone/*.quad.h5 from to "$TURN" 0,0,0
}

@test "sides that are bent in space repeat on a surface of revolution, whose chart does not" {
  # shellcheck disable=SC2046
  meshed sector_vase $(names sector_vase) --periodic from=to
  repeats sector_vase/*.quad.h5 from to "$TURN" 0,0,0
}

@test "sides of a wavy sheet repeat by a translation" {
  # shellcheck disable=SC2046
  meshed sheet $(names sheet) --periodic from=to
  repeats sheet/*.quad.h5 from to "$SAME" 0.3,1.5,0
  hexsweep -q sheet/*.quad.h5 --along 0,0,0.2 --layers 2 -o x.hex.h5
  stagecheck x.hex.h5
  run -0 h5dump -d face_groups/periodic_with x.hex.h5
  assert_output --regexp '\): .*[0-9], '
}

@test "half of a cylinder with a hole repeats by half a turn, and along its axis" {
  # shellcheck disable=SC2046
  meshed half_cylinder_hole $(names half_cylinder_hole) --periodic from=to --periodic top=bottom
  repeats half_cylinder_hole/*.quad.h5 from to -1,0,0,0,-1,0,0,0,1 0,0,0
  repeats half_cylinder_hole/*.quad.h5 top bottom "$SAME" 0,0,-2
}

@test "relaxation, sizes and layers keep the images" {
  # shellcheck disable=SC2046
  meshed sector_vase $(names sector_vase) --periodic from=to
  for options in "--relax none" "--relax shape --relax-sweeps 10" "--size-near from=0.05" "--wall curve_*:first=0.01,layers=3"; do
    # shellcheck disable=SC2086  # several options
    quadrefine -q --order 4 $options sector_vase/*.blocks.h5 -o x.quad.h5
    stagecheck x.quad.h5
    repeats x.quad.h5 from to "$TURN" 0,0,0
  done
}

@test "formats in space have the motion, or say that they do not" {
  # shellcheck disable=SC2046
  meshed sector_cylinder $(names sector_cylinder) --periodic from=to
  for format in msh msh22 mfem mfem13 nektar; do
    run -0 quadexport sector_cylinder/*.quad.h5 --format $format -o $format.msh
    refute_output --partial periodic
  done
  run -0 python3 "$ROOT/tests/exports/check_periodic.py" msh.msh msh22.msh
  run -1 env PYTHONPATH="$ROOT/pipelines/python" /usr/bin/python3 -c \
    "import quadrille; quadrille.read('sector_cylinder/sector_cylinder.quad.h5').face.periodic_pairs[0].move([[0, 0]])"
  assert_output --partial "ValueError: the sides of a curved face repeat each other in space"
  run -0 quadexport sector_cylinder/*.quad.h5 -o x.vtu
  assert_output --partial 'that sides are periodic is not stored, their nodes are images of each other: "from" and "to"'
}

@test "sides that no motion maps onto each other are refused with the place and the distance" {
  cad2chart "$DATA/curved/sector_cone.step" --face 0 -o cone.chart.h5
  # shellcheck disable=SC2046
  run -3 cad2tri cone.chart.h5 $(names sector_cone) --name base@0.476,0.155,0 --periodic from=base -o x.tri.h5
  assert_output --regexp "the sides are not equal up to a motion: the point \(.*\) of '(from|base)' would be .* diameters\) away"
  # shellcheck disable=SC2046
  run -2 cad2tri cone.chart.h5 $(names sector_cone) --periodic from=to:rotate=36 -o x.tri.h5
  assert_output --partial "the motion of sides of a curved face is found from them: leave it out"
  cad2chart "$DATA/curved/tube.step" --face 0 -o tube.chart.h5
  run -2 cad2tri tube.chart.h5 --name low=0 --name high=1 --periodic low=high -o x.tri.h5
  assert_output --partial "are closed: sides of a curved face that have no ends are not supported; cut the shape"
  assert_file_not_exist x.tri.h5
}
