# pipelines/quadmesh, driven stage by stage: --until, --from, --nodes, --dry-run, and the history of a file.
load ../tools/common

quadmesh=$ROOT/pipelines/quadmesh
shape=$DATA/half_disc.step

# The mesh, and the files of its stages, of a run from beginning to end.
setup_file() {
  cd "$BATS_FILE_TMPDIR" || return 1
  "$ROOT/pipelines/quadmesh" "$DATA/half_disc.step" -o whole.msh --workdir whole
}

setup() {
  common_setup
  whole=$BATS_FILE_TMPDIR/whole
}

# edited FILE: x.crit.json with its first node 0.1 to the left.
edited() {
  jq '.form = "phase" | .critical_points[0] |= {position: [.position[0] - 0.1, .position[1]], valence}' "$1"
}

# by_hand CRIT: hand.msh, by the single commands, from triangles, field and these nodes.
by_hand() {
  mkdir -p hand
  fieldsolve --nodes "$1" --orders "$whole/half_disc.field.h5" "$whole/half_disc.tri.h5" -o hand/half_disc.phase.solve.h5
  padapt hand/half_disc.phase.solve.h5 -o hand/half_disc.phase.h5
  separatrix hand/half_disc.phase.h5 "$1" -o hand/half_disc.sep.json
  blocksplit hand/half_disc.sep.json | quadrefine --size 0.1 -o hand/half_disc.quad.h5
  quadexport hand/half_disc.quad.h5 -o hand.msh
}

@test "--until ends after each stage, with the files up to it, and says which is the last" {
  expected=''
  for pair in cad2tri:tri.h5 fieldsolve:solve.h5 padapt:field.h5 critpoints:crit.json separatrix:sep.json \
    blocksplit:blocks.h5 quadrefine:quad.h5; do
    expected="$expected half_disc.${pair#*:}"
    run -0 --separate-stderr "$quadmesh" "$shape" --workdir stages --until "${pair%:*}"
    assert_output "stages up to ${pair%:*}: stages/half_disc.${pair#*:}"
    assert_equal "$stderr" ''
    assert_equal "$(ls stages | xargs)" "$(printf '%s\n' $expected | sort | xargs)"
    cmp "stages/half_disc.${pair#*:}" "$whole/half_disc.${pair#*:}"
    rm -r stages
  done
}

@test "--until without --workdir writes the file of the stage, and leaves no other" {
  export TMPDIR=$PWD
  for pair in cad2tri:tri.h5 fieldsolve:solve.h5 padapt:field.h5 critpoints:crit.json separatrix:sep.json \
    blocksplit:blocks.h5 quadrefine:quad.h5; do
    run -0 --separate-stderr "$quadmesh" "$shape" --until "${pair%:*}" -o "a.${pair#*:}"
    cmp "a.${pair#*:}" "$whole/half_disc.${pair#*:}"
    "$quadmesh" -q "$shape" --until "${pair%:*}" | cmp - "$whole/half_disc.${pair#*:}"
    rm "a.${pair#*:}"
    assert_nothing_left
  done
  assert_output --regexp '^4 blocks, 2 irregular nodes, [0-9]+ quads, '
  run -0 --separate-stderr "$quadmesh" "$shape" --until blocksplit
  assert_equal "$stderr" 'stages up to blocksplit: standard output'
  run -0 "$quadmesh" "$shape" --until blocksplit -o a.blocks.h5 --dry-run
  assert_equal "${lines[-1]}" 'blocksplit ./half_disc.sep.json -o a.blocks.h5'
  "$quadmesh" "$shape" --sweep --one-layer --until hexsweep -o a.hex.h5
  "$quadmesh" "$shape" --until quadrefine | hexsweep --one-layer | cmp - a.hex.h5
}

@test "--from goes on with the files of the stages before, and gives the same bytes" {
  for stage in fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport; do
    cp -r "$whole" stages
    run -0 --separate-stderr "$quadmesh" "$shape" --workdir stages --from "$stage" -o out.msh --report report.json
    assert_equal "$stderr" ''
    cmp out.msh "$BATS_FILE_TMPDIR/whole.msh"
    diff -r stages "$whole"
    assert_equal "$(jq -r '.stages | keys_unsorted[0]' report.json)" "$stage"
    rm -r stages
  done
}

@test "--from and --until together run the stages between; the shape may be left out" {
  "$quadmesh" "$shape" --workdir stages --until critpoints
  touch -d '1 hour ago' stages/*
  "$quadmesh" --workdir stages --from separatrix --until blocksplit
  assert_equal "$(find stages -mmin -30 | sort | xargs)" "stages stages/half_disc.blocks.h5 stages/half_disc.sep.json"
  "$quadmesh" --workdir stages --from quadrefine -o out.msh
  cmp out.msh "$BATS_FILE_TMPDIR/whole.msh"
}

@test "nodes edited with jq: --from critpoints, --from separatrix and --nodes give the bytes of the single commands" {
  edited "$whole/half_disc.crit.json" >nodes.json
  by_hand nodes.json
  for stage in critpoints separatrix; do
    "$quadmesh" "$shape" --workdir stages --until critpoints
    cp nodes.json stages/half_disc.crit.json
    run -0 --separate-stderr "$quadmesh" "$shape" --workdir stages --from $stage --size 0.1 -o out.msh
    case $stage in
      critpoints) assert_equal "$stderr" \
        "quadmesh: stages/half_disc.crit.json was edited after critpoints wrote it: its nodes are used" ;;
      *) assert_equal "$stderr" '' ;;
    esac
    cmp out.msh hand.msh
    cmp nodes.json stages/half_disc.crit.json
    for file in hand/*; do cmp "$file" "stages/${file#hand/}"; done
    rm -r stages
  done
  "$quadmesh" "$shape" --nodes nodes.json --size 0.1 -o out.msh --workdir stages
  cmp out.msh hand.msh
  cmp nodes.json stages/half_disc.crit.json
  "$quadmesh" "$shape" --nodes - --size 0.1 -o piped.msh <nodes.json
  cmp piped.msh hand.msh
  "$quadmesh" --workdir stages --nodes stages/half_disc.crit.json --from separatrix --size 0.1 -o again.msh
  cmp again.msh hand.msh
}

@test "--from critpoints with other options finds other nodes" {
  cp -r "$whole" stages
  "$quadmesh" "$shape" --workdir stages --from critpoints --until critpoints --place energy
  critpoints --place energy "$whole/half_disc.field.h5" | cmp - stages/half_disc.crit.json
  # Nodes that were set by hand are not lost so.
  edited "$whole/half_disc.crit.json" >stages/half_disc.crit.json
  cp stages/half_disc.crit.json nodes.json
  run -2 "$quadmesh" "$shape" --workdir stages --from critpoints --place energy -o out.msh
  assert_line --partial "quadmesh: stages/half_disc.crit.json was edited, but made with other options of critpoints"
  cmp nodes.json stages/half_disc.crit.json
}

@test "an option that a stage before --from has too goes to the stages that run" {
  cp -r "$whole" stages
  run -0 "$quadmesh" "$shape" --workdir stages --from quadexport --allow-invalid -o out.msh
  cmp out.msh "$BATS_FILE_TMPDIR/whole.msh"
  run -2 "$quadmesh" "$shape" --workdir stages --from quadexport --allow-invalid --relax none -o out.msh
  assert_line --partial "--relax is an option of quadrefine"
}

@test "edited nodes are used whatever the form says, on one line and from a pipe too; those of another face are named" {
  edited "$whole/half_disc.crit.json" >nodes.json
  run -0 --separate-stderr "$quadmesh" "$shape" --nodes nodes.json -o one.msh
  jq '.form = "harmonic"' nodes.json >as_it_was.json
  jq -c . nodes.json >line.json
  for file in as_it_was line; do
    run -0 --separate-stderr "$quadmesh" "$shape" --nodes $file.json -o $file.msh
    cmp one.msh $file.msh
  done
  run -0 --separate-stderr "$quadmesh" "$shape" --nodes <(cat as_it_was.json) -o pipe.msh
  cmp one.msh pipe.msh
  cp -r "$whole" stages
  cp as_it_was.json stages/half_disc.crit.json
  run -0 --separate-stderr "$quadmesh" --workdir stages --from separatrix -o kept.msh
  cmp one.msh kept.msh
  # Those that nobody has edited need no second field.
  run -0 "$quadmesh" "$shape" --nodes "$whole/half_disc.crit.json" -o same.msh --report report.json
  assert_equal "$(jq '.stages | has("phase_fieldsolve")' report.json)" false
  run -3 "$quadmesh" "$DATA/plate_hole.step" --nodes nodes.json -o other.msh
  assert_output --partial 'nodes.json was not made from'
}

@test "nodes that were given or edited are not replaced where a strip of blocks contains itself" {
  critpoints --max-valence 5 "$whole/half_disc.field.h5" -o nodes.json
  run -0 --separate-stderr "$quadmesh" "$shape" --nodes nodes.json -o out.msh --report report.json
  assert_equal "$stderr" ''
  assert_equal "$(jq -c '[.remedy, .critical_points, (.stages | has("critpoints"))]' report.json)" '[null,2,false]'
}

@test "--dry-run prints commands that give the same bytes, and runs nothing" {
  cp "$shape" .
  "$quadmesh" half_disc.step --dry-run -o 'a mesh.msh' --size 0.1 --size-near curve_0=0.05 >commands
  assert_nothing_left commands half_disc.step
  assert_equal "$(grep -v '^#' commands | cut -d ' ' -f 1 | xargs)" \
    "cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport"
  sh -e commands
  "$quadmesh" half_disc.step -o other.msh --size 0.1 --size-near curve_0=0.05
  cmp 'a mesh.msh' other.msh
}

@test "--dry-run with given nodes, with a work folder, and from a stage on" {
  edited "$whole/half_disc.crit.json" >nodes.json
  "$quadmesh" "$shape" --dry-run --nodes nodes.json --workdir "it's new" -o one.msh >commands
  assert_file_not_exists "it's new"
  sh -e commands
  "$quadmesh" "$shape" --nodes nodes.json -o two.msh
  cmp one.msh two.msh
  run -0 "$quadmesh" "$shape" --dry-run --workdir "$whole" --from quadrefine -o 3.msh
  assert_equal "${#lines[@]}" 2
  assert_line --index 0 "quadrefine $whole/half_disc.blocks.h5 -o $whole/half_disc.quad.h5"
  run -0 "$quadmesh" "$shape" --dry-run --workdir "$whole" --from critpoints -o 3.msh
  assert_line --index 0 "# $whole/half_disc.crit.json is kept if it was edited after critpoints wrote it"
  run -0 "$quadmesh" "$shape" --dry-run --until cad2tri --workdir "$whole"
  assert_equal "${#lines[@]}" 1
  run -0 "$quadmesh" "$shape" --dry-run --layout midpoint -o 3.msh
  assert_equal "$(cut -d ' ' -f 1 <<<"$output" | xargs)" "cad2tri separatrix blocksplit quadrefine quadexport"
  run -2 "$quadmesh" "$shape" --dry-run -o 3.msh --size wrong
}

@test "stagecheck --history prints commands that make the file again" {
  cp "$shape" .
  stagecheck --history "$whole"/half_disc.{crit.json,quad.h5} >commands
  assert_equal "$(head -n 1 commands)" "# half_disc.step: step, SHA-256 $(sha256sum <half_disc.step | cut -d ' ' -f 1)"
  sh -e commands
  cmp half_disc.quad.h5 "$whole/half_disc.quad.h5"
  cmp half_disc.crit.json "$whole/half_disc.crit.json"
  # An edit is not in the provenance, but the file is not what the commands make.
  edited half_disc.crit.json >nodes.json
  stagecheck --history nodes.json >commands
  assert_equal "$(tail -n 1 commands)" "# nodes.crit.json: SHA-256 $(sha256sum <nodes.json | cut -d ' ' -f 1); if the \
command makes another file, it was edited since: use the edited one"
  # Without the file of nodes, its options are not known.
  stagecheck --history "$whole/half_disc.quad.h5" >commands
  grep -q "^# half_disc.crit.json: critical-points, SHA-256 $(sha256sum <half_disc.crit.json | cut -d ' ' -f 1)$" commands
  for file in "$whole"/*; do stagecheck --history "$file" | grep -q '^cad2tri .* half_disc.step -o half_disc.tri.h5$'; done
  run -3 stagecheck --history "$shape"
}

@test "stagecheck --history prints commands that make a field with prescribed orders again" {
  cp "$shape" .
  cp "$whole"/half_disc.{tri,field}.h5 .
  fieldsolve --orders half_disc.field.h5 half_disc.tri.h5 -o again.solve.h5
  n=$(h5dump -H -d /elem_order half_disc.field.h5 | grep -oP 'SIMPLE \{ \( \K\d+')
  jq -n --argjson n "$n" '{format: "order-map", version: [1, 0], elem_order: [range($n) | 5 + . % 5]}' >orders.json
  fieldsolve --orders orders.json half_disc.tri.h5 -o map.solve.h5
  stagecheck --history again.solve.h5 map.solve.h5 half_disc.field.h5 >commands # in any order
  grep -q "^# map.orders.json: order-map, SHA-256 $(sha256sum <orders.json | cut -d ' ' -f 1)$" commands
  assert_equal "$(grep -c ^cad2tri commands)" 1
  mkdir again && cp half_disc.step again/map.step && cp orders.json again/map.orders.json
  (cd again && sh -e ../commands)
  for file in {again,map}.solve.h5 half_disc.field.h5; do cmp "$file" "again/$file"; done
}

@test "after a failure, the report has the stage, the exit code and the message" {
  run -3 "$quadmesh" "$DATA/bad/solid.step" -o out.msh --report report.json
  assert_equal "$(jq -c '[.tool, .exit_code, .stage, (.stages | keys)]' report.json)" '["quadmesh",3,"cad2tri",["cad2tri"]]'
  assert_output "cad2tri: $(jq -r .error report.json)"
  run -1 "$quadmesh" "$shape" --size 0.03 --max-elements 1000 -o out.msh --report report.json
  assert_equal "$(jq -c '[.exit_code, .stage, .blocks, .certificate.method]' report.json)" '[1,"quadrefine",null,"traced"]'
  assert_regex "$(jq -r .error report.json)" 'quads, more than --max-elements 1000'
  assert_equal "$(jq .estimated_quads report.json)" 2042
  # The area of the face tells it before there is a field.
  run -1 "$quadmesh" "$shape" --size 1e-4 -o out.msh --report report.json
  assert_output --partial 'quadmesh: sizes require some 157079633 quads, more than --max-elements 1000000: raise --size'
  assert_equal "$(jq -c '[.exit_code, .stage, (.stages | keys)]' report.json)" '[1,"quadmesh",["cad2tri"]]'
  run -1 "$quadmesh" "$shape" --size 1e-4 --count 0=1 -o out.msh --report report.json # counts may make them few
  assert_equal "$(jq -c '[.stage, .given_up]' report.json)" '["quadrefine",null]'
  run -3 "$quadmesh" missing.step -o out.msh --report report.json
  assert_equal "$(jq -c '[.exit_code, .stage, .error]' report.json)" '[3,"quadmesh","missing.step: no such file"]'
  run -4 "$quadmesh" "$shape" -o nowhere/out.msh --report report.json
  assert_equal "$(jq -c '[.exit_code, .stage]' report.json)" '[4,"quadmesh"]'
}

@test "a warning that two stages issue is printed once, also for nodes that need a second field" {
  edited "$whole/half_disc.crit.json" >nodes.json
  inexact='padapt=padapt --target-error 1e-15 --max-order 4'
  run -0 --separate-stderr "$quadmesh" "$shape" --layout traced --nodes nodes.json -o out.msh --stage "$inexact"
  assert_equal "$(sort <<<"$stderr" | uniq -d)" ''
  assert_regex "$stderr" '^padapt: warning W-ADAPT-002: '
  run -0 --separate-stderr "$quadmesh" -q "$shape" --nodes nodes.json -o out.msh --stage "$inexact"
  assert_equal "$stderr" ''
}
