# Nektar++ XML and MFEM meshes, read by parsers of their own (tests/exports) and compared to the stage file.
load ../tools/common

setup_file() {
  stage_blocks "$BATS_FILE_TMPDIR" half_disc plate_hole l_shape small_fillets
}

setup() {
  common_setup
  compare=$ROOT/tests/exports/compare
  blocks=$BATS_FILE_TMPDIR
}

# exports NAME: x.xml, x.mesh, x13.mesh of x.quad.h5; then what the readers say of them.
exports() {
  quadexport -q "$1.quad.h5" -o "$1.xml"
  quadexport -q "$1.quad.h5" -o "$1.mesh"
  quadexport -q --format mfem13 "$1.quad.h5" -o "${1}13.mesh"
  run -0 "$compare" mfem "$1.mesh" "$1.quad.h5" mfem "${1}13.mesh" "$1.quad.h5"
  assert_output ''
  run -0 "$compare" --off 1e-10 nektar "$1.xml" "$1.quad.h5" # edges that are straight to 1e-10 of their length
  assert_output ''
}

@test "low and high orders: elements, names and counts of the stage file, in each of the formats" {
  for shape in half_disc plate_hole l_shape small_fillets; do
    orders='2 7'
    [[ $shape != half_disc ]] || orders='1 2 3 4 7'
    for order in $orders; do
      quadrefine -q --order $order --geometry-tol 1e-2 "$blocks/$shape.blocks.h5" -o a.quad.h5
      exports a
    done
  done
}

@test "the XML is well formed, and only elements that their sides do not tell have faces" {
  quadrefine -q --inner-edges curved "$blocks/plate_hole.blocks.h5" -o a.quad.h5
  quadexport a.quad.h5 -o a.xml
  run -0 xmllint --noout a.xml
  run -1 grep -c '<F ' a.xml
  assert_output 0
  quadrefine -q --inner-edges curved "$blocks/small_fillets.blocks.h5" -o b.quad.h5
  quadexport b.quad.h5 -o b.xml
  run -0 xmllint --noout b.xml
  assert [ "$(grep -c '<F ' b.xml)" -gt 50 ]
  sed -E '0,/<F /{/<F /s/(  \S+ \S+ 0){6}/&1/}' b.xml >c.xml # z of the seventh point, an inner one
  run -0 "$compare" --off 1e-10 nektar b.xml b.quad.h5
  run -1 "$compare" --off 1e-10 nektar c.xml b.quad.h5
}

@test "straight edges are not listed as curved" {
  # Their nodes differ from the chords by round-off, up to 1e-13 of the edges.
  "$ROOT/pipelines/quadmesh" -q "$DATA/hexagon.step" -o h.msh --workdir work
  mv work/*.quad.h5 h.quad.h5
  quadexport h.quad.h5 -o h.xml
  run -1 grep CURVED h.xml
  exports h
}

@test "order 20" {
  quadrefine -q --order 20 --size 2 "$blocks/half_disc.blocks.h5" -o a.quad.h5
  exports a
}

@test "awkward names arrive" {
  echo '{"0": "Wand & \"Boden\" <Süd>", "1": "back\\slash"}' >names.json
  cad2tri -q --boundary-names names.json "$DATA/half_disc.step" | fieldsolve -q | padapt -q -o a.field.h5
  critpoints -q a.field.h5 | separatrix -q a.field.h5 - | blocksplit -q | quadrefine -q -o a.quad.h5
  exports a
  run -0 jq -r '.boundaries[] | [.id, .name] | @csv' a.mesh.names.json
  assert_output '1,"Wand & ""Boden"" <Süd>"
2,"back\slash"'
}

@test "MFEM v1.0 says on stderr which names are in the table; the others are silent" {
  quadrefine -q "$blocks/half_disc.blocks.h5" -o a.quad.h5
  run -0 --separate-stderr quadexport a.quad.h5 -o a.mesh
  [[ $stderr == *"2 boundaries and 1 region"* ]]
  run -0 --separate-stderr quadexport --format mfem13 a.quad.h5 -o b.mesh
  assert_equal "$stderr" ""
  run -0 --separate-stderr quadexport a.quad.h5 -o a.xml
  assert_equal "$stderr" ""
  assert_nothing_left a.mesh a.mesh.names.json a.quad.h5 a.xml b.mesh
}

@test "--frame 3d: the coordinates of a plane that does not lie level" {
  sed -E "s/(CARTESIAN_POINT|DIRECTION)\('',\(([^,]+),([^,]+),([^)]+)\)\)/\1('',(\4,\2,\3))/" "$DATA/half_disc.step" >a.step
  cad2tri -q a.step | fieldsolve -q | padapt -q -o a.field.h5
  critpoints -q a.field.h5 | separatrix -q a.field.h5 - | blocksplit -q | quadrefine -q -o a.quad.h5
  quadexport -q --frame 3d a.quad.h5 -o a.xml
  quadexport -q --frame 3d a.quad.h5 -o a.mesh
  run -0 "$compare" --space mfem a.mesh a.quad.h5
  run -0 "$compare" --space --off 1e-10 nektar a.xml a.quad.h5
  run -0 grep -c 'SPACE="3"' a.xml
  run -0 grep -c '^VDim: 3$' a.mesh
  quadexport -q a.quad.h5 -o a.xml
  run -0 grep -c 'SPACE="2"' a.xml
}

@test "the readers see what is wrong: a node, a direction, a name, an edge, a curve that runs backwards" {
  quadrefine -q "$blocks/half_disc.blocks.h5" -o a.quad.h5
  quadexport -q a.quad.h5 -o a.xml
  quadexport -q --format mfem13 a.quad.h5 -o a.mesh
  spoilt() { # READER FILE SED-SCRIPT: the changed file differs from the other, and the reader says so
    sed -E "$3" "$2" >b
    run -1 cmp -s "$2" b
    run -1 "$compare" --off 1e-10 "$1" b a.quad.h5
  }
  spoilt nektar a.xml 's/(<V ID="2">)(\S+)/\10.1\2/'
  spoilt nektar a.xml 's/(<V ID="2">\S{8})/\11/'
  spoilt nektar a.xml 's/NAME="curve_1"/NAME="curve_0"/'
  spoilt nektar a.xml 's/NAME="domain"> Q\[0-/NAME="domain"> Q[1-/'
  spoilt nektar a.xml 's/(<Q ID="7">)(\S+) (\S+) (\S+) (\S+)</\1\3 \4 \5 \2</'
  spoilt nektar a.xml 's/(<E ID="5">)(\S+) (\S+)</\1\3 \2</'
  spoilt mfem a.mesh 's/^1 3 0 1 2 3$/1 3 1 2 3 0/'
  spoilt mfem a.mesh 's/^"domain" 1 1/"domain" 1 2/'
  spoilt mfem a.mesh '/^Ordering/,$ s/^(-?0\.[0-9]{8})/\11/'
  spoilt mfem a.mesh '/^boundary$/,/^bdr/ s/^2 1 (\S+) (\S+)$/2 1 \2 \1/'
  spoilt mfem a.mesh '/^mfem_mesh_end/d'
}

@test "eight shapes, one at each of the orders 1 to 8" {
  [[ -n ${QUADRILLE_LONG-} ]] || skip "long: part of tests/run --all"
  local order=0 shape
  for shape in annulus s_bend tilted_half_disc geometry_4 chamfered_plate_hole stadium geometry_5 quarter_annulus; do
    order=$((order + 1))
    blocks_of_size "$shape" 8
    quadrefine -q --order $order --size "$size" --geometry-tol 1e-2 "$shape.blocks.h5" -o a.quad.h5
    exports a
  done
}
