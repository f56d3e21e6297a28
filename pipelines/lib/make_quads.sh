# shellcheck shell=sh
# From the triangles to the quads, or to the last stage of --until, by the stages between cad2tri and quadexport. Sets
# $nodes, the file of critical points.
field=''
nodes=/dev/null # as long as no file of critical points is written
way=''          # "field or triangles" as long as there is a choice
remedy=''       # options of critpoints that were added because a strip of blocks contained itself

# make_quads LAYOUT: the value of separatrix --layout. With "auto" (or none) the quads are made from the triangles alone
# where a stage finds no valid result, or is stopped (limit_stages.sh).
make_quads() {
  case $1 in
    midpoint) quads_of_triangles; return ;;
    '' | auto) [ "$first_position" -gt 5 ] || [ "$final_position" -lt 5 ] || way='field or triangles' may_use=most ;;
  esac
  quads_of_field
  made=$?
  leave_one_way
  [ "$made" -ne 0 ] || return 0
  [ -n "$quiet" ] || warn_of_triangles
  prefix=midpoint_
  quads_of_triangles
  prefix=''
}

# leave_one_way: the stages that follow have no other, and may use all seconds.
leave_one_way() { way='' may_use=all; }

warn_of_triangles() {
  if [ -n "$stopped" ]; then warn_of_limit && return; fi
  echo "${0##*/}: $failed_stage found no valid result: the quads are made without a field" >&2
}

# has_other_way TOOL REPORT: whether quads may be found without the tool after it found no valid result or was stopped.
# What a user asks of the quads, such as layers that do not fit, is refused.
has_other_way() {
  [ -n "$way" ] || return
  [ -z "$stopped" ] || return 0
  case $1 in
    fieldsolve | padapt | critpoints | separatrix) ;;
    quadrefine) [ "$(jq .valid "$2" 2>/dev/null)" = false ] ;;
    *) false ;;
  esac
}

quads_of_field() {
  field=$stem.field.h5
  stage fieldsolve "$stem.solve.h5" "$stem.tri.h5" && stage padapt "$field" "$stem.solve.h5" && graph_of_nodes "$stem" &&
    try_remedies && quads_of_graph
}

# graph_of_nodes STEM [OPTION...]: the separatrix graph for the triangles and the field of STEM, with these options of
# critpoints beside the chosen ones.
graph_of_nodes() {
  triangles=$1.tri.h5 field=$1.field.h5
  shift
  make_nodes "$@" || return
  nodes=$stem.crit.json
  if [ -z "$dry_run" ] && [ -f "$known_nodes" ]; then nodes=$known_nodes; fi # the user's name, for messages
  if [ -n "$dry_run" ] && ! has_phase_form "${known_nodes:-$nodes}"; then
    print_phase_stages
  elif need_own_field; then
    stages_of_phase || return
    field=$stem.phase.h5
    [ "$final_position" -lt 5 ] || last=$nodes
  fi
  stage separatrix "$stem.sep.json" "$field" "$nodes"
}

# need_own_field: whether $nodes are not those of the field: by their form, or because somebody has edited them and left
# the form as it was. Of another face they are refused when that field is made.
need_own_field() {
  has_phase_form "${known_nodes:-$nodes}" && return
  [ -n "$known_nodes" ] && [ -f "$field" ] && is_due separatrix '' || return
  message=$(separatrix "$field" --check-nodes "$nodes" 2>&1 </dev/null)
  case $message in *'run fieldsolve --nodes'* | *'was not made from'*) ;; *) false ;; esac
}

has_phase_form() { [ -f "$1" ] && jq -e '.form == "phase"' "$1" >/dev/null 2>&1; }

stages_of_phase() {
  stage fieldsolve "$stem.phase.solve.h5" --nodes "$nodes" --orders "$field" "$triangles" &&
    stage padapt "$stem.phase.h5" "$stem.phase.solve.h5"
}

# print_phase_stages: with --dry-run, for a person: whether they run depends on what critpoints finds.
print_phase_stages() {
  is_due separatrix '' || return 0
  echo "# if \"form\" is \"phase\" in $nodes, or its nodes were edited; separatrix then reads $stem.phase.h5:"
  before=$last
  stages_of_phase | sed 's/^/# /'
  last=$before
}

quads_of_triangles() { stage separatrix "$stem.sep.json" "$stem.tri.h5" && quads_of_graph; }

quads_of_graph() {
  stage blocksplit "$stem.blocks.h5" "$stem.sep.json" && stage quadrefine "$stem.quad.h5" "$stem.blocks.h5"
}
