#pragma once
// The stage fieldsolve: the guiding field of each region of a triangle mesh.

#include <optional>
#include <string>

#include "base/options.hpp"
#include "base/run.hpp"
#include "galerkin/solve_laplace.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"
#include "model/given_metric.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::stage {

struct FieldsolveOptions {
  int order = 8;                   ///< of every element, without an order map
  std::string orders_file;         ///< path of an order map or field, which the caller reads
  std::string nodes_file;          ///< path of critical points, which the caller reads
  std::string align_file;          ///< path of directions to align with, which the caller reads
  double align_strength = 1;       ///< over that of each feature of the file, >= 0
  galerkin::LaplaceOptions solve;  ///< its number of threads is that of the run

  /// No option of the command: whether the error of each element is estimated, which padapt does again.
  bool estimates_errors = true;

  void validate() const;  ///< throws UsageError
};
void declare(Options& options, FieldsolveOptions& fieldsolve);

/// What the fields are made from.
struct FieldsolveInput {
  Input<TriMesh> mesh;
  std::optional<Input<OrderMap>> orders;                ///< replaces FieldsolveOptions::order
  std::string orders_format;                            ///< "order-map" or "field"
  std::optional<Input<CriticalPoints>> nodes;           ///< then the field is the phase form that has exactly these
  std::optional<Input<GivenAlignment>> alignment = {};  ///< -Δv + mu v = f in place of Laplace's equation
};

/// The field with the estimated error of each element. The nodes may be from a field on another mesh of the face, or
/// have been moved: their element numbers are not used. Throws FormatError if the mesh or the nodes break a rule or do
/// not belong together, UsageError for options that exclude each other, ComputeError if no field can have the nodes.
Field fieldsolve(const FieldsolveInput& input, const FieldsolveOptions& options, Run& run);

}  // namespace quadrille::stage
