# p4est's own reader of .inp files, which is the first half of Trixi.jl's P4estMesh: every shape has our trees and vertices.
load common

setup() {
  common_setup
  need libp4est-dev mpi-default-dev hdf5-tools
  reader=$BATS_FILE_TMPDIR/read_inp
  [[ -x $reader ]] || program | mpicc -x c - -o "$reader" -lp4est -lsc
}

program() {
  cat <<'END'
#include <p4est_connectivity.h>
#include <stdio.h>

int main(int argc, char **argv) {
  sc_init(sc_MPI_COMM_NULL, 0, 0, NULL, SC_LP_ERROR);
  p4est_init(NULL, SC_LP_ERROR);
  p4est_connectivity_t *c = argc == 2 ? p4est_connectivity_read_inp(argv[1]) : NULL;
  if (c == NULL || !p4est_connectivity_is_valid(c)) return 1;
  int outside = 0; /* sides that are their own neighbours */
  for (p4est_topidx_t t = 0; t < c->num_trees; ++t)
    for (int s = 0; s < 4; ++s) outside += c->tree_to_tree[4 * t + s] == t && c->tree_to_face[4 * t + s] == s;
  printf("trees %d vertices %d outside %d\n", (int)c->num_trees, (int)c->num_vertices, outside);
  p4est_connectivity_destroy(c);
  return 0;
}
END
}

@test "p4est reads every shape: trees, vertices and sides on the boundary" {
  local file blocks
  while read -r file; do
    echo "$file"
    blocks=$(blocks_of "$file")
    quadrefine -q "$blocks" -o a.quad.h5
    quadexport -q a.quad.h5 -o a.inp
    run -0 "$reader" a.inp
    assert_output "$("$PYTHON" - "$ROOT/tests/exports" a.quad.h5 <<'END'
import sys
sys.path.insert(0, sys.argv[1])
import stage_mesh
mesh = stage_mesh.read(sys.argv[2])
print(f"trees {len(mesh.elements)} vertices {mesh.num_vertices} outside {len(mesh.boundaries)}")
END
)"
  done < <(shapes)
}
