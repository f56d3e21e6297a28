# PETSc's DMPlex reads our MSH files: the label of each name has the sides of that name, and no other.
load common

setup() {
  common_setup
  need python3-petsc4py python3-numpy python3-h5py
}

# judge CURVED NAME_PATTERN ORDER...: shapes whose name fits, in both versions.
judge() {
  local name order path kind format cases=()
  while read -r name order path; do
    for kind in quad hex; do
      [[ $kind$order != hex10 ]] || continue
      for format in msh msh22; do
        quadexport -q --format "$format" "$path.$kind.h5" -o "$name.$order.$kind.$format.msh"
        cases+=("$path.$kind.h5" "$name.$order.$kind.$format.msh")
      done
    done
  done < <(coarse "${@:3}" | grep "^$2 ")
  run "$PYTHON" "$ROOT/tests/peers/judge_petsc.py" "$1" "${cases[@]}"
  assert_success # and shows what was said where it is not
}

# Version 2.2 lists the number of the entity beside that of the group, and PETSc looks for both in one list.
@test "PETSc labels the sides and cells of every name, and no others, in every shape of orders 1 to 4" {
  judge 0 '.*' 1 2 3 4
}

@test "PETSc reads every order, of orders 1 and 2 with curved cells" {
  judge 0 labels 5 6 7 8 9 10
  judge 1 labels 1 2
}
