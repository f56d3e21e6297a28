#pragma once
// The irregular nodes and corner valences of a layout, chosen from a guiding field: all steps of critpoints
// (lib/method.md §3, §5). Each changes the result of the one before and keeps the index sum:
//   find_critical_points        zeros, clusters, corners by angle or field, corners that absorb zeros
//   resolve_clusters            clusters become nodes
//   choose_at_ties              replaces both if corners lie near 45 + 90 k degrees
//   line_field_points           replaces all these if the zeros cannot be isolated
//   override_corners            prescribed valences
//   divide_degenerate_corners   corners that are too sharp for a block
//   apply_topology              the grid and the number of nodes that a user chooses
//   resolve_features            nodes of small fillets and holes
//   place_nodes                 positions of least energy
//   keep_clearance              nodes too near to walls with layers
//   complete_nodes              elements, order
// Each change is recorded. A step whose result has a node that is no zero of the field sets the form `phase`.
// In one half of a symmetric whole all are steps of the whole (choice/half_model.hpp).

#include <functional>

#include "base/report.hpp"
#include "choice/node_options.hpp"
#include "model/critical_points.hpp"
#include "model/field.hpp"

namespace quadrille::choice {

/// Called with the name of each part of the work as it begins: search, resolve, place.
using PartBegins = std::function<void(const char* name)>;

/// `field`: harmonic, with an error estimate of each element (field/error_estimate). The result has no provenance.
/// Throws UsageError for overrides that do not fit the face, ComputeError if the index sum does not hold. The report
/// gets the keys of the steps, `feature_size`, and a warning if the nodes are chosen by rule.
CriticalPoints choose_nodes(const Field& field, const NodeOptions& options, int num_threads, Report& report,
                            const PartBegins& begin = {});

}  // namespace quadrille::choice
