#include "sew/one_sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "outline/extent.hpp"
#include "outline/outline_checks.hpp"
#include "sew/region_distance.hpp"
#include "sew/slips.hpp"
#include "sew/whole_boundary.hpp"

namespace quadrille::sew {
namespace {

/// Curves nearer to each other than this part of the diameter are in contact, as in outline/assemble_face.cpp.
constexpr double contact_share = 1e-9;

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
