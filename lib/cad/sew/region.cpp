#include "sew/region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "heal/joint_target.hpp"
#include "sew/cut_curve.hpp"

namespace quadrille::sew {

namespace {

int loop_of(const Region& region, int curve) {
  const auto& offsets = region.loop_offsets;
  return static_cast<int>(std::upper_bound(offsets.begin(), offsets.end(), curve) - offsets.begin()) - 1;
}

}  // namespace

int Region::next_in_loop(int curve) const {
  const int l = loop_of(*this, curve);
  return curve + 1 < loop_offsets[l + 1] ? curve + 1 : loop_offsets[l];
}

int Region::previous_in_loop(int curve) const {
  const int l = loop_of(*this, curve);
  return curve > loop_offsets[l] ? curve - 1 : loop_offsets[l + 1] - 1;
}

Region region_of(const std::vector<heal::Loop>& loops, const std::string& name, int cad_face) {
  Region region{name, cad_face, {}, {}, {0}};
  for (const heal::Loop& loop : loops) {
    region.curves.insert(region.curves.end(), loop.begin(), loop.end());
    region.loop_offsets.push_back(region.num_curves());
  }
  region.other_sides.assign(region.curves.size(), -1);
  return region;
}

bool has_seam(const Region& region, int curve) {
  return region.next_in_loop(curve) == curve && curve::has_smooth_seam(region.curves[curve].curve);
}

std::string face_text(const Region& region) {
  return region.name.empty() ? fmt::format("face {}", region.cad_face)
                             : fmt::format("face {} '{}'", region.cad_face, region.name);
}

curve::PoleBox region_box(const Region& region) {
  curve::PoleBox box = curve::pole_box(region.curves.front().curve);
  for (int c = 1; c < region.loop_offsets[1]; ++c) box.extend(curve::pole_box(region.curves[c].curve));  // the outline
  return box;
}

std::vector<std::vector<Nurbs>> loop_curves(const Region& region) {
  std::vector<std::vector<Nurbs>> loops;
  for (int l = 0; l < region.num_loops(); ++l) {
    loops.emplace_back();
    for (int c = region.loop_offsets[l]; c < region.loop_offsets[l + 1]; ++c)
      loops.back().push_back(region.curves[c].curve);
  }
  return loops;
}

namespace {

/// The start of a curve.
struct Start {
  CurveId id;
  Vec2 position;
};

std::vector<Start> starts_of(const std::vector<Region>& regions) {
  std::vector<Start> starts;
  for (int r = 0; r < static_cast<int>(regions.size()); ++r)
    for (int c = 0; c < regions[r].num_curves(); ++c)
      if (!has_seam(regions[r], c)) starts.push_back({{r, c}, regions[r].curves[c].curve.poles.front()});
  return starts;
}

/// Two starts that may be one place.
struct Pair {
  double distance = 0;
  int a = 0, b = 0;

  friend bool operator<(const Pair& p, const Pair& q) {
    return std::tie(p.distance, p.a, p.b) < std::tie(q.distance, q.a, q.b);
  }
};

/// Ascending by distance. Pairs in one region only where they are the same point: the ends of slits.
std::vector<Pair> near_pairs(const std::vector<Start>& starts, double tol) {
  std::vector<int> by_x(starts.size());
  for (size_t i = 0; i < by_x.size(); ++i) by_x[i] = static_cast<int>(i);
  std::stable_sort(by_x.begin(), by_x.end(), [&](int i, int j) { return starts[i].position.x < starts[j].position.x; });
  std::vector<Pair> pairs;
  for (size_t m = 0; m < by_x.size(); ++m)
    for (size_t n = m + 1; n < by_x.size(); ++n) {
      const auto [a, b] = std::minmax({by_x[m], by_x[n]});
      if (starts[by_x[n]].position.x > starts[by_x[m]].position.x + tol) break;
      const double d = distance(starts[a].position, starts[b].position);
      if (d <= (starts[a].id.region == starts[b].id.region ? 0 : tol)) pairs.push_back({d, a, b});
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

/// The sets of starts that are one place. The points of one region in a set are the same point.
std::vector<std::vector<int>> united(const std::vector<Start>& starts, double tol) {
  DisjointSets sets(starts.size());
  std::vector<std::map<int, Vec2>> points(starts.size());  // by region, of the set with this least number
  for (size_t i = 0; i < starts.size(); ++i) points[i] = {{starts[i].id.region, starts[i].position}};
  for (const Pair& pair : near_pairs(starts, tol)) {
    const int a = std::min(sets.find(pair.a), sets.find(pair.b)), b = std::max(sets.find(pair.a), sets.find(pair.b));
    const auto disagrees = [&](const auto& entry) {
      const auto found = points[a].find(entry.first);
      return found != points[a].end() && !(found->second == entry.second);
    };
    if (a == b || std::any_of(points[b].begin(), points[b].end(), disagrees)) continue;
    points[a].insert(points[b].begin(), points[b].end());
    sets.unite(a, b);
  }
  return sets.sets();
}

/// Places and the cuts that they make, while they are looked for.
class Splitter {
 public:
  Splitter(const std::vector<Region>& regions, double tol) : tol_(tol), cuts_(by_curve(regions, std::vector<Cut>())) {
    result_.regions = regions;
    result_.places = by_curve(regions, -1);
    for (const Region& region : regions) boundaries_.push_back(boundary_of(region));
  }

  Placed split() {
    const std::vector<Start> starts = starts_of(result_.regions);
    for (const std::vector<int>& set : united(starts, tol_)) add_place(starts, set);
    for (int r = 0; r < static_cast<int>(result_.regions.size()); ++r) cut_region(r);
    return std::move(result_);
  }

 private:
  void add_place(const std::vector<Start>& starts, const std::vector<int>& set) {
    const int place = static_cast<int>(result_.positions.size());
    std::map<int, Vec2> points;  // by region
    for (const int i : set) {
      result_.places[starts[i].id.region][starts[i].id.curve] = place;
      points.emplace(starts[i].id.region, starts[i].position);
    }
    const Vec2 x = points.begin()->second;
    for (int r = 0; r < static_cast<int>(result_.regions.size()); ++r)
      if (!points.contains(r))
        if (const auto foot = cut_at(r, x, place)) points.emplace(r, *foot);
    const Vec2 first = points.begin()->second;
    result_.positions.push_back(first);
    for (const auto& [r, point] : points) result_.greatest = std::max(result_.greatest, distance(first, point));
  }

  // Cuts the nearest curve of the region, if it passes the place; the point of the curve.
  std::optional<Vec2> cut_at(int r, Vec2 x, int place) {
    const Region& region = result_.regions[r];
    const curve::NearestPoint foot = boundaries_[r].nearest(x, [&](int c) { return region.other_sides[c] < 0; });
    if (foot.distance > tol_) return std::nullopt;
    const Nurbs& curve = region.curves[foot.curve].curve;
    const bool is_at_end =
        std::min(distance(foot.position, curve.poles.front()), distance(foot.position, curve.poles.back())) <= 2 * tol_;
    if (is_at_end && !has_seam(region, foot.curve)) return std::nullopt;
    cuts_[r][foot.curve].push_back({foot.t, place});
    return foot.position;
  }

  void cut_region(int r) {
    const Region& whole = result_.regions[r];
    Region split{whole.name, whole.cad_face, {}, {}, {0}};
    std::vector<int> places, new_numbers;
    for (int l = 0; l < whole.num_loops(); ++l) {
      for (int c = whole.loop_offsets[l]; c < whole.loop_offsets[l + 1]; ++c) {
        new_numbers.push_back(split.num_curves());
        for (const auto& [curve, place] : cut_curve(whole.curves[c].curve, cuts_[r][c], result_.places[r][c])) {
          split.curves.push_back({curve, whole.curves[c].cad_edge, whole.curves[c].name});
          places.push_back(place);
        }
      }
      split.loop_offsets.push_back(split.num_curves());
    }
    split.other_sides.assign(split.curves.size(), -1);
    for (int c = 0; c < whole.num_curves(); ++c)  // slits were not cut
      if (whole.other_sides[c] >= 0) split.other_sides[new_numbers[c]] = new_numbers[whole.other_sides[c]];
    result_.regions[r] = std::move(split);
    result_.places[r] = std::move(places);
  }

  double tol_;
  Placed result_;
  ByCurve<std::vector<Cut>> cuts_;
  std::vector<curve::CurveTree> boundaries_;  ///< of the regions before they are cut
};

}  // namespace

Placed split_at_places(const std::vector<Region>& regions, double tol) { return Splitter(regions, tol).split(); }

Nurbs curve_to_places(const Placed& placed, CurveId id) {
  const Region& region = placed.regions[id.region];
  const Nurbs& curve = region.curves[id.curve].curve;
  const int from = placed.places[id.region][id.curve];
  if (from < 0) return curve;
  const Vec2 start = placed.positions[from];
  const Vec2 end = placed.positions[placed.places[id.region][region.next_in_loop(id.curve)]];
  const double moved = std::max(distance(start, curve.poles.front()), distance(end, curve.poles.back()));
  // Otherwise the curve keeps its shape up to rounding.
  if (moved > tolerance::round_off * curve::pole_box(curve).diagonal())
    if (std::vector<Nurbs> pieces = heal::moved_curve(curve, start, end); pieces.size() == 1) return pieces.front();
  return moved > 0 ? curve::with_ends(curve, start, end) : curve;
}

}  // namespace quadrille::sew
