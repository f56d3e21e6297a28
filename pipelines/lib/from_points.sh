# shellcheck shell=sh
# A file of points as SHAPE: points2step makes a CAD file of it, which cad2tri reads.

# has_points: by the options of points2step, or by the ending of the file.
has_points() {
  [ "$first_position" -eq 1 ] || return 1
  case $separator$chosen in *"${separator}points2step "*) return 0 ;; esac
  case $shape in *.dat | *.xy) ;; *) return 1 ;; esac
}

# make_cad_file: sets $cad_file, the SHAPE or what points2step makes of it.
make_cad_file() {
  cad_file=$shape
  has_points || return 0
  cad_file=$stem.outline.step
  if [ -n "$dry_run" ]; then
    with_options points2step print_command points2step "$shape" -o "$cad_file"
    return
  fi
  message=$(with_options points2step "$here/points2step" "$shape" -o "$cad_file" 2>&1) &&
    { warn_of_points && return; }
  code=$?
  printf '%s\n' "$message" | sed 's/^points2step: /quadmesh: /; s/points2step --help/quadmesh --help/' >&2
  message=${message#points2step: }
  fail "$code" points2step "${message%%
*}"
}

# warn_of_points: prints the warnings in $message, and writes them as the report of a stage without times.
warn_of_points() {
  [ -n "$message" ] || return 0
  printf '%s\n' "$message" | jq -R -n '{tool: "points2step",
    warnings: [inputs | capture("^points2step: warning (?<code>W-[A-Z]+-[0-9]+): (?<message>.*)$")]}' \
    >"$scratch/$number.points2step.json" && print_warnings "$scratch/$number.points2step.json"
}
