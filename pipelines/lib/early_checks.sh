# shellcheck shell=sh
# What the command line and the headers of files tell before any work: options of all stages, inputs that are missing,
# outputs that cannot be written or would replace an input.

# refuse CODE MESSAGE: ends quadmesh, with a report.
refuse() {
  printf '%s\n' "quadmesh: $2" >&2
  [ -n "$scratch" ] || scratch=$(mktemp -d) || exit "$1"
  report_failure "$1" quadmesh "$2"
  rm -rf "$scratch"
  exit "$1"
}

# check_command_line: what needs no files.
check_command_line() {
  [ -n "$shape" ] || [ -n "$first_stage" ] || mistake "no shape given"
  case $html in '' | *?.html) ;; *) mistake "--html: '$html' does not end in .html" ;; esac
  limit_range "$first_stage" "$last_stage"
  check_options cad2tri /dev/null ${healed:+--write-healed "$healed"} ${heal:+--heal-tolerance "$heal"} \
    ${fit:+--fit-tolerance "$fit"} ${blunt:+--blunt "$blunt"} ${threads:+--threads "$threads"}
  for tool in critpoints separatrix blocksplit quadrefine; do check_options "$tool" /dev/null; done
  check_output_format
  check_given_nodes_option
}

# check_output_format: sets $exported, the ending of the file that quadexport reads: of a mesh, or of blocks for STEP.
check_output_format() {
  format=$(chosen_value quadexport --format)
  case ${format:-auto}:$out in
    step:* | auto:*.step | auto:*.stp) exported=blocks.h5 ;;
  esac
  order=''
  [ "$final_position" -lt 8 ] || order=$(chosen_value quadrefine --order)
  check_options quadexport --check-shape /dev/null -o "${out:--}" ${order:+--mesh-order "$order"}
}

check_given_nodes_option() {
  [ -n "$given_nodes" ] || return 0
  [ "$layout" != midpoint ] || mistake "--nodes and --layout midpoint exclude each other: it uses no nodes"
  [ "$first_position" -le 5 ] || mistake "--nodes needs separatrix, which --from $first_stage does not run"
  [ "$final_position" -ge 4 ] || mistake "--nodes is not used before critpoints, where --until $last_stage ends"
  case $separator$chosen in
    *"${separator}critpoints --"*)
      option=${chosen#*"critpoints --"}
      mistake "--nodes takes the place of critpoints: --${option%%"$separator"*} is an option of it, leave it out" ;;
  esac
  [ "$given_nodes" != - ] || [ "$shape" != - ] || mistake "SHAPE and --nodes cannot both be standard input"
}

# check_files: inputs and outputs. Needs $shape, which may be found in the work folder.
check_files() {
  require_files
  if [ "$first_position" -eq 1 ]; then require_input "$shape"; fi
  case $given_nodes in
    '' | -) ;;
    *) [ -e "$given_nodes" ] || refuse 3 "--nodes $given_nodes: no such file; the rules are none, fewest, field and auto" ;;
  esac
  size_file=$(chosen_value quadrefine --size-field)
  block_file=$(chosen_value blocksplit --block-names)
  for json in "$names" "$block_file" "$given_nodes"; do
    case $json in '' | -) ;; *) require_input "$json" && require_json "$json" ;; esac
  done
  case $size_file in '' | -) ;; *) require_input "$size_file" ;; esac # JSON or a table, which quadrefine checks
  check_contents cad2tri --boundary-names "$names"
  check_contents blocksplit --block-names "$block_file"
  check_contents quadrefine --size-field "$size_file"
  case $given_nodes in '' | -) ;; *) require_nodes "$given_nodes" ;; esac
  check_outputs
}

# require_input FILE: exists, can be read, is not empty.
require_input() {
  if [ "$1" = - ]; then return; fi
  [ -e "$1" ] || refuse 3 "$1: no such file"
  [ ! -d "$1" ] || refuse 3 "$1: is a directory, not a file"
  [ -r "$1" ] || refuse 3 "$1: cannot be read: permission denied"
  [ ! -f "$1" ] || [ -s "$1" ] || refuse 3 "$1: is empty"
}

# check_contents TOOL OPTION FILE: as the tool reads it before its input, which is empty here.
check_contents() {
  [ -f "$3" ] || return 0
  message=$("$1" /dev/null "$2" "$3" 2>&1 </dev/null)
  case $?:$message in
    3:"$1: /dev/null: "*) ;;
    3:*) refuse 3 "${message#"$1: "}" ;;
  esac
}

# check_shape: what the options ask of the shape, such as names of boundaries, in the first file with the face.
check_shape() {
  case $first_position in
    6) with_face=$stem.sep.json ;;
    7) with_face=$stem.blocks.h5 ;;
    8) with_face=$stem.$exported ;;
    *) with_face=$stem.tri.h5 ;;
  esac
  [ -f "$with_face" ] || return 0 # with --dry-run
  for tool in critpoints quadrefine quadexport; do
    case $separator$chosen in *"$separator$tool "*) ;; *) continue ;; esac
    written=''
    [ "$tool" != quadexport ] || written=${out:--} # which determines the format
    message=$(with_options "$tool" "$tool" --check-shape "$with_face" ${written:+-o "$written"} \
      --called-by quadmesh 2>&1 </dev/null)
    code=$?
    case $code in 1 | 2) ;; *) continue ;; esac # 1: far too many quads
    message=${message#"$tool: "} last='' # no later stage has seen it
    printf 'quadmesh: %s\n' "${message#quadmesh: }" >&2
    message=${message%%
*}
    fail "$code" quadmesh "${message#quadmesh: }"
  done
}

require_json() {
  [ -f "$1" ] || return 0
  problem=$(jq empty "$1" 2>&1 </dev/null) || refuse 3 "$1: is not JSON: ${problem##*: }"
}

# require_nodes FILE: has the format of x.crit.json and keeps the rules that stages check. CRT-R07 and CRT-R16 are about
# the record of the search, which an editor may leave as it was.
require_nodes() {
  [ -f "$1" ] || return 0
  format=$(jq -r '.format? // "none"' "$1" 2>/dev/null)
  [ "$format" = critical-points ] || refuse 3 "$1: expected a critical-points file (x.crit.json), found format $format"
  broken=$(stagecheck "$1" 2>/dev/null | grep -v -e ': CRT-R07: ' -e ': CRT-R16: ' | head -n 1)
  [ -z "$broken" ] || refuse 3 "$broken"
}

# identity_of FILE: the same words for all names of a file, also through links.
identity_of() { stat -L -c '%d:%i' -- "$1" 2>/dev/null || readlink -m -- "$1"; }

is_same_file() { [ "$(identity_of "$1")" = "$(identity_of "$2")" ]; }

check_outputs() {
  [ "${out:--}" != - ] || [ "$report" != - ] || [ "$final_position" -lt 8 ] ||
    mistake "the mesh and the report cannot both go to standard output: give -o FILE"
  for output in "$out" "$report" "$healed" "$html"; do
    case $output in '' | -) ;; *) check_output "$output" ;; esac
  done
  refuse_pair "$out" "$report" "the mesh" "the report"
  refuse_pair "$out" "$healed" "the mesh" "the healed face"
  refuse_pair "$report" "$healed" "the report" "the healed face"
  refuse_pair "$html" "$out" "the page" "the mesh"
  refuse_pair "$html" "$report" "the page" "the report"
}

# refuse_pair FILE OTHER WHAT OF_OTHER
refuse_pair() {
  case $1:$2 in :* | *: | -:* | *:- | /dev/*) return ;; esac
  if is_same_file "$1" "$2"; then mistake "$3 and $4 are the same file: $1"; fi
}

# check_output FILE: would replace no input and no file of the stages; its folder exists.
check_output() {
  for input in "$shape" "$names" "$block_file" "$size_file" "$given_nodes"; do
    case $input in '' | -) continue ;; esac
    if [ -f "$input" ] && is_same_file "$1" "$input"; then mistake "the output $1 is the input $input"; fi
  done
  if [ -n "$workdir" ]; then refuse_stage_file "$1"; fi
  [ ! -d "$1" ] || cannot_be_written "$1" "is a directory"
  case $1 in */*) folder=${1%/*} ;; *) folder=. ;; esac
  [ -d "${folder:-/}" ] || cannot_be_written "$1" "there is no folder $folder"
  [ -e "$1" ] || [ -w "${folder:-/}" ] || cannot_be_written "$1" "the folder is write-protected"
}

# cannot_be_written FILE REASON: ends with 4; if FILE is the report, no report is written.
cannot_be_written() {
  [ "$1" != "$report" ] || report=''
  refuse 4 "$1: cannot be written: $2"
}

refuse_stage_file() {
  for ending in outline.step tri.h5 solve.h5 field.h5 crit.json phase.solve.h5 phase.h5 sep.json blocks.h5 quad.h5; do
    if is_same_file "$1" "$workdir/$(stem_of "$shape").$ending"; then
      mistake "the output $1 is a file of the stages in --workdir $workdir"
    fi
  done
}

# choose_clearances: nodes keep the distance from walls that all layers need, unless --clearance says another.
choose_clearances() {
  [ "$first_position" -le 4 ] && [ "$final_position" -ge 4 ] && [ -z "$given_nodes" ] || return 0
  case $layout:$separator$chosen in midpoint:*) return 0 ;; *"${separator}quadrefine --wall"*) ;; *) return 0 ;; esac
  clearances=$(with_options quadrefine quadrefine --write-clearances - 2>/dev/null </dev/null)
  while read -r clearance; do
    case $separator$chosen in *"${separator}critpoints ${clearance%=*}="*) continue ;; esac
    [ -z "$clearance" ] || { takers=critpoints && choose_option --clearance "$clearance"; }
  done <<END
$clearances
END
}

# choose_offsets: --wall NAME:...,blocks=own needs a curve that cad2tri makes.
choose_offsets() {
  case $chosen in *blocks=own*) ;; *) return 0 ;; esac
  offsets=$(with_options quadrefine quadrefine --write-offsets - 2>&1 </dev/null) || {
    printf '%s\n' "$offsets" | sed 's/^quadrefine: /quadmesh: /' >&2
    exit 2
  }
  while read -r offset; do
    [ -z "$offset" ] || { takers=cad2tri && choose_option --offset "$offset"; }
  done <<END
$offsets
END
}
