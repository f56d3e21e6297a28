# Every command that a page, a manual page or a help shows is run by a test: by those named in this table, or here.
load ../tools/common

list=$ROOT/tests/page_commands.py

# Page and the tests that run all its commands.
runners() {
  cat <<'END'
README.md readme.bats
pipelines/manual.md manual.bats
pipelines/tutorial.md tutorial.bats
pipelines/quadbatch.md quadbatch.bats
pipelines/quadbench.md quadbench.bats
END
}

# A command and the tests that run the examples of its help, which are those of its manual page.
helps() {
  cat <<'END'
quadmesh cases/quadmesh.bats
quadplace cases/quadplace.bats
points2step cases/points2step.bats
drawing2step cases/drawing2step.bats
quadbatch cases/quadbatch.bats
quadbench cases/quadbench.bats
quadgallery cases/quadgallery.bats
END
}

# Files for the commands: every stage of the half disc as half_disc.*, x.* and a.*.
setup_file() {
  cd "$BATS_FILE_TMPDIR" || return
  stage_chain half_disc .
  cp "$DATA/half_disc.step" .
  local file
  for file in half_disc.*; do cp "$file" "x.${file#*.}" && cp "$file" "a.${file#*.}"; done
  cp half_disc.step shape.step
}

# here PAGE: runs its commands, one after another, in a folder of their own.
here() {
  "$list" lines "$1" | cut -f 3 >commands
  assert [ -s commands ]
  rm -rf folder && mkdir folder && cp "$BATS_FILE_TMPDIR"/*.* folder && mkdir -p folder/case/system folder/build
  ln -s "$ROOT/pipelines" folder && ln -s "$BIN" folder/build/bin
  cd folder || return
  run -0 env PATH="$ROOT/pipelines:$PATH" bash -euo pipefail ../commands
  cd ..
}

@test "pages with commands are run here or by the tests of the table" {
  # Those of CONTRIBUTING.md remake the pictures of the repository.
  "$list" lines | cut -f 1 | uniq | grep '\.md$' | grep -v -e ^formats/ -e ^CONTRIBUTING >found
  runners | cut -d ' ' -f 1 | sort | diff - <(sort found)
  while read -r page tests; do grep -qF "${page##*/}" "$ROOT/tests/cases/$tests" || fail "$tests does not name $page"; done < <(runners)
}

@test "the commands on the pages of formats" {
  "$list" lines formats | cut -f 1 | uniq >pages
  assert [ "$(wc -l <pages)" -ge 10 ]
  while read -r page; do here "$page"; done <pages
}

@test "the commands within the sentences of pages" {
  "$list" inline README.md CONTRIBUTING.md pipelines formats lib | cut -f 2 | sort -u | sed 's/-o FILE$/-o x.msh/' >commands
  assert [ "$(wc -l <commands)" -ge 17 ]
  ln -s "$ROOT/pipelines" .
  for file in "$BATS_FILE_TMPDIR"/half_disc.*; do
    for stem in d x shape; do cp "$file" "$stem.${file##*/half_disc.}"; done
  done
  cp "$DATA/curved/filleted_box.step" part.step
  hexsweep x.quad.h5 --one-layer -o x.hex.h5
  mkdir -p meshes system constant/polyMesh
  run -0 bash -euo pipefail commands
  for file in DIR/gallery.html shape.msh x.msh x.svg; do assert_file_exists "$file"; done
}

@test "the commands of quadrille(7)" {
  here pipelines/quadrille.7.in
}

@test "the commands that remake the pictures and pages" {
  mkdir -p formats/pictures build && ln -s "$BIN" build/bin && ln -s "$ROOT/pipelines" "$ROOT/tests" .
  "$list" lines CONTRIBUTING.md | cut -f 3 >commands
  assert_equal "$(wc -l <commands)" 10
  run -0 bash -euo pipefail commands
  for file in formats/pictures/*; do assert_file_exists "$ROOT/$file"; done
}

@test "the examples of every help are run" {
  run -0 bash -c 'basename -s .cpp "$0"/tools/*.cpp | grep -v -' "$ROOT"
  for tool in $(helps | cut -d ' ' -f 1 | grep -vxf - <(echo "$output")); do # cli.bats runs those of TOOLS
    grep -qE "^TOOLS=.*\b$tool\b" "$ROOT/tests/tools/cli.bats" || fail "cli.bats does not run the examples of $tool"
  done
  grep -lE '^EXAMPLES$|"EXAMPLES"' "$ROOT"/pipelines/* "$ROOT"/lib/program/chain/*_help.cpp 2>/dev/null |
    xargs -n 1 basename -s .cpp | sed 's/_help$//' | grep -vx -e man-page -e completions | sort >found
  helps | cut -d ' ' -f 1 | sort | diff - found
  while read -r command tests; do
    grep -q EXAMPLES "$ROOT/tests/$tests" || fail "no test runs the examples of $command"
  done < <(helps)
}

@test "the scripts that install, build and describe answer --help and do nothing else" {
  for script in quickstart build-tools install-dependencies man-page completions; do
    # From a copy without sources, and without the programs that install and build.
    mkdir -p copy/pipelines && cp "$ROOT/pipelines/$script" copy/pipelines
    for word in --help -h; do
      run -0 --separate-stderr env PATH=/usr/bin:/bin "copy/pipelines/$script" $word
      assert_line --index 0 --regexp "^usage: $script"
      assert_equal "$stderr" ''
    done
    [[ $script == quickstart ]] || continue
    run -2 "copy/pipelines/$script" all
  done
  assert_equal "$(find copy -type f | wc -l)" 5
}

@test "quickstart makes what it prints, once packages and tools are there" {
  mkdir -p copy/pipelines copy/build copy/tests/data
  cp "$ROOT/pipelines/quickstart" copy/pipelines
  ln -s "$ROOT/pipelines/quadmesh" copy/pipelines && ln -s "$BIN" copy/build/bin
  cp "$DATA/half_disc.step" copy/tests/data
  for script in install-dependencies build-tools; do # these take minutes and change the machine
    printf '#!/bin/sh\necho "$(basename "$0")" "$@" >>../steps\n' >copy/pipelines/$script
    chmod +x copy/pipelines/$script
  done
  run -0 --separate-stderr copy/pipelines/quickstart
  assert_equal "$(cut -d ' ' -f 1,2 steps | paste -sd ,)" "install-dependencies,build-tools build"
  for what in mesh pictures report; do
    file=$(awk -v what=$what '$1 == what { print $2 }' <<<"$output")
    for file in $(eval echo "$file"); do assert_file_not_empty "copy/$file"; done
  done
  assert_equal "$(find copy/build/quickstart -name '*.svg' | wc -l)" 6
  assert_line --regexp '^next +pipelines/quadmesh SHAPE.step'
}

# code PATTERN: the words of CONTRIBUTING.md that the pattern's group takes from its code, each once.
code() {
  { sed -n 's/^    *//p; s/^       *//p' "$ROOT/CONTRIBUTING.md"; grep -oE '`[^`]+`' "$ROOT/CONTRIBUTING.md" | tr -d '`'; } |
    sed -nE "s/.*$1.*/\\1/p" | sort -u
}

@test "presets, targets, tests and filters that CONTRIBUTING.md names exist" {
  run -0 code '--preset ([a-z]+)'
  assert [ "${#lines[@]}" -ge 1 ]
  for name in "${lines[@]}"; do
    jq -e --arg name "$name" 'any(.configurePresets[], .buildPresets[]; .name == $name)' "$ROOT/CMakePresets.json" >/dev/null ||
      fail "no preset $name"
  done
  run -0 code 'ninja -C build ([a-z_]+)'
  assert [ "${#lines[@]}" -ge 5 ]
  for name in "${lines[@]}"; do
    [[ -e $ROOT/tools/$name.cpp || -d $ROOT/tests/unit/${name#unit_} ]] || compgen -G "$ROOT/lib/*/$name/" >/dev/null ||
      grep -qE "^ *(add_custom_target|add_executable)\($name\b" "$ROOT"/{,tests,tools}/CMakeLists.txt || fail "no target $name"
  done
  run -0 code "(bats -f ('[^']+'|[a-z]+) [a-z/]+\.bats)"
  assert [ "${#lines[@]}" -ge 4 ]
  for line in "${lines[@]}"; do
    count=$(cd "$ROOT" && eval "${line/bats/bats -c}") && [[ $count -ge 1 ]] || fail "no test: $line"
  done
  run -0 code "(unit_[a-z]+ --gtest_filter='[^']+')"
  assert [ "${#lines[@]}" -ge 1 ]
  for line in "${lines[@]}"; do
    folder=$(sed 's/^unit_//; s/ .*//' <<<"$line") filter=$(sed "s/.*='//; s/[*']*$//" <<<"$line")
    grep -rqE "^TEST(_[FP])?\($filter" "$ROOT/tests/unit/$folder" || fail "no test: $line"
  done
}

@test "every option that a page or a help shows is one of its command" {
  "$list" options | cut -f 2,3 | sort -u >shown
  assert [ "$(wc -l <shown)" -ge 50 ]
  for command in $(cut -f 1 shown | uniq); do
    file=$ROOT/pipelines/$command
    [[ -x $file ]] || file=$BIN/$command
    "$file" --help-all | grep -oE '^  (-[a-z], )?--[a-z][a-z-]+' | grep -oE -- '--[a-z-]+' | sort -u >options
    grep "^$command	" shown | cut -f 2 | sort -u | comm -23 - options >unknown
    [[ $command != quadbatch ]] || sed -i '/^--sshlogin$/d' unknown # of GNU parallel
    [[ ! $command =~ ^quad(batch|bench|gallery)$ ]] || { quadmesh=$("$ROOT/pipelines/quadmesh" --help-all) &&
      while read -r option; do grep -qE "^  (-[a-z], )?$option\b" <<<"$quadmesh" || echo "$option"; done <unknown >left && mv left unknown; }
    [[ ! -s unknown ]] || fail "$command has no $(xargs <unknown)"
  done
}
