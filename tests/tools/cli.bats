# The contract of every command, looped over all tools.
load common

TOOLS="cad2chart cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine hexsweep quadexport stageview stagecheck"

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
  ln -sf "$DATA/half_disc.step" "$BATS_FILE_TMPDIR/half_disc.step"
}

setup() {
  common_setup
  stem=$BATS_FILE_TMPDIR/half_disc
}

# inputs_of TOOL: its input files in the half disc's chain.
inputs_of() {
  case $1 in
    cad2chart | cad2tri) echo "$stem.step" ;;
    fieldsolve) echo "$stem.tri.h5" ;;
    padapt) echo "$stem.solve.h5" ;;
    critpoints) echo "$stem.field.h5" ;;
    separatrix) echo "$stem.field.h5 $stem.crit.json" ;;
    blocksplit) echo "$stem.sep.json" ;;
    quadrefine) echo "$stem.blocks.h5" ;;
    hexsweep | quadexport | stageview | stagecheck) echo "$stem.quad.h5" ;;
  esac
}

# out_of TOOL: a name for its output; quadexport takes the format from it.
out_of() {
  case $1 in
    quadexport) echo out.msh ;;
    stageview) echo out.svg ;;
    *) echo out ;;
  esac
}

# The tools that write a file with -o.
writers() {
  echo "${TOOLS% stagecheck}"
}

@test "--help goes to stdout, ends with 0 and names exit codes and examples" {
  for tool in $TOOLS; do
    run --separate-stderr "$tool" --help
    assert_success
    assert_equal "$stderr" ""
    assert_line "EXIT CODES"
    assert_line "EXAMPLES"
    assert_line --partial "-o, --output FILE" || [ "$tool" = stagecheck ]
    run --separate-stderr "$tool" -h
    assert_success
  done
}

@test "--help states unit, default and interval of every number" {
  for tool in $TOOLS; do
    "$tool" --help | tr -s '\n ' ' ' > help
    numbers=$(grep -oE -- ' --[a-z-]+ (X|N) ' help | wc -l)
    assert_equal "$(grep -oE '\(unit: [^)]+; default: [^)]+; interval: [^)]+\)' help | wc -l)" "$numbers"
  done
}

@test "every page that a help text cites exists" {
  for tool in $TOOLS; do "$tool" --help; done >help
  for command in quadmesh quadplace points2step drawing2step; do "$ROOT/pipelines/$command" --help-all; done >>help
  run -0 grep -oE '\b(formats|lib|tests|pipelines)/[A-Za-z0-9/_.-]*[A-Za-z0-9/]' help
  [ "${#lines[@]}" -ge 4 ]
  for page in "${lines[@]}"; do assert_exists "$ROOT/$page"; done
}

@test "--version prints one line" {
  for tool in $TOOLS; do
    run --separate-stderr "$tool" --version
    assert_success
    assert_output --regexp "^$tool \(Quadrille\) [0-9]+\.[0-9]+\.[0-9]+$"
  done
}

@test "a mistake on the command line is one line, 'try', and 2" {
  for tool in $TOOLS; do
    for mistake in --no-such-option "--threads 0" "--threads many" --threads "--progress sometimes"; do
      run --separate-stderr "$tool" $mistake
      assert_equal "$status" 2
      assert_equal "$output" ""
      assert_equal "${#stderr_lines[@]}" 2
      assert_regex "${stderr_lines[0]}" "^$tool: "
      assert_equal "${stderr_lines[1]}" "try '$tool --help'"
    done
  done
}

@test "an input that is missing, empty, a folder, garbage or of another format ends with 3, one message and no file" {
  : > empty
  head -c 3000 /dev/urandom > garbage
  echo '{"format": "sonnet", "version": [1, 0]}' > sonnet.json
  mkdir folder
  for tool in $(writers); do
    for input in no/such/file empty folder garbage sonnet.json; do
      run --separate-stderr "$tool" "$input" -o "$(out_of "$tool")"
      assert_equal "$tool $input $status" "$tool $input 3"
      assert_equal "$output" ""
      assert_regex "$stderr" "^$tool: "
      assert_equal "${#stderr_lines[@]}" 1
      assert_nothing_left empty folder garbage sonnet.json
    done
  done
}

@test "a truncated input ends with 3 and no file" {
  for tool in $(writers); do
    set -- $(inputs_of "$tool")
    head -c $(($(stat -Lc %s "$1") / 2)) "$1" > half
    run --separate-stderr "$tool" half ${2-} -o "$(out_of "$tool")"
    assert_equal "$tool $status" "$tool 3"
    assert_equal "${#stderr_lines[@]}" 1
    assert_nothing_left half
  done
}

@test "silent on success; the file is the only thing left, and the same as through pipes" {
  for tool in $(writers); do
    set -- $(inputs_of "$tool")
    out=$(out_of "$tool")
    run --separate-stderr "$tool" "$@" -o "$out"
    assert_success
    assert_equal "$tool: $output$stderr" "$tool: "
    assert_nothing_left "$out"
    "$tool" "$@" > piped
    cmp "$out" piped
    rm -f "$out" piped
  done
}

@test "reads standard input by default and for -" {
  for tool in fieldsolve padapt critpoints blocksplit quadrefine stageview; do
    input=$(inputs_of "$tool")
    "$tool" "$input" -o named
    [ "$tool" != stageview ] || sed -i 's|<text class="file"[^<]*</text>||' named # a picture has the name of its file
    "$tool" < "$input" > piped
    cat "$input" | "$tool" - -o dashed
    cmp named piped
    cmp named dashed
  done
}

@test "no tool replaces a file that it reads, under any of its names: exit 2" {
  for tool in $(writers); do
    for name in input ./input link; do
      set -- $(inputs_of "$tool")
      cp "${@: -1}" input
      ln -sf input link
      run --separate-stderr "$tool" "${@:1:$#-1}" input -o "$name"
      assert_equal "$tool $name $status" "$tool $name 2"
      assert_equal "${stderr_lines[0]}" \
        "$tool: $name: is the input input, which --output would overwrite: give another file"
      cmp input "${@: -1}"
      run -2 "$tool" "${@:1:$#-1}" input -o out --report "$name"
      cmp input "${@: -1}"
    done
    run -2 --separate-stderr "$tool" "${@:1:$#-1}" - -o input <input
    cmp input "${@: -1}"
    assert_nothing_left input link
  done
}

@test "unwritable output ends with 4 and leaves nothing" {
  for tool in $(writers); do
    for target in "no/such/folder/$(out_of "$tool")" /dev/full; do
      [ "$tool $target" = "quadexport /dev/full" ] && continue # no extension to tell the format
      run --separate-stderr "$tool" $(inputs_of "$tool") -o "$target"
      assert_equal "$tool $target $status" "$tool $target 4"
      assert_regex "$stderr" "^$tool: $target: "
      assert_nothing_left
    done
    mkdir "folder.$(out_of "$tool")"
    run --separate-stderr "$tool" $(inputs_of "$tool") -o "folder.$(out_of "$tool")"
    assert_equal "$tool $status" "$tool 4"
    rmdir "folder.$(out_of "$tool")"
    run --separate-stderr bash -c "$tool $(inputs_of "$tool") > /dev/full"
    assert_equal "$tool $status" "$tool 4"
  done
}

@test "a full disk (here: a file size limit) ends with 4 and leaves nothing" {
  for tool in $(writers); do
    run --separate-stderr bash -c "ulimit -f 1; $tool $(inputs_of "$tool") -o $(out_of "$tool")"
    assert_equal "$tool $status" "$tool 4"
    assert_nothing_left
  done
}

@test "--report is written, with tool, exit code and timings, after success and after failure" {
  for tool in $TOOLS; do
    "$tool" $(inputs_of "$tool") --report ok.json > /dev/null
    run jq -r '[.tool, .exit_code, (.timings.total.cpu_seconds > 0), (.warnings | type)] | join(" ")' ok.json
    assert_output "$tool 0 true array"
    "$tool" no/such/file --report bad.json > /dev/null 2>&1 || true
    run jq -r '[.tool, .exit_code, (.error | length > 0)] | join(" ")' bad.json
    assert_output "$tool 3 true"
  done
}

@test "an existing file is replaced whole, its mode kept, a symbolic link stays one" {
  echo old > real
  chmod 640 real
  ln -s real link
  critpoints "$stem.field.h5" -o link
  [ -L link ]
  assert_equal "$(stat -c %a real)" 640
  cmp real "$stem.crit.json"
}

@test "a failure leaves an existing output alone" {
  echo old > out
  run critpoints "$DATA/half_disc.step" -o out
  assert_equal "$status" 3
  assert_equal "$(cat out)" old
}

@test "writes to a FIFO and to /dev/stdout directly" {
  mkfifo pipe
  timeout 20 cat pipe > got 3>&- &
  critpoints "$stem.field.h5" -o pipe
  wait $!
  cmp got "$stem.crit.json"
  [ -p pipe ]
  critpoints "$stem.field.h5" -o /dev/stdout | cmp - "$stem.crit.json"
}

@test "a reader that goes away ends the tool by SIGPIPE" {
  mkfifo pipe
  # Open for reading while the other end is opened, then closed: the tool cannot be faster than the reader.
  run bash -c "exec 5<>pipe 6>pipe 5<&-; exec stageview '$stem.quad.h5' >&6"
  assert_equal "$status" 141
}

@test "a signal ends the tool with 128 + n and leaves nothing" {
  mkfifo never
  for signal in INT TERM HUP; do
    # A FIFO that nobody writes to keeps the tool waiting. Bats ignores INT in what it starts: --default-signal.
    timeout 20 env --default-signal critpoints never -o out 2> /dev/null 3>&- &
    tool=$!
    until pkill -x -$signal -P $tool critpoints; do sleep 0.01; done # until it has been started
    code=0
    wait $tool || code=$?
    assert_equal "$signal $code" "$signal $((128 + $(kill -l $signal)))"
    assert_nothing_left never
  done
}

@test "binary is not written to a terminal" {
  command -v script || skip "no script(1)"
  run script -qec "fieldsolve '$stem.tri.h5'" /dev/null
  assert_equal "$status" 4
  assert_output --partial "fieldsolve: standard output is a terminal"
}

@test "the options that cannot change a result leave no trace in it" {
  for tool in fieldsolve padapt critpoints blocksplit quadrefine; do
    "$tool" $(inputs_of "$tool") -o plain
    "$tool" -v --threads 2 --progress never --report report.json $(inputs_of "$tool") -o other 2> /dev/null
    cmp plain other
  done
}

@test "the examples of --help run" {
  cp "$BATS_FILE_TMPDIR"/half_disc.* .
  cp "$DATA/bad/solid.step" bracket_solid.step
  printf 'x,y,h1,h2,angle\n0,0.5,0.2,0.1,0\n' >metric.csv
  for tool in $TOOLS; do
    "$tool" --help | sed -n '/^EXAMPLES$/,$p' | sed 1d > examples
    [ -s examples ]
    while read -r example; do
      run bash -c "$example"
      assert_success
    done < examples
  done
}

@test "tools load neither the shared C++ library nor the CAD kernel, which would take longer than their start" {
  if nm "$BIN/stagecheck" | grep -q __asan_init; then skip "built with sanitizers, with shared libraries"; fi
  for tool in $TOOLS; do
    run -0 ldd "$BIN/$tool"
    refute_output --regexp 'lib(stdc\+\+|fmt|TK[A-Za-z]+)\.so'
  done
}

# on_terminal COMMAND...: runs it on a terminal of its own and prints what is written there.
on_terminal() {
  script -qec "$(printf '%q ' "$@")" /dev/null </dev/null
}

# screen: what a terminal shows in the end of what is written to it (standard input), without empty lines.
screen() {
  /usr/bin/python3 -c '
import sys
for written in sys.stdin.buffer.read().replace(b"\r\n", b"\n").decode().split("\n"):
    line, column = {}, 0
    for c in written:
        if c in "\r\b":
            column = 0 if c == "\r" else column - 1
        else:
            line[column], column = c, column + 1
    text = "".join(line[i] for i in sorted(line)).rstrip()
    if text:
        print(text)'
}

@test "progress on a terminal is one line, and nothing of it is left" {
  for tool in $TOOLS; do
    arguments="$(inputs_of "$tool") --progress always"
    [ "$tool" = stagecheck ] || arguments="$arguments -o $(out_of "$tool")"
    on_terminal "$tool" $arguments > written
    grep -q $'\r'"$tool: [a-z]*.*, [0-9]* s" written || fail "$tool: $(cat -v written)"
    assert_equal "$tool: $(screen < written)" "$tool: "
  done
}

@test "messages stay on a terminal, whatever the progress" {
  on_terminal padapt "$stem.solve.h5" --max-steps 0 -v --progress always -o out > written
  screen < written > left
  run -0 cat left
  assert_line --index 0 --partial "padapt: orders "
  refute_output --regexp ', [0-9]+ s$'
}

@test "--progress is silent without a terminal unless it is asked for, and --quiet on a terminal" {
  for tool in $(writers); do
    run -0 --separate-stderr "$tool" $(inputs_of "$tool") -o "$(out_of "$tool")"
    assert_equal "$tool$stderr" "$tool"
    run -0 --separate-stderr "$tool" $(inputs_of "$tool") --progress always -o "$(out_of "$tool")"
    assert_regex "$stderr" "^$tool: [a-z]+ \.\.\."
    run -0 on_terminal "$tool" $(inputs_of "$tool") -q -o "$(out_of "$tool")"
    assert_output ""
  done
}

@test "a signal erases the line of progress" {
  mkfifo never
  on_terminal timeout --foreground 1 bash -c 'exec critpoints - --progress always -o out <> never' > written || true
  assert_equal "$(screen < written)" ""
}
