# OpenFOAM builds its own mesh from our blockMeshDict, reads our polyMesh, checks both for every shape, and computes.
load common

setup() {
  common_setup
  need openfoam hdf5-tools
  export WM_PROJECT_DIR=/usr/share/openfoam # Debian's package leaves it to the user
  cells=$ROOT/tests/exports/read_blockmesh.py
}

# new_case: an OpenFOAM case without anything in it, for checkMesh says "OK" to the mesh of an earlier run.
new_case() {
  local section
  rm -rf case
  mkdir -p case/system
  dictionary controlDict "startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;" \
    "writeControl timeStep; writeInterval 1; writeFormat ascii; writePrecision 17;"
  dictionary fvSolution
  dictionary fvSchemes "$(for section in ddt grad div laplacian interpolation snGrad; do
    echo "${section}Schemes { default none; }"
  done)"
}

dictionary() {
  printf 'FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n' "$1" >"case/system/$1"
  printf '%s\n' "${@:2}" >>"case/system/$1"
}

# check_mesh: checkMesh finds nothing wrong. What it says of neighbours of unlike size ("small interpolation weight",
# "small volume ratio") and of long cells on a boundary ("small determinant": about the square of width over length of a
# cell with two inner faces) is true of the mesh, whatever the format.
check_mesh() {
  run checkMesh -case case -allGeometry -allTopology
  local wrong
  wrong=$(grep -F '***' <<<"$output" | grep -vE 'small (interpolation weight|volume ratio|determinant)' || true)
  assert_equal "$wrong" ''
  assert_output --partial 'Number of regions: 1'
}

# builds MESH: blockMesh takes the dictionary without a word, and checkMesh its mesh.
builds() {
  new_case
  quadexport -q "$1" -o case/system/blockMeshDict --report a.json
  run -0 blockMesh -case case
  refute_output --partial Warning
  check_mesh
  [[ $1 == *.hex.h5 ]] || run -0 "$PYTHON" "$cells" case/system/blockMeshDict "$1" case/constant/polyMesh/points
}

@test "blockMesh builds every shape as we say, and checkMesh accepts it" {
  local file blocks
  while read -r file; do
    echo "$file"
    blocks=$(blocks_of "$file")
    quadrefine -q "$blocks" -o a.quad.h5
    builds a.quad.h5
  done < <(shapes)
}

# poly_mesh FILE: writes its polyMesh, and checkMesh finds nothing wrong.
poly_mesh() {
  new_case
  mkdir -p case/constant/polyMesh
  quadexport -q "$1" -o case/constant/polyMesh/points
  check_mesh
}

@test "checkMesh accepts a polyMesh of quads, of sweeps and of periodic ends" {
  cp "$(blocks_of "$DATA/half_disc.step")" half_disc.blocks.h5
  quadrefine -q --order 2 half_disc.blocks.h5 -o a.quad.h5
  poly_mesh a.quad.h5
  assert_output --partial 'Mesh OK.'
  assert_output --partial '2 geometric (non-empty/wedge) directions (1 1 0)'
  hexsweep -q a.quad.h5 --height 2 --layers 4 --twist 40 -o a.hex.h5
  poly_mesh a.hex.h5
  assert_output --partial 'Mesh OK.'
  hexsweep -q a.quad.h5 --one-layer -o a.hex.h5
  poly_mesh a.hex.h5
  assert_output --partial 'Mesh OK.'
  run -0 grep -c 'type cyclic;' case/constant/polyMesh/boundary
  assert_output 2
}

# same_points A B DISTANCE: as many points, and each of A within the distance of one of B.
same_points() {
  run -0 "$PYTHON" - "$@" <<'END'
import re
import sys
import numpy
a, b = (numpy.array(re.findall(r"^\(([^()]+)\)$", open(path).read(), re.M)) for path in sys.argv[1:3])
a, b = (numpy.array([list(map(float, row.split())) for row in x]) for x in (a, b))
assert len(a) == len(b) > 0, (len(a), len(b))
far = max(numpy.linalg.norm(b - x, axis=1).min() for x in a)
assert far < float(sys.argv[3]), far
END
}

# same_figures FILE: what --check-for reports are checkMesh's figures, to six digits.
same_figures() {
  new_case
  mkdir -p case/constant/polyMesh
  run quadexport -q --check-for openfoam "$1" -o case/constant/polyMesh/points --report a.json
  quadexport -q "$1" -o case/constant/polyMesh/points
  run checkMesh -case case
  local pair wanted
  for pair in 'aspect_ratio:ax(imum)? aspect ratio(:| =) ' 'non_orthogonality:on-orthogonality Max: ' \
    'skewness:Max skewness = '; do
    wanted=$(grep -oP "${pair#*:}\\K[0-9.e+-]+" <<<"$output" | tail -1 | sed 's/[.,]$//')
    jq -e --argjson wanted "$wanted" ".check_for.${pair%%:*}.value | . / \$wanted - 1 | fabs < 1e-6" a.json >/dev/null ||
      fail "$1: ${pair%%:*} is $wanted, not $(jq ".check_for.${pair%%:*}.value" a.json)"
  done
}

@test "OpenFOAM refuses a symmetryPlane that is not flat, as --check-for does" {
  quadrefine -q "$(blocks_of "$DATA/half_disc.step")" -o a.quad.h5
  new_case
  mkdir -p case/constant/polyMesh
  run -1 quadexport a.quad.h5 --check-for openfoam --patch-type curve_1=symmetryPlane -o case/constant/polyMesh/points
  assert_output --partial 'plane deviation'
  quadexport -q a.quad.h5 --patch-type curve_1=symmetryPlane -o case/constant/polyMesh/points
  run checkMesh -case case
  assert_output --partial 'is not planar'
}

@test "--check-for openfoam measures what checkMesh does: quads, sweeps, cyclic patches, wall layers" {
  quadrefine -q --order 2 "$(blocks_of "$DATA/half_disc.step")" -o a.quad.h5
  same_figures a.quad.h5
  hexsweep -q a.quad.h5 --height 0.5 --layers 4 --twist 80 -o a.hex.h5
  same_figures a.hex.h5
  hexsweep -q a.quad.h5 --one-layer -o a.hex.h5
  same_figures a.hex.h5
  quadmesh -q "$DATA/regions/periodic_sector.step" --periodic from=to --order 3 --workdir . -o a.msh
  same_figures periodic_sector.quad.h5
  quadmesh -q "$DATA/naca0012.step" --wall curve_4:first=7e-5,growth=1.3,layers=15 --order 2 --workdir . -o a.msh
  same_figures naca0012.quad.h5
  assert_output --partial 'High aspect ratio cells found'
  run -1 quadexport naca0012.quad.h5 --check-for openfoam -o blockMeshDict
  assert_output --partial 'reaches the limit 1000 of OpenFOAM'
}

@test "blockMesh builds straight sweeps with their layers where polyMesh has them, and checkMesh accepts it" {
  local shape motion file
  for shape in half_disc plate_hole s_bend; do
    quadrefine -q --order 2 --geometry-tol 1 "$(blocks_of "$DATA/$shape.step")" -o a.quad.h5
    for motion in "--height 2 --layers 4" "--height 2 --layers 9 --bottom-layers first=0.02,growth=1.3,layers=5"; do
      # shellcheck disable=SC2086
      hexsweep -q a.quad.h5 $motion -o a.hex.h5
      builds a.hex.h5
      mkdir -p direct/polyMesh
      quadexport -q a.hex.h5 -o direct/polyMesh/points
      moved=$(jq -r '[.warnings[].message | select(test("blockMesh places")) | capture("up to (?<x>\\S+)").x][0] // "0"' a.json)
      same_points case/constant/polyMesh/points direct/polyMesh/points "$(awk -v x="$moved" 'BEGIN { print 1.1e-3 * x + 1e-12 }')"
    done
  done
  hexsweep -q a.quad.h5 --height 1 --twist 20 -o a.hex.h5
  run -1 quadexport a.hex.h5 -o blockMeshDict
  assert_output --partial 'holds straight sweeps of planar faces only, and this one bends, turns, narrows'
  quadexport -q --format polymesh a.hex.h5 -o points
}

@test "checkMesh accepts the polyMesh of every shape, of quads and of twisted layers" {
  local file blocks name height
  while read -r file; do
    echo "$file"
    blocks=$(blocks_of "$file")
    name=$(basename "$file" .step)
    height=$(jq '.face.diameter / 7' "${blocks%/*}/$name.sep.json")
    cp "${blocks%/*}/$name.quad.h5" a.quad.h5
    poly_mesh a.quad.h5
    hexsweep -q a.quad.h5 --height "$height" --twist 5 --layers 3 -o a.hex.h5
    poly_mesh a.hex.h5
    assert_output --regexp ' top +'"$(h5dump -d elem_block -H a.quad.h5 | grep -oP 'SIMPLE \{ \( \K[0-9]+')"
  done < <(shapes)
}

# field NAME CLASS DIMENSIONS INTERNAL PATCH=VALUE...: a field; VALUE is what stands in the patch, .* is the rest.
field() {
  local patch
  mkdir -p case/0
  {
    printf 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n' "$2" "$1"
    printf 'dimensions %s; internalField uniform %s;\nboundaryField\n{\n' "$3" "$4"
    for patch in "${@:5}"; do printf '    "%s" { %s }\n' "${patch%%=*}" "${patch#*=}"; done
    echo '}'
  } >"case/0/$1"
}

# cavity FILE LID [PATCH=VALUE]...: 50 steps of icoFoam with the patch LID in motion; nothing diverges.
cavity() {
  new_case
  mkdir -p case/constant/polyMesh
  quadexport -q --scale 1 "$1" -o case/constant/polyMesh/points # lengths of about 1
  sed -i 's/endTime 1; deltaT 1/endTime 0.5; deltaT 0.01/' case/system/controlDict
  dictionary fvSchemes 'ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }' \
    'divSchemes { default none; div(phi,U) Gauss upwind; } laplacianSchemes { default Gauss linear corrected; }' \
    'interpolationSchemes { default linear; } snGradSchemes { default corrected; }'
  dictionary fvSolution 'solvers { p { solver PCG; preconditioner DIC; tolerance 1e-8; relTol 0; }' \
    'pFinal { $p; } U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-8; relTol 0; } }' \
    'PISO { nCorrectors 2; nNonOrthogonalCorrectors 1; pRefCell 0; pRefValue 0; }'
  printf 'FoamFile { version 2.0; format ascii; class dictionary; object transportProperties; }\nnu %s;\n' \
    '[0 2 -1 0 0 0 0] 0.05' >case/constant/transportProperties
  field U volVectorField '[0 1 -1 0 0 0 0]' '(0 0 0)' '.*=type noSlip;' \
    "$2=type fixedValue; value uniform (1 0 0);" "${@:3}"
  field p volScalarField '[0 2 -2 0 0 0 0]' 0 '.*=type zeroGradient;' "${@:3}"
  run -0 icoFoam -case case
  refute_output --partial nan
  assert_equal "$(grep -c '^Time = ' <<<"$output")" 50
  assert_output --partial $'\nEnd'
  # The lid has the speed 1: nothing moves faster, and what flows into a cell leaves it.
  awk '/Courant/ && $NF > 1 { wrong = 1 } /continuity errors/ { last = $9; found = 1 }
    END { exit wrong || !found || last + 0 > 1e-6 }' <<<"$output" || fail "$output"
}

@test "icoFoam computes 50 steps in a cavity: one plate of quads, a periodic layer, and twisted layers" {
  quadrefine -q --order 2 --size 0.1 "$(blocks_of "$DATA/square.step")" -o a.quad.h5
  cavity a.quad.h5 curve_2 'frontAndBack=type empty;'
  hexsweep -q a.quad.h5 --one-layer -o a.hex.h5
  cavity a.hex.h5 curve_2 '(bottom|top)=type cyclic;'
  quadrefine -q --order 2 --size 0.2 "$(blocks_of "$DATA/half_disc.step")" -o a.quad.h5
  hexsweep -q a.quad.h5 --height 1 --layers 5 --twist 40 -o a.hex.h5
  cavity a.hex.h5 top
}

@test "thin layers along a curved wall have straight sides that do not cross them" {
  quadmesh -q "$DATA/naca0012.step" --wall curve_4:first=7e-5,growth=1.3,layers=15 --order 2 --workdir . \
    -o blockMeshDict
  builds naca0012.quad.h5
  run checkMesh -case case
  refute_output --partial 'severely non-orthogonal'
}

@test "patches have their faces, zones their cells" {
  quadrefine -q "$(blocks_of "$DATA/plate_hole.step")" -o a.quad.h5 --report a.json
  builds a.quad.h5
  run checkMesh -case case
  assert_output --partial "hexahedra:     $(jq .quads a.json)"
  assert_output --regexp 'frontAndBack +'$((2 * $(jq .quads a.json)))
}

@test "wall layers come out as they are" {
  quadrefine -q --wall curve_0,curve_1:first=1e-3,layers=8 "$(blocks_of "$DATA/cylinder_channel.step")" -o a.quad.h5
  new_case
  quadexport -q a.quad.h5 -o case/system/blockMeshDict
  run -0 blockMesh -case case
  run -0 "$PYTHON" "$cells" case/system/blockMeshDict a.quad.h5 case/constant/polyMesh/points
  run checkMesh -case case
  assert_output --partial 'Mesh OK.'
}

@test "cyclic patches match point by point" {
  local options shape
  for options in "box left=right bottom=top" "sector from=to" "wave inflow=outflow"; do
    read -ra words <<<"$options"
    shape=periodic_${words[0]}
    mapfile -t pairs < <(printf -- '--periodic\n%s\n' "${words[@]:1}")
    "$ROOT/pipelines/quadmesh" -q "$DATA/regions/$shape.step" "${pairs[@]}" --workdir . -o a.msh
    quadrefine -q --order 2 "$shape.blocks.h5" -o a.quad.h5
    builds a.quad.h5
    run -0 grep -c 'type  *cyclic;' case/constant/polyMesh/boundary
    assert_output $((2 * (${#words[@]} - 1)))
    run checkMesh -case case -allGeometry -allTopology
    assert_output --partial 'Mesh OK.'
    assert_output --regexp 'Coupled point location match \(average [0-9.e-]+\) OK'
  done
}

@test "the commands of the page work" {
  cp "$(blocks_of "$DATA/half_disc.step")" half_disc.blocks.h5
  new_case
  example 1 sh openfoam >commands
  run -0 bash -euo pipefail commands
  assert_output --partial 'Mesh OK.'
  bash -euo pipefail <(example 2 sh openfoam)
  run -0 grep -A 2 '^    curve_1$' case/system/blockMeshDict
  assert_output --partial 'type wall;'
  run -0 grep -c 'type wall;' case/system/blockMeshDict
  assert_output 1
}
