# shellcheck shell=sh
# Runs stages one after another, each with the options chosen for it (stage_options.sh). A stage that fails ends the
# pipeline with its exit code; a signal ends the running stage, then the pipeline. The pipeline sets $quiet, $threads,
# $stem, the name of its files without the ending, and $field, the name of the present field.
number=10       # counts stages, for the names of their reports: $scratch/NUMBER.STAGE.json
last=''         # the file of the last stage that succeeded
child=''        # the process of the running stage
prefix=''       # of the names of stages in the report
failed_stage='' # the stage without a valid result after which the pipeline went on
scratch='' dir='' # the folders of temporary files and of stage files
part=''         # a file that is being written
exported=quad.h5 # the ending of the file that quadexport reads
trap 'stop INT' INT
trap 'stop TERM' TERM
trap 'stop HUP' HUP

# stop SIGNAL: the running stage removes what it began.
stop() {
  trap '' INT TERM HUP
  [ -z "$child" ] || { kill "$child" && wait "$child"; } 2>/dev/null
  rm -rf "$scratch"
  rm -f "$part"
  trap - "$1"
  kill -s "$1" $$
}

# add_tools_to_path FOLDER...: from the first folder that has them.
add_tools_to_path() {
  for folder in "$@"; do
    if [ -x "$folder/cad2tri" ]; then PATH=$(cd "$folder" && pwd):$PATH && return; fi
  done
}
require_tools() {
  command -v cad2tri >/dev/null || { echo "${0##*/}: no cad2tri on PATH; pipelines/quickstart builds it" >&2; exit 1; }
}

cannot_write() { echo "${0##*/}: $1: cannot be written: ${2##*: }" >&2; }

# make_folders [DIR]: stage files are kept in DIR; without DIR they are temporary. With --dry-run nothing is made.
make_folders() {
  if [ -n "$dry_run" ]; then
    dir=${1:-.}
    [ -d "$dir" ] || print_command mkdir -p "$dir"
    return
  fi
  scratch=$(mktemp -d 2>&1) || { cannot_write "the temporary folder in ${TMPDIR:-/tmp}" "$scratch"; exit 4; }
  dir=${1:-$scratch}
  message=$(mkdir -p "$dir" 2>&1) || { cannot_write "$dir" "$message"; rm -rf "$scratch"; exit 4; }
  if (exec 3<&0) 2>/dev/null; then exec 3<&0; else exec 3</dev/null; fi
}

# stage TOOL OUTPUT ARGUMENT...: skips it if it is not due (stage_range.sh). Returns 1 only if it finds no valid result
# and has_other_way, which the pipeline defines. With -q, its message is then dropped: it is no error of the pipeline.
stage() {
  if ! is_due "$1" "$2"; then
    [ "$position" -gt "$final_position" ] || last=$2
    return 0
  fi
  tool=$1 result=$2 name=$prefix$1 number=$((number + 1))
  case $result in "$stem".phase.*) name=${prefix}phase_$tool ;; esac
  shift 2
  if [ -n "$dry_run" ]; then
    with_options "$tool" print_tool "$@"
    last=$result
    return
  fi
  title_progress
  with_options "$tool" start_tool "$@" ${title:+--progress-title "$title" --progress-since "$start"}
  wait "$child"
  code=$?
  if [ -n "$title" ] && [ "$code" -gt 128 ]; then printf '\r%79s\r' '' >&2; fi # it may have been killed
  child=''
  if was_stopped "$code" "$scratch/$number.$name.json" "$tool"; then
    code=1
  elif [ "$prefix" != failed_ ]; then
    print_warnings "$scratch/$number.$name.json"
  fi
  if [ "$code" -eq 1 ] && has_other_way "$tool" "$scratch/$number.$name.json"; then
    failed_stage=$tool
    return 1
  fi
  [ -z "$quiet" ] || cat "$scratch/messages" >&2
  [ "$code" -eq 0 ] || fail "$code" "$tool"
  last=$result
}

# title_progress: sets $title, the beginning of the line in which the next tool shows its progress on a terminal. The
# pipeline sets $start, its Unix time, and $layout, the value of separatrix --layout; the number of all stages is known
# as long as nothing unforeseen happens.
title_progress() {
  title=''
  if [ -n "$quiet" ] || [ ! -t 2 ]; then return; fi
  case $name in
    *cad2tri) if [ "$layout" = midpoint ]; then after=4; else after=7; fi ;;
    *phase_fieldsolve) after=5 ;;
    *phase_padapt) after=4 ;;
    *fieldsolve) after=6 ;;
    *padapt) after=5 ;;
    *critpoints) after=4 ;;
    *separatrix) after=3 ;;
    *blocksplit) after=2 ;;
    *quadrefine) after=1 ;;
    *) after=0 ;;
  esac
  after=$((after > 8 - final_position ? after - 8 + final_position : 0))
  title="${0##*/}: stage $((number - 10)) of $((number - 10 + after)), $tool"
}

# In the background, since a shell that waits for a process in the foreground handles signals only after it.
start_tool() {
  set -- "$scratch/$number.$name.json" "$tool" "$@" -o "$result" --report "$scratch/$number.$name.json" \
    ${threads:+--threads "$threads"} --silent-warnings --called-by "${0##*/}"
  if [ -n "$quiet" ]; then within_budget "$@" -q 2>"$scratch/messages"; else within_budget "$@"; fi
}

# fail CODE TOOL [MESSAGE]: ends the pipeline, with a report; the stage has printed its message. In --workdir, a picture of
# the last file is added if the shape may be the cause: after 1 (no valid result, unless the stage was stopped) and 70
# (internal error). Temporary folders are always removed.
fail() {
  if [ -n "$stopped" ]; then
    name_limit
    last=''
  fi
  report_failure "$@"
  if [ -n "$last" ] && { [ "$1" -eq 1 ] || [ "$1" -eq 70 ]; }; then show_last_file "$2"; fi
  [ -z "$scratch" ] || rm -rf "$scratch"
  exit "$1"
}

# show_last_file TOOL: where to look after the tool failed.
show_last_file() {
  if [ "$dir" = "$scratch" ]; then
    echo "${0##*/}: run it again with --workdir DIR to keep the files of the stages before $1 and a picture" >&2
    return
  fi
  picture=$stem.before-$1.svg beside=''
  case $last in *.crit.json) beside=$field ;; esac
  stageview "$last" ${beside:+--field "$beside"} -o "$picture" 2>/dev/null || return
  echo "${0##*/}: the files of the stages before $1 are kept in $dir; look at the last one with" >&2
  echo "  xdg-open '$picture'" >&2
}
