#include "mesh/given_position.hpp"

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "curve/named_places.hpp"
#include "mesh/chart_map.hpp"
#include "surface/space_extent.hpp"

namespace quadrille::mesh {

Vec2 given_position(const CadFace& face, const std::vector<double>& coordinates, const std::string& where) {
  constexpr double farthest = 1e-3;  // diameters
  if (!face.chart) return curve::face_position(face, coordinates, where);
  const Vec3 x = curve::space_position(coordinates, where);
  const ChartMap::Foot foot = ChartMap(face).nearest(x);
  if (!(foot.distance <= farthest * surface::diameter(*face.chart)))
    throw FormatError(fmt::format("{}: {} lies {:.3g} off the face", where, position_text(x), foot.distance));
  return foot.x;
}

}  // namespace quadrille::mesh
