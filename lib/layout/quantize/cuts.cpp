#include "quantize/cuts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/position_text.hpp"

namespace quadrille::quantize {
namespace {

// The component of each node under the graph's arcs.
std::vector<int> components(const SeparatrixGraph& graph) {
  DisjointSets linked(graph.nodes.size());
  for (const GraphArc& arc : graph.arcs) linked.unite(arc.from, arc.to);
  std::vector<int> component;
  for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n) component.push_back(linked.find(n));
  return component;
}

}  // namespace

CutStart cut_across_limit_cycle(const field::FieldEvaluator& evaluator, const trace::LineTracer& tracer,
                                const trace::Streamline& line) {
  for (const double turn : {half_pi, -half_pi}) {
    const trace::Streamline half = tracer.follow_from(line.end_position, line.end_angle + turn);
    if (half.end == trace::Streamline::End::boundary) return {half.reached.curve, half.reached.t};
  }
  const Vec2 at = line.end_position + evaluator.field().mesh.face.origin;
  throw ComputeError(fmt::format("no line leads from the limit cycle at {} to the boundary", position_text(at)));
}

std::vector<int> unconnected_loops(const SeparatrixGraph& graph) {
  const std::vector<int> component = components(graph);
  std::vector<int> component_of_loop(graph.face.num_loops(), -1);
  for (size_t n = 0; n < graph.nodes.size(); ++n)
    if (graph.nodes[n].curve >= 0) component_of_loop[graph.face.loop_of(graph.nodes[n].curve)] = component[n];
  std::vector<int> loops;
  for (int loop = 1; loop < graph.face.num_loops(); ++loop)
    if (component_of_loop[loop] != component_of_loop[0]) loops.push_back(loop);
  return loops;
}

CutStart cut_from_loop(const CadFace& face, int loop, int k) {
  const int first = face.loop_offsets[loop], num = face.loop_offsets[loop + 1] - first;
  double fraction = 0, digit = 0.5;
  for (; k > 0; k /= 2, digit /= 2) fraction += k % 2 * digit;
  const double along = fraction * num + 0.5, whole = std::floor(along);
  const int curve = first + static_cast<int>(whole) % num;
  const Nurbs& c = face.curves[curve];
  return {curve, c.begin() + (along - whole) * (c.end() - c.begin())};
}

}  // namespace quadrille::quantize
