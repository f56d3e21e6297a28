#include "chart/make_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "chart/chart_outline.hpp"
#include "chart/isothermal.hpp"
#include "chart/plane_chart.hpp"
#include "chart/rough_chart.hpp"
#include "chart/smooth_parameters.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::chart {
namespace {

struct ChartConstants {
  int first_order = 4, order = 8;  ///< of the first triangles, which only make the outline accurate, and the others
  int most_meshes = 8, most_elements = 5000;
  double most_folded = 0.1;      ///< part of the elements
  double least_folded = 1e-3;    ///< diameters, of elements that are divided as they are folded
  double least_ratio = 0.02;     ///< of areas, of elements that are not folded
  int dear_elements = 1500;      ///< from which meeting the goal is enough
  double aim = 0.03;             ///< of the goal, for which meshes are made as long as they become better
  double turn = 0.5;             ///< of the normal across an element, radians
  double edge_tolerance = 1e-2;  ///< of the straight triangles, whose edges are put onto the curves in space
  double least_reduction = 0.2;  ///< of the size of elements that are not accurate enough
};
constexpr ChartConstants constants;

/// Its middle in the image and in space, and its longest edge in the image.
struct ElementPlace {
  Vec2 image;
  Vec3 middle;
  double longest = 0;
};

ElementPlace place_of(const SurfaceMesh& mesh, int elem) {
  const std::size_t first = static_cast<std::size_t>(mesh.nodes_per_elem()) * elem;
  ElementPlace at;
  for (int k = 0; k < 3; ++k) {
    at.image += mesh.image[first + k] / 3, at.middle += mesh.nodes[first + k] / 3;
    at.longest = std::max(at.longest, distance(mesh.image[first + k], mesh.image[first + (k + 1) % 3]));
  }
  return at;
}

/// Sizes at which the normal turns by no more than the limit across an element.
std::vector<SizePoint> sizes_by_curvature(const SurfaceMesh& mesh, double diameter) {
  std::vector<SizePoint> sizes;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const std::size_t first = static_cast<std::size_t>(mesh.nodes_per_elem()) * e;
    double curvature = 0;
    for (int k = 0; k < 3; ++k) {
      const std::size_t a = first + k, b = first + (k + 1) % 3;
      const double turn =
          std::atan2(norm(cross(mesh.normals[a], mesh.normals[b])), dot(mesh.normals[a], mesh.normals[b]));
      curvature = std::max(curvature, turn / distance(mesh.image[a], mesh.image[b]));
    }
    if (curvature * diameter / 4 > constants.turn)
      sizes.push_back({place_of(mesh, e).image, constants.turn / curvature, 0});
  }
  return sizes;
}

/// Smaller sizes, but for `least`, where elements have more than their part of the square of the tolerated error.
void add_sizes_by_error(const SurfaceMesh& mesh, const IsothermalFit& fit, double tolerance, double least,
                        std::vector<SizePoint>& sizes) {
  constexpr double size_of_longest = 0.75;  // elements of the prescribed size have longer edges, too
  const double part = tolerance * tolerance / 4 / mesh.num_elems();
  for (int e = 0; e < mesh.num_elems(); ++e) {
    if (fit.elem_squares[e] <= part) continue;
    const double reduction = std::pow(part / fit.elem_squares[e], 0.5 / (mesh.order + 1));
    const ElementPlace at = place_of(mesh, e);
    const double size = std::max(least, size_of_longest * at.longest * std::max(reduction, constants.least_reduction));
    sizes.push_back({at.image, size, 0});
    for (int k = 0; k < 3; ++k)
      sizes.push_back({mesh.image[static_cast<std::size_t>(mesh.nodes_per_elem()) * e + k], size, 0});
  }
}

/// A third of the size of these elements, where they are longer than `least`. Returns whether any is.
bool add_third_sizes(const SurfaceMesh& mesh, const std::vector<int>& elems, double least,
                     std::vector<SizePoint>& sizes) {
  const std::size_t num_before = sizes.size();
  for (const int e : elems) {
    const std::array<int, 3>& v = mesh.plane.elem2vertices[e];
    double longest = 0;
    for (int k = 0; k < 3; ++k)
      longest = std::max(longest, distance(mesh.plane.vertices[v[k]], mesh.plane.vertices[v[(k + 1) % 3]]));
    if (longest <= least) continue;
    for (const int k : v) sizes.push_back({mesh.plane.vertices[k], longest / 3, 0});
  }
  return sizes.size() > num_before;
}

/// Moves the image: the longest curve runs to the right (the first of equal ones), from its start to its end or, if it
/// is closed, at its start; the middle of the outline is at the origin.
void normalize(const SpaceFace& face, const std::vector<SpaceLength>& lengths, SurfaceMesh& mesh) {
  constexpr double longer = 1 + 1e-6, closed = 1e-6;
  const int num_outline_curves = face.face.loop_offsets[1];
  int longest = 0;
  for (int i = 1; i < num_outline_curves; ++i)
    if (lengths[i].total() > longer * lengths[longest].total()) longest = i;
  const int n = mesh.nodes_per_elem();
  const spectral::Quadrature rule =
      mesh.order == 1 ? spectral::gauss_lobatto(2) : spectral::gauss_lobatto(mesh.order + 1);
  const auto node = [&](const BoundaryEdge& b, int j) {
    return mesh.image[static_cast<std::size_t>(n) * b.elem + spectral::tri_edge_node(mesh.order, b.edge, j)];
  };
  Vec2 sum, chord, first_step;
  double whole = 0;
  for (const BoundaryEdge& b : mesh.plane.boundary_edges) {
    if (b.curve >= num_outline_curves) break;
    const double length = lengths[b.curve].at(b.t1) - lengths[b.curve].at(b.t0);
    for (int j = 0; j <= mesh.order; ++j) sum += rule.weights[j] / 2 * length * node(b, j);
    whole += length;
    if (b.curve != longest) continue;
    if (norm2(first_step) == 0) first_step = image_slope(mesh, b, false);
    chord += node(b, mesh.order) - node(b, 0);
  }
  if (norm(chord) < closed * lengths[longest].total()) chord = first_step;
  const Vec2 right = normalized(chord), centre = sum / whole;
  for (std::vector<Vec2>* positions : {&mesh.image, &mesh.plane.vertices})
    for (Vec2& x : *positions) x = {dot(x - centre, right), cross(right, x - centre)};
}

triangulate::TriangulateOptions triangle_options(double diameter, std::vector<SizePoint> sizes, double least_size,
                                                 bool is_first) {
  triangulate::TriangulateOptions options;
  options.order = constants.first_order;
  options.size = diameter / 4;
  options.curve_tol = constants.edge_tolerance;
  options.size_points = std::move(sizes);
  options.least_fan_radius = least_size / diameter;
  if (is_first) options.fan_layers = 0;
  return options;
}

TriMesh triangles_of(const CadFace& outline, const triangulate::TriangulateOptions& options) {
  Report unused;
  try {
    return triangulate::triangulate(outline, options, unused);
  } catch (const ComputeError& error) {
    throw ComputeError(fmt::format(
        "the chart of the face cannot be triangulated ({}): remove short edges and cusps from the boundary or, where "
        "the face overlaps itself when it is flattened, cut it in two in the CAD system",
        error.what()));
  }
}

struct MadeChart {
  CadFace face;
  SurfaceMesh mesh;
  IsothermalFit fit;
  int num_meshes = 0;
};

/// Whether a chart of this accuracy is taken, as another mesh is too dear or hardly helps.
class Judge {
 public:
  explicit Judge(const ChartOptions& options) : goal_(options.closedness), worst_(options.worst_closedness) {}

  /// What meshes are made for as long as they become much better.
  double aim() const { return constants.aim * goal_; }
  bool is_good(const MadeChart& made) {
    if (made.num_meshes < 2) return false;
    if (made.num_meshes > judged_) {
      stalls_ += made.num_meshes > 2 && made.fit.closedness > last_ / 2;
      last_ = made.fit.closedness, judged_ = made.num_meshes;
    }
    const bool is_enough = stalls_ > 0 || made.mesh.num_elems() > constants.dear_elements;
    return last_ <= (is_last(made) ? worst_ : is_enough ? goal_ : aim());
  }
  bool is_last(const MadeChart& made) const {
    const bool is_dear = made.num_meshes >= constants.most_meshes || made.mesh.num_elems() > constants.most_elements;
    return made.num_meshes > 1 && (is_dear || stalls_ > 1);
  }

 private:
  double goal_, worst_, last_ = 0;
  int judged_ = 0;  ///< number of the last mesh
  int stalls_ = 0;  ///< meshes that were not much better than the one before
};

[[noreturn]] void refuse(const MadeChart& made, double worst_closedness) {
  const auto worst = std::max_element(made.fit.elem_squares.begin(), made.fit.elem_squares.end());
  const Vec3 at = place_of(made.mesh, static_cast<int>(worst - made.fit.elem_squares.begin())).middle;
  throw ComputeError(fmt::format(
      "the chart of the face misses its angles by {:.1e} radians, more than {:.1e}, above all near {}: the surface has "
      "a kink or a tip there; cut the face there in the CAD system",
      made.fit.closedness, worst_closedness, position_text(at)));
}

/// The message names the element that is folded most.
[[noreturn]] void refuse_folded(const SurfaceMesh& mesh, const std::vector<double>& ratios) {
  const auto worst = std::min_element(ratios.begin(), ratios.end()) - ratios.begin();
  const Vec3* const corners = &mesh.nodes[static_cast<std::size_t>(mesh.nodes_per_elem()) * worst];
  throw ComputeError(
      fmt::format("the face has no chart: its elements turn over near {}, where two edges lie upon each other, or the "
                  "surface bends too sharply or has no normal; remove such edges, or cut the face there, in the CAD "
                  "system",
                  position_text((corners[0] + corners[1] + corners[2]) / 3)));
}

/// Where one element has no size or no normal, no element of the chart has numbers.
void require_finite(const MadeChart& made) {
  if (!std::isfinite(made.fit.closedness)) refuse_folded(made.mesh, least_area_ratios(made.mesh));
}

/// Smaller sizes where elements are folded and not yet small; returns whether there are any. Throws ComputeError where
/// many are folded although they are small: then the surface itself turns over.
bool add_sizes_of_folded(const SurfaceMesh& mesh, std::vector<SizePoint>& sizes) {
  const std::vector<double> ratios = least_area_ratios(mesh);
  std::vector<int> folded;
  for (int e = 0; e < mesh.num_elems(); ++e)
    if (!(ratios[e] > constants.least_ratio)) folded.push_back(e);
  const bool are_many = static_cast<double>(folded.size()) > constants.most_folded * mesh.num_elems();
  if (are_many && mesh.num_elems() > constants.most_elements) refuse_folded(mesh, ratios);
  return add_third_sizes(mesh, folded, constants.least_folded * mesh.plane.face.diameter, sizes);
}

/// Meshes the outline of the last image and makes a new one, until it is closed or no longer becomes better.
MadeChart curved_chart(const SpaceFace& space_face, const ChartOptions& options) {
  std::vector<SpaceLength> lengths;
  lengths.reserve(space_face.curves.size());
  for (const SpaceCurve& curve : space_face.curves) lengths.emplace_back(curve);
  MadeChart made;
  made.mesh = rough_chart(space_face.face, delaunay_triangles(space_face, lengths));
  std::vector<SizePoint> by_error;
  Judge judge(options);
  for (double tolerance = rough_outline_tolerance;;) {
    normalize(space_face, lengths, made.mesh);
    made.face = outline_of_image(space_face, lengths, made.mesh, {tolerance, options.corner_angle});
    if (judge.is_good(made)) return made;
    if (judge.is_last(made)) break;
    // The error of smaller triangles is below the goal whatever they do, and their numbers drown in rounding.
    const double least_size = options.closedness * made.face.diameter;
    if (made.num_meshes > 1) add_sizes_by_error(made.mesh, made.fit, judge.aim(), least_size, by_error);
    std::vector<SizePoint> sizes = sizes_by_curvature(made.mesh, made.face.diameter);
    sizes.insert(sizes.end(), by_error.begin(), by_error.end());
    const bool is_first = made.num_meshes == 0;
    TriMesh plane =
        triangles_of(made.face, triangle_options(made.face.diameter, std::move(sizes), least_size, is_first));
    SurfaceMesh mesh = lifted_mesh(space_face, lengths, made.mesh, std::move(plane),
                                   is_first ? constants.first_order : constants.order);
    if (add_sizes_of_folded(mesh, by_error)) continue;
    made.mesh = std::move(mesh);
    made.fit = make_isothermal(made.mesh, space_face.face.loop_offsets);
    require_finite(made);
    ++made.num_meshes;
    tolerance = outline_tolerance(made.fit.closedness);
  }
  refuse(made, options.worst_closedness);
}

void require_even_scale(const SurfaceMesh& mesh, double greatest_range) {
  const auto [least, most] = std::minmax_element(mesh.scale.begin(), mesh.scale.end());
  const double range = std::exp(*most - *least);
  if (range <= greatest_range) return;
  throw ComputeError(fmt::format(
      "the chart of the face would have scales between 1 and {:.3g}, which is more than {:.3g}, with the extremes near "
      "{} and {}: cut the face between them in the CAD system",
      range, greatest_range, position_text(mesh.nodes[least - mesh.scale.begin()]),
      position_text(mesh.nodes[most - mesh.scale.begin()])));
}

Chart chart_of(const SpaceFace& face, const SurfaceMesh& mesh, double closedness) {
  Chart chart;
  chart.order = mesh.order;
  chart.elem2vertices = mesh.plane.elem2vertices;
  chart.nodes = mesh.image;
  chart.space_nodes = mesh.nodes;
  chart.uv = mesh.uv;
  for (const double s : mesh.scale) chart.log_scale.push_back(-s);
  chart.elem_surface.assign(mesh.num_elems(), 0);
  chart.surfaces = {face.surface};
  chart.space_curves = face.curves;
  chart.closedness = closedness;
  return chart;
}

}  // namespace

void ChartOptions::validate() const {
  if (!(closedness > 0 && closedness <= 1e-3)) throw UsageError("the closedness must lie in (0, 0.001]");
  if (!(worst_closedness >= closedness)) throw UsageError("the worst closedness must not be below the goal");
  if (!(corner_angle >= 0 && corner_angle <= half_pi)) throw UsageError("the corner angle must lie in 0..90 degrees");
  if (!(greatest_scale_range > 1)) throw UsageError("the greatest range of scales must be above 1");
}

CadFace make_chart(const SpaceFace& space_face, const ChartOptions& options, Report& report) {
  options.validate();
  MadeChart made;
  SpaceFace smooth_face;
  const SpaceFace* used = &space_face;
  if (std::optional<PlaneChart> plane = plane_chart(space_face, options.corner_angle)) {
    made.face = std::move(plane->face), made.mesh = std::move(plane->mesh);
  } else {
    smooth_face = with_smooth_parameters(space_face);
    used = &smooth_face;
    made = curved_chart(smooth_face, options);
  }
  require_even_scale(made.mesh, options.greatest_scale_range);
  const auto [least, most] = std::minmax_element(made.mesh.scale.begin(), made.mesh.scale.end());
  report.set("chart.elements", made.mesh.num_elems());
  report.set("chart.meshes", made.num_meshes);
  report.set("chart.closedness", made.fit.closedness);
  report.set("chart.scale_range", std::exp(*most - *least));
  made.face.chart = std::make_shared<Chart>(chart_of(*used, made.mesh, made.fit.closedness));
  return std::move(made.face);
}

}  // namespace quadrille::chart
