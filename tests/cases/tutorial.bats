# Every command of pipelines/tutorial.md, on copies of its inputs. Those that need a solver are skipped without it, with
# the reason; the meshes are made all the same.
load ../tools/common

setup() {
  common_setup
  page=$ROOT/pipelines/tutorial.md
  export XDG_CACHE_HOME=$PWD/cache # of dolfinx
  mkdir build && ln -s "$BIN" build/bin
  ln -s "$ROOT/pipelines" .
}

# code HEADING: the pieces of code below a heading of the page, before the next one.
code() {
  awk -v heading="$1" '/^#/ && !inside { wanted = index($0, heading) } /^```$/ { inside = 0; if (wanted) print "" }
    inside && wanted; /^```sh$/ { inside = 1 }' "$page"
}

# runs HEADING [PROGRAM]: the first pieces of the page and those of the section; without PROGRAM, up to the first piece
# that needs it.
runs() {
  { code 'From a drawing'; code "$1"; } >commands
  assert [ "$(grep -c . commands)" -ge 5 ]
  missing=
  if [[ -n ${2-} ]] && ! eval "$2" >/dev/null 2>&1; then
    missing=yes
    sed -i -E '/^export WM_PROJECT_DIR|(pipe|pin|crack)_heat\.py|^for round/,$d' commands
  fi
  run -0 bash -euo pipefail commands
}

# near VALUE LOW HIGH
near() { awk -v x="$1" -v low="$2" -v high="$3" 'BEGIN { exit !(x + 0 > low && x + 0 < high) }' || fail "$1"; }

@test "flow around a cylinder: drag and lift of the benchmark" {
  runs '## 1.' 'command -v simpleFoam'
  assert_line --partial '12 blocks, 4 irregular nodes, 6191 quads'
  assert_equal "$(grep -c 'warning W-EXP-001: ' <<<"$output") $(grep -c 'warning W-' <<<"$output")" '2 2'
  assert_file_not_empty work/channel.svg
  assert_equal "$(sed -n '/^boundary/,$p' work/channel/system/blockMeshDict | sed -nE 's/^    ([a-zA-Z]+)$/\1/p' |
    sort | paste -sd ' ')" "cylinder frontAndBack inlet outlet walls"
  [[ -z $missing ]] || skip "no OpenFOAM: the mesh was made, nothing was solved"
  assert_line 'Mesh OK.'
  read -r drag lift <<<"${lines[-1]}"
  near "$drag" 5.54 5.58
  near "$lift" 0.0100 0.0115
}

@test "heat loss of a pipe: the exact one" {
  runs '## 2.' "/usr/bin/python3 -c 'import dolfinx, gmsh'"
  assert_file_not_empty work/pipe.msh
  [[ -z $missing ]] || skip "no dolfinx: the mesh was made, nothing was solved"
  assert_line --regexp '^heat loss 18\.84783. W/m, exact 18\.847830 W/m, relative error [1-9]\.[0-9]e-0[89]$'
}

@test "a pin in a stream: two materials, all heat leaves" {
  runs '### 4.1' "/usr/bin/python3 -c 'import dolfinx, gmsh'"
  assert_line --regexp '^1 +plane .* pin '
  assert_line --partial '17 blocks, 8 irregular nodes, 1256 quads'
  for name in '1 [0-9]+ "pin surface"' '2 [0-9]+ "fluid"' '2 [0-9]+ "pin"'; do
    grep -qE "^$name\$" work/pin.msh || fail "$name"
  done
  grep -qF 'interface of two regions' work/pin.svg
  [[ -z $missing ]] || skip "no dolfinx: the mesh was made, nothing was solved"
  assert_line --regexp '^pin 19\.06[0-9] K, heat that leaves with the water (1\.0000|0\.9999)[0-9] of what the pin gives$'
}

@test "a crack: the resistance of a plate with a crack, and without" {
  runs '### 4.2' "/usr/bin/python3 -c 'import dolfinx, gmsh'"
  assert_file_not_empty work/crack.msh
  [[ -z $missing ]] || skip "no dolfinx: the mesh was made, nothing was solved"
  assert_line --regexp '^resistance 1\.84[12][0-9], without the crack 1\.5000, strip 1\.8487$'
  sed -i 's/ --open crack//' commands
  rm -r work
  run -0 bash -euo pipefail commands
  assert_line --regexp '^resistance 1\.5000, '
}

@test "a blade passage: its sides have the same nodes" {
  need_h5py
  runs '### 4.3'
  refute_output --partial 'warning W-'
  assert_file_not_empty work/blade.svg
  grep -qxF "\$Periodic" work/blade.msh
  run -0 /usr/bin/python3 -B "$ROOT/tests/check_regions.py" work/stages/periodic_blade.quad.h5 \
    --face work/stages/periodic_blade.tri.h5 --area-tolerance 1e-4
  assert_line --regexp '^ok +periodic nodes: [1-9][0-9]+ pairs'
}

@test "a sliding band: both sides have their number of equal edges" {
  runs '### 4.4'
  assert_line --partial '17 blocks, 8 irregular nodes, 1518 quads'
  refute_output --partial W-QUA-007
  grep -qE '^1 [0-9]+ "pin surface"$' work/turning.msh
}

@test "an aerofoil from points: the drag of a finer mesh, no lift" {
  runs '## 3.' 'command -v simpleFoam'
  # Counts follow the last digits of the sizes: 2820 to 3374 quads within 1e-6 of them.
  assert_line --regexp ' (2[7-9]|3[0-4])[0-9][0-9] quads'
  [[ -z $missing ]] || skip "no OpenFOAM: the mesh was made, nothing was solved"
  read -r drag lift <<<"${lines[-1]}"
  near "$drag" 0.118 0.123
  near "$lift" -1e-6 1e-6
}

@test "a shock before a cylinder: three rounds lower the error a hundredfold" {
  runs '## 5.' "/usr/bin/python3 -c 'import dolfinx, gmsh'"
  grep -qF 'prescribed direction' work/field.svg
  assert_file_not_empty work/shock.svg
  [[ -z $missing ]] || skip "no dolfinx: the meshes were made, nothing was solved"
  read -r -a quads <<<"$(grep -oE '^[0-9]+ quads, error' <<<"$output" | cut -d ' ' -f 1 | paste -sd ' ')"
  read -r -a errors <<<"$(grep -oE 'quads, error [^,]+' <<<"$output" | cut -d ' ' -f 3 | paste -sd ' ')"
  assert_equal "${#errors[@]}" 4
  near "${quads[3]}" 700 1800
  near "${errors[0]}" 0.05 0.07
  near "${errors[3]}" 1e-4 1e-3
}

@test "the sections above are all that have commands" {
  run -0 awk '/^###? / { heading = $2 } /^```sh$/ && !seen[heading]++ { printf " %s", heading }' "$page"
  assert_output "  1. 2. 3. 4.1 4.2 4.3 4.4 5."
}

@test "the shapes and points are those that make_examples.py and make_regions.py draw" {
  mkdir made
  python3 -B "$DATA/make_examples.py" made
  for file in made/* "$DATA"/regions/{pin_in_channel,plate_crack,periodic_blade}.step; do
    cmp "$file" "$ROOT/pipelines/examples/${file##*/}"
  done
  cmp "$DATA/bow_shock.step" "$ROOT/pipelines/examples/bow_shock.step"
  cmp "$DATA/alignment/bow_shock.align.json" "$ROOT/pipelines/examples/shock.align.json"
}
