#include "stage/cad2chart.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "cad/file_kind.hpp"
#include "cad/load_face.hpp"
#include "cad/region_names.hpp"
#include "chart/inner_images.hpp"
#include "chart/make_chart.hpp"
#include "outline/outline_checks.hpp"
#include "sew/chart_regions.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::stage {
namespace {

/// Charts of faces that turn far may overlap themselves, though they fold nowhere.
void require_simple_outline(const CadFace& face) {
  std::vector<std::vector<Nurbs>> loops;
  for (int l = 0; l < face.num_loops(); ++l)
    loops.emplace_back(face.curves.begin() + face.loop_offsets[l], face.curves.begin() + face.loop_offsets[l + 1]);
  const auto contact = outline::find_contact(loops, outline::contact_share * face.diameter);
  if (!contact) return;
  const auto place = [&](int loop, int curve, double t) {
    return position_text(surface::point(face.chart->space_curves[face.loop_offsets[loop] + curve], t));
  };
  throw ComputeError(fmt::format(
      "the chart of the face overlaps itself: its boundary at {} crosses that at {}: cut the face in two between them "
      "in the CAD system",
      place(contact->loop_a, contact->curve_a, contact->t_a), place(contact->loop_b, contact->curve_b, contact->t_b)));
}

/// The chart with cracks and the common edges of faces, as they are there in a plane.
CadFace with_inner_curves(const CadFace& face, const SpaceFace& space_face, const std::string& file,
                          double corner_angle, Report& report) {
  if (space_face.inner_curves.empty()) return face;
  std::vector<sew::ChartCurve> curves;
  for (chart::ImagedCurve& curve : chart::inner_curves_in_chart(space_face, face)) {
    const InnerSpaceCurve& inner = space_face.inner_curves[curves.size()];
    curves.push_back({std::move(curve.image), std::move(curve.space), inner.name, inner.cad_edge, inner.faces});
  }
  CadFace divided = sew::divided_chart(
      face, curves, {file, space_face.tolerance, corner_angle, space_face.face_names, space_face.curve_faces}, report);
  cad::name_interfaces(divided);
  return divided;
}

}  // namespace

void declare(Options& o, Cad2chartOptions& cad2chart) {
  o.text("--face", cad2chart.face, "N|NAME",
         "the face to read of a solid, shell or assembly: its name, or its number in cad2tri --list, from 0, or the "
         "name of a part or layer that holds no other face; N,N: several faces of one surface, as regions");
  o.number("--corner-angle", cad2chart.corner_angle, 0, 90, "degrees",
           "tangent discontinuities greater than this are corners of the layout; a surface whose normal jumps by more "
           "inside the face is refused");
  o.number("--heal-tolerance", cad2chart.heal_tolerance, -1, 5e-3, "diameters",
           "the most that the ends of edges which do not meet are moved; 0: no healing; -1: 1e-5, or the tolerances of "
           "the shape if they are larger");
  o.number("--closedness", cad2chart.closedness, 1e-12, 1e-3, "radians",
           "the error of angles in the chart at which its elements are no longer split; on a surface that is not "
           "smooth, up to "
           "1e-3 is accepted");
  o.number("--scale-range", cad2chart.scale_range, 1.01, 1e6, "ratio",
           "the greatest ratio of lengths in space over those in the chart at two points; a face with more is refused");
}

ChartedFace cad2chart(const Input<std::string>& cad, const Cad2chartOptions& options, Run& run) {
  require_intervals(options);
  run.begin_phase("load");
  cad::LoadOptions load;
  load.corner_angle = radians(options.corner_angle);
  load.heal_tolerance = options.heal_tolerance, load.face = options.face;
  return cad2chart(cad::load_space_face_guarded(cad.model, cad.file.name, load, run.report()), cad, options, run);
}

ChartedFace cad2chart(const SpaceFace& space_face, const Input<std::string>& cad, const Cad2chartOptions& options,
                      Run& run) {
  require_intervals(options);
  const std::string& name = cad.file.name;
  const double corner_angle = radians(options.corner_angle);
  run.begin_phase("chart");
  ChartedFace charted;
  chart::ChartOptions limits;
  limits.closedness = options.closedness, limits.corner_angle = corner_angle;
  limits.greatest_scale_range = options.scale_range;
  try {
    charted.face = chart::make_chart(space_face, limits, run.report());
    require_simple_outline(charted.face);
    charted.face = with_inner_curves(charted.face, space_face, name, corner_angle, run.report());
  } catch (const ComputeError& e) {
    throw ComputeError(fmt::format("{}{}: {}", name, options.face.empty() ? "" : ": face " + options.face, e.what()));
  }
  if (const double closedness = charted.face.chart->closedness; closedness > options.closedness)
    run.report().warn(
        warning::closedness_missed,
        fmt::format(
            "{}: angles in the chart are wrong by up to {:.1e} radians, more than {:.1e}, because the surface is "
            "not smooth somewhere; the mesh is valid and on the surface all the same: see --closedness",
            name, closedness, options.closedness));
  run.end_phase();
  charted.provenance =
      with_step({}, "cad2chart", options, {cad.file.digest(cad::format_stem(cad::cad_format(cad.model, name)))});
  run.info(fmt::format("{}, {} of order {}, closedness {:.1e}", counted(charted.face.num_curves(), "curve"),
                       counted(charted.face.chart->num_elems(), "element"), charted.face.chart->order,
                       charted.face.chart->closedness));
  return charted;
}

}  // namespace quadrille::stage
