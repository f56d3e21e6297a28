// Private helper of quadexport: makes a CGNS file. A separate program, because the CGNS library writes to files alone,
// and to keep it out of all other processes of a chain.

#include <cstdlib>
#include <filesystem>

#include "base/child_process.hpp"
#include "base/error.hpp"
#include "cgns/write_cgns.hpp"
#include "export/cgns_request.hpp"

using namespace quadrille;

namespace {

std::string temporary_folder() {
  std::error_code error;
  const std::filesystem::path parent = std::filesystem::temp_directory_path(error);
  if (error) throw OutputError("no folder for temporary files: set TMPDIR to one: " + error.message());
  return (parent / "quadexport-XXXXXX").string();
}

std::string cgns_file_of(const std::string& request) {
  std::string folder = temporary_folder();
  if (mkdtemp(folder.data()) == nullptr) throw OutputError(folder + ": cannot make a temporary folder");
  try {
    std::string bytes = cgns::cgns_file(exports::cgns_request(request), folder + "/mesh.cgns");
    std::filesystem::remove_all(folder);
    return bytes;
  } catch (...) {
    std::filesystem::remove_all(folder);
    throw;
  }
}

}  // namespace

int main() { answer_parent(cgns_file_of); }
