#pragma once
// The numbered rules of every format (formats/*.md), one .cpp per format.

#include <string>
#include <vector>

#include "model/block_layout.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "model/quad_mesh.hpp"
#include "model/separatrix_graph.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::check {

struct Violation {
  std::string rule;  ///< "TRI-R01"
  std::string text;  ///< what is wrong, and where
};

/// quick: the rules without which a stage could read out of bounds or loop forever; full: every rule, proofs included.
enum class CheckDepth { quick, full };

std::vector<Violation> check_cad_face(const CadFace& face, CheckDepth depth);
std::vector<Violation> check_tri_mesh(const TriMesh& mesh, CheckDepth depth);
std::vector<Violation> check_field(const Field& field, CheckDepth depth);
std::vector<Violation> check_critical_points(const CriticalPoints& points, CheckDepth depth);
/// The rules of critical points that also need the mesh of their field: they refer to elements and corners of it.
std::vector<Violation> check_critical_points_of(const CriticalPoints& points, const TriMesh& mesh);
std::vector<Violation> check_separatrix_graph(const SeparatrixGraph& graph, CheckDepth depth);
std::vector<Violation> check_block_layout(const BlockLayout& layout, CheckDepth depth);
std::vector<Violation> check_quad_mesh(const QuadMesh& mesh, CheckDepth depth);

/// The warning (warning::mesh_not_valid) for a mesh that was written although it is not valid: a sentence with the
/// position of the worst element; empty for a valid mesh.
std::string validity_warning(const QuadMesh& mesh);

/// Throws FormatError with the first violation; `name` is the file's name for the message.
void require_valid(const std::vector<Violation>& violations, const std::string& name);

}  // namespace quadrille::check
