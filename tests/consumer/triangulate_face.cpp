// triangulate_face x.blocks.h5 x.tri.h5: triangles of the face that any stage file carries, by CGAL.
#include <quadrille/files.hpp>
#include <quadrille/triangles.hpp>

int main(int argc, char** argv) {
  using namespace quadrille;
  if (argc == 3) api::write(argv[2], api::make_triangles(api::read<BlockLayout>(argv[1]).face));
}
