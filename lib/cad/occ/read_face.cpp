#include "occ/read_face.hpp"

#include <fmt/format.h>

#include <Standard_Failure.hxx>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/warning_codes.hpp"
#include "cad/curve_names.hpp"
#include "cad/loaded_face.hpp"
#include "cad/region_names.hpp"
#include "heal/heal_face.hpp"
#include "heal/heal_rules.hpp"
#include "heal/wire_edges.hpp"
#include "occ/occ_face.hpp"
#include "occ/occ_model.hpp"
#include "occ/occ_triangles.hpp"
#include "outline/assemble_face.hpp"
#include "sew/one_sheet.hpp"
#include "sew/sewn_face.hpp"
#include "space/assemble_space_face.hpp"
#include "space/space_curve.hpp"
#include "space/surface_kinks.hpp"

namespace quadrille::occ {

namespace {

// Errors of the kernel and of computations in `work` become errors of the file.
template <class Work>
auto of_file(const KernelFormat& format, const std::string& name, Work work) {
  try {
    return work();
  } catch (const Standard_Failure& e) {
    const std::string message = e.GetMessageString();
    throw FormatError(name + ": the shape in the " + cad::format_name(format.format) +
                      " file is broken: " + (message.empty() ? e.DynamicType()->Name() : message));
  } catch (const ComputeError& e) {
    throw FormatError(name + ": " + e.what());
  }
}

// As for the edges of a face without a layer.
void choose_names_of(std::vector<heal::RawEdge>& edges) {
  heal::RawFace raw;
  raw.inner_edges = std::move(edges);
  cad::choose_names(raw);
  edges = std::move(raw.inner_edges);
}

/// The shapes of a file, or those in which a plane cuts its solids.
OccModel loaded(const KernelFormat& format, const std::string& bytes, const std::string& name,
                const cad::LoadOptions& options, Report& report) {
  OccModel model = occ_load(format, bytes, name);
  if (!options.section.is_given()) return model;
  if (format.cut == nullptr) throw Defect("a section was asked of the program of one format");
  return format.cut(model, options.section, name, report);
}

/// The face that the curves of a file without faces bound.
FacesAndEdges closed_curves(const OccModel& model, double tolerance, const std::string& name, Report& report) {
  FacesAndEdges found = face_of_curves(model, name, report);
  heal::RawFace& raw = found.faces.front();
  const auto num_edges = raw.wires.front().size();
  heal::close_wires(raw, heal::heal_scale(raw, tolerance, outline::raw_diameter(raw)));
  report.warn(warning::face_of_curves,
              fmt::format("{}: the file holds no face: {} that close, in {}, were taken as the boundary of one", name,
                          counted(num_edges, "curve"), counted(raw.wires.size(), "loop")));
  return found;
}

cad::LoadedFace planar_face(const OccModel& model, const std::string& name, const cad::LoadOptions& options,
                            Report& report) {
  const bool has_no_face = model.num_faces == 0 && options.face.empty();
  const std::vector<FaceChoice> choices =
      has_no_face ? std::vector<FaceChoice>(1) : choose_faces(model, options.face, name);
  FacesAndEdges found = has_no_face ? closed_curves(model, options.heal_tolerance, name, report)
                                    : occ_faces(model, choices, name, report);
  for (size_t f = 0; f < choices.size(); ++f) {
    cad::choose_names(found.faces[f]);
    if (found.faces[f].name.empty()) found.faces[f].name = choices[f].part;
  }
  choose_names_of(found.free_edges);
  cad::LoadedFace loaded;
  if (sew::are_to_be_sewn(found.faces, found.free_edges)) {
    loaded.face = sew::sewn_face(found.faces, found.free_edges,
                                 {options.corner_angle, options.blunt_width, options.fit_tolerance,
                                  options.heal_tolerance, choices.front().piece},
                                 loaded.repairs, report);
    cad::name_interfaces(loaded.face);
  } else {
    heal::RawFace& raw = found.faces.front();
    loaded.repairs = heal::heal_face(raw, {options.heal_tolerance}, outline::raw_diameter(raw), report);
    loaded.face = outline::assemble_face(
        raw, {options.corner_angle, options.blunt_width, choices.front().piece, options.fit_tolerance}, loaded.repairs,
        report);
  }
  warn_of_ignored(found, name, report);
  return loaded;
}

/// Pieces are for planes.
std::vector<FaceChoice> choose_whole_faces(const OccModel& model, const std::string& choice, const std::string& name) {
  std::vector<FaceChoice> choices = choose_faces(model, choice, name);
  if (choices.front().piece.number >= 0)
    throw FormatError(name + ": only planar faces have pieces: choose the whole face");
  return choices;
}

void require_smooth(const space::RawSpaceFace& raw, double angle) {
  if (const auto kink = space::kink_inside(raw, angle))
    throw FormatError(fmt::format(
        "{}: the surface of the face has a kink of {:.3g} degrees along {} = {:.6g}, at {}: "
        "cut the face there in the CAD program",
        raw.labels.file, degrees(kink->angle), kink->is_u ? "u" : "v", kink->parameter, position_text(kink->position)));
}

/// "plane" if all chosen faces are planar, else the kind of the first that is not.
std::string chosen_kind(const OccModel& model, const std::string& choice, const std::string& name) {
  if (model.num_faces == 0) return "plane";
  for (const FaceChoice& chosen : choose_faces(model, choice, name))
    if (std::string kind = kind_of(chosen.face); kind != "plane") return kind;
  return "plane";
}

SpaceFace curved_face(const OccModel& model, const std::string& name, const cad::LoadOptions& options, Report& report) {
  const std::vector<FaceChoice> choices = choose_whole_faces(model, options.face, name);
  space::RawSpaceFace raw;
  raw.labels = labels_of_face(model, choices.front().face, name);
  if (!options.face.empty()) raw.labels.file += ": face " + options.face;  // the begin of all messages
  raw.face_names.clear();
  for (const FaceChoice& choice : choices) {
    require_unscaled(choice.face, name);
    const std::string own = model.label_of(choice.face).name;
    raw.face_names.push_back(own.empty() ? choice.part : own);
  }
  read_curved_face(model, choices, options.heal_tolerance, raw, report);
  cad::choose_names(raw.labels);
  if (choices.size() == 1) raw.face_names = {raw.labels.name};
  report.set("surface.kind", kind_of(choices.front().face));
  require_smooth(raw, options.corner_angle);
  return space::assemble_space_face(raw, options.heal_tolerance, report);
}

}  // namespace

cad::LoadedFace read_face(const KernelFormat& format, const std::string& bytes, const std::string& name,
                          const cad::LoadOptions& options, Report& report) {
  report.set("input.format", cad::format_name(format.format));
  return of_file(format, name,
                 [&] { return planar_face(loaded(format, bytes, name, options, report), name, options, report); });
}

SpaceFace read_space_face(const KernelFormat& format, const std::string& bytes, const std::string& name,
                          const cad::LoadOptions& options, Report& report) {
  report.set("input.format", cad::format_name(format.format));
  return of_file(format, name, [&] { return curved_face(occ_load(format, bytes, name), name, options, report); });
}

cad::AnyFace read_any_face(const KernelFormat& format, const std::string& bytes, const std::string& name,
                           const cad::LoadOptions& options, Report& report) {
  report.set("input.format", cad::format_name(format.format));
  return of_file(format, name, [&]() -> cad::AnyFace {
    const OccModel model = loaded(format, bytes, name, options, report);
    if (chosen_kind(model, options.face, name) == "plane") return planar_face(model, name, options, report);
    return curved_face(model, name, options, report);
  });
}

std::string answer_request(const KernelFormat& format, const std::string& request) {
  const cad::CadRequest r = cad::request_from_bytes(request);
  if (r.task == cad::CadTask::write) {
    if (format.write == nullptr) throw Defect("no face is written as " + cad::format_name(format.format));
    return format.write(r.face);
  }
  Report report;
  if (r.task == cad::CadTask::list)
    return of_file(format, r.name,
                   [&] { return cad::to_bytes(list_faces(loaded(format, r.bytes, r.name, r.options, report))); });
  if (r.task == cad::CadTask::kind)
    return of_file(format, r.name,
                   [&] { return chosen_kind(occ_load(format, r.bytes, r.name), r.options.face, r.name); });
  if (r.task == cad::CadTask::load_any)
    return cad::to_bytes(read_any_face(format, r.bytes, r.name, r.options, report), report);
  if (r.task == cad::CadTask::load_space)
    return cad::to_bytes(read_space_face(format, r.bytes, r.name, r.options, report), report);
  const cad::LoadedFace loaded = read_face(format, r.bytes, r.name, r.options, report);
  return cad::to_bytes(loaded, report);
}

}  // namespace quadrille::occ
