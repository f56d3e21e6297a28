#pragma once
// The numbered rules of every format (formats/*.md), one .cpp per format.

#include <string>
#include <vector>

#include "model/stage_formats.hpp"

namespace quadrille::check {

struct Violation {
  std::string rule;  ///< "TRI-R01"
  std::string text;  ///< what is wrong, and where
};

/// quick: the rules without which a stage could read out of bounds or loop forever; full: every rule, proofs included.
enum class CheckDepth { quick, full };

/// The rules of the format of a struct of StageModel or of a CadFace; those of a face or mesh that it contains come
/// first.
template <typename Model>
std::vector<Violation> check_stage(const Model& model, CheckDepth depth);
/// The rules of critical points that also need the mesh of their field: they refer to elements and corners of it.
std::vector<Violation> check_critical_points_of(const CriticalPoints& points, const TriMesh& mesh);

/// The warning (warning::mesh_not_valid) for a mesh that was written although it is not valid: a sentence with the
/// position of the worst element; empty for a valid mesh.
std::string validity_warning(const QuadMesh& mesh);
std::string validity_warning(const HexMesh& mesh);

/// Throws FormatError with the first violation; `name` is the file's name for the message.
void require_valid(const std::vector<Violation>& violations, const std::string& name);

/// Throws FormatError unless the rules hold that every stage checks when it reads a file.
template <typename Model>
void require_sound(const Model& model, const std::string& name) {
  require_valid(check_stage(model, CheckDepth::quick), name);
}

}  // namespace quadrille::check
