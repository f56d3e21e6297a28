#include "quantize/t_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/fit_line.hpp"
#include "curve/nurbs.hpp"
#include "graph/build_graph.hpp"
#include "graph/crossings.hpp"
#include "graph/face_census.hpp"
#include "graph/family_order.hpp"
#include "graph/known_crossings.hpp"
#include "quantize/motorcycle.hpp"
#include "trace/advance.hpp"
#include "trace/launch_all.hpp"
#include "trace/merge.hpp"

namespace quadrille::quantize {
namespace {

// Shares of the diameter.
constexpr double hit_share = 1e-7;   // as near to a node as this a line ends in it
constexpr double fit_share = 2e-9;   // splines follow their lines within this
constexpr double snap_share = 1e-9;  // nodes nearer than this are one
constexpr double tie_share = 1e-6;   // arrivals nearer than this are one
constexpr double first_bound = 2;    // of the length of lines
constexpr int max_cuts = 100;

constexpr double same_angle = 1e-4;  // radians: lines that meet head on within this are one, whatever the options say

/// A line or a merged pair, before the race.
struct Contestant {
  graph::CurveKey key{};
  graph::FinishedLine line;
  Trail trail;
  int merge = -1;    // candidate
  int unended = -1;  // the streamline that has no end yet
};

}  // namespace

class TMeshTracer::Impl {
 public:
  Impl(const field::FieldEvaluator& evaluator, const CriticalPoints& points, const trace::TraceOptions& options)
      : evaluator_(evaluator),
        face_(evaluator.field().mesh.face),
        d_(face_.diameter),
        options_(options),
        fixed_(trace::fixed_nodes(face_, points)),
        launches_(trace::launch_all(evaluator, points)) {
    if (launches_.empty() && face_.num_loops() == 2) launches_ = trace::launch_cuts(evaluator);
    head_starts_.resize(launches_.size(), 0);
    for (const graph::FixedNode& node : fixed_) nodes_.push_back(node.position);
    for (const trace::Launch& launch : launches_)
      lines_.push_back(trace::advance(evaluator, launch, nodes_, bounds(first_bound * d_)));
  }

  SeparatrixGraph run() {
    for (;;) {
      run_race();
      if (lengthen()) continue;
      SeparatrixGraph graph = clipped_graph();
      if (!tie_lone_loops(graph)) return graph;
    }
  }

  bool give_up_merge(const SeparatrixGraph& graph, const std::vector<int>& arcs) {
    std::vector<int> near, all;
    for (size_t i = 0; i < merge_of_line_.size(); ++i) {
      if (merge_of_line_[i] < 0) continue;
      all.push_back(merge_of_line_[i]);
      for (const int a : graph.lines[i].arcs)
        if (std::find(arcs.begin(), arcs.end(), a) != arcs.end()) near.push_back(merge_of_line_[i]);
    }
    return give_up_worst(near, same_angle) || give_up_worst(all, same_angle);
  }

  size_t num_lines() const { return lines_.size(); }
  int num_cuts() const { return num_cuts_; }
  int num_merged() const {
    return static_cast<int>(
        std::count_if(contestants_.begin(), contestants_.end(), [](const Contestant& c) { return c.merge >= 0; }));
  }
  double largest_turn() const {
    double turn = 0;
    for (const Contestant& c : contestants_)
      if (c.merge >= 0) turn = std::max(turn, candidates_[c.merge].turn);
    return turn;
  }
  int num_stopped() const {
    return static_cast<int>(
        std::count_if(covered_.begin(), covered_.end(), [](const Covered& c) { return !c.whole(); }));
  }

 private:
  trace::AdvanceOptions bounds(double length) const {
    const double step = options_.step > 0 ? options_.step : d_ / 20;
    return {options_.tolerance * d_, step, std::min(length, options_.max_length * d_), hit_share * d_};
  }

  void run_race() {
    const double angle = std::max(radians(options_.merge_angle), same_angle);
    if (candidates_are_old_)
      candidates_ = trace::merge_candidates(evaluator_, lines_, nodes_, {angle, options_.merge_distance});
    candidates_are_old_ = false;
    do {
      enter_contestants();
    } while (give_up_crossed_merges());
    std::vector<bool> is_exempt;  // cuts from two sides may be one and the same
    for (const Contestant& c : contestants_) is_exempt.push_back(c.merge >= 0 || c.line.kind == "cut");
    graph::require_family_order(crossings_, is_exempt, face_.origin);
    std::vector<Trail> trails;
    for (const Contestant& c : contestants_) trails.push_back(c.trail);
    covered_ = race(trails, crossings_, tie_share * d_);
  }

  void enter_contestants() {
    std::vector<bool> taken(lines_.size(), false);
    std::vector<int> merge_of(lines_.size(), -1);
    std::vector<bool> allowed;
    for (const trace::MergeCandidate& c : candidates_) allowed.push_back(given_up_.count({c.a, c.b}) == 0);
    for (const int c : trace::choose_merges(candidates_, allowed, taken))
      merge_of[candidates_[c].a] = merge_of[candidates_[c].b] = c;
    contestants_.clear();
    std::vector<Nurbs> splines;
    for (int i = 0; i < static_cast<int>(lines_.size()); ++i) {
      if (merge_of[i] >= 0 && candidates_[merge_of[i]].b == i) continue;
      contestants_.push_back(merge_of[i] >= 0 ? merged(merge_of[i]) : single(i));
      splines.push_back(contestants_.back().line.spline);
    }
    std::vector<graph::CurveKey> keys;
    for (const Contestant& c : contestants_) keys.push_back(c.key);
    crossings_.clear();
    for (const graph::Crossing& c : known_crossings_.find(keys, splines, snap(), face_.origin))
      if (!is_common_end(c)) crossings_.push_back(c);
  }

  Contestant single(int i) {
    const trace::Streamline& l = lines_[i];
    const bool is_cut = l.launch.node < 0, is_unended = l.end == trace::Streamline::End::length;
    const graph::LineEnd start =
        is_cut ? graph::LineEnd{-1, l.launch.curve, l.launch.t} : graph::LineEnd{l.launch.node, -1, 0};
    const auto along = [&](double s, Vec2& direction) { return l.at(evaluator_, s, direction); };
    const Nurbs& spline = fitted(i, -1, along, l.length());
    return {key_of(i, -1, l.length()),
            {start, {l.end_node, l.curve, l.t}, spline, is_cut ? "cut" : "traced"},
            {l.length(), false, head_starts_[i]},
            -1,
            is_unended ? i : -1};
  }

  Contestant merged(int candidate) {
    const trace::MergeCandidate& m = candidates_[candidate];
    const trace::Streamline &a = lines_[m.a], &b = lines_[m.b];
    const Nurbs& spline = fitted(m.a, m.b, trace::merged_curve(evaluator_, a, b, m), m.length());
    return {key_of(m.a, m.b, m.length()),
            {{a.launch.node, -1, 0}, {b.launch.node, -1, 0}, spline, "merged"},
            {m.length(), true, 0},
            candidate,
            -1};
  }

  // Lines, the second -1 where there is one only; `length` tells a line from itself before it was lengthened.
  static graph::CurveKey key_of(int a, int b, double length) {
    return {static_cast<double>(a), static_cast<double>(b), length};
  }

  // Fitted once however often the plan changes.
  const Nurbs& fitted(int a, int b, const curve::CurveFunction& curve, double length) {
    const graph::CurveKey key = key_of(a, b, length);
    const auto known = fitted_.find(key);
    if (known != fitted_.end()) return known->second;
    return fitted_[key] = curve::fit_line(curve, length, fit_share * d_);
  }

  bool is_common_end(const graph::Crossing& c) const {
    const auto ends_there = [&](int i) {
      const Nurbs& spline = contestants_[i].line.spline;
      return distance(spline.poles.front(), c.position) <= 2 * snap() ||
             distance(spline.poles.back(), c.position) <= 2 * snap();
    };
    return ends_there(c.a) && ends_there(c.b);
  }

  // Lines of one family never cross, unless a merge has bent one across the other: the worst of these is given up.
  bool give_up_crossed_merges() {
    std::vector<int> crossed;
    for (const graph::Crossing& c : crossings_)
      for (const int i : {c.a, c.b})
        if (graph::is_of_one_family(c) && contestants_[i].merge >= 0) crossed.push_back(contestants_[i].merge);
    return give_up_worst(crossed, 0);
  }

  // Of these candidates, within 1e-6 alike. False where none turns by as much as `least_turn`.
  bool give_up_worst(const std::vector<int>& merges, double least_turn) {
    double turn = -1;
    for (const int merge : merges) turn = std::max(turn, candidates_[merge].turn);
    if (turn < least_turn) return false;
    for (const int merge : merges)
      if (candidates_[merge].turn > turn - 1e-6) given_up_.insert({candidates_[merge].a, candidates_[merge].b});
    return true;
  }

  // Follows farther what nothing has stopped; at the greatest length it gets a cut across its way. False: all ended.
  bool lengthen() {
    bool any = false;
    for (size_t i = 0; i < contestants_.size(); ++i) {
      const int line = contestants_[i].unended;
      if (line < 0 || !covered_[i].whole()) continue;
      any = true;
      const double length = lines_[line].length();
      if (!lines_[line].is_limit_cycle && length < options_.max_length * d_ * (1 - 1e-9)) {
        trace::follow(evaluator_, lines_[line], nodes_, bounds(2 * length));
      } else {
        cut_across(lines_[line]);
        break;
      }
    }
    candidates_are_old_ = candidates_are_old_ || any;
    return any;
  }

  // From boundary to boundary across the end of a line.
  void cut_across(const trace::Streamline& line) {
    for (const double turn : {half_pi, -half_pi}) {
      const trace::Launch across =
          trace::launch_line(evaluator_, -1, line.end_position, line.end_angle + turn, 1e-6 * d_, 1);
      const trace::Streamline half = trace::advance(evaluator_, across, nodes_, bounds(options_.max_length * d_));
      if (half.end == trace::Streamline::End::boundary) return add_cut(half.curve, half.t, options_.max_length * d_);
    }
    const Vec2 at = line.end_position + face_.origin;
    throw ComputeError(
        fmt::format("no line leads from the limit cycle at ({:.6g}, {:.6g}) to the boundary", at.x, at.y));
  }

  void add_cut(int curve, double t, double head_start) {
    if (++num_cuts_ > max_cuts) throw ComputeError(fmt::format("more than {} cuts do not make a layout", max_cuts));
    launches_.push_back(trace::launch_from_boundary(evaluator_, curve, t));
    head_starts_.push_back(head_start);
    candidates_are_old_ = true;
    lines_.push_back(trace::advance(evaluator_, launches_.back(), nodes_, bounds(first_bound * d_)));
  }

  SeparatrixGraph clipped_graph() {
    std::vector<graph::FinishedLine> pieces;
    merge_of_line_.clear();
    std::vector<std::vector<int>> pieces_of(contestants_.size());
    for (size_t i = 0; i < contestants_.size(); ++i) {
      const auto add = [&](graph::FinishedLine piece) {
        pieces_of[i].push_back(static_cast<int>(pieces.size()));
        pieces.push_back(std::move(piece));
        merge_of_line_.push_back(contestants_[i].merge);
      };
      const graph::FinishedLine& line = contestants_[i].line;
      const Covered& part = covered_[i];
      if (part.whole()) {
        add(line);
        continue;
      }
      add({line.start, {}, curve::trimmed(line.spline, line.spline.begin(), part.first), line.kind});
      if (part.last < line.spline.end())
        add({{}, line.end, curve::trimmed(line.spline, part.last, line.spline.end()), line.kind});
    }
    const auto piece_at = [&](int i, double s) {
      for (const int p : pieces_of[i])
        if (s >= pieces[p].spline.begin() && s <= pieces[p].spline.end()) return p;
      return -1;
    };
    std::vector<graph::Crossing> kept;
    for (graph::Crossing c : crossings_) {
      c.a = piece_at(c.a, c.s), c.b = piece_at(c.b, c.t);
      if (c.a >= 0 && c.b >= 0) kept.push_back(c);
    }
    return graph::build_graph(face_, fixed_, pieces, kept, snap());
  }

  // Holes may be tied to each other and to nothing else: each of their cuts starts from another place, at halves,
  // quarters, eighths of the loop's curves in turn (van der Corput's sequence).
  void tie(int loop) {
    const int first = face_.loop_offsets[loop], num = face_.loop_offsets[loop + 1] - first;
    double share = 0, digit = 0.5;
    for (int k = num_ties_[loop]++; k > 0; k /= 2, digit /= 2) share += k % 2 * digit;
    const double along = share * num + 0.5, whole = std::floor(along);
    const int c = first + static_cast<int>(whole) % num;
    const Nurbs& curve = face_.curves[c];
    add_cut(c, curve.begin() + (along - whole) * (curve.end() - curve.begin()), 0);
  }

  // A hole that nothing ties to the outer boundary gets a cut, the first from the middle of its first curve.
  bool tie_lone_loops(const SeparatrixGraph& graph) {
    std::vector<int> root(graph.nodes.size());
    std::iota(root.begin(), root.end(), 0);
    const std::function<int(int)> find = [&](int n) { return root[n] == n ? n : root[n] = find(root[n]); };
    for (const GraphArc& arc : graph.arcs) root[find(arc.from)] = find(arc.to);
    std::vector<int> root_of_loop(face_.num_loops(), -1);
    for (size_t n = 0; n < graph.nodes.size(); ++n)
      if (graph.nodes[n].curve >= 0) root_of_loop[face_.loop_of(graph.nodes[n].curve)] = find(static_cast<int>(n));
    bool any = false;
    for (int loop = 1; loop < face_.num_loops(); ++loop) {
      if (root_of_loop[loop] == root_of_loop[0]) continue;
      tie(loop);
      any = true;
    }
    return any;
  }

  double snap() const { return snap_share * d_; }

  const field::FieldEvaluator& evaluator_;
  const CadFace& face_;
  double d_;
  trace::TraceOptions options_;
  std::vector<graph::FixedNode> fixed_;
  std::vector<trace::Launch> launches_;
  std::vector<double> head_starts_;
  std::vector<Vec2> nodes_;
  std::vector<trace::Streamline> lines_;
  std::map<graph::CurveKey, Nurbs> fitted_;
  std::vector<trace::MergeCandidate> candidates_;
  bool candidates_are_old_ = true;
  std::set<std::pair<int, int>> given_up_;  // pairs of lines that are not merged
  std::vector<Contestant> contestants_;
  graph::KnownCrossings known_crossings_;
  std::vector<graph::Crossing> crossings_;  // without those at common ends
  std::vector<Covered> covered_;
  std::vector<int> merge_of_line_;  // candidate of each line of the graph, or -1
  std::map<int, int> num_ties_;     // cuts that a loop has got
  int num_cuts_ = 0;
};

TMeshTracer::TMeshTracer(const field::FieldEvaluator& evaluator, const CriticalPoints& points,
                         const trace::TraceOptions& options)
    : impl_(std::make_unique<Impl>(evaluator, points, options)) {}

TMeshTracer::~TMeshTracer() = default;

SeparatrixGraph TMeshTracer::trace(Report& report) {
  SeparatrixGraph graph = impl_->run();
  graph.certificate.merged_lines = impl_->num_merged();
  graph.certificate.largest_deviation_degrees = degrees(impl_->largest_turn());
  report.set("t_mesh.launched", impl_->num_lines());
  report.set("t_mesh.merged", impl_->num_merged());
  report.set("t_mesh.stopped", impl_->num_stopped());
  report.set("t_mesh.cuts", impl_->num_cuts());
  report.set("t_mesh.arcs", graph.arcs.size());
  report.set("t_mesh.t_junctions", graph.t_junctions.size());
  for (const FaceCount& count : graph::face_census(graph))
    report.set(fmt::format("t_mesh.faces_of_{}_corners", count.corners), count.faces);
  return graph;
}

bool TMeshTracer::give_up_merge(const SeparatrixGraph& graph, const std::vector<int>& arcs) {
  return impl_->give_up_merge(graph, arcs);
}

}  // namespace quadrille::quantize
