#include "quantize/quantize_and_extend.hpp"

#include <algorithm>
#include <utility>

#include "graph/chord_strip.hpp"
#include "model/periodic.hpp"
#include "quantize/extend_lines.hpp"
#include "quantize/quantize.hpp"
#include "quantize/quantized_parametrization.hpp"

namespace quadrille::quantize {
namespace {

constexpr double relative_unit = 0.1;  // an arc of this length, relative to the diameter, has integer length one

/// The faces of a T-mesh, and what is known of their integer grids.
struct QuantizedFaces {
  std::vector<HalfEdge> same;  // of periodic arcs (model/periodic.hpp, first_arcs); empty: none are glued
  std::vector<TFace> faces, glued;
  Quantization found;
};

QuantizedFaces quantized_faces(const graph::CandidateLayout& t_mesh, PeriodicSides sides, Progress* progress) {
  const Progress::Part part(progress, "integer program");
  const ArcGraph& graph = t_mesh.graph();
  QuantizedFaces q;
  if (sides == PeriodicSides::glued) q.same = first_arcs(graph);
  q.faces = t_mesh_faces(t_mesh.subdivision);
  q.glued = faces_across_periodic_sides(q.faces, q.same);
  q.found = quantize_or_explain(q.glued, graph::arc_lengths(graph), relative_unit * graph.face.diameter);
  std::vector<int>& lengths = q.found.lengths;
  for (std::size_t a = 0; a < lengths.size() && !q.same.empty(); ++a) lengths[a] = lengths[q.same[a].arc];
  return q;
}

}  // namespace

std::vector<int> InfeasibleTMesh::zero_arcs() const {
  return forced_zero_arcs(faces, static_cast<int>(t_mesh.graph().arcs.size()));
}

ExtendedTMesh quantize_and_extend(graph::CandidateLayout t_mesh, PeriodicSides sides, const ReplaceTMesh& replace,
                                  Progress* progress) {
  QuantizedFaces q = quantized_faces(t_mesh, sides, progress);
  while (q.found.lengths.empty()) {
    t_mesh = replace({t_mesh, q.glued, q.found.strips});
    q = quantized_faces(t_mesh, sides, progress);
  }
  const Progress::Part part(progress, "continued lines");
  const std::vector<int>& lengths = q.found.lengths;
  return {extend_lines(t_mesh, q.faces, lengths, q.same), *std::max_element(lengths.begin(), lengths.end())};
}

}  // namespace quadrille::quantize
