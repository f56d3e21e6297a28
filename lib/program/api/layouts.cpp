#include "api/layouts.hpp"

#include "api/as_input.hpp"
#include "stage/blocksplit.hpp"
#include "stage/critpoints.hpp"
#include "stage/quadrefine.hpp"
#include "stage/separatrix.hpp"

namespace quadrille::api {

CriticalPoints find_nodes(const Field& field, std::vector<std::string>* warnings) {
  Run run;
  CriticalPoints points = stage::critpoints(as_input(field, "the field"), {}, run);
  add_warnings(run, warnings);
  return points;
}

SeparatrixGraph trace_layout(const Field& field, const CriticalPoints& points, const TraceSettings& settings,
                             std::vector<std::string>* warnings) {
  Run run;
  stage::SeparatrixOptions options;
  options.layout = settings.layout;
  options.trace.merge_distance = settings.merge_distance;
  options.max_deviation = settings.max_deviation;
  if (settings.coarse_mesher)
    options.coarse_mesher = [&](const CadFace& face, const auto& doubts, Report&) {
      return settings.coarse_mesher(face, doubts);
    };
  SeparatrixGraph graph = stage::separatrix(as_input(field, "the field"), as_input(points, "the nodes"), options, run);
  add_warnings(run, warnings);
  return graph;
}

BlockLayout make_blocks(const SeparatrixGraph& graph, std::vector<std::string>* warnings) {
  Run run;
  BlockLayout layout = stage::blocksplit(as_input(graph, "the graph"), {}, {}, run);
  add_warnings(run, warnings);
  return layout;
}

QuadMesh make_quads(const BlockLayout& layout, const QuadSettings& settings, std::vector<std::string>* warnings) {
  Run run;
  stage::QuadrefineOptions options;
  options.refine.order = settings.order;
  options.sizes.size = settings.size;
  QuadMesh mesh = stage::quadrefine({as_input(layout, "the blocks")}, options, run);
  add_warnings(run, warnings);
  return mesh;
}

}  // namespace quadrille::api
