# cmake --install: commands that work where they land, their manual pages and the pages of the formats.
load ../tools/common

setup_file() {
  [[ -f $BIN/../cmake_install.cmake ]] || skip "the tools are not in a build folder"
  cmake --install "$BIN/.." --prefix "$BATS_FILE_TMPDIR/usr" >"$BATS_FILE_TMPDIR/log"
}

setup() {
  common_setup
  usr=$BATS_FILE_TMPDIR/usr
}

@test "quadmesh, the readers of CAD files and the STEP writer find their programs beside themselves" {
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin "$usr/bin/quadmesh" "$DATA/square.step" -o out.msh --workdir .
  assert_output --regexp '^1 block, .*'
  run -0 "$usr/bin/quadexport" square.blocks.h5 -o square.blocks.step
  run -0 "$usr/bin/cad2tri" square.blocks.step -o again.tri.h5
  run -0 "$usr/bin/cad2tri" "$DATA/bad/half_disc_inches.iges" -o iges.tri.h5
  run -0 "$usr/bin/cad2tri" "$DATA/bad/rectangle.brep" -o brep.tri.h5
  run -0 env PATH=/usr/bin:/bin "$usr/bin/quadmesh" --version
}

@test "the installed Makefile.example finds the installed tools" {
  cp "$DATA/half_disc.step" "$DATA/bad/half_disc_inches.iges" .
  run -0 env -u BIN PATH=/usr/bin:/bin make -s -f "$usr/share/doc/quadrille/Makefile.example" half_disc.msh half_disc_inches.vtu
  run -0 env -u BIN PATH=/usr/bin:/bin make -f "$usr/share/doc/quadrille/Makefile.example" half_disc.msh
  assert_output ''
}

@test "the installed quadmesh runs a part of the chain, and answers wrong usage with the nearest option" {
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin "$usr/bin/quadmesh" "$DATA/square.step" --workdir w --until critpoints
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin "$usr/bin/quadmesh" --workdir w --from separatrix -o out.msh
  run -2 env -u QUADRILLE_BIN PATH=/usr/bin:/bin "$usr/bin/quadmesh" --verbos
  assert_line "quadmesh: unknown option --verbos: did you mean --verbose?"
  run -2 env -u QUADRILLE_BIN PATH=/usr/bin:/bin "$usr/bin/quadplace" --verbos
  assert_line "quadplace: unknown option --verbos: did you mean --verbose?"
}

@test "the folder may be moved, and a link to a command is the command" {
  cp -r "$usr" moved
  ln -s moved/bin/quadmesh mesh
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin ./mesh "$DATA/square.step" -o out.msh
  assert_output --regexp '^1 block, .*'
  printf '0 0\n1 0\n0 1\n' >points
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin moved/bin/points2step points -o triangle.step
  "$ROOT/pipelines/points2step" points | cmp - triangle.step
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin moved/bin/quadplace -q "$DATA/square.step" -o placed.msh
  cmp placed.msh out.msh
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin moved/bin/quadgallery -q --to gallery
  assert_file_exists gallery/gallery.html
  command -v parallel || skip "no GNU parallel"
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin moved/bin/quadbatch "$DATA/square.step" --to batch
  cmp batch/square.msh out.msh
}

@test "every command has a manual page that renders without a warning and ends with its examples and SEE ALSO" {
  command -v groff || skip "no groff"
  assert_equal "$(ls "$usr/share/man/man1" | sed 's/\.1$//')" "$(ls "$usr/bin")"
  for page in "$usr"/share/man/man1/*.1 "$usr/share/man/man7/quadrille.7"; do
    run -0 --separate-stderr groff -man -ww -Tascii "$page"
    assert_equal "$stderr" ""
    assert_equal "$(grep '^\.SH' "$page" | tail -1)" ".SH SEE ALSO"
  done
  for page in "$usr"/share/man/man1/*.1; do
    assert_equal "$(grep '^\.SH' "$page" | tail -3 | tr '\n' ' ')" ".SH ENVIRONMENT .SH EXAMPLES .SH SEE ALSO "
    assert_equal "$(sed -n '/^\.EX$/,/^\.EE$/p' "$page" | sed '1d;$d; s/\\-/-/g; s/\\e/\\/g')" \
      "$("$usr/bin/$(basename "$page" .1)" --help-all | sed '1,/^EXAMPLES$/d; s/^  //')"
  done
}

@test "SEE ALSO names manual pages that exist, and quadrille(7) all commands" {
  for page in "$usr"/share/man/man*/*; do
    sed '1,/^\.SH SEE ALSO/d' "$page" | sed -nE 's/^\.BR ([a-z0-9]+) \(([17])\),?$/\1.\2/p' >names
    assert_file_not_empty names
    while read -r name; do assert_file_exists "$usr/share/man/man${name##*.}/$name"; done <names
  done
  for command in "$usr"/bin/*; do
    run -0 grep -E "^\.(B|BR) ${command##*/}( |\$)" "$usr/share/man/man7/quadrille.7"
  done
}

@test "ENVIRONMENT names the variables that quadmesh and the scripts read" {
  for command in "$usr"/bin/*; do
    page=$usr/share/man/man1/${command##*/}.1
    run -0 grep -A1 '^\.SH ENVIRONMENT' "$page"
    case $(head -c 2 "$command"):${command##*/} in
      '#!':* | *:quadmesh) refute_output --partial None ;;
      *) assert_output --partial None ;;
    esac
  done
  run -0 grep -rohE 'getenv\([^)]*\)' "$ROOT/lib" "$ROOT/tools" --include='*pp'
  assert_output 'getenv("TMPDIR")'
  run -0 bash -c 'grep -rohE "environ\.get\(\"[A-Z_]+\"\)" "$1" | sort -u' - "$ROOT/pipelines"
  assert_output 'environ.get("QUADRILLE_BIN")'
  for name in quadmesh:TMPDIR quadplace:QUADRILLE_BIN quadplace:TMPDIR quadbatch:TMPDIR; do
    run -0 grep -l "^${name#*:}$" "$usr/share/man/man1/${name%:*}.1" "$usr/share/man/man7/quadrille.7"
  done
  QUADRILLE_BIN=$PWD/none TMPDIR=$PWD/no/folder run -4 "$usr/bin/quadmesh" "$DATA/square.step" -o a.msh
}

@test "man finds the pages" {
  command -v man || skip "no man"
  for name in quadmesh cad2tri quadrille; do
    MANPATH=$usr/share/man run -0 man -w $name
    assert_output --partial "$usr/share/man"
  done
}

@test "the pages of the formats and their schemas are in share/doc" {
  for file in "$ROOT"/formats/*.md "$ROOT"/formats/*.json; do
    cmp "$file" "$usr/share/doc/quadrille/formats/${file##*/}"
  done
  assert_file_exists "$usr/share/doc/quadrille/LICENSE"
}

@test "the Python package is installed, reads files, and meshes by the tools beside it" {
  need_h5py
  "$usr/bin/cad2tri" "$DATA/square.step" -o a.tri.h5
  export PYTHONPATH=$usr/lib/python3/dist-packages
  run -0 /usr/bin/python3 -c 'import quadrille; print(quadrille.read("a.tri.h5").locate([[0.2, 0.3], [2, 2]])[0][1])'
  assert_output -1
  run -0 env -u QUADRILLE_BIN PATH=/usr/bin:/bin /usr/bin/python3 -c "
import quadrille.tool_errors
print(quadrille.tool_errors.tool_path('quadmesh'), quadrille.mesh('$DATA/square.step', size=0.5).num_elements)"
  assert_output --regexp "^$usr/bin/quadmesh [0-9]+\$"
  assert_file_executable "$usr/share/doc/quadrille/pipelines/python/examples/plot_nodes"
}

@test "links of the installed README, of the method and of the formats lead to installed pages" {
  cd "$usr/share/doc/quadrille"
  run -0 python3 "$ROOT/tests/pages.py" "$PWD" links README.md lib/method.md formats/*.md formats/export/*.md \
    pipelines/python/README.md
  assert_output ''
  mv lib/method.md moved
  run -1 python3 "$ROOT/tests/pages.py" "$PWD" links formats/glossary.md
  assert_output --partial 'leads nowhere'
  mv moved lib/method.md
}
