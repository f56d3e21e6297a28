#include "sew/one_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/chain.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"
#include "outline/extent.hpp"
#include "outline/outline_checks.hpp"

namespace quadrille::sew {

namespace {

constexpr int samples_per_span = 16;
constexpr int refinements = 20;
/// Samples inside a region lie this part of the curve's size beside it.
constexpr double inward = 1e-2;

struct Sample {
  Vec2 position, normal;  // the normal points into the region
};

std::vector<Sample> samples_of(const Nurbs& curve) {
  std::vector<Sample> samples;
  curve::for_each_span(curve, [&](double t0, double t1) {
    for (int i = 0; i < samples_per_span; ++i) {
      const double t = t0 + (t1 - t0) * (i + 0.5) / samples_per_span;
      samples.push_back({curve::point(curve, t), left_of(curve::tangent(curve, t))});
    }
  });
  return samples;
}

/// A region with its boundary.
struct BoundedRegion {
  const Region& region;
  curve::CurveTree boundary;
  curve::PoleBox box;

  explicit BoundedRegion(const Region& r) : region(r), boundary(boundary_of(r)), box(region_box(r)) {}
  bool contains(Vec2 x) const { return boundary.winding_number(x) > 0; }
};

/// Samples on the boundary of `a` and beside it that are inside of `b`.
void find_overlap(const BoundedRegion& a, const BoundedRegion& b, double negligible,
                  std::optional<MeasuredPlace>& deepest) {
  const auto consider = [&](Vec2 x, bool is_on_boundary) {
    if (!b.box.contains(x)) return;
    double depth = b.boundary.nearest(x).distance;
    if (!is_on_boundary) depth = std::min(depth, a.boundary.nearest(x).distance);
    if (depth <= std::max(negligible, deepest ? deepest->size : 0) || !b.contains(x)) return;
    if (is_on_boundary || a.contains(x)) deepest = {x, depth};
  };
  for (const heal::LoopCurve& c : a.region.curves) {
    const double beside = inward * curve::pole_box(c.curve).diagonal();
    for (const Sample& sample : samples_of(c.curve)) {
      consider(sample.position, true);
      consider(sample.position + beside * sample.normal, false);
    }
  }
}

}  // namespace

std::optional<MeasuredPlace> overlap(const Region& a, const Region& b, double negligible) {
  const BoundedRegion first(a), second(b);
  std::optional<MeasuredPlace> deepest;
  find_overlap(first, second, negligible, deepest);
  find_overlap(second, first, negligible, deepest);
  return deepest;
}

MeasuredPlace gap_between(const Region& a, const Region& b) {
  const Nurbs *from = nullptr, *to = nullptr;
  Vec2 nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [own, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const curve::CurveTree boundary = boundary_of(*other);
    for (const heal::LoopCurve& c : own->curves) {
      std::vector<Vec2> points{c.curve.poles.front()};
      for (const Sample& sample : samples_of(c.curve)) points.push_back(sample.position);
      for (const Vec2 x : points)
        if (const curve::NearestPoint foot = boundary.nearest(x); foot.distance < least)
          least = foot.distance, nearest = foot.position, from = &other->curves[foot.curve].curve, to = &c.curve;
    }
  }
  // From the nearest samples forth and back between the two curves.
  Vec2 opposite = nearest;
  for (int i = 0; i < refinements; ++i) {
    opposite = curve::project(*to, nearest).position;
    nearest = curve::project(*from, opposite).position;
  }
  return {0.5 * (nearest + opposite), distance(nearest, opposite)};
}

namespace {

constexpr double slip_share = 1e-3;        ///< of the diameter
constexpr double slip_tolerances = 10;     ///< of a tolerance that was given
constexpr double length_share = 1.0 / 50;  ///< of the length of the curve
constexpr int num_samples = 9, least_near = 3;

/// Between the curve and region `other`; both ends of the curve are measured too.
std::optional<Slip> slip_between(const Sewn& sewn, CurveId id, int other, double most_slip) {
  const Nurbs& curve = sewn.regions[id.region].curves[id.curve].curve;
  const curve::ArcLength length(curve);
  const double most = std::min(most_slip, length_share * length.total());
  const curve::CurveTree boundary = boundary_of(sewn.regions[other]);
  const auto is_of_whole = [&](int c) { return !sewn.partners[other][c].exists(); };
  Slip slip{id.region, other, {}};
  int num_near = 0;
  for (int i = 0; i <= num_samples + 1; ++i) {
    const Vec2 x = curve::point(curve, length.parameter(length.total() * i / (num_samples + 1)));
    const curve::NearestPoint foot = boundary.nearest(x, is_of_whole);
    if (foot.distance > most) continue;
    num_near += 0 < i && i <= num_samples;
    if (foot.distance >= slip.gap.size) slip.gap = {0.5 * (x + foot.position), foot.distance};
  }
  return num_near >= least_near ? std::optional(slip) : std::nullopt;
}

}  // namespace

double most_slip_of(const heal::HealScale& scale, bool is_asked) {
  return is_asked ? slip_tolerances * scale.tolerance : slip_share * scale.diameter;
}

std::optional<Slip> find_slip(const Sewn& sewn, double most_slip) {
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (int c = 0; c < sewn.regions[r].num_curves(); ++c)
      for (int other = 0; other < static_cast<int>(sewn.regions.size()) && !sewn.partners[r][c].exists(); ++other)
        if (other != r)
          if (const auto slip = slip_between(sewn, {r, c}, other, most_slip)) return slip;
  return std::nullopt;
}

std::vector<std::vector<CurveId>> whole_boundary(const Sewn& sewn) {
  const auto partner = [&](CurveId id) { return sewn.partners[id.region][id.curve]; };
  const auto after = [&](CurveId id) { return CurveId{id.region, sewn.regions[id.region].next_in_loop(id.curve)}; };
  ByCurve<bool> is_done = by_curve(sewn.regions, false);
  std::vector<std::vector<CurveId>> loops;
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (int c = 0; c < sewn.regions[r].num_curves(); ++c) {
      if (is_done[r][c] || partner({r, c}).exists()) continue;
      loops.emplace_back();
      for (CurveId id{r, c}; !is_done[id.region][id.curve];) {
        is_done[id.region][id.curve] = true;
        loops.back().push_back(id);
        id = after(id);
        while (partner(id).exists()) id = after(partner(id));
      }
    }
  return loops;
}

std::vector<std::vector<int>> connected_regions(const Sewn& sewn) {
  DisjointSets sets(sewn.regions.size());
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r)
    for (const CurveId partner : sewn.partners[r])
      if (partner.exists()) sets.unite(r, partner.region);
  return sets.sets();
}

namespace {

using outline::contact_share;

using Boundary = std::vector<std::vector<CurveId>>;

std::vector<std::vector<Nurbs>> curves_of(const Sewn& sewn, const Boundary& boundary) {
  std::vector<std::vector<Nurbs>> loops;
  for (const auto& loop : boundary) {
    loops.emplace_back();
    for (const CurveId id : loop) loops.back().push_back(sewn.regions[id.region].curves[id.curve].curve);
  }
  return loops;
}

/// Whether simple, disjoint loops are one outline and holes in it beside each other.
bool bound_one_part(const std::vector<std::vector<Nurbs>>& loops) {
  int outer = -1;
  for (int l = 0; l < static_cast<int>(loops.size()); ++l)
    if (outline::signed_area(loops[l]) > 0) {
      if (outer >= 0) return false;
      outer = l;
    }
  for (int hole = 0; hole < static_cast<int>(loops.size()); ++hole) {
    const Vec2 x = loops[hole].front().poles.front();
    for (int l = 0; l < static_cast<int>(loops.size()); ++l)
      if (l != hole && hole != outer && outline::winding_number(loops[l], x) != (l == outer ? 1 : 0)) return false;
  }
  return outer >= 0;
}

std::string pair_text(const Region& a, const Region& b) { return face_text(a) + " and " + face_text(b); }

void refuse_overlaps(const Sewn& sewn, const heal::HealScale& scale, double most_slip) {
  for (size_t a = 0; a < sewn.regions.size(); ++a)
    for (size_t b = a + 1; b < sewn.regions.size(); ++b)
      if (const auto found = overlap(sewn.regions[a], sewn.regions[b], contact_share * scale.diameter))
        throw FormatError(fmt::format(
            "{}: {} overlap at {}, by {:.3g}{}", scale.file, pair_text(sewn.regions[a], sewn.regions[b]),
            rounded_position_text(found->position), found->size,
            found->size <= most_slip
                ? heal::remedy(scale, found->size)
                : fmt::format(" or more: draw them side by side, cut one out of the other, or {}", face_choice_text)));
}

void refuse_slips(const Sewn& sewn, const heal::HealScale& scale, double most_slip) {
  const auto slip = find_slip(sewn, most_slip);
  if (!slip) return;
  throw FormatError(
      fmt::format("{}: {} do not meet: they are up to {:.3g} apart at {}{}; if the gap is meant, give "
                  "--heal-tolerance {:.1g}",
                  scale.file, pair_text(sewn.regions[slip->a], sewn.regions[slip->b]), slip->gap.size,
                  rounded_position_text(slip->gap.position), heal::remedy(scale, slip->gap.size),
                  slip->gap.size / scale.diameter / 50));
}

/// At a place at which two curves of the boundary start, the whole touches itself in a point.
void refuse_point_contacts(const Sewn& sewn, const Boundary& boundary, const heal::HealScale& scale) {
  std::map<int, CurveId> first;
  for (const auto& loop : boundary)
    for (const CurveId id : loop) {
      const int place = sewn.places[id.region][id.curve];
      const auto [found, is_new] = first.emplace(place, id);
      if (place < 0 || is_new) continue;
      const Region &a = sewn.regions[found->second.region], &b = sewn.regions[id.region];
      throw FormatError(fmt::format(
          "{}: {} touch at {} in a point only: let them share an edge there, or draw them apart", scale.file,
          found->second.region == id.region ? face_text(a) + " and its neighbours" : pair_text(a, b),
          rounded_position_text(a.curves[found->second.curve].curve.poles.front())));
    }
}

/// Regions that no interface connects: nearly touching, or apart.
void refuse_separate_parts(const Sewn& sewn, const heal::HealScale& scale, double most_slip) {
  const std::vector<std::vector<int>> parts = connected_regions(sewn);
  if (parts.size() < 2) return;
  std::optional<MeasuredPlace> nearest;
  std::pair<int, int> faces;
  for (const int a : parts.front())
    for (int b = 0; b < static_cast<int>(sewn.regions.size()); ++b) {
      if (std::binary_search(parts.front().begin(), parts.front().end(), b)) continue;
      const MeasuredPlace gap = gap_between(sewn.regions[a], sewn.regions[b]);
      if (!nearest || gap.size < nearest->size) nearest = gap, faces = {a, b};
    }
  const std::string pair = pair_text(sewn.regions[faces.first], sewn.regions[faces.second]);
  if (nearest->size <= most_slip)
    throw FormatError(fmt::format("{}: {} do not meet: they are {:.3g} apart at {}{}", scale.file, pair, nearest->size,
                                  rounded_position_text(nearest->position), heal::remedy(scale, nearest->size)));
  throw FormatError(
      fmt::format("{}: the file holds several faces ({}) that do not touch: {} are {:.3g} apart, nearest "
                  "at {}: {}",
                  scale.file, sewn.regions.size(), pair, nearest->size, rounded_position_text(nearest->position),
                  face_choice_text));
}

}  // namespace

void require_one_sheet(const Sewn& sewn, const heal::HealScale& scale, bool is_asked) {
  const double most_slip = most_slip_of(scale, is_asked);
  const Boundary boundary = whole_boundary(sewn);
  const std::vector<std::vector<Nurbs>> loops = curves_of(sewn, boundary);
  const bool is_connected = connected_regions(sewn).size() == 1;
  const auto contact = outline::find_contact(loops, contact_share * scale.diameter);
  if (!is_connected || contact || !bound_one_part(loops)) {
    refuse_overlaps(sewn, scale, most_slip);
    refuse_slips(sewn, scale, most_slip);
    refuse_point_contacts(sewn, boundary, scale);
    refuse_separate_parts(sewn, scale, most_slip);
    const Vec2 x = contact ? contact->position : loops.front().front().poles.front();
    const CurveId a = contact ? boundary[contact->loop_a][contact->curve_a] : boundary.front().front();
    const CurveId b = contact ? boundary[contact->loop_b][contact->curve_b] : boundary.back().front();
    throw FormatError(fmt::format("{}: {} cross or touch at {}: draw them apart, or let them share an edge there",
                                  scale.file, pair_text(sewn.regions[a.region], sewn.regions[b.region]),
                                  rounded_position_text(x)));
  }
  refuse_slips(sewn, scale, most_slip);
}

}  // namespace quadrille::sew
