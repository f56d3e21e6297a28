# hexsweep on whole shapes: every element is proved, and volumes are those of the exact bodies.
load ../tools/common

setup_file() {
  stage_blocks "$BATS_FILE_TMPDIR" half_disc plate_hole s_bend
}

setup() {
  common_setup
  blocks=$BATS_FILE_TMPDIR
}

# deviation MOTION...: of the volume of a.hex.h5 from the exact one, without its sign.
deviation() {
  /usr/bin/python3 "$ROOT/tests/exports/sweep_volume.py" a.hex.h5 a.quad.h5 "$@" | sed 's/^-//'
}

@test "straight sweeps: the volume is area times height, at every order" {
  for shape in half_disc plate_hole s_bend; do
    for order in 1 2 4 6; do
      quadrefine -q "$blocks/$shape.blocks.h5" --order $order -o a.quad.h5
      hexsweep a.quad.h5 --height 0.3 --layers 3 -o a.hex.h5
      run deviation straight 0.3
      assert [ "$(jq -n "$output < 1e-12")" = true ]
    done
  done
}

@test "revolved sweeps: the volume is that of Pappus, which twice the layers approach at the order's rate" {
  for order in 1 2 3; do
    quadrefine -q "$blocks/plate_hole.blocks.h5" --order $order -o a.quad.h5
    errors=()
    for layers in 3 6; do
      hexsweep a.quad.h5 --revolve 90 --axis=-5,0,-5,1 --layers $layers -o a.hex.h5
      errors+=("$(deviation revolved 90 -5)")
    done
    run jq -n "(${errors[0]} / ${errors[1]} | log2) > $order + 0.9"
    assert_output true
  done
  quadrefine -q "$blocks/plate_hole.blocks.h5" --order 6 -o a.quad.h5
  hexsweep a.quad.h5 --revolve 90 --axis=-5,0,-5,1 --layers 6 -o a.hex.h5
  assert [ "$(jq -n "$(deviation revolved 90 -5) < 1e-9")" = true ]
}

@test "twisted and revolved, every order is proved valid, and the proof is repeated by stagecheck" {
  for shape in half_disc plate_hole s_bend; do
    for order in 1 3 5; do
      quadrefine -q "$blocks/$shape.blocks.h5" --order $order -o a.quad.h5
      for motion in "--height 1 --twist 60" "--revolve 90 --axis=-20,0,-20,1"; do
        hexsweep a.quad.h5 $motion --layers 6 -o a.hex.h5
        stagecheck a.hex.h5
      done
    done
  done
}

@test "regions stay regions, interfaces are named from both sides, periodic sides stay periodic" {
  "$ROOT/pipelines/quadmesh" -q "$DATA/regions/chequerboard_4_hole.step" --until quadrefine --workdir .
  hexsweep chequerboard_4_hole.quad.h5 --layers 2 -o a.hex.h5
  stagecheck a.hex.h5
  run -0 h5dump -A 0 -d /region_names a.hex.h5
  assert_output --partial '"black", "white"'
  run -0 h5dump -A 0 -d /face_groups/name a.hex.h5
  assert_output --partial '"black-white"'
  "$ROOT/pipelines/quadmesh" -q "$DATA/square.step" --until quadrefine --workdir . --periodic curve_1=curve_3
  hexsweep square.quad.h5 --layers 2 -o b.hex.h5
  stagecheck b.hex.h5
  h5dump -d /face_groups/periodic_with b.hex.h5 | grep -qE ' [0-9]+,|, [0-9]'
  run -0 hexsweep square.quad.h5 --height 1 --twist 20 --layers 2 -o c.hex.h5
  assert_output --partial "warning W-HEX-001"
}

@test "a curved face is swept along a vector and revolved in space, not along a normal" {
  "$ROOT/pipelines/quadmesh" -q "$DATA/curved/saddle.step" --face 0 --until quadrefine --workdir .
  hexsweep saddle.quad.h5 --along 0,0,0.5 --layers 2 -o a.hex.h5
  stagecheck a.hex.h5
  hexsweep saddle.quad.h5 --revolve 30 --axis=-9,0,0,-9,1,0 --layers 3 -o b.hex.h5
  stagecheck b.hex.h5
  run -2 hexsweep saddle.quad.h5 --height 1 -o c.hex.h5
  assert_output --partial "give --along X,Y,Z"
}

@test "quadmesh --sweep gives the bytes of the single commands, from a file of --workdir too, and a page" {
  quadmesh=$ROOT/pipelines/quadmesh
  options="--height 0.5 --layers 2 --twist 20"
  run -0 "$quadmesh" "$DATA/half_disc.step" --size 0.4 --sweep $options --workdir stages --html page.html --report r.json \
    -o out.msh
  assert_output --regexp '^4 blocks, .* [0-9]+ hexahedra, worst scaled Jacobian 0\.[0-9]+; (good|usable: .*|poor: .*)$'
  hexsweep $options stages/half_disc.quad.h5 -o half_disc.hex.h5
  cmp half_disc.hex.h5 stages/half_disc.hex.h5
  quadexport half_disc.hex.h5 -o again.msh
  cmp out.msh again.msh
  assert_equal "$(jq .sweep.hexahedra r.json)" $((2 * $(jq .quads r.json)))
  grep -qF 'half_disc.hex.h5' page.html
  "$quadmesh" -q "$DATA/half_disc.step" --size 0.4 --sweep $options -o memory.msh
  cmp out.msh memory.msh
  "$quadmesh" -q --from hexsweep --workdir stages --sweep $options -o from.msh
  cmp out.msh from.msh
  "$quadmesh" "$DATA/half_disc.step" --size 0.4 --sweep $options --dry-run --workdir stages -o dry.msh >commands
  grep -qxF "hexsweep stages/half_disc.quad.h5 $options -o stages/half_disc.hex.h5" commands
}

@test "quadmesh --sweep: what cannot be swept, or is not, is refused before any work" {
  quadmesh=$ROOT/pipelines/quadmesh
  refused() {
    run "$quadmesh" "$DATA/half_disc.step" "${@:2}"
    assert_failure 2
    assert_output --partial "$1"
  }
  refused '--twist is an option of hexsweep: give --sweep too' --twist 20 -o out.msh
  refused 'the format ism-v2 has no hexahedra: choose one of msh' --sweep -o out.ism
  refused '--sweep: a STEP model is made from blocks' --sweep -o out.step
  refused 'supports hexahedra up to order 9' --sweep --order 10 -o out.msh
  refused 'the stage hexsweep runs with --sweep only' --until hexsweep --workdir . -o out.msh
  refused '--revolve' --sweep --revolve 90 --height 1 -o out.msh
  assert_nothing_left
}
