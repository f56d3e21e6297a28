# shellcheck shell=sh
# What quadmesh prints and reports of a run: warnings, each once; the report, also after a failure; the line about the
# mesh; the commands of --dry-run.

# print_warnings REPORT: of a stage, unless one with the same code and text was printed before.
print_warnings() {
  [ -z "$quiet" ] || return 0
  { grep -q '"code": *"W-' "$1"; } 2>/dev/null || return 0
  jq -r '.tool as $tool | .warnings[] | "\(.tool // $tool): warning \(.code): \(.message | gsub("\n"; " "))"' "$1" \
    2>/dev/null | while IFS= read -r warning; do
    text=${warning#*: }
    if ! { grep -Fqx -e "$text" "$scratch/warned"; } 2>/dev/null; then
      printf '%s\n' "$warning" >&2
      printf '%s\n' "$text" >>"$scratch/warned"
    fi
  done
}

# reports_of_stages: their names, one a line.
reports_of_stages() {
  for json in "$scratch"/[1-9][0-9].*.json; do
    [ ! -s "$json" ] || printf '%s\n' "$json"
  done
}

# merge_reports FILTER [ARGUMENT...]: runs the filter of quadmesh.jq with the report of the run as its input.
merge_reports() {
  filter=$1
  shift
  nodes_file=$nodes
  [ -e "$nodes_file" ] || nodes_file=/dev/null
  whole=$(reports_of_stages)
  version_text=$(cad2tri --version) || version_text=
  (
    IFS='
'
    set -f
    # shellcheck disable=SC2086 # a name in each line
    jq -n -r -L "$lib" --argjson start "$start" --argjson verbose "$verbose" --slurpfile nodes "$nodes_file" \
      --arg remedy "$remedy" --arg version "${version_text##* }" "$@" \
      "include \"quadmesh\"; report(\$start; \$nodes[0]; \$remedy; \$version) | $filter" ${whole:-/dev/null}
  )
}

# report_failure CODE TOOL [MESSAGE]: --report also has what failed. Without MESSAGE, it is in the report of the stage.
report_failure() {
  [ -n "$report" ] && [ -z "$dry_run" ] || return 0
  json=$(printf '%s\n' "$scratch/$number".*."json") && json=${json##*
}
  message=${3-$(jq -r '.error // empty' "$json" 2>/dev/null)}
  # shellcheck disable=SC2016 # variables of jq
  merge_reports '{exit_code: $code, stage: $stage, error: $message} as $failure | . + $failure' \
    --argjson code "$1" --arg stage "$2" --arg message "$message" >"$scratch/failure" 2>/dev/null &&
    write_report "$scratch/failure"
}

# write_report FILE: once, also if it cannot be written.
write_report() {
  target=$report report=''
  [ -z "$target" ] || write_file "$1" "$target"
}

# compose_report: $scratch/report.json, and in $scratch/words the same with a few words for a person behind it.
compose_report() {
  # shellcheck disable=SC2016 # variables of jq
  merge_reports '. + {exit_code: 0, stage: null, error: null} |
    ., if $verbose then times else empty end, summary($until; $last)' \
    --arg until "$last_stage" --arg last "$last" >"$scratch/words" || fail 70 quadmesh "internal error"
  sed '/^}$/q' "$scratch/words" >"$scratch/report.json" || fail 4 quadmesh "no space for temporary files"
}

# report_run: writes the report and prints the words, on stderr if the mesh or the report went to stdout.
report_run() {
  if [ "${out:--}" = - ] || [ "$report" = - ]; then uses_stdout=yes; else uses_stdout=; fi
  [ "$final_position" -eq 8 ] || [ "$report" = - ] || uses_stdout=
  write_report "$scratch/report.json"
  [ -z "$uses_stdout" ] || exec >&2
  [ -n "$quiet" ] || sed '1,/^}$/d' "$scratch/words"
}

# print_command WORD...: for a shell, quoted where necessary.
print_command() {
  line=''
  for word in "$@"; do
    case $word in
      '' | *[!A-Za-z0-9_./:=,+%@-]*) word=$(printf '%s\n' "$word." | sed "s/'/'\\\\''/g") && word="'${word%.}'" ;;
    esac
    line="$line $word"
  done
  printf '%s\n' "${line# }"
}

print_tool() {
  print_command "$tool" "$@" -o "$result" ${threads:+--threads "$threads"} ${quiet:+-q}
}

# write_file SOURCE TARGET: all or nothing, with 4 and a message if it fails; straight into a pipe or a device.
write_file() {
  if [ "$2" = - ]; then
    cat "$1" || fail 4 "${0##*/}"
    return
  elif [ -e "$2" ] && [ ! -f "$2" ]; then
    message=$({ cat "$1" >"$2"; } 2>&1)
  else
    part=$2.part
    message=$({ cp "$1" "$part" && mv "$part" "$2"; } 2>&1)
  fi || {
    cannot_write "$2" "$message"
    rm -f "$part"
    report=''
    fail 4 "${0##*/}"
  }
}
