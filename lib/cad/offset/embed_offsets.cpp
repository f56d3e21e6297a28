#include "offset/embed_offsets.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/warning_codes.hpp"
#include "curve/nurbs.hpp"
#include "curve/project.hpp"
#include "curve/symmetry_lines.hpp"
#include "heal/raw_face.hpp"
#include "mesh/chart_map.hpp"
#include "model/interfaces.hpp"
#include "offset/chart_heights.hpp"
#include "offset/lifted_curve.hpp"
#include "offset/offset_chain.hpp"
#include "offset/offset_profile.hpp"
#include "offset/wall_chains.hpp"
#include "outline/outline_checks.hpp"
#include "sew/chart_regions.hpp"
#include "sew/embed_curves.hpp"
#include "sew/sew_regions.hpp"
#include "sew/sewn_face.hpp"
#include "surface/positions.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::offset {
namespace {

/// The name of all parts of a region: a face without one gets the name that it has in exports (export/groups).
std::string name_of(const CadFace& face, int region) {
  if (!face.region_names.empty()) return face.region_names[region];
  return face.name.empty() ? "domain" : face.name;
}

/// A region in file coordinates.
sew::Region region_of(const CadFace& face, int number) {
  sew::Region region{name_of(face, number), number, {}, {}, {0}};
  for (int l = 0; l < face.num_loops(); ++l) {
    if (face.region_of_loop(l) != number) continue;
    for (int c = face.loop_offsets[l]; c < face.loop_offsets[l + 1]; ++c) {
      region.curves.push_back({face.curves[c], face.curve_cad_edges[c], face.curve_names[c]});
      for (Vec2& pole : region.curves.back().curve.poles) pole += face.origin;
    }
    region.loop_offsets.push_back(region.num_curves());
  }
  region.other_sides.assign(region.curves.size(), -1);
  return region;
}

void refuse(const CadFace& face, const std::vector<OffsetRequest>& requests) {
  const std::string& where = requests.front().where;
  const double diameter = face.chart ? surface::diameter(*face.chart) : face.diameter;
  if (!face.periodic_pairs.empty())
    throw UsageError(where + ": curves at a distance from walls are not supported in faces with periodic sides");
  const std::vector<int> region = curve_regions(face);
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.is_interface(c) && region[c] == region[face.partners[c]])
      throw UsageError(
          fmt::format("{}: curves at a distance from walls are not supported in faces with embedded "
                      "curves that end inside, such as {}",
                      where, face.curve_names[c]));
  for (const OffsetRequest& request : requests)
    if (request.distance < offset_constants.least_distance * diameter)
      throw UsageError(fmt::format("{}: the distance is less than {:g} diameters of the face ({:g})", request.where,
                                   offset_constants.least_distance, diameter));
}

/// None if the face is no part of a whole.
std::vector<curve::SymmetryLine> lines_of_symmetry(const CadFace& face, const std::vector<std::string>& symmetry) {
  std::vector<curve::SymmetryLine> lines = curve::symmetry_lines(face, curve::curves_that_fit(face, symmetry)).lines;
  if (!curve::is_part_of_whole(lines)) lines.clear();
  return lines;
}

/// By curve.
std::vector<bool> curves_on_lines(const CadFace& face, const std::vector<std::string>& symmetry) {
  std::vector<bool> is_on_line(face.curves.size(), false);
  for (const curve::SymmetryLine& line : lines_of_symmetry(face, symmetry))
    for (const int c : line.curves) is_on_line[c] = true;
  return is_on_line;
}

std::vector<double> wall_distances(const CadFace& face, const std::vector<WallChain>& chains) {
  std::vector<double> distances(face.curves.size(), 0);
  for (const WallChain& chain : chains)
    for (std::size_t i = 0; i < chain.curves.size(); ++i) distances[chain.curves[i]] = chain.distances[i];
  return distances;
}

/// Those of the whole, if the face is a part of one: mirror images limit the distance, and no line of symmetry does.
/// Makes the heights those of the whole.
std::vector<ChainProfile> chain_profiles(CadFace face, std::vector<WallChain> chains,
                                         const std::vector<std::string>& symmetry, ChartHeights& heights) {
  std::vector<double> distances = wall_distances(face, chains);
  for (auto lines = lines_of_symmetry(face, symmetry); !lines.empty(); lines = lines_of_symmetry(face, symmetry)) {
    curve::MirroredFace mirrored = curve::mirrored_face(face, lines.front());
    std::vector<double> of_whole(mirrored.whole.num_curves(), 0);
    for (int c = 0; c < face.num_curves(); ++c)
      if (mirrored.copy[c] >= 0) of_whole[mirrored.copy[c]] = of_whole[mirrored.image[c]] = distances[c];
    for (WallChain& chain : chains)
      for (int& c : chain.curves) c = mirrored.copy[c];
    heights.add_mirror(lines.front());
    face = std::move(mirrored.whole);
    distances = std::move(of_whole);
  }
  std::vector<ChainProfile> profiles;
  for (const WallChain& chain : chains) profiles.push_back(chain_profile(face, chain, distances, heights));
  return profiles;
}

void report_chains(const CadFace& face, const std::vector<OffsetRequest>& requests,
                   const std::vector<WallChain>& chains, const std::vector<ChainProfile>& profiles, Report& report) {
  std::vector<double> least(requests.size(), 1);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    const OffsetRequest& request = requests[chains[i].requests.front()];
    for (const int r : chains[i].requests) least[r] = std::min(least[r], profiles[i].least_ratio);
    if (profiles[i].least_ratio > 1 - 1e-9) continue;
    report.warn(
        warning::offset_compressed,
        fmt::format("{}: the distance is reduced to {:.4g} near {}, where the opposite boundary, or the bend of "
                    "the wall, leaves less room",
                    request.where, request.distance * profiles[i].least_ratio,
                    surface::position_text(face, profiles[i].narrowest)));
  }
  for (std::size_t r = 0; r < requests.size(); ++r) {
    const std::string key = fmt::format("offsets.{}.", r);
    report.set(key + "names", fmt::format("{}", fmt::join(requests[r].names, ",")));
    report.set(key + "distance", requests[r].distance);
    report.set(key + "least", requests[r].distance * least[r]);
  }
}

/// The curves as a loop for outline::find_contact: the ends of an open chain do not touch the boundary.
std::vector<Nurbs> loop_of(const std::vector<heal::LoopCurve>& curves, bool is_closed) {
  constexpr double end = 1e-3;
  std::vector<Nurbs> loop;
  for (const heal::LoopCurve& c : curves) loop.push_back(c.curve);
  if (is_closed) return loop;
  const auto inside = [](const Nurbs& c, double fraction) { return c.begin() + fraction * (c.end() - c.begin()); };
  loop.front() = curve::trimmed(loop.front(), inside(loop.front(), end), loop.front().end());
  loop.back() = curve::trimmed(loop.back(), loop.back().begin(), inside(loop.back(), 1 - end));
  return loop;
}

/// Offset curves with their chains, in one region.
struct RegionOffsets {
  std::vector<heal::LoopCurve> curves;
  std::vector<std::vector<Nurbs>> loops;
  std::string where;
};

void require_no_contact(const CadFace& face, const sew::Region& region, const RegionOffsets& offsets) {
  std::vector<std::vector<Nurbs>> loops = sew::loop_curves(region);
  loops.insert(loops.end(), offsets.loops.begin(), offsets.loops.end());
  if (const auto contact = outline::find_contact(loops, offset_constants.tolerance * face.diameter))
    throw ComputeError(
        fmt::format("{}: the curve at this distance touches another one, or the boundary, at {}: use a "
                    "smaller distance",
                    offsets.where, surface::position_text(face, contact->position - face.origin)));
}

/// Curves that end on both sides of an interface, where it meets the wall, end in one place there: extended, or cut at
/// its own curve, each is a little off the height of the other.
void meet_on_interfaces(const CadFace& face, const std::vector<WallChain>& chains,
                        std::vector<std::vector<heal::LoopCurve>>& curves) {
  for (std::size_t a = 0; a < chains.size(); ++a) {
    const int wall = chains[a].curves.front(), side = face.previous_in_loop(wall);
    if (chains[a].is_closed || !face.is_interface(side)) continue;
    for (std::size_t b = 0; b < chains.size(); ++b) {
      if (chains[b].is_closed || face.next_in_loop(chains[b].curves.back()) != face.partners[side]) continue;
      Nurbs &first = curves[a].front().curve, &last = curves[b].back().curve;
      const Vec2 start = first.poles.front(), end = last.poles.back();
      const double gap = distance(start, end), height = distance(start, face.joints[wall].position);
      if (gap <= offset_constants.tolerance * face.diameter || gap > offset_constants.least_ratio * height) continue;
      const Vec2 both = curve::project(face.curves[side], (start + end) / 2).position;
      first = curve::with_ends(first, both, first.poles.back());
      last = curve::with_ends(last, last.poles.front(), both);
    }
  }
}

std::vector<RegionOffsets> offsets_by_region(const CadFace& face, const std::vector<OffsetRequest>& requests,
                                             const std::vector<WallChain>& chains,
                                             const std::vector<ChainProfile>& profiles, const ChartHeights& heights) {
  const std::vector<int> curve_region = curve_regions(face);
  std::vector<std::vector<heal::LoopCurve>> of_chains;
  for (std::size_t i = 0; i < chains.size(); ++i)
    of_chains.push_back(offset_chain(face, chains[i], profiles[i], heights, requests));
  meet_on_interfaces(face, chains, of_chains);
  std::vector<RegionOffsets> offsets(face.num_regions());
  for (std::size_t i = 0; i < chains.size(); ++i) {
    RegionOffsets& own = offsets[curve_region[chains[i].curves.front()]];
    std::vector<heal::LoopCurve>& curves = of_chains[i];
    for (heal::LoopCurve& c : curves)
      for (Vec2& pole : c.curve.poles) pole += face.origin;
    if (own.where.empty()) own.where = requests[chains[i].requests.front()].where;
    own.loops.push_back(loop_of(curves, chains[i].is_closed));
    own.curves.insert(own.curves.end(), curves.begin(), curves.end());
  }
  return offsets;
}

/// Names made from numbers remain such names.
std::vector<int> unnamed_curves(const CadFace& before, const std::vector<RegionOffsets>& offsets, const CadFace& face) {
  std::set<std::string> names;
  for (const int c : before.unnamed_curves) names.insert(before.curve_names[c]);
  for (const RegionOffsets& own : offsets)
    for (const heal::LoopCurve& c : own.curves) names.insert(c.name);
  std::vector<int> unnamed;
  for (int c = 0; c < face.num_curves(); ++c)
    if (names.contains(face.curve_names[c])) unnamed.push_back(c);
  return unnamed;
}

heal::RawFace frame_of(const CadFace& face) {
  heal::RawFace raw;
  raw.length_unit = face.length_unit;
  raw.metres_per_unit = face.metres_per_unit;
  raw.plane_origin = face.plane_origin;
  raw.plane_x = face.plane_x;
  raw.plane_y = face.plane_y;
  return raw;
}

CadFace embedded_in_plane(const CadFace& face, const std::vector<RegionOffsets>& offsets, double corner_angle) {
  const double tolerance = offset_constants.tolerance * face.diameter;
  std::vector<sew::Region> regions;
  for (int r = 0; r < face.num_regions(); ++r)
    for (sew::Region& piece : sew::embed_curves(region_of(face, r), offsets[r].curves, tolerance, "--offset"))
      regions.push_back(std::move(piece));
  CadFace result = sew::face_of_regions(sew::sew_regions(regions, tolerance), frame_of(face), corner_angle);
  result.fit_distance = face.fit_distance;
  return result;
}

CadFace embedded_in_chart(CadFace face, const std::vector<RegionOffsets>& offsets, double corner_angle) {
  const mesh::ChartMap map(face);
  std::vector<sew::ChartCurve> curves;
  for (const RegionOffsets& own : offsets)
    for (const heal::LoopCurve& c : own.curves)
      curves.push_back({c.curve, lifted_curve(map, face, c.curve), c.name, c.cad_edge, {-1, -1}});
  sew::ChartRegionOptions options{
      "--offset", offset_constants.fit_tolerance * face.diameter, corner_angle, {}, curve_regions(face), 0};
  for (int r = 0; r < face.num_regions(); ++r) options.face_names.push_back(name_of(face, r));
  face.unnamed_curves.clear();  // they keep their names
  Report of_cad2chart;          // which counts other curves
  return sew::divided_chart(face, curves, options, of_cad2chart);
}

}  // namespace

CadFace embed_offsets(const CadFace& face, const std::vector<OffsetRequest>& requests, double corner_angle,
                      const std::vector<std::string>& symmetry, Report& report) {
  if (requests.empty()) return face;
  refuse(face, requests);
  const std::vector<WallChain> chains = wall_chains(face, requests, curves_on_lines(face, symmetry));
  ChartHeights heights(face);
  const std::vector<ChainProfile> profiles = chain_profiles(face, chains, symmetry, heights);
  const std::vector<RegionOffsets> offsets = offsets_by_region(face, requests, chains, profiles, heights);
  for (int r = 0; r < face.num_regions(); ++r) require_no_contact(face, region_of(face, r), offsets[r]);
  CadFace result =
      face.chart ? embedded_in_chart(face, offsets, corner_angle) : embedded_in_plane(face, offsets, corner_angle);
  result.unnamed_curves = unnamed_curves(face, offsets, result);
  report_chains(face, requests, chains, profiles, report);
  return result;
}

}  // namespace quadrille::offset
