#pragma once
// Reading and writing stage files: "-" is stdin or stdout, HDF5 as a file image. One .cpp per format behind this.
// Readers throw FormatError (not that format, other major version, wrong shape or type, truncated), writers
// OutputError.

#include <string>

#include "io/input_file.hpp"
#include "model/block_layout.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "model/quad_mesh.hpp"
#include "model/separatrix_graph.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::io {

TriMesh read_tri_mesh(const InputFile& file);
Field read_field(const InputFile& file);  ///< x.solve.h5, x.field.h5
CriticalPoints read_critical_points(const InputFile& file);
SeparatrixGraph read_separatrix_graph(const InputFile& file);
BlockLayout read_block_layout(const InputFile& file);
QuadMesh read_quad_mesh(const InputFile& file);
/// The reader of the struct's format.
template <typename Model>
Model read_stage(const InputFile& file);
template <>
inline TriMesh read_stage(const InputFile& file) {
  return read_tri_mesh(file);
}
template <>
inline Field read_stage(const InputFile& file) {
  return read_field(file);
}
template <>
inline CriticalPoints read_stage(const InputFile& file) {
  return read_critical_points(file);
}
template <>
inline SeparatrixGraph read_stage(const InputFile& file) {
  return read_separatrix_graph(file);
}
template <>
inline BlockLayout read_stage(const InputFile& file) {
  return read_block_layout(file);
}
template <>
inline QuadMesh read_stage(const InputFile& file) {
  return read_quad_mesh(file);
}

/// The CAD face at the root of x.tri.h5, x.sep.json, x.blocks.h5 or x.quad.h5, whatever else is in the file.
CadFace read_face(const InputFile& file);

/// The bytes of the file of a struct: HDF5 or JSON.
std::string stage_bytes(const TriMesh& mesh);
std::string stage_bytes(const Field& field);
std::string stage_bytes(const CriticalPoints& points);
std::string stage_bytes(const SeparatrixGraph& graph);
std::string stage_bytes(const BlockLayout& layout);
std::string stage_bytes(const QuadMesh& mesh);

/// Writes the bytes of a stage file to `path`, completely or not at all.
void write_stage_bytes(const std::string& path, const std::string& bytes);

template <typename Model>
void write_stage(const std::string& path, const Model& model) {
  write_stage_bytes(path, stage_bytes(model));
}

/// The name and the digest that a file of these bytes has.
FileIdentity identity_of(const std::string& name, const std::string& bytes);

/// "tri-mesh", "field", "critical-points", "separatrix-graph", "block-layout", "quad-mesh"; throws FormatError for
/// anything else.
std::string stage_format(const InputFile& file);

}  // namespace quadrille::io
