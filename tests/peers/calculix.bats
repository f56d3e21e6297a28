# CalculiX solves on our meshes: a pipe under inner pressure, whose displacement Lamé gave in 1852.
load common

setup() {
  common_setup
  need calculix-ccx
}

# job [LINE...]: the file job.inp, for the mesh in pipe.inp, with further boundary conditions.
job() {
  cat >job.inp <<END
*INCLUDE, INPUT=pipe.inp
*MATERIAL, NAME=STEEL
*ELASTIC
210000, 0.3
*SOLID SECTION, ELSET=EALL, MATERIAL=STEEL
1
*BOUNDARY
bottom, 2, 2
left, 1, 1
$(printf '%s\n' "${@:-** of the plane}")
*STEP
*STATIC
*DSLOAD
inner, P, 100
*NODE PRINT, NSET=NALL
U
*END STEP
END
}

# error KIND: the greatest error of the radial displacement at a node, relative to the greatest displacement.
error() {
  run -0 ccx job
  refute_output --partial '*ERROR'
  "$PYTHON" - "$1" <<'END'
import re, sys
nodes, moved = {}, {}
inside = False
for line in open("pipe.inp"):
    if line.startswith("*"):
        inside = line.startswith("*NODE")
    elif inside:
        number, x, y, _ = line.split(",")
        nodes[int(number)] = float(x), float(y)
for line in open("job.dat"):
    words = line.split()
    if len(words) == 4 and words[0].isdigit():
        moved[int(words[0])] = tuple(map(float, words[1:3]))
# E, nu of plane strain as those of plane stress; inner and outer radius
a, b = (f(x * x + y * y for x, y in nodes.values()) ** 0.5 for f in (min, max))
E, nu, p = 210000.0, 0.3, 100.0
if sys.argv[1] != "CPS":
    E, nu = E / (1 - nu * nu), nu / (1 - nu)
worst = 0.0
for number, (x, y) in nodes.items():
    r = (x * x + y * y) ** 0.5
    u = p * a * a / (E * (b * b - a * a)) * ((1 - nu) * r + (1 + nu) * b * b / r)
    worst = max(worst, abs(moved[number][0] - u * x / r), abs(moved[number][1] - u * y / r))
print(worst / (p * a / (E * (b * b - a * a)) * ((1 - nu) * a * a + (1 + nu) * b * b)))
END
}

@test "plane stress and plane strain: displacements converge to Lamé's" {
  local kind format order errors size
  "$ROOT/pipelines/quadmesh" -q "$DATA/quarter_annulus.step" --name bottom=0 --name outer=1 --name left=2 \
    --name inner=3 --until blocksplit --workdir .
  job
  for kind in CPS:abaqus CPE:abaqus-cpe; do
    IFS=: read -r kind format <<<"$kind"
    for order in 1 2; do
      errors=()
      for size in 0.2 0.1; do
        quadrefine -q --order $order --size $size --geometry-tol 1 quarter_annulus.blocks.h5 -o a.quad.h5
        quadexport -q --format "$format" a.quad.h5 -o pipe.inp
        errors+=("$(error "$kind")")
      done
      # Twice as many elements along each side; CalculiX prints six digits.
      jq -en "${errors[0]} / ${errors[1]} > 0.8 * pow(2; $order + 1) and ${errors[1]} < 3e-3" >/dev/null ||
        fail "$kind, order $order: ${errors[*]}"
    done
  done
}

@test "hexahedra: displacements of a pipe between two walls converge to those of plane strain" {
  local order errors size
  "$ROOT/pipelines/quadmesh" -q "$DATA/quarter_annulus.step" --name bottom=0 --name outer=1 --name left=2 \
    --name inner=3 --until blocksplit --workdir .
  job 'low, 3, 3' 'high, 3, 3'
  for order in 1 2; do
    errors=()
    for size in 0.2 0.1; do
      quadrefine -q --order $order --size $size --geometry-tol 1 quarter_annulus.blocks.h5 -o a.quad.h5
      hexsweep -q a.quad.h5 --height 0.5 --layers 2 --bottom-name low --top-name high -o a.hex.h5
      quadexport -q --format abaqus a.hex.h5 -o pipe.inp
      errors+=("$(error C3D)")
    done
    jq -en "${errors[0]} / ${errors[1]} > 0.8 * pow(2; $order + 1) and ${errors[1]} < 3e-3" >/dev/null ||
      fail "order $order: ${errors[*]}"
  done
}

# Quads of order 4 are split into elements of order 2.
@test "CalculiX finds the stress of a uniform pressure in every shape: quads of orders 1, 2, 4, hexahedra of 1, 2" {
  need python3-h5py
  local name order path cases=()
  # exported KIND FORMAT: one more case; axisymmetric elements have no negative x.
  exported() {
    local file=$name.$order.$1.$2.inp
    ! quadexport -q --format "$2" "$path.$1.h5" -o "$file" 2>refused || cases+=("$path.$1.h5" "$file")
    [[ ! -s refused ]] || assert_file_contains refused 'x is the radius'
  }
  while read -r name order path; do
    exported quad abaqus
    [[ $order == 4 ]] || exported hex abaqus
    [[ $order != 2 ]] || { exported quad abaqus-cpe && exported quad abaqus-cax; }
  done < <(coarse 1 2 4)
  run "$PYTHON" "$ROOT/tests/peers/judge_calculix.py" "${cases[@]}"
  assert_success
}
