# Every command without the resources that it needs, and with messages that cannot be written: it ends with a documented
# exit code, never by a signal, and with 70 never.
load ../tools/common

setup_file() {
  cd "$BATS_FILE_TMPDIR" || return 1
  stage_chain square
  cp "$DATA/square.step" .
  head -c -16 square.quad.h5 >foreign.quad.h5 # without the checksum: it is read in a child process
  printf '0 0\n1 0\n1 1\n0 1\n' >square.dat
  echo '<svg xmlns="http://www.w3.org/2000/svg"><rect width="1" height="1"/></svg>' >square.svg
}

# A line for each command that works: the inputs are those of setup_file.
commands() {
  cat <<END
cad2tri square.step -o \$out/x.tri.h5
fieldsolve square.tri.h5 -o \$out/x.solve.h5
padapt square.solve.h5 -o \$out/x.field.h5
critpoints square.field.h5 -o \$out/x.crit.json
separatrix square.field.h5 square.crit.json -o \$out/x.sep.json
blocksplit square.sep.json -o \$out/x.blocks.h5
quadrefine square.blocks.h5 --size 0.5 -o \$out/x.quad.h5
quadexport square.quad.h5 -o \$out/x.msh
quadexport square.blocks.h5 -o \$out/x.step
stagecheck square.quad.h5 square.crit.json
stagecheck foreign.quad.h5
stageview square.quad.h5 -o \$out/x.svg
quadmesh square.step --size 0.5 -o \$out/x.msh
END
}

# scripts: those in Python, with the same meaning.
scripts() {
  cat <<END
points2step square.dat -o \$out/y.step
drawing2step square.svg -o \$out/y.step
quadbatch none.step --to \$out/batch
quadplace square.step --rounds 0 -o \$out/y.msh
quadgallery --to /dev/null/gallery
END
}

# starts COMMAND...: whether the kernel and the loader have the memory to start the program at all.
starts() { "$@" >/dev/null 2>&1; }

# documented CODE...: adds to $wrong what is not one of the documented codes of a failure or success.
documented() {
  case $1 in 0 | 1 | 2 | 3 | 4) ;; *) wrong+="$1: ${*:2}"$'\n' ;; esac
}

@test "messages that cannot be written change the exit code of no command" {
  cd "$BATS_FILE_TMPDIR" && out=$BATS_TEST_TMPDIR
  PATH=$ROOT/pipelines:$PATH
  while read -r line; do
    for mistake in "" --nonsense; do
      eval "$line $mistake" >/dev/null 2>&1 && code=0 || code=$?
      for way in '2>&-' '2>/dev/full' '2> >(exec true)'; do
        eval "$line $mistake >/dev/null $way" && found=0 || found=$?
        [[ $found == "$code" ]] || wrong+="$line $mistake $way: $found, not $code"$'\n'
      done
    done
  done < <(commands && scripts | grep -v quadplace)
  assert_equal "${wrong-}" ""
}

@test "20 limits of memory: documented codes, and 1 with the resource named" {
  cd "$BATS_FILE_TMPDIR" && out=$BATS_TEST_TMPDIR
  while read -r line; do
    read -r tool _ <<<"$line"
    # From the least limit with which the program starts, in kilobytes: kernel and loader answer below it.
    for ((least = 6000; least < 60000; least += 500)); do
      starts bash -c "ulimit -v $least; exec $tool --version" && break
    done
    for ((step = 0; step < 20; ++step)); do
      limit=$((least + 250 * step + 40 * step * step))
      code=0
      (ulimit -v $limit && eval "exec $line") >/dev/null 2>"$out/words" || code=$?
      documented $code "$line, at $limit kB: $(head -n 1 "$out/words")"
      ((code == 0 || code == 1)) || wrong+="$line, at $limit kB: $code: $(head -n 1 "$out/words")"$'\n'
      ((code != 1)) || grep -qE 'out of memory|no more (memory|processes)' "$out/words" ||
        wrong+="$line, at $limit kB: $(head -n 1 "$out/words")"$'\n'
    done
  done < <(commands) 2>/dev/null
  assert_equal "${wrong-}" ""
}

@test "four open files: a documented code of every command" {
  cd "$BATS_FILE_TMPDIR" && out=$BATS_TEST_TMPDIR
  while read -r line; do
    code=0
    (ulimit -n 4 && eval "exec $line") >/dev/null 2>"$out/words" 3>&- 4>&- 10>&- 255>&- || code=$? # those of Bats
    documented $code "$line: $(cat "$out/words")"
    ((code != 1)) || grep -q 'no more open files: raise their limit (ulimit -n)' "$out/words" ||
      wrong+="$line: $(cat "$out/words")"$'\n'
  done < <(commands)
  assert_equal "${wrong-}" ""
}

@test "no other process, as a plain user: a documented code of every command" {
  [[ $EUID == 0 ]] && command -v setpriv >/dev/null || skip "needs root, to become a plain user, and setpriv"
  setpriv --reuid 65534 --clear-groups test -x "$BIN/cad2tri" || skip "a plain user cannot reach $BIN"
  cd "$BATS_FILE_TMPDIR" && out=plain
  setpriv --reuid 65534 --clear-groups test -r square.step || skip "a plain user cannot read $BATS_FILE_TMPDIR"
  mkdir -m 777 "$out"
  while read -r line; do
    code=0
    setpriv --reuid 65534 --clear-groups bash -c "ulimit -u 1; out=$out; exec $line" >/dev/null 2>"$BATS_TEST_TMPDIR/words" ||
      code=$?
    documented $code "$line: $(cat "$BATS_TEST_TMPDIR/words")"
    ((code != 1)) || grep -q 'no more processes: raise their limit (ulimit -u)' "$BATS_TEST_TMPDIR/words" ||
      wrong+="$line: $(cat "$BATS_TEST_TMPDIR/words")"$'\n'
  done < <(commands)
  assert_equal "${wrong-}" ""
}
