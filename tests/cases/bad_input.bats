# Bad input, unwritable output and interruption, through the tools and through quadmesh alike: the documented exit
# code, one message that says what and where, no output file, and no temporary left beside it or in TMPDIR.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh

# The CAD files that are refused, and what the message must say without its blanks.
refused="empty.step:empty truncated.step:truncated garbage.step:STEP garbage.txt:STEP wrong_extension.iges:.iges
  wrong_extension.txt:.txt unknown_entity.step:#4 unknown_point.step:#4 points_are_directions.step:#4
  broken_reference.step:edges mixed_units.step:unit solid.step:solid two_faces.step:faces
  open_wire.step:(0,1) self_intersecting.step:(0.952381,0.52381)
  self_intersecting_curve.step:(1,0.857143) hole_outside.step:(3,0)
  hole_across.step:(2,0.75) hole_in_hole.step:(3,3) zero_area.step:(2,0)
  swapped_coordinates.step:(1,2)"

setup() {
  common_setup
  mkdir ../temporaries
  export TMPDIR=$BATS_TEST_TMPDIR/temporaries
}

teardown() {
  [[ ! -d disk ]] || ! mountpoint -q disk || umount disk
}

# refuses CODE PATTERN COMMAND...: one line on stderr that matches, nothing on stdout, no temporary.
refuses() {
  local code=$1 pattern=$2
  shift 2
  run --separate-stderr "$@"
  assert_equal "$* ends with $status" "$* ends with $code"
  assert_equal "$output" ""
  assert_equal "$* says ${#stderr_lines[@]} line: $stderr" "$* says 1 line: $stderr"
  [[ $stderr == $pattern ]] || fail "$*: $stderr"
  assert_equal "$(ls -A "$TMPDIR")" ""
}

# ends_of_signal SIGNAL SECONDS COMMAND...: the command, hit in the middle of its work, ends with 128 + n in silence.
ends_of_signal() {
  local signal=$1 seconds=$2 code=0
  shift 2
  # Bats ignores INT in what it starts; a signal from the keyboard reaches the whole group, one from kill only one.
  env --default-signal timeout --foreground --preserve-status -s "$signal" "$seconds" "$@" 2>words 3>&- || code=$?
  assert_equal "$* $signal $code" "$* $signal $((128 + $(kill -l "$signal")))"
  assert_equal "$(cat words)" ""
  rm words
  assert_equal "$(ls -A "$TMPDIR")" ""
}

@test "a closed surface: cad2tri says that it is curved, quadmesh where to cut it" {
  refuses 3 'cad2tri: *the face is not planar (a sphere): *' cad2tri "$DATA/bad/sphere.step" -o out.tri.h5
  refuses 3 '*: the face is closed, without a boundary*: cut it into faces*' "$quadmesh" "$DATA/bad/sphere.step" \
    -o out.msh
}

@test "CAD files that are refused: 3, what and where, through cad2tri and through quadmesh" {
  for entry in $refused; do
    file=${entry%%:*}
    refuses 3 "*: $DATA/bad/$file: *" "$quadmesh" "$DATA/bad/$file" -o out.msh --report report.json
    message=${stderr#*: }
    [[ ${message// /} == *"${entry#*:}"* ]] || fail "$message"
    assert_equal "$(jq -r '"\(.exit_code) \(.error)"' report.json)" "3 $message"
    rm report.json
    refuses 3 "cad2tri: *" cad2tri "$DATA/bad/$file" -o out.tri.h5
    assert_equal "$stderr" "cad2tri: $message"
  done
  assert_nothing_left
}

@test "boundaries that touch are refused with --blunt 0" {
  refuses 3 "*(2, 0.5)*" cad2tri "$DATA/bad/hole_touching.step" --blunt 0 -o out.tri.h5
  refuses 3 "*(2, 0.5)*" "$quadmesh" "$DATA/bad/hole_touching.step" --blunt 0 -o out.msh
}

@test "a CAD file through a pipe is refused under the name of standard input" {
  refuses 3 "cad2tri: standard input: *" bash -c "'$quadmesh' - -o out.msh <'$DATA/bad/open_wire.step'"
  refuses 3 "cad2tri: standard input: *" bash -c "cad2tri - -o out.tri.h5 <'$DATA/bad/open_wire.step'"
  assert_nothing_left
}

@test "every tool refuses its input of another version with the sentence for newer or for older" {
  for pair in fieldsolve:tri_mesh padapt:field critpoints:field blocksplit:separatrix_graph quadrefine:block_layout \
    quadexport:quad_mesh stageview:critical_points stageview:quad_mesh; do
    tool=${pair%:*}
    for file in "$ROOT/tests/formats/${pair#*:}"/failed/version-*; do
      case $file in
        *newer*) sentence="is newer than this program" ;;
        *older*) sentence="is from an older program" ;;
      esac
      refuses 3 "$tool: $file: *$sentence*" "$tool" "$file" -o "out.$([[ $tool == stageview ]] && echo svg || echo msh)"
    done
  done
  for age in newer older; do
    field=$ROOT/tests/formats/field points=$ROOT/tests/formats/critical_points
    refuses 3 "separatrix: $field/failed/version-$age*" separatrix "$field/failed/version-$age.field.h5" \
      "$points/passed/square.crit.json" -o out
    refuses 3 "separatrix: $points/failed/version-$age*" separatrix "$field/passed/square.field.h5" \
      "$points/failed/version-$age.crit.json" -o out
    blocks=$ROOT/tests/formats/block_layout/failed/version-$age.blocks.h5
    refuses 3 "quadexport: $blocks: *" quadexport "$blocks" -o out.step
  done
  assert_nothing_left
}

@test "an output that cannot be written: 4, and the name" {
  mkdir folder.msh
  for target in no/such/folder.msh folder.msh /proc/out.msh "$DATA/square.step/out.msh"; do
    refuses 4 "quad*: $target: cannot be written: *" "$quadmesh" "$DATA/square.step" -o "$target"
    refuses 4 "cad2tri: $target: cannot be written: *" cad2tri "$DATA/square.step" -o "$target"
  done
  refuses 4 "quadexport: *cannot be written: *" bash -c "'$quadmesh' '$DATA/square.step' >/dev/full"
  assert_nothing_left folder.msh
}

@test "a report, a working folder or a temporary folder that cannot be written: 4, and the name" {
  mkdir folder
  for target in no/such/folder.json folder /proc/report.json /dev/full; do
    refuses 4 "*$target*" "$quadmesh" "$DATA/square.step" -o out.msh --report "$target"
    refuses 4 "cad2tri: $target: *" cad2tri "$DATA/square.step" -o out.tri.h5 --report "$target"
    rm -f out.msh out.tri.h5
  done
  refuses 4 "*No space left*" bash -c "'$quadmesh' '$DATA/square.step' -o out.msh --report - >/dev/full"
  rm out.msh
  for target in /proc/stages "$DATA/square.step/stages"; do
    refuses 4 "quadmesh: *$target*" "$quadmesh" "$DATA/square.step" -o out.msh --workdir "$target"
  done
  refuses 4 "quadmesh: *" env TMPDIR="$PWD/nowhere" "$quadmesh" "$DATA/square.step" -o out.msh
  assert_nothing_left folder
}

@test "a full disk and one that is read-only: 4, nothing left on them" {
  mkdir disk
  mount -t tmpfs -o size=16k none disk 2>/dev/null || skip "may not mount here"
  refuses 4 "quadexport: disk/out.msh: *No space left*" "$quadmesh" "$DATA/square.step" -o disk/out.msh
  refuses 4 "cad2tri: disk/out.tri.h5: *No space left*" cad2tri "$DATA/half_disc.step" -o disk/out.tri.h5
  refuses 4 "quadexport: disk/out.step: *No space left*" bash -c \
    "'$quadmesh' -q '$DATA/half_disc.step' -o out.msh --workdir . && quadexport half_disc.blocks.h5 -o disk/out.step"
  refuses 4 "quadexport: disk/out.exo: *No space left*" quadexport -q half_disc.quad.h5 -o disk/out.exo
  refuses 4 "quadexport: the CGNS library reports: *" env TMPDIR="$PWD/disk" quadexport -q --format cgns-structured half_disc.quad.h5 -o out.cgns
  refuses 4 "cad2tri: disk/half_disc.tri.h5: *No space left*" "$quadmesh" "$DATA/half_disc.step" -o a.msh --workdir disk
  # Stages in processes of their own pass files on, those in one process do not.
  refuses 4 "*No space left*" env TMPDIR="$PWD/disk" "$quadmesh" "$DATA/half_disc.step" -o a.msh --max-seconds 600
  assert_equal "$(ls -A disk)" ""
  assert_file_not_exists a.msh
  run -0 env TMPDIR="$PWD/disk" "$quadmesh" -q "$DATA/half_disc.step" -o a.msh
  assert_equal "$(ls -A disk)" ""
  rm a.msh
  mount -o remount,ro disk
  refuses 4 "quad*: disk/out.msh: cannot be written: *" "$quadmesh" "$DATA/square.step" -o disk/out.msh
  refuses 4 "cad2tri: disk/out.tri.h5: *Read-only*" cad2tri "$DATA/square.step" -o disk/out.tri.h5
  refuses 4 "quadmesh: *disk/stages*" "$quadmesh" "$DATA/square.step" -o a.msh --workdir disk/stages
}

@test "a signal in the middle of the work: 128 + n, nothing left" {
  for signal in INT TERM HUP; do
    for seconds in 0.01 0.1 0.4; do
      ends_of_signal $signal $seconds cad2tri "$DATA/stadium.step" --size 0.01 -o out.tri.h5
      ends_of_signal $signal $seconds "$quadmesh" "$DATA/geometry_1.step" --size 0.006 -o out.msh
      assert_nothing_left
    done
  done
}

@test "an interrupt from the keyboard, to the whole group at once: 130, nothing left" {
  for seconds in 0.05 0.2 0.5; do
    env --default-signal setsid "$quadmesh" "$DATA/geometry_1.step" --size 0.006 -o out.msh 2>words 3>&- &
    group=$!
    until kill -0 -- -$group 2>/dev/null; do sleep 0.01; done # until setsid has made the group
    sleep $seconds
    kill -INT -- -$group
    code=0
    wait $group || code=$?
    assert_equal "$seconds $code" "$seconds 130"
    assert_equal "$(cat words)" ""
    rm words
    assert_equal "$(ls -A "$TMPDIR")" ""
    assert_nothing_left
  done
}

@test "an output that is there already stays as it was after bad input and after a signal" {
  echo old >out.msh
  refuses 3 "cad2tri: *" "$quadmesh" "$DATA/bad/open_wire.step" -o out.msh
  ends_of_signal TERM 0.2 "$quadmesh" "$DATA/geometry_1.step" --size 0.006 -o out.msh
  assert_equal "$(cat out.msh)" old
}
