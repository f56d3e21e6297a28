# shellcheck shell=sh
# Limits of time and memory of a pipeline (--max-seconds, --max-memory); stage_budget.py runs its stages within them.
budget=''   # three words for stage_budget.py; empty: there is no limit
may_use=all # the seconds, or most: some are kept for quads from triangles alone
stopped=''  # the report of the last stage, if that was stopped or killed

# open_budget SECONDS MEMORY: seconds count from the start of the pipeline. An empty word is no limit.
open_budget() {
  [ -n "$1$2" ] || return 0
  budget=$(python3 -ISB "$lib/stage_budget.py" open $$ "$1" "$2") || mistake "$budget"
}

# within_budget REPORT COMMAND...: starts the command, with no more than what is left and the pipeline's standard input.
within_budget() {
  # shellcheck disable=SC2086 # words
  if [ -n "$budget" ]; then
    set -- run $budget "$may_use" "$scratch/spent" "$@"
    python3 -ISB "$lib/stage_budget.py" "$@" <&3 &
  else
    shift
    "$@" <&3 &
  fi
  child=$!
}

# was_stopped CODE REPORT TOOL: whether a stage that ended with this code was stopped, or killed for want of memory.
was_stopped() {
  stopped=''
  case $1${budget:+ limited} in
    '124 limited') ;;
    137*) python3 -ISB "$lib/stage_budget.py" killed "$2" "$3" || return ;;
    *) return 1 ;;
  esac
  stopped=$2
}

# On standard error: that the quads are made without a field, and that there are none.
warn_of_limit() { jq -r '.warnings[] | "\(.tool): warning \(.code): \(.message)"' "$stopped" >&2; }
name_limit() { jq -r --arg name "${0##*/}" '"\($name): \(.tool) was \(.error)"' "$stopped" >&2; }
