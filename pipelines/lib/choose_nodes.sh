# shellcheck shell=sh
# The file of critical points: from critpoints, from --nodes, or as a user edited it in the work folder.
known_nodes='' # the file that the nodes come from, if critpoints does not choose them in this run

# make_nodes [OPTION...]: makes $stem.crit.json; the options are added to those of critpoints.
make_nodes() {
  if [ -n "$given_nodes" ]; then
    copy_given_nodes
  elif [ "$first_position" -gt 4 ]; then
    known_nodes=$stem.crit.json
  elif [ "$first_position" -eq 4 ] && [ -s "$stem.crit.json" ] && [ -z "$prefix" ]; then
    find_nodes_again "$@"
  else
    stage critpoints "$stem.crit.json" "$field" "$@"
  fi
}

# copy_given_nodes: as if critpoints had written them; --nodes may be that file itself.
copy_given_nodes() {
  known_nodes=$given_nodes last=$stem.crit.json
  if is_same_file "$given_nodes" "$stem.crit.json"; then return; fi
  if [ -n "$dry_run" ]; then
    print_command cp "$(echo "$given_nodes" | sed 's|^-$|/dev/stdin|')" "$stem.crit.json"
  elif [ "$given_nodes" = - ]; then
    cat <&3 >"$scratch/given.crit.json" && require_nodes "$scratch/given.crit.json"
    known_nodes=$scratch/given.crit.json
    write_file "$known_nodes" "$stem.crit.json"
  else
    write_file "$given_nodes" "$stem.crit.json"
    [ -f "$given_nodes" ] || known_nodes=$stem.crit.json # a pipe can be read once
  fi
}

# find_nodes_again [OPTION...]: runs critpoints; a file with the same provenance but other content was edited, and kept.
# With another provenance, that is with other options, it is replaced, but not if it has nodes that were set by hand.
find_nodes_again() {
  if [ -n "$dry_run" ]; then
    echo "# $stem.crit.json is kept if it was edited after critpoints wrote it"
    stage critpoints "$stem.crit.json" "$field" "$@"
    return
  fi
  stage critpoints "$scratch/found.crit.json" "$field" "$@" || return
  last=$stem.crit.json
  if is_edited "$scratch/found.crit.json" "$stem.crit.json"; then
    known_nodes=$stem.crit.json
    [ -n "$quiet" ] ||
      echo "${0##*/}: $stem.crit.json was edited after critpoints wrote it: its nodes are used" >&2
  elif has_nodes_by_hand "$stem.crit.json" && ! cmp -s "$scratch/found.crit.json" "$stem.crit.json"; then
    message="$stem.crit.json was edited, but made with other options of critpoints: use it with --from separatrix, or \
remove it"
    echo "${0##*/}: $message" >&2
    fail 2 "${0##*/}" "$message"
  else
    write_file "$scratch/found.crit.json" "$stem.crit.json"
  fi
}

# has_nodes_by_hand FILE: nodes without the source that critpoints writes.
has_nodes_by_hand() {
  jq -e 'any(.critical_points[]?; (.source // "hand") == "hand")' "$1" >/dev/null 2>&1
}

# is_edited FOUND FILE
is_edited() {
  jq -n -e --slurpfile found "$1" --slurpfile file "$2" \
    '$found[0] as $a | $file[0] as $b | $a.provenance == $b.provenance and $a != $b' >/dev/null 2>&1
}
