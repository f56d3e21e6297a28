# quadexport: files of other programs.
load common

setup_file() {
  stage_chain half_disc "$BATS_FILE_TMPDIR"
}

setup() {
  common_setup
  quad=$BATS_FILE_TMPDIR/half_disc.quad.h5
  blocks=$BATS_FILE_TMPDIR/half_disc.blocks.h5
}

@test "writes a Gmsh file silently, the same through pipes" {
  run quadexport "$quad" -o a.msh
  assert_success
  assert_output ""
  assert_nothing_left a.msh
  quadexport < "$quad" > b.msh
  cmp a.msh b.msh
  quadexport --format msh "$quad" -o c.out
  cmp a.msh c.out
}

@test "names boundaries and blocks" {
  quadexport "$quad" -o a.msh
  run grep '^2 [0-9]* "' a.msh
  assert_output '2 3 "domain"'
  run grep -c '^1 [0-9]* "' a.msh
  assert_output 2
}

@test "--block-groups writes each block without a name as a region of its own" {
  quadexport --block-groups "$quad" -o a.msh
  assert_equal "$(grep -c '^2 [0-9]* "block_[0-3]"' a.msh)" 4
  quadexport --block-groups --format mfem13 "$quad" -o a.mesh
  assert_equal "$(grep -c '^"block_[0-3]" 1 [1-4]$' a.mesh)" 4
  quadexport --block-groups "$quad" -o a.xml
  assert_equal "$(grep -c 'NAME="block_[0-3]"> Q' a.xml)" 4
  quadexport -q --block-groups "$quad" -o blockMeshDict
  assert_equal "$(grep -oE 'hex .*\) block_[0-9]+ ' blockMeshDict | wc -l)" "$(grep -c '^    hex' blockMeshDict)"
  run quadexport --block-groups "$quad" -o a.re2
  assert_output --partial '4 region names are not stored'
  # Named blocks keep their names, with the option and without.
  echo '[{"id": 1, "name": "core"}]' >names.json
  blocksplit --block-names names.json <(jq . "$BATS_FILE_TMPDIR/half_disc.sep.json") | quadrefine --size 0.5 -o b.quad.h5
  regions() { quadexport "$@" b.quad.h5 | sed -nE 's/^2 [0-9]+ "(.*)"$/\1/p' | tr '\n' ' '; }
  assert_equal "$(regions)" 'domain core '
  assert_equal "$(regions --block-groups)" 'block_0 core block_2 block_3 '
}

@test "MSH 2.2 is there for those who ask" {
  run quadexport --format msh22 "$quad" -o a.msh
  assert_success
  assert_output ""
  run sed -n 2p a.msh
  assert_output "2.2 0 8"
  assert_equal "$(grep -c '^2 [0-9]* "domain"' a.msh)" 1
}

@test "VTU has its curves in a second file, which standard output leaves out" {
  run quadexport "$quad" -o a.vtu
  assert_success
  assert_output ""
  assert_nothing_left a.vtu a.curves.vtu
  run xmllint --noout a.vtu a.curves.vtu
  assert_success
  run --separate-stderr quadexport --format vtu "$quad"
  assert_success
  assert_equal "$output" "$(cat a.vtu)"
  assert_equal "$stderr" "quadexport: warning W-EXP-002: *.curves.vtu is not written: standard output can contain one file only"
  mkfifo pipe
  cat pipe > through_pipe &
  run quadexport --format vtu "$quad" -o pipe
  assert_output --partial "pipe can contain one file only"
  wait
  cmp a.vtu through_pipe
  quadexport --format vtu-bezier "$quad" -o b.vtu
  assert_equal "$(wc -c < b.vtu)" "$(wc -c < a.vtu)"
  run ! cmp -s a.vtu b.vtu
}

@test "every format gives the same bytes through pipes, and says what it cannot hold only once" {
  formats=$(quadexport --help | sed -nE '/^  --format /,/^  --frame/s/^ +([a-z0-9-]+): .*/\1/p' | grep -vE '^(auto|step)$')
  assert [ "$(wc -l <<< "$formats")" -ge 4 ]
  stage_blocks . quarter_annulus
  quadrefine -q quarter_annulus.blocks.h5 -o right.quad.h5 # x is not negative there
  for format in $formats; do
    mesh=$quad
    [[ $format != abaqus-cax ]] || mesh=right.quad.h5
    quadexport --format "$format" "$mesh" -o a.out 2> said
    quadexport -q --format "$format" < "$mesh" > b.out 2> nothing
    cmp a.out b.out
    [[ ! -s nothing ]] || fail "$format: $(cat nothing)"
    assert_equal "$(sort said | uniq -d)" ""
  done
}

@test "Gmsh reads every order that it knows" {
  command -v gmsh || skip "no gmsh"
  for order in 1 2 3 4 5 6 7 8 9 10; do
    quadrefine --order $order --size 0.5 --geometry-tol 1e-3 "$blocks" | quadexport -o a.msh
    run gmsh -check a.msh
    assert_success
    refute_output --partial "Warning"
    refute_output --partial "Error"
  done
}

@test "an order above 10 ends with 1 and no file" {
  quadrefine --order 11 "$blocks" -o a.quad.h5
  run quadexport a.quad.h5 -o a.msh
  assert_failure 1
  assert_output --partial "order"
  assert_nothing_left a.quad.h5
}

@test "blocks become a STEP model, also through a pipe" {
  run quadexport "$blocks" -o a.step
  assert_success
  assert_output ""
  run head -n 1 a.step
  assert_output "ISO-10303-21;"
  quadexport --format step < "$blocks" > b.step
  cmp a.step b.step
}

# scaled FACTOR A B: every number of B is FACTOR times that of A, or, where it is no length, the same.
scaled() {
  python3 - "$@" <<'PYTHON'
import re, sys
factor = float(sys.argv[1])
a, b = (re.split(r"[^0-9eE.+-]+", open(path).read()) for path in sys.argv[2:])
assert len(a) == len(b)
def number(text):
    try: return float(text)
    except ValueError: return 0
lengths = 0
for x, y in zip(a, b):
    if x != y:
        assert abs(number(y) - factor * number(x)) <= 1e-14 * abs(number(y)), (x, y)
        lengths += 1
assert lengths > 100, lengths
PYTHON
}

@test "--unit and --scale change the coordinates of every format, and the report says so" {
  for format in msh msh22 nektar mfem13 ism-v2 inp; do
    quadexport -q --format $format "$quad" -o a.out
    quadexport -q --format $format --unit m "$quad" -o b.out --report b.json
    scaled 0.001 a.out b.out
    quadexport -q --format $format --unit m --scale 1000 "$quad" -o c.out
    cmp a.out c.out
    assert_equal "$(jq -r '"\(.unit) \(.scale)"' b.json)" "metre 0.001"
  done
  run quadexport -v --format mfem13 --scale 2 "$quad" -o a.out --report a.json
  assert_output --partial "quadexport: coordinates in an unknown unit, 2 times those of the CAD file"
  assert_equal "$(jq -r '"\(.unit) \(.scale)"' a.json)" "unknown 2"
  run quadexport -v --format mfem13 "$quad" -o a.out
  assert_output "quadexport: coordinates in millimetre, as in the CAD file"
  # OpenFOAM converts to metres itself, unless the unit is not known.
  scale_of() { quadexport -q --format blockmesh "$@" "$quad" | sed -n 's/^scale //p'; }
  assert_equal "$(scale_of) $(scale_of --unit m) $(scale_of --unit in) $(scale_of --scale 0.001)" "0.001; 1; 0.0254; 1;"
  assert_equal "$(scale_of --scale 1)" "1;"
}

@test "--unit and --scale change a STEP model" {
  quadexport "$blocks" -o a.step
  quadexport --unit in "$blocks" -o b.step
  quadexport --scale 2 "$blocks" -o c.step
  diameter() { cad2tri --face 0 "$1" -q -o a.tri.h5 --report a.json && jq -r '"\(.face.length_unit) \(.face.diameter)"' a.json; }
  read -r _ a <<<"$(diameter a.step)"
  run -0 diameter b.step
  assert_regex "$output" '^inch '
  run -0 awk -v a="$a" '{ print ($2 * 25.4 / a - 1) ^ 2 < 1e-16 }' <<<"$output"
  assert_output 1
  run -0 diameter c.step
  assert_regex "$output" '^millimetre '
  run -0 awk -v a="$a" '{ print ($2 / 2 / a - 1) ^ 2 < 1e-16 }' <<<"$output"
  assert_output 1
  run -0 quadexport -v --unit m "$blocks" -o d.step --report d.json
  assert_output "quadexport: coordinates in metre, 0.001 times those of the CAD file"
  assert_equal "$(jq -c '[.format, .blocks > 1, .unit, .scale]' d.json)" '["step",true,"metre",0.001]'
  # Units for which the CAD kernel has no name, and a yard, which becomes millimetres.
  for unit in NANO:nanometre PICO:picometre HECTO:hectometre; do
    IFS=: read -r prefix name <<<"$unit"
    sed "s/SI_UNIT(.MILLI.,.METRE.)/SI_UNIT(.$prefix.,.METRE.)/" "$DATA/square.step" >"$prefix.step"
    cad2tri -q "$prefix.step" | fieldsolve -q | padapt -q -o "$prefix.field.h5"
    critpoints -q "$prefix.field.h5" | separatrix -q "$prefix.field.h5" - | blocksplit -q -o "$prefix.blocks.h5"
    run -0 quadexport "$prefix.blocks.h5" -o "$prefix.out.step"
    assert_output ''
    assert_equal "$(diameter "$prefix.out.step")" "$name $(diameter "$prefix.step" | cut -d ' ' -f 2)"
  done
  quadexport --unit nm "$blocks" -o e.step
  run -0 diameter e.step
  assert_regex "$output" '^nanometre '
  run -0 awk -v a="$a" '{ print ($2 / 1e6 / a - 1) ^ 2 < 1e-16 }' <<<"$output"
  assert_output 1
}

@test "STEP of blocks whose unit is an empty text is in an unknown unit" {
  jq '.face.length_unit = ""' "$BATS_FILE_TMPDIR/half_disc.sep.json" >x.sep.json
  blocksplit x.sep.json -o x.blocks.h5
  run -0 quadexport -v x.blocks.h5 -o x.step
  assert_output --partial "coordinates in an unknown unit"
}

@test "the faces of a STEP model have the names of their regions" {
  # names FILE: how many faces have each name.
  names() { cad2tri --list "$1" --report list.json -o /dev/null && jq -r '.list.face[] | .name' list.json | sort | uniq -c | xargs; }
  number=$(quadexport "$blocks" -o a.step --report a.json && jq .blocks a.json)
  assert_equal "$(names a.step)" "$number domain"
  quadexport --block-groups "$blocks" -o b.step
  assert_equal "$(names b.step)" "$(for ((i = 0; i < number; i++)); do echo 1 block_$i; done | sort -k 2 | xargs)"
  cad2tri "$DATA/square.step" -q | fieldsolve -q | padapt -q -o s.field.h5
  critpoints s.field.h5 | separatrix s.field.h5 - -o s.sep.json
  blocksplit --block-names <(echo '"core"') s.sep.json | quadexport --format step -o c.step
  assert_equal "$(names c.step)" "1 core"
}

@test "--unit needs the unit of the CAD file" {
  cad2tri "$DATA/square.step" --write-healed square.brep -o a.tri.h5
  cad2tri square.brep | fieldsolve -q | padapt -q -o a.field.h5
  critpoints a.field.h5 | separatrix a.field.h5 - | blocksplit | quadrefine --size 0.5 -o a.quad.h5
  run quadexport --unit m a.quad.h5 -o a.msh
  assert_failure 2
  assert_output --partial "--unit m: the CAD file states no length unit: give the factor by --scale instead"
  quadexport --scale 0.001 a.quad.h5 -o a.msh
  run quadexport --unit parsec a.quad.h5 -o b.msh
  assert_failure 2
  run quadexport --scale 0 a.quad.h5 -o b.msh
  assert_failure 2
}

@test "--patch-type sets the types of OpenFOAM's patches, which names decide otherwise" {
  cad2tri "$DATA/half_disc.step" --name Walls=0 --name symmetry=1 -q | fieldsolve -q | padapt -q -o a.field.h5
  critpoints a.field.h5 | separatrix a.field.h5 - | blocksplit | quadrefine --order 1 --size 0.5 --geometry-tol 1 -o a.quad.h5
  types() { quadexport -q "$@" a.quad.h5 -o blockMeshDict && sed -n 's/^        type //p' blockMeshDict | tr -d '\n'; }
  assert_equal "$(types)" "wall;symmetry;empty;"
  assert_equal "$(types --patch-type 'W*=patch' --patch-type symmetry=symmetryPlane)" "patch;symmetryPlane;empty;"
  run quadexport a.quad.h5 --patch-type lid=wall -o blockMeshDict
  assert_failure 2
  assert_output --partial "--patch-type lid=wall: no boundary has this name; the boundaries are Walls, symmetry"
  run quadexport a.quad.h5 --patch-type Walls=cyclic -o blockMeshDict
  assert_failure 2
  run quadexport a.quad.h5 --patch-type Walls=wall -o a.msh
  assert_failure 2
  assert_output --partial "--patch-type: boundaries have no types in the format msh"
  run quadexport nowhere.quad.h5 --patch-type Walls=wall -o a.msh # refused before the mesh is read
  assert_failure 2
  run quadexport "$blocks" --patch-type Walls=wall -o a.step
  assert_failure 2
}

@test "--check-for reports what the solver measures, and changes no byte" {
  local pair
  for pair in openfoam:blockmesh su2:su2 nektar:nektar trixi:inp calculix:abaqus moose:exodus; do
    quadexport -q "$quad" --format "${pair#*:}" -o a.out
    run -0 quadexport -q "$quad" --format "${pair#*:}" --check-for "${pair%:*}" -o b.out --report b.json
    cmp a.out b.out
    jq -e --arg solver "${pair%:*}" '.check_for.solver == $solver and .check_for.elements > 0' b.json
  done
  run -0 quadexport -v "$quad" --check-for su2 -o a.su2
  assert_output --regexp 'SU2: Jacobian ratio 0\.[0-9]+ at worst, of element [0-9]+ near \('
}

@test "--check-for warns where a measure reaches the solver's limit, and ends with 1 and no file where it must not" {
  hexsweep -q "$quad" --height 0.5 --layers 4 --twist 80 -o a.hex.h5
  run -0 quadexport a.hex.h5 --check-for openfoam --format polymesh -o points
  assert_output --regexp 'W-EXP-004: non-orthogonality 7[0-9.]+ degrees of element [0-9]+ near \(.* limit 70 of OpenFOAM'
  quadrefine -q "$blocks" --wall curve_0:first=2e-5,growth=1.5,layers=12 -o a.quad.h5
  run -1 quadexport a.quad.h5 --check-for openfoam -o blockMeshDict --report a.json
  assert_output --regexp 'aspect ratio [0-9]+ of element [0-9]+ near \(.* limit 1000 of OpenFOAM .*without --check-for'
  assert_file_not_exists blockMeshDict
  run -1 quadexport "$quad" --check-for openfoam --patch-type curve_1=symmetryPlane -o blockMeshDict
  assert_output --partial 'choose --patch-type NAME=symmetry'
  jq -e '.check_for.aspect_ratio.value > 1000 and (.check_for.aspect_ratio.position | length == 2)' a.json
  quadexport -q a.quad.h5 -o blockMeshDict
}

@test "--check-for refuses formats and orders that the solver does not read, quadmesh before it begins" {
  run -2 quadexport "$quad" --check-for openfoam -o a.msh
  assert_output --partial 'OpenFOAM does not read the format msh: choose blockmesh, polymesh'
  run -1 quadexport "$quad" --check-for flexi -o a.cgns
  assert_output --partial 'hexsweep'
  run -1 quadexport "$quad" --check-for dealii -o a.msh
  assert_output --partial 'deal.II reads quads up to order 1, these have order'
  run -2 quadmesh "$DATA/half_disc.step" --order 4 --check-for dolfinx -o a.msh
  assert_output --partial 'dolfinx reads quads up to order 3'
  assert_file_not_exists a.msh
}

@test "tables of names beside two meshes do not overwrite each other, and messages have their paths" {
  mkdir x.d
  run -0 quadexport "$quad" -o x.d/a.re2
  assert_output --partial "names are stored as numbers, which x.d/a.re2.names.json lists"
  refute_output --partial " 0.f00000"
  run -0 quadexport "$quad" -o x.d/a.mesh
  assert_output --partial "their names are in x.d/a.mesh.names.json"
  assert_equal "$(ls x.d | tr '\n' ' ')" "a.mesh a.mesh.names.json a.re2 a.re2.names.json a0.f00000 "
}

@test "abaqus-cax refuses negative radii, with the remedy" {
  run -1 quadexport --format abaqus-cax "$quad" -o a.inp
  assert_output --partial "x is the radius of axisymmetric elements, and the mesh begins at x = -1: move the drawing"
  assert_nothing_left
}

@test "an unknown ending ends with 2" {
  run quadexport "$quad" -o a.stl
  assert_failure 2
  assert_output --partial ".msh"
  assert_nothing_left
}

@test "the wrong stage's file ends with 3" {
  run quadexport "$blocks" -o a.msh
  assert_failure 3
  run quadexport "$quad" -o a.step
  assert_failure 3
  assert_nothing_left
}

@test "an output that cannot be written ends with 4" {
  run quadexport "$quad" -o nowhere/a.msh
  assert_failure 4
  run --separate-stderr quadexport "$blocks" -o nowhere/a.step --report a.json
  assert_failure 4
  assert_equal "quadexport: $(jq -r '[.error, .exit_code] | join(" ")' a.json)" "$stderr 4"
  [[ $stderr == "quadexport: nowhere/a.step: "* ]]
}

@test "--frame 3d puts the mesh on the plane and the curves of the CAD model, in its unit" {
  cad2tri "$DATA/tilted_half_disc.step" | fieldsolve -q | padapt -q -o a.field.h5
  critpoints a.field.h5 | separatrix a.field.h5 - | blocksplit | quadrefine --size 0.5 -o a.quad.h5
  for format in msh msh22; do
    quadexport --format $format a.quad.h5 -o flat.msh
    quadexport --format $format --frame 3d a.quad.h5 -o space.msh
    # The frame by which tests/data/make_shapes.py wrote the shape: origin, x, y.
    python3 - flat.msh space.msh <<'PYTHON'
import sys
frame = (10, -20, 30), (1 / 3, 2 / 3, 2 / 3), (2 / 3, 1 / 3, -2 / 3)
def nodes(path):  # three numbers with a point in the lines of nodes; MSH 2.2 has the tag before them
    lines = open(path).read().split("$Nodes\n")[1].split("$EndNodes")[0].splitlines()[1:]
    words = [line.split()[-3:] for line in lines if len(line.split()) >= 3]
    return [tuple(map(float, w)) for w in words if sum("." in number for number in w)]
flat, space = nodes(sys.argv[1]), nodes(sys.argv[2])
assert len(space) > 200 and all(z == 0 for _, _, z in flat), len(space)
for (x, y, z) in space:
    rest = [c - o for c, o in zip((x, y, z), frame[0])]
    u, v = (sum(c * e for c, e in zip(rest, axis)) for axis in frame[1:])
    off = max(abs(c - u * a - v * b) for c, a, b in zip(rest, *frame[1:]))
    assert off < 1e-14 * 40, (x, y, z, off)
    assert -1e-12 < v and u * u + v * v < 1 + 1e-6, (u, v)
    assert min(abs(u - a) + abs(v - b) for a, b, _ in flat) < 1e-13, (u, v)
on_arc = sum(abs(x * x + y * y - 1) < 1e-6 for x, y, _ in flat)
assert on_arc > 20, on_arc
PYTHON
  done
}

@test "--translate moves the coordinates before --unit and --scale, and refuses what it cannot" {
  coordinates() { sed -n '/^\$Nodes/,/^\$EndNodes/p' "$1" | awk 'NF == 3'; }
  quadexport "$quad" -o a.msh
  quadexport "$quad" --translate 1,-2 --scale 10 -o b.msh
  paste <(coordinates a.msh) <(coordinates b.msh) >both
  assert [ "$(wc -l <both)" -ge 100 ]
  run awk '{ x = $4 - 10 * ($1 + 1); y = $5 - 10 * ($2 - 2); if (x * x + y * y > 1e-24) print }' both
  assert_output ''
  run -2 quadexport "$quad" --translate 1,2,3 -o c.msh
  assert_output --partial 'three numbers are for --frame 3d'
  run -2 quadexport "$quad" --translate 1,x -o c.msh
  assert_output --partial "'1,x' is not X,Y or X,Y,Z"
  quadexport "$quad" --frame 3d --translate 0,0,5 -o c.msh
  run awk '$3 != 5' <(coordinates c.msh)
  assert_output ''
}

@test "without the program of its format a file ends with 70 and the path; other formats need none" {
  mkdir bin libexec
  cp "$BIN/quadexport" bin
  quadrefine -q --order 2 "$blocks" -o a.quad.h5
  local format
  for format in cgns exodus; do
    run bin/quadexport --format $format a.quad.h5 -o a.out
    assert_failure 70
    assert_output "quadexport: $PWD/bin/../libexec/quadexport-${format/exodus/netcdf} cannot be run: No such file or directory"
  done
  bin/quadexport a.quad.h5 -o a.msh
  assert_nothing_left a.msh a.quad.h5 bin bin/quadexport libexec
}

@test "CGNS needs a folder for temporary files, which Exodus does not" {
  quadrefine -q --order 2 "$blocks" -o a.quad.h5
  run -4 env TMPDIR="$PWD/nowhere" quadexport a.quad.h5 -o a.cgns
  assert_output 'quadexport: no folder for temporary files: set TMPDIR to one: No such file or directory'
  TMPDIR="$PWD/nowhere" quadexport a.quad.h5 -o a.exo
  assert_nothing_left a.exo a.quad.h5
}

@test "netCDF's and HDF5's libraries are loaded by the programs of their formats alone" {
  assert_equal "$(ldd "$BIN/quadexport" | grep -cE 'libnetcdf|libhdf5|libcurl')" 0
  ldd "$BIN/../libexec/quadexport-netcdf" | grep libnetcdf
}
