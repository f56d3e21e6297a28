#pragma once
// The members of each struct of StageModel, named once for both directions (archive.hpp): FORMAT_io.cpp defines the
// function of its struct. Private to io.

#include <functional>
#include <string>
#include <vector>

#include "io/archive.hpp"
#include "io/whole_file.hpp"
#include "model/provenance.hpp"
#include "model/stage_formats.hpp"

namespace quadrille::io {

void describe(Archive& archive, ChartedFace& charted);
void describe(Archive& archive, TriMesh& mesh);
void describe(Archive& archive, Field& field);
void describe(Archive& archive, CriticalPoints& points);
void describe(Archive& archive, SeparatrixGraph& graph);
void describe(Archive& archive, BlockLayout& layout);
void describe(Archive& archive, QuadMesh& mesh);
void describe(Archive& archive, HexMesh& mesh);

// Parts of several formats.
/// The face as the JSON object or HDF5 group `face` (formats/cad-face.md).
void describe_face(Archive& archive, CadFace& face);
/// The chart of a curved face as its member `chart`, which planar faces lack (formats/chart.md).
void describe_chart(Archive& archive, CadFace& face);
void describe_nurbs(Archive& archive, const char* name, std::vector<Nurbs>& curves);
/// The triangles, in a file of their own or inside a field file.
void describe_triangles(Archive& archive, TriMesh& mesh);
/// The members `nodes` and `arcs` of a separatrix graph or a block layout.
void describe_graph(Archive& archive, std::vector<GraphNode>& nodes, std::vector<GraphArc>& arcs);
/// The member `open_curves`, where there are any.
void describe_open_curves(Archive& archive, std::vector<int>& curves);
/// Names and regions of the blocks of a layout or a mesh.
void describe_blocks(Archive& archive, std::vector<std::string>& names, std::vector<int>& unnamed,
                     std::vector<int>& region);

// The header of every stage file: format, version [major, minor], producer, provenance.
/// The last step of the provenance chain, "cad2tri 0.1.0".
std::string producer_of(const Provenance& provenance);

/// Throws FormatError unless the file is of this format and of its major version; the messages for older and for newer
/// versions differ.
void require_version(const std::string& file_name, const StageFormat& expected, const std::string& format,
                     const std::vector<int>& version);

/// The same of what users write, by the keys of the root: a file without the format's name is called no `what`.
void require_format(Archive& root, const StageFormat& expected, const std::string& file_name, const char* what);

void describe_provenance(Archive& archive, Provenance& provenance);

/// The provenance chain as one line of JSON, and its inverse.
std::string provenance_text(Provenance provenance);
Provenance parse_provenance(const std::string& text, const std::string& file_name);

/// The bytes of a file, header included, from the description of its members; reads one. `provenance` is read before
/// `describe` runs.
using Describe = std::function<void(Archive&)>;
std::string described_bytes(const StageFormat& format, const Provenance& provenance, const Describe& describe);
void read_described(const InputFile& file, const StageFormat& format, Provenance& provenance, const Describe& describe);

}  // namespace quadrille::io
