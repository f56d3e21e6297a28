"""What all objects of stage files share: their bytes, how they were made, how they are shown, saved and exported."""
import pathlib

from . import tools


class StageResult:
    """`data`: the bytes of the stage file; `producer` and `provenance`: how it was made; of what a stage made here:
    `report`, a dict (formats/report.md), and `messages`, what the tool wrote beside warnings, in lines."""
    data = b""
    producer = provenance = report = None
    messages = line = ""
    export_options = {}

    def summary(self):
        """A line about the content."""
        return type(self).__name__

    def __repr__(self):
        return f"<{type(self).__name__}: {self.line or self.summary()}>"

    def save(self, path):
        """Writes the stage file, which the tools and `read` read."""
        pathlib.Path(path).write_bytes(self.data)

    def draw(self, **options):
        """A picture as the text of an SVG file; `options`: those of stageview (width=600, curve_labels=True)."""
        return tools.run("stageview", [self], options).data.decode()

    def _repr_svg_(self):
        return self.draw(width=600)


class Exportable(StageResult):
    """Blocks and meshes, which quadexport writes for other programs."""

    def write(self, path, **options):
        """Writes a file in the format of the path's ending or of `format`; `options`: those of quadexport (unit="m").
        Options of quadexport that were given to `mesh` hold here too. Returns the report."""
        return tools.run("quadexport", [self], {**self.export_options, **options}, output=path).report

    def bytes_of(self, format, **options):
        """The bytes of such a file, of a format that is one file: `mesh.bytes_of("msh")`."""
        return tools.run("quadexport", [self], {**self.export_options, **options, "format": format}).data


class Mesh(Exportable):
    """A mesh of quads or hexahedra."""

    @property
    def points(self):
        """Nodes, as an array: [n, 2], or [n, 3] of hexahedra and of curved faces."""
        in_space = getattr(self, "space_nodes", None)
        return self.nodes if in_space is None else in_space

    @property
    def cells(self):
        """Nodes of each element, as an array, xi1 fastest, at the Gauss-Lobatto-Legendre points."""
        return self.elem_nodes

    def to_meshio(self, **options):
        """A meshio.Mesh, with names as meshio reads them from Gmsh's files; `options`: those of quadexport."""
        from . import other_meshes
        return other_meshes.to_meshio(self, options)

    def to_dolfinx(self, comm=None, **options):
        """A tuple with `mesh`, `cell_tags`, `facet_tags` of dolfinx, and `names`, a dict: (dimension, name) to tag.
        `comm`: an MPI communicator (default: all processes); `options`: those of quadexport."""
        from . import other_meshes
        return other_meshes.to_dolfinx(self, comm, options)
