# shellcheck shell=sh
# The page of a run (quadmesh --html).

# typed_command WORD...: the command for a shell; files without folders, so that the page can be given away.
typed_command() {
  for word in "$@"; do
    shift
    folder=${word%/*}
    case $word in
      --*=*/*) [ ! -d "${folder#*=}" ] || word=${word%%=*}=${word##*/} ;;
      */*) [ ! -d "$folder" ] || word=${word##*/} ;;
    esac
    set -- "$@" "$word"
  done
  print_command quadmesh "$@"
}

# show_page FILE REPORT: the files of all stages as tabs; what an earlier run left in the folder is older, and not shown.
# A further tab has the report with the command.
show_page() {
  page=$1
  jq --arg command "$typed" '{command: $command} + .' "$2" >"$scratch/run.json" || fail 70 quadmesh "internal error"
  set -- "$stem.tri.h5"
  for ending in field.h5 crit.json phase.h5 sep.json blocks.h5 quad.h5; do
    [ -z "$(find "$stem.$ending" -newer "$1" 2>/dev/null)" ] || set -- "$@" "$stem.$ending"
  done
  stageview -q "$@" --run-report "$scratch/run.json" -o "$page" || fail $? stageview
}
