#include "trace/trace_separatrices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "trace/advance.hpp"
#include "trace/build_graph.hpp"
#include "trace/crossings.hpp"
#include "trace/fit_line.hpp"
#include "trace/launch_all.hpp"
#include "trace/merge.hpp"
#include "trace/planar_faces.hpp"

namespace quadrille {
namespace {

// Shares of the diameter.
constexpr double hit_share = 1e-7;   // as near to a node as this a line ends in it
constexpr double fit_share = 2e-9;   // splines follow their lines within this
constexpr double snap_share = 1e-9;  // nodes nearer than this are one
constexpr double node_share = 1e-6;  // a node of the critical points' file lies this near to a zero

class Tracer {
 public:
  Tracer(const FieldEvaluator& evaluator, const CriticalPoints& points, const TraceOptions& options, Report& report)
      : evaluator_(evaluator), options_(options), report_(report), face_(evaluator.field().mesh.face) {
    fixed_ = fixed_nodes(face_, points);
    for (const FixedNode& node : fixed_) positions_.push_back(node.position);
    std::vector<Launch> launches = launch_all(evaluator, points);
    if (launches.empty() && face_.num_loops() == 2) launches = launch_cuts(evaluator);
    for (const Launch& launch : launches) lines_.push_back(advance(evaluator, launch, positions_, advance_options()));
    traced_.resize(lines_.size());
  }

  SeparatrixGraph run() {
    add_candidates(radians(options_.merge_angle), options_.merge_distance);
    num_regular_ = candidates_.size();
    std::vector<int> chosen;
    std::vector<Crossing> crossings;
    do {
      do chosen = choose();
      while (ban_for_lost(chosen));
      collect(chosen);
      crossings = crossings_of_finished();
    } while (ban_crossed_merges(crossings));
    SeparatrixGraph graph = build_graph(face_, fixed_, finished_, crossings, snap_share * face_.diameter);
    require_few_arcs(graph);
    tell(graph, chosen);
    report_.set("trace.faces", require_four_corners(graph));
    return graph;
  }

 private:
  AdvanceOptions advance_options() const {
    const double d = face_.diameter;
    return {options_.tolerance * d, options_.step > 0 ? options_.step : d / 20, options_.max_length * d, hit_share * d};
  }

  void add_candidates(double max_angle, double distance) {
    for (const MergeCandidate& c : merge_candidates(evaluator_, lines_, positions_, {max_angle, distance}))
      candidates_.push_back(c);
    merged_.resize(candidates_.size());
    banned_.resize(candidates_.size(), false);
  }

  bool is_endless(int line) const { return lines_[line].end == Streamline::End::length; }

  // By the rules; then lines that would go on for ever (spirals, limit cycles) are merged whatever that turns, if
  // anything comes their way.
  std::vector<int> choose() {
    std::vector<bool> taken(lines_.size(), false), allowed(candidates_.size(), false);
    for (size_t i = 0; i < num_regular_; ++i) allowed[i] = !banned_[i];
    std::vector<int> chosen = choose_merges(candidates_, allowed, taken);
    const std::vector<int> lost = lost_lines(chosen);
    if (lost.empty()) return chosen;
    if (candidates_.size() == num_regular_) add_candidates(greatest_merge_angle, 0);
    const auto is_lost = [&](int line) { return std::binary_search(lost.begin(), lost.end(), line); };
    allowed.assign(candidates_.size(), false);
    for (size_t i = num_regular_; i < candidates_.size(); ++i)
      allowed[i] = !banned_[i] && (is_lost(candidates_[i].a) || is_lost(candidates_[i].b));
    for (const int c : choose_merges(candidates_, allowed, taken)) chosen.push_back(c);
    return chosen;
  }

  // Endless lines that no merge has taken, ascending.
  std::vector<int> lost_lines(const std::vector<int>& chosen) const {
    std::vector<bool> merged_line(lines_.size(), false);
    for (const int c : chosen) merged_line[candidates_[c].a] = merged_line[candidates_[c].b] = true;
    std::vector<int> lost;
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i)
      if (is_endless(i) && !merged_line[i]) lost.push_back(i);
    return lost;
  }

  // Where an endless line has nobody because others took its partner first, that merge is given up: its lines end.
  bool ban_for_lost(const std::vector<int>& chosen) {
    std::vector<int> merge_of(lines_.size(), -1);
    for (const int c : chosen) merge_of[candidates_[c].a] = merge_of[candidates_[c].b] = c;
    bool any = false;
    for (const int line : lost_lines(chosen))
      for (size_t i = 0; i < candidates_.size(); ++i) {
        const MergeCandidate& wish = candidates_[i];
        if (banned_[i] || (wish.a != line && wish.b != line)) continue;
        const int taker = merge_of[wish.a == line ? wish.b : wish.a];
        if (taker < 0 || is_endless(candidates_[taker].a) || is_endless(candidates_[taker].b)) continue;
        any = any || !banned_[taker];
        banned_[taker] = true;
        break;
      }
    return any;
  }

  // Merged pairs and what is left of the lines, in the sequence of the lines.
  void collect(const std::vector<int>& chosen) {
    std::vector<int> merge_of(lines_.size(), -1);
    for (const int c : chosen) merge_of[candidates_[c].a] = merge_of[candidates_[c].b] = c;
    finished_.clear(), finished_merge_.clear();
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
      const int c = merge_of[i];
      if (c >= 0 && candidates_[c].b == i) continue;
      finished_.push_back(c >= 0 ? merged(c) : traced(i));
      finished_merge_.push_back(c);
    }
  }

  FinishedLine merged(int c) {
    const MergeCandidate& m = candidates_[c];
    const Streamline &a = lines_[m.a], &b = lines_[m.b];
    if (!merged_[c]) merged_[c] = fit_line(merged_curve(evaluator_, a, b, m), m.length(), fit_share * face_.diameter);
    return {{a.launch.node}, {b.launch.node}, *merged_[c], "merged"};
  }

  FinishedLine traced(int i) {
    const Streamline& line = lines_[i];
    if (is_endless(i)) fail_too_long(line);
    if (!traced_[i]) {
      const auto along = [&](double s, Vec2& direction) { return line.at(evaluator_, s, direction); };
      traced_[i] = fit_line(along, line.length(), fit_share * face_.diameter);
    }
    FinishedLine finished{{line.launch.node}, {line.end_node, line.curve, line.t}, *traced_[i], "traced"};
    if (line.launch.node < 0) {
      finished.start = {-1, line.launch.curve, line.launch.t};
      finished.kind = "cut";
    }
    return finished;
  }

  std::vector<Crossing> crossings_of_finished() const {
    std::vector<Nurbs> splines;
    for (const FinishedLine& line : finished_) splines.push_back(line.spline);
    return find_crossings(splines, snap_share * face_.diameter);
  }

  bool at_common_end(const Crossing& c) const {
    const double near = 2 * snap_share * face_.diameter;
    for (const int line : {c.a, c.b}) {
      const Nurbs& spline = finished_[line].spline;
      if (distance(spline.poles.front(), c.position) > near && distance(spline.poles.back(), c.position) > near)
        return false;
    }
    return true;
  }

  // Lines of one family never cross, unless a merge has bent one across the other: that merge is given up.
  bool ban_crossed_merges(const std::vector<Crossing>& crossings) {
    double turn = -1;
    for (const bool find : {true, false})
      for (const Crossing& c : crossings) {
        if (c.angle > pi / 4 || at_common_end(c)) continue;
        for (const int line : {c.a, c.b}) {
          const int m = finished_merge_[line];
          if (m < 0) continue;
          // All of one orbit alike: what turns as much within 1e-6.
          if (find)
            turn = std::max(turn, candidates_[m].turn);
          else if (candidates_[m].turn > turn - 1e-6)
            banned_[m] = true;
        }
      }
    return turn >= 0;
  }

  [[noreturn]] void fail_too_long(const Streamline& line) const {
    const Vec2 from = line.launch.origin + face_.origin, to = line.end_position + face_.origin;
    throw ComputeError(
        fmt::format("the separatrix from ({:.6g}, {:.6g}) at {:.2f} degrees has reached neither boundary "
                    "nor node after {:.3g} diameters, near ({:.6g}, {:.6g})",
                    from.x, from.y, degrees(wrap_pi(line.launch.angle)), line.length() / face_.diameter, to.x, to.y));
  }

  void require_few_arcs(const SeparatrixGraph& graph) const {
    const auto inside = [](const GraphArc& arc) { return !arc.is_boundary; };
    const auto count = std::count_if(graph.arcs.begin(), graph.arcs.end(), inside);
    if (count > options_.max_lines)
      throw ComputeError(fmt::format("{} separatrices cut each other into {} arcs, more than the {} allowed",
                                     graph.lines.size(), count, options_.max_lines));
  }

  void tell(const SeparatrixGraph& graph, const std::vector<int>& chosen) const {
    double turn = 0;
    for (const int c : chosen) turn = std::max(turn, candidates_[c].turn);
    report_.set("trace.launched", lines_.size());
    report_.set("trace.lines", graph.lines.size());
    report_.set("trace.merged", chosen.size());
    report_.set("trace.largest_merge_turn_degrees", degrees(turn));
    report_.set("trace.nodes", graph.nodes.size());
    report_.set("trace.arcs", graph.arcs.size());
  }

  const FieldEvaluator& evaluator_;
  const TraceOptions& options_;
  Report& report_;
  const CadFace& face_;
  std::vector<FixedNode> fixed_;
  std::vector<Vec2> positions_;
  std::vector<Streamline> lines_;
  std::vector<MergeCandidate> candidates_;  // by the rules, then the last resorts for endless lines
  std::vector<bool> banned_;
  size_t num_regular_ = 0;
  std::vector<std::optional<Nurbs>> traced_, merged_;  // splines by line and by candidate, fitted when first wanted
  std::vector<FinishedLine> finished_;
  std::vector<int> finished_merge_;  // candidate of each finished line, or -1
};

}  // namespace

void TraceOptions::validate() const {
  if (!(tolerance > 0)) throw UsageError("the tolerance must be positive");
  if (step < 0 || merge_distance < 0 || merge_angle < 0) throw UsageError("lengths and angles must not be negative");
  if (max_lines < 1 || !(max_length > 0)) throw UsageError("the bounds must be positive");
}

void require_nodes_of_field(const FieldEvaluator& evaluator, const CriticalPoints& points) {
  const CadFace& face = evaluator.field().mesh.face;
  int sum = 0;
  for (const CriticalPoint& p : points.critical_points) {
    sum += 4 - p.valence;
    const Location at = evaluator.locator().find(p.position);
    bool is_zero = false;
    if (at.elem >= 0) {
      const FieldSample sample = evaluator.sample(at.elem, at.xi);
      const double slope = std::sqrt(std::abs(det(sample.dv_dx))), off = norm(sample.value);
      // A multiple zero has no slope; its value is small.
      is_zero = std::abs(p.index) == 1 ? norm(inverse(sample.dv_dx) * sample.value) <= node_share * face.diameter
                                       : off <= 1e-4 * std::max(1.0, slope * face.diameter);
    }
    if (is_zero) continue;
    const Vec2 place = p.position + face.origin;
    throw FormatError(
        fmt::format("the node at ({:.6g}, {:.6g}) is no zero of the field: run fieldsolve --nodes", place.x, place.y));
  }
  for (const Corner& c : points.corners) {
    sum += 2 - c.valence;
    if (c.joint < 0 || c.joint >= face.num_curves() || !face.joints[c.joint].is_corner)
      throw FormatError(fmt::format("joint {} of the critical points is no corner of the field's face", c.joint));
  }
  if (sum != 4 * face.euler_characteristic())
    throw FormatError(fmt::format("the index sum of nodes and corners is {} where the domain needs {}", sum,
                                  4 * face.euler_characteristic()));
}

SeparatrixGraph trace_separatrices(const FieldEvaluator& evaluator, const CriticalPoints& points,
                                   const TraceOptions& options, Report& report) {
  options.validate();
  return Tracer(evaluator, points, options, report).run();
}

}  // namespace quadrille
