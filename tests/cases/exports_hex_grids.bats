# Structured grids of swept meshes: PLOT3D with its neutral map and CGNS, read by parsers of their own and compared to the
# stage file.
load ../tools/common

setup_file() {
  stage_blocks "$BATS_FILE_TMPDIR" half_disc plate_hole annulus
}

setup() {
  need_h5py
  common_setup
  blocks=$BATS_FILE_TMPDIR
  grids=$ROOT/tests/exports/read_hex_grids.py
}

# reads OPTION...: a.hex.h5 in both formats.
reads() {
  quadexport -q "$@" a.hex.h5 -o a.xyz
  quadexport -q "$@" --format cgns-structured a.hex.h5 -o a.cgns
  local file
  for file in a.xyz a.cgns; do
    run -0 /usr/bin/python3 "$grids" $file a.hex.h5
    assert_output --regexp '^grids [0-9]+$'
  done
}

@test "points, cells, connections and names of straight, twisted and revolved sweeps, orders 1 and 2" {
  local order motion
  for order in 1 2; do
    quadrefine -q --order $order --size 0.5 --geometry-tol 1 "$blocks/half_disc.blocks.h5" -o a.quad.h5
    for motion in "--height 0.5 --layers 2" "--height 1 --twist 40 --layers 3" "--one-layer" \
      "--revolve 60 --axis -9,0,-9,1 --layers 4" "--revolve 360 --axis -9,0,-9,1 --layers 12"; do
      # shellcheck disable=SC2086
      hexsweep -q a.quad.h5 $motion -o a.hex.h5
      reads
    done
    reads --merge-blocks
  done
  quadrefine -q --order 2 --geometry-tol 1 "$blocks/plate_hole.blocks.h5" -o a.quad.h5
  hexsweep -q a.quad.h5 --height 1 --twist 40 --layers 3 -o a.hex.h5
  reads
  reads --merge-blocks
}

@test "regions are families, and interfaces connections" {
  "$ROOT/pipelines/quadmesh" -q "$DATA/regions/disc_in_square.step" --order 2 -o a.msh --workdir stages
  hexsweep -q stages/*.quad.h5 --height 1 --layers 2 -o a.hex.h5
  reads
  reads --merge-blocks
}

@test "--merge-blocks: a swept ring is two grids; any format takes the option" {
  quadrefine -q --order 2 --geometry-tol 1 "$blocks/annulus.blocks.h5" -o a.quad.h5
  hexsweep -q a.quad.h5 --height 1 --layers 2 -o a.hex.h5
  reads --merge-blocks
  assert_output 'grids 2'
  quadexport -q --merge-blocks a.hex.h5 -o a.vtu
}

@test "the reader sees what is wrong" {
  quadrefine -q --order 1 --size 0.5 --geometry-tol 1 "$blocks/half_disc.blocks.h5" -o a.quad.h5
  hexsweep -q a.quad.h5 --height 1 --layers 2 -o a.hex.h5
  reads
  # spoilt ENDING SED: a change that the reader must notice
  spoilt() {
    cp a.xyz b.xyz
    cp a.nmf b.nmf
    sed -E -i "$2" "b.$1"
    run ! cmp -s "a.$1" "b.$1"
    run -1 /usr/bin/python3 "$grids" b.xyz a.hex.h5
  }
  spoilt nmf '0,/^curve_1/s/^curve_1/curve_0/'
  spoilt nmf 's/^(bottom 1 )1/\12/'
  spoilt nmf '0,/^ONE_TO_ONE/s/^(ONE_TO_ONE [0-9]+ [0-9]+) ([0-9]+) ([0-9]+) /\1 \3 \2 /'
  spoilt nmf '/^top 1 /d'
  spoilt xyz '0,/^-1 /s/^-1 /-1.01 /'
}
