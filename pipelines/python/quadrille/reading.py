"""Stage files as objects."""
from .blocks import BlockLayout
from .chart import Chart
from .field import Field
from .graph import SeparatrixGraph
from .hexes import HexMesh
from .nodes import CriticalPoints
from .quads import QuadMesh
from .stage_file import StageFileError, bytes_of, parse
from .tri_mesh import TriMesh

TYPES = {"chart": Chart, "tri-mesh": TriMesh, "field": Field, "critical-points": CriticalPoints,
         "separatrix-graph": SeparatrixGraph, "block-layout": BlockLayout, "quad-mesh": QuadMesh, "hex-mesh": HexMesh}


def read(source):
    """The object that a stage file holds. `source`: a path, or the bytes of the file. The object's members `producer`
    and `provenance` say how the file was made. Raises StageFileError for what is no stage file."""
    data, name = bytes_of(source)
    content = parse(data, name)
    if content["format"] not in TYPES:
        raise StageFileError(f"{content['format']} files have no class here: load gives their content as a dict")
    made = TYPES[content["format"]](content)
    made.data, made.producer, made.provenance = data, content.get("producer"), content.get("provenance")
    return made
