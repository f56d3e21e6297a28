# The Python module for stage files (pipelines/python): its unit tests, and its results against files of the tools.
load ../tools/common

python=$ROOT/pipelines/python

setup_file() {
  need_h5py
  for shape in half_disc plate_hole slanted_l; do
    stage_chain $shape "$BATS_FILE_TMPDIR"
    fieldsolve --nodes "$BATS_FILE_TMPDIR/$shape.crit.json" "$BATS_FILE_TMPDIR/$shape.tri.h5" |
      padapt -o "$BATS_FILE_TMPDIR/$shape.phase.h5"
  done
}

setup() {
  common_setup
  files=$BATS_FILE_TMPDIR
  export PYTHONPATH=$python CHAINS=$files QUADRILLE_BIN=$BIN
}

# passes PATTERN: the unit tests in the files of this name pass, and there are some.
passes() {
  run -0 /usr/bin/python3 -m unittest discover -s "$ROOT/tests/unit/python" -p "$1_test.py"
  assert_line --regexp '^Ran [1-9][0-9]* tests? in '
}

@test "polynomials, splines, and the sample files of every format and version" {
  passes reference
  passes face
  passes samples
}

@test "the formats are those of the tools, with their major versions" {
  stagecheck --list-formats >formats.json
  run -0 /usr/bin/python3 -c "
import json
from quadrille.stage_file import MAJOR_VERSIONS
formats = json.load(open('formats.json'))['formats']
assert MAJOR_VERSIONS == {row['name']: row['version'][0] for row in formats}, MAJOR_VERSIONS"
}

@test "tables of sizes from the points and cells of a VTU file" {
  passes vtu_sizes
}

@test "keywords are the options of the tools" {
  passes tool_words
}

@test "the chain in Python: bytes of the tools, exceptions, warnings, nothing left behind" {
  XDG_CACHE_HOME=$PWD/cache passes stages
}

@test "the three cases of the tutorial from a notebook" {
  cp -r "$ROOT/pipelines/examples" work && cd work
  left_out=()
  command -v simpleFoam >/dev/null || left_out+=(openfoam)
  /usr/bin/python3 -c 'import dolfinx, gmsh' 2>/dev/null || left_out+=(dolfinx)
  XDG_CACHE_HOME=$PWD/cache run -0 --separate-stderr /usr/bin/python3 "$ROOT/tests/cases/run_notebook.py" \
    "$python/examples/tutorial.ipynb" "${left_out[@]}"
  assert_line --regexp '^<QuadMesh: 12 blocks, 4 irregular nodes, 6191 quads, '
  assert_line --regexp '^<QuadMesh: 4 blocks, 0 irregular nodes, 308 quads, '
  assert_line --regexp '^<QuadMesh: 18 blocks, 3 irregular nodes, [0-9]+ quads, '
  assert_equal "$(grep -c '^svg of [0-9]* bytes$' <<<"$output")" 3
  assert_file_not_empty channel/system/blockMeshDict
  assert_file_not_empty aerofoil/system/blockMeshDict
  [[ " ${left_out[*]} " == *openfoam* ]] || assert_line --regexp '^drag 5\.5[67][0-9], lift 0\.01[01][0-9]$'
  [[ " ${left_out[*]} " == *dolfinx* ]] || assert_line --regexp ' relative error [1-9]\.[0-9]e-0[89]$'
}

@test "fields, blocks and quads agree with what the tools wrote" {
  passes chain
}

@test "positions include the origin of a face far from that of the model" {
  "$DATA/move_step.py" --move 5000 300 "$DATA/half_disc.step" moved.step
  cad2tri moved.step -o a.tri.h5
  fieldsolve a.tri.h5 | padapt -o a.field.h5
  critpoints a.field.h5 -o a.crit.json
  run -0 /usr/bin/python3 -c "
import numpy, quadrille
field, points = quadrille.read('a.field.h5'), quadrille.read('a.crit.json')
assert abs(field.face.origin).max() > 0
numpy.testing.assert_allclose(field.value(points.positions), 0, atol=1e-9)
former = quadrille.read('$files/half_disc.crit.json')
numpy.testing.assert_allclose(points.positions - [5000, 300], former.positions, atol=1e-6)"
}

@test "the example of crosses prints the angle at each point, nan outside" {
  run -0 "$python/examples/cross_directions" "$files/half_disc.field.h5" <<<$'0 0.5\n0 0.01\n9 9'
  assert_line --index 0 --regexp '^0 0.5 -?0\.00000[0-9]$'
  assert_line --index 1 --regexp '^0 0.01 -?0\.00000[0-9]$'
  assert_line --index 2 "9 9 nan"
}

@test "the example of blocks prints the least scaled Jacobian that blocksplit reports" {
  blocksplit "$files/plate_hole.sep.json" -o /dev/null --report report.json
  run -0 "$python/examples/block_quality" "$files/plate_hole.blocks.h5"
  assert_equal "${#lines[@]}" "$((1 + $(jq .blocks report.json)))"
  read -r _ name least _ <<<"${lines[1]}"
  assert_equal "$name $least" "$(jq -r .least_scaled_jacobian_block report.json) $(
    printf '%.6f' "$(jq .least_scaled_jacobian report.json)")"
}

@test "the example of nodes draws a picture" {
  /usr/bin/python3 -c 'import matplotlib' || skip "no matplotlib: apt-get install python3-matplotlib"
  MPLCONFIGDIR=$PWD run -0 "$python/examples/plot_nodes" "$files/half_disc."{field.h5,crit.json} nodes.png
  assert_equal "$(head -c 4 nodes.png | tail -c 3)" PNG
}

@test "the examples of the page run" {
  cp "$DATA/half_disc.step" .
  cp "$files"/half_disc.{field,blocks,quad}.h5 "$files"/half_disc.{crit,sep}.json .
  ln -s "$ROOT/tests" tests
  sed -n '/^    >>> /,/^$/p' "$python/README.md" | sed 's/^    //' >examples
  assert [ "$(grep -c '^>>> ' examples)" -gt 15 ]
  run -0 /usr/bin/python3 -c 'import doctest, sys; sys.exit(doctest.testfile("examples", module_relative=False).failed)'
}

@test "every module is named on the page and has at most 350 lines" {
  for file in "$python"/quadrille/[a-z]*.py; do
    grep -qF "\`$(basename "$file")\`" "$python/README.md" || fail "$file is not on the page"
    assert [ "$(wc -l <"$file")" -le 350 ]
  done
}
