# shellcheck shell=sh
# The page of a run (quadmesh --html).

# show_page FILE: the files of all stages as tabs; what an earlier run left in the folder is older, and not shown.
show_page() {
  page=$1
  set -- "$stem.tri.h5"
  for ending in field.h5 crit.json phase.h5 sep.json blocks.h5 quad.h5; do
    [ -z "$(find "$stem.$ending" -newer "$1" 2>/dev/null)" ] || set -- "$@" "$stem.$ending"
  done
  stageview -q "$@" -o "$page" || fail $? stageview
}
