# p4est's own readers of .inp files, which are the first half of Trixi.jl's P4estMesh: every shape has our trees and
# vertices, of quads and of hexahedra.
load common

setup() {
  common_setup
  need libp4est-dev mpi-default-dev python3-numpy python3-h5py
}

# reader DIMENSION: compiles a program that prints what p4est has of each file.
reader() {
  sed "s/OWN/p$((4 * $1 - 4))est/g; s/SIDES/$((2 * $1))/g" <<'END' | mpicc -x c - -o "read_$1" -lp4est -lsc
#include <OWN_connectivity.h>
#include <p4est.h>
#include <stdio.h>

int main(int argc, char **argv) {
  sc_init(sc_MPI_COMM_NULL, 0, 0, NULL, SC_LP_ERROR);
  p4est_init(NULL, SC_LP_ERROR);
  for (int k = 1; k < argc; ++k) {
    OWN_connectivity_t *c = OWN_connectivity_read_inp(argv[k]);
    if (c == NULL || !OWN_connectivity_is_valid(c)) return 1;
    int outside = 0; /* sides that are their own neighbours */
    for (p4est_topidx_t t = 0; t < c->num_trees; ++t)
      for (int s = 0; s < SIDES; ++s)
        outside += c->tree_to_tree[SIDES * t + s] == t && c->tree_to_face[SIDES * t + s] == s;
    printf("%s trees %d vertices %d outside %d\n", argv[k], (int)c->num_trees, (int)c->num_vertices, outside);
    OWN_connectivity_destroy(c);
  }
  return 0;
}
END
}

@test "p4est reads every shape, quads and hexahedra: trees, vertices and sides on the boundary" {
  local name order path
  reader 2
  reader 3
  while read -r name order path; do
    quadexport -q "$path.quad.h5" -o "$name.quad.inp"
    quadexport -q "$path.hex.h5" -o "$name.hex.inp"
    echo "$path $name" >>meshes
  done < <(coarse 4)
  "$PYTHON" -c '
import sys
sys.path.insert(0, sys.argv[1])
import numpy
from stage_measures import measures
for line in open("meshes"):
    path, name = line.split()
    for kind in ("quad", "hex"):
        wanted = measures(f"{path}.{kind}.h5")
        points = wanted.corners.reshape(-1, wanted.corners.shape[2])
        vertices, outside = len(numpy.unique(points, axis=0)), sum(map(len, wanted.middles.values()))
        print(f"{name}.{kind}.inp trees {len(wanted.dets)} vertices {vertices} outside {outside}")
' "$ROOT/tests/peers" | sort >wanted
  { ./read_2 ./*.quad.inp && ./read_3 ./*.hex.inp; } | sed 's|^\./||' | sort >found
  diff found wanted
  assert_equal "$(wc -l <found)" "$((2 * $(shapes | wc -l)))"
}
