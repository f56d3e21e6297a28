#include "ties/choose_at_ties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "guide/resolve_clusters.hpp"
#include "placement/node_ledger.hpp"
#include "surface/positions.hpp"
#include "ties/choice_cost.hpp"
#include "ties/choice_search.hpp"

namespace quadrille::ties {
namespace {

constexpr std::size_t max_compared_orbits = 4;  // of which all choices are compared

/// Follows choices to their nodes and what these cost. Each is tried once.
class Trials {
 public:
  Trials(const field::FieldEvaluator& field, const TieOrbits& ties, const PartSolver& solve, const TieOptions& options,
         Progress* progress)
      : face_(field.field().mesh.face),
        group_(curve::symmetries(face_)),
        ties_(ties),
        options_(options),
        tilted_(field.field(), ties, solve),
        search_(tilted_, options.search.noise),
        measure_(field, ties),
        part_(progress, "choices") {}

  /// Null if the choice leads to no admissible set of nodes. With many orbits the result is what is no better than
  /// `best`, if that is the least that the choice can cost, or what the nodes cost that Newton's method finds: then
  /// they are enough for the index sum, and a search can find no other than pairs of opposite index.
  const Cost* of(const Choice& choice, const Cost* best = nullptr) {
    const auto known = costs_.find(choice);
    if (known != costs_.end()) return known->second ? &*known->second : nullptr;
    std::optional<Cost>& cost = costs_[choice];
    if (best && are_many()) {
      cost = least(choice);
      if (!is_better(*cost, *best)) return &*cost;
      part_.advance();
      cost = cost_of(choice, &ChoiceSearch::likely_zeros_of);
      if (cost && !is_better(*cost, *best)) return &*cost;
    }
    ++num_searches_;
    cost = cost_of(choice, &ChoiceSearch::zeros_of);
    part_.advance();
    return cost ? &*cost : nullptr;
  }
  /// The position of the choice that can cost least; the first, unless there are many orbits.
  std::ptrdiff_t most_promising(const std::vector<Choice>& choices) const {
    if (!are_many()) return 0;
    std::vector<Cost> costs;
    for (const Choice& choice : choices) costs.push_back(least(choice));
    return std::min_element(costs.begin(), costs.end(), is_better) - costs.begin();
  }
  /// Null if the choice was not tried, or leads to no admissible set of nodes.
  const Cost* known(const Choice& choice) const {
    const auto found = costs_.find(choice);
    return found != costs_.end() && found->second ? &*found->second : nullptr;
  }
  /// The last choice is the best so far.
  void keep_last() { search_.keep_last(); }
  std::size_t count() const { return num_searches_; }

  /// The nodes of a choice by a search of all elements, which proves that no zero is missing. No trial may follow.
  CriticalPoints proved(const Choice& choice, Report& report) {
    tilted_.forget_parts();
    const Field field = tilted_.solved(choice);
    CriticalPoints points =
        guide::find_critical_points(field::FieldEvaluator(field), options_.search, valences(choice), report);
    guide::resolve_clusters(face_, group_, options_.max_valence, points);
    return points;
  }

 private:
  guide::CornerValences valences(const Choice& choice) const {
    guide::CornerValences result = guide::corner_valences_by_angle(face_);
    const auto set = [&](const Tie& tie, int valence) {
      for (Corner& corner : result.corners)
        if (corner.joint == tie.joint) corner.valence = valence, corner.source = NodeSource::line;
    };
    for (const Tie& tie : ties_.ties) set(tie, tie.smaller + 1);
    for (std::size_t u = 0; u < choice.size(); ++u)
      for (const int t : ties_.units[u])
        if (choice[u]) set(ties_.ties[t], ties_.ties[t].smaller);
    return result;
  }

  bool are_many() const { return ties_.orbits.size() > max_compared_orbits; }

  /// At least what the choice costs, if no other corner absorbs a node.
  Cost least(const Choice& choice) const {
    CriticalPoints points;
    points.corners = valences(choice).corners;
    return measure_.least(choice, 4 * face_.euler_characteristic() - index_sum_of(points), options_.max_valence);
  }

  /// Nothing if the zeros make no admissible set of nodes, or are not found.
  std::optional<Cost> cost_of(const Choice& choice, zeros::SearchResult (ChoiceSearch::*zeros_of)(const Choice&)) {
    try {
      Report of_this_choice;
      const zeros::SearchResult found = (search_.*zeros_of)(choice);
      CriticalPoints points =
          guide::find_critical_points(tilted_.with(choice), options_.search, valences(choice), found, of_this_choice);
      guide::resolve_clusters(face_, group_, options_.max_valence, points);
      if (points.index_sum != points.index_sum_expected) return {};
      return measure_(choice, points);
    } catch (const ComputeError&) {
      return {};
    }
  }

  const CadFace& face_;
  std::vector<curve::Isometry> group_;
  const TieOrbits& ties_;
  TieOptions options_;
  TiltedField tilted_;
  ChoiceSearch search_;
  CostMeasure measure_;
  std::map<Choice, std::optional<Cost>> costs_;
  std::size_t num_searches_ = 0;
  Progress::Part part_;
};

/// The search for the best choice.
class Chooser {
 public:
  Chooser(const CadFace& face, const TieOrbits& ties, Trials& trials)
      : face_(face), ties_(ties), trials_(trials), best_(ties.units.size(), false) {}

  Choice run() {
    const std::vector<std::vector<int>> sets = compared_sets();
    trials_.of(best_);
    trials_.keep_last();
    for (int sweep = 0; sweep < 3 && improve(sets); ++sweep) continue;
    halve();
    return best_;
  }

 private:
  /// Sets of orbits whose choices are compared with each other.
  std::vector<std::vector<int>> compared_sets() const {
    std::vector<std::vector<int>> sets;
    if (ties_.orbits.size() <= max_compared_orbits) {
      sets.emplace_back();
      for (std::size_t o = 0; o < ties_.orbits.size(); ++o) sets.back().push_back(static_cast<int>(o));
      return sets;
    }
    sets = chamfers(face_, ties_);
    std::vector<bool> is_paired(ties_.orbits.size(), false);
    for (const std::vector<int>& pair : sets)
      for (const int o : pair) is_paired[o] = true;
    for (std::size_t o = 0; o < is_paired.size(); ++o)
      if (!is_paired[o]) sets.push_back({static_cast<int>(o)});
    return sets;
  }

  /// Whether `choice` is better than the best so far; it then becomes the best.
  bool replace_if_better(const Choice& choice) {
    const Cost *now = trials_.of(best_), *then = trials_.of(choice, now);
    if (!then || (now && !is_better(*then, *now))) return false;
    best_ = choice;
    trials_.keep_last();
    return true;
  }

  Choice with_orbit(Choice choice, int orbit, bool is_smaller) const {
    for (const int u : ties_.orbits[orbit]) choice[u] = is_smaller;
    return choice;
  }

  bool improve(const std::vector<std::vector<int>>& sets) {
    const Choice before = best_;
    for (const std::vector<int>& set : sets) {
      std::vector<Choice> choices(std::size_t{1} << set.size(), best_);
      for (std::size_t bits = 0; bits < choices.size(); ++bits)
        for (std::size_t i = 0; i < set.size(); ++i) choices[bits] = with_orbit(choices[bits], set[i], bits >> i & 1U);
      while (!choices.empty()) {
        const auto next = choices.begin() + trials_.most_promising(choices);
        replace_if_better(*next);
        choices.erase(next);
      }
    }
    return best_ != before && sets.size() > 1;
  }

  /// Allows mirror images to differ where a node would lie too close to the boundary or to another node.
  void halve() {
    for (const std::vector<int>& orbit : ties_.orbits) {
      const Cost* now = trials_.of(best_);
      if (orbit.size() < 2 || (now && (*now)[static_cast<std::size_t>(Criterion::crowded)] == 0)) continue;
      for (const bool is_first : {true, false}) {
        Choice choice = best_;
        choice[orbit[0]] = is_first;
        choice[orbit[1]] = !is_first;
        replace_if_better(choice);
      }
    }
  }

  const CadFace& face_;
  const TieOrbits& ties_;
  Trials& trials_;
  Choice best_;
};

/// Why a unit has its valence: what would be worse with the other one.
std::string reason(const Choice& choice, const TieOrbits& ties, const Trials& trials, std::size_t unit) {
  Choice other = choice;
  for (const int u : ties.orbits[ties.unit2orbit[unit]]) other[u] = !choice[u];
  const Cost *chosen = trials.known(choice), *instead = trials.known(other);
  if (!instead) return "by rule";
  const auto criterion = difference(*chosen, *instead);
  return criterion ? "because " + text_of(*criterion) : "because it comes first in the file";
}

std::string corners_text(std::size_t count) { return count == 1 ? "one corner" : fmt::format("{} corners", count); }

std::vector<placement::NodeEdit> edits_of(const Choice& choice, const TieOrbits& ties, const Trials& trials) {
  std::vector<placement::NodeEdit> edits;
  for (std::size_t u = 0; u < choice.size(); ++u) {
    const Tie& first = ties.ties[ties.units[u].front()];
    placement::NodeEdit edit;
    edit.kind = ChangeKind::line;
    edit.reason =
        fmt::format("{} near {:g} degrees, where the field does not decide between two valences: valence {}, {}",
                    corners_text(ties.units[u].size()), degrees(first.angle), first.smaller + (choice[u] ? 0 : 1),
                    reason(choice, ties, trials, u));
    for (const int t : ties.units[u]) edit.corners.push_back({ties.ties[t].joint, first.smaller + (choice[u] ? 0 : 1)});
    edits.push_back(edit);
  }
  return edits;
}

void warn_of_halves(const CadFace& face, const Choice& choice, const TieOrbits& ties, Report& report) {
  for (const std::vector<int>& orbit : ties.orbits) {
    if (choice[orbit.front()] == choice[orbit.back()]) continue;
    const int joint = ties.ties[ties.units[orbit.front()].front()].joint;
    report.warn(
        warning::mirror_images_differ,
        fmt::format("the chamfer at {} is too small for a node: corners that are mirror images of each other get "
                    "different valences there, and the mesh is not symmetric; suppress the chamfer, or choose "
                    "with --corner-valence",
                    surface::position_text(face, face.joints[joint].position)));
  }
}

}  // namespace

CriticalPoints choose_at_ties(const field::FieldEvaluator& field, const TieOrbits& ties, const PartSolver& solve,
                              const TieOptions& options, Report& report) {
  options.search.validate();
  const CadFace& face = field.field().mesh.face;
  Trials trials(field, ties, solve, options, report.progress());
  const Choice choice = Chooser(face, ties, trials).run();
  report.set("ties.corners", ties.ties.size());
  report.set("ties.orbits", ties.orbits.size());
  report.set("ties.searches", trials.count());
  if (!trials.of(choice))
    throw ComputeError(fmt::format("no choice of valences at {} near 45, 135, 225 or 315 degrees leads to nodes",
                                   corners_text(ties.ties.size())));
  warn_of_halves(face, choice, ties, report);
  CriticalPoints points = trials.proved(choice, report);
  points.form = NodeForm::phase;  // the data are tilted, at corners without a choice too
  placement::apply(edits_of(choice, ties, trials), points);
  return points;
}

}  // namespace quadrille::ties
