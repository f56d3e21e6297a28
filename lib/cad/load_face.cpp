#include "cad/load_face.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <Standard_Failure.hxx>
#include <functional>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "cad/curve_names.hpp"
#include "cad/face_bytes.hpp"
#include "cad/file_kind.hpp"
#include "cad/occ_face.hpp"
#include "cad/occ_load.hpp"
#include "cad/step_faults.hpp"
#include "heal/heal_face.hpp"
#include "outline/assemble_face.hpp"

namespace quadrille::cad {
namespace {

// Third-party readers write to stdout and stderr, which are reserved for data and messages of the tools.
void silence() {
  const int null = open("/dev/null", O_WRONLY);
  if (null < 0) return;
  dup2(null, STDOUT_FILENO);
  dup2(null, STDERR_FILENO);
  close(null);
}

// Time limit of the child process; a face with thousands of edges takes less than a second.
constexpr int most_seconds = 60;

// Errors of the kernel and of computations in `work` become errors of the file.
template <class Work>
auto of_file(const std::string& name, CadFormat format, Work work) {
  try {
    return work();
  } catch (const Standard_Failure& e) {
    const std::string message = e.GetMessageString();
    throw FormatError(name + ": the shape in the " + format_name(format) +
                      " file is broken: " + (message.empty() ? e.DynamicType()->Name() : message));
  } catch (const ComputeError& e) {
    throw FormatError(name + ": " + e.what());
  }
}

// Runs `work` in a child process, with the name and, after a crash, the fault of the file in its error.
std::string guarded(const std::string& bytes, const std::string& name, const std::function<std::string()>& work) {
  const CadFormat format = cad_format(bytes, name);
  const std::string crash =
      name + ": the file is malformed: the " + format_name(format) + " reader crashed or did not end";
  const auto silent_work = [&] {
    silence();
    return work();
  };
  try {
    return run_in_child(silent_work, crash, most_seconds);
  } catch (const FormatError& e) {
    // After a crash of the reader, search the file for an error that the user can correct.
    const std::string fault = e.what() == crash && format == CadFormat::step ? step_fault(bytes) : std::string();
    if (fault.empty()) throw;
    throw FormatError(name + ": the file is malformed: " + fault);
  }
}

}  // namespace

LoadedFace load_face(const std::string& bytes, const std::string& name, const LoadOptions& options, Report& report) {
  const CadFormat format = cad_format(bytes, name);
  report.set("input.format", format_name(format));
  return of_file(name, format, [&] {
    const OccModel model = occ_load(format, bytes, name);
    const FaceChoice choice = choose_face(model, options.face, name);
    heal::RawFace raw = occ_face(model, choice.face, name, report);
    choose_names(raw);
    LoadedFace loaded;
    loaded.repairs = heal::heal_face(raw, {options.heal_tolerance}, outline::raw_diameter(raw), report);
    loaded.face =
        outline::assemble_face(raw, {options.corner_angle, options.blunt_width, choice.piece}, loaded.repairs, report);
    return loaded;
  });
}

LoadedFace load_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                             Report& report) {
  const auto work = [&] {
    Report inner;
    const LoadedFace loaded = load_face(bytes, name, options, inner);
    return to_bytes(loaded, inner);
  };
  return from_bytes(guarded(bytes, name, work), report);
}

FaceList list_faces_guarded(const std::string& bytes, const std::string& name) {
  const auto work = [&] {
    const CadFormat format = cad_format(bytes, name);
    return of_file(name, format, [&] { return to_bytes(list_faces(occ_load(format, bytes, name))); });
  };
  return list_from_bytes(guarded(bytes, name, work));
}

}  // namespace quadrille::cad
