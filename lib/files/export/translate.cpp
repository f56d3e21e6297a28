#include "export/translate.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/number_list.hpp"

namespace quadrille::exports {
namespace {

Vec3 in_space_of(const std::vector<double>& by) { return {by[0], by[1], by.size() == 3 ? by[2] : 0}; }

template <class Positions>
void add(Positions& positions, Vec3 t) {
  for (Vec3& x : positions) x += t;
}

void translate(Chart& chart, Vec3 t) {
  add(chart.space_nodes, t);
  for (NurbsSurface& surface : chart.surfaces) add(surface.poles, t);
  for (SpaceCurve& curve : chart.space_curves) add(curve.poles, t);
}

}  // namespace

std::vector<double> parse_translation(const std::string& text) {
  if (text.empty()) return {};
  std::vector<double> numbers = numbers_of(text);
  if (numbers.size() != 2 && numbers.size() != 3)
    throw UsageError(fmt::format("--translate: '{}' is not X,Y or X,Y,Z", text));
  return numbers;
}

void require_translation(const std::vector<double>& by, bool in_space) {
  if (by.size() == 3 && !in_space)
    throw UsageError("--translate: three numbers are for --frame 3d, curved faces and hexahedra: give X,Y");
}

void translate(QuadMesh& mesh, const std::vector<double>& by, bool in_space) {
  if (by.empty()) return;
  const Vec3 t = in_space_of(by);
  if (mesh.face.chart) {
    Chart chart = *mesh.face.chart;
    translate(chart, t);
    mesh.face.chart = std::make_shared<const Chart>(std::move(chart));
    add(mesh.space_nodes, t);
  } else if (in_space) {
    mesh.face.plane_origin[0] += t.x, mesh.face.plane_origin[1] += t.y, mesh.face.plane_origin[2] += t.z;
  } else {
    require_translation(by, false);
    const Vec2 s{t.x, t.y};
    mesh.face.origin += s;
    for (PeriodicPair& pair : mesh.face.periodic_pairs) {
      const Vec2 turn = unit(pair.angle);
      pair.shift += s - Vec2{turn.x * s.x - turn.y * s.y, turn.y * s.x + turn.x * s.y};
    }
  }
}

void translate(HexMesh& mesh, const std::vector<double>& by, bool) {
  if (by.empty()) return;
  const Vec3 t = in_space_of(by);
  add(mesh.nodes, t);
  for (HexFaceGroup& group : mesh.face_groups) {
    const auto& [x, y, z] = group.motion.matrix;
    group.motion.shift += t - Vec3{dot(x, t), dot(y, t), dot(z, t)};
  }
}

}  // namespace quadrille::exports
