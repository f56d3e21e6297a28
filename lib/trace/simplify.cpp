#include "trace/simplify.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "base/angle.hpp"
#include "trace/chord_collapse.hpp"
#include "trace/chord_judge.hpp"

namespace quadrille {
namespace {

constexpr double fit_share = 2e-9;  // of the diameter: as traced lines
constexpr double tie_share = 1e-6;

// A layout on its way, and what became of the arcs of the one that it was made from.
struct Trial {
  SeparatrixGraph graph;
  std::vector<int> arc2arc;
  std::vector<bool> is_changed;
  int num_blocks = 0;
  double turn = 0;
};

bool share_a_rail(const std::vector<ChordStrip>& strips) {
  std::set<int> rails;
  for (const ChordStrip& strip : strips)
    for (const std::vector<int>* darts : {&strip.left, &strip.right})
      for (const int d : *darts)
        if (!rails.insert(dart_arc(d)).second) return true;
  return false;
}

class Simplifier {
 public:
  Simplifier(const FieldEvaluator& evaluator, SeparatrixGraph graph, const SimplifyOptions& options)
      : evaluator_(evaluator), options_(options), graph_(std::move(graph)) {}

  // One group of equal chords; false where none can go.
  bool step() {
    const PlanarFaces faces = planar_faces(graph_);
    std::vector<ChordStrip> strips;
    for (ChordStrip& s : all_strips(graph_, faces, arc_lengths(graph_)))
      if (!pins_of(graph_, s).empty()) strips.push_back(std::move(s));
    std::stable_sort(strips.begin(), strips.end(),
                     [](const ChordStrip& a, const ChordStrip& b) { return a.slimness() < b.slimness(); });
    for (auto first = strips.begin(); first != strips.end();) {
      const double same = first->slimness() * (1 + tie_share);
      const auto last = std::find_if(first, strips.end(), [&](const ChordStrip& s) { return s.slimness() > same; });
      if (collapse_all({first, last}, faces)) return true;
      first = last;
    }
    return false;
  }

  SeparatrixGraph graph_without_leftovers() {
    drop_unused_splines(graph_);
    return std::move(graph_);
  }

  int num_collapsed() const { return num_collapsed_; }
  double turn() const { return turn_; }

 private:
  bool collapse_all(const std::vector<ChordStrip>& strips, const PlanarFaces& faces) {
    if (share_a_rail(strips)) return false;
    Trial trial{graph_, {}, std::vector<bool>(graph_.arcs.size(), false), static_cast<int>(faces.cycles.size()), 0};
    trial.arc2arc.resize(graph_.arcs.size());
    std::iota(trial.arc2arc.begin(), trial.arc2arc.end(), 0);
    for (const ChordStrip& strip : strips)
      if (!collapse_one(strip, trial)) return false;
    if (!is_good(trial, faces)) return false;
    graph_ = std::move(trial.graph);
    num_collapsed_ += static_cast<int>(strips.size());
    turn_ = std::max(turn_, trial.turn);
    return true;
  }

  // The strip as it is after the collapse of others that cross it, and with it the census of faces.
  bool collapse_one(const ChordStrip& old_strip, Trial& trial) const {
    int arc = -1;
    for (const int d : old_strip.rungs)
      if (arc < 0) arc = trial.arc2arc[dart_arc(d)];
    if (arc < 0) return false;
    const ChordStrip strip = strip_through(trial.graph, planar_faces(trial.graph), arc_lengths(trial.graph), arc);
    const std::vector<Pin> pins = pins_of(trial.graph, strip);
    if (pins.empty()) return false;
    auto collapse =
        collapse_strip(evaluator_, trial.graph, strip, pins, {options_.max_turn, fit_share * graph_.face.diameter});
    if (!collapse) return false;
    trial.num_blocks -= strip.num_blocks();
    const PlanarFaces faces = planar_faces(collapse->graph);
    if (static_cast<int>(faces.cycles.size()) != trial.num_blocks || faces.num_components != 1 ||
        !cycles_without_four_corners(faces).empty())
      return false;
    for (std::size_t a = 0; a < trial.is_changed.size(); ++a)
      if (trial.is_changed[a] && collapse->arc2arc[a] >= 0) collapse->is_changed[collapse->arc2arc[a]] = true;
    trial.is_changed = std::move(collapse->is_changed);
    for (int& a : trial.arc2arc)
      if (a >= 0) a = collapse->arc2arc[a];
    trial.graph = std::move(collapse->graph);
    trial.turn = std::max(trial.turn, collapse->turn);
    return true;
  }

  bool is_good(const Trial& trial, const PlanarFaces& faces) const {
    std::vector<bool> touched;
    for (const int a : trial.arc2arc) touched.push_back(a < 0 || trial.is_changed[a]);
    const PlanarFaces new_faces = planar_faces(trial.graph);
    const BlockShape after = worst_shape(trial.graph, new_faces, faces_beside(new_faces, trial.is_changed));
    if (!after.is_valid) return false;
    const BlockShape before = worst_shape(graph_, faces, faces_beside(faces, touched));
    const double slack = 1e-6;  // equal is good enough, whatever the rounding
    return after.least_angle >= std::min(before.least_angle, options_.least_angle) - slack &&
           after.greatest_angle <= std::max(before.greatest_angle, options_.greatest_angle) + slack &&
           after.least_scaled_jacobian >=
               std::min(before.least_scaled_jacobian, options_.least_scaled_jacobian) - slack;
  }

  const FieldEvaluator& evaluator_;
  const SimplifyOptions& options_;
  SeparatrixGraph graph_;
  int num_collapsed_ = 0;
  double turn_ = 0;
};

}  // namespace

SeparatrixGraph simplify(const FieldEvaluator& evaluator, SeparatrixGraph graph, const SimplifyOptions& options,
                         Report& report) {
  report.set("simplify.blocks_before", planar_faces(graph).cycles.size());
  Simplifier simplifier(evaluator, std::move(graph), options);
  while (simplifier.step()) {
  }
  report.set("simplify.collapsed", simplifier.num_collapsed());
  report.set("simplify.largest_turn_degrees", degrees(simplifier.turn()));
  return simplifier.graph_without_leftovers();
}

}  // namespace quadrille
