#pragma once
// Repeats the computation of a layout with a finer tolerance of integration where lines of one family cross.

#include <functional>

#include "base/report.hpp"
#include "graph/candidate_layout.hpp"
#include "layout/layout_options.hpp"

namespace quadrille::layout {

using LayoutOfOptions = std::function<graph::CandidateLayout(const LayoutOptions&)>;

/// compute(options); if it throws graph::FamilyOrderError, again with a tolerance 100 times finer, down to 1e-12
/// diameters: where many lines approach one separatrix, their errors are larger than their distances. Reports
/// layout.tolerance if it was changed. The integrator with a fixed step has no tolerance: its errors are not caught.
graph::CandidateLayout with_fine_tolerance(LayoutOptions options, Report& report, const LayoutOfOptions& compute);

}  // namespace quadrille::layout
