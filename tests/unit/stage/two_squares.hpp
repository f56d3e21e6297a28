#pragma once
// Two unit squares side by side and what the stages make of them, as the input of the next stage.

#include <vector>

#include "../regions/faces_of_regions.hpp"
#include "model/critical_points.hpp"
#include "model/tri_mesh.hpp"
#include "stage/stage_input.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::testing_stages {

inline TriMesh two_squares() {
  using namespace testing_faces;
  Report report;
  TriMesh mesh =
      triangulate::triangulate(face_of_regions({rectangle({0, 0}, {1, 1}), rectangle({1, 0}, {2, 1})}), {}, report);
  mesh.provenance = {{"cad2tri", version, {{"step", "digest of the CAD file"}}, "{}"}};
  return mesh;
}

/// The corners alone, each of valence 1. `made_from`: digest of the field.
inline CriticalPoints corners_of(const CadFace& face, const std::string& made_from) {
  CriticalPoints points;
  points.face = face;
  points.origin = face.origin;
  for (int j = 0; j < face.num_curves(); ++j)
    points.corners.push_back({j, face.joints[j].position, 90, 1, {face.previous_in_loop(j), j}});
  points.index_sum = points.index_sum_expected = 4 * face.num_regions();
  points.provenance = {{"critpoints", version, {{"field", made_from}}, "{}"}};
  return points;
}

template <typename Model>
stage::Input<Model> as_input(const Model& model, const std::string& name) {
  return {model, {name, "digest of " + name}};
}

}  // namespace quadrille::testing_stages
