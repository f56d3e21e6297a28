# Wrong usage: each is answered before any work, under the name of the command that was typed, with the remedy.
load ../tools/common

# A line for each: exit code | command | words that the message must contain, in this order (* stands for anything).
table() {
  cat <<'END'
2 | cad2tri --verbos half_disc.step | unknown option --verbos: did you mean --verbose?
2 | cad2tri --face-name 3 half_disc.step | unknown option --face-name
2 | cad2tri --heal-tol 1e-4 half_disc.step | unknown option --heal-tol: did you mean --heal-tolerance?
2 | cad2tri --offset hole half_disc.step | --offset hole: expected NAME=T
2 | cad2tri --offset 0=thin half_disc.step | --offset 0=thin: 'thin' is not a number
2 | cad2tri --offset hole=0.1 half_disc.step -o out.tri.h5 | --offset hole=0.1: there is no boundary "hole"
2 | cad2tri --region-name fluid half_disc.step | --region-name fluid: expected NAME=LIST
2 | cad2tri --blunt much half_disc.step | --blunt much: expected "auto" or a width in file units
2 | cad2tri --symmetry axis half_disc.step | there is no boundary "axis"
2 | cad2tri -z half_disc.step | unknown option -z
2 | cad2tri half_disc.step square.step | surplus argument 'square.step'
2 | cad2tri half_disc.step --size | --size needs a value
2 | cad2tri half_disc.step --size big | --size: 'big' is not a number
2 | cad2tri half_disc.step --order 99 | --order: 99 is outside its interval (1 to 16)
2 | cad2tri --list --face 1 half_disc.step | --list and --face exclude each other
3 | cad2tri missing.step | missing.step*No such file
2 | fieldsolve --field-ordr 9 w/half_disc.tri.h5 | unknown option --field-ordr: did you mean --field-order?
2 | fieldsolve --method cgg w/half_disc.tri.h5 | --method: 'cgg' is not one of cg|dg
2 | fieldsolve --nodes w/half_disc.crit.json --method dg w/half_disc.tri.h5 | --nodes needs --method cg
3 | fieldsolve half_disc.step | half_disc.step
3 | fieldsolve w/half_disc.field.h5 | expected a tri-mesh file, found a field file
2 | padapt --max-ordr 9 w/half_disc.solve.h5 | did you mean --max-order?
2 | padapt --max-order 2.5 w/half_disc.solve.h5 | --max-order: '2.5' is not an integer
3 | padapt w/half_disc.tri.h5 | expected a field file, found a tri-mesh file
2 | critpoints --plase energy w/half_disc.field.h5 | unknown option --plase: did you mean --place?
2 | critpoints --corner-valence 3=1 w/half_disc.field.h5 | '3=1' is not a corner valence: write CURVE_A:CURVE_B=VALENCE
2 | critpoints --nodes few w/half_disc.field.h5 | --nodes: 'few' is not one of auto|none|fewest|field
2 | critpoints --topology o w/half_disc.field.h5 | a C-, O- or H-grid is made around a hole, and the face has none
2 | critpoints --clearance curve_0 w/half_disc.field.h5 | --clearance: 'curve_0' is not NAME=L with a length L > 0
2 | critpoints --clearance roof=0.1 w/half_disc.field.h5 | --clearance: there is no boundary *roof
2 | critpoints --symmetry roof w/half_disc.field.h5 | --symmetry: there is no boundary *roof
2 | critpoints --threads 0 w/half_disc.field.h5 | --threads: 0 is outside its interval
3 | critpoints w/half_disc.tri.h5 | expected a field file, found a tri-mesh file
2 | separatrix --verbos | unknown option --verbos: did you mean --verbose?
2 | separatrix | FIELD is required
2 | separatrix w/half_disc.field.h5 w/half_disc.crit.json more.json | surplus argument 'more.json'
2 | separatrix --layout trased w/half_disc.field.h5 w/half_disc.crit.json | 'trased' is not one of
3 | separatrix w/half_disc.field.h5 square.crit.json | square.crit.json was not made from w/half_disc.field.h5
3 | separatrix square.field.h5 w/half_disc.crit.json | w/half_disc.crit.json was not made from square.field.h5
3 | separatrix w/half_disc.field.h5 edited.json | fieldsolve --nodes
2 | blocksplit --block-name x.json w/half_disc.sep.json | did you mean --block-names?
3 | blocksplit w/half_disc.blocks.h5 | expected a separatrix-graph file
2 | quadrefine --sise 0.1 w/half_disc.blocks.h5 | unknown option --sise: did you mean --size?
2 | quadrefine --max-elements 0 w/half_disc.blocks.h5 | --max-elements: 0 is outside its interval
1 | quadrefine --size 1e-3 w/half_disc.blocks.h5 -o out.quad.h5 | require about * quads, more than --max-elements 1000000: raise --size by a factor of
1 | quadrefine --count 0=100000000 w/half_disc.blocks.h5 -o out.quad.h5 | counts require about * quads, more than --max-elements 1000000: lower --count
1 | quadrefine --size 0.1 --max-elements 50 w/half_disc.blocks.h5 -o out.quad.h5 | more than --max-elements 50
2 | quadrefine --wall curve_0 w/half_disc.blocks.h5 | --wall curve_0: expected NAME:first=H,layers=N
2 | quadrefine w/half_disc.blocks.h5 -o out.quad.h5 --report ./out.quad.h5 | ./out.quad.h5: would be written twice, by --output and by --report: give two names
2 | critpoints w/half_disc.field.h5 --report - | --output and --report cannot both go to standard output: name a file for one of them
2 | quadrefine --size-near hole w/half_disc.blocks.h5 | hole
2 | quadrefine --count x w/half_disc.blocks.h5 | x
2 | quadrefine --count hole=0 w/half_disc.blocks.h5 | --count: 'hole=0' is not CHORD=N or NAME=N
2 | quadrefine --count 0=4,even w/half_disc.blocks.h5 | --count: '0=4,even' is not CHORD=N or NAME=N
2 | quadrefine --count curve_0=9,even --relax none w/half_disc.blocks.h5 | leave out --relax none
2 | quadrefine --count curve_0=9,even --blocks 0 w/half_disc.blocks.h5 | with --blocks no vertex moves
2 | quadrefine --grading hole=0.1 w/half_disc.blocks.h5 | --grading: 'hole=0.1' is not NAME=FIRST:LAST
2 | quadrefine --refine 11 w/half_disc.blocks.h5 | --refine: 11 is outside its interval
2 | quadrefine --relax 20 w/half_disc.blocks.h5 | --relax 20 is now --relax shape --relax-sweeps 20
2 | quadrefine --relax even w/half_disc.blocks.h5 | --relax: 'even' is not one of size, shape, none
2 | quadrefine --inner-edges bent w/half_disc.blocks.h5 | --inner-edges
2 | quadrefine --per-curve few w/half_disc.blocks.h5 | --per-curve: 'few' is not "auto" or an integer
2 | quadrefine --wall curve_0:first=1,layers=2,blocks=own w/half_disc.blocks.h5 | blocks=own needs a curve curve_0_offset in the face
2 | quadrefine --wall curve_0:yplus=1,layers=2 w/half_disc.blocks.h5 | y+ needs the flow as well: give --velocity, --viscosity, --length
2 | quadrefine --wall curve_0:first=1,yplus=1,layers=2 w/half_disc.blocks.h5 | one of first and yplus must be given, not both
2 | quadrefine --wall curve_0:first=1,layers=2 --velocity 30 w/half_disc.blocks.h5 | --velocity: used with --yplus or --wall NAME:yplus=Y only
2 | quadrefine --yplus 1 --velocity 30 --viscosity 1e-5 --length 1 w/half_disc.blocks.h5 | --yplus is the height of wall layers: give --wall
2 | quadrefine --target-edge-ratio 0.5 w/half_disc.blocks.h5 | --target-edge-ratio must be 0 or at least 1
2 | quadrefine --target-growth 1 w/half_disc.blocks.h5 | --target-growth must be 0 or greater than 1
3 | quadrefine w/half_disc.quad.h5 | expected a block-layout file
2 | quadexport --formt msh w/half_disc.quad.h5 | unknown option --formt: did you mean --format?
2 | quadexport w/half_disc.quad.h5 -o out.unknown | out.unknown does not determine the format: end it in one of
2 | quadexport w/half_disc.quad.h5 --format unv -o out.unv | 'unv' is not one of
2 | quadexport w/half_disc.quad.h5 --check-for openfoam -o out.msh | OpenFOAM does not read the format msh: choose
2 | quadexport w/half_disc.blocks.h5 --check-for su2 -o out.step | SU2 does not read the format step: choose su2
3 | quadexport w/half_disc.blocks.h5 -o out.msh | expected a quad-mesh file
2 | stageview --feild w/half_disc.field.h5 w/half_disc.crit.json | did you mean --field?
2 | stageview w/half_disc.quad.h5 --field w/half_disc.field.h5 -o out.svg | --field needs a critical-points file
2 | stageview w/half_disc.quad.h5 --window 0,0,1 -o out.svg | --window: '0,0,1' is not X0,Y0,X1,Y1
2 | stageview w/half_disc.quad.h5 --window 5,5,6,6 -o out.svg | --window: nothing is there; the picture extends from
2 | stageview w/half_disc.tri.h5 --curve-labels --no-curve-labels -o out.svg | --curve-labels and --no-curve-labels exclude each other
2 | stageview w/half_disc.quad.h5 -o out.gif | out.gif: pictures are written as SVG, PNG or PDF: end the name in
2 | stagecheck --histroy w/half_disc.quad.h5 | unknown option --histroy: did you mean --history?
3 | stagecheck half_disc.step w/half_disc.quad.h5 | 1 of 2 files is broken
3 | stagecheck half_disc.step | 1 of 1 file is broken
2 | quadmesh | no shape given
2 | quadmesh --verbos half_disc.step | unknown option --verbos: did you mean --verbose?
2 | quadmesh --sise 0.1 half_disc.step | unknown option --sise: did you mean --size?
2 | quadmesh -qz half_disc.step | unknown option -z
2 | quadmesh half_disc.step square.step | more than one shape: half_disc.step and square.step
2 | quadmesh half_disc.step -o | -o needs a value
2 | quadmesh half_disc.step -o --size 0.1 | -o needs a value, not the option --size
2 | quadmesh half_disc.step --quiet=yes | --quiet takes no value
2 | quadmesh half_disc.step -oout.step --patch-type *=wall | --patch-type: a STEP model has no types of boundaries
2 | quadmesh half_disc.step -o out.m --format step --unit yd | --unit: 'yd' is not one of file|m|cm|mm|um|nm|km|in|ft
2 | quadmesh half_disc.step -o half_disc.step | half_disc.step: is the input half_disc.step, which --output would overwrite: give another file
2 | quadmesh half_disc.step -o out.unknown | out.unknown does not determine the format: end it in one of
2 | quadmesh half_disc.step -o out.msh --order 12 | --order 12: the format msh supports quads up to order 10
2 | quadmesh half_disc.step -o out.msh --feature-size big | --feature-size big: expected "auto" or a length
2 | quadmesh half_disc.step -o out.msh --growth 0.5 | --growth must be greater than 1
2 | quadmesh half_disc.step -o out.msh --html out.msh.html --report out.msh.html | out.msh.html: would be written twice, by --report and by --html: give two names
2 | quadmesh half_disc.step -o out.msh --wall curve_0:yplus=1,layers=2 --velocity 3 | y+ needs the flow as well: give --viscosity, --length
2 | quadplace half_disc.step -o out.msh --goal beauty | --goal: 'beauty' is not one of scaled-jacobian|edge-ratio|blocks|alignment
2 | quadplace half_disc.step -o out.msh --goal alignment | --goal alignment and --align FILE go together
3 | quadmesh half_disc.step -o out.msh --size-field edited.json | edited.json: not a size field
3 | quadmesh half_disc.step -o out.msh --block-names wrong_names.json | wrong_names.json: "*": the new name must be a text
3 | quadmesh half_disc.step -o out.msh --boundary-names wrong_names.json | wrong_names.json: "*": the new name must be a text
4 | quadmesh half_disc.step -o out.msh --html nowhere/x.html | nowhere/x.html: cannot be written: there is no folder nowhere
2 | quadmesh half_disc.step -o out.msh --order 0 | --order: 0 is outside its interval (1 to 20)
3 | quadmesh half_disc.step -o out.msh --nodes few | --nodes few: no such file; the rules are none, fewest, field and auto
2 | quadmesh half_disc.step -o out.msh --heal-tolerance wide | --heal-tolerance: 'wide' is not a number
2 | quadmesh half_disc.step -o out.msh --write-healed out.iges | out.iges: the file must end in .step, .stp or .brep
2 | quadmesh half_disc.step -o out.msh --corner-valence 3 | is not a corner valence
2 | quadmesh half_disc.step -o out.msh --wall 0:first=1,layers=fit,blocks=own | blocks=own needs a number of layers
2 | quadmesh half_disc.step -o out.msh --wall hole | expected NAME:first=H
2 | quadmesh half_disc.step -o out.msh --size-near hole | hole
2 | quadmesh half_disc.step -o out.msh --layout best | --layout: 'best' is not one of
2 | quadmesh half_disc.step -o out.msh --threads none | --threads
2 | quadmesh half_disc.step -o out.msh --max-seconds soon | soon
2 | quadmesh half_disc.step -o half_disc.step --format msh | half_disc.step: is the input half_disc.step, which --output
2 | quadmesh half_disc.step -o ./half_disc.step --format msh | ./half_disc.step: is the input half_disc.step, which --output
2 | quadmesh half_disc.step -o link.msh | link.msh: is the input half_disc.step, which --output would
2 | quadmesh half_disc.step -o out.msh --report link.msh | link.msh: is the input half_disc.step, which --report would
2 | quadmesh half_disc.step -o out.msh --report ./out.msh | ./out.msh: would be written twice, by --output and by --report
2 | quadmesh half_disc.step --report - | cannot both go to standard output
2 | quadmesh half_disc.step --format msh -o w/half_disc.quad.h5 --workdir w | w/half_disc.quad.h5: would be written twice, by --output and by the stage quadrefine
2 | quadmesh half_disc.step -o out.msh --report w/../w/half_disc.crit.json --workdir w | w/half_disc.crit.json: would be written twice, by --report and by the stage critpoints
2 | quadmesh half_disc.step --farfield circle:5 --from separatrix --workdir w | --farfield makes a CAD file of points
2 | quadmesh half_disc.step --nodes edited.json -o out.msh --report edited.json | edited.json: is the input edited.json, which --report would overwrite
3 | quadmesh missing.step -o out.msh | missing.step: no such file
3 | quadmesh empty.step -o out.msh | empty.step: is empty
3 | quadmesh w -o out.msh | w: is a directory
3 | quadmesh half_disc.step -o out.msh --boundary-names missing.json | missing.json: no such file
3 | quadmesh half_disc.step -o out.msh --block-names missing.json | missing.json: no such file
3 | quadmesh half_disc.step -o out.msh --size-field half_disc.step | half_disc.step:1: there is no column x
3 | quadmesh half_disc.step -o out.msh --nodes missing.json | missing.json: no such file
3 | quadmesh half_disc.step -o out.msh --nodes w/half_disc.sep.json | expected a critical-points file (x.crit.json), found format separatrix-graph
3 | quadmesh half_disc.step -o out.msh --nodes unbalanced.json | unbalanced.json: CRT-R05: index_sum
4 | quadmesh half_disc.step -o nowhere/out.msh | nowhere/out.msh: cannot be written: there is no folder nowhere
4 | quadmesh half_disc.step -o out.msh --report nowhere/report.json | there is no folder nowhere
4 | quadmesh half_disc.step -o folder.msh | folder.msh: cannot be written: is a directory
2 | quadmesh half_disc.step --until critpoints -o out.msh | out.msh: --until critpoints writes x.crit.json: end the name in .json
2 | quadmesh half_disc.step --until critpoint --workdir w | 'critpoint' is no stage (did you mean critpoints?)
2 | quadmesh half_disc.step --from separatrix -o out.msh | --from separatrix needs --workdir
2 | quadmesh half_disc.step --from quadrefine --until separatrix --workdir w | --from quadrefine comes after --until separatrix
2 | quadmesh half_disc.step --from quadrefine --place energy --workdir w -o out.msh | --place is an option of critpoints, which --from quadrefine does not run
2 | quadmesh half_disc.step --from padapt --face 1 --workdir w -o out.msh | --face is an option of cad2tri, which --from padapt does not run
3 | quadmesh square.step --from quadrefine --workdir w -o out.msh | w/square.blocks.h5, which does not exist
2 | quadmesh half_disc.step --from blocksplit --nodes edited.json --workdir w -o out.msh | --nodes needs separatrix, which --from blocksplit does not run
2 | quadmesh half_disc.step --nodes edited.json --place energy -o out.msh | --nodes takes the place of critpoints
2 | quadmesh half_disc.step --nodes edited.json --layout midpoint -o out.msh | --nodes and --layout midpoint exclude each other
2 | quadplace | no shape given
2 | quadplace --roundes 3 half_disc.step | unknown option --roundes: did you mean --rounds?
2 | quadplace half_disc.step --rounds 1.5 | --rounds: '1.5' is not an integer
2 | quadplace half_disc.step -oout.step | out.step: STEP is a format of blocks, not of meshes
2 | quadplace half_disc.step -o out.unknown | out.unknown does not determine the format
2 | quadplace half_disc.step -o out.msh --order 0 | --order: 0 is outside its interval
2 | quadplace half_disc.step -o out.msh --size many | --size: 'many' is not a number
2 | quadplace half_disc.step -o out.msh --corner-valence 3 | is not a corner valence
2 | quadplace half_disc.step --start edited.json --nodes ./edited.json -o out.msh | the output ./edited.json is an input
3 | quadplace missing.step -o out.msh | missing.step: no such file
3 | quadplace half_disc.step --start w/half_disc.sep.json -o out.msh | expected a critical-points file
4 | quadplace half_disc.step -o nowhere/out.msh | there is no folder nowhere
2 | quadbench --size 1 | no shape given
2 | quadbench half_disc.step half_disc.step | more than one shape: half_disc.step and half_disc.step
2 | quadbench half_disc.step --sise 1 | unknown option --sise: did you mean --size?
2 | quadbench half_disc.step --workdir w | --workdir is for a single run: use quadmesh
2 | quadbench half_disc.step --port 70000 | --port: 70000 is outside its interval
2 | quadbench half_disc.step --order 0 | --order: 0 is outside its interval
2 | quadbench half_disc.step --wall hole | --wall: 'hole' has no : between a name and what it means
2 | quadbench half_disc.step --name hole | --name: 'hole' has no @ between a name and what it means
2 | quadbench half_disc.step -o half_disc.step | the output half_disc.step is an input
2 | quadbench - | none from standard input
3 | quadbench missing.step | missing.step: no such file
4 | quadbench half_disc.step --folder nowhere | nowhere: cannot be written: there is no such folder
4 | quadbench half_disc.step -o nowhere/x.msh | there is no folder nowhere
2 | quadbatch --jobbs 2 half_disc.step | unknown option --jobbs: did you mean --jobs?
2 | quadbatch --sise 3 half_disc.step --to m | unknown option --sise: did you mean --size?
2 | quadgallery --too m | unknown option --too: did you mean --to?
2 | points2step --unitt mm points.dat | unknown option --unitt: did you mean --unit?
2 | points2step points.dat -o points.dat | the output points.dat is an input
4 | points2step points.dat -o nowhere/out.step | there is no folder nowhere
2 | drawing2step --layer wall plate.svg | unknown option --layer: did you mean --layers?
2 | drawing2step plate.svg -o plate.svg | the output plate.svg is an input
4 | drawing2step plate.svg -o nowhere/out.step | there is no folder nowhere
2 | drawing2step plate.svg --tolerance 0 -o out.step | --tolerance: 0 is outside its interval (above 0)
2 | drawing2step plate.svg --unit yd -o out.step | --unit: 'yd' is not one of m, cm, mm, um, in, ft
2 | quadmesh plate.svg --chord 2 -o out.msh | --chord is an option for points (.dat, .xy), but the shape is a drawing: leave it out
2 | points2step --farfield cgrid:0.5 points.dat -o out.step | --farfield: 0.5 is outside its interval (above 1, at most 1e+06)
END
}

# Files for the commands, and tools that leave the file `started` if they begin to work: for quadmesh by --stage.
setup_file() {
  cd "$BATS_FILE_TMPDIR" || return 1
  mkdir files tools && cd files || return 1
  cp "$DATA/half_disc.step" "$DATA/square.step" .
  quadmesh=$ROOT/pipelines/quadmesh
  "$quadmesh" -q half_disc.step --workdir w -o /dev/null --format msh
  "$quadmesh" -q square.step --workdir other --until critpoints
  cp other/square.field.h5 other/square.crit.json . && rm -r other
  jq '.critical_points[0].position[0] -= 0.1' w/half_disc.crit.json >edited.json
  jq '.form = "phase" | .critical_points = []' w/half_disc.crit.json >unbalanced.json
  echo '{"*": 3}' >wrong_names.json
  : >empty.step
  ln -s half_disc.step link.msh
  mkdir folder.msh
  printf '0 0\n1 0\n1 1\n' >points.dat
  echo '<svg xmlns="http://www.w3.org/2000/svg"><rect width="2" height="1"/></svg>' >plate.svg
  local tool
  for tool in cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport stageview stagecheck; do
    printf '%s\n' '#!/bin/sh' 'case " $*" in *" /dev/null"*) ;; *" -o "*) : >"$STARTED" ;; esac' \
      "exec '$BIN/$tool' \"\$@\"" >"../tools/$tool"
    chmod +x "../tools/$tool"
  done
  ln -s "$BIN/quadmesh" ../tools
}

setup() {
  common_setup
  cp -a "$BATS_FILE_TMPDIR/files/." .
  mkdir ../tmp
  stages=()
  for stage in cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport; do
    stages+=("--stage $stage=$BATS_FILE_TMPDIR/tools/$stage")
  done
}

# check_usage CODE COMMAND WORDS: prints what is wrong about the answer.
check_usage() {
  local before code=0 message name=${2%% *} command=$2 work
  before=$(find . | sort)
  case $name in
    quadmesh) command="$ROOT/pipelines/quadmesh ${stages[*]} ${2#quadmesh}" ;;
    quadplace | points2step | drawing2step | quadbatch | quadbench | quadgallery) command="$ROOT/pipelines/$2" ;;
  esac
  # shellcheck disable=SC2086 # words
  message=$(export TMPDIR=$PWD/../tmp STARTED=$PWD/../started QUADRILLE_BIN=$BIN
    case $name in quadplace) QUADRILLE_BIN=$BATS_FILE_TMPDIR/tools ;; esac
    $command 2>&1 >/dev/null </dev/null) || code=$?
  [ "$code" = "$1" ] || echo "$2: exit code $code, not $1: $message"
  # shellcheck disable=SC2053 # a pattern
  [[ ${message%%$'\n'*} == "$name: "*$3* ]] || echo "$2: $message"
  case $1 in 2) [[ $message == *"try '$name --help'" ]] || echo "$2: no hint" ;; esac
  [ "$before" = "$(find . | sort)" ] || echo "$2: files have changed"
  work=$(ls -A ../tmp)
  [ -z "$work" ] || { echo "$2: left $work" && rm -rf ../tmp/*; }
  [ ! -e ../started ] || { echo "$2: a stage was started" && rm ../started; }
}

# check_rows COMMAND...: of these commands.
check_rows() {
  local code command words problems=''
  while IFS='|' read -r code command words; do
    command=$(xargs <<<"$command") code=$(xargs <<<"$code") words=${words# }
    words=${words//\?/\\?} words=${words//\[/\\[}
    case " $* " in *" ${command%% *} "*) problems+=$(check_usage "$code" "$command" "$words") ;; esac
  done < <(table)
  assert_equal "$problems" ''
}

@test "the table has at least 80 rows, and each command of the chain has one" {
  [ "$(table | wc -l)" -ge 80 ]
  for command in cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport stageview stagecheck \
    quadmesh quadplace points2step drawing2step quadbatch quadbench quadgallery; do
    table | grep -q "| $command\b"
  done
}

@test "wrong usage of the tools" {
  check_rows cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport stageview stagecheck
}

@test "wrong usage of quadmesh" {
  check_rows quadmesh
}

@test "wrong usage of the other pipelines" {
  check_rows quadplace points2step drawing2step quadbatch quadbench quadgallery
}

# late SHAPE OPTION...: is refused by quadmesh with 2, or $code, after cad2tri, before the field is solved.
late() {
  run -"${code:=2}" "$ROOT/pipelines/quadmesh" "$@" --workdir late -o out.msh --report late.json
  assert_equal "$(ls late)" "${1%.*}.tri.h5"
  [[ $code != 2 ]] || assert_line 'try '\''quadmesh --help'\'
  assert_equal "$(jq -c '[.exit_code, .stage, "quadmesh: " + .error]' late.json)" "$(jq -nc --arg l "${lines[0]}" "[$code, \"quadmesh\", \$l]")"
  rm -r late late.json
  assert_not_exists out.msh
}

@test "what the shape tells about options of later stages is answered before the field is solved" {
  late square.step --wall curve_11:first=0.1,layers=2
  assert_output --partial 'quadmesh: --wall: there is no boundary "curve_11" (did you mean curve_1?); the names are curve_0, curve_1'
  late square.step --size-near cuvre_2=0.1
  assert_output --partial 'quadmesh: --size-near: there is no boundary "cuvre_2" (did you mean curve_2?)'
  late square.step --corner-valence 0:2=2
  assert_output --partial "quadmesh: no corner between curves 0 and 2: they do not meet"
  late square.step --format blockmesh --patch-type cuvre_2=wall
  assert_output --partial "quadmesh: --patch-type cuvre_2=wall: no boundary has this name (did you mean curve_2?)"
  cad2tri "$DATA/square.step" --write-healed unitless.brep -o /dev/null
  late unitless.brep --unit m
  assert_output --partial "quadmesh: --unit m: the CAD file states no length unit: give the factor by --scale instead"
  code=1 late square.step --size 1e-5
  assert_output "quadmesh: sizes require some 1e+10 quads, more than --max-elements 1000000: raise --size by a factor of \
100, or raise --max-elements"
  run -1 "$ROOT/pipelines/quadplace" square.step --size 1e-5 -o out.msh
  assert_output --partial "quadplace: sizes require some 1e+10 quads, more than --max-elements 1000000"
}

@test "from a later stage on, too" {
  "$ROOT/pipelines/quadmesh" -q square.step --workdir late --until blocksplit
  find late -type f | sort >before
  for stage in critpoints separatrix blocksplit quadrefine; do
    run -2 "$ROOT/pipelines/quadmesh" square.step --workdir late --from $stage -o out.msh --size-near cuvre_2=0.1
    assert_output --partial "did you mean curve_2?"
  done
  find late -type f | sort | cmp - before
}

@test "bundled short options are those one by one" {
  for tool in critpoints stageview; do
    out=out.${tool/stageview/svg}
    "$tool" -qo"$out" w/half_disc.field.h5
    cp "$out" first
    "$tool" -q -o "$out" w/half_disc.field.h5
    cmp "$out" first
    run -0 --separate-stderr "$tool" -vq -oother.svg w/half_disc.field.h5
    assert_equal "$stderr" ''
  done
  run -0 "$ROOT/pipelines/quadmesh" -qvo"out.msh" square.step
  assert_output ''
  run -0 "$ROOT/pipelines/quadmesh" -qv square.step -oother.msh
  cmp out.msh other.msh
  run -0 "$ROOT/pipelines/quadplace" -qoplaced.msh square.step
  assert_output ''
  cmp out.msh placed.msh
}

# keeps FILE COMMAND...: the command is refused with 2 and leaves the file as it is.
keeps() {
  local file=$1 before
  before=$(md5sum <"$file")
  shift
  run -2 "$@"
  assert_equal "$(md5sum <"$file")" "$before"
}

@test "no output replaces a file beside which it writes, a file of points, a stage file or standard input" {
  local quadmesh=$ROOT/pipelines/quadmesh
  cp "$ROOT/pipelines/examples/aerofoil.dat" a.dat
  printf '1 0\n5 0.1\n' | tee wake.msh w/a.outline.step >wake.txt
  keeps wake.msh "$quadmesh" a.dat --farfield cgrid:4 --wake wake.msh -o wake.msh
  keeps wake.txt "$quadmesh" a.dat --farfield cgrid:4 --wake wake.txt -o a.msh --report wake.txt
  keeps wake.txt "$ROOT/pipelines/points2step" a.dat --farfield cgrid:4 --wake wake.txt -o wake.txt
  keeps w/a.outline.step "$quadmesh" a.dat --farfield cgrid:4 --wake w/a.outline.step -o a.msh --workdir w
  echo '[{"id": "*", "name": "wall"}]' | tee d.mesh.names.json >w/half_disc.sep.json
  keeps d.mesh.names.json "$quadmesh" half_disc.step --boundary-names d.mesh.names.json -o d.mesh
  keeps w/half_disc.sep.json "$quadmesh" half_disc.step --boundary-names w/half_disc.sep.json -o d.msh --workdir w
  printf 'x,y,size\n0,0.5,0.3\n' >d.curves.vtu
  keeps d.curves.vtu "$quadmesh" half_disc.step --size-field d.curves.vtu -o d.vtu
  run -2 "$quadmesh" - --workdir w -o half_disc.step --format msh <half_disc.step
  run -2 "$quadmesh" half_disc.step -o d.re2 --report d0.f00000
  cp w/half_disc.quad.h5 e.curves.vtu
  keeps e.curves.vtu quadexport e.curves.vtu -o e.vtu
  run -2 quadexport w/half_disc.quad.h5 -o f.mesh --report f.mesh.names.json
  cp w/half_disc.crit.json n.mesh.names.json
  keeps n.mesh.names.json "$ROOT/pipelines/quadplace" half_disc.step --start n.mesh.names.json -o n.mesh --rounds 0
  cmp half_disc.step "$DATA/half_disc.step"
}

@test "temporary files replace nothing: names that others gave are other files" {
  for name in n.json.part .n.json.tmp; do
    cp w/half_disc.crit.json "$name"
    "$ROOT/pipelines/quadplace" -q half_disc.step --start "$name" --nodes n.json -o q.msh --rounds 0
    cmp "$name" w/half_disc.crit.json
  done
  assert_equal "$(find . -name '.*.tmp' -not -name .n.json.tmp)" ''
}

@test "a name that begins with two dots, or a link to the folder, is the same file" {
  ln -s . here
  run -2 "$ROOT/pipelines/quadmesh" half_disc.step --format msh -o here/half_disc.step
  assert_line --partial "is the input half_disc.step"
  ln half_disc.step hard.msh
  run -2 "$ROOT/pipelines/quadmesh" half_disc.step -o hard.msh
  run -2 "$ROOT/pipelines/quadmesh" half_disc.step -o out.msh --report ../here/w/half_disc.sep.json --workdir here/w
  cmp half_disc.step "$DATA/half_disc.step"
}
