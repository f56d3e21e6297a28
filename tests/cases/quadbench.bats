# pipelines/quadbench: the server of the workbench. Its page in a browser is tested in tests/peers/browser.bats.
load ../tools/common

quadbench=$ROOT/pipelines/quadbench

setup() {
  common_setup
  mkdir tmp shapes
  cp "$DATA/half_disc.step" shapes
  number=0
}

teardown() {
  [[ -z ${bench-} ]] || kill -KILL "$bench" 2>/dev/null || :
}

# open_bench WORD...: starts the workbench; sets $bench, its process, and $address.
open_bench() {
  rm -f address
  TMPDIR=$PWD/tmp "$quadbench" "$@" --no-browser >address 2>messages 3>&- &
  bench=$!
  until [[ -s address ]]; do
    kill -0 $bench || fail "$(cat messages)"
    sleep 0.05
  done
  address=$(sed 's/^quadbench: //' address)
}

# ask NAME [JSON] [HEADER:VALUE...]: as the page does.
ask() { "$BATS_TEST_DIRNAME/bench_request.py" "$address" "$@"; }

# mesh_of STATE: runs it; the answer is in answer.json.
mesh_of() {
  number=$((number + 1))
  ask run "{\"number\": $number, \"state\": $1}" >answer.json
}

# answered FILTER: what jq takes from the answer.
answered() { jq -cr "$1" answer.json; }

# save STATE WHAT
save() { ask save "{\"state\": $1, \"what\": \"$2\"}" >answer.json; }

# ends_with CODE: the workbench has ended and left nothing.
ends_with() {
  local code=0
  wait $bench || code=$?
  assert_equal $code "$1"
  bench=
  assert_equal "$(find tmp -mindepth 1)" ""
}

# data_of_page: the data of the page.
data_of_page() { ask "" | sed -n 's|.*<script type="application/json" id="data">\(.*\)</script>.*|\1|p'; }

# move DX: the state in which the first node of the page is moved to the right.
move() {
  jq -c --argjson dx "$1" '.workbench.nodes[0].position as $p | {moves: [{node: $p, to: [$p[0] + $dx, $p[1]]}]}' page.json
}

# stages: those that ran for the answer, but for trials.
stages() { answered '.report.stages | keys_unsorted | map(select(startswith("trial_") | not)) | join(" ")'; }

# shown FOLDER: the mesh that is shown, of the nodes that were found or moved.
shown() { find tmp/quadbench.*/"$1"/mesh -name half_disc.msh; }

# saved: the mesh of the saved command.
saved() {
  (cd / && "$OLDPWD/shapes/half_disc.quadmesh.sh" >/dev/null)
  echo shapes/half_disc.msh
}

@test "the page has the data of the first mesh, the state of the command line and the command" {
  open_bench shapes/half_disc.step --size 0.3 --name wall=0 --order 3 --threads 1
  assert_equal "$(cat messages)" ""
  [[ $address =~ ^http://127\.0\.0\.1:[0-9]+/[A-Za-z0-9_-]{22}/$ ]]
  data_of_page >page.json
  assert_equal "$(jq -c '[.sheets[].title]' page.json)" '["Critical points","Separatrices","Blocks","Quad mesh"]'
  assert_equal "$(jq -r .workbench.command page.json)" \
    "quadmesh half_disc.step --threads 1 --name wall=0 --size 0.3 --order 3 -o half_disc.msh"
  jq -e '.workbench | .state.size == 0.3 and .state.options == ["--order", "3"] and .shape == "half_disc.step" and
    (.nodes | map(.valence)) == [3, 3] and (.corners[0] | .curves | length) == 2 and .report.quads > 0' page.json
  ask "" >page.html
  grep -q "connect-src 'self'" page.html
  kill $bench
}

@test "a dragged node: only the stages from the lines on run; the saved command gives the same bytes; undo" {
  open_bench shapes/half_disc.step
  data_of_page >page.json
  cp $(shown found) first.msh
  mesh_of "$(move 0.02)"
  jq -e '.ok and .warnings == [] and (.page.sheets | length) == 4' answer.json
  assert_equal "$(stages)" "phase_fieldsolve phase_padapt separatrix blocksplit quadrefine quadexport"
  assert_equal "$(answered .command)" "quadmesh half_disc.step --nodes half_disc.crit.json -o half_disc.msh"
  run ! cmp $(shown moved) first.msh
  cp $(shown moved) moved.msh
  save "$(move 0.02)" command
  assert_equal "$(answered .file)" half_disc.quadmesh.sh
  cmp "$(saved)" moved.msh
  assert_equal "$(ls shapes | paste -sd ' ')" "half_disc.crit.json half_disc.msh half_disc.quadmesh.sh half_disc.step"
  # The sizes change: the field of these nodes is there. Then back, where nothing is to be made.
  mesh_of "$(move 0.02 | jq -c '. + {size: 0.3}')"
  assert_equal "$(stages)" "quadrefine quadexport"
  mesh_of '{}'
  assert_equal "$(answered .command)" "quadmesh half_disc.step -o half_disc.msh"
  cmp $(shown found) first.msh
  cmp <(answered '.page.sheets') <(jq -c .sheets page.json)
  save '{}' command
  cmp "$(saved)" first.msh
  # Moved twice, in two moves or in one.
  mesh_of "$(move 0.02 | jq -c '.moves += [{node: .moves[0].to, to: [.moves[0].to[0] + 0.01, .moves[0].to[1]]}]')"
  cp $(shown moved) twice.msh
  run ! cmp twice.msh moved.msh
  kill $bench
}

@test "names, sizes, layers and corners: the stages that change run, and the saved command gives the same bytes" {
  local state='{"names": [{"curves": [0], "name": "wall"}]'
  open_bench shapes/half_disc.step --size 0.2
  while read -r more stages; do
    mesh_of "$state$more}"
    assert_equal "$(answered .ok) $(stages | cut -d ' ' -f 1)" "true $stages"
    save "$state$more}" command
    cp $(shown found) shown.msh
    cmp "$(saved)" shown.msh
  done <<'END'
,"size":0.2 cad2tri
,"size":0.25 quadrefine
,"near":{"wall":0.05} quadrefine
,"walls":{"wall":"first=0.01,growth=1.2,layers=3"} critpoints
,"valences":[{"corner":[0,1],"valence":2}] critpoints
,"options":["--unit","m"] critpoints
,"options":["--unit","cm"] quadrefine
END
  save "$state}" makefile
  assert_equal "$(answered .file)" half_disc.mk
  rm shapes/half_disc.msh
  (cd shapes && PATH=$BIN:$PATH make -s -f half_disc.mk >/dev/null)
  assert_file_exists shapes/half_disc.msh
  save "$state}" nodes
  run -0 jq -r .format shapes/half_disc.crit.json
  assert_output critical-points
  kill $bench
}

@test "regions, points and formats: the saved command finds its files from the folder" {
  mkdir shapes/out
  cp "$DATA/regions/disc_in_square.step" shapes
  open_bench shapes/disc_in_square.step --size 0.3 -o shapes/out/x.vtu --folder .
  data_of_page >page.json
  local state
  state=$(move 0.01 | jq -c '. + {size: 0.3}')
  mesh_of "$state"
  assert_equal "$(answered .ok)" true
  assert_equal "$(answered .command)" \
    "quadmesh shapes/disc_in_square.step --size 0.3 --nodes disc_in_square.crit.json -o shapes/out/x.vtu"
  save "$state" command
  sh disc_in_square.quadmesh.sh >/dev/null
  cmp shapes/out/x.vtu tmp/quadbench.*/moved/mesh/shapes/out/x.vtu
  kill $bench
}

@test "a shape that was changed meanwhile is read again" {
  open_bench shapes/half_disc.step
  mesh_of '{}'
  assert_equal "$(stages | cut -d ' ' -f 1)" cad2tri # of the first mesh: nothing has changed
  cp "$DATA/square.step" shapes/half_disc.step
  mesh_of '{}'
  assert_equal "$(answered .report.blocks)" 1
  rm shapes/half_disc.step
  mesh_of '{}'
  assert_equal "$(answered .ok)" false
  kill $bench
}

@test "options that nodes take the place of are left out of the command, those of later stages too are kept" {
  open_bench shapes/half_disc.step --symmetry none --place energy
  data_of_page >page.json
  local state
  state=$(move 0.01 | jq -c '. + {options: ["--symmetry", "none", "--place", "energy"]}')
  mesh_of "$state"
  assert_equal "$(answered .command)" \
    "quadmesh half_disc.step --symmetry none --nodes half_disc.crit.json -o half_disc.msh"
  cp $(shown moved) moved.msh
  save "$state" command
  cmp "$(saved)" moved.msh
  kill $bench
}

@test "a mistake in the page changes nothing, and its message is that of quadmesh" {
  open_bench shapes/half_disc.step
  cp $(shown found) first.msh
  mesh_of '{"walls": {"wall": "first=0.01,layers=3"}}'
  assert_equal "$(answered .ok)" false
  run -0 answered .message
  assert_output --partial 'there is no boundary "wall"; the names are'
  for state in '{"size": "x"}' '{"options": ["-o", "x.msh"]}' '{"options": ["--stage", "cad2tri=touch x"]}' 'null' \
    '{"moves": [{"node": [9, 9], "to": [0, 0]}]}'; do
    mesh_of "$state"
    assert_equal "$(answered .ok)" false
  done
  assert_equal "$(answered .message)" "there is no irregular node at (9, 9), as the other changes have others: undo this move"
  assert_file_not_exists x
  mesh_of '{}'
  assert_equal "$(answered .ok)" true
  cmp $(shown found) first.msh
  kill $bench
}

@test "a newer change stops the run of an older one" {
  open_bench shapes/half_disc.step
  ask run '{"number": 1, "state": {"size": 0.004, "options": ["--order", "8"]}}' >older.json &
  local older=$!
  until [[ -e $(echo tmp/quadbench.*/found/aside/half_disc.quad.h5) ]]; do sleep 0.02; done
  number=1
  mesh_of '{"size": 0.3}'
  assert_equal "$(answered .ok)" true
  wait $older
  assert_equal "$(jq -c . older.json)" '{"number":1,"ok":false,"overtaken":true}'
  number=0
  mesh_of '{}'
  assert_equal "$(answered .overtaken)" true
  kill $bench
}

@test "only its own page is answered: no other token, host, origin, kind of content or path" {
  open_bench shapes/half_disc.step
  local token own=${address#http://} state='{"number": 1, "state": {}}'
  token=${own#*/} own=${own%%/*}
  while read -r refusal words; do
    run -1 eval "ask $words"
    assert_output "$refusal"
  done <<END
404 /
404 /${token:0:21}/
404 /${token%/}x/
404 /wrong/run '$state'
404 page
404 half_disc.step
404 ../shapes/half_disc.step
404 /${token}../../../../../etc/passwd
403 "" Host:evil.example
403 "" Host:evil.example:${own#*:}
403 run '$state' Origin:http://evil.example
403 run '$state' Origin:null
403 save '{"what": "command", "state": {}}' Origin:https://$own
415 run '$state' Content-Type:text/plain
400 save '{"what": "../x", "state": {}}'
413 run '{}' Content-Length:1048577
END
  assert_equal "$(ls shapes)" half_disc.step
  ask run "$state" "Origin:http://$own" >answer.json
  assert_equal "$(answered .ok)" true
  # Nobody listens at other addresses of this machine.
  run ! python3 -c "import socket; socket.create_connection(('127.0.0.2', ${own#*:}), 1)"
  kill $bench
}

@test "it ends when the page is closed, by Ctrl-C and by SIGTERM, also in work, and leaves nothing" {
  open_bench shapes/half_disc.step
  ask alive 1
  ends_with 0
  for signal in INT TERM; do
    open_bench shapes/half_disc.step
    ask run '{"number": 1, "state": {"size": 0.004, "options": ["--order", "8"]}}' >/dev/null 2>&1 &
    until [[ -e $(echo tmp/quadbench.*/found/aside/half_disc.quad.h5) ]]; do sleep 0.02; done
    kill -$signal $bench
    ends_with $((128 + $(kill -l $signal)))
  done
  assert_equal "$(ls shapes)" half_disc.step
}

@test "the failure of the first mesh is that of quadmesh; a port that is in use is refused" {
  TMPDIR=$PWD/tmp run -3 "$quadbench" "$DATA/bad/open_wire.step" --no-browser
  assert_output --partial "the wire is open"
  open_bench shapes/half_disc.step
  local port=${address#http://127.0.0.1:}
  TMPDIR=$PWD/tmp run -2 "$quadbench" shapes/half_disc.step --port "${port%%/*}" --no-browser
  assert_output --partial "--port: ${port%%/*} cannot be opened: address already in use"
  kill $bench
}

@test "the browser is opened at the address, if there is one" {
  mkdir bin
  printf '#!/bin/sh\necho "$@" >opened\n' >bin/xdg-open
  chmod +x bin/xdg-open
  TMPDIR=$PWD/tmp PATH=$PWD/bin:$PATH "$quadbench" shapes/half_disc.step >address 3>&- &
  bench=$!
  until [[ -s opened ]]; do sleep 0.05; done
  assert_equal "quadbench: $(cat opened)" "$(cat address)"
  kill $bench
  wait $bench || :
  ln -s "$(command -v python3)" bin/python3
  rm bin/xdg-open address
  TMPDIR=$PWD/tmp PATH=$PWD/bin "$quadbench" shapes/half_disc.step >address 2>messages 3>&- &
  bench=$!
  until [[ -s address ]]; do sleep 0.05; done
  assert_equal "$(cat messages)" ""
  kill $bench
}

# Every line of EXAMPLES, and of the page, until it serves.
@test "the examples of the help and the commands of its page work" {
  cd shapes
  cp half_disc.step shape.step && ln -s ../tmp . && ln -s "$ROOT/pipelines" .
  "$quadbench" --help | sed '1,/^EXAMPLES$/d; s/^  //' >../examples
  "$ROOT/tests/page_commands.py" lines pipelines/quadbench.md | cut -f 3 >>../examples
  assert [ "$(wc -l <../examples)" -ge 3 ]
  while read -r _ words; do
    open_bench ${words/--no-browser/}
    kill -TERM $bench
    ends_with 143
  done <../examples
}
