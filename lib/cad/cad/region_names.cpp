#include "cad/region_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/tolerance.hpp"
#include "curve/project.hpp"
#include "mesh/given_position.hpp"
#include "outline/extent.hpp"
#include "outline/face_of_loops.hpp"
#include "outline/outline_checks.hpp"

namespace quadrille::cad {

namespace {

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
  const Vec2 x = mesh::given_position(face, rule.position, rule.where);
  const std::string text = fmt::format("({:.6g})", fmt::join(rule.position, ", "));
  for (const Nurbs& curve : face.curves)
    if (curve::project(curve, x).distance <= tolerance::same_point * face.diameter)
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

namespace {

using Loop = std::vector<int>;

class RegionMerger {
 public:
  RegionMerger(const CadFace& face, const std::vector<int>& named, double corner_angle)
      : face_(face), corner_angle_(corner_angle), groups_(face.num_regions()) {
    for (int l = 0; l < face.num_loops(); ++l) region_of_.resize(face.loop_offsets[l + 1], face.region_of_loop(l));
    const auto is_named = [&](int r) { return std::binary_search(named.begin(), named.end(), r); };
    for (int c = 0; c < face.num_curves(); ++c) {
      if (!face.is_interface(c)) continue;
      const int a = region_of_[c], b = region_of_[face.partners[c]];
      if (is_named(a) && is_named(b) && face.region_names[a] == face.region_names[b]) groups_.unite(a, b);
    }
  }

  bool changes_anything() { return static_cast<int>(groups_.sets().size()) < face_.num_regions(); }

  CadFace merged() {
    CadFace face = face_;
    clear_boundary(face);
    std::vector<std::vector<Loop>> loops(face_.num_regions());  // of each region at the number of its group's first
    std::vector<bool> is_seen(face_.num_curves(), false);
    for (int c = 0; c < face_.num_curves(); ++c)
      if (!is_seen[c] && !is_removed(c)) loops[groups_.find(region_of_[c])].push_back(traced(c, is_seen));
    for (int r = 0; r < face_.num_regions(); ++r)
      if (groups_.find(r) == r) add_region(face, loops[r], face_.region_names[r]);
    std::vector<int> new_numbers(face_.num_curves(), -1);
    for (int c = 0; c < face.num_curves(); ++c) new_numbers[numbers_[c]] = c;
    if (face_.chart) {
      auto chart = std::make_shared<Chart>(*face_.chart);
      for (std::size_t i = 0; i < numbers_.size(); ++i) chart->space_curves[i] = face_.chart->space_curves[numbers_[i]];
      chart->space_curves.resize(numbers_.size());
      face.chart = std::move(chart);
    }
    for (const int c : numbers_) face.partners.push_back(face_.partners[c] < 0 ? -1 : new_numbers[face_.partners[c]]);
    set_joints(face);
    name_curves(face);
    return face;
  }

 private:
  bool is_removed(int c) {
    if (!face_.is_interface(c)) return false;
    const int a = region_of_[c], b = region_of_[face_.partners[c]];
    return a != b && groups_.find(a) == groups_.find(b);
  }

  /// In the loop of the merged region: where a curve between merged regions follows, the loop goes on in the neighbour.
  int next(int c) {
    int n = face_.next_in_loop(c);
    while (is_removed(n)) n = face_.next_in_loop(face_.partners[n]);
    return n;
  }

  Loop traced(int first, std::vector<bool>& is_seen) {
    Loop loop;
    for (int c = first; !is_seen[c]; c = next(c)) {
      is_seen[c] = true;
      loop.push_back(c);
    }
    return loop;
  }

  double signed_area(const Loop& loop) const {
    std::vector<Nurbs> curves;
    for (const int c : loop) curves.push_back(face_.curves[c]);
    return outline::signed_area(curves);
  }

  static void clear_boundary(CadFace& face) {
    face.curves.clear(), face.curve_cad_edges.clear(), face.curve_names.clear(), face.unnamed_curves.clear();
    face.joints.clear(), face.partners.clear(), face.region_names.clear();
    face.loop_offsets = face.region_loops = {0};
  }

  void add_region(CadFace& face, std::vector<Loop>& loops, const std::string& name) {
    const auto is_smaller = [this](const Loop& a, const Loop& b) { return signed_area(a) < signed_area(b); };
    const auto outline = std::max_element(loops.begin(), loops.end(), is_smaller);
    std::rotate(loops.begin(), outline, outline + 1);
    for (const Loop& loop : loops) {
      for (const int c : loop) {
        numbers_.push_back(c);
        face.curves.push_back(face_.curves[c]);
        face.curve_cad_edges.push_back(face_.curve_cad_edges[c]);
        face.curve_names.push_back(face_.has_given_name(c) ? face_.curve_names[c] : "");
      }
      face.loop_offsets.push_back(face.num_curves());
    }
    face.region_loops.push_back(face.num_loops());
    face.region_names.push_back(name);
  }

  void set_joints(CadFace& face) {
    for (int i = 0; i < face.num_curves(); ++i) {
      const int in = face.previous_in_loop(i);
      if (numbers_[in] == face_.previous_in_loop(numbers_[i])) {
        face.joints.push_back(face_.joints[numbers_[i]]);
        continue;
      }
      face.joints.push_back(outline::joint_between(face.curves[in], face.curves[i], corner_angle_));
      if (face.partners[i] == in)  // the tip of a curve inside the region
        face.joints[i].interior_angle = 2 * pi, face.joints[i].is_corner = true;
    }
    for (int r = 0; r < face.num_regions(); ++r) refuse_contact(face, r);
  }

  static void refuse_contact(const CadFace& face, int region) {
    std::vector<std::pair<double, double>> places;
    for (int c = face.loop_offsets[face.region_loops[region]]; c < face.loop_offsets[face.region_loops[region + 1]];
         ++c)
      if (!is_in_one_region(face, c)) places.emplace_back(face.joints[c].position.x, face.joints[c].position.y);
    std::sort(places.begin(), places.end());
    const auto twin = std::adjacent_find(places.begin(), places.end());
    if (twin == places.end()) return;
    throw FormatError(fmt::format(
        "--region-name: '{}' would be one region that touches itself at {}: give its faces two names, or --keep-joints",
        face.region_names[region], rounded_position_text(Vec2{twin->first, twin->second} + face.origin)));
  }

  /// Whether a curve inside one region starts or ends at the joint.
  static bool is_in_one_region(const CadFace& face, int joint) {
    const auto is_slit = [&](int c) {
      return face.is_interface(c) &&
             face.region_of_loop(face.loop_of(c)) == face.region_of_loop(face.loop_of(face.partners[c]));
    };
    return is_slit(joint) || is_slit(face.previous_in_loop(joint));
  }

  static void name_curves(CadFace& face) {
    face.unnamed_curves = replace_empty_names(face.curve_names, "curve");
    if (face.num_regions() == 1) {
      face.name = face.region_names.front();
      face.region_loops.clear(), face.region_names.clear();
      if (std::all_of(face.partners.begin(), face.partners.end(), [](int p) { return p < 0; })) face.partners.clear();
    }
    name_interfaces(face);
  }

  const CadFace& face_;
  double corner_angle_;
  DisjointSets groups_;
  std::vector<int> region_of_;  ///< of each curve
  std::vector<int> numbers_;    ///< old number of each curve
};

}  // namespace

void merge_regions(CadFace& face, const std::vector<int>& named, double corner_angle) {
  if (face.num_regions() == 1) return;
  RegionMerger merger(face, named, corner_angle);
  if (merger.changes_anything()) face = merger.merged();
}

}  // namespace quadrille::cad
