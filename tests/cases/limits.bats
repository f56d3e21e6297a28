# quadmesh --max-seconds, --max-memory and --threads: a stage that exceeds a limit is stopped and named, and nothing else
# is left than the mesh without a field, if there is room for it.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh

# here COMMAND...: with the test's folder for temporaries too, so that what is left is seen.
here() { TMPDIR=$PWD "$@"; }

wasteful="exec python3 -c 'import time; data = bytearray(b\"x\" * (1 << 30)); time.sleep(60)'"
one_line_of_limit='^quadmesh: warning W-RUN-001: padapt was stopped at [0-9]+M of memory: --max-memory is 700M: the quads are made without a field$'

@test "a stage with more memory than --max-memory is stopped, and the quads are made without a field" {
  replace_stage padapt "$wasteful"
  run -0 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh --max-memory 700M --report report.json
  assert_output --regexp ', by midpoint division of triangles; (good|usable: .*|poor: .*)$'
  assert_regex "${stderr_lines[0]}" "$one_line_of_limit"
  assert_regex "${stderr_lines[1]}" '^separatrix: warning W-SEP-002: '
  run -0 jq -c '[.certificate.method, .valid, (.warnings | map([.tool, .code]) - [["quadrefine","W-QUA-005"]]), (.stages | keys_unsorted)]' report.json
  assert_output '["midpoint",true,[["quadmesh","W-RUN-001"],["separatrix","W-SEP-002"]],["cad2tri","fieldsolve","padapt","midpoint_separatrix","midpoint_blocksplit","midpoint_quadrefine","quadexport"]]'
  run -0 jq -r '.given_up, "quadmesh: warning W-RUN-001: " + .warnings[0].message' report.json
  assert_line --index 0 --regexp '^padapt: stopped at '
  assert_line --index 1 --regexp "$one_line_of_limit"
  run -0 --separate-stderr here "$quadmesh" "${replaced[@]}" -q "$DATA/half_disc.step" -o out.msh --max-memory 700M
  assert_equal "$output$stderr" ""
  rm -r fake
  assert_nothing_left out.msh report.json
}

@test "a stage that takes longer than --max-seconds allows is stopped, and the quads are made without a field" {
  replace_stage padapt 'exec sleep 100'
  run -0 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh --max-seconds 20 --report report.json
  assert_regex "${stderr_lines[0]}" '^quadmesh: warning W-RUN-001: padapt was stopped after 1[0-9]\.[0-9]+ s of all stages: --max-seconds is 20, and the rest is kept for quads without a field: the quads are made without a field$'
  run -0 jq -c '[.certificate.method, .valid]' report.json
  assert_output '["midpoint",true]'
  rm -r fake
  assert_nothing_left out.msh report.json
}

@test "without another way the exit code is 1, the stage is named and nothing is left" {
  replace_stage padapt "$wasteful"
  run -1 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh --max-memory=700M --layout traced
  assert_equal "${#stderr_lines[@]}" 1
  assert_regex "$stderr" '^quadmesh: padapt was stopped at [0-9]+M of memory: --max-memory is 700M$'
  rm -r fake
  replaced=()
  replace_stage cad2tri 'exec sleep 100'
  run -1 --separate-stderr here "$quadmesh" "${replaced[@]}" -q "$DATA/half_disc.step" -o out.msh --max-seconds 5
  assert_equal "${#stderr_lines[@]}" 1
  assert_regex "$stderr" '^quadmesh: cad2tri was stopped after [0-9.]+ s of all stages: --max-seconds is 5$'
  rm -r fake
  assert_nothing_left
}

@test "quads without a field for which there is no room either: the exit code is 1, the stage is named" {
  replace_stage padapt "$wasteful"
  replace_stage blocksplit "$wasteful"
  run -1 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh --max-memory 700M
  assert_regex "${stderr_lines[0]}" 'padapt was stopped .*without a field$'
  assert_regex "${stderr_lines[-1]}" '^quadmesh: blocksplit was stopped at [0-9]+M of memory: --max-memory is 700M$'
  rm -r fake
  assert_nothing_left
}

@test "a stage that the system kills, as it does for want of memory, is named" {
  replace_stage padapt 'kill -KILL $$'
  run -0 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh
  assert_regex "$stderr" 'quadmesh: warning W-RUN-001: padapt was killed by signal 9, as systems do when memory runs out: the quads'
  run -1 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o other.msh --layout quantized
  assert_regex "${stderr_lines[-1]}" '^quadmesh: padapt was killed by signal 9, as systems do when memory runs out$'
  run -1 --separate-stderr here bash -c 'ulimit -t 100; exec "$@"' - \
    "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o other.msh --layout quantized
  assert_regex "${stderr_lines[-1]}" 'padapt was killed by signal 9, as systems do after 100 s of CPU time \(ulimit -t\) or'
  rm -r fake
  assert_nothing_left out.msh
}

@test "a process that gets no more processes, files or memory: 1, with the resource named" {
  run -1 --separate-stderr bash -c 'ulimit -n 6; exec "$@"' - cad2tri "$DATA/half_disc.step" -o out.tri.h5
  [[ $stderr == *": no more open files: raise their limit (ulimit -n)" ]]
  run -1 --separate-stderr bash -c 'ulimit -v 30000; exec "$@"' - cad2tri "$DATA/half_disc.step" -o out.tri.h5
  [[ $stderr == *" cannot be started: no more memory: raise its limit (ulimit -v)" ]]
  [[ $EUID == 0 ]] && command -v setpriv >/dev/null || skip "a plain user is needed"
  chmod 777 .
  setpriv --reuid 65534 --clear-groups bash -c 'ulimit -u 1; exec "$@"' - "$BIN/cad2tri" - -o out.tri.h5 \
    <"$DATA/half_disc.step" 2>words && code=0 || code=$?
  assert_equal "$code $(cat words)" "1 cad2tri: cannot start a process: no more processes: raise their limit (ulimit -u)"
}

@test "messages that cannot be written change no exit code" {
  for words in "cad2tri none.step" "padapt none.h5" "quadmesh none.step -o out.msh" "points2step none.dat"; do
    case $words in
      quadmesh*) set -- "$quadmesh" none.step -o out.msh ;;
      points2step*) set -- "$ROOT/pipelines/points2step" none.dat ;;
      *) set -- $words ;;
    esac
    for way in '2>&-' '2>/dev/full' '2> >(exec true)'; do
      eval '"$@" '"$way" && code=0 || code=$?
      assert_equal "$words $way $code" "$words $way 3"
    done
  done
  "$quadmesh" "$DATA/half_disc.step" -o out.msh --size 0.4 >/dev/full
  "$quadmesh" "$DATA/half_disc.step" -o out.msh --size 0.4 >&- 2>&-
  run -4 bash -c '"$@" >/dev/full' - "$quadmesh" --help
  run -4 bash -c '"$@" >&-' - "$quadmesh" -q "$DATA/half_disc.step" --size 0.4
}

@test "a tool that gets no memory says so and ends with 1" {
  cad2tri --size 0.02 "$DATA/half_disc.step" -o a.tri.h5
  run -1 --separate-stderr bash -c 'ulimit -v 300000; fieldsolve --field-order 20 a.tri.h5 -o a.solve.h5'
  assert_regex "$stderr" '^fieldsolve: out of memory, at [0-9]+ MB'
  assert_nothing_left a.tri.h5
}

@test "a file for which there is no memory is not called damaged" {
  cad2tri --size 0.02 "$DATA/half_disc.step" -o a.tri.h5
  fieldsolve --field-order 6 a.tri.h5 -o a.solve.h5 # 5 MB
  for kilobytes in 20000 24000 28000 40000; do
    run --separate-stderr bash -c "ulimit -v $kilobytes; padapt --max-steps 1 a.solve.h5 -o a.field.h5"
    assert_equal "$status" 1
    assert_regex "$stderr" '^padapt: out of memory, at '
  done
}

@test "where other nodes were tried and a stage was stopped, the triangles are divided that were there" {
  awk 'BEGIN { pi = atan2(0, -1)
    for (k = 0; k <= 48; ++k) { t = 2 * pi * k / 48; r = 10 + k / 16; print r * cos(t), r * sin(t) }
    print ""
    for (k = 0; k < 24; ++k) { t = 2 * pi * k / 24; print 5 * cos(t), 5 * sin(t) } }' |
    "$ROOT/pipelines/points2step" -o snail.step
  replace_stage critpoints "case \" \$* \" in *.remedy.*) $wasteful ;; esac" 'exec critpoints "$@"'
  run -0 --separate-stderr here "$quadmesh" "${replaced[@]}" snail.step -o out.msh --report report.json --max-memory 700M
  assert_equal "$(grep -c trying <<<"$stderr")" 1
  assert_regex "$stderr" 'quadmesh: warning W-RUN-001: critpoints was stopped at'
  run -0 jq -c '[.certificate.method, .remedy, .valid, .verdict.grade, (.warnings | map(.code) | sort)]' report.json
  assert_output '["midpoint",null,true,"usable",["W-ADAPT-002","W-QUA-005","W-RUN-001","W-SEP-002"]]'
  rm -r fake
  assert_nothing_left out.msh report.json snail.step
}

@test "within the limits, and with any number of threads, the mesh is the same" {
  "$quadmesh" "$DATA/half_disc.step" -o plain.msh --workdir plain
  run -0 --separate-stderr here "$quadmesh" "$DATA/half_disc.step" -o limited.msh --workdir limited --max-seconds 600 --max-memory 8G
  assert_equal "$stderr" ""
  "$quadmesh" - -o limits_and_pipe.msh --max-seconds 600 <"$DATA/half_disc.step" >words
  cmp plain.msh limited.msh
  cmp plain.msh limits_and_pipe.msh
  for threads in 1 3 auto; do
    "$quadmesh" "$DATA/half_disc.step" -o other.msh --workdir "threads_$threads" --threads "$threads"
    cmp plain.msh other.msh
    diff -r plain "threads_$threads"
  done
  diff -r plain limited
}

@test "a limit or a number of threads that cannot be understood is a mistake" {
  for option in "--max-seconds 0" "--max-seconds x" "--max-seconds=" "--max-memory 2GB" "--max-memory -1" "--max-memory=" \
    "--threads 0" "--threads many" "--threads="; do
    # shellcheck disable=SC2086
    run -2 --separate-stderr here "$quadmesh" "$DATA/square.step" -o out.msh --workdir stages $option
    assert_regex "${stderr_lines[0]}" "^quad[a-z]+: ${option%%[ =]*}"
    assert_regex "${stderr_lines[1]}" "^try 'quad[a-z]+ --help'$"
  done
  assert_nothing_left
}

@test "a signal ends the stage and the pipeline within limits too" {
  replace_stage separatrix 'echo >started' 'exec sleep 30'
  ends_with_signal "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh --max-seconds 600
}
