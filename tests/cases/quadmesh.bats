# pipelines/quadmesh: one line for a person, a report for programs, messages and exit codes that come through.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh

# here COMMAND...: with the test's folder for temporaries too, so that what is left is seen.
here() { TMPDIR=$PWD "$@"; }

@test "the only words are one line about the mesh; nothing but the mesh is left" {
  run -0 --separate-stderr here "$quadmesh" "$DATA/half_disc.step" -o out.msh
  assert_output --regexp '^4 blocks, 2 irregular nodes, [0-9]+ quads, worst scaled Jacobian 0\.[0-9]+, greatest edge ratio [.0-9]+; good$'
  assert_equal "$stderr" ""
  assert_nothing_left out.msh
}

@test "a STEP file is a model of the blocks, in the unit that is asked for" {
  run -0 "$quadmesh" "$DATA/half_disc.step" -o out.step --unit m --report out.json --workdir stages
  assert_output --partial "coordinates in metre, 0.001 times those of the CAD file"
  assert_equal "$(jq -c '[.unit, .scale]' out.json)" '["metre",0.001]'
  quadexport --unit m stages/half_disc.blocks.h5 -o again.step
  cmp out.step again.step
  rm out.step stages/half_disc.quad.h5
  run -0 "$quadmesh" -q --from quadexport --workdir stages --unit m -o out.step
  cmp out.step again.step
}

# strip HEIGHT: a rectangle of length 10.
strip() { printf '%s\n' "0 0" "10 0" "10 $1" "0 $1" | "$ROOT/pipelines/points2step" - --straight -o strip.step; }

@test "the line ends with a verdict, which names an option that makes the mesh better, and so does the report" {
  strip 0.2
  run -0 --separate-stderr "$quadmesh" strip.step --size 0.5 -o out.msh --workdir . --report before.json
  assert_output --regexp '; usable: resolution ratio [.0-9]+ near \(.*\), elements there are [.0-9]+ by [.0-9]+ prescribed lengths, chord [0-9]+ has [0-9]+ % of the error; give --size 0.25 \(about [0-9]+ quads\) for a lower resolution ratio$'
  assert_equal "$(jq -r '.verdict.text' before.json)" "${output#*; }"
  run -0 jq -c '.verdict | [.grade, .limit, .option, (.position | length), .value > 10]' before.json
  assert_output '["usable","resolution ratio","--size 0.25",2,true]'
  run -0 "$quadmesh" strip.step --size 0.25 -o out.msh --report after.json
  assert_output --regexp '; good$'
  run -0 stagecheck -v strip.quad.h5 --report check.json
  assert_output --partial '; usable: resolution ratio'
  assert_equal "$(jq -r .verdict.grade check.json)" usable
}

@test "a corner that no mesh can better is named, and no option" {
  printf '%s\n' "0 0" "10 0" "10 3" | "$ROOT/pipelines/points2step" - --straight -o wedge.step
  run -0 "$quadmesh" wedge.step -o out.msh --report out.json
  assert_output --partial "least scaled Jacobian 0.29, that of the face's corner of 17 degrees, which no mesh can better, at (0, 0)"
  assert_equal "$(jq -c .verdict.option out.json)" null
}

@test "one block, zero nodes: the line counts in English" {
  run -0 "$quadmesh" "$DATA/square.step" -o out.msh
  assert_output --regexp '^1 block, 0 irregular nodes, [0-9]+ quads, worst scaled Jacobian 1, greatest edge ratio 1; good$'
}

@test "the mesh goes to standard output, the line then to standard error" {
  "$quadmesh" "$DATA/square.step" >piped.msh 2>words
  "$quadmesh" "$DATA/square.step" -o file.msh
  cmp piped.msh file.msh
  run -0 cat words
  assert_output --regexp '^1 block, .*'
  run -0 "$quadmesh" -q "$DATA/square.step" -o quiet.msh
  assert_output ''
}

@test "a shape comes in through standard input" {
  "$quadmesh" - -o piped.msh <"$DATA/square.step"
  "$quadmesh" "$DATA/square.step" -o file.msh <&-
  cmp piped.msh file.msh
}

@test "--html writes a page of all stages, not of files that an earlier run left" {
  folder=$BATS_TEST_TMPDIR/stages
  mkdir "$folder" && echo old >"$folder/half_disc.phase.h5"
  run -0 "$quadmesh" -q "$DATA/half_disc.step" -o out.msh --html page.html --workdir "$folder"
  assert_output ''
  run -0 grep -oE '"title":"[A-Z][a-z ]+","name"' page.html
  assert_equal "${#lines[@]}" 6
  run -2 "$quadmesh" "$DATA/half_disc.step" -o other.msh --html page.svg
  assert_nothing_left out.msh page.html
}

@test "--html-parts chooses the tabs of the page" {
  run -0 "$quadmesh" -q "$DATA/half_disc.step" -o out.msh --html page.html --html-parts quads,blocks
  run -0 grep -oE '"title":"[A-Z][a-z ]+","name"' page.html
  assert_output '"title":"Blocks","name"
"title":"Quad mesh","name"'
  run ! grep -q '"type":"samples"' page.html
  run -2 "$quadmesh" -q "$DATA/half_disc.step" -o out.msh --html other.html --html-parts hexahedra
  assert_output "quadmesh: --html-parts: this run makes none of the parts: name others"
  assert_file_not_exists other.html
}

@test "the page of --html has the report of the run and the commands, without folders" {
  run -0 "$quadmesh" -q "$DATA/half_disc.step" -o out.msh --html page.html --report report.json --size=0.2
  assert_output ''
  sed -n 's/^.*<script type="application\/json" id="data">\(.*\)<\/script>$/\1/p' page.html >data.json
  assert_equal "$(jq -r .report.command data.json)" \
    "quadmesh -q half_disc.step -o out.msh --html page.html --report report.json --size=0.2"
  assert_equal "$(jq -c '.report | del(.command, .tool)' data.json)" "$(jq -c 'del(.tool)' report.json)"
  assert_equal "$(jq -r '.commands[]' data.json | grep -v '^#' | cut -d ' ' -f 1 | xargs)" \
    "cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine"
  assert_equal "$(jq -r '.commands[-1]' data.json | grep -oE -e '--size=[0-9.]+')" --size=0.2
  run ! grep -qF "$DATA" page.html
}

@test "--workdir keeps the file of every stage, --report the counts and the seconds of every stage" {
  run -0 "$quadmesh" "$DATA/half_disc.step" --output=out.msh --workdir=stages --report=report.json
  assert_equal "$(ls stages | xargs)" "half_disc.blocks.h5 half_disc.crit.json half_disc.field.h5 half_disc.quad.h5 \
half_disc.sep.json half_disc.solve.h5 half_disc.tri.h5"
  run -0 jq -r '[.critical_points, .irregular_nodes, .blocks, .quads > 0, .least_jacobian_bound > 0,
    .least_scaled_jacobian > 0, .cpu_seconds > 0, .wall_seconds > 0, (.warnings | length)] | @csv' report.json
  assert_output '2,2,4,true,true,true,true,true,0'
  run -0 jq -r '.stages | keys_unsorted[], (map(.cpu_seconds > 0 and .wall_seconds > 0) | all)' report.json
  assert_equal "$(xargs <<<"$output")" \
    "cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport true"
}

@test "nodes at the least energy are taken where their mesh has the lower resolution ratio, whatever the sizes are" {
  run -0 --separate-stderr "$quadmesh" "$DATA/eccentric_annulus.step" -o fine.msh --report fine.json
  assert_equal "$stderr" ""
  run -0 jq -c '[.remedy, (.trials | map(.options)), .trials[1].resolution < 0.95 * .trials[0].resolution,
    (.stages | has("trial_separatrix") and has("remedy_separatrix"))]' fine.json
  assert_output '["critpoints --place energy",[null,"critpoints --place energy"],true,true]'
  run -0 "$quadmesh" "$DATA/eccentric_annulus.step" --size 0.3 -o coarse.msh --report coarse.json
  assert_equal "$(jq -c '[.trials, .blocks]' coarse.json)" "$(jq -c '[.trials, .blocks]' fine.json)"
  run -0 "$quadmesh" "$DATA/eccentric_annulus.step" --place keep -o keep.msh --report keep.json
  assert_equal "$(jq -c '[.remedy, .trials]' keep.json)" '[null,[]]'
  assert [ "$(jq .blocks keep.json)" -gt "$(jq .blocks fine.json)" ]
}

@test "a run that ends with the blocks tries the same nodes as a whole one" {
  run -0 "$quadmesh" -q "$DATA/eccentric_annulus.step" --workdir whole -o out.msh
  run -0 "$quadmesh" -q "$DATA/eccentric_annulus.step" --workdir part --until blocksplit --report report.json
  cmp whole/eccentric_annulus.blocks.h5 part/eccentric_annulus.blocks.h5
  assert_equal "$(jq -r .remedy report.json)" "critpoints --place energy"
}

@test "-v prints the share of each stage" {
  run -0 "$quadmesh" -v "$DATA/square.step" -o out.msh
  assert_equal "${#lines[@]}" 10
  assert_line --index 0 --regexp '^cad2tri +[0-9.]+ s CPU, [0-9]+ %$'
  assert_line --index 8 --regexp '^all stages +[0-9.]+ s CPU, [0-9.]+ s$'
}

@test "a mesh with the options of all stages in it is that of the single commands" {
  stage_chain half_disc
  quadexport half_disc.quad.h5 -o single.vtu
  "$quadmesh" -q "$DATA/half_disc.step" -o whole.vtu
  cmp single.vtu whole.vtu
  "$quadmesh" -q "$DATA/half_disc.step" -o whole.vtu --workdir .
  cmp single.vtu whole.vtu
}

@test "--size and --order reach the mesh" {
  "$quadmesh" "$DATA/square.step" -o coarse.msh --size 0.5 --order 2 --report coarse.json
  assert_equal "$(jq .quads coarse.json)" 4
}

@test "--geometry-tol reaches the mesh: fewer quads of a low order follow the arc less closely" {
  "$quadmesh" "$DATA/half_disc.step" -o close.msh --size 0.5 --order 2 --geometry-tol 1e-6 --report close.json
  "$quadmesh" "$DATA/half_disc.step" -o loose.msh --size 0.5 --order 2 --geometry-tol 1e-3 --report loose.json
  jq -n -e --slurpfile close close.json --slurpfile loose loose.json '$loose[0].quads < $close[0].quads'
}

@test "--boundary-names renames boundary curves, by name or number" {
  echo '{"0": "floor", "curve_1": "roof"}' >names.json
  "$quadmesh" "$DATA/half_disc.step" -o out.msh --boundary-names names.json
  run -0 sed -n '/^\$PhysicalNames/,/^\$EndPhysicalNames/s/^1 [0-9]* //p' out.msh
  assert_output '"floor"
"roof"'
  echo '{"7": "wall"}' >names.json
  run -3 --separate-stderr "$quadmesh" "$DATA/half_disc.step" -o other.msh --boundary-names names.json
  [[ $stderr == "cad2tri: "*names.json*'"7"'* ]] || fail "$stderr"
  assert_file_not_exists other.msh
}

@test "--name names boundary curves without a file, several times" {
  "$quadmesh" "$DATA/half_disc.step" -o out.msh --name 'the floor=0' --name=roof@0,1
  run -0 sed -n '/^\$PhysicalNames/,/^\$EndPhysicalNames/s/^1 [0-9]* //p' out.msh
  assert_output '"the floor"
"roof"'
  run -3 --separate-stderr "$quadmesh" "$DATA/half_disc.step" -o other.msh --name lid=7
  [[ $stderr == "quadmesh: --name lid=7: no boundary curve has the number 7; the curves are 0 "* ]] || fail "$stderr"
  assert_file_not_exists other.msh
}

@test "--unit converts the mesh, and the line and the report say so" {
  run -0 "$quadmesh" "$DATA/half_disc.step" -o out.msh --unit m --report out.json
  assert_output --partial ", coordinates in metre, 0.001 times those of the CAD file"
  assert_equal "$(jq -r '"\(.unit) \(.scale)"' out.json)" "metre 0.001"
  run -0 "$quadmesh" "$DATA/half_disc.step" -o out.msh --report out.json
  refute_output --partial "coordinates"
  assert_equal "$(jq -r '"\(.unit) \(.scale)"' out.json)" "millimetre 1"
}

@test "the same shape twice gives the same bytes at every stage" {
  for shape in half_disc plate_hole; do
    "$quadmesh" "$DATA/$shape.step" -o a.msh --workdir a
    "$quadmesh" "$DATA/$shape.step" -o b.msh --workdir b
    run -0 diff -r a b
    cmp a.msh b.msh
  done
}

@test "pipes give the same bytes as files" {
  "$quadmesh" "$DATA/half_disc.step" -o a.msh --size 0.1 --workdir a
  cad2tri "$DATA/half_disc.step" | fieldsolve | padapt -o b.field.h5
  critpoints b.field.h5 | separatrix b.field.h5 - | blocksplit | quadrefine --size .1 | quadexport -o b.msh
  cmp a/half_disc.field.h5 b.field.h5
  cmp a.msh b.msh
}

@test "bad input: the message and the exit code of the stage come through, nothing is left" {
  : >empty.step
  head -c 3000 "$DATA/half_disc.step" >truncated.step
  head -c 2000 /dev/urandom >garbage.step
  for shape in empty truncated garbage missing; do
    run -3 --separate-stderr here "$quadmesh" "$shape.step" -o out.msh
    assert_equal "${#stderr_lines[@]}" 1
    [[ $stderr == *": "*"$shape.step"* ]] || fail "$shape: $stderr"
    case $shape in empty | missing) assert_regex "$stderr" "^quadmesh: " ;; *) assert_regex "$stderr" "^cad2tri: " ;; esac
    assert_output ''
  done
  assert_nothing_left empty.step garbage.step truncated.step
}

@test "an impossible option of a stage is a usage error of quadmesh" {
  run -2 --separate-stderr here "$quadmesh" "$DATA/square.step" -o out.msh --order 0
  assert_equal "${stderr_lines[0]}" "quadmesh: --order: 0 is outside its interval (1 to 20)"
  assert_equal "${stderr_lines[1]}" "try 'quadmesh --help'"
  assert_nothing_left
}

@test "a mistake in the options of a late stage is told before any work is done" {
  replace_stage cad2tri 'touch started' 'exit 1'
  for options in "--size x" "--max-valence 3.5" "--simplify wrong" "-o out.unknown" "--format unknown" "--frame 4d"; do
    # shellcheck disable=SC2086 # words
    run -2 "$quadmesh" "${replaced[@]}" "$DATA/square.step" $options
    assert_file_not_exists started
  done
  run -1 "$quadmesh" "${replaced[@]}" "$DATA/square.step" -o out.msh
  assert_file_exists started
}

@test "an output that cannot be written is exit 4, nothing is left" {
  run -4 --separate-stderr here "$quadmesh" "$DATA/square.step" -o nowhere/out.msh
  [[ $stderr == "quadmesh: "*nowhere/out.msh* ]] || fail "$stderr"
  run -4 --separate-stderr here "$quadmesh" "$DATA/square.step" -o out.msh --report nowhere/report.json
  [[ $stderr == "quadmesh: "*nowhere/report.json* ]] || fail "$stderr"
  run -4 --separate-stderr here "$quadmesh" "$DATA/square.step" --format msh -o /dev/full
  [[ $stderr == "quadexport: "*/dev/full* ]] || fail "$stderr"
  assert_nothing_left
}

@test "mistakes on the command line are exit 2 with a hint" {
  for arguments in "" "--frob" "a.step b.step" "a.step -o"; do
    # shellcheck disable=SC2086
    run -2 --separate-stderr "$quadmesh" $arguments
    assert_equal "${stderr_lines[1]}" "try 'quadmesh --help'"
  done
}

@test "a stage that fails keeps the files before it, a picture of the last one and the command to look at it" {
  replace_stage blocksplit 'echo "blocksplit: no luck at (1, 2)" >&2' 'exit 1'
  run -1 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh --workdir kept
  assert_equal "${stderr_lines[0]}" "blocksplit: no luck at (1, 2)"
  assert_equal "${stderr_lines[1]}" \
    "quadmesh: the files of the stages before blocksplit are kept in kept; look at the last one with"
  assert_equal "${stderr_lines[2]}" "  xdg-open 'kept/half_disc.before-blocksplit.svg'"
  xmllint --noout kept/half_disc.before-blocksplit.svg
  assert_file_exists kept/half_disc.sep.json
  assert_file_not_exists out.msh
  # Without --workdir nothing stays, and the message says how to keep the files.
  rm -r kept
  run -1 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh
  assert_equal "${stderr_lines[1]}" \
    "quadmesh: run it again with --workdir DIR to keep the files of the stages before blocksplit and a picture"
  rm -r fake
  assert_nothing_left
}

# failing STAGE REPORT: the stage finds no valid result, and reports this JSON; the second time it succeeds.
failing() {
  replace_stage "$1" "[ ! -e begun ] || exec $1 \"\$@\"" 'touch begun' 'while [ "$1" != --report ]; do shift; done' \
    "echo '$2' >\"\$2\"" "echo '$1: no luck' >&2" 'exit 1'
}

@test "where the field has no result, the quads are made from triangles, with a warning" {
  failing critpoints '{"tool": "critpoints", "exit_code": 1, "error": "no luck", "timings": {"total":
    {"cpu_seconds": 1, "wall_seconds": 1}}, "warnings": []}'
  run -0 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh --report report.json
  assert_output --regexp ', by midpoint division of triangles; (good|usable: .*|poor: .*)$'
  assert_equal "${stderr_lines[0]}" "critpoints: no luck"
  assert_equal "${stderr_lines[1]}" "quadmesh: critpoints found no valid result: the quads are made without a field"
  assert_regex "${stderr_lines[2]}" '^separatrix: warning W-SEP-002: '
  run -0 jq -c '[.certificate.method, .given_up, .form, .critical_points, .valid, (.stages | keys_unsorted)[-4:]]' \
    report.json
  assert_output '["midpoint","critpoints: no luck",null,0,true,["midpoint_separatrix","midpoint_blocksplit","midpoint_quadrefine","quadexport"]]'
  # With -q, what a stage did not find is no error: nothing is printed.
  rm begun
  run -0 --separate-stderr here "$quadmesh" "${replaced[@]}" -q "$DATA/half_disc.step" -o out.msh
  assert_equal "$output$stderr" ""
  rm begun
  run -1 --separate-stderr "$quadmesh" "${replaced[@]}" -q "$DATA/half_disc.step" -o out.msh --layout traced
  assert_equal "${stderr_lines[0]}" "critpoints: no luck"
  rm -r fake begun
  assert_nothing_left out.msh report.json
}

@test "elements without a proof are replaced by those of triangles, requests that cannot be met are refused" {
  failing quadrefine '{"tool": "quadrefine", "exit_code": 1, "error": "no luck", "valid": false, "timings": {"total":
    {"cpu_seconds": 1, "wall_seconds": 1}}, "warnings": []}'
  run -0 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh
  assert_output --regexp ', by midpoint division of triangles; (good|usable: .*|poor: .*)$'
  rm begun
  run -1 --separate-stderr here "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o other.msh --layout traced
  run -1 --separate-stderr "$quadmesh" "$DATA/half_disc.step" -o other.msh --wall curve_0:first=1e-2,layers=60
  [[ $stderr != *"without a field"* ]] || fail "$stderr"
  assert_file_not_exists other.msh
}

# The band between a circle and a spiral that ends with a step after one lap: whatever starts at the step comes back to it.
snail() {
  awk 'BEGIN { pi = atan2(0, -1)
    for (k = 0; k <= 48; ++k) { t = 2 * pi * k / 48; r = 10 + k / 16; print r * cos(t), r * sin(t) }
    print ""
    for (k = 0; k < 24; ++k) { t = 2 * pi * k / 24; print 5 * cos(t), 5 * sin(t) } }' |
    "$ROOT/pipelines/points2step" -o snail.step
}

@test "the best of the meshes by which nodes are compared is that of quadrefine, and not made twice" {
  for shape in half_disc eccentric_annulus; do
    run -0 "$quadmesh" -q "$DATA/$shape.step" --workdir stages -o $shape.msh --report $shape.json
    run -0 quadrefine -q "stages/$shape.blocks.h5" -o again.quad.h5
    cmp again.quad.h5 "stages/$shape.quad.h5"
  done
  run -0 jq -c '[.stages | has("trial_quadrefine", "quadrefine")]' half_disc.json
  assert_output '[false,true]'
  run -0 jq -c '[.stages | has("trial_quadrefine", "quadrefine")]' eccentric_annulus.json
  assert_output '[true,true]'
}

@test "where a strip of blocks contains itself, a corner on it emits a node" {
  snail
  run -0 --separate-stderr here "$quadmesh" snail.step -o out.msh --report report.json --workdir stages
  run -0 --separate-stderr grep -c '^quadmesh: no layout with these nodes: trying critpoints --corner-valence' - <<<"$stderr"
  assert_output 2
  run -0 jq -c '[.certificate.method, .remedy, .blocks, .irregular_nodes, .given_up, .form]' report.json
  assert_output '["traced","critpoints --corner-valence 1:0=2",3,1,null,"phase"]'
  run -0 jq -c '[.warnings[].code] | unique' report.json # without that of the graph that was replaced
  assert_output '["W-ADAPT-002"]'
  run -0 jq '(.cpu_seconds - ([.stages[].cpu_seconds] | add) | fabs) < 1e-9 and (.stages | has("trial_separatrix"))' report.json
  assert_output true
  assert_equal "$(ls stages | xargs)" "snail.blocks.h5 snail.crit.json snail.field.h5 snail.phase.h5 \
snail.phase.solve.h5 snail.quad.h5 snail.sep.json snail.solve.h5 snail.tri.h5"
  run -0 stagecheck stages/*
  rm -r stages
  assert_nothing_left out.msh report.json snail.step
}

@test "options that the user chose are not replaced where a strip of blocks contains itself" {
  snail
  run -0 --separate-stderr here "$quadmesh" snail.step -o out.msh --report report.json --corner-valence 0:1=1
  run -0 jq -c '[.certificate.method, .remedy]' report.json
  assert_output '["midpoint",null]'
  [[ $stderr != *"trying"* ]] || fail "$stderr"
  run -1 "$quadmesh" snail.step -o out.msh --layout quantized
}

@test "where no other node helps, the strip of blocks stays, and triangles are divided" {
  snail
  replace_stage separatrix 'case "$*" in *.remedy.*) set -- --layout midpoint "$@" ;; esac' 'exec separatrix "$@"'
  run -0 --separate-stderr here "$quadmesh" "${replaced[@]}" snail.step -o out.msh --report report.json --workdir stages
  run -0 jq -c '[.certificate.method, .remedy, .given_up, .form, .valid]' report.json
  assert_output '["midpoint",null,null,"harmonic",true]'
  run -0 jq -c '[.warnings[].code] | sort' report.json
  assert_output --partial '"W-SEP-002"'
  run -0 jq '.stages | has("trial_separatrix") and (keys | map(select(startswith("remedy_"))) == [])' report.json
  assert_output true
  assert_equal "$(ls stages | xargs)" "snail.blocks.h5 snail.crit.json snail.field.h5 snail.quad.h5 snail.sep.json \
snail.solve.h5 snail.tri.h5"
}

@test "--layout midpoint solves for no field" {
  run -0 --separate-stderr "$quadmesh" "$DATA/half_disc.step" -o out.msh --layout=midpoint --report report.json
  assert_equal "$(grep -v W-QUA-005 <<<"$stderr")" ""
  run -0 jq -c '[.certificate.method, .given_up, (.stages | keys_unsorted)]' report.json
  assert_output '["midpoint",null,["cad2tri","separatrix","blocksplit","quadrefine","quadexport"]]'
}

# Replaces critpoints: writes its arguments to `arguments`, and asks for the first node 0.1 to the left of the field's own.
moving_critpoints() {
  replace_stage critpoints 'echo "$@" >arguments' 'field=$1' 'while [ "$1" != -o ]; do shift; done' \
    'critpoints "$field" -o moved.json --report "$4" &&' \
    "jq '.form = \"phase\" | .critical_points[0].position[0] -= 0.1' moved.json >\"\$2\""
}

@test "nodes that are not the field's own get a field that has them, in two more stages" {
  moving_critpoints
  run -0 "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh --workdir stages --report report.json
  run -0 jq -c '[.form, .blocks, (.stages | keys_unsorted | .[3:7])]' report.json
  assert_output '["phase",4,["critpoints","phase_fieldsolve","phase_padapt","separatrix"]]'
  assert_file_exists stages/half_disc.phase.h5
  run -0 jq -c '[.nodes[] | select(.kind == "irregular").position[0] * 1e6 | round]' stages/half_disc.sep.json
  assert_output '[-605081,505081]'
}

@test "the options that choose nodes reach critpoints" {
  moving_critpoints
  run -0 "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh --feature-size 0.1 \
    --corner-valence 0:1=1 --place=energy --corner-valence=1:0=1 --place-weight 0 --max-valence 5
  run -0 cat arguments
  assert_output --partial ".field.h5 --feature-size 0.1 --corner-valence 0:1=1 --place energy --corner-valence 1:0=1 \
--place-weight 0 --max-valence 5 -o "
  run -2 "$quadmesh" "$DATA/half_disc.step" --feature-size
  assert_line "quadmesh: --feature-size needs a value"
}

@test "an option goes to every stage that has it, and its value arrives as it is" {
  for stage in cad2tri quadrefine quadexport; do
    replace_stage $stage "printf '<%s>' \"\$@\" >$stage.words" "exec $stage \"\$@\""
  done
  run -0 "$quadmesh" "${replaced[@]}" "$DATA/square.step" -o out.msh --name $'a  *\nb =0' --allow-invalid --unit=m --size 0.5
  [[ $(cat cad2tri.words) == *$'.step><--name><a  *\nb =0><-o>'* ]] || fail "$(cat cad2tri.words)"
  [[ $(cat quadrefine.words) == *'.blocks.h5><--allow-invalid><--unit><m><--size><0.5><-o>'* ]] || fail "$(cat quadrefine.words)"
  [[ $(cat quadexport.words) == *'.quad.h5><--allow-invalid><--unit><m><-o><out.msh>'* ]] || fail "$(cat quadexport.words)"
}

@test "--stage: a command for the shell in place of a stage; all others give the same bytes" {
  "$quadmesh" "$DATA/half_disc.step" -o plain.msh --workdir plain
  for stage in cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport; do
    run -0 --separate-stderr here "$quadmesh" "$DATA/half_disc.step" -o other.msh --workdir other --report report.json \
      --stage "$stage=echo $stage >>ran; LC_ALL=C $stage"
    assert_equal "$stage$stderr" $stage
    assert_equal "$(cat ran)" $stage
    assert_equal "$(jq -c '[.stages[] | .cpu_seconds > 0] | [length, all]' report.json)" '[8,true]'
    cmp plain.msh other.msh
    diff -r plain other
    rm -r ran other
  done
}

@test "--stage: a mistake is one of quadmesh; a command that is not there, or writes nothing, is named" {
  for value in square blocks=true fieldsolve= =true; do
    run -2 --separate-stderr here "$quadmesh" "$DATA/square.step" -o out.msh --stage $value
    assert_regex "${stderr_lines[0]}" '^quadmesh: --stage: '
    assert_equal "${stderr_lines[1]}" "try 'quadmesh --help'"
  done
  run -2 "$quadmesh" "$DATA/square.step" -o out.msh --stage padaptt=true
  assert_line --index 0 --partial "quadmesh: --stage: 'padaptt' is no stage (did you mean padapt?): the stages are cad2tri "
  run -127 --separate-stderr here "$quadmesh" "$DATA/square.step" -o out.msh --report report.json --stage padapt=./nowhere
  assert_regex "${stderr_lines[0]}" '^padapt: .*nowhere.*not found'
  assert_equal "$(jq -c '[.exit_code, .stage]' report.json)" '[127,"padapt"]'
  rm report.json
  run -3 --separate-stderr here "$quadmesh" "$DATA/square.step" -o out.msh --stage padapt=true
  assert_regex "${stderr_lines[0]}" '\.field\.h5: '
  assert_nothing_left
}

@test "a stage that crashes is named, with the signal" {
  run -139 --separate-stderr here "$quadmesh" "$DATA/square.step" -o out.msh --report report.json \
    --stage 'padapt=kill -SEGV $$; true'
  assert_equal "${stderr_lines[0]}" "padapt: ended by signal 11"
  assert_equal "$(jq -c '[.exit_code, .stage, .error]' report.json)" '[139,"padapt","ended by signal 11"]'
  rm report.json
  assert_nothing_left
}

@test "the worker is killed in the middle: the stages run again, each in a process of its own, and give the same bytes" {
  "$quadmesh" -q "$DATA/geometry_4.step" -o plain.msh --workdir plain
  TMPDIR=$PWD "$quadmesh" "$DATA/geometry_4.step" -o out.msh --workdir stages --report report.json >words 2>&1 3>&- &
  local pid=$!
  until [[ -e stages/geometry_4.tri.h5 ]]; do sleep 0.01; done
  kill -KILL "$(pgrep -P $pid)"
  wait $pid
  assert_equal "$(wc -l <words)" 1
  assert_equal "$(jq -c '.stages | with_entries(select(.key | startswith("trial_") | not)) | length' report.json)" 8
  cmp plain.msh out.msh
  diff -r plain stages
  rm -r plain stages plain.msh
  assert_nothing_left out.msh report.json words
}

@test "the worker is killed while another program runs: that ends too, and runs again" {
  replace_stage separatrix '[ -e started ] || { echo $$ >started; exec sleep 30; }' 'exec separatrix "$@"'
  TMPDIR=$PWD "$quadmesh" -q "${replaced[@]}" "$DATA/square.step" -o out.msh 3>&- &
  local pid=$!
  until [[ -s started ]]; do sleep 0.05; done
  kill -KILL "$(pgrep -P $pid)"
  wait $pid
  # It may wait to be reaped by a system that does so late.
  run -0 sed -n 's/^State:[[:space:]]*\([RSD]\).*/\1/p' <(cat "/proc/$(cat started)/status" 2>&1)
  assert_output ''
  rm -r fake started
  assert_nothing_left out.msh
}

@test "a second run on the files of one shape in one --workdir waits for the first" {
  mkdir w
  exec 9>w/.square.lock
  flock 9
  "$quadmesh" "$DATA/square.step" --workdir w -o out.msh >words 2>&1 9>&- 3>&- &
  until grep -q . words; do sleep 0.01; done
  assert_equal "$(cat words) $(ls -A w)" "quadmesh: waits for another run that works on w/square.* .square.lock"
  exec 9>&-
  wait $!
  assert_file_exists out.msh
  assert_file_not_exists w/.square.lock
}

@test "--help-all has the options of the stages, as their own help has them" {
  "$quadmesh" --help-all >help
  for tool in critpoints separatrix blocksplit quadrefine quadexport; do
    sed -n "/^OPTIONS OF ${tool^^}\$/,/^\$/p" help | sed '1d;$d' >shown
    "$tool" --help | sed -n '/^OPTIONS$/,/^$/p' | sed '1d;$d' | sed '/^  -o,/,/^  --/{/^  --/!d}' | diff - shown
    [ -s shown ]
  done
}

@test "--help is one page of options that --help-all has" {
  "$quadmesh" --help >page
  "$quadmesh" --help-all | grep -oE '^  (-., )?--[a-z-]+' | sort -u >all
  assert [ "$(wc -l <page)" -le 40 ]
  grep -oE '^  (-., )?--[a-z-]+' page | sort -u | comm -23 - all >missing
  assert_file_empty missing
  assert [ "$(wc -l <all)" -ge 100 ]
}

@test "the command of the sources says where it is built if it was not" {
  cp "$quadmesh" .
  QUADRILLE_BIN='' run -1 ./quadmesh shape.step
  assert_output "quadmesh: there is no $PWD/../build/bin/quadmesh: pipelines/quickstart builds it"
  QUADRILLE_BIN=nowhere run -1 ./quadmesh --help
  assert_output "quadmesh: there is no nowhere/quadmesh: pipelines/quickstart builds it"
}

@test "a signal ends it with 128 + n and leaves nothing" {
  replace_stage separatrix 'echo >started' 'exec sleep 30'
  ends_with_signal "$quadmesh" "${replaced[@]}" "$DATA/half_disc.step" -o out.msh
}

@test "an interrupt in any stage leaves no temporary file, and no output" {
  for stage in cad2tri critpoints quadexport; do
    for signal in INT HUP; do
      replaced=()
      replace_stage $stage 'echo >started' 'exec sleep 30'
      TMPDIR=$PWD env --default-signal "$quadmesh" "${replaced[@]}" "$DATA/square.step" -o out.msh --report report.json 3>&- &
      local pid=$! code=0
      until [[ -e started ]]; do sleep 0.05; done
      kill -$signal $pid
      wait $pid || code=$?
      assert_equal "$stage $signal $code" "$stage $signal $((128 + $(kill -l $signal)))"
      rm -r fake started
      assert_nothing_left
    done
  done
}

@test "--help and --help-all show examples that run" {
  cp "$DATA/half_disc.step" "$DATA/bow_shock.step" "$DATA/curved/half_cylinder.step" "$ROOT"/pipelines/examples/{aerofoil.dat,plate.dxf} .
  cp "$DATA/alignment/bow_shock.align.json" shock.json
  printf 'x,y,h1,h2,angle\n-1,0,0.2,0.1,90\n' >metric.csv
  for help in --help --help-all; do "$quadmesh" $help | sed -n '/^EXAMPLES/,$p' | grep '^  quadmesh'; done | awk '!seen[$0]++' >examples
  while read -r _ arguments; do
    # shellcheck disable=SC2086
    run -0 "$quadmesh" $arguments
  done <examples
  run -0 "$quadmesh" --version
  assert_output --regexp '^quadmesh .*[0-9]+\.[0-9]+\.[0-9]+$'
}

@test "edges that do not meet are healed on the way, by as much as --heal-tolerance allows" {
  sed -E "s/^(#[0-9]+ = CIRCLE\('',#[0-9]+,)1\.\)/\11.0001)/" "$DATA/stadium.step" > slot.step
  run -0 --separate-stderr "$quadmesh" slot.step -o slot.msh --write-healed healed.brep
  assert_regex "$stderr" 'healed 4 joints'
  [[ -s healed.brep ]]
  run -3 --separate-stderr "$quadmesh" slot.step -o other.msh --heal-tolerance 1e-5
  assert_regex "$stderr" 'give --heal-tolerance'
}

@test "--face takes one face of a solid, and without it the message names the option" {
  run -0 --separate-stderr "$quadmesh" "$DATA/bad/solid.step" --face 4 -o side.msh --workdir stages
  run -3 --separate-stderr "$quadmesh" "$DATA/bad/solid.step" -o none.msh
  assert_regex "$stderr" '--face NUMBER or --face NAME'
  run -3 --separate-stderr "$quadmesh" "$DATA/bad/solid.step" --face=6 -o none.msh
  assert_regex "$stderr" '--face 6: no face'
  assert_file_not_exists none.msh
}

# With a first stage that takes so long that progress is shown from the second one on.
on_terminal() {
  script -qec "$(printf '%q ' "$@" --stage 'cad2tri=sleep 1.1; cad2tri')" /dev/null </dev/null
}

@test "on a terminal, one line shows the stage and its progress" {
  on_terminal "$quadmesh" "$DATA/half_disc.step" -o out.msh >written
  stage=1
  for tool in fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport; do
    stage=$((stage + 1))
    grep -q $'\r'"quadmesh: stage $stage of 8, $tool: [a-z]*, .*[1-9] s" written || fail "$tool: $(cat -v written)"
  done
  assert_equal "$(grep -c '' written)" 1
  on_terminal "$quadmesh" "$DATA/half_disc.step" --layout midpoint -o out.msh >written
  grep -q "quadmesh: stage 2 of 5, separatrix: divide, " written
  run -0 on_terminal "$quadmesh" -q "$DATA/half_disc.step" -o out.msh
  assert_output ''
}

@test "counts are chosen where the boundary, not the size, asks for short elements" {
  "$quadmesh" -q "$DATA/free_form.step" -o a.msh --report a.json
  run jq '.valid and .boundary.mesh_to_cad <= .boundary.tolerance and .resolution.ratio < 3' a.json
  assert_output true
}

@test "the report has the elements along each boundary, as --count prescribes them, and its gradings" {
  along() { jq -c '[.boundaries[] | [.name, .elements]] | map(join("=")) | join(" ")' -r a.json; }
  lines_of() { # of a name in a.msh of version 2.2, in the file's order: elements of one dimension, first tag
    awk -v name="\"$1\"" '$1 == 1 && $3 == name { group = $2 } /^\$/ { inside = $1 == "$Elements" }
      inside && NF > 5 && $4 == group && ($2 == 1 || $2 == 8 || $2 == 26 || $2 == 27) { ++count } END { print count }' a.msh
  }
  "$quadmesh" -q "$DATA/plate_hole.step" --name hole=4 --name 'rim=*' --size 1 --format msh22 -o a.msh --report a.json
  run -0 along
  assert_output "rim=$(lines_of rim) hole=$(lines_of hole)"
  run -0 jq -c '[.counts, .gradings]' a.json
  assert_output '[null,null]'
  jq -e '[.boundaries[] | .least_edge > 0 and .least_edge <= .greatest_edge] | all' a.json
  "$quadmesh" -q "$DATA/plate_hole.step" --name hole=4 --name 'rim=*' --size 1 --count hole=24 -o a.msh --report a.json
  assert_equal "$(jq -c '[.counts["0"].achieved, (.boundaries[] | select(.name == "hole") | .elements)]' a.json)" '[24,24]'
  "$quadmesh" -q "$DATA/plate_hole.step" --name hole=4 --name 'rim=*' --size 1 --count hole=24 --refine 1 -o a.msh \
    --report a.json
  assert_equal "$(jq -c '[.counts["0"].achieved, (.boundaries[] | select(.name == "hole") | .elements)]' a.json)" '[24,48]'
  "$quadmesh" -q "$DATA/square.step" --grading curve_0=0.02: -o a.msh --report a.json
  jq -e '.gradings["0"] | .boundary == "curve_0" and .first < 0.025 and .growth > 1' a.json
}
