# shellcheck shell=sh
# Where separatrix could only divide triangles, other nodes may give a layout: its report has options of critpoints that
# change those on a strip of blocks that contains itself (quantize.remedies), or the grid around a body (other_grids).
# The first that gives a layout replaces nodes, field and graph; if none does, or a stage is stopped (limit_stages.sh),
# they stay. Options that the user chose are not replaced, nor nodes that a user gave or edited (choose_nodes.sh).

# try_remedies: after separatrix. Sets $remedy, and moves the files of the graph that is taken to the usual names.
try_remedies() {
  usual=$stem usual_nodes=$nodes usual_field=$field usual_last=$last first=$number
  [ -z "$known_nodes$dry_run" ] && is_due separatrix '' || return 0
  [ -z "$way" ] || list_remedies "$scratch/$number.separatrix.json" >"$scratch/remedies" || fail 70 jq
  [ -s "$scratch/remedies" ] || return 0
  while read -r option value; do
    [ -z "$(chosen_value critpoints "$option")" ] || continue
    try_remedy "$option" "$value" && return
    [ -z "$stopped" ] || { leave_one_way && break; }
  done <"$scratch/remedies"
  if [ -n "$stopped" ] && [ -z "$quiet" ]; then warn_of_limit; fi
  nodes=$usual_nodes field=$usual_field last=$usual_last
}

# list_remedies REPORT: one a line, if no layout was found without them.
list_remedies() {
  jq -r 'select(.certificate.method == "midpoint") | .quantize.remedies, .other_grids | values | split(", ")[]' "$1"
}

# try_remedy OPTION VALUE: reports of stages that are not used are called NUMBER.failed_STAGE.json.
try_remedy() {
  [ -n "$quiet" ] || echo "${0##*/}: no layout with these nodes: trying critpoints $1 $2" >&2
  before=$number stem=$usual.remedy prefix=failed_
  graph_of_nodes "$usual" "$@" && [ "$(jq -r .certificate.method "$scratch/$number.failed_separatrix.json")" != midpoint ]
  code=$?
  stem=$usual prefix=''
  if [ "$code" -eq 0 ]; then take_remedy "$@"; else rm -f "$usual".remedy.*; fi
  return "$code"
}

take_remedy() {
  remedy="critpoints $*"
  mv "$scratch/$first.separatrix.json" "$scratch/$first.failed_separatrix.json"
  for json in "$scratch"/*.failed_*; do
    run=${json#"$scratch"/} && run=${run%%.*}
    [ "$run" -le "$before" ] || mv "$json" "${json%%.failed_*}.remedy_${json#*.failed_}"
  done
  for json in "$scratch"/*.remedy_*; do print_warnings "$json"; done
  rm -f "$usual".phase.*
  for file in "$usual".remedy.*; do mv "$file" "$usual${file#"$usual".remedy}"; done
  nodes=$usual.crit.json last=$usual.sep.json
  case $field in "$usual".remedy.*) field=$usual${field#"$usual".remedy} ;; esac
}
