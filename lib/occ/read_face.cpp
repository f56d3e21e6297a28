#include "occ/read_face.hpp"

#include <Standard_Failure.hxx>

#include "base/error.hpp"
#include "cad/curve_names.hpp"
#include "cad/face_bytes.hpp"
#include "heal/heal_face.hpp"
#include "occ/occ_face.hpp"
#include "occ/occ_load.hpp"
#include "outline/assemble_face.hpp"
#include "sew/sewn_face.hpp"

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

}  // namespace

cad::LoadedFace read_face(const KernelFormat& format, const std::string& bytes, const std::string& name,
                          const cad::LoadOptions& options, Report& report) {
  report.set("input.format", cad::format_name(format.format));
  return of_file(format, name, [&] {
    const OccModel model = occ_load(format, bytes, name);
    const std::vector<FaceChoice> choices = choose_faces(model, options.face, name);
    std::vector<heal::RawFace> raws = occ_faces(model, choices, name, report);
    for (heal::RawFace& raw : raws) cad::choose_names(raw);
    cad::LoadedFace loaded;
    if (raws.size() > 1) {
      for (size_t f = 0; f < raws.size(); ++f)
        if (raws[f].name.empty()) raws[f].name = choices[f].part;
      loaded.face = sew::sewn_face(
          raws, {options.corner_angle, options.blunt_width, options.fit_tolerance, options.heal_tolerance},
          loaded.repairs, report);
      return loaded;
    }
    heal::RawFace& raw = raws.front();
    loaded.repairs = heal::heal_face(raw, {options.heal_tolerance}, outline::raw_diameter(raw), report);
    loaded.face = outline::assemble_face(
        raw, {options.corner_angle, options.blunt_width, choices.front().piece, options.fit_tolerance}, loaded.repairs,
        report);
    return loaded;
  });
}

std::string answer(const KernelFormat& format, const std::string& request) {
  const cad::CadRequest r = cad::request_from_bytes(request);
  if (r.task == cad::CadTask::write) {
    if (format.write == nullptr) throw Defect("no face is written as " + cad::format_name(format.format));
    return format.write(r.face);
  }
  if (r.task == cad::CadTask::list)
    return of_file(format, r.name, [&] { return cad::to_bytes(list_faces(occ_load(format, r.bytes, r.name))); });
  Report report;
  const cad::LoadedFace loaded = read_face(format, r.bytes, r.name, r.options, report);
  return cad::to_bytes(loaded, report);
}

}  // namespace quadrille::occ
