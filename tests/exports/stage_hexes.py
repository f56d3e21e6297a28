"""The hexahedra of x.hex.h5 by another program's eyes (formats/hex-mesh.md says what it holds)."""
import h5py

import hex_mesh

# The faces of x.hex.h5 by their corners: those of hex_mesh.
FACES = [hex_mesh.FACES.index(face) for face in ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (3, 2, 1, 0),
                                                 (4, 5, 6, 7))]


def corner_positions(nodes, order, corners):
    return frozenset(tuple(nodes[tuple(order * i for i in reversed(hex_mesh.CORNERS[c]))]) for c in corners)


def stage(path):
    """The stage file as the readers return theirs; faces of interfaces from one side."""
    with h5py.File(path) as file:
        order, num_quads = int(file["order"][()]), int(file["num_quads"][()])
        nodes = file["nodes"][()][file["elem_nodes"][()]].reshape((-1,) + (order + 1,) * 3 + (3,))
        regions = [name.decode() for name in file["region_names"][()]]
        of_quad = file["block_region"][()][file["quad_block"][()]]
        groups = file["face_groups"]
        faces, seen = [], set()
        for g, name in enumerate(groups["name"][()]):
            first, last = groups["elems_offsets"][()][g:g + 2]
            elems, sides = groups["elems"][()][first:last], groups["faces"][()][first:last]
            is_interface = bool(groups["is_interface"][()][g])
            for elem, side in zip(elems, sides):
                corners = hex_mesh.FACES[FACES[side]]
                at = corner_positions(nodes[elem], order, corners)
                if not (is_interface and at in seen):
                    faces.append((int(elem), FACES[side], name.decode()))
                seen.add(at)
    return hex_mesh.HexElements(order, nodes, [regions[of_quad[e % num_quads]] for e in range(len(nodes))], faces)
