// wall_heights MESH.quad.h5 FIRST STEPS NAME...
// Measures the layers of a mesh along the boundaries of the given names, from its vertices and the CAD curves alone.
// Prints JSON: the greatest deviation of the first heights from FIRST, as a share, at wall vertices farther than ten
// first heights from boundary vertices without two elements and from corners above 180 degrees; the greatest ratio of
// neighbouring steps among the first STEPS of the columns of vertices that leave the wall there, and in the whole
// columns, with the place; the same in all whole columns, those near corners too; the number of wall vertices.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/angle.hpp"
#include "curve/project.hpp"
#include "io/stage_files.hpp"

using namespace quadrille;

namespace {

using Edge = std::pair<int, int>;
Edge sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

struct Measured {
  int vertices = 0;
  double deviation = 0, growth = 1, growth_anywhere = 1;
  Vec2 worst_place;  ///< of growth anywhere
  double growth_with_corners = 1;
  Vec2 worst_with_corners;
};

class Walls {
 public:
  Walls(const QuadMesh& mesh, const std::set<std::string>& names) : mesh_(mesh) {
    for (int elem = 0; elem < mesh.num_elems(); ++elem)
      for (int k = 0; k < 4; ++k) {
        edge2elems_[sorted(vertex(elem, k), vertex(elem, k + 1))].push_back({elem, k});
        ++num_elems_at_[vertex(elem, k)];
      }
    for (int c = 0; c < mesh.face.num_curves(); ++c)
      if (names.count(mesh.face.curve_names[c])) curves_.insert(c);
  }

  Measured measure(double first, int steps) const {
    std::vector<Vec2> corners;
    for (const QuadBoundaryEdge& e : mesh_.boundary_edges)
      for (const int v : {vertex(e.elem, e.side), vertex(e.elem, e.side + 1)})
        if (num_elems_at_.at(v) != 2) corners.push_back(mesh_.nodes[v]);
    for (const int c : curves_)  // layers with blocks of their own turn around these in parallel to both sides
      if (mesh_.face.joints[c].is_corner && mesh_.face.joints[c].interior_angle > pi)
        corners.push_back(mesh_.face.joints[c].position);
    Measured result;
    for (const QuadBoundaryEdge& e : mesh_.boundary_edges)
      for (int end = 0; curves_.count(e.curve) && end < 2; ++end) {
        const std::vector<int> column = walk(e, end);
        const Vec2 foot = mesh_.nodes[column[0]];
        add_growth(column, result.growth_with_corners, result.worst_with_corners);
        const auto is_near = [&](Vec2 c) { return distance(c, foot) <= 10 * first; };
        if (std::any_of(corners.begin(), corners.end(), is_near)) continue;
        ++result.vertices;
        result.deviation = std::max(result.deviation, std::abs(height(mesh_.nodes[column[1]]) / first - 1));
        add_growth(column, result.growth_anywhere, result.worst_place);
        Vec2 ignored;
        add_growth({column.begin(), column.begin() + std::min<std::ptrdiff_t>(steps + 1, std::ssize(column))},
                   result.growth, ignored);
      }
    return result;
  }

 private:
  struct Side {
    int elem, side;
  };

  int vertex(int elem, int k) const {
    const int n = mesh_.order, width = n + 1;
    const int corner[4] = {0, n, width * width - 1, width * n};
    return mesh_.elem_nodes[static_cast<std::size_t>(elem) * width * width + corner[k % 4]];
  }

  /// The vertices of the column over one end of a boundary edge, as far as it goes.
  std::vector<int> walk(const QuadBoundaryEdge& start, int end) const {
    std::vector<int> column{vertex(start.elem, start.side + end)};
    std::set<int> seen;
    for (Side s{start.elem, start.side}; seen.insert(s.elem).second;) {
      const int foot = column.back();
      column.push_back(vertex(s.elem, s.side) == foot ? vertex(s.elem, s.side + 3) : vertex(s.elem, s.side + 2));
      const Edge far = sorted(vertex(s.elem, s.side + 2), vertex(s.elem, s.side + 3));
      const std::vector<Side>& both = edge2elems_.at(far);
      if (both.size() < 2) break;
      s = both[0].elem == s.elem ? both[1] : both[0];
    }
    return column;
  }

  void add_growth(const std::vector<int>& column, double& worst, Vec2& place) const {
    for (std::size_t k = 2; k < column.size(); ++k) {
      const double below = distance(mesh_.nodes[column[k - 2]], mesh_.nodes[column[k - 1]]);
      const double above = distance(mesh_.nodes[column[k - 1]], mesh_.nodes[column[k]]);
      const double ratio = std::max(above / below, below / above);
      if (ratio > worst) worst = ratio, place = mesh_.nodes[column[k - 1]];
    }
  }

  double height(Vec2 x) const {
    double nearest = 1e300;
    for (const int c : curves_) nearest = std::min(nearest, curve::project(mesh_.face.curves[c], x).distance);
    return nearest;
  }

  const QuadMesh& mesh_;
  std::map<Edge, std::vector<Side>> edge2elems_;
  std::map<int, int> num_elems_at_;
  std::set<int> curves_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    std::fputs("wall_heights MESH.quad.h5 FIRST STEPS NAME...\n", stderr);
    return 2;
  }
  const QuadMesh mesh = io::read_stage<QuadMesh>(io::read_input(argv[1]));
  const Measured m = Walls(mesh, {argv + 4, argv + argc}).measure(std::atof(argv[2]), std::atoi(argv[3]));
  const Vec2 worst = m.worst_place + mesh.face.origin, corner = m.worst_with_corners + mesh.face.origin;
  fmt::print(
      "{{\"wall_vertices\": {}, \"deviation\": {:.6g}, \"growth\": {:.6g}, \"growth_anywhere\": {:.6g}, "
      "\"worst_growth_at\": [{:.6g}, {:.6g}], \"growth_with_corners\": {:.6g}, \"worst_with_corners_at\": "
      "[{:.6g}, {:.6g}]}}\n",
      m.vertices, m.deviation, m.growth, m.growth_anywhere, worst.x, worst.y, m.growth_with_corners, corner.x,
      corner.y);
  return m.vertices > 0 ? 0 : 1;
}
