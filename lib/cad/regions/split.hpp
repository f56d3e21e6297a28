#pragma once
// One struct for each region of a face of several regions, as if each were alone, and the whole again from those.

#include <algorithm>
#include <vector>

#include "model/critical_points.hpp"
#include "model/field.hpp"
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

// One struct for each region of a face of several regions, as if each were alone: loops, curves, joints, elements and
// vertices count from 0, curves have partners in the same region only, and lengths in diameters refer to the diameter
// of the region. The origin stays that of the whole. For one region: the struct itself.

std::vector<CadFace> split(const CadFace& face);

/// The repairs stay with the first mesh.
std::vector<TriMesh> split(const TriMesh& mesh);

std::vector<Field> split(const Field& field);

/// Nodes belong to the region that contains their position: after an edit, their elements need not. The parts have what
/// later stages need: nodes, corners and windings, without history and certificate. `mesh`: of the field. Throws
/// FormatError with the position of a node that is in no region.
std::vector<CriticalPoints> split(const CriticalPoints& points, const TriMesh& mesh);

/// `parts`: one for each region, in order; at least one. Of one region: the part itself, with the face `whole`.
TriMesh join(const CadFace& whole, std::vector<TriMesh> parts);

/// The fields must be of one kind, on the regions' parts of `whole`. Rounds of adaptation are joined from the first on;
/// a region with fewer rounds keeps its orders in the others.
Field join(const TriMesh& whole, std::vector<Field> parts);

/// The form is "phase" if that of one part is.
CriticalPoints join(const TriMesh& whole, std::vector<CriticalPoints> parts);

}  // namespace quadrille::regions
