// mesh_face x.tri.h5 x.crit.json x.quad.h5 [quantized]: from triangles to quads by the library, without running a tool.
// mesh_any_face, the same with WITH_TRIANGLES, also where no separatrices make blocks.
#include <iostream>
#include <quadrille/fields.hpp>
#include <quadrille/files.hpp>
#include <quadrille/layouts.hpp>
#ifdef WITH_TRIANGLES
#include <quadrille/triangles.hpp>
#endif

int main(int argc, char** argv) try {
  if (argc < 4) return 2;
  using namespace quadrille;
  const TriMesh triangles = api::read<TriMesh>(argv[1]);
  Field field = api::solve_field(triangles);
  const CriticalPoints points = api::find_nodes(field);
  if (points.form == NodeForm::phase) field = api::solve_field_of_nodes(triangles, points);
  api::TraceSettings settings;
  if (argc == 5) settings.layout = layout::LayoutChoice::quantized;
#ifdef WITH_TRIANGLES
  settings.coarse_mesher = api::coarse_triangles;
#endif
  const QuadMesh mesh = api::make_quads(api::make_blocks(api::trace_layout(field, points, settings)));
  api::write(argv[2], points);
  api::write(argv[3], mesh);

  std::cout.precision(15);
  const api::FieldAtPoints at_points(field);
  for (const Vec2 x : {Vec2{0.1, 0.2}, Vec2{0.4, 0.3}, Vec2{99, 99}})
    if (const auto at = at_points.at(x)) std::cout << at->value.x << ' ' << at->value.y << '\n';
  std::cout << points.critical_points.size() << " nodes, " << mesh.num_elems() << " quads, "
            << api::broken_rules(mesh).size() << " broken rules\n";
} catch (const quadrille::Error& error) {
  std::cerr << error.what() << '\n';
  return static_cast<int>(error.code());
}
