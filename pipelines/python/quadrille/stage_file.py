"""Stage files as nested dicts: HDF5 by h5py, JSON by the standard library (formats/README.md).

A dict has the names of the format's page as keys. Values are numbers, strings, lists and dicts as in JSON, and NumPy
arrays for the datasets of HDF5. `records` makes lists of dicts of what either storage holds.
"""
import io
import json
import os

import numpy as np

# The major version that is read, of each format of `stagecheck --list-formats`.
MAJOR_VERSIONS = {"chart": 1, "tri-mesh": 1, "field": 2, "critical-points": 2, "separatrix-graph": 2,
                  "block-layout": 2, "quad-mesh": 2, "hex-mesh": 1}
HDF5_SIGNATURE = b"\x89HDF\r\n\x1a\n"


class StageFileError(ValueError):
    """A file that is no stage file, or one of a version that this module does not read."""


def load(source):
    """The content of a stage file. `source`: a path, or the bytes of the file."""
    return parse(*bytes_of(source))


def bytes_of(source):
    """The bytes of the file, and its name for messages."""
    if isinstance(source, (bytes, bytearray, memoryview)):
        return bytes(source), "the bytes"
    with open(source, "rb") as file:
        return file.read(), os.fspath(source)


def parse(data, name):
    """The content of a stage file of these bytes."""
    content = _load_hdf5(data, name) if data.startswith(HDF5_SIGNATURE) else _load_json(data, name)
    _check_version(content, name)
    return content


def _load_json(data, name):
    try:
        content = json.loads(data)
    except ValueError as error:
        raise StageFileError(f"{name}: neither HDF5 nor JSON: {error}") from None
    except RecursionError:
        raise StageFileError(f"{name}: nested too deeply") from None
    if not isinstance(content, dict):
        raise StageFileError(f"{name}: expected a JSON object")
    return content


def _load_hdf5(data, name):
    import h5py  # only here: JSON files are read without it
    try:
        with h5py.File(io.BytesIO(data), "r") as file:
            content = _group(file)
            for key in ("format", "producer", "version", "provenance"):
                if key in file.attrs:
                    content[key] = _plain(file.attrs[key])
    except OSError as error:
        raise StageFileError(f"{name}: cannot be read as HDF5: {error}") from None
    if isinstance(content.get("provenance"), str):
        content["provenance"] = _load_json(content["provenance"], f"{name}: attribute 'provenance'").get("provenance", [])
    return content


def _group(group):
    import h5py
    content = {}
    for key, member in group.items():
        content[key] = _group(member) if isinstance(member, h5py.Group) else _plain(member[()])
    return content


def _plain(value):
    """Strings of bytes, arrays of strings to lists, and scalars to Python's numbers."""
    if isinstance(value, bytes):
        return value.decode()
    if isinstance(value, np.ndarray) and value.dtype.kind in "SO":
        return [_plain(entry) for entry in value.tolist()]
    if isinstance(value, np.generic):
        return _plain(value.item())
    return value


def _check_version(content, name):
    stage_format = content.get("format")
    if stage_format not in MAJOR_VERSIONS:
        raise StageFileError(f"{name}: no stage file: its format is {stage_format!r}")
    major, present = int(content["version"][0]), MAJOR_VERSIONS[stage_format]
    if major != present:
        raise StageFileError(f"{name}: {stage_format} {major}.{int(content['version'][1])}: this module reads version "
                             f"{present}")


def split(values, offsets):
    """The rows of a ragged member, one array for each record."""
    return [values[begin:end] for begin, end in zip(offsets[:-1], offsets[1:])]


def records(value):
    """A list of records as a list of dicts: from JSON as it is, from HDF5 gathered from one array for each member."""
    if not isinstance(value, dict):
        return list(value)
    columns = {}
    for key, member in value.items():
        if key.endswith("_offsets"):
            continue
        if key + "_offsets" not in value:
            columns[key] = member
        elif isinstance(member, dict):
            columns[key] = split(records(member), value[key + "_offsets"])
        else:
            columns[key] = split(member, value[key + "_offsets"])
    return [dict(zip(columns, row)) for row in zip(*columns.values())]
