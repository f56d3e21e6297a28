// mesh_face x.tri.h5 x.crit.json x.quad.h5: from triangles to quads by the library, without running a tool.
#include <iostream>
#include <quadrille/fields.hpp>
#include <quadrille/files.hpp>
#include <quadrille/layouts.hpp>

int main(int argc, char** argv) try {
  if (argc != 4) return 2;
  using namespace quadrille;
  api::FieldAtPoints field(api::solve_field(api::read_tri_mesh(argv[1])));
  const CriticalPoints points = api::find_nodes(field.field());
  const QuadMesh mesh = api::make_quads(api::make_blocks(api::trace_layout(field.field(), points)));
  api::write(argv[2], points);
  api::write(argv[3], mesh);
  std::cout.precision(15);
  for (const Vec2 x : {Vec2{0.1, 0.2}, Vec2{0.4, 0.3}, Vec2{9, 9}})
    if (const auto at = field.at(x)) std::cout << at->value.x << ' ' << at->value.y << '\n';
  std::cout << points.critical_points.size() << " nodes, " << mesh.num_elems() << " quads, "
            << api::broken_rules(mesh).size() << " broken rules\n";
} catch (const quadrille::Error& error) {
  std::cerr << error.what() << '\n';
  return static_cast<int>(error.code());
}
