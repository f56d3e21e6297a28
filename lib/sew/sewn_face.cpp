#include "sew/sewn_face.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "heal/heal_face.hpp"
#include "heal/heal_scale.hpp"
#include "heal/report_repair.hpp"
#include "outline/assemble_face.hpp"
#include "outline/extent.hpp"
#include "outline/face_of_loops.hpp"
#include "sew/face_of_regions.hpp"
#include "sew/one_sheet.hpp"
#include "sew/sew_regions.hpp"

namespace quadrille::sew {
namespace {

/// The whole as far as healing asks about it: the tolerances of all faces.
heal::HealScale scale_of(const std::vector<heal::RawFace>& faces, double tolerance) {
  heal::RawFace whole;
  whole.file = faces.front().file;
  for (const heal::RawFace& face : faces) {
    whole.tolerance = std::max(whole.tolerance, face.tolerance);
    whole.shape_tolerance = std::max(whole.shape_tolerance, face.shape_tolerance);
    whole.wires.insert(whole.wires.end(), face.wires.begin(), face.wires.end());
  }
  return heal::heal_scale(whole, tolerance, outline::raw_diameter(whole));
}

void require_one_plane(const std::vector<heal::RawFace>& faces, const heal::HealScale& scale) {
  for (size_t f = 1; f < faces.size(); ++f) {
    double height = 0;
    for (const auto& wire : faces[f].wires)
      for (const heal::RawEdge& edge : wire) height = std::max(height, edge.height);
    if (!(height <= scale.most_off_plane))
      throw FormatError(
          fmt::format("{}: the file holds several faces ({}) that are not in one plane: {} is up to {:.3g} "
                      "off the plane of {}: {}",
                      scale.file, faces.size(), face_text({faces[f].name, static_cast<int>(f), {}, {}, {}}), height,
                      face_text({faces[0].name, 0, {}, {}, {}}), face_choice_text));
  }
}

int num_edges_of(const heal::RawFace& raw) {
  int last = -1;
  for (const auto& wire : raw.wires)
    for (const heal::RawEdge& edge : wire) last = std::max(last, edge.cad_edge);
  return last + 1;
}

/// Heals the faces one by one and collects what was done.
class Healer {
 public:
  Healer(const SewOptions& options, std::vector<Repair>& repairs, Report& report)
      : options_(options), repairs_(repairs), report_(report) {}

  Region region(heal::RawFace raw, int number) {
    raw.file += ": " + face_text({raw.name, number, {}, {}, {}});
    const int num_edges = num_edges_of(raw);
    Report own;
    std::vector<Repair> repairs = heal::heal_face(raw, {options_.heal_tolerance}, outline::raw_diameter(raw), own);
    const outline::AssembledLoops assembled = outline::assembled_loops(
        raw, {options_.corner_angle, options_.blunt_width, {std::to_string(number), -1}, options_.fit_tolerance},
        repairs, own);
    for (const auto& warning : own.warnings()) report_.warn(warning.code, warning.message);
    fit_distance_ = std::max(fit_distance_, assembled.fit_distance);
    Region region = region_of(assembled.loops, raw.name, number);
    for (heal::LoopCurve& c : region.curves) c.cad_edge += first_edge_;
    for (Repair& repair : repairs) repair.cad_edge += first_edge_, repairs_.push_back(repair);
    first_edge_ += num_edges;
    return region;
  }

  double fit_distance() const { return fit_distance_; }

 private:
  const SewOptions& options_;
  std::vector<Repair>& repairs_;
  Report& report_;
  int first_edge_ = 0;
  double fit_distance_ = 0;
};

void report_sewing(const Sewn& sewn, const CadFace& face, const std::vector<Repair>& repairs,
                   const heal::HealScale& scale, Report& report) {
  double greatest = 0;
  for (const Repair& repair : repairs)
    if (repair.kind != RepairKind::fit && repair.kind != RepairKind::cusp)
      greatest = std::max(greatest, repair.distance);
  report.set("heal.tolerance", scale.tolerance / scale.diameter);
  report.set("heal.repairs", repairs.size());
  report.set("heal.greatest", greatest / scale.diameter);
  for (size_t i = 0; i < repairs.size(); ++i) heal::report_repair(repairs[i], i, report);
  report.set("sew.interfaces", sewn.num_interfaces);
  report.set("sew.greatest", sewn.greatest / scale.diameter);
  report.set("face.area", outline::area_of(face));
}

}  // namespace

CadFace sewn_face(std::vector<heal::RawFace> faces, const SewOptions& options, std::vector<Repair>& repairs,
                  Report& report) {
  const heal::HealScale scale = scale_of(faces, options.heal_tolerance);
  require_one_plane(faces, scale);
  Healer healer(options, repairs, report);
  std::vector<Region> regions;
  for (size_t f = 0; f < faces.size(); ++f) regions.push_back(healer.region(faces[f], static_cast<int>(f)));
  const Sewn sewn = sew_regions(regions, std::max(scale.tolerance, scale.rounding));
  require_one_sheet(sewn, scale, options.heal_tolerance >= 0);
  CadFace face = face_of_regions(sewn, faces.front(), options.corner_angle);
  face.fit_distance = healer.fit_distance();
  report_sewing(sewn, face, repairs, scale, report);
  return face;
}

}  // namespace quadrille::sew
