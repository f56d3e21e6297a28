# What the README shows works as it stands there.
load ../tools/common

@test "the worked example gives what it shows" {
  ln -s "$ROOT/tests" .
  mkdir build && ln -s "$BIN" build/bin
  sed -n '/^## Step by step/,/^## /p' "$ROOT/README.md" >section
  sed -nE 's/^    \$ (.*)/\1/p' section >commands
  sed -nE '/^    \$/d; s/^    (.*)/\1/p' section >expected
  assert [ "$(wc -l <commands)" -ge 8 ]
  run -0 bash -euo pipefail commands
  assert_output "$(cat expected)"
  assert_file_not_empty d.msh
  assert_file_not_empty d.field.svg
}

@test "the commands that mesh one shape and many work" {
  ln -s "$ROOT/pipelines" .
  cp "$DATA/half_disc.step" shape.step
  mkdir shapes && cp "$DATA/square.step" shapes
  for section in "One command" "Many shapes"; do
    [[ $section != Many* ]] || command -v parallel || skip "no GNU parallel"
    sed -n "/^## $section/,/^## /p" "$ROOT/README.md" | sed -nE 's/^    (.*)/\1/p' >commands
    assert [ "$(wc -l <commands)" -eq 1 ]
    run -0 bash -euo pipefail commands
  done
  for file in shape.msh meshes/square.msh meshes/table.html; do assert_file_exists "$file"; done
}

@test "the commands of curved faces work" {
  ln -s "$ROOT/pipelines" "$ROOT/tests" .
  mkdir build && ln -s "$BIN" build/bin
  sed -n '/^## Curved faces/,/^## /p' "$ROOT/README.md" | sed -nE 's/^    (.*)/\1/p' >commands
  assert [ "$(wc -l <commands)" -eq 3 ]
  run -0 bash -euo pipefail commands
  for file in torus_patch.msh torus_patch.blocks.step torus_patch.svg; do assert_file_exists "$file"; done
}

@test "the commands of hexahedra work" {
  ln -s "$ROOT/pipelines" "$ROOT/tests" .
  mkdir build && ln -s "$BIN" build/bin
  sed -n '/^## Hexahedra/,/^## /p' "$ROOT/README.md" | sed -nE 's/^    (.*)/\1/p' >commands
  assert [ "$(wc -l <commands)" -eq 4 ]
  run -0 bash -euo pipefail commands
  for file in twisted.msh bend.vtu plate.re2 twisted.svg; do assert_file_exists "$file"; done
}

@test "the lines of Python work" {
  need_h5py
  ln -s "$ROOT/tests" .
  sed -n '/^## In a program/,/^## /p' "$ROOT/README.md" | sed -nE 's/^    (.*)/\1/p' >lines.py
  assert [ "$(wc -l <lines.py)" -eq 10 ]
  QUADRILLE_BIN=$BIN PYTHONPATH=$ROOT/pipelines/python run -0 /usr/bin/python3 -W error lines.py
  assert_line --index 0 --regexp '^<QuadMesh: [0-9]+ blocks, .*> \([0-9]+, 2\) \([0-9]+, 16\)$'
  assert_line --index 1 --regexp '^0\.[0-9]+$'
  run -0 stagecheck plate.quad.h5
  assert_file_not_empty plate.xml
}

@test "the sections whose commands are run above are all that have commands, but for the set-up" {
  run -0 awk '/^## / { heading = substr($0, 4) } /^    [^ ]/ && !seen[heading]++ { print heading }' "$ROOT/README.md"
  assert_output "$(printf '%s\n' Set-up 'One command' 'Curved faces' Hexahedra 'Many shapes' 'Step by step' \
    'In a program')"
}

@test "every file that it links is there" {
  grep -oE '\]\([^):]+\)' "$ROOT/README.md" | tr -d '])(' | sort -u >links
  assert [ "$(wc -l <links)" -ge 7 ]
  while read -r link; do assert_file_exists "$ROOT/$link"; done <links
}

@test "the table of tools names every tool and no other" {
  run -0 diff <(sed -nE 's/^\| `([a-z0-9]+)` \|.*/\1/p' "$ROOT/README.md" | sort) \
    <(find "$ROOT/tools/" -name '*.cpp' ! -name '*-*' -exec basename {} .cpp \; | sort)
}

@test "every format of the solvers' table is written" {
  "$ROOT/pipelines/quadmesh" -q "$DATA/half_disc.step" --workdir . -o x.msh
  mkdir system
  sed -n '/^## Into your solver/,/^## /p' "$ROOT/README.md" >section
  for name in $(grep -oE '`(x\.[a-z]+|system/blockMeshDict)`' section | tr -d '`' | sort -u); do
    case $name in
      x.quad.h5 | x.blocks.h5) ;;
      x.step) run -0 quadexport half_disc.blocks.h5 -o x.step && assert_file_not_empty x.step ;;
      *) run -0 quadexport half_disc.quad.h5 -o "$name" && assert_file_not_empty "$name" ;;
    esac
  done
  for name in $(grep -oE -- '--format [a-z0-9-]+' section | sed 's/.* //'); do
    run -0 quadexport half_disc.quad.h5 --format "$name" -o x.any && assert_file_not_empty x.any
  done
}

@test "every option of the table by problem is one of quadmesh, and the page is short" {
  "$ROOT/pipelines/quadmesh" --help-all >help
  sed -n '/^## Which option/,/^## /p' "$ROOT/README.md" | sed -E 's/`(cad2tri|pipelines\/quadplace) [^`]*`//' | grep -oE -- '--[a-z][a-z-]+' | sort -u >options
  assert [ "$(wc -l <options)" -ge 20 ]
  while read -r option; do grep -qE "^  (-., )?$option\b" help || fail "quadmesh has no $option"; done <options
  assert [ "$(wc -l <"$ROOT/README.md")" -le 250 ]
}
