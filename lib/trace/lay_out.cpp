#include "trace/lay_out.hpp"

#include "trace/t_mesh.hpp"

namespace quadrille {

SeparatrixGraph lay_out(const FieldEvaluator& evaluator, const CriticalPoints& points, const TraceOptions& options,
                        Report& report) {
  if (options.layout == "t-mesh") return trace_t_mesh(evaluator, points, options, report);
  return trace_separatrices(evaluator, points, options, report);
}

}  // namespace quadrille
