#include "cad/load_face.hpp"

#include <cctype>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "cad/face_bytes.hpp"
#include "cad/step_faults.hpp"

namespace quadrille::cad {
namespace {

// Time limit of the program; a face with thousands of edges takes less than a second.
constexpr int most_seconds = 60;

// What the program of the format answers.
std::string answer(CadFormat format, const CadRequest& request, const std::string& crash) {
  std::string name = format_name(format);
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return run_program(helper_program("cad2tri-" + name), to_bytes(request), crash, {.cpu_seconds = most_seconds});
}

// The answer about a file, with the fault of the file in the error after a crash.
std::string answer_about_file(const CadRequest& request) {
  const CadFormat format = cad_format(request.bytes, request.name);
  const std::string crash =
      request.name + ": the file is malformed: the " + format_name(format) + " reader crashed or did not end";
  try {
    return answer(format, request, crash);
  } catch (const FormatError& e) {
    // After a crash of the reader, search the file for an error that the user can correct.
    const std::string fault =
        e.what() == crash && format == CadFormat::step ? step_fault(request.bytes) : std::string();
    if (fault.empty()) throw;
    throw FormatError(request.name + ": the file is malformed: " + fault);
  }
}

}  // namespace

LoadedFace load_face_guarded(const std::string& bytes, const std::string& name, const LoadOptions& options,
                             Report& report) {
  return from_bytes(answer_about_file({CadTask::load, name, bytes, options, CadFace()}), report);
}

FaceList list_faces_guarded(const std::string& bytes, const std::string& name) {
  return list_from_bytes(answer_about_file({CadTask::list, name, bytes, LoadOptions(), CadFace()}));
}

std::string file_of_face(const CadFace& face, CadFormat format) {
  CadRequest request;
  request.task = CadTask::write;
  request.face = face;
  return answer(format, request,
                "the face cannot be written: the " + format_name(format) + " writer crashed or did not end");
}

}  // namespace quadrille::cad
