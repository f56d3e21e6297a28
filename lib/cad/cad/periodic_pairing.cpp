#include "cad/periodic_pairing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "curve/nurbs.hpp"
#include "model/periodic.hpp"
#include "surface/positions.hpp"

namespace quadrille::cad {
namespace {

// From its own start on.
Nurbs from_zero(Nurbs curve) {
  const double begin = curve.begin();
  for (double& knot : curve.knots) knot -= begin;
  return curve;
}

}  // namespace

void split_curve(CadFace& face, int curve, double t) {
  const Nurbs whole = face.curves[curve];
  const int added = curve + 1;
  const double tangent = angle_of(curve::tangent(whole, t));
  const auto renumber = [added](int& c) { c += c >= added; };
  face.curves[curve] = curve::trimmed(whole, whole.begin(), t);
  Nurbs rest = from_zero(curve::trimmed(whole, t, whole.end()));
  rest.poles.front() = face.curves[curve].poles.back();
  face.joints.insert(face.joints.begin() + added, {rest.poles.front(), tangent, tangent, pi, false});
  face.curves.insert(face.curves.begin() + added, std::move(rest));
  face.curve_names.insert(face.curve_names.begin() + added, std::string(face.curve_names[curve]));
  face.curve_cad_edges.insert(face.curve_cad_edges.begin() + added, int(face.curve_cad_edges[curve]));
  const bool is_unnamed = !face.has_given_name(curve);
  for (int& c : face.unnamed_curves) renumber(c);
  if (is_unnamed)
    face.unnamed_curves.insert(std::upper_bound(face.unnamed_curves.begin(), face.unnamed_curves.end(), curve), added);
  for (int& offset : face.loop_offsets) offset += offset > curve;
  if (!face.partners.empty()) {
    for (int& partner : face.partners) renumber(partner);
    face.partners.insert(face.partners.begin() + added, -1);
  }
  for (PeriodicPair& pair : face.periodic_pairs)
    for (int& c : pair.curves) renumber(c);
}

bool SideFinder::are_same(Vec2 a, Vec2 b) const { return distance(a, b) <= relative_same * face_.diameter; }

std::string SideFinder::place(Vec2 x) const { return surface::position_text(face_, x); }

std::vector<int> SideFinder::curves_named(const std::string& name) const {
  std::vector<int> curves;
  for (int c = 0; c < face_.num_curves(); ++c)
    if (matches_wildcard(face_.curve_names[c], name)) curves.push_back(c);
  if (curves.empty())
    throw UsageError(fmt::format("{}: no curve is named '{}'; the names are: {}", request_.where, name,
                                 fmt::join(std::set(face_.curve_names.begin(), face_.curve_names.end()), ", ")));
  for (const int c : curves)
    if (face_.is_interface(c))
      throw UsageError(
          fmt::format("{}: '{}' at {} is not on the boundary: the face is on both sides of it, and free "
                      "periodic curves, which no side follows, are not supported; cut the shape there",
                      request_.where, name, place(start(c))));
  const std::vector<int> partners = periodic_partners(face_);
  for (const int c : curves)
    if (partners[c] >= 0)
      throw UsageError(fmt::format("{}: '{}' is already a side of another periodic pair", request_.where, name));
  return curves;
}

PeriodicSide SideFinder::side(const std::string& name) const {
  std::vector<int> rest = curves_named(name);
  PeriodicSide side;
  while (!rest.empty()) {
    const auto follows_another = [&](int c) {
      return std::any_of(rest.begin(), rest.end(), [&](int o) { return are_same(end(o), start(c)); });
    };
    auto next = std::find_if_not(rest.begin(), rest.end(), follows_another);
    if (next == rest.end())
      throw UsageError(fmt::format(
          "{}: the curves '{}' at {} are closed: {}; cut the shape along two lines that repeat each other, and name "
          "these",
          request_.where, name, place(start(rest.front())),
          face_.chart ? "sides of a curved face that have no ends are not supported"
                      : "no motion in the plane maps a closed side onto another from outside"));
    side.push_back({name, {}});
    const auto is_next = [&](int c) { return are_same(end(side.back().curves.back()), start(c)); };
    for (; next != rest.end(); next = std::find_if(rest.begin(), rest.end(), is_next)) {
      side.back().curves.push_back(*next);
      rest.erase(next);
    }
  }
  return side;
}

void SideFinder::require_two_sides(const PeriodicSide& a, const PeriodicSide& b) const {
  for (const SidePart& part : a)
    for (const SidePart& other : b)
      for (const int c : part.curves)
        if (std::find(other.curves.begin(), other.curves.end(), c) != other.curves.end())
          throw UsageError(fmt::format("{}: '{}' is on both sides", request_.where, face_.curve_names[c]));
  if (a.size() != b.size())
    throw UsageError(
        fmt::format("{}: '{}' has {} and '{}' has {} that do not follow each other ({}; {}): each part needs an image",
                    request_.where, request_.first, counted(a.size(), "part"), request_.second,
                    counted(b.size(), "part"), places(a), places(b)));
}

/// "(0, 0) to (1, 0), (2, 0) to (3, 0)"
std::string SideFinder::places(const PeriodicSide& side) const {
  std::vector<std::string> texts;
  for (const SidePart& part : side)
    texts.push_back(place(start(part.curves.front())) + " to " + place(end(part.curves.back())));
  return fmt::format("{}", fmt::join(texts, ", "));
}

}  // namespace quadrille::cad
