#pragma once
// The numbered rules of a format: a table of small functions. Private to check.
//
// FORMAT_check.cpp defines violations_of(const Model&, CheckDepth) and instantiates check_stage of its struct:
//   template std::vector<Violation> check_stage(const QuadMesh&, CheckDepth);

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/message_text.hpp"
#include "base/vec2.hpp"
#include "base/vec3.hpp"
#include "check/check.hpp"
#include "surface/positions.hpp"

namespace quadrille::check {

/// The violations of one rule: the first five, and the number of the others.
class Findings {
 public:
  explicit Findings(const char* rule) : rule_(rule) {}
  template <typename... Args>
  void add(fmt::format_string<Args...> text, Args&&... args) {
    if (++count_ <= 5) list_.push_back({rule_, fmt::format(text, std::forward<Args>(args)...)});
  }
  bool is_empty() const { return count_ == 0; }
  std::vector<Violation> take() {
    if (count_ > 5) list_.push_back({rule_, fmt::format("and {} more violations", count_ - 5)});
    return std::move(list_);
  }

 private:
  const char* rule_;
  std::size_t count_ = 0;
  std::vector<Violation> list_;
};

/// structure: later rules would read out of bounds, so checking ends there; quick: checked by every stage;
/// full: checked by stagecheck only.
enum class RuleKind { structure, quick, full };

template <typename Stage>
struct Rule {
  const char* id;
  RuleKind kind;
  void (*check)(const Stage&, Findings&);
};

template <typename Stage, std::size_t N>
std::vector<Violation> apply_rules(const Rule<Stage> (&rules)[N], const Stage& stage, CheckDepth depth) {
  std::vector<Violation> all;
  for (const Rule<Stage>& rule : rules) {
    if (rule.kind == RuleKind::full && depth == CheckDepth::quick) continue;
    Findings findings(rule.id);
    rule.check(stage, findings);
    const bool is_broken = !findings.is_empty();
    for (Violation& violation : findings.take()) all.push_back(std::move(violation));
    if (is_broken && rule.kind == RuleKind::structure) break;
  }
  return all;
}

template <typename Model>
std::vector<Violation> check_stage(const Model& model, CheckDepth depth) {
  return violations_of(model, depth);
}
/// Of what other structs contain.
std::vector<Violation> violations_of(const CadFace& face, CheckDepth depth);
/// Of the chart of a sound curved face; none of a planar one.
std::vector<Violation> chart_violations(const CadFace& face, CheckDepth depth);
std::vector<Violation> violations_of(const TriMesh& mesh, CheckDepth depth);
std::vector<Violation> violations_of(const HexMesh& mesh, CheckDepth depth);

/// The violations found in `part`, a member of the stage's struct; without any, the violations of `rules`.
template <typename Part, typename Stage, std::size_t N>
std::vector<Violation> apply_rules_after(const Part& part, const Rule<Stage> (&rules)[N], const Stage& stage,
                                         CheckDepth depth) {
  std::vector<Violation> all = violations_of(part, depth);
  return all.empty() ? apply_rules(rules, stage, depth) : all;
}

/// Curves of STEP files meet within the tolerance of their vertices; a larger distance is a gap in the outline.
/// Relative to the diameter.
inline constexpr double gap_tol = 1e-5;

// Of curves.

/// Empty if the arrays of the curve are consistent, else what is wrong (formats/cad-face.md: clamped, never periodic).
std::string structure_fault(const Nurbs& curve);
/// Empty if all numbers of the curve are finite, else a message such as "pole 3 is not finite".
std::string number_fault(const Nurbs& curve);
/// Whether a pole lies so far outside (1000 diameters from the face's first joint) that arithmetic on the curve loses
/// its digits.
bool has_far_pole(const Nurbs& curve, const CadFace& face);

// Rules common to separatrix graphs and block layouts: of their splines, nodes and arcs.

void splines_are_sound(const ArcGraph& graph, Findings& findings);
void graph_indices_exist(const ArcGraph& graph, Findings& findings);
void pieces_are_sound(const ArcGraph& graph, Findings& findings);
void arcs_are_chains(const ArcGraph& graph, Findings& findings);
void boundary_is_covered(const ArcGraph& graph, Findings& findings);
void node_kinds_fit(const ArcGraph& graph, Findings& findings);

// Rules of quad meshes.

/// The proofs of elements, repeated.
void jacobians_are_as_stored(const QuadMesh& mesh, Findings& findings);
void boundary_is_on_curves_in_space(const QuadMesh& mesh, Findings& findings);

inline bool is_finite(double x) { return std::isfinite(x); }
inline bool is_finite(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }
inline bool is_finite(Vec2 p) { return std::isfinite(p.x) && std::isfinite(p.y); }
template <typename T>
bool are_finite(const std::vector<T>& values) {
  for (const T& value : values)
    if (!is_finite(value)) return false;
  return true;
}
inline bool is_index(int i, std::size_t count) { return i >= 0 && static_cast<std::size_t>(i) < count; }
/// Whether `list` is ascending, without repetitions, and all entries are indices below `count`.
inline bool are_ascending_indices(const std::vector<int>& list, std::size_t count) {
  for (std::size_t k = 0; k < list.size(); ++k)
    if (!is_index(list[k], count) || (k > 0 && list[k] <= list[k - 1])) return false;
  return true;
}
/// Whether `offsets` climbs strictly from 0 to `count`.
inline bool are_offsets(const std::vector<int>& offsets, int count) {
  return offsets.size() >= 2 && offsets.front() == 0 && offsets.back() == count &&
         std::adjacent_find(offsets.begin(), offsets.end(), std::greater_equal<>()) == offsets.end();
}
/// By curve: whether its interface is open. Adds a finding, and returns no entries, unless `open_curves` are curves
/// with partners, each with its partner, in ascending order.
inline std::vector<bool> open_interfaces(const CadFace& face, const std::vector<int>& open_curves, Findings& findings) {
  std::vector<bool> is_open(face.curves.size(), false);
  bool is_sound = are_ascending_indices(open_curves, is_open.size());
  for (std::size_t i = 0; is_sound && i < open_curves.size(); ++i) is_open[open_curves[i]] = true;
  for (std::size_t i = 0; is_sound && i < open_curves.size(); ++i)
    is_sound = face.is_interface(open_curves[i]) && is_open[face.partners[open_curves[i]]];
  if (is_sound) return is_open;
  findings.add("open_curves must be curves of interfaces, those of both sides, in ascending order");
  return {};
}
/// Whether a slit ends in the joint, so that its curve runs back along the one before it. The face must be sound.
inline bool is_slit_tip(const CadFace& face, int joint) {
  return is_index(joint, face.partners.size()) && face.partners[joint] == face.previous_in_loop(joint);
}
using surface::position_text;

}  // namespace quadrille::check
