"""Meshes CAD faces by the tools of Quadrille, and reads their stage files: nodes, separatrices, blocks, quads, and the
field at any point.

    import quadrille
    mesh = quadrille.mesh("x.step", size=0.1, order=3)      # a QuadMesh; help(quadrille.mesh)
    mesh.write("x.msh", unit="m")
    field = quadrille.read("x.field.h5")        # a Field
    field.cross_angle([[0.2, 0.3]])             # radians
    quadrille.read("x.crit.json").nodes         # irregular nodes: position, valence

`cad2tri`, `fieldsolve`, ... `hexsweep`, `export` run one stage each. They and `read` return a Chart, TriMesh, Field, CriticalPoints, SeparatrixGraph, BlockLayout, QuadMesh or HexMesh.
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
from .reading import read
from .stage_file import StageFileError, load
from .stages import (blocksplit, cad2chart, cad2tri, critpoints, export, fieldsolve, hexsweep, mesh, padapt, quadrefine,
                     separatrix)
from .tool_errors import ToolError, ToolWarning
from .tri_mesh import TriMesh

__all__ = ["Arc", "Block", "BlockLayout", "BoundaryNode", "Chart", "Corner", "CriticalPoints", "Face", "Field",
           "GraphNode", "HexMesh", "Joint", "Line", "Node", "QuadMesh", "SeparatrixGraph", "Spline", "StageFileError",
           "ToolError", "ToolWarning", "TriMesh", "blocksplit", "cad2chart", "cad2tri", "critpoints", "export",
           "fieldsolve", "hexsweep", "load", "mesh", "padapt", "quadrefine", "read", "separatrix"]
