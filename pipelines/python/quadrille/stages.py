"""The chain in Python: `mesh`, and one call for each stage. Options are those of the tools, as keywords
(tool_words.py); all raise ToolError and issue ToolWarning.

    mesh = quadrille.mesh("x.step", size=0.1, walls={"hole": {"first": 1e-3, "layers": "fit"}}, order=3)
    mesh.write("x.msh")

Inputs are paths, bytes, or what other calls and `read` return. Nothing is written to files but by `save`, `write` and
options that name a file to write (html="x.html").
"""
from . import tool_words, tools
from .reading import read
from .stage_file import StageFileError
from .tool_errors import tool_path

# Of quadmesh: where files go and which stages run is decided here.
NOT_OF_MESH = ("--from", "--until", "--workdir", "--report", "--dry-run", "--verbose", "--quiet")


def mesh(shape, **options):
    """The mesh of a CAD face, or of points, by all stages: a QuadMesh, or a HexMesh with sweep=True.

    `shape`: a path (STEP, IGES, BREP, points), or the bytes of such a file; `options`: those of quadmesh. Those of
    quadexport, as unit="m", are kept for `write`.
    """
    last = "hexsweep" if options.get("sweep") else "quadrefine"
    outcome = tools.run("quadmesh", [shape], options, ["--until", last], without=NOT_OF_MESH)
    made = made_of(outcome)
    made.line = outcome.messages.rstrip().rpartition("\n")[2]
    exported = tool_words.listed_options(tool_path("quadexport"))
    kept = {"--" + key.replace("_", "-"): key for key in options}
    made.export_options = {key: options[key] for name, key in kept.items() if name in exported}
    return made


def made_of(outcome):
    """What a stage wrote; text where an option asks for text (cad2tri(..., list=True))."""
    try:
        made = read(outcome.data)
    except StageFileError:
        return outcome.data.decode()
    made.report, made.messages = outcome.report, outcome.messages
    return made


def stage(tool, *inputs, **options):
    """What the tool makes of these inputs."""
    return made_of(tools.run(tool, inputs, options, level=3))


def cad2chart(shape, **options):
    """The Chart of a curved face of a CAD file."""
    return stage("cad2chart", shape, **options)


def cad2tri(shape, **options):
    """The TriMesh of a face of a CAD file, or of a Chart; with list=True a text that lists the faces."""
    return stage("cad2tri", shape, **options)


def fieldsolve(triangles, **options):
    """The Field on a TriMesh; with nodes=CriticalPoints that with exactly these nodes."""
    return stage("fieldsolve", triangles, **options)


def padapt(field, **options):
    """The Field with orders at which it is accurate."""
    return stage("padapt", field, **options)


def critpoints(field, **options):
    """The CriticalPoints of a Field: irregular nodes and corner valences."""
    return stage("critpoints", field, **options)


def separatrix(field, nodes=None, **options):
    """The SeparatrixGraph of a Field and its CriticalPoints; of a TriMesh alone with layout="midpoint"."""
    return stage("separatrix", field, *([] if nodes is None else [nodes]), **options)


def blocksplit(graph, **options):
    """The BlockLayout of a SeparatrixGraph."""
    return stage("blocksplit", graph, **options)


def quadrefine(blocks, **options):
    """The QuadMesh of a BlockLayout."""
    return stage("quadrefine", blocks, **options)


def hexsweep(quads, **options):
    """The HexMesh that a QuadMesh sweeps."""
    return stage("hexsweep", quads, **options)


def export(mesh_or_blocks, path, **options):
    """Writes a mesh, or a BlockLayout as x.step, for other programs, as its `write` does. Returns the report."""
    return tools.run("quadexport", [mesh_or_blocks], options, output=path).report
