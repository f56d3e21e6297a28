#pragma once
// Raw faces for the tests of healing.

#include <vector>

#include "curve/nurbs.hpp"
#include "heal/raw_face.hpp"

namespace quadrille::heal {

inline RawEdge raw_edge(const Nurbs& curve, int cad_edge = 0) {
  return {curve, curve.poles.front(), curve.poles.back(), cad_edge};
}

/// A face of one wire; edge i has number i.
inline RawFace raw_face(const std::vector<Nurbs>& curves) {
  RawFace raw;
  raw.file = "f.step";
  raw.wires.emplace_back();
  for (const Nurbs& curve : curves) raw.wires[0].push_back(raw_edge(curve, static_cast<int>(raw.wires[0].size())));
  return raw;
}

inline RawFace raw_polygon(const std::vector<Vec2>& p) {
  std::vector<Nurbs> curves;
  for (size_t i = 0; i < p.size(); ++i) curves.push_back(curve::segment(p[i], p[(i + 1) % p.size()]));
  return raw_face(curves);
}

/// The greatest distance between the end of an edge and the start of the next one.
inline double greatest_gap(const RawFace& raw) {
  double gap = 0;
  for (const auto& wire : raw.wires)
    for (size_t i = 0; i < wire.size(); ++i)
      gap = std::max(gap, distance(wire[i].curve.poles.back(), wire[(i + 1) % wire.size()].curve.poles.front()));
  return gap;
}

}  // namespace quadrille::heal
