# Formats of low order, read by parsers of their own (tests/exports) and compared to the stage file: SU2, Abaqus, Exodus II,
# SPECFEM2D and PLOT3D with its neutral map.
load ../tools/common

setup_file() {
  stage_blocks "$BATS_FILE_TMPDIR" half_disc plate_hole s_bend
}

setup() {
  common_setup
  compare=$ROOT/tests/exports/compare
  grids=$ROOT/tests/exports/read_plot3d.py
  blocks=$BATS_FILE_TMPDIR
}

# linear: SU2 and PLOT3D of a.quad.h5, with merged blocks too; their points are the nodes to the last bit.
linear() {
  quadexport -q a.quad.h5 -o a.su2
  run -0 "$compare" --off 0 su2 a.su2 a.quad.h5
  assert_output ''
  for merge in '' --merge-blocks; do
    # shellcheck disable=SC2086  # an option or none
    quadexport -q $merge a.quad.h5 -o a.xyz
    run -0 "$grids" a.xyz a.quad.h5
    assert_output --regexp '^grids [0-9]+$'
  done
}

# quadratic: Abaqus and Exodus of a.quad.h5, of order 1 or 2.
quadratic() {
  quadexport -q --format abaqus a.quad.h5 -o a.inp --report a.json
  off=$(awk -v x="$(reported_loss a.json 'middle of elements')" 'BEGIN { print 1.1 * x + 1e-13 }')
  run -0 "$compare" --off "$off" abaqus a.inp a.quad.h5
  assert_output ''
  quadexport -q a.quad.h5 -o a.exo
  run -0 "$compare" --off 0 exodus a.exo a.quad.h5
  assert_output ''
  quadexport -q --format exodus-serendipity a.quad.h5 -o b.exo
  run -0 "$compare" --off "$off" exodus b.exo a.quad.h5
  assert_output ''
}

@test "elements, cells, names and counts of the stage file, in each of the formats" {
  for shape in half_disc plate_hole s_bend; do
    for order in 1 2 4 7; do
      quadrefine -q --order $order --geometry-tol 1e-2 "$blocks/$shape.blocks.h5" -o a.quad.h5
      linear
      ((order > 2)) || quadratic
    done
  done
}

@test "SPECFEM2D: elements, regions, free and absorbing sides" {
  cad2tri -q --name free=0 --name absorbing=1 "$DATA/half_disc.step" | fieldsolve -q | padapt -q -o a.field.h5
  critpoints -q a.field.h5 | separatrix -q a.field.h5 - | blocksplit -q -o a.blocks.h5
  for order in 1 2; do
    quadrefine -q --order $order --geometry-tol 1e-2 a.blocks.h5 -o a.quad.h5
    quadexport -q --format specfem2d a.quad.h5 -o a.mesh_file
    run -0 "$compare" --off 0 specfem a.mesh_file a.quad.h5
    assert_output ''
  done
  sed -i '2s/ 2 / 3 /' a.mesh_file.absorbing_surface
  run -1 "$compare" specfem a.mesh_file a.quad.h5
}

@test "awkward names arrive" {
  echo '{"0": "Wand \"Boden\" <Süd>", "1": "a name of more than thirty-two letters"}' >names.json
  cad2tri -q --boundary-names names.json "$DATA/half_disc.step" | fieldsolve -q | padapt -q -o a.field.h5
  critpoints -q a.field.h5 | separatrix -q a.field.h5 - | blocksplit -q | quadrefine -q --order 2 -o a.quad.h5
  linear
  quadratic
  run -0 jq -r '.boundaries[1].tag' a.exo.names.json
  assert_output 'a_name_of_more_than_thirty-two_l'
}

@test "--merge-blocks: a ring is two grids" {
  stage_blocks . annulus
  quadrefine -q --order 2 annulus.blocks.h5 -o a.quad.h5
  quadexport -q --merge-blocks a.quad.h5 -o a.xyz
  run -0 "$grids" a.xyz a.quad.h5
  assert_output 'grids 2'
  run -2 quadexport --merge-blocks "$blocks/half_disc.blocks.h5" -o a.step
  assert_output --partial '--merge-blocks: a STEP model is made from the blocks themselves'
}

@test "the ending .inp is Trixi.jl's, and the message names the format of Abaqus" {
  quadrefine -q --order 2 "$blocks/half_disc.blocks.h5" -o a.quad.h5
  run -0 quadexport a.quad.h5 -o a.inp
  assert_line 'quadexport: warning W-EXP-003: a.inp is written for Trixi.jl, as --format inp: for Abaqus and CalculiX give --format abaqus'
  cp a.inp b.inp
  run -0 quadexport --format inp a.quad.h5 -o a.inp
  refute_output --partial W-EXP-003
  cmp a.inp b.inp
}

@test "the readers see what is wrong" {
  quadrefine -q --order 2 --size 0.5 "$blocks/half_disc.blocks.h5" -o a.quad.h5
  linear
  quadratic
  # spoilt READER FILE SED: a change that the reader must notice
  spoilt() {
    sed -E "$3" "$2" >"b.${2##*.}"
    run ! cmp -s "$2" "b.${2##*.}"
    run -1 "$compare" --off 1e-6 "$1" "b.${2##*.}" a.quad.h5
  }
  spoilt su2 a.su2 '0,/^9 (\S+) (\S+) / s/^9 (\S+) (\S+) /9 \2 \1 /'
  spoilt su2 a.su2 's/^MARKER_TAG= curve_1/MARKER_TAG= curve_0/'
  spoilt su2 a.su2 '0,/^-1 /s/^-1 /-1.01 /'
  spoilt abaqus a.inp 's/^(1, -?[0-9.]+)/\11/'
  spoilt abaqus a.inp '0,/, S1$/s/, S1$/, S2/'
  spoilt abaqus a.inp 's/NAME=curve_1/NAME=curve_2/'
  cp a.xyz b.xyz
  sed -E '0,/ONE_TO_ONE (\S+) (\S+)/s/ONE_TO_ONE (\S+) (\S+)/curve_0 \1 \2/' a.nmf >b.nmf
  run -1 "$grids" b.xyz a.quad.h5
  sed -E 's/^curve_1/curve_0/' a.nmf >b.nmf
  run -1 "$grids" b.xyz a.quad.h5
}
