#include "sew/chart_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <utility>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "curve/nurbs.hpp"
#include "outline/extent.hpp"
#include "outline/face_of_loops.hpp"
#include "sew/embed_curves.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::sew {
namespace {

/// The sides of all pieces, of the boundary first, with what SideOfCurve does not have.
struct ChartSides {
  std::vector<SideOfCurve> sides;
  std::vector<SpaceCurve> space;
  std::vector<int> faces;   ///< on the left; -1: unknown
  std::vector<int> starts;  ///< the curve of the boundary that starts where the side starts; -1: none
  std::vector<int> ends;    ///< likewise: that ends where it ends
};

ChartSides sides_of(const CadFace& face, const std::vector<ChartCurve>& curves, const ChartRegionOptions& options,
                    const std::vector<ChartPiece>& pieces) {
  ChartSides all;
  const auto add = [&](const ChartPiece& p, int twin, bool is_back) {
    const bool is_outer = p.curve < face.num_curves();
    const int inner = p.curve - face.num_curves(), outer = is_outer && is_back ? face.partners[p.curve] : p.curve;
    const std::string name =
        is_outer ? (face.has_given_name(outer) ? face.curve_names[outer] : "") : curves[inner].name;
    SideOfCurve side{
        {p.image, is_outer ? face.curve_cad_edges[outer] : curves[inner].cad_edge, name}, p.from, p.to, twin};
    if (is_back) side.curve.curve = curve::reversed(p.image), std::swap(side.from, side.to);
    all.sides.push_back(std::move(side));
    all.space.push_back(is_back ? surface::reversed(p.space) : p.space);
    all.faces.push_back(is_outer ? options.curve_faces[outer] : curves[inner].faces[is_back ? 1 : 0]);
    all.starts.push_back(is_outer && (is_back ? p.is_last : p.is_first) ? outer : -1);
    all.ends.push_back(is_outer && (is_back ? p.is_first : p.is_last) ? outer : -1);
  };
  for (const ChartPiece& p : pieces) {
    const int number = static_cast<int>(all.sides.size());
    const bool has_back = p.curve >= face.num_curves() || face.is_interface(p.curve);
    add(p, has_back ? number + 1 : -1, false);
    if (has_back) add(p, number, true);
  }
  return all;
}

using RegionLoops = std::vector<std::vector<int>>;

/// Which region belongs to which face of the file, and their order.
class RegionFaces {
 public:
  RegionFaces(const ChartSides& all, std::vector<RegionLoops> regions, const ChartRegionOptions& options)
      : all_(all), regions_(std::move(regions)), options_(options), region_of_(all.sides.size(), -1) {
    for (std::size_t r = 0; r < regions_.size(); ++r)
      for (const std::vector<int>& loop : regions_[r])
        for (const int s : loop) region_of_[s] = static_cast<int>(r);
    join_across_free_curves();
    for (std::size_t r = 0; r < regions_.size(); ++r) faces_.push_back(face_of(static_cast<int>(r)));
  }

  /// In the order of their faces, and of one face as they were found.
  std::vector<std::pair<int, RegionLoops>> sorted() const {
    std::vector<std::pair<int, RegionLoops>> result;
    for (std::size_t r = 0; r < regions_.size(); ++r) result.emplace_back(faces_[r], regions_[r]);
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return result;
  }

 private:
  /// Sides of one face: regions on both sides of a curve that belongs to no face are parts of one face.
  void join_across_free_curves() {
    DisjointSets parts(regions_.size());
    for (std::size_t s = 0; s < all_.sides.size(); ++s)
      if (all_.faces[s] < 0) parts.unite(region_of_[s], region_of_[all_.sides[s].twin]);
    for (std::size_t r = 0; r < regions_.size(); ++r) part_of_.push_back(parts.find(static_cast<int>(r)));
  }

  int face_of(int region) const {
    int found = -1;
    for (std::size_t s = 0; s < all_.sides.size(); ++s) {
      if (all_.faces[s] < 0 || part_of_[region_of_[s]] != part_of_[region]) continue;
      if (found >= 0 && all_.faces[s] != found)
        throw FormatError(fmt::format("{}: faces {} and {} of the file overlap beside edge {}: draw them side by side",
                                      options_.file, found, all_.faces[s], all_.sides[s].curve.cad_edge));
      found = all_.faces[s];
    }
    return std::max(found, 0);
  }

  const ChartSides& all_;
  std::vector<RegionLoops> regions_;
  const ChartRegionOptions& options_;
  std::vector<int> region_of_;  ///< of each side
  std::vector<int> part_of_;    ///< of each region: those of one part have one face
  std::vector<int> faces_;      ///< of each region
};

/// The face, region after region.
class Assembler {
 public:
  Assembler(const CadFace& face, const ChartSides& all, const ChartRegionOptions& options)
      : old_(face), all_(all), options_(options), face_(face), numbers_(all.sides.size(), -1) {
    face_.curves.clear(), face_.curve_cad_edges.clear(), face_.curve_names.clear(), face_.joints.clear();
    face_.partners.clear(), face_.region_names.clear();
    face_.loop_offsets = face_.region_loops = {0};
  }

  void add(int file_face, const RegionLoops& loops) {
    for (const std::vector<int>& loop : loops) {
      for (const int s : loop) {
        numbers_[s] = face_.num_curves();
        used_.push_back(s);
        face_.curves.push_back(all_.sides[s].curve.curve);
        face_.curve_cad_edges.push_back(all_.sides[s].curve.cad_edge);
        face_.curve_names.push_back(all_.sides[s].curve.name);
      }
      face_.loop_offsets.push_back(face_.num_curves());
    }
    face_.region_loops.push_back(face_.num_loops());
    face_.region_names.push_back(options_.face_names[file_face]);
    file_faces_.push_back(file_face);
  }

  CadFace assembled() {
    auto chart = std::make_shared<Chart>(*old_.chart);
    chart->space_curves.clear();
    for (const int s : used_) {
      chart->space_curves.push_back(all_.space[s]);
      face_.partners.push_back(all_.sides[s].twin < 0 ? -1 : numbers_[all_.sides[s].twin]);
    }
    face_.chart = std::move(chart);
    for (int i = 0; i < face_.num_curves(); ++i) face_.joints.push_back(joint(i));
    face_.unnamed_curves = replace_empty_names(face_.curve_names, "curve");
    for (const int r : replace_empty_names(face_.region_names, "region"))
      if (r > 0 && file_faces_[r - 1] == file_faces_[r]) face_.region_names[r] = face_.region_names[r - 1];
    if (file_faces_.size() == 1) {
      face_.name = options_.face_names[file_faces_.front()];
      face_.region_loops.clear(), face_.region_names.clear();
    }
    return std::move(face_);
  }

 private:
  /// Joints of the boundary that no inner curve meets have the angles of space; at the tip of a slit all around is the
  /// face.
  Joint joint(int i) const {
    const int in = face_.previous_in_loop(i), curve = all_.starts[used_[i]];
    if (curve >= 0 && all_.ends[used_[in]] == old_.previous_in_loop(curve)) return old_.joints[curve];
    Joint joint = outline::joint_between(face_.curves[in], face_.curves[i], options_.corner_angle);
    if (face_.partners[i] == in) joint.interior_angle = 2 * pi, joint.is_corner = true;
    return joint;
  }

  const CadFace& old_;
  const ChartSides& all_;
  const ChartRegionOptions& options_;
  CadFace face_;
  std::vector<int> numbers_, used_;  ///< new numbers of sides, and back
  std::vector<int> file_faces_;      ///< of each region
};

/// As far as refuse_cusps asks.
void refuse_cusps_of(const ChartSides& all, const RegionLoops& loops, const std::string& file) {
  Region region;
  std::vector<int> numbers(all.sides.size(), -1), used;
  for (const std::vector<int>& loop : loops) {
    for (const int s : loop)
      numbers[s] = region.num_curves(), used.push_back(s), region.curves.push_back(all.sides[s].curve);
    region.loop_offsets.push_back(region.num_curves());
  }
  for (const int s : used) region.other_sides.push_back(all.sides[s].twin < 0 ? -1 : numbers[all.sides[s].twin]);
  refuse_cusps(region, file);
}

}  // namespace

CadFace divided_chart(const CadFace& face, const std::vector<ChartCurve>& curves, const ChartRegionOptions& options,
                      Report& report) {
  const ChartSides all =
      sides_of(face, curves, options, chart_pieces(face, curves, {options.file, options.tolerance, options.slip}));
  Assembler assembler(face, all, options);
  for (const auto& [file_face, loops] : RegionFaces(all, regions_of_sides(all.sides), options).sorted()) {
    refuse_cusps_of(all, loops, options.file);
    assembler.add(file_face, loops);
  }
  CadFace divided = assembler.assembled();
  int num_interfaces = 0, num_inner = 0;
  for (int i = 0; i < divided.num_curves(); ++i)
    if (const int other = divided.partners[i]; other > i)
      ++(divided.region_of_loop(divided.loop_of(i)) == divided.region_of_loop(divided.loop_of(other)) ? num_inner
                                                                                                      : num_interfaces);
  report.set("sew.interfaces", num_interfaces);
  report.set("sew.inner_curves", num_inner);
  return divided;
}

}  // namespace quadrille::sew
