#pragma once
// Component `files`: reads, checks and writes the stage files (formats/README.md).
//
// Positions in the structs are relative to face.origin, lengths in the unit of the CAD file, indices count from 0.
// Errors are thrown (base/error.hpp): FormatError for a file that is not what it should be, OutputError for one that
// cannot be written. "-" is standard input or output.
//
// What the functions of the components make has the provenance of the tools' files, so that the tools take these files
// like their own.

#include <string>
#include <vector>

#include "model/block_layout.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "model/quad_mesh.hpp"
#include "model/separatrix_graph.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::api {

/// The format that the file states: "tri-mesh", "field", "critical-points", "separatrix-graph", "block-layout" or
/// "quad-mesh". Throws FormatError for anything else.
std::string format_of(const std::string& path);

/// Each reads one file and checks the rules without which it could not be used, as the tools do.
TriMesh read_tri_mesh(const std::string& path);
Field read_field(const std::string& path);
CriticalPoints read_critical_points(const std::string& path);
SeparatrixGraph read_separatrix_graph(const std::string& path);
BlockLayout read_block_layout(const std::string& path);
QuadMesh read_quad_mesh(const std::string& path);

/// Each writes one file, completely or not at all.
void write(const std::string& path, const TriMesh& mesh);
void write(const std::string& path, const Field& field);
void write(const std::string& path, const CriticalPoints& points);
void write(const std::string& path, const SeparatrixGraph& graph);
void write(const std::string& path, const BlockLayout& layout);
void write(const std::string& path, const QuadMesh& mesh);

/// A numbered rule of a format that does not hold: its number ("TRI-R01"), what is wrong and where.
struct BrokenRule {
  std::string number, text;
};

/// All rules of the format, as stagecheck checks them; empty if they hold.
std::vector<BrokenRule> broken_rules(const TriMesh& mesh);
std::vector<BrokenRule> broken_rules(const Field& field);
std::vector<BrokenRule> broken_rules(const CriticalPoints& points);
std::vector<BrokenRule> broken_rules(const SeparatrixGraph& graph);
std::vector<BrokenRule> broken_rules(const BlockLayout& layout);
std::vector<BrokenRule> broken_rules(const QuadMesh& mesh);

}  // namespace quadrille::api
