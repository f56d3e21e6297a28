#include "layout/fine_tolerance.hpp"

#include <optional>

#include "graph/family_order.hpp"

namespace quadrille::layout {
namespace {

constexpr double refinement = 100;
constexpr double finest_tolerance = 1e-12 * (1 - 1e-6);  // in diameters; round-off makes finer ones useless

}  // namespace

graph::CandidateLayout with_fine_tolerance(LayoutOptions options, Report& report, const LayoutOfOptions& compute) {
  std::optional<Progress::Part> finer;
  for (;;) {
    try {
      return compute(options);
    } catch (const graph::FamilyOrderError&) {
      options.trace.tolerance /= refinement;
      const bool has_tolerance = options.trace.integrator == trace::Integrator::runge_kutta;
      if (!has_tolerance || options.trace.tolerance < finest_tolerance) throw;
      report.set("layout.tolerance", options.trace.tolerance);
      finer.emplace(report.progress(), "finer tolerance");
    }
  }
}

}  // namespace quadrille::layout
