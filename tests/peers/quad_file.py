"""x.quad.h5 by h5py and numpy alone: element nodes, det J, areas and lengths; shares no code with the tools."""
import numpy


def gll(order):
    """The Gauss-Lobatto-Legendre points: the ends and the roots of the derivative of Legendre's polynomial."""
    inner = numpy.polynomial.legendre.Legendre.basis(order).deriv().roots()
    return numpy.concatenate([[-1.0], numpy.sort(inner.real), [1.0]])


def lagrange(points, at):
    """Values and derivatives of the Lagrange polynomials: [len(at), len(points)] each, through Legendre's basis."""
    legendre = numpy.polynomial.legendre
    coefs = numpy.linalg.inv(legendre.legvander(points, len(points) - 1))
    derivative = legendre.legder(coefs)
    return legendre.legvander(at, len(points) - 1) @ coefs, legendre.legvander(at, len(points) - 2) @ derivative


class QuadFile:
    def __init__(self, path):
        import h5py  # here, so that the functions above need numpy alone
        with h5py.File(path, "r") as file:
            self.order = int(file["order"][()])
            width = self.order + 1
            self.nodes = file["nodes"][:] + file["face/origin"][:]
            self.elems = file["elem_nodes"][:].reshape(-1, width, width)  # [element, j, i]
            self.block = file["elem_block"][:]
            text = lambda values: [v.decode() if isinstance(v, bytes) else v for v in values]
            self.block_names = text(file["block_names"][:])
            self.unnamed_blocks = set(file["unnamed_blocks"][:])
            names = text(file["face/curve_names"][:])
            self.curve_names = [name or f"curve_{k}" for k, name in enumerate(names)]
            self.sides = list(zip(*(file["boundary_edges/" + key][:] for key in ("elem", "side", "curve"))))

    def jacobian_dets(self, at):
        """det J at the tensor points `at` x `at`: [element, j, i]."""
        value, slope = lagrange(gll(self.order), at)
        x = self.nodes[self.elems]
        by_1 = numpy.einsum("ja,ib,eabk->ejik", value, slope, x)
        by_2 = numpy.einsum("ja,ib,eabk->ejik", slope, value, x)
        return by_1[..., 0] * by_2[..., 1] - by_1[..., 1] * by_2[..., 0]

    def jacobian_ratios(self, count=41):
        """Least det J over greatest, of each element, from samples."""
        at = -numpy.cos(numpy.linspace(0, numpy.pi, count))
        chunks = [self.jacobian_dets_of(part, at) for part in numpy.array_split(numpy.arange(len(self.elems)),
                                                                                 1 + len(self.elems) // 500)]
        dets = numpy.concatenate(chunks)
        return dets.min(axis=(1, 2)) / dets.max(axis=(1, 2))

    def jacobian_dets_of(self, elems, at):
        part = object.__new__(QuadFile)
        part.order, part.nodes, part.elems = self.order, self.nodes, self.elems[elems]
        return part.jacobian_dets(at)

    def area(self):
        at, weights = numpy.polynomial.legendre.leggauss(2 * self.order)
        return float(numpy.einsum("eji,j,i->", self.jacobian_dets(at), weights, weights))

    def group_lengths(self):
        """Length of the mesh's boundary by name."""
        at, weights = numpy.polynomial.legendre.leggauss(24)
        _, slope = lagrange(gll(self.order), at)
        lengths = {}
        for elem, side, curve in self.sides:
            e = self.elems[elem]
            nodes = (e[0, :], e[:, -1], e[-1, :], e[:, 0])[side]
            speed = numpy.linalg.norm(slope @ self.nodes[nodes], axis=1)
            name = self.curve_names[curve]
            lengths[name] = lengths.get(name, 0) + float(speed @ weights)
        return lengths

    def groups(self):
        """Number of edges by boundary name, of quads by the name of their region."""
        boundaries, regions = {}, {}
        for _, _, curve in self.sides:
            name = self.curve_names[curve]
            boundaries[name] = boundaries.get(name, 0) + 1
        for block in self.block:
            name = "domain" if block in self.unnamed_blocks else self.block_names[block]
            regions[name] = regions.get(name, 0) + 1
        return boundaries, regions
