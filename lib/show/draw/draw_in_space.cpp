#include "draw/draw_in_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "draw/embedded.hpp"
#include "draw/figures.hpp"
#include "draw/marks.hpp"
#include "mesh/outer_faces.hpp"
#include "model/length_scale.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::draw {

namespace {

constexpr double darkest = 0.5;  ///< of an element seen edge-on

Vec3 corner(const QuadMesh& mesh, int elem, int k) { return mesh.space_nodes[side_start(mesh, elem, k)]; }

/// Twice the vector area of the element's corners.
Vec3 corner_normal(const QuadMesh& mesh, int elem) {
  return cross(corner(mesh, elem, 2) - corner(mesh, elem, 0), corner(mesh, elem, 3) - corner(mesh, elem, 1));
}

Vec3 middle(const QuadMesh& mesh, int elem) {
  Vec3 sum;
  for (int k = 0; k < 4; ++k) sum += corner(mesh, elem, k);
  return sum / 4;
}

/// "#rrggbb", darker by a factor.
std::string shaded(const std::string& colour, double factor) {
  std::string text = "#";
  for (const int k : {1, 3, 5})
    text += fmt::format(
        "{:02x}", std::lround(factor * static_cast<double>(std::strtol(colour.substr(k, 2).c_str(), nullptr, 16))));
  return text;
}

/// Draws elements one after the other.
class SpacePicture {
 public:
  SpacePicture(const QuadMesh& mesh, const SpaceView& view, Picture& picture)
      : mesh_(mesh), view_(view), picture_(picture) {
    std::vector<double> samples;
    const int count = mesh.order == 1 ? 1 : 2 * mesh.order + 2;
    for (int i = 0; i <= count; ++i) samples.push_back(-1 + 2.0 * i / count);
    to_samples_ = spectral::interpolation_matrix(spectral::gll_points(mesh.order), samples);
    note_borders();
  }

  /// Far elements first; each with those of its sides that are on the boundary or between two blocks.
  void draw() {
    std::vector<int> elems(mesh_.num_elems());
    std::iota(elems.begin(), elems.end(), 0);
    std::vector<double> depths;
    for (const int e : elems) depths.push_back(view_.depth(middle(mesh_, e)));
    std::sort(elems.begin(), elems.end(),
              [&](int a, int b) { return depths[a] != depths[b] ? depths[a] < depths[b] : a < b; });
    picture_.open_group("elems");
    for (const int e : elems) draw_element(e);
    picture_.close_group();
  }

 private:
  /// Sides that bound the face (1) or a block (2), by element and side.
  void note_borders() {
    is_border_.assign(4 * static_cast<std::size_t>(mesh_.num_elems()), 0);
    for (const auto& [a, b] : mesh::borders(mesh_, mesh_.elem_block))
      is_border_[4 * a.elem + a.side] = is_border_[4 * b.elem + b.side] = 2;
    for (const auto* edges : {&mesh_.boundary_edges, &mesh_.interface_edges})
      for (const QuadBoundaryEdge& edge : *edges) is_border_[4 * edge.elem + edge.side] = 1;
  }

  void append_side(int elem, int side, PathData& path) const {
    const std::vector<int> ids = side_nodes(mesh_, elem, side);
    for (int i = path.empty() ? 0 : 1; i < to_samples_.rows(); ++i) {
      Vec3 x;
      for (int k = 0; k <= mesh_.order; ++k) x += to_samples_(i, k) * mesh_.space_nodes[ids[k]];
      const Vec2 at = picture_.at(view_.at(x));
      path.empty() ? path.move_to(at) : path.line_to(at);
    }
  }

  void draw_element(int elem) {
    const double quality = mesh_.elem_scaled_jacobian.empty() ? 1 : mesh_.elem_scaled_jacobian[elem];
    const Vec3 normal = corner_normal(mesh_, elem);
    const double facing = norm(normal) > 0 ? std::abs(dot(normalized(normal), view_.towards)) : 1;
    PathData outline;
    for (int side = 0; side < 4; ++side) append_side(elem, side, outline);
    outline.close();
    picture_.add(svg_element(
        "path",
        {{"id", fmt::format("elem-{}", elem)},
         {"fill", shaded(ramp_colour(palette(Paper::light).quality, quality), darkest + (1 - darkest) * facing)},
         {"d", outline.str()}},
        fmt::format("quad {}, block {}, scaled Jacobian {:.3f}", elem, mesh_.elem_block[elem], quality)));
    for (int side = 0; side < 4; ++side) {
      const int border = is_border_[4 * elem + side];
      if (border == 0) continue;
      PathData path;
      append_side(elem, side, path);
      picture_.add(svg_element("path", {{"style", border == 1 ? "fill:none;stroke:#1d2731;stroke-width:2.2"
                                                              : "fill:none;stroke:#44535f;stroke-width:1.4"},
                                        {"d", path.str()}}));
    }
  }

  const QuadMesh& mesh_;
  const SpaceView& view_;
  Picture& picture_;
  Eigen::MatrixXd to_samples_;
  std::vector<int> is_border_;
};

}  // namespace

SpaceView space_view(const QuadMesh& mesh, const ViewDirection& view) {
  Vec3 towards = view.value_or(Vec3{});
  if (!view) {
    Vec3 normal;
    double area = 0;
    for (int e = 0; e < mesh.num_elems(); ++e) {
      normal += corner_normal(mesh, e);
      area += norm(corner_normal(mesh, e));
    }
    const double rounding = 1e-6 * area;  // those of a tube cancel each other
    const auto sign = [&](double x) { return x < -rounding ? -1.0 : 1.0; };
    towards = {sign(normal.x), sign(normal.y), sign(normal.z)};
  }
  towards = normalized(towards);
  const bool is_along_z = std::abs(towards.z) > 1 - 1e-9;
  const Vec3 right = normalized(cross(is_along_z ? Vec3{0, 1, 0} : Vec3{0, 0, 1}, towards));
  return {right, cross(towards, right), towards};
}

SpaceTitle quad_title(const QuadMesh& mesh) {
  return {"Quad mesh in space", fmt::format("{} of order {} in {}", counted(mesh.num_elems(), "quad"), mesh.order,
                                            counted(num_blocks(mesh), "block"))};
}

std::string draw_in_space(const QuadMesh& mesh, const SpaceView& view, const DrawOptions& options,
                          const SpaceTitle& what) {
  PictureBox box;
  for (const Vec3 x : mesh.space_nodes) box.include(view.at(x));
  DrawOptions own = options;
  own.window.reset();
  const Vec3& t = view.towards;
  Picture picture(box, own, what.title,
                  fmt::format("{}, seen from the direction ({:.3g}, {:.3g}, {:.3g})", what.caption, t.x, t.y, t.z));
  SpacePicture(mesh, view, picture).draw();
  picture.legend_bar(palette(Paper::light).quality, "scaled Jacobian", {"0", "0.25", "0.5", "0.75", "1"});
  picture.legend_scale(unit_symbol(mesh.face));
  return picture.str();
}

std::string side_by_side(const std::array<std::string, 2>& pictures, const std::string& title, int width) {
  const int half = width / 2;
  return begin_parts(title, width, std::max(height_of(pictures[0]), height_of(pictures[1]))) +
         embedded(pictures[0], "a-", 0) + embedded(pictures[1], "b-", half) + "</svg>\n";
}

}  // namespace quadrille::draw
