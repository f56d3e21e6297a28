// How much room the irregular nodes of a layout have.
//
//   node_room FIELD CRITICAL_POINTS     writes one line of JSON
//
// In diameters: the least distance of a node to the boundary and to another node, and for each node its valence, its
// place as the file has it, and its distance to the boundary.

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "curve/face_boundary.hpp"
#include "io/stage_files.hpp"
#include "io/whole_file.hpp"

using namespace quadrille;

namespace {

std::string number_or_null(double x) { return x < 1e9 ? fmt::format("{:.5g}", x) : "null"; }

void tell_room(const CadFace& face, const CriticalPoints& points) {
  const curve::FaceBoundary walls(face);
  double least_wall = 1e10, least_pair = 1e10;
  std::string nodes;
  for (const CriticalPoint& node : points.critical_points) {
    const double wall = walls.nearest(node.position).distance / face.diameter;
    least_wall = std::min(least_wall, wall);
    for (const CriticalPoint& other : points.critical_points)
      if (&other != &node) least_pair = std::min(least_pair, distance(node.position, other.position) / face.diameter);
    const Vec2 x = node.position + face.origin;
    nodes += fmt::format("{}{{\"valence\": {}, \"x\": {:.10g}, \"y\": {:.10g}, \"wall\": {:.5g}}}",
                         nodes.empty() ? "" : ", ", node.valence, x.x, x.y, wall);
  }
  fmt::print("{{\"diameter\": {:.10g}, \"wall\": {}, \"pair\": {}, \"nodes\": [{}]}}\n", face.diameter,
             number_or_null(least_wall), number_or_null(least_pair), nodes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: node_room FIELD CRITICAL_POINTS\n");
    return 2;
  }
  try {
    tell_room(io::read_stage<Field>(io::read_input(argv[1])).mesh.face,
              io::read_stage<CriticalPoints>(io::read_input(argv[2])));
  } catch (const std::exception& error) {
    fmt::print(stderr, "node_room: {}\n", error.what());
    return 1;
  }
}
