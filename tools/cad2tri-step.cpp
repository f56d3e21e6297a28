// Private helper of cad2tri: reads and writes STEP. A program of its own, because loading the CAD kernel's libraries of
// a format takes longer than meshing a small face.

#include "base/child_process.hpp"
#include "occ/read_face.hpp"

int main() {
  using namespace quadrille;
  answer_parent([](const std::string& request) { return occ::answer_request(occ::step_format(), request); });
}
