# find_package(Quadrille): the installed library, used by a program outside the tree (tests/consumer).
load ../tools/common

setup_file() {
  [[ -f $BIN/../lib/program/libquadrille_files.a ]] || skip "built without QUADRILLE_LIBRARY"
  if nm "$BIN/../lib/program/libquadrille_files.a" 2>/dev/null | grep -q __asan_init; then skip "built with sanitizers"; fi
  cmake --install "$BIN/.." --prefix "$BATS_FILE_TMPDIR/usr" >"$BATS_FILE_TMPDIR/log"
  cp -r "$ROOT/tests/consumer" "$BATS_FILE_TMPDIR"
  cd "$BATS_FILE_TMPDIR/consumer" || return
  cmake -S . -B build -DCMAKE_PREFIX_PATH="$BATS_FILE_TMPDIR/usr" -DCMAKE_BUILD_TYPE=Release >>"$BATS_FILE_TMPDIR/log" &&
    cmake --build build >>"$BATS_FILE_TMPDIR/log" || return
  stage_chain half_disc "$BATS_FILE_TMPDIR"
  stage_chain eccentric_annulus "$BATS_FILE_TMPDIR"
}

setup() {
  common_setup
  files=$BATS_FILE_TMPDIR
  consumer=$files/consumer/build
}

# same_as_tools FILE: the library makes the files that the tools make of a CAD file, byte for byte, or fails with their
# exit code.
same_as_tools() {
  local status=0
  rm -f t.* a.*
  cad2tri -q "$1" -o t.tri.h5
  chain_of_tools || status=$?
  run -"$status" "$consumer/mesh_any_face" t.tri.h5 a.crit.json a.quad.h5
  ((status == 0)) || return 0
  assert_line --regexp '^[0-9]+ nodes, [0-9]+ quads, 0 broken rules$'
  cmp t.crit.json a.crit.json && cmp t.quad.h5 a.quad.h5 || fail "$1"
}

# chain_of_tools: from t.tri.h5 to t.quad.h5, with a field of their own for nodes that are no zeros.
chain_of_tools() {
  local field=t.field.h5
  fieldsolve -q t.tri.h5 | padapt -q -o $field && critpoints -q $field -o t.crit.json || return
  if [[ $(jq -r .form t.crit.json) == phase ]]; then
    field=t.phase.h5
    fieldsolve -q --nodes t.crit.json t.tri.h5 | padapt -q -o $field || return
  fi
  separatrix -q $field t.crit.json -o t.sep.json && blocksplit -q t.sep.json -o t.blocks.h5 &&
    quadrefine -q t.blocks.h5 -o t.quad.h5
}

@test "a short program makes the files that the tools make, byte for byte: faces of one region" {
  for shape in half_disc eccentric_annulus disc geometry_2 l_shape; do same_as_tools "$DATA/$shape.step"; done
}

@test "the same: faces of several regions, with slits and periodic sides" {
  for file in "$DATA"/regions/*.step; do same_as_tools "$file"; done
}

@test "the quantized layout is computed, with CBC" {
  run -0 "$consumer/mesh_face" "$files/eccentric_annulus.tri.h5" a.crit.json a.quad.h5 quantized
  assert_line --regexp ' 0 broken rules$'
}

@test "values of the field are those of the Python package" {
  need_h5py
  run -0 "$consumer/mesh_face" "$files/half_disc.tri.h5" crit.json quad.h5
  assert_equal "${#lines[@]}" 3 # the third point lies outside
  PYTHONPATH=$ROOT/pipelines/python run -0 /usr/bin/python3 -B -c "
import numpy, quadrille
value = quadrille.read('$files/half_disc.field.h5').value([[0.1, 0.2], [0.4, 0.3]])
numpy.testing.assert_allclose(value, [[float(x) for x in line.split()] for line in ('${lines[0]}', '${lines[1]}')], 1e-12)"
}

@test "errors are thrown with the tools' messages and exit codes" {
  echo '{}' >broken
  run -3 "$consumer/mesh_face" broken a b
  assert_output --partial broken
  run -4 "$consumer/mesh_face" "$files/half_disc.tri.h5" no/such/folder b
}

@test "only the component of triangles contains CGAL" {
  for name in files fields layouts; do
    assert [ "$(nm -C "$files/usr/lib/libquadrille_$name.a" 2>/dev/null | grep -c CGAL::)" -eq 0 ]
  done
  assert [ "$(nm -C "$consumer/mesh_face" | grep -c CGAL::)" -eq 0 ]
  assert [ "$(nm -C "$files/usr/lib/libquadrille_triangles.a" 2>/dev/null | grep -c CGAL::)" -gt 0 ]
  run -0 "$consumer/triangulate_face" "$files/half_disc.blocks.h5" again.tri.h5
  run -0 stagecheck again.tri.h5
  h5diff --exclude-attribute / --exclude-path /repairs "$files/half_disc.tri.h5" again.tri.h5
}

@test "an unknown component is refused by name, an absent one is no error if it is optional" {
  printf '%s\n' 'cmake_minimum_required(VERSION 3.25)' 'project(p LANGUAGES CXX)' \
    'find_package(Quadrille OPTIONAL_COMPONENTS sounds)' 'message(STATUS "found ${Quadrille_FOUND}")' \
    'find_package(Quadrille REQUIRED COMPONENTS sounds)' >CMakeLists.txt
  run -1 cmake -S . -B b -DCMAKE_PREFIX_PATH="$files/usr"
  assert_line --regexp 'found (1|TRUE)'
  assert_output --partial 'Quadrille has no component sounds'
}
