#include "guide/override_corners.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/tolerance.hpp"
#include "curve/face_boundary.hpp"
#include "guide/valence.hpp"
#include "placement/node_ledger.hpp"
#include "surface/positions.hpp"

namespace quadrille::guide {
namespace {

std::optional<int> whole_number(const std::string& text) {
  const std::optional<int> value = number_of<int>(text);
  return value && *value >= 0 ? value : std::nullopt;
}

std::string name_of(const CadFace& face, const Corner& c) {
  return fmt::format("the corner of {:.6g} degrees at {}, between curves {} and {},", c.angle_degrees,
                     surface::position_text(face, c.position), c.curves[0], c.curves[1]);
}

[[noreturn]] void refuse_curves(const CadFace& face, const CornerOverride& o) {
  const auto exists = [&](int curve) { return curve >= 0 && curve < face.num_curves(); };
  const auto leads_to = [&](int a, int b) { return exists(a) && exists(b) && face.next_in_loop(a) == b; };
  std::string why = "they do not meet";
  if (!exists(o.curve_a) || !exists(o.curve_b))
    why = fmt::format("the face has curves 0 to {}", face.num_curves() - 1);
  else if (leads_to(o.curve_a, o.curve_b) || leads_to(o.curve_b, o.curve_a))
    why = "they meet smoothly";
  throw UsageError(fmt::format("no corner between curves {} and {}: {}", o.curve_a, o.curve_b, why));
}

[[noreturn]] void refuse_valence(const CadFace& face, const Corner& c, int valence) {
  std::string admissible;
  for (int v = 0; v <= greatest_corner_valence; ++v)
    if (is_admissible_valence(c.angle_degrees, v)) admissible += fmt::format("{}{}", admissible.empty() ? "" : ", ", v);
  const std::string blocks =
      valence > 0 && valence <= greatest_corner_valence
          ? fmt::format("its blocks would have {:.6g} degrees there, not 15 to 165", c.angle_degrees / valence)
          : fmt::format("corner valences are 0 to {}", greatest_corner_valence);
  throw UsageError(
      fmt::format("{} cannot have valence {}: {}; admissible are {}", name_of(face, c), valence, blocks, admissible));
}

std::size_t find_corner(const CadFace& face, const CornerOverride& o, const std::vector<Corner>& corners) {
  for (const std::array<int, 2>& curves : {std::array{o.curve_a, o.curve_b}, std::array{o.curve_b, o.curve_a}})
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (corners[i].curves == curves) return i;
  refuse_curves(face, o);
}

/// A corner whose valence changes.
struct Demand {
  std::size_t corner;
  int valence;                       ///< prescribed
  int index;                         ///< to be added by the nodes inside
  std::vector<std::size_t> removed;  ///< nodes of the opposite index
  std::vector<NodeMark> added;
};

std::vector<Demand> demands_of(const CadFace& face, const std::vector<CornerOverride>& overrides,
                               const std::vector<Corner>& corners) {
  std::vector<Demand> demands;
  for (const CornerOverride& o : overrides) {
    const std::size_t i = find_corner(face, o, corners);
    if (!is_admissible_valence(corners[i].angle_degrees, o.valence)) refuse_valence(face, corners[i], o.valence);
    const auto known = std::find_if(demands.begin(), demands.end(), [&](const Demand& d) { return d.corner == i; });
    if (known == demands.end())
      demands.push_back({i, o.valence, o.valence - corners[i].valence, {}, {}});
    else if (known->valence != o.valence)
      throw UsageError(
          fmt::format("{} cannot have both valence {} and {}", name_of(face, corners[i]), known->valence, o.valence));
  }
  std::erase_if(demands, [](const Demand& d) { return d.index == 0; });
  return demands;
}

/// `radius`, reduced in steps of a fifth as long as a node is near one of the points at that radius.
double free_radius(const CriticalPoints& points, Vec2 corner, const std::vector<Vec2>& directions, double radius) {
  const auto is_taken = [&](double r) {
    for (const Vec2 direction : directions)
      for (const CriticalPoint& p : points.critical_points)
        if (distance(p.position, corner + r * direction) < 0.1 * r) return true;
    return false;
  };
  for (int i = 0; i < 20 && is_taken(radius); ++i) radius *= 0.8;
  return radius;
}

/// The nodes still missing after those of d.removed are removed: at equal angles in the corner's sector.
std::vector<NodeMark> added_nodes(const CadFace& face, const CriticalPoints& points, const Demand& d) {
  const int n = std::abs(d.index) - static_cast<int>(d.removed.size());
  const Joint& joint = face.joints[points.corners[d.corner].joint];
  std::vector<Vec2> directions;
  const curve::FaceBoundary boundary(face);
  double clearance = INFINITY;
  for (int k = 1; k <= n; ++k) {
    directions.push_back(unit(joint.tangent_out + joint.interior_angle * k / (n + 1)));
    const double start = tolerance::same_point * face.diameter;  // away from the corner itself
    clearance =
        std::min(clearance, boundary.length_inside(joint.position + start * directions.back(), directions.back()));
  }
  const double radius = free_radius(points, joint.position, directions, 0.25 * clearance);
  std::vector<NodeMark> added;
  for (const Vec2 direction : directions) added.push_back({joint.position + radius * direction, d.index > 0 ? 3 : 5});
  return added;
}

class Overrider {
 public:
  Overrider(const CadFace& face, std::vector<Demand> demands, CriticalPoints& points, const std::string& why)
      : face_(face), demands_(std::move(demands)), points_(points), why_(why) {}

  void run() {
    if (demands_.empty()) return;
    int total = 0;
    for (const Demand& d : demands_) total += d.index;
    if (total != 0)
      for (Demand& d : demands_) {
        choose_removed(d);
        d.added = added_nodes(face_, points_, d);
      }
    std::vector<placement::NodeEdit> edits;
    for (const Demand& d : demands_) edits.push_back(edit_of(d));
    placement::apply(total == 0 ? std::vector{exchange_of(edits)} : edits, points_);
  }

 private:
  Vec2 position(const Demand& d) const { return points_.corners[d.corner].position; }
  double distance_to(const Demand& d, std::size_t node) const {
    return distance(position(d), points_.critical_points[node].position);
  }

  bool may_remove(const Demand& d, std::size_t node) const {
    const double length = distance_to(d, node), tol = tolerance::tied * face_.diameter;
    if (points_.critical_points[node].index != (d.index > 0 ? -1 : 1) || length > 0.25 * face_.diameter) return false;
    return std::none_of(demands_.begin(), demands_.end(), [&](const Demand& other) {
      return other.corner != d.corner && (other.index > 0) == (d.index > 0) && distance_to(other, node) < length + tol;
    });
  }

  /// Chooses the nearest nodes, in groups of equal distance: all of a group or none.
  void choose_removed(Demand& d) const {
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < points_.critical_points.size(); ++i)
      if (may_remove(d, i)) nodes.push_back(i);
    std::stable_sort(nodes.begin(), nodes.end(),
                     [&](std::size_t a, std::size_t b) { return distance_to(d, a) < distance_to(d, b); });
    const auto distance_of = [&](std::size_t node) { return distance_to(d, node); };
    const std::ptrdiff_t needed = std::abs(d.index);
    for (auto first = nodes.begin(); first != nodes.end();) {
      const auto last = end_of_ties(first, nodes.end(), tolerance::tied * face_.diameter, distance_of);
      if (last - nodes.begin() > needed) return;
      d.removed.assign(nodes.begin(), last);
      first = last;
    }
  }

  placement::NodeEdit edit_of(const Demand& d) const {
    const Corner& c = points_.corners[d.corner];
    std::string reason =
        fmt::format("valence {} {} for {} which had {}", d.valence, why_, name_of(face_, c), c.valence);
    if (!d.removed.empty() || !d.added.empty())
      reason += fmt::format(": {} nodes are removed, {} added", d.removed.size(), d.added.size());
    return {ChangeKind::corner, reason, {{c.joint, d.valence}}, d.added, d.removed};
  }

  /// One change for corners that exchange valences.
  static placement::NodeEdit exchange_of(const std::vector<placement::NodeEdit>& edits) {
    placement::NodeEdit exchange = edits.front();
    for (std::size_t i = 1; i < edits.size(); ++i) {
      exchange.reason += "; " + edits[i].reason;
      exchange.corners.push_back(edits[i].corners.front());
    }
    return exchange;
  }

  const CadFace& face_;
  std::vector<Demand> demands_;
  CriticalPoints& points_;
  const std::string& why_;
};

}  // namespace

CornerOverride parse_corner_override(const std::string& text) {
  const std::size_t colon = text.find(':'), equals = text.find('=');
  std::optional<int> a, b, valence;
  if (colon != std::string::npos && equals != std::string::npos && colon < equals) {
    a = whole_number(text.substr(0, colon));
    b = whole_number(text.substr(colon + 1, equals - colon - 1));
    valence = whole_number(text.substr(equals + 1));
  }
  if (!a || !b || !valence)
    throw UsageError(
        fmt::format("'{}' is not a corner valence: write CURVE_A:CURVE_B=VALENCE, for example 3:4=2", text));
  return {*a, *b, *valence};
}

void override_corners(const CadFace& face, const std::vector<CornerOverride>& overrides, CriticalPoints& points,
                      const std::string& why) {
  Overrider(face, demands_of(face, overrides, points.corners), points, why).run();
  // A valence that was prescribed stays, also one that the corner had before.
  for (const CornerOverride& o : overrides)
    points.corners[find_corner(face, o, points.corners)].source = NodeSource::corner;
}

void require_corners(const CadFace& face, const std::vector<CornerOverride>& overrides) {
  demands_of(face, overrides, corner_valences_by_angle(face).corners);
}

}  // namespace quadrille::guide
