# Makefile.example: only what is out of date runs.
load ../tools/common

setup_file() {
  cd "$BATS_FILE_TMPDIR" || return 1
  cp "$ROOT/tests/data/half_disc.step" .
  make -s -f "$ROOT/Makefile.example" BIN="$BIN" half_disc.msh
}

setup() {
  cp -a "$BATS_FILE_TMPDIR/." "$BATS_TEST_TMPDIR" && cd "$BATS_TEST_TMPDIR" || return 1
}

# The names of the stages that `make half_disc.msh ARGUMENT...` runs, in one line.
stages_run() {
  make -f "$ROOT/Makefile.example" BIN="$BIN" half_disc.msh "$@" | sed -nE "s|^$BIN/([a-z0-9]+) .*|\1|p" | xargs
}

@test "a second make runs nothing" {
  assert_equal "$(stages_run)" ""
}

@test "a touched shape re-runs everything" {
  touch half_disc.step
  assert_equal "$(stages_run)" "cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport"
  assert_equal "$(stages_run)" ""
}

@test "a changed setting of one stage re-runs it and what follows, nothing before" {
  assert_equal "$(stages_run quadrefine='--size 0.2')" "quadrefine quadexport"
  assert_equal "$(stages_run quadrefine='--size 0.2')" ""
  assert_equal "$(stages_run quadrefine='--size 0.2' fieldsolve='--field-order 9')" \
    "fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport"
  assert_equal "$(stages_run)" "fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport"
}

@test "a file from the middle that is touched re-runs what follows" {
  touch half_disc.blocks.h5
  assert_equal "$(stages_run)" "quadrefine quadexport"
}

@test "a node that is moved by hand gets a field of its own" {
  jq '.form = "phase" | .critical_points[0].position[0] -= 0.1' half_disc.crit.json > moved
  mv moved half_disc.crit.json
  assert_equal "$(stages_run)" "fieldsolve padapt separatrix blocksplit quadrefine quadexport"
  assert_equal "$(stages_run)" ""
  assert_equal "$(stages_run separatrix='--merge-angle 10')" "separatrix blocksplit quadrefine quadexport"
}

@test "a failing stage leaves no target, and the next make tries it again" {
  run ! make -s -f "$ROOT/Makefile.example" BIN="$BIN" half_disc.msh quadrefine='--order 0'
  assert_equal "$(stages_run)" "quadrefine quadexport"
}

@test "every stage has a picture" {
  run -0 make -s -f "$ROOT/Makefile.example" BIN="$BIN" half_disc.{tri,solve,field,crit,sep,blocks,quad}.svg
  run -0 xmllint --noout half_disc.{tri,solve,field,crit,sep,blocks,quad}.svg
}

@test "every ending of a solver's format has a rule" {
  run -0 make -s -f "$ROOT/Makefile.example" BIN="$BIN" half_disc.{vtu,xml,mesh,ism,inp,re2}
  for ending in vtu xml mesh ism inp re2; do assert_file_exists "half_disc.$ending"; done
  assert_equal "$(stages_run)" ""
}

@test "options are remembered for each target: another target does not change them" {
  cp half_disc.step other.step
  run -0 make -s -f "$ROOT/Makefile.example" BIN="$BIN" other.msh quadrefine='--size 0.5'
  assert_equal "$(stages_run)" ""
  run -0 make -f "$ROOT/Makefile.example" BIN="$BIN" other.msh quadrefine='--size 0.5'
  assert_output ''
  # Options of one shape replace those of all, also where they are empty.
  assert_equal "$(stages_run quadrefine='--size 0.2' half_disc.quadrefine=)" ""
  assert_equal "$(stages_run half_disc.quadrefine="--size 0.2 --size-near 'a b'=1" half_disc.separatrix='--merge-angle 9')" \
    "separatrix blocksplit quadrefine"
  assert_equal "$(stages_run quadexport='--frame 3d')" "separatrix blocksplit quadrefine quadexport"
  assert_equal "$(stages_run quadexport='--frame 3d')" ""
}

@test "a changed option of the field for given nodes makes that again, and what follows" {
  jq -c '.form = "phase" | .critical_points[0].position[0] -= 0.1' half_disc.crit.json > moved
  mv moved half_disc.crit.json
  stages_run
  assert_equal "$(stages_run phase='--field-order 9')" "fieldsolve padapt separatrix blocksplit quadrefine quadexport"
  assert_equal "$(stages_run phase='--field-order 9')" ""
}

@test "shapes are STEP, IGES or BREP files, also in other folders" {
  mkdir shapes
  cp "$DATA/bad/half_disc_inches.iges" shapes/inches.iges
  cp "$DATA/bad/half_disc_inches.iges" inches.igs
  cp "$DATA/bad/rectangle.brep" .
  cp half_disc.step disc.stp
  run -0 make -s -f "$ROOT/Makefile.example" BIN="$BIN" shapes/inches.msh inches.msh rectangle.vtu disc.msh
  cmp shapes/inches.msh inches.msh
  [[ -s disc.msh && -s rectangle.vtu ]]
  run -0 make -f "$ROOT/Makefile.example" BIN="$BIN" shapes/inches.msh shapes.quadrefine='--size 1'
  assert_output ''
  run -0 make -f "$ROOT/Makefile.example" BIN="$BIN" shapes/inches.msh inches.quadrefine='--size 1'
  assert_output --partial 'quadrefine --size 1 shapes/inches.blocks.h5 -o shapes/inches.quad.h5'
  run -0 make -s -f "$ROOT/Makefile.example" BIN="$BIN" clean
  assert_file_not_exists half_disc.quad.h5
}

@test "the tools are found on PATH where the file was copied to; without them it says what to do" {
  mkdir elsewhere
  cp "$ROOT/Makefile.example" elsewhere/Makefile
  cp half_disc.step elsewhere
  run -0 env -u BIN make -s -C elsewhere half_disc.msh
  cmp elsewhere/half_disc.msh half_disc.msh
  run -2 env -u BIN PATH=/usr/bin:/bin make -C elsewhere half_disc.msh
  assert_output --partial 'no cad2tri on PATH: give BIN=FOLDER'
}
