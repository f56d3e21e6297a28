# The tutorial's commands with the solvers that they need, which tests/cases/tutorial.bats leaves out where they are not
# installed.
load common

setup() { common_setup; }

# solves PACKAGES WORDS: the tests whose names match pass and are not skipped.
solves() {
  # shellcheck disable=SC2086
  need $1
  run -0 bats --tap -f "$2" "$ROOT/tests/cases/tutorial.bats"
  assert_output --regexp '^1\.\.[1-9]'
  refute_output --partial '# skip'
}

@test "both flows, with OpenFOAM" { solves openfoam 'flow around|aerofoil'; }
@test "heat loss, a pin, a crack, with dolfinx" { solves 'python3-dolfinx python3-gmsh' 'heat loss|a pin|a crack'; }
