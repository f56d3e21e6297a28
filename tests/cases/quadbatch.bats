# pipelines/quadbatch: many shapes, interrupted and continued; one table.
load ../tools/common

quadbatch=$ROOT/pipelines/quadbatch

setup() {
  common_setup
  command -v parallel || skip "no GNU parallel"
}

# here COMMAND...: with the test's folder for temporaries and as home too, so that what is left is seen.
here() { TMPDIR=$PWD HOME=$PWD "$@"; }

# column KEY: of the table, without its head, in the order of the shapes.
column() {
  "$PYTHON" -c 'import csv, sys
print(*[row[sys.argv[1]] for row in csv.DictReader(open("out/table.csv"))], sep="\n")' "$1"
}
PYTHON=/usr/bin/python3

@test "each shape has its mesh, its report and its row; failures have a message; exit code 1" {
  run -1 --separate-stderr here "$quadbatch" "$DATA/square.step" "$DATA/bad/open_wire.step" "$DATA/half_disc.step" --to out \
    --jobs 2 --size 0.2
  assert_output "3 shapes: 2 with a mesh, 1 without, 0 done before: out/table.html"
  assert_equal "$stderr" ""
  assert_nothing_left out out/{half_disc,square}.{msh,blocks.svg,report.json,result.json} out/open_wire.result.json out/table.{csv,html}
  assert_equal "$(column exit_code | paste -sd ' ')" "0 3 0"
  assert_equal "$(column blocks | paste -sd ' ')" "4  1"
  assert_equal "$(column quads | head -1)" "$(jq .quads out/half_disc.report.json)"
  run -0 column message
  assert_output --regexp 'cad2tri: .*open_wire.step: the wire is open'
  "$ROOT/pipelines/quadmesh" -q "$DATA/half_disc.step" --size 0.2 -o one.msh
  cmp one.msh out/half_disc.msh
  xmllint --html --noout out/table.html
  xmllint --noout out/half_disc.blocks.svg
  assert_equal "$(grep -c '<img src="half_disc.blocks.svg" alt="" loading="lazy">' out/table.html)" 1
  assert_equal "$(grep -o '<th aria-sort="none"><button>' out/table.html | wc -l)" 11
}

@test "what is done is not done again; a changed shape, other options, a lost file and --retry are" {
  mkdir shapes
  cp "$DATA/square.step" "$DATA/half_disc.step" shapes
  cp "$DATA/bad/open_wire.step" shapes
  times() { stat -c '%n %.9Y' out/*.result.json | sort; }
  changed() {
    join <(echo "$before") <(times) | awk '$2 != $3 { print $1 }' | sed 's|out/||; s|\.result.*||' | paste -sd ' '
  }
  again() { before=$(times) && run here "$quadbatch" shapes --to out "$@"; }
  again
  again
  assert_output --partial ', 3 done before'
  assert_equal "$(changed)" ""
  touch shapes/square.step && again
  assert_equal "$(changed)" ""
  echo >>shapes/square.step && touch -d 2000-01-01 shapes/square.step && again
  assert_equal "$(changed)" "square"
  rm out/half_disc.msh && again
  assert_equal "$(changed)" "half_disc"
  again --retry
  assert_equal "$(changed)" "open_wire"
  again --threads 2
  assert_equal "$(changed)" ""
  again --size 0.3
  assert_equal "$(changed)" "half_disc open_wire square"
}

@test "interrupted half-way, it leaves whole results; started again, it does the rest, once" {
  replace_stage quadrefine '[ -e slow ] || exec quadrefine "$@"' \
    'case "$*" in *ellipse.blocks*) echo >started; sleep 60 & trap "kill $!; exit 143" TERM; wait ;; esac' \
    'exec quadrefine "$@"'
  shapes=("$DATA"/{ellipse,square,half_disc,annulus,disc,octagon}.step)
  local signal code first
  for signal in INT TERM; do
    rm -rf out started
    touch slow
    TMPDIR=$PWD HOME=$PWD env --default-signal "$quadbatch" "${replaced[@]}" "${shapes[@]}" --to out --jobs 2 2>words 3>&- &
    until [[ -e started && -e out/square.result.json ]]; do sleep 0.05; done
    kill "-$signal" $!
    code=0 && wait $! || code=$?
    assert_equal $code $((128 + $(kill -l $signal)))
    run cat words
    assert_output "quadbatch: interrupted: the same command again continues"
    assert_not_exists out/ellipse.result.json
    first=$(cd out && stat -c '%n %.9Y' ./*.result.json | sort)
    assert_equal "$(find . -name '.*' ! -name .)" ""
    assert_equal "$(ls | paste -sd ' ')" "fake out slow started words"
    assert_equal "$(($(wc -l <out/table.csv) - 1))" "$(wc -l <<<"$first")"
    rm slow
    run -0 here "$quadbatch" "${replaced[@]}" "${shapes[@]}" --to out --jobs 2
    assert_output "6 shapes: 6 with a mesh, 0 without, $(wc -l <<<"$first") done before: out/table.html"
    assert_equal "$(cd out && stat -c '%n %.9Y' ./*.result.json | sort | comm -12 - <(echo "$first"))" "$first"
    assert_equal "$(wc -l <out/table.csv)" 7
    assert_equal "$(find out -type f | wc -l)" 26
  done
}

@test "mistakes on the command line are exit 2 with a hint, before anything is meshed" {
  for arguments in "" "a.step" "a.step --to" "a.step --to out --frob" "a.step --to out --size -1" \
    "a.step --to out -o x" "a.step --to out --jobs x" \
    "a.step --to out --threads x" "- --to out" "a/x.step b/x.iges --to out"; do
    # shellcheck disable=SC2086
    run -2 --separate-stderr "$quadbatch" $arguments
    assert_equal "${stderr_lines[1]}" "try 'quadbatch --help'"
  done
  run -3 "$quadbatch" out --to out
  run -4 "$quadbatch" x.step --to /dev/null/out
}

@test "--name names the boundaries of every shape" {
  "$quadbatch" -q "$DATA/square.step" "$DATA/half_disc.step" --to meshes --name 'wall=*' --name floor=0
  for shape in square half_disc; do
    assert_equal "$(sed -nE 's/^1 [0-9]+ "(.*)"$/\1/p' meshes/$shape.msh | sort | xargs)" "floor wall"
  done
}

@test "every option of quadmesh is passed on, but those of one shape" {
  "$quadbatch" -q "$DATA/regions/layered_beam.step" --to meshes --region-name 'core=*' --keep-joints --jobs 1 \
    --size 0.5 --offset 0=0.1
  run -0 jq -r '.options | join(" ")' meshes/layered_beam.result.json
  assert_output "--region-name core=* --keep-joints --size 0.5 --offset 0=0.1"
  printf '0 0\n1 0\n1 1\n0 1\n' >square.dat
  "$quadbatch" -q square.dat --to meshes --straight --points-unit mm --farfield box:3
  assert_file_exists meshes/square.msh
  for option in $(quadmesh --list-options | awk '{ print $2 }'); do
    run "$quadbatch" "$option"
    refute_output --partial "unknown option"
  done
  for option in '--html x.html' '--write-healed x.step' '--from critpoints' --dry-run; do
    # shellcheck disable=SC2086
    run -2 --separate-stderr "$quadbatch" "$DATA/square.step" --to out $option
    assert_equal "${stderr_lines[0]}" "quadbatch: ${option%% *} is for one shape: run quadmesh on it"
  done
}

@test "a shape whose name has no room for its results has a row with its message" {
  long=$(printf 'a%.0s' {1..248})
  cp "$DATA/square.step" "$long.step"
  run -1 --separate-stderr here "$quadbatch" "$DATA/half_disc.step" "$long.step" "$(printf 'b%.0s' {1..70000})" --to out
  assert_output "3 shapes: 1 with a mesh, 2 without, 0 done before: out/table.html"
  assert_equal "$(column exit_code | sort | paste -sd ' ')" "0 4 4"
  assert_equal "$(column message | grep -c 'is too long for the names of its results: rename the shape')" 2
  assert_equal "$(find out -name '.*' ! -name .)" ""
}

@test "names with blanks, quotes and braces" {
  cp "$DATA/square.step" "it's {} a \$shape; 1.step"
  echo '"a b"' >'block names'
  run -0 here "$quadbatch" ./*.step --to 'the {.} "meshes"' --block-names 'block names'
  assert_file_exists "the {.} \"meshes\"/it's {} a \$shape; 1.msh"
  assert_file_exists 'the {.} "meshes"/table.csv'
}

# tree PID: the process and all below it.
tree() {
  local child
  echo "$1"
  for child in $(pgrep -P "$1"); do tree "$child"; done
}

@test "killed without warning, it leaves no half result under a result's name, and is continued" {
  replace_stage quadexport 'case "$*" in *square.quad.h5*) [ -e started ] || { echo >started; exec sleep 60; } ;; esac' \
    'exec quadexport "$@"'
  TMPDIR=$PWD HOME=$PWD "$quadbatch" "${replaced[@]}" "$DATA"/{half_disc,square}.step --to out --jobs 1 3>&- &
  until [[ -e started ]]; do sleep 0.05; done
  # shellcheck disable=SC2046
  kill -KILL $(tree $!)
  wait $! || true
  assert_equal "$(cd out && ls -A | paste -sd ' ')" \
    ".square.part half_disc.blocks.svg half_disc.msh half_disc.report.json half_disc.result.json"
  run -0 here "$quadbatch" "${replaced[@]}" "$DATA"/{half_disc,square}.step --to out --jobs 1
  assert_output "2 shapes: 2 with a mesh, 0 without, 1 done before: out/table.html"
  assert_equal "$(find out -type f | wc -l)" 10
  assert_not_exists out/.square.part
}

@test "other hosts by parallel's own options" {
  run -0 here "$quadbatch" "$DATA/square.step" --to out --sshlogin 1/: -v --no-table
  assert_line --regexp 'square.step: 1 block, 0 irregular nodes, [0-9]+ quads \([.0-9]+ s\)'
  assert_line "1 shape: 1 with a mesh, 0 without, 0 done before"
  assert_not_exists out/table.csv
}

@test "the help's examples work" {
  mkdir shapes
  cp "$DATA/half_disc.step" "$DATA/plate_hole.step" .
  cp "$DATA/square.step" shapes
  "$quadbatch" --help | sed -n '/^EXAMPLES/,$p' | grep '^  quadbatch' >examples
  assert [ "$(wc -l <examples)" -ge 3 ]
  while read -r _ arguments; do
    # shellcheck disable=SC2086
    run -0 "$quadbatch" $arguments
  done <examples
  assert_equal "$(wc -l <meshes/table.csv)" 4
}

@test "the page's commands, its Slurm job and its Snakemake rules work" {
  page=$ROOT/pipelines/quadbatch.md
  ln -s "$ROOT/pipelines" .
  mkdir shapes
  cp "$DATA/square.step" "$DATA/half_disc.step" "$DATA/bad/open_wire.step" shapes
  sed -nE '/^```/,/^```/d; s/^    ([^ ].*)/\1/p' "$page" >commands
  assert_equal "$(wc -l <commands)" 4
  assert_equal "$(grep '^```.' "$page" | paste -sd ' ')" '```sh ```python' # the job and the rules, below
  # In place of other hosts.
  mkdir hosts
  printf '%s\n' '#!/bin/sh' 'while [ "${1#-}" != "$1" ]; do shift; done; echo >>"hosts.$1"; shift; exec sh -c "$*"' >hosts/ssh
  chmod +x hosts/ssh
  { sed '$d' commands; echo rm -r meshes; tail -n 1 commands; } >all
  PATH=$PWD/hosts:$PATH HOME=$PWD run bash -uo pipefail all
  assert_line --regexp '^shapes/open_wire.step,3,'
  assert_line '"shapes/half_disc.step"'
  assert_line "3 shapes: 2 with a mesh, 1 without, 0 done before: meshes/table.html"
  assert_file_exists "hosts.node1"
  rm -r meshes
  sed -n '/^```sh$/,/^```$/p' "$page" | sed '1d;$d' >job
  ls shapes/*.step >shapes.txt
  SLURM_ARRAY_TASK_ID=0 SLURM_CPUS_PER_TASK=2 run bash job
  pipelines/quadbatch --to meshes
  assert_equal "$(wc -l <meshes/table.csv)" 4
  rm -r meshes
  command -v snakemake || skip "no snakemake"
  sed -n '/^```python$/,/^```$/p' "$page" | sed '1d;$d' >Snakefile
  HOME=$PWD run -0 snakemake --cores 2
  assert_equal "$(wc -l <meshes/table.csv)" 4
}
