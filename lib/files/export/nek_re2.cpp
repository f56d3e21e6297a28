#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "export/cells.hpp"
#include "export/hex_blend.hpp"
#include "export/hex_periodic.hpp"
#include "export/periodic_edges.hpp"
#include "export/renode.hpp"
#include "export/writers.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::exports {

namespace {

using Position = std::array<double, 3>;

constexpr float byte_order_mark = 6.54321F;

/// Appends the 4 or 8 bytes of a number, the lowest first.
template <class Number>
void append_little_endian(std::string& bytes, Number number) {
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  static_assert(sizeof(Number) == sizeof(Bits));
  const Bits bits = std::bit_cast<Bits>(number);
  for (std::size_t k = 0; k < sizeof(Bits); ++k) bytes += static_cast<char>((bits >> (8 * k)) & 0xff);
}

constexpr std::size_t header_length = 132;

/// Word size, points in each direction, elements here and in all, time, step, file and number of files, contents,
/// thermodynamic pressure, no pressure on the velocity's points.
std::string field_header(int width, int dim, std::size_t count) {
  std::string line =
      fmt::format("#std {:1} {:2} {:2} {:2} {:10} {:10} {:>20} {:9} {:6} {:6} {:<10}{:15} F", 8, width, width,
                  dim == 3 ? width : 1, count, count, "0.0000000000000E+00", 0, 0, 1, "X", "  1.0000000E+00");
  line.resize(header_length, ' ');
  return line;
}

/// The geometry at Gauss-Lobatto-Legendre points, which Nek5000 uses as the positions of its own points: a field file.
/// `elem_nodes`: the (order + 1)^dim nodes of each element; `positions`: by node, of which `dim` coordinates are
/// written.
std::string geometry_field(int order, int dim, const std::vector<int>& elem_nodes,
                           const std::vector<std::array<double, 3>>& positions) {
  std::size_t per_elem = 1;
  for (int axis = 0; axis < dim; ++axis) per_elem *= order + 1;
  const std::size_t count = elem_nodes.size() / per_elem;
  std::string bytes = field_header(order + 1, dim, count);
  bytes.reserve(bytes.size() + 4 * (1 + count) + 8 * dim * elem_nodes.size());
  append_little_endian(bytes, byte_order_mark);
  for (std::size_t elem = 0; elem < count; ++elem) append_little_endian(bytes, static_cast<int>(elem + 1));
  for (std::size_t first = 0; first < elem_nodes.size(); first += per_elem)
    for (int axis = 0; axis < dim; ++axis)
      for (std::size_t k = 0; k < per_elem; ++k) append_little_endian(bytes, positions[elem_nodes[first + k]][axis]);
  return bytes;
}

bool is_curved_edge(const QuadMesh& mesh, const std::vector<int>& nodes) { return !is_straight_edge(mesh, nodes); }
bool is_curved_edge(const HexMesh& mesh, const std::vector<int>& nodes) { return !is_blend(mesh, nodes); }

/// The middle of an edge; of hexahedra in space, as `frame` leaves it.
Position middle_of(const QuadMesh& mesh, const Frame& frame, const std::vector<int>& nodes) {
  const Eigen::MatrixXd to_middle = spectral::interpolation_matrix(spectral::gll_points(mesh.order), {0.0});
  Vec2 middle;
  for (int k = 0; k <= mesh.order; ++k) middle += to_middle(0, k) * mesh.nodes[nodes[k]];
  return frame.at(middle);
}
Position middle_of(const HexMesh& mesh, const Frame&, const std::vector<int>& nodes) {
  const Vec3 x = edge_middle(mesh, nodes);
  return {x.x, x.y, x.z};
}

using ElementSide = std::pair<int, int>;

/// The partners of sides on periodic boundaries.
std::map<ElementSide, ElementSide> periodic_partners(const QuadMesh& mesh) {
  std::map<ElementSide, ElementSide> partners;
  for (const PeriodicEdges& edges : periodic_edges(mesh)) {
    const QuadBoundaryEdge &a = mesh.boundary_edges[edges.first], &b = mesh.boundary_edges[edges.second];
    partners[{a.elem, a.side}] = {b.elem, b.side};
    partners[{b.elem, b.side}] = {a.elem, a.side};
  }
  return partners;
}
std::map<ElementSide, ElementSide> periodic_partners(const HexMesh& mesh) {
  std::map<ElementSide, ElementSide> partners;
  for (const PeriodicFaces& pair : periodic_faces(mesh)) {
    partners[{pair.first.elem, pair.first.face}] = {pair.second.elem, pair.second.face};
    partners[{pair.second.elem, pair.second.face}] = {pair.first.elem, pair.first.face};
  }
  return partners;
}

/// An .re2 file, version 4, little endian, numbers in double precision. Nek5000's corners, edges (of a hexahedron those
/// of the bottom, of the top, upright) and sides (the sides of the quad, bottom, top) have our numbers plus 1.
template <typename Mesh>
class Re2Writer {
 public:
  Re2Writer(const Mesh& mesh, const Frame& frame, const Groups& groups)
      : mesh_(mesh), frame_(frame), groups_(groups), numbering_(number_parts(mesh)) {
    require_known_by_vertices(mesh, numbering_, "Nek5000");
  }

  /// `has_regions`: groups of material properties have the numbers of the regions; else they are 0.
  std::string bytes(const std::vector<Position>& positions, bool has_regions) {
    out_ = fmt::format("#v004{:16}{:3}{:16}{:4} hdr", mesh_.num_elems(), dim, mesh_.num_elems(), 1);
    out_.resize(80, ' ');
    append_little_endian(out_, byte_order_mark);
    write_corners(positions, has_regions);
    write_curved_edges();
    write_boundaries();
    return std::move(out_);
  }

 private:
  static constexpr int dim = mesh_dimension<Mesh>;

  void put(double number) { append_little_endian(out_, number); }

  /// Element and side, which count from 0 here and from 1 in the file, five numbers, a word of eight letters.
  void write_record(int elem, int side, const std::array<double, 5>& numbers, const char* word) {
    put(elem + 1), put(side + 1);
    for (const double number : numbers) put(number);
    out_ += fmt::format("{:<8}", word);
  }

  void write_corners(const std::vector<Position>& positions, bool has_regions) {
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      put(has_regions ? 1 + groups_.block2region[block_of(mesh_, elem)] : 0);
      for (int axis = 0; axis < dim; ++axis)
        for (int corner = 0; corner < 1 << dim; ++corner) put(positions[corner_node(mesh_, elem, corner)][axis]);
    }
  }

  void write_curved_edges() {
    std::vector<std::optional<Position>> middles;  // of curved edges
    for (const NumberedEdge& edge : numbering_.edges) {
      const std::vector<int> nodes = edge_nodes(mesh_, edge);
      middles.emplace_back();
      if (is_curved_edge(mesh_, nodes)) middles.back() = middle_of(mesh_, frame_, nodes);
    }
    const std::vector<int>& edges = numbering_.elem2edges;
    const int per_elem = dim == 2 ? 4 : 12;
    put(static_cast<double>(
        std::count_if(edges.begin(), edges.end(), [&](int edge) { return middles[edge].has_value(); })));
    for (int k = 0; k < static_cast<int>(edges.size()); ++k)
      if (const std::optional<Position>& x = middles[edges[k]])
        write_record(k / per_elem, k % per_elem, {(*x)[0], (*x)[1], dim == 2 ? 0 : (*x)[2], 0, 0}, "m");
  }

  void write_boundaries() {
    std::vector<GroupSide> sides = group_sides(mesh_, groups_, numbering_);
    std::erase_if(sides, [](const GroupSide& at) { return at.is_interface; });
    std::sort(sides.begin(), sides.end(), [](const GroupSide& a, const GroupSide& b) {
      return std::tie(a.elem, a.side) < std::tie(b.elem, b.side);
    });
    const std::map<ElementSide, ElementSide> partners = periodic_partners(mesh_);
    put(static_cast<double>(sides.size()));
    for (const GroupSide& at : sides)
      if (const auto partner = partners.find({at.elem, at.side}); partner != partners.end())
        write_record(at.elem, at.side,
                     {1.0 + partner->second.first, 1.0 + partner->second.second, 0, 0, 1.0 + at.group}, "P");
      else
        write_record(at.elem, at.side, {0, 0, 0, 0, 1.0 + at.group}, "MSH");
  }

  const Mesh& mesh_;
  const Frame& frame_;
  const Groups& groups_;
  decltype(number_parts(std::declval<Mesh>())) numbering_;
  std::string out_;
};

/// How far nodes on `sides` ("sides" of quads, "edges" of hexahedra) and `others` move.
void report_moved_nodes(double sides_moved, double others_moved, const char* sides, const char* others, int order,
                        double diameter, Exported& exported) {
  const double least = 1e-12 * diameter;
  if (sides_moved > least)
    exported.add_loss(fmt::format(
        "{} are stored as parabolas, which moves them by up to {}; *0.f00000 contains the geometry of order {}", sides,
        length_text(sides_moved, diameter), order));
  else if (others_moved > least)
    exported.add_loss(
        fmt::format("nodes {} are rebuilt from the {}, which moves them by up to {}; "
                    "*0.f00000 contains the original ones",
                    others, sides, length_text(others_moved, diameter)));
  exported.add_loss("names are stored as numbers, which *.names.json lists");
}

template <typename Mesh>
void write_re2(const Mesh& mesh, const Frame& frame, const std::vector<Position>& positions, const Groups& groups,
               bool has_regions, Exported& exported) {
  exported.add_loss(interface_loss(groups));
  if (!has_regions) exported.add_loss(region_loss(groups));
  exported.bytes = Re2Writer(mesh, frame, groups).bytes(positions, has_regions);
  exported.is_binary = true;
  exported.side_files.push_back(
      names_table(groups, groups.boundary_names, has_regions ? groups.region_names : NameList()));
  if (mesh.order > 1)
    exported.side_files.push_back(
        {nek_field_name, geometry_field(mesh.order, mesh_dimension<Mesh>, mesh.elem_nodes, positions), true});
}

}  // namespace

Exported nek_re2(const QuadMesh& mesh, const Frame& frame) {
  Exported exported;
  const TransfiniteLoss loss = transfinite_loss(mesh, RebuiltFrom::quadratic_sides, "Nek5000");
  report_moved_nodes(loss.sides, loss.interior, "sides", "inside elements", mesh.order, mesh.face.diameter, exported);
  write_re2(mesh, frame, positions(mesh, frame, ElementPoints::nodes), mesh_groups(mesh), !mesh.block_region.empty(),
            exported);
  return exported;
}

Exported nek_re2(const HexMesh& mesh) {
  Exported exported;
  const QuadraticEdgeLoss loss = quadratic_edge_loss(mesh, "Nek5000");
  report_moved_nodes(loss.edges, loss.others, "edges", "on faces and inside elements", mesh.order, mesh.diameter,
                     exported);
  const Groups groups = mesh_groups(mesh);
  write_re2(mesh, {}, positions(mesh, ElementPoints::nodes), groups, groups.num_regions() > 1, exported);
  return exported;
}

}  // namespace quadrille::exports
