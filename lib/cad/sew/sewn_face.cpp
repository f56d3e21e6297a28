#include "sew/sewn_face.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/name_text.hpp"
#include "curve/simplify_spline.hpp"
#include "heal/heal_face.hpp"
#include "heal/heal_rules.hpp"
#include "outline/assemble_face.hpp"
#include "outline/extent.hpp"
#include "outline/face_of_loops.hpp"
#include "sew/embed_curves.hpp"
#include "sew/inner_curves.hpp"
#include "sew/one_sheet.hpp"
#include "sew/sew_regions.hpp"

namespace quadrille::sew {

namespace {

/// Both sides of a common curve with one name.
std::vector<heal::LoopCurve> named_curves(const Sewn& sewn, int r) {
  std::vector<heal::LoopCurve> curves = sewn.regions[r].curves;
  for (size_t c = 0; c < curves.size(); ++c) {
    const CurveId partner = sewn.partners[r][c];
    if (!partner.exists()) continue;
    const std::string& other = sewn.regions[partner.region].curves[partner.curve].name;
    const bool is_first = std::pair(r, static_cast<int>(c)) < std::pair(partner.region, partner.curve);
    if (curves[c].name.empty() || (!is_first && !other.empty())) curves[c].name = other;
  }
  return curves;
}

std::vector<heal::Loop> all_loops(const Sewn& sewn) {
  std::vector<heal::Loop> loops;
  for (int r = 0; r < static_cast<int>(sewn.regions.size()); ++r) {
    const std::vector<heal::LoopCurve> curves = named_curves(sewn, r);
    const std::vector<int>& offsets = sewn.regions[r].loop_offsets;
    for (size_t l = 0; l + 1 < offsets.size(); ++l)
      loops.emplace_back(curves.begin() + offsets[l], curves.begin() + offsets[l + 1]);
  }
  return loops;
}

std::vector<Nurbs> outlines_of(const Sewn& sewn) {
  std::vector<Nurbs> curves;
  for (const Region& region : sewn.regions)
    for (int c = 0; c < region.loop_offsets[1]; ++c) curves.push_back(region.curves[c].curve);
  return curves;
}

std::vector<int> partner_numbers(const Sewn& sewn) {
  std::vector<int> first{0}, numbers;
  for (const Region& region : sewn.regions) first.push_back(first.back() + region.num_curves());
  for (const auto& partners : sewn.partners)
    for (const CurveId id : partners) numbers.push_back(id.exists() ? first[id.region] + id.curve : -1);
  return numbers;
}

/// At the tip of a slit the curve turns back: all around it is the face.
void open_tips(CadFace& face) {
  for (int j = 0; j < face.num_curves(); ++j)
    if (face.partners[j] == face.previous_in_loop(j)) {
      face.joints[j].interior_angle = 2 * pi;
      face.joints[j].is_corner = true;
    }
}

}  // namespace

CadFace face_of_regions(const Sewn& sewn, const heal::RawFace& raw, double corner_angle) {
  CadFace face = outline::face_of_loops(raw, all_loops(sewn), outlines_of(sewn), corner_angle);
  face.partners = partner_numbers(sewn);
  face.region_loops = {0};
  for (const Region& region : sewn.regions) {
    face.region_loops.push_back(face.region_loops.back() + region.num_loops());
    face.region_names.push_back(region.name);
  }
  for (const int r : replace_empty_names(face.region_names, "region"))
    if (r > 0 && sewn.regions[r - 1].cad_face == sewn.regions[r].cad_face)  // a face that inner curves divide
      face.region_names[r] = face.region_names[r - 1];
  open_tips(face);
  if (sewn.regions.size() > 1) return face;
  face.name = sewn.regions.front().name;
  face.region_loops.clear(), face.region_names.clear();
  if (sewn.num_inner_curves == 0) face.partners.clear();
  return face;
}

namespace {

/// The whole as far as healing asks about it: the tolerances of all faces. Without healing, rounding errors are sewn.
heal::HealScale scale_of(const std::vector<heal::RawFace>& faces, double tolerance) {
  heal::RawFace whole;
  whole.file = faces.front().file;
  for (const heal::RawFace& face : faces) {
    whole.tolerance = std::max(whole.tolerance, face.tolerance);
    whole.shape_tolerance = std::max(whole.shape_tolerance, face.shape_tolerance);
    whole.wires.insert(whole.wires.end(), face.wires.begin(), face.wires.end());
  }
  heal::HealScale scale = heal::heal_scale(whole, tolerance, outline::raw_diameter(whole));
  scale.tolerance = std::max(scale.tolerance, scale.rounding);
  return scale;
}

int number_of(const std::vector<heal::RawFace>& faces, size_t f) {
  return faces[f].cad_face < 0 ? static_cast<int>(f) : faces[f].cad_face;
}

std::string text_of(const std::vector<heal::RawFace>& faces, size_t f) {
  return face_text({faces[f].name, number_of(faces, f), {}, {}, {}});
}

void require_one_plane(const std::vector<heal::RawFace>& faces, const heal::HealScale& scale) {
  for (size_t f = 1; f < faces.size(); ++f) {
    double height = 0;
    for (const auto& wire : faces[f].wires)
      for (const heal::RawEdge& edge : wire) height = std::max(height, edge.height);
    if (!(height <= scale.most_off_plane))
      throw FormatError(fmt::format(
          "{}: the file holds several faces ({}) that are not in one plane: {} is up to {:.3g} off the plane of {}: {}",
          scale.file, faces.size(), text_of(faces, f), height, text_of(faces, 0), face_choice_text));
  }
}

int num_edges_of(const heal::RawFace& raw) {
  int last = -1;
  for (const auto& wire : raw.wires)
    for (const heal::RawEdge& edge : wire) last = std::max(last, edge.cad_edge);
  for (const heal::RawEdge& edge : raw.inner_edges) last = std::max(last, edge.cad_edge);
  return last + 1;
}

/// The regions of the faces, healed one by one, with what was done.
class RegionMaker {
 public:
  RegionMaker(const heal::HealScale& scale, const SewOptions& options, std::vector<Repair>& repairs, Report& report)
      : scale_(scale), options_(options), repairs_(repairs), report_(report) {}

  void add_face(heal::RawFace raw, int number, bool is_single) {
    if (!is_single) raw.file += ": " + face_text({raw.name, number, {}, {}, {}});
    const int num_edges = num_edges_of(raw);
    move_open_wires(raw, scale_, report_);
    Report own;
    std::vector<Repair> repairs = heal::heal_face(raw, {options_.heal_tolerance}, outline::raw_diameter(raw), own);
    const outline::FacePiece piece = is_single ? options_.piece : outline::FacePiece{std::to_string(number), -1};
    const outline::AssembledLoops assembled = outline::assembled_loops(
        raw, {options_.corner_angle, options_.blunt_width, piece, options_.fit_tolerance, !is_single}, repairs, own);
    for (const auto& warning : own.warnings()) report_.warn(warning.code, warning.message);
    fit_distance_ = std::max(fit_distance_, assembled.fit_distance);
    Region region = region_of(assembled.loops, raw.name, number);
    std::vector<heal::LoopCurve> inner = inner_curves(region, raw.inner_edges, scale_);
    for (std::vector<heal::LoopCurve>* curves : {&region.curves, &inner})
      for (heal::LoopCurve& c : *curves) c.cad_edge += first_edge_;
    for (Repair& repair : repairs) repair.cad_edge += first_edge_, repairs_.push_back(repair);
    regions_.push_back(std::move(region));
    inner_.push_back(std::move(inner));
    first_edge_ += num_edges;
  }

  /// The regions with all embedded curves.
  std::vector<Region> regions(std::vector<heal::RawEdge> free_edges) {
    for (heal::RawEdge& edge : free_edges) edge.cad_edge += first_edge_;
    std::vector<heal::LoopCurve> free = embedded_edges(regions_, free_edges, scale_, report_);
    std::vector<heal::LoopCurve> all = free;
    for (const auto& curves : inner_) all.insert(all.end(), curves.begin(), curves.end());
    refuse_dangling_ends(regions_, all, scale_, most_slip_of(scale_, options_.heal_tolerance >= 0));
    simplify(free);
    std::vector<Region> result;
    for (size_t r = 0; r < regions_.size(); ++r) {
      simplify(inner_[r]);
      inner_[r].insert(inner_[r].end(), free.begin(), free.end());
      for (Region& piece : embed_curves(regions_[r], inner_[r], scale_.tolerance, scale_.file))
        result.push_back(std::move(piece));
    }
    return result;
  }

  double fit_distance() const { return fit_distance_; }

 private:
  void simplify(std::vector<heal::LoopCurve>& curves) {
    for (heal::LoopCurve& c : curves)
      if (options_.fit_tolerance > 0)
        if (auto simple = curve::simplified_spline(c.curve, options_.fit_tolerance * scale_.diameter)) {
          c.curve = std::move(simple->curve);
          fit_distance_ = std::max(fit_distance_, simple->distance);
        }
  }

  const heal::HealScale& scale_;
  const SewOptions& options_;
  std::vector<Repair>& repairs_;
  Report& report_;
  std::vector<Region> regions_;
  std::vector<std::vector<heal::LoopCurve>> inner_;  // by face
  int first_edge_ = 0;
  double fit_distance_ = 0;
};

void report_sewing(const Sewn& sewn, const CadFace& face, const std::vector<Repair>& repairs,
                   const heal::HealScale& scale, bool is_healed, Report& report) {
  double greatest = 0;
  for (const Repair& repair : repairs)
    if (repair.kind != RepairKind::fit && repair.kind != RepairKind::cusp)
      greatest = std::max(greatest, repair.distance);
  report.set("heal.tolerance", is_healed ? scale.tolerance / scale.diameter : 0);
  report.set("heal.repairs", repairs.size());
  report.set("heal.greatest", greatest / scale.diameter);
  for (size_t i = 0; i < repairs.size(); ++i) heal::report_repair(repairs[i], i, report);
  report.set("sew.interfaces", sewn.num_interfaces);
  report.set("sew.inner_curves", sewn.num_inner_curves);
  report.set("sew.greatest", sewn.greatest / scale.diameter);
  report.set("face.area", outline::area(face));
}

}  // namespace

bool are_to_be_sewn(const std::vector<heal::RawFace>& faces, const std::vector<heal::RawEdge>& free_edges) {
  if (faces.size() > 1 || !free_edges.empty() || !faces.front().inner_edges.empty()) return true;
  heal::RawFace face = faces.front();
  if (face.wires.size() < 2) return false;
  Report unused;
  move_open_wires(face, scale_of(faces, -1), unused);
  return !face.inner_edges.empty();
}

CadFace sewn_face(std::vector<heal::RawFace> faces, std::vector<heal::RawEdge> free_edges, const SewOptions& options,
                  std::vector<Repair>& repairs, Report& report) {
  const heal::HealScale scale = scale_of(faces, options.heal_tolerance);
  require_one_plane(faces, scale);
  RegionMaker maker(scale, options, repairs, report);
  for (size_t f = 0; f < faces.size(); ++f) maker.add_face(faces[f], number_of(faces, f), faces.size() == 1);
  const std::vector<Region> regions = maker.regions(std::move(free_edges));
  const Sewn sewn = sew_regions(regions, scale.tolerance);
  require_one_sheet(sewn, scale, options.heal_tolerance >= 0);
  CadFace face = face_of_regions(sewn, faces.front(), options.corner_angle);
  face.fit_distance = maker.fit_distance();
  report_sewing(sewn, face, repairs, scale, options.heal_tolerance != 0, report);
  return face;
}

}  // namespace quadrille::sew
