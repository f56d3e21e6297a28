# Hexahedra in the formats of solvers: parsers of their own (tests/exports) compare volumes of regions and areas of
# named groups to the stage file, and programs that are installed read them.
load ../tools/common

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
}

setup() {
  need_h5py
  common_setup
  quads=$BATS_FILE_TMPDIR/half_disc.quad.h5
  compare=$ROOT/tests/exports/compare_hexes
}

# reads NAME FORMAT...: writes NAME.hex.h5 in each of the formats and compares.
reads() {
  local format ending words=()
  for format in "${@:2}"; do
    case $format in mfem*) ending=mesh ;; nektar) ending=xml ;; *) ending=$format ;; esac
    quadexport -q --format "$format" "$1.hex.h5" -o "$1.$format.$ending"
    words+=("${format%13}" "$1.$format.$ending" "$1.hex.h5")
  done
  run "$compare" "${words[@]}"
  assert_output ''
  assert_success
}

@test "straight, twisted and revolved sweeps: volumes and areas of the stage file in each of the formats" {
  local motion
  for motion in "--height 0.5 --layers 2" "--height 1 --twist 40 --layers 3" \
    "--revolve 60 --axis -3,0,-3,1 --layers 4" "--revolve 360 --axis -3,0,-3,1 --layers 12"; do
    # shellcheck disable=SC2086
    hexsweep -q "$quads" $motion -o a.hex.h5
    reads a nektar mfem mfem13 re2 inp su2 cgns
  done
}

@test "orders 1 to 3, and periodic ends" {
  local order
  for order in 1 2 3; do
    quadrefine -q --order "$order" --geometry-tol 1 "$BATS_FILE_TMPDIR/half_disc.blocks.h5" -o b.quad.h5
    hexsweep -q b.quad.h5 --height 0.5 --layers 3 -o b.hex.h5
    reads b nektar mfem mfem13 re2 inp su2 cgns
  done
  hexsweep -q b.quad.h5 --one-layer -o b.hex.h5
  reads b nektar mfem re2 inp su2 cgns
}

@test "Exodus, of orders 1 and 2, with and without nodes inside elements" {
  local order kind
  for order in 1 2; do
    quadrefine -q --order "$order" --geometry-tol 1 "$BATS_FILE_TMPDIR/half_disc.blocks.h5" -o b.quad.h5
    hexsweep -q b.quad.h5 --height 1 --twist 40 --layers 3 -o b.hex.h5
    for kind in exodus exodus-serendipity; do
      quadexport -q --format $kind b.hex.h5 -o b.exo
      run -0 "$compare" $kind b.exo b.hex.h5
      assert_output ''
    done
  done
  quadexport -q --scale 1.001 b.hex.h5 -o b.exo
  run -1 "$compare" exodus b.exo b.hex.h5
  quadexport -q b.hex.h5 -o b.exo
  run -1 "$compare" exodus-serendipity b.exo b.hex.h5
}

@test "Gmsh reads every order that it knows, with positive Jacobians" {
  command -v gmsh >/dev/null || skip "no gmsh"
  local order version
  echo 'Merge "c.msh"; Plugin(AnalyseMeshQuality).JacobianDeterminant = 1; Plugin(AnalyseMeshQuality).Run;' >check.geo
  for order in 1 2 3 4; do
    quadrefine -q --order "$order" --geometry-tol 1 "$BATS_FILE_TMPDIR/half_disc.blocks.h5" -o c.quad.h5
    hexsweep -q c.quad.h5 --height 0.5 --twist 20 --layers 2 -o c.hex.h5
    for version in msh msh22; do
      quadexport -q --format $version c.hex.h5 -o c.msh
      run -0 gmsh check.geo -parse_and_exit
      refute_output --regexp 'minJ/maxJ.*min *= *-'
      refute_output --partial Error
      refute_output --partial Warning
    done
  done
}

@test "the bytes are those through pipes, and a format without hexahedra is refused with those that have them" {
  hexsweep -q "$quads" --height 0.5 -o a.hex.h5
  quadexport -q a.hex.h5 -o a.vtu
  assert_file_exist a.faces.vtu
  quadexport -q --format vtu <a.hex.h5 >b.vtu
  cmp a.vtu b.vtu
  run -2 quadexport a.hex.h5 -o a.ism
  assert_output --partial 'the format ism-v2 has no hexahedra: choose one of msh,'
  run -2 quadexport --frame 3d a.hex.h5 -o a.msh
  assert_output --partial 'omit it'
  assert_file_not_exist a.ism
}

@test "the readers see what is wrong" {
  hexsweep -q "$quads" --height 0.5 --layers 2 -o a.hex.h5
  reads a su2
  # spoilt SED: a change that the reader must notice
  spoilt() {
    sed -E "$1" a.su2.su2 >b.su2
    run ! cmp -s a.su2.su2 b.su2
    run -1 "$compare" su2 b.su2 a.hex.h5
  }
  spoilt '0,/^12 (\S+) (\S+) / s/^12 (\S+) (\S+) /12 \2 \1 /'
  spoilt '0,/^9 (\S+) (\S+) / s/^9 (\S+) (\S+) /9 \2 \1 /'
  spoilt 's/^MARKER_TAG= curve_1/MARKER_TAG= curve_0/'
  spoilt '0,/^-1 /s/^-1 /-1.01 /'
}
