#include "quantize/t_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "graph/build_graph.hpp"
#include "graph/candidate_layout.hpp"
#include "surface/positions.hpp"
#include "trace/launch.hpp"

namespace quadrille::quantize {
namespace {

// Lengths to which lines are traced first, relative to the diameter.
struct FirstLengths {
  double few = 2;
  // So many lines stop each other much earlier: traced first so many times as far as the side of a square of which each
  // line has one, relative to the diameter squared.
  int many_lines = 500;
  double squares = 6;

  double of(int num_lines) const { return num_lines <= many_lines ? few : squares / std::sqrt(num_lines); }
};
constexpr FirstLengths first_lengths{};

constexpr int max_cuts = 100;

// Traces all lines to the first length.
trace::LineTracer first_lines(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                              const std::vector<Vec2>& nodes, const trace::TraceOptions& options, Progress* progress) {
  trace::LineTracer tracer(evaluator, points, nodes, options);
  tracer.follow_all_to(first_lengths.of(trace::num_launches(points)) * evaluator.field().mesh.face.diameter, progress);
  return tracer;
}

std::vector<MotorcycleTrail> trails_of(const trace::LineArrangement& arrangement,
                                       const std::vector<double>& head_starts) {
  std::vector<MotorcycleTrail> trails;
  for (const trace::MergedLine& line : arrangement.lines) {
    const bool is_merged = line.merge >= 0;
    trails.push_back({line.length, is_merged, is_merged ? 0 : head_starts[line.streamline]});
  }
  return trails;
}

[[noreturn]] void fail_stuck(const CadFace& face, const trace::Streamline& line) {
  throw ComputeError(
      fmt::format("{} steps take the separatrix from {} no farther than {:.3g} diameters, to {}: the field turns too "
                  "fast there, or from element to element: lower padapt --target-error",
                  line.steps.size(), surface::position_text(face, line.launch.origin), line.length() / face.diameter,
                  surface::position_text(face, line.end_position)));
}

std::ptrdiff_t num_stopped(const std::vector<CoveredPart>& covered) {
  return std::count_if(covered.begin(), covered.end(), [](const CoveredPart& part) { return !part.is_whole(); });
}

}  // namespace

CutStart cut_across_limit_cycle(const field::FieldEvaluator& evaluator, const trace::LineTracer& tracer,
                                const trace::Streamline& line) {
  for (const double turn : {half_pi, -half_pi}) {
    const trace::Streamline half = tracer.follow_from(line.end_position, line.end_angle + turn);
    if (half.end == trace::Streamline::End::boundary) return {half.reached.curve, half.reached.t};
  }
  const std::string at = surface::position_text(evaluator.field().mesh.face, line.end_position);
  throw ComputeError(fmt::format("no line leads from the limit cycle at {} to the boundary", at));
}

std::vector<int> unconnected_loops(const SeparatrixGraph& graph) {
  DisjointSets linked(graph.nodes.size());
  for (const GraphArc& arc : graph.arcs) linked.unite(arc.from, arc.to);
  std::vector<int> node_of_loop(graph.face.num_loops(), -1);
  for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n)
    if (graph.nodes[n].curve >= 0) node_of_loop[graph.face.loop_of(graph.nodes[n].curve)] = n;
  std::vector<int> loops;
  for (int loop = 1; loop < graph.face.num_loops(); ++loop)
    if (linked.find(node_of_loop[loop]) != linked.find(node_of_loop[0])) loops.push_back(loop);
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

TMeshTracer::TMeshTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                         const trace::TraceOptions& options, Progress* progress)
    : evaluator_(evaluator),
      fixed_(trace::fixed_nodes(evaluator.field().mesh.face, points)),
      nodes_(trace::positions(fixed_)),
      tracer_(first_lines(evaluator, points, nodes_, options, progress)),
      lines_(evaluator, tracer_.lines(), nodes_, radians(options.merge_angle), options.merge_distance,
             trace::LineEnds::optional) {
  cuts_.head_starts.resize(tracer_.lines().size(), 0);
  cuts_.num_of_loop.resize(evaluator.field().mesh.face.num_loops(), 0);
}

graph::CandidateLayout TMeshTracer::trace(Report& report) {
  const CadFace& face = evaluator_.field().mesh.face;
  const Progress::Part round(report.progress(), "round");
  for (;;) {
    round.advance();
    lines_.merge(report.progress());  // lines need no end here: merging can always be decided
    const trace::LineArrangement& arrangement = lines_.arrangement();
    const std::vector<CoveredPart> covered = trace_motorcycle_graph(
        trails_of(arrangement, cuts_.head_starts), arrangement.inner_crossings, tolerance::tied * face.diameter);
    if (follow_unstopped_lines(covered)) continue;
    ClippedLines clipped = clip_lines(arrangement, covered);
    SeparatrixGraph graph = graph::build_graph(face, fixed_, std::move(clipped.pieces), clipped.crossings,
                                               tolerance::round_off * face.diameter);
    if (connect_loops(graph)) continue;
    piece2line_ = std::move(clipped.piece2line);
    graph.certificate.merged_lines = static_cast<int>(lines_.chosen().size());
    graph.certificate.largest_deviation_degrees = degrees(lines_.largest_deviation());
    report.set("t_mesh.launched", tracer_.lines().size());
    report.set("t_mesh.steps", tracer_.num_steps());
    report.set("t_mesh.merged", graph.certificate.merged_lines);
    report.set("t_mesh.stopped", num_stopped(covered));
    report.set("t_mesh.cuts", cuts_.num);
    report.set("t_mesh.arcs", graph.arcs.size());
    report.set("t_mesh.t_junctions", graph.t_junctions.size());
    graph::CandidateLayout layout = graph::candidate_layout(std::move(graph));
    for (const FaceCount& count : graph::face_valence_histogram(layout.subdivision))
      report.set(fmt::format("t_mesh.faces_of_{}_corners", count.corners), count.faces);
    return layout;
  }
}

bool TMeshTracer::reject_merges(const std::vector<SeparatrixLine>& lines, const std::vector<std::vector<int>>& strips) {
  std::vector<int> all;
  std::map<int, int> arc2merge;
  for (size_t i = 0; i < lines.size(); ++i) {
    const int merge = lines_.arrangement().lines[piece2line_[i]].merge;
    if (merge < 0) continue;
    all.push_back(merge);
    for (const int arc : lines[i].arcs) arc2merge[arc] = merge;
  }
  bool any = false;
  for (const std::vector<int>& strip : strips) {
    std::vector<int> beside;
    for (const int arc : strip)
      if (const auto at = arc2merge.find(arc); at != arc2merge.end()) beside.push_back(at->second);
    any = lines_.reject_worst(beside, trace::same_line_angle) || any;
  }
  return any || lines_.reject_worst(all, trace::same_line_angle);
}

// A line of the greatest length that is not stopped is a limit cycle: a cut is added across it, and the motorcycle
// graph is computed again. False if all lines have ended or are stopped.
bool TMeshTracer::follow_unstopped_lines(const std::vector<CoveredPart>& covered) {
  bool any = false;
  for (size_t i = 0; i < covered.size(); ++i) {
    const trace::MergedLine& merged = lines_.arrangement().lines[i];
    const trace::Streamline& line = tracer_.lines()[merged.streamline];
    if (merged.merge >= 0 || !line.is_endless() || !covered[i].is_whole()) continue;
    if (line.is_stuck()) fail_stuck(evaluator_.field().mesh.face, line);
    any = true;
    if (line.is_limit_cycle || line.length() >= tracer_.max_length() * (1 - 1e-9)) {
      add_cut(cut_across_limit_cycle(evaluator_, tracer_, line), tracer_.max_length());
      break;
    }
    const double before = line.length();
    tracer_.follow_to(merged.streamline, 2 * before);
    if (line.is_endless() && !(line.length() > before)) fail_stuck(evaluator_.field().mesh.face, line);
  }
  if (any) lines_.renew();
  return any;
}

bool TMeshTracer::connect_loops(const SeparatrixGraph& graph) {
  const std::vector<int> loops = unconnected_loops(graph);
  for (const int loop : loops) add_cut(cut_from_loop(graph.face, loop, cuts_.num_of_loop[loop]++), 0);
  if (!loops.empty()) lines_.renew();
  return !loops.empty();
}

void TMeshTracer::add_cut(const CutStart& start, double head_start) {
  if (++cuts_.num > max_cuts)
    throw ComputeError(fmt::format("holes and limit cycles need more than {} cuts", max_cuts));
  cuts_.head_starts.push_back(head_start);
  tracer_.add_cut(start.curve, start.t, first_lengths.few * evaluator_.field().mesh.face.diameter);
}

}  // namespace quadrille::quantize
