# Loaded by every file of tests/peers: `load common`. Independent readers of what quadexport writes; they are installed
# here, by the tests that need them, because nothing else of the project does.
load ../tools/common

# Apt's modules are those of the distribution's own interpreter.
PYTHON=/usr/bin/python3
# Of all shapes; the files of peers share them where $QUADRILLE_LAYOUTS names a folder.
LAYOUTS=${QUADRILLE_LAYOUTS:-$BATS_RUN_TMPDIR/layouts}
export PYTHONDONTWRITEBYTECODE=1

# need PACKAGE...: installs what is missing, as root and online; skips the test with the reason where it cannot.
need() {
  local package missing=()
  for package; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] || missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  [[ ! -e $BATS_FILE_TMPDIR/cannot_install ]] || skip "not installed: ${missing[*]}"
  command -v apt-get >/dev/null || skip "no apt-get to install ${missing[*]}"
  [[ $(id -u) == 0 ]] || skip "not root, and not installed: ${missing[*]}"
  # Files of tests run side by side: one installs at a time. Nothing that is there gives way (--no-remove).
  mkdir -p "$LAYOUTS"
  local apt=(flock "$LAYOUTS/apt.lock" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300)
  { "${apt[@]}" update && "${apt[@]}" -y --no-remove --no-install-recommends install "${missing[@]}"; } \
    >"$BATS_FILE_TMPDIR/apt.log" 2>&1 || {
    touch "$BATS_FILE_TMPDIR/cannot_install"
    skip "cannot install ${missing[*]}: $(tail -n 1 "$BATS_FILE_TMPDIR/apt.log")"
  }
}

# shapes: the STEP files to be judged: those of tests/data; in long runs all of ../shared/geometries too, if it exists.
shapes() {
  local file
  for file in "$DATA"/*.step; do echo "$file"; done
  [[ -n ${QUADRILLE_LONG-} && -d $ROOT/../shared/geometries ]] || return 0
  for file in "$ROOT"/../shared/geometries/*.step; do
    [[ -e $DATA/${file##*/} ]] || echo "$file"
  done
}

# blocks_of STEP: prints the path of the shape's block layout, made when it is asked for first.
blocks_of() {
  local name
  name=$(basename "$1" .step)
  mkdir -p "$LAYOUTS/$name"
  (
    flock 9
    [[ -e $LAYOUTS/$name/$name.blocks.h5 ]] ||
      "$ROOT/pipelines/quadmesh" -q "$1" -o "$LAYOUTS/$name/$name.msh" --workdir "$LAYOUTS/$name" >/dev/null
  ) 9>"$LAYOUTS/$name.lock" || return 1
  echo "$LAYOUTS/$name/$name.blocks.h5"
}

# coarse ORDER...: for each shape and order prints NAME ORDER and the path, without its ending, of a mesh of few elements
# in X.quad.h5, and of one twisted layer of it in X.hex.h5; made when they are asked for first.
coarse() {
  local file name blocks folder size order
  while read -r file; do
    name=$(basename "$file" .step)
    blocks=$(blocks_of "$file")
    folder=${blocks%/*}
    size=$(jq '.face.diameter / 6' "$folder/$name.sep.json")
    for order; do
      coarse_mesh "$blocks" "$order" "$size" "$folder/coarse.$order" || return 1
      echo "$name $order $folder/coarse.$order"
    done
  done < <(shapes)
}

# coarse_mesh BLOCKS ORDER SIZE PATH
coarse_mesh() {
  (
    flock 9
    [[ ! -e $4.hex.h5 ]] || exit 0
    quadrefine -q --order "$2" --per-curve 0 --size "$3" --geometry-tol 1 "$1" -o "$4.quad.h5" &&
      hexsweep -q "$4.quad.h5" --layers 1 --height "$3" --twist 20 -o "$4.hex.h5"
  ) 9>"$4.lock"
}

# example N LANGUAGE PAGE: the Nth piece of code in that language on formats/export/PAGE.md.
example() {
  awk -v wanted="$1" -v fence="\`\`\`$2" '$0 == "```" { inside = 0 } inside; $0 == fence { inside = ++n == wanted }' \
    "$ROOT/formats/export/$3.md"
}
