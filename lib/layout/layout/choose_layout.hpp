#pragma once
// The choice of the layout by `--layout auto` (lib/method.md §9.8).
//
//   separatrices   traced layout   quantized layout           taken
//   more than 500  not computed    exists                     quantized, with a warning
//   more than 500  not computed    none                       crowded, with a warning
//   at most 500    too many arcs   scaled Jacobian >= 0.3     quantized, with a warning
//   at most 500    too many arcs   scaled Jacobian < 0.3      crowded if that is better, else quantized; with a warning
//   at most 500    too many arcs   none                       crowded, with a warning
//   at most 500    none            exists                     quantized, with a warning
//   at most 500    none            none                       midpoint division, with a warning
//   at most 500    few blocks      not computed               traced
//   at most 500    many blocks     fewer blocks, none worse   quantized
//   at most 500    many blocks     any other, or none         traced
//
// Crowded: the traced layout with ten times as many arcs allowed. If that fails too, midpoint division is taken.

#include <functional>
#include <optional>
#include <string>

#include "base/report.hpp"
#include "graph/candidate_layout.hpp"

namespace quadrille::layout {

/// A layout, or the reason why there is none.
struct LayoutAttempt {
  std::optional<graph::CandidateLayout> layout;
  std::string reason;
  bool is_crowded = false;  ///< the reason is the number of lines or arcs
};

/// Computes a layout and reports its counts.
using LayoutComputation = std::function<LayoutAttempt(Report&)>;

/// Computes the layout that exists in any case.
using CertainLayout = std::function<graph::CandidateLayout(Report&)>;

struct LayoutComputations {
  LayoutComputation traced, quantized, crowded;
  CertainLayout midpoint;
};

struct ChosenLayout {
  graph::CandidateLayout layout;  ///< certificate.reason: why not the traced one
  LayoutMethod method = LayoutMethod::traced;
  std::string warning;  ///< text of a warning; empty if the layout needs no warning
};

/// The text of the warning that a midpoint division was computed because of `reason`.
std::string midpoint_warning(const std::string& reason);

/// Chooses by the table above and computes only the layouts that it needs. Reports layout.method and layout.reason.
/// Throws ComputeError with the reason if there is no computation of a midpoint division where it would
/// be taken.
ChosenLayout choose_layout(int num_separatrices, const LayoutComputations& compute, Report& report);

/// Whether a layout has more than 1.2 times as many blocks as would result from lines that stop at each other.
bool has_many_blocks(int num_blocks, int num_lines, int euler_characteristic);

/// The criteria by which two layouts are compared.
struct LayoutQuality {
  int num_blocks = 0;
  bool is_valid = true;  ///< all Jacobians proved positive
  double least_scaled_jacobian = 1;
};
LayoutQuality quality_of(const graph::Subdivision& subdivision);

/// Whether a layout has fewer blocks, all valid and none worse (within 1e-6) than the worst of `traced`.
bool is_preferable(const LayoutQuality& quantized, const LayoutQuality& traced);

/// Whether a crowded layout is taken in place of a poor quantized one: all Jacobians are proved positive, and they are
/// not in the other, or the least scaled Jacobian is greater.
bool is_better_shaped(const LayoutQuality& crowded, const LayoutQuality& quantized);

}  // namespace quadrille::layout
