#include "refine/sampled_loops.hpp"

#include <algorithm>
#include <cmath>

#include "curve/chain.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::refine {
namespace {

constexpr int samples_per_edge = 8;

std::vector<int> edges_by_curve(const QuadMesh& mesh) {
  std::vector<int> count(mesh.face.num_curves(), 0);
  for (const auto* edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& edge : *edges) ++count[edge.curve];
  return count;
}

}  // namespace

SampledLoops::SampledLoops(const QuadMesh& mesh) {
  const CadFace& face = mesh.face;
  const std::vector<int> edges = edges_by_curve(mesh);
  for (int l = 0; l < face.num_loops(); ++l) {
    Loop loop;
    for (int c = face.loop_offsets[l]; c < face.loop_offsets[l + 1]; ++c) {
      const curve::ArcLength arc(face.curves[c]);
      const int count = samples_per_edge * (edges[c] + 1);
      Curve curve{loop.length, arc.total() / count, {}};
      for (int k = 0; k <= count; ++k) {
        const double t = k == count ? face.curves[c].end() : arc.parameter(k * curve.step);
        curve.samples.push_back({curve::point(face.curves[c], t), curve::tangent(face.curves[c], t, k == count), {}});
      }
      loop.length += arc.total();
      loop.curves.push_back(std::move(curve));
    }
    loops_.push_back(std::move(loop));
  }
}

/// Hermite's cubic between two samples.
LoopPoint SampledLoops::at(int loop, double length) const {
  const auto& [total, curves] = loops_[loop];
  if (!(length >= 0 && length < total)) length -= total * std::floor(length / total);
  const auto after = std::upper_bound(curves.begin(), curves.end(), length,
                                      [](double x, const Curve& curve) { return x < curve.start; });
  const Curve& curve = after == curves.begin() ? curves.front() : *std::prev(after);
  const double place = (length - curve.start) / curve.step;
  const int k = std::clamp(static_cast<int>(place), 0, static_cast<int>(curve.samples.size()) - 2);
  const double u = place - k, v = 1 - u;
  const LoopPoint &a = curve.samples[k], &b = curve.samples[k + 1];
  const Vec2 chord = b.position - a.position;
  return {v * v * (1 + 2 * u) * a.position + u * u * (1 + 2 * v) * b.position +
              curve.step * u * v * (v * a.tangent - u * b.tangent),
          6 * u * v / curve.step * chord + v * (1 - 3 * u) * a.tangent + u * (1 - 3 * v) * b.tangent,
          (b.tangent - a.tangent) / curve.step};
}

}  // namespace quadrille::refine
