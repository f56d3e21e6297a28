#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <deque>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "triangulate/delaunay.hpp"

namespace quadrille::triangulate {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;
using Face = Triangulation::Face_handle;

constexpr int unknown = -1;

using Edges = std::set<std::pair<int, int>>;

/// Edge k of a face, by its vertices.
std::pair<int, int> key_of(Face face, int k) {
  return std::minmax(face->vertex((k + 1) % 3)->info(), face->vertex((k + 2) % 3)->info());
}

/// Stores in the info of each face the number of constraints between the face and infinity, `inner` ones left out.
void mark_depth(const Triangulation& triangulation, const Edges& inner) {
  for (const Face face : triangulation.all_face_handles()) face->info() = unknown;
  std::deque<Face> queue{triangulation.infinite_face()};
  queue.front()->info() = 0;
  while (!queue.empty()) {
    const Face face = queue.front();
    queue.pop_front();
    for (int k = 0; k < 3; ++k) {
      const Face next = face->neighbor(k);
      const bool crosses = face->is_constrained(k) && !inner.contains(key_of(face, k));
      const int depth = face->info() + (crosses ? 1 : 0);
      if (next->info() != unknown && next->info() <= depth) continue;
      next->info() = depth;
      // Faces at the same depth are visited first, so that each face is visited once.
      if (crosses) {
        queue.push_back(next);
      } else {
        queue.push_front(next);
      }
    }
  }
}

bool is_inside(const Triangulation& triangulation, Face face) {
  return !triangulation.is_infinite(face) && face->info() % 2 == 1;
}

struct Oriented {
  Face face;
  int first;  ///< CGAL's local number of the lowest vertex
  std::array<int, 3> vertices;
};

Oriented oriented(Face face) {
  int first = 0;
  for (int k = 1; k < 3; ++k) {
    if (face->vertex(k)->info() < face->vertex(first)->info()) first = k;
  }
  std::array<int, 3> vertices{};
  for (int k = 0; k < 3; ++k) vertices[k] = face->vertex((first + k) % 3)->info();
  return {face, first, vertices};
}

}  // namespace

struct ConstrainedDelaunay::Impl {
  Triangulation triangulation;
  std::vector<Triangulation::Vertex_handle> vertices;
  Face hint;
  Edges inner;
};

ConstrainedDelaunay::ConstrainedDelaunay() : impl_(std::make_unique<Impl>()) {}
ConstrainedDelaunay::~ConstrainedDelaunay() = default;

int ConstrainedDelaunay::insert(Vec2 position) {
  auto& [triangulation, vertices, hint, inner] = *impl_;
  const std::size_t before = triangulation.number_of_vertices();
  const auto vertex = triangulation.insert(Kernel::Point_2(position.x, position.y), hint);
  hint = vertex->face();
  if (triangulation.number_of_vertices() == before) return vertex->info();
  vertex->info() = static_cast<int>(vertices.size());
  vertices.push_back(vertex);
  return vertex->info();
}

bool ConstrainedDelaunay::constrain(int a, int b, bool is_inner) {
  auto& [triangulation, vertices, hint, inner] = *impl_;
  try {
    triangulation.insert_constraint(vertices[a], vertices[b]);
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    return false;
  }
  Face face;
  int k = 0;
  if (!triangulation.is_edge(vertices[a], vertices[b], face, k) || !face->is_constrained(k)) return false;
  if (is_inner) inner.insert(std::minmax(a, b));
  return true;
}

void ConstrainedDelaunay::release(int a, int b) {
  auto& [triangulation, vertices, hint, inner] = *impl_;
  Face face;
  int k = 0;
  if (!triangulation.is_edge(vertices[a], vertices[b], face, k)) throw Defect("a constraint is no edge");
  triangulation.remove_constrained_edge(face, k);
  inner.erase(std::minmax(a, b));
  hint = vertices[a]->face();
}

std::vector<DelaunayTriangle> ConstrainedDelaunay::triangles() const {
  const Triangulation& triangulation = impl_->triangulation;
  mark_depth(triangulation, impl_->inner);
  std::vector<Oriented> faces;
  for (const Face face : triangulation.finite_face_handles()) {
    if (is_inside(triangulation, face)) faces.push_back(oriented(face));
  }
  std::sort(faces.begin(), faces.end(), [](const Oriented& a, const Oriented& b) { return a.vertices < b.vertices; });
  for (const Face face : triangulation.all_face_handles()) face->info() = unknown;
  const int count = static_cast<int>(faces.size());
  for (int i = 0; i < count; ++i) faces[i].face->info() = i;
  std::vector<DelaunayTriangle> result(count);
  for (int i = 0; i < count; ++i) {
    result[i].vertices = faces[i].vertices;
    for (int k = 0; k < 3; ++k) {
      // CGAL numbers an edge by its opposite vertex, this project by its first vertex.
      const int opposite = (faces[i].first + k + 2) % 3;
      const bool closed = faces[i].face->is_constrained(opposite);
      result[i].neighbors[k] = closed ? -1 : faces[i].face->neighbor(opposite)->info();
    }
  }
  return result;
}

}  // namespace quadrille::triangulate
