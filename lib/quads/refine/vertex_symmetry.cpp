#include "refine/vertex_symmetry.hpp"

#include "base/point_grid.hpp"
#include "base/tolerance.hpp"

namespace quadrille::refine {
namespace {

constexpr double same_gradient = 1e-2;

/// Empty if a vertex has no image, or two vertices have one: those on both sides of a slit are in one place.
std::vector<int> images(const PointGrid& positions, const curve::Isometry& isometry, double tolerance) {
  std::vector<int> image;
  std::vector<bool> is_taken(positions.points().size(), false);
  for (const Vec2 x : positions.points()) {
    const PointGrid::Nearest nearest = positions.nearest(isometry(x), [](int) { return true; });
    if (nearest.point < 0 || nearest.distance2 > tolerance * tolerance || is_taken[nearest.point]) return {};
    is_taken[nearest.point] = true;
    image.push_back(nearest.point);
  }
  return image;
}

}  // namespace

VertexSymmetry::VertexSymmetry(const RelaxProblem& problem, const std::vector<Vec2>& positions,
                               const std::vector<Vec2>& tangents, const VertexMoves& gradient)
    : problem_(problem) {
  const CadFace& face = problem.start.face;
  const PointGrid grid(positions);
  for (const curve::Isometry& g : curve::symmetries(face)) {
    if (!g.is_mirrored && g.angle == 0) continue;
    Image image{images(grid, g, tolerance::same_point * face.diameter), g.turned({1, 0}), g.turned({0, 1}), {}};
    if (image.vertex.empty()) continue;
    for (int v = 0; v < problem.num_vertices(); ++v)
      image.is_backwards.push_back(dot(tangents[image.vertex[v]], g.turned(tangents[v])) < 0);
    double difference = 0, size = 0;
    for (int v = 0; v < problem.num_vertices(); ++v) {
      difference += norm2(back(image, v, gradient) - gradient[v]);
      size += norm2(gradient[v]);
    }
    if (difference <= same_gradient * same_gradient * size) images_.push_back(std::move(image));
  }
}

/// What the image of a vertex does, mapped back to the vertex.
Vec2 VertexSymmetry::back(const Image& image, int vertex, const VertexMoves& moves) const {
  const Vec2 move = moves[image.vertex[vertex]];
  if (problem_.follow.on_boundary(vertex) < 0) return {dot(image.x, move), dot(image.y, move)};
  return image.is_backwards[vertex] ? -move : move;
}

void VertexSymmetry::average(VertexMoves& moves) const {
  if (images_.empty()) return;
  VertexMoves mean = moves;
  for (std::size_t v = 0; v < mean.size(); ++v) {
    for (const Image& image : images_) mean[v] += back(image, static_cast<int>(v), moves);
    mean[v] *= 1.0 / static_cast<double>(images_.size() + 1);
  }
  moves = std::move(mean);
}

}  // namespace quadrille::refine
