// Private helper of cad2tri, like cad2tri-step: reads and writes BREP.

#include "base/child_process.hpp"
#include "occ/read_face.hpp"

int main() {
  using namespace quadrille;
  answer_parent([](const std::string& request) { return occ::answer_request(occ::brep_format(), request); });
}
