"""Reads the stage files of Quadrille: nodes, separatrices, blocks, quads, and the field at any point.

    import quadrille
    field = quadrille.read("x.field.h5")        # a Field
    field.cross_angle([[0.2, 0.3]])             # radians
    quadrille.read("x.crit.json").nodes         # irregular nodes: position, valence

`read` returns a Chart, TriMesh, Field, CriticalPoints, SeparatrixGraph, BlockLayout, QuadMesh or HexMesh, as the file
says.
Positions are those of the CAD file's plane, as quadexport writes them (`face.origin` is added). Numbers count from 0.
Files are not checked against the rules of their format: stagecheck does that.
"""
from .blocks import Block, BlockLayout
from .chart import Chart
from .face import Face, Joint, Spline
from .field import Field
from .graph import Arc, GraphNode, Line, SeparatrixGraph
from .hexes import HexMesh
from .nodes import BoundaryNode, Corner, CriticalPoints, Node
from .quads import QuadMesh
from .stage_file import StageFileError, load
from .tri_mesh import TriMesh

__all__ = ["Arc", "Block", "BlockLayout", "BoundaryNode", "Chart", "Corner", "CriticalPoints", "Face", "Field",
           "GraphNode", "HexMesh", "Joint", "Line", "Node", "QuadMesh", "SeparatrixGraph", "Spline", "StageFileError",
           "TriMesh", "load", "read"]

TYPES = {"chart": Chart, "tri-mesh": TriMesh, "field": Field, "critical-points": CriticalPoints,
         "separatrix-graph": SeparatrixGraph, "block-layout": BlockLayout, "quad-mesh": QuadMesh, "hex-mesh": HexMesh}


def read(source):
    """The object that a stage file holds. `source`: a path, or the bytes of the file. The object's members `producer`
    and `provenance` say how the file was made. Raises StageFileError for what is no stage file."""
    content = load(source)
    if content["format"] not in TYPES:
        raise StageFileError(f"{content['format']} files have no class here: load gives their content as a dict")
    made = TYPES[content["format"]](content)
    made.producer, made.provenance = content.get("producer"), content.get("provenance")
    return made
