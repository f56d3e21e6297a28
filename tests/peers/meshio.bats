# meshio, the converter between formats, counts and names as we do.
load common

setup() {
  common_setup
  need python3-meshio python3-h5py python3-netcdf4
}

# Not VTU, whose arrays of words meshio 5.0 refuses, nor CGNS, of which it reads files of its own alone.
@test "meshio reads every shape, quads and hexahedra, with names: MSH of every order, SU2, Exodus and Abaqus" {
  local name order path cases=()
  # exported KIND ENDING FORMAT ORDER: one more case, where the order is not above the last.
  exported() {
    local file=$name.$order.$1.$3.$2
    ((order <= $4)) || return 0
    quadexport -q --format "$3" "$path.$1.h5" -o "$file"
    cases+=("$path.$1.h5" "$file")
  }
  while read -r name order path; do
    exported quad msh msh 10
    exported quad msh msh22 10
    exported quad su2 su2 3
    exported quad exo exodus 3
    exported quad inp abaqus 1 # meshio has no CPS8
    exported hex msh msh 9
    exported hex msh msh22 9
    exported hex su2 su2 3
    exported hex exo exodus 2
    exported hex inp abaqus 2
  done < <(coarse 1 2 3 4 5 6 7 8 9 10)
  run "$PYTHON" "$ROOT/tests/peers/judge_meshio.py" "${cases[@]}"
  assert_success
}

@test "the commands of the page work" {
  quadrefine "$(blocks_of "$DATA/half_disc.step")" | quadexport -o x.msh
  example 2 python msh >commands.py
  run -0 "$PYTHON" commands.py
  assert_output --partial "'curve_0'"
}
