# shellcheck shell=sh
# Which stages of the chain run: all, or those from --from to --until. Others are skipped; files of stages before --from
# are those in the work folder, which a user may have edited.
all_stages='cad2tri fieldsolve padapt critpoints separatrix blocksplit quadrefine quadexport'
first_position=1 final_position=8 # positions in this list

# position_of STAGE: sets $position, from 1; 0: there is no such stage.
position_of() {
  position=0
  for one in $all_stages; do
    position=$((position + 1))
    [ "$one" != "$1" ] || return 0
  done
  position=0
}

# limit_range FROM UNTIL: either may be empty. Exits after a mistake.
limit_range() {
  if [ -n "$1" ]; then require_stage --from "$1" && first_position=$position; fi
  if [ -n "$2" ]; then require_stage --until "$2" && final_position=$position; fi
  [ "$first_position" -le "$final_position" ] || mistake "--from $1 comes after --until $2: no stage would run"
  if [ "$first_position" -gt 1 ] && [ -z "$workdir" ]; then
    mistake "--from $1 needs --workdir, the folder with the files of the stages before"
  fi
  if [ "$final_position" -lt 8 ] && [ -z "$workdir" ]; then
    mistake "--until $2 needs --workdir, the folder in which the files of the stages are kept"
  fi
  refuse_options_before
}

# require_stage OPTION STAGE
require_stage() {
  position_of "$2"
  [ "$position" -eq 0 ] || return 0
  # shellcheck disable=SC2086 # words
  nearest=$(python3 -ISB "$lib/nearest_word.py" "$2" $all_stages 2>/dev/null)
  mistake "$1: '$2' is no stage${nearest:+ (did you mean $nearest?)}: the stages are $all_stages"
}

# is_due TOOL OUTPUT: whether a stage runs. A field for given nodes (x.phase.*) is made when separatrix runs.
is_due() {
  position_of "$1"
  case $2 in "$stem".phase.*) position=5 ;; esac
  [ "$position" -ge "$first_position" ] && [ "$position" -le "$final_position" ]
}

# Options of stages before --from could not change anything.
refuse_options_before() {
  if [ "$first_position" -gt 1 ] && [ -n "${of_cad2tri-}" ]; then
    mistake "$of_cad2tri is an option of cad2tri, which --from $first_stage does not run: leave one of them out"
  fi
  if [ "$first_position" -gt 1 ] && [ -n "${of_points-}" ]; then
    mistake "$of_points makes a CAD file of points, which --from $first_stage does not read: leave one of them out"
  fi
  for tool in critpoints separatrix blocksplit quadrefine; do
    if is_skipped "$tool"; then refuse_options_of "$tool"; fi
  done
}

# refuse_options_of STAGE: those that no stage has which runs.
refuse_options_of() {
  set -f && IFS=$separator
  # shellcheck disable=SC2086 # words
  set -- "$1" $chosen
  set +f && unset IFS
  skipped=$1 refused=''
  shift
  for word in "$@"; do
    case $word in "$skipped --"*) has_runner "${word#* }" || refused=${word#* } ;; esac
  done
  [ -z "$refused" ] || mistake "$refused is an option of $skipped, which --from $first_stage does not run: leave it out, or \
begin with --from $skipped"
}

# has_runner OPTION: whether it was also chosen for a stage from --from on.
has_runner() {
  for runner in critpoints separatrix blocksplit quadrefine quadexport; do
    is_skipped "$runner" || case $separator$chosen in *"$separator$runner $1$separator"*) return 0 ;; esac
  done
  return 1
}

is_skipped() { position_of "$1" && [ "$position" -lt "$first_position" ]; }

# require_files: the files in the work folder from which --from goes on.
require_files() {
  case $first_position in
    1) needed='' ;;
    2) needed=tri.h5 ;;
    3) needed='tri.h5 solve.h5' ;;
    4) needed='tri.h5 field.h5' ;;
    5) needed='tri.h5 field.h5 crit.json' ;;
    6) needed=sep.json ;;
    7) needed=blocks.h5 ;;
    8) needed=$exported ;;
  esac
  case $layout:$first_position in midpoint:[345]) needed=tri.h5 ;; esac
  [ -z "$needed" ] || [ -n "$shape" ] || find_shape "${needed%% *}"
  for ending in $needed; do
    [ "$ending" != crit.json ] || [ -z "$given_nodes" ] || continue
    [ -s "$workdir/$(stem_of "$shape").$ending" ] || missing_file "$workdir/$(stem_of "$shape").$ending" "$ending"
  done
}

# missing_file FILE ENDING
missing_file() {
  case $2 in
    tri.h5) maker=cad2tri ;;
    solve.h5) maker=fieldsolve ;;
    field.h5) maker=padapt ;;
    crit.json) maker=critpoints ;;
    sep.json) maker=separatrix ;;
    blocks.h5) maker=blocksplit ;;
    quad.h5) maker=quadrefine ;;
  esac
  refuse 3 "--from $first_stage needs $1, which does not exist or is empty: begin with $maker or before"
}

# find_shape ENDING: without SHAPE on the command line, that of the only file with this ending in the work folder.
find_shape() {
  for file in "$workdir"/*."$1"; do
    case $file in *.phase."$1") continue ;; esac
    [ -e "$file" ] || mistake "--from $first_stage needs a file *.$1 in $workdir, and there is none"
    [ -z "$shape" ] || mistake "$workdir has files of several shapes: name the SHAPE, of which only the name is used"
    shape=${file##*/} && shape=${shape%."$1"}.step
  done
}

stem_of() {
  case $1 in
    -) echo shape ;;
    *) name=${1##*/} && printf '%s\n' "${name%.*}" ;;
  esac
}
