#include "cad/region_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "base/assign_names.hpp"
#include "base/error.hpp"
#include "base/name_text.hpp"
#include "curve/face_position.hpp"
#include "curve/project.hpp"
#include "outline/outline_checks.hpp"

namespace quadrille::cad {
namespace {

/// Diameters: a point as near to a curve is on it.
constexpr double on_boundary = 1e-6;

std::vector<std::string> names_of(const CadFace& face) {
  return face.region_names.empty() ? std::vector<std::string>{face.name} : face.region_names;
}

std::string known_regions(const std::vector<std::string>& names, const std::string& text = {}) {
  std::vector<std::string> known;
  for (size_t r = 0; r < std::min<size_t>(names.size(), 20); ++r)
    known.push_back(fmt::format("{} \"{}\"", r, names[r]));
  return fmt::format("{}; the regions are {}{}", text.empty() ? "" : did_you_mean(text, names), fmt::join(known, ", "),
                     names.size() > 20 ? ", ..." : "");
}

int winding_number(const CadFace& face, int loop, Vec2 x) {
  return outline::winding_number(
      {face.curves.begin() + face.loop_offsets[loop], face.curves.begin() + face.loop_offsets[loop + 1]}, x);
}

std::vector<int> region_around(const CadFace& face, const NameRule& rule) {
  const Vec2 x = curve::face_position(face, rule.position, rule.where);
  const std::string text = fmt::format("({:.6g})", fmt::join(rule.position, ", "));
  for (const Nurbs& curve : face.curves)
    if (curve::project(curve, x).distance <= on_boundary * face.diameter)
      throw FormatError(fmt::format("{}: {} is on the boundary of a region: give a point inside", rule.where, text));
  std::vector<int> winding(face.num_regions(), 0);
  for (int l = 0; l < face.num_loops(); ++l) winding[face.region_of_loop(l)] += winding_number(face, l, x);
  const auto found = std::find(winding.begin(), winding.end(), 1);
  if (found == winding.end())
    throw FormatError(fmt::format("{}: {} is in no region{}", rule.where, text, known_regions(names_of(face))));
  return {static_cast<int>(found - winding.begin())};
}

std::vector<int> regions_of(const CadFace& face, const NameRule& rule) {
  if (rule.part != NameRule::Part::any)
    throw UsageError(rule.where + ": boundary: and interface: are for names of curves: leave them out");
  const std::vector<std::string> names = names_of(face);
  const int count = static_cast<int>(names.size());
  std::vector<int> regions;
  switch (rule.kind) {
    case NameRule::Kind::rest:
      regions.resize(count);
      std::iota(regions.begin(), regions.end(), 0);
      return regions;
    case NameRule::Kind::position:
      return region_around(face, rule);
    case NameRule::Kind::range:
      if (rule.last_number >= count)
        throw FormatError(fmt::format("{}: no region has the number {}{}", rule.where, std::max(rule.number, count),
                                      known_regions(names)));
      for (int r = rule.number; r <= rule.last_number; ++r) regions.push_back(r);
      return regions;
    default:
      for (int r = 0; r < count; ++r)
        if (matches_wildcard(names[r], rule.text)) regions.push_back(r);
      if (regions.empty())
        throw FormatError(
            fmt::format("{}: no region has the name {}{}", rule.where, rule.text, known_regions(names, rule.text)));
      return regions;
  }
}

}  // namespace

void name_interfaces(CadFace& face) {
  for (const int c : face.unnamed_curves) {
    if (!face.is_interface(c)) continue;
    const auto [a, b] =
        std::minmax({face.region_of_loop(face.loop_of(c)), face.region_of_loop(face.loop_of(face.partners[c]))});
    if (a == b)
      face.curve_names[c] = face.curve_names[std::min(c, face.partners[c])];
    else
      face.curve_names[c] = face.region_names[a] + "-" + face.region_names[b];
  }
}

std::vector<int> rename_regions(CadFace& face, const std::vector<NameRule>& rules) {
  if (rules.empty()) return {};
  std::vector<GivenName> given;
  for (const NameRule& rule : rules)
    given.push_back({rule.name, regions_of(face, rule), rule.kind == NameRule::Kind::rest, rule.where});
  std::vector<std::string> names = names_of(face);
  std::vector<int> named = assign_names(names, given, "region");
  if (face.region_names.empty())
    face.name = names.front();
  else
    face.region_names = names;
  name_interfaces(face);
  return named;
}

}  // namespace quadrille::cad
