#pragma once
// Where the curves, holes, elements and vertices of a region start among those of the whole face.

#include <algorithm>
#include <vector>

#include "model/tri_mesh.hpp"

namespace quadrille::regions {

/// A range [begin, end) of indices of the whole.
struct IndexRange {
  int begin = 0, end = 0;

  int size() const { return end - begin; }
  bool contains(int i) const { return i >= begin && i < end; }
};

inline IndexRange loops_of(const CadFace& face, int region) {
  if (face.region_loops.empty()) return {0, face.num_loops()};
  return {face.region_loops[region], face.region_loops[region + 1]};
}

/// Also of joints.
inline IndexRange curves_of(const CadFace& face, int region) {
  const IndexRange loops = loops_of(face, region);
  return {face.loop_offsets[loops.begin], face.loop_offsets[loops.end]};
}

/// Counted as in PhaseForm::hole_winding: the outlines left out.
inline IndexRange holes_of(const CadFace& face, int region) {
  const IndexRange loops = loops_of(face, region);
  return {loops.begin - region, loops.end - region - 1};
}

inline IndexRange elems_of(const TriMesh& mesh, int region) {
  if (mesh.region_elems.empty()) return {0, mesh.num_elems()};
  return {mesh.region_elems[region], mesh.region_elems[region + 1]};
}

template <typename T>
std::vector<T> part_of(const std::vector<T>& all, IndexRange range) {
  if (all.empty()) return {};
  return {all.begin() + range.begin, all.begin() + range.end};
}

template <typename T>
void append(std::vector<T>& all, const std::vector<T>& part) {
  all.insert(all.end(), part.begin(), part.end());
}

}  // namespace quadrille::regions
