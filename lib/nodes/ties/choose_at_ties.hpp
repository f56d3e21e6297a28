#pragma once
// Nodes and valences of a face with ties (lib/method.md §3): the valences at ties are chosen by rule, and the nodes are
// the zeros of the field that is tilted accordingly.

#include "base/enum_names.hpp"
#include "base/report.hpp"
#include "guide/find_critical_points.hpp"
#include "ties/tilted_field.hpp"

namespace quadrille::ties {

/// Treatment of corners near a tie: their valences are chosen, or they are those of the field.
enum class TiePolicy { choose, field };
constexpr auto enum_names(TiePolicy) { return std::to_array({"choose", "field"}); }

struct TieOptions {
  guide::SearchOptions search;
  int max_valence = 6;
};

/// `ties` must not be empty. Of the choices that satisfy the index sum the one of least cost (ties/choice_cost). Orbits
/// are decided as a whole; only if a node then lies too close to the boundary or to another node, mirror images may
/// differ (W-NODE-001). Up to four orbits all choices are compared; of more, those of each chamfer in turn. Clusters
/// are resolved; the form is `phase`, and each tie is recorded as a change of the kind `line`. Report: ties.{corners,
/// orbits, searches}. Throws ComputeError if no choice has zeros that can be isolated.
CriticalPoints choose_at_ties(const field::FieldEvaluator& field, const TieOrbits& ties, const PartSolver& solve,
                              const TieOptions& options, Report& report);

}  // namespace quadrille::ties
