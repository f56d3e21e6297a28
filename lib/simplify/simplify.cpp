#include "simplify/simplify.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "base/angle.hpp"
#include "simplify/chord_collapse.hpp"
#include "simplify/chord_judge.hpp"
#include "simplify/chord_shortcut.hpp"

namespace quadrille::simplify {
namespace {

constexpr double fit_share = 2e-9;  // of the diameter: as traced lines
constexpr double tie_share = 1e-6;

// A layout on its way, and what became of the arcs of the one that it was made from.
struct Trial {
  SeparatrixGraph graph;
  std::vector<int> arc2arc;
  std::vector<bool> is_changed;
  int num_blocks = 0;
};

bool share_a_rail(const std::vector<graph::ChordStrip>& strips) {
  std::set<int> rails;
  for (const graph::ChordStrip& strip : strips)
    for (const std::vector<HalfEdge>* half_edges : {&strip.left, &strip.right})
      for (const HalfEdge d : *half_edges)
        if (!rails.insert(d.arc).second) return true;
  return false;
}

// The pieces of all arcs of some strips.
std::vector<double> key_of(const SeparatrixGraph& graph, const std::vector<graph::ChordStrip>& strips) {
  std::vector<std::vector<double>> keys;
  for (const graph::ChordStrip& strip : strips) {
    keys.emplace_back();
    for (const std::vector<HalfEdge>* half_edges : {&strip.rungs, &strip.left, &strip.right})
      for (const HalfEdge d : *half_edges)
        for (const ArcPiece& p : graph.arcs[d.arc].pieces)
          keys.back().insert(keys.back().end(), {static_cast<double>(p.curve), p.t0, p.t1});
    std::sort(keys.back().begin(), keys.back().end());
  }
  std::sort(keys.begin(), keys.end());
  std::vector<double> key;
  for (const std::vector<double>& k : keys) key.insert(key.end(), k.begin(), k.end());
  return key;
}

std::vector<int> all_of(const graph::PlanarFaces& faces) {
  std::vector<int> all(faces.cycles.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

class Simplifier {
 public:
  Simplifier(const field::FieldEvaluator& evaluator, SeparatrixGraph graph, const SimplifyOptions& options)
      : evaluator_(evaluator), options_(options), graph_(std::move(graph)) {}

  // One group of equal chords; false where none can go.
  bool step() {
    const graph::PlanarFaces faces = graph::planar_faces(graph_);
    std::vector<graph::ChordStrip> strips;
    for (graph::ChordStrip& s : graph::all_strips(graph_, faces, graph::arc_lengths(graph_, lengths_)))
      if (!graph::pins_of(graph_, s).empty()) strips.push_back(std::move(s));
    std::stable_sort(strips.begin(), strips.end(), [](const graph::ChordStrip& a, const graph::ChordStrip& b) {
      return a.slimness() < b.slimness();
    });
    for (auto first = strips.begin(); first != strips.end();) {
      const double same = first->slimness() * (1 + tie_share);
      const auto last =
          std::find_if(first, strips.end(), [&](const graph::ChordStrip& s) { return s.slimness() > same; });
      const std::vector<graph::ChordStrip> group(first, last);
      std::vector<double> key = key_of(graph_, group);
      if (refused_.count(key) == 0) {
        if (collapse_all(group, faces)) return true;
        refused_.insert(std::move(key));
      }
      first = last;
    }
    return false;
  }

  // The same for laps.
  bool step_across_laps() {
    const graph::PlanarFaces faces = graph::planar_faces(graph_);
    std::vector<Shortcut> shortcuts = find_shortcuts(graph_, faces, graph::arc_lengths(graph_, lengths_));
    std::stable_sort(shortcuts.begin(), shortcuts.end(),
                     [](const Shortcut& a, const Shortcut& b) { return a.slimness < b.slimness; });
    for (auto first = shortcuts.begin(); first != shortcuts.end();) {
      const double same = first->slimness * (1 + tie_share);
      const auto last = std::find_if(first, shortcuts.end(), [&](const Shortcut& s) { return s.slimness > same; });
      if (take_all({first, last}, faces)) return true;
      first = last;
    }
    return false;
  }

  SeparatrixGraph graph_without_leftovers() {
    drop_unused_splines(graph_);
    return std::move(graph_);
  }

  int num_collapsed() const { return num_collapsed_; }
  int num_shortcuts() const { return num_shortcuts_; }
  double turn() const { return turn_; }

 private:
  bool collapse_all(const std::vector<graph::ChordStrip>& strips, const graph::PlanarFaces& faces) {
    if (share_a_rail(strips)) return false;
    Trial trial{graph_, {}, std::vector<bool>(graph_.arcs.size(), false), static_cast<int>(faces.cycles.size())};
    trial.arc2arc.resize(graph_.arcs.size());
    std::iota(trial.arc2arc.begin(), trial.arc2arc.end(), 0);
    std::vector<Blend> blends;
    for (const graph::ChordStrip& strip : strips) {
      auto own = blends_of(evaluator_, graph_, strip, graph::pins_of(graph_, strip), blend_options());
      if (!own) return false;
      for (Blend& b : *own) blends.push_back(std::move(b));
    }
    for (const graph::ChordStrip& strip : strips)
      if (!collapse_one(strip, blends, trial)) return false;
    if (!is_good(trial, faces)) return false;
    graph_ = std::move(trial.graph);
    num_collapsed_ += static_cast<int>(strips.size());
    for (const Blend& b : blends) turn_ = std::max(turn_, b.turn);
    return true;
  }

  // The strip as it is after the collapse of others that cross it, and with it the census of faces.
  bool collapse_one(const graph::ChordStrip& old_strip, const std::vector<Blend>& blends, Trial& trial) const {
    int arc = -1;
    for (const HalfEdge d : old_strip.rungs)
      if (arc < 0) arc = trial.arc2arc[d.arc];
    if (arc < 0) return false;
    const graph::ChordStrip strip = graph::strip_through(trial.graph, graph::planar_faces(trial.graph), arc);
    const std::vector<graph::Pin> pins = graph::pins_of(trial.graph, strip);
    if (pins.empty()) return false;
    auto collapse = collapse_strip(trial.graph, strip, pins, blends);
    if (!collapse) return false;
    trial.num_blocks -= strip.num_blocks();
    const graph::PlanarFaces faces = graph::planar_faces(collapse->graph);
    if (static_cast<int>(faces.cycles.size()) != trial.num_blocks || faces.num_components != 1 ||
        !graph::cycles_without_four_corners(faces).empty())
      return false;
    for (std::size_t a = 0; a < trial.is_changed.size(); ++a)
      if (trial.is_changed[a] && collapse->arc2arc[a] >= 0) collapse->is_changed[collapse->arc2arc[a]] = true;
    trial.is_changed = std::move(collapse->is_changed);
    for (int& a : trial.arc2arc)
      if (a >= 0) a = collapse->arc2arc[a];
    trial.graph = std::move(collapse->graph);
    return true;
  }

  bool is_good(const Trial& trial, const graph::PlanarFaces& faces) const {
    std::vector<bool> touched;
    for (const int a : trial.arc2arc) touched.push_back(a < 0 || trial.is_changed[a]);
    const graph::PlanarFaces new_faces = graph::planar_faces(trial.graph);
    const BlockShape after = worst_shape(trial.graph, new_faces, faces_beside(new_faces, trial.is_changed));
    const BlockShape before = worst_shape(graph_, faces, faces_beside(faces, touched));
    return is_better(before, after, new_faces.cycles.size(), faces.cycles.size());
  }

  // What blocks lose in shape must be worth the number of them that it saves.
  bool is_better(const BlockShape& before, const BlockShape& after, std::size_t num_after,
                 std::size_t num_before) const {
    if (!after.is_valid) return false;
    const double slack = 1e-6;  // equal is good enough, whatever the rounding
    const double share = options_.is_thrifty ? static_cast<double>(num_after) / static_cast<double>(num_before) : 0;
    const double least = std::max(options_.least_scaled_jacobian, share * before.least_scaled_jacobian);
    return after.least_angle >= std::min(before.least_angle, options_.least_angle) - slack &&
           after.greatest_angle <= std::max(before.greatest_angle, options_.greatest_angle) + slack &&
           after.least_scaled_jacobian >= std::min(before.least_scaled_jacobian, least) - slack;
  }

  bool take_all(const std::vector<Shortcut>& shortcuts, const graph::PlanarFaces& faces) {
    std::map<int, Blend> line2blend;
    for (const Shortcut& s : shortcuts) {
      auto blend = blend_of(evaluator_, graph_, s, blend_options());
      if (!blend || !line2blend.emplace(s.spline, std::move(*blend)).second) return false;
    }
    SeparatrixGraph graph = graph_;
    for (const auto& [line, blend] : line2blend)
      if (!take_one(line, blend, graph)) return false;
    const graph::PlanarFaces new_faces = graph::planar_faces(graph);
    if (!is_better(worst_shape(graph_, faces, all_of(faces)), worst_shape(graph, new_faces, all_of(new_faces)),
                   new_faces.cycles.size(), faces.cycles.size()))
      return false;
    graph_ = std::move(graph);
    num_shortcuts_ += static_cast<int>(shortcuts.size());
    for (const auto& [line, blend] : line2blend) turn_ = std::max(turn_, blend.turn);
    return true;
  }

  // The shortcut of a line as it is after others; splines keep their numbers.
  static bool take_one(int line, const Blend& blend, SeparatrixGraph& graph) {
    const graph::PlanarFaces faces = graph::planar_faces(graph);
    const std::vector<Shortcut> now = find_shortcuts(graph, faces, graph::arc_lengths(graph));
    const auto found = std::find_if(now.begin(), now.end(), [&](const Shortcut& s) { return s.spline == line; });
    if (found == now.end()) return false;
    auto result = take_shortcut(graph, *found, blend);
    if (!result) return false;
    const graph::PlanarFaces new_faces = graph::planar_faces(*result);
    if (new_faces.cycles.size() >= faces.cycles.size() || new_faces.num_components != 1 ||
        !graph::cycles_without_four_corners(new_faces).empty())
      return false;
    graph = std::move(*result);
    return true;
  }

  BlendOptions blend_options() const { return {options_.max_turn, fit_share * graph_.face.diameter}; }

  const field::FieldEvaluator& evaluator_;
  const SimplifyOptions& options_;
  SeparatrixGraph graph_;
  graph::PieceLengths lengths_;
  std::set<std::vector<double>> refused_;  // groups that were tried, by their arcs: other steps leave most as they are
  int num_shortcuts_ = 0;
  int num_collapsed_ = 0;
  double turn_ = 0;
};

double least_scaled_jacobian(const SeparatrixGraph& graph, const graph::PlanarFaces& faces) {
  return worst_shape(graph, faces, all_of(faces)).least_scaled_jacobian;
}

}  // namespace

SeparatrixGraph simplify(const field::FieldEvaluator& evaluator, SeparatrixGraph graph, const SimplifyOptions& options,
                         Report& report) {
  const graph::PlanarFaces faces = graph::planar_faces(graph);
  double least = least_scaled_jacobian(graph, faces);
  report.set("simplify.blocks_before", faces.cycles.size());
  report.set("simplify.least_scaled_jacobian_before", least);
  Simplifier simplifier(evaluator, std::move(graph), options);
  while (simplifier.step() || simplifier.step_across_laps()) {
  }
  report.set("simplify.collapsed", simplifier.num_collapsed());
  report.set("simplify.laps_cut", simplifier.num_shortcuts());
  report.set("simplify.laps_cut", simplifier.num_shortcuts());
  report.set("simplify.shortened_spirals", simplifier.num_shortcuts());
  report.set("simplify.largest_turn_degrees", degrees(simplifier.turn()));
  report.set("simplify.largest_turn_degrees", degrees(simplifier.turn()));
  report.set("simplify.largest_deviation_degrees", degrees(simplifier.turn()));
  const bool is_changed = simplifier.num_collapsed() + simplifier.num_shortcuts() > 0;
  graph = simplifier.graph_without_leftovers();
  if (is_changed) least = least_scaled_jacobian(graph, graph::planar_faces(graph));
  report.set("simplify.least_scaled_jacobian", least);
  LayoutCertificate& certificate = graph.certificate;
  certificate.collapsed_chords += simplifier.num_collapsed();
  certificate.shortened_spirals += simplifier.num_shortcuts();
  certificate.largest_deviation_degrees = std::max(certificate.largest_deviation_degrees, degrees(simplifier.turn()));
  return graph;
}

}  // namespace quadrille::simplify
