# Meshes: the same for every edge that a loop begins with, and when the shape is mirrored, turned and moved.
load ../tools/common

# same_when_moved SHAPE
same_when_moved() {
  local name=$1 step=$DATA/$1.step
  mkdir original
  quadmesh -q "$step" -o original.msh --workdir original
  same_mesh_moved() {
    mkdir moved
    quadmesh -q moved.step -o moved.msh --workdir moved
    run -0 "$BATS_TEST_DIRNAME/same_corners.py" "$@" "original/$name.quad.h5" moved/moved.quad.h5 1e-6
    rm -r moved
  }
  each_motion "$step" same_mesh_moved <<END
--start 1
--start 3
--mirror
--rotate 37
--move 3.7 -11.3
END
}

@test "meshes with holes are the same when they move" { same_when_moved plate_4_holes; }
@test "meshes of many alike parts are the same when they move" { same_when_moved gear_filleted; }
@test "meshes with chosen counts are the same when they move" { same_when_moved notched_polygon; }
@test "meshes of few blocks are the same when they move" { same_when_moved chamfered_plate_hole; }
