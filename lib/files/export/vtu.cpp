#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>

#include "base/base64.hpp"
#include "export/groups.hpp"
#include "export/renode.hpp"
#include "export/skeleton.hpp"
#include "export/writers.hpp"

namespace quadrille::exports {

namespace {

/// An array: of cells one value each, of field data any number.
template <typename Value>
struct VtkArray {
  std::string name;
  std::vector<Value> values;
};

/// One unstructured grid of cells of one type.
struct VtkGrid {
  std::vector<std::array<double, 3>> points;
  std::uint8_t cell_type = 0;
  int nodes_per_cell = 0;
  std::vector<int> connectivity;  ///< nodes_per_cell for each cell
  std::vector<VtkArray<int>> cell_integers;
  std::vector<VtkArray<double>> cell_reals;
  std::vector<VtkArray<std::string>> texts;
};

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

/// The length in bytes, then the bytes: VTK requires the two to be encoded separately.
template <class T>
void append_array(const char* type, const std::string& attributes, std::span<const T> values, std::string& text) {
  const auto bytes = [](const auto* first, std::size_t size) {
    return std::string_view(reinterpret_cast<const char*>(first), size);
  };
  const std::uint64_t size = values.size_bytes();
  text.reserve(text.size() + size / 3 * 4 + 256);
  fmt::format_to(std::back_inserter(text), "<DataArray type=\"{}\" {} format=\"binary\">\n", type, attributes);
  text += base64(bytes(&size, sizeof size)) + base64(bytes(values.data(), size));
  text += "\n</DataArray>\n";
}

void append_integers(const std::string& attributes, std::span<const int> values, std::string& text) {
  static_assert(sizeof(int) == 4);
  append_array("Int32", attributes, values, text);
}

std::string named(const std::string& name) { return fmt::format("Name=\"{}\"", name); }

/// VTK writes texts as the numbers of their bytes, each text ended by 0.
void append_texts(const VtkArray<std::string>& texts, std::string& text) {
  fmt::format_to(std::back_inserter(text), "<DataArray type=\"String\" {} NumberOfTuples=\"{}\" format=\"ascii\">\n",
                 named(texts.name), texts.values.size());
  for (const std::string& value : texts.values) {
    for (const char c : value) fmt::format_to(std::back_inserter(text), "{} ", static_cast<unsigned char>(c));
    text += "0\n";
  }
  text += "</DataArray>\n";
}

void append_cells(const VtkGrid& grid, std::string& text) {
  const std::size_t count = grid.connectivity.size() / grid.nodes_per_cell;
  std::vector<int> ends(count);
  for (std::size_t i = 0; i < count; ++i) ends[i] = static_cast<int>(i + 1) * grid.nodes_per_cell;
  text += "<Cells>\n";
  append_integers(named("connectivity"), grid.connectivity, text);
  append_integers(named("offsets"), ends, text);
  const std::vector<std::uint8_t> types(count, grid.cell_type);
  append_array<std::uint8_t>("UInt8", named("types"), types, text);
  text += "</Cells>\n";
}

// Arrays inline, base64, little endian.
std::string vtk_xml(const VtkGrid& grid) {
  std::string text =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n<FieldData>\n";
  for (const VtkArray<std::string>& texts : grid.texts) append_texts(texts, text);
  text += fmt::format("</FieldData>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<CellData>\n",
                      grid.points.size(), grid.connectivity.size() / grid.nodes_per_cell);
  for (const VtkArray<int>& data : grid.cell_integers) append_integers(named(data.name), data.values, text);
  for (const VtkArray<double>& data : grid.cell_reals)
    append_array<double>("Float64", named(data.name), data.values, text);
  text += "</CellData>\n<Points>\n";
  const double* first = grid.points.empty() ? nullptr : grid.points.front().data();
  append_array<double>("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", {first, 3 * grid.points.size()}, text);
  text += "</Points>\n";
  append_cells(grid, text);
  text += "</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
  return text;
}

struct CellTypes {
  std::uint8_t curve, quad;
};
constexpr CellTypes lagrange_cells{68, 70}, bezier_cells{75, 77};

/// VTK's order of the local nodes: corners, the sides bottom, right, top, left all in the direction of rising xi, then
/// the inner ones, xi1 fastest.
std::vector<int> vtk_node_order(int order) {
  std::vector<int> node_order;
  const auto add = [&](int i, int j) { node_order.push_back(j * (order + 1) + i); };
  add(0, 0), add(order, 0), add(order, order), add(0, order);
  for (int k = 1; k < order; ++k) add(k, 0);
  for (int k = 1; k < order; ++k) add(order, k);
  for (int k = 1; k < order; ++k) add(k, order);
  for (int k = 1; k < order; ++k) add(0, k);
  for (int j = 1; j < order; ++j)
    for (int i = 1; i < order; ++i) add(i, j);
  return node_order;
}

std::vector<std::string> provenance_lines(const Provenance& chain) {
  std::vector<std::string> lines;
  for (const ProvenanceStep& step : chain)
    lines.push_back(fmt::format("{} {} {}", step.tool, step.version, step.options));
  return lines;
}

std::vector<VtkArray<std::string>> texts_of(const QuadMesh& mesh, const Groups& groups) {
  std::vector<std::string> line_names = groups.boundary_names;
  line_names.insert(line_names.end(), groups.interface_names.begin(), groups.interface_names.end());
  return {{"format", {"quad-mesh"}},
          {"provenance", provenance_lines(mesh.provenance)},
          {"length_unit", {mesh.face.length_unit}},
          {"block_names", mesh.block_names},
          {"region_names", groups.region_names},
          {"boundary_names", line_names}};
}

class VtuWriter {
 public:
  VtuWriter(const QuadMesh& mesh, const Frame& frame, ElementPoints points, CellTypes types)
      : mesh_(mesh), groups_(mesh_groups(mesh)), types_(types), positions_(positions(mesh, frame, points)) {}

  VtkGrid quads() const {
    VtkGrid grid;
    grid.points = positions_;
    grid.cell_type = types_.quad;
    grid.nodes_per_cell = mesh_.nodes_per_elem();
    grid.connectivity.reserve(mesh_.elem_nodes.size());
    const std::vector<int> node_order = vtk_node_order(mesh_.order);
    for (int elem = 0; elem < mesh_.num_elems(); ++elem)
      for (const int local : node_order)
        grid.connectivity.push_back(mesh_.elem_nodes[elem * mesh_.nodes_per_elem() + local]);
    VtkArray<int> ids{"element_id", {}}, regions{"region_id", {}}, attributes{"attribute", {}};
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) {
      ids.values.push_back(elem);
      regions.values.push_back(groups_.block2region[mesh_.elem_block[elem]]);
      attributes.values.push_back(regions.values.back() + 1);
    }
    grid.cell_integers = {{"block_id", mesh_.elem_block}, regions, ids, attributes};
    grid.cell_reals = {{"least_scaled_jacobian", mesh_.elem_scaled_jacobian},
                       {"least_jacobian_bound", mesh_.elem_jacobian_bound}};
    grid.texts = texts_of(mesh_, groups_);
    return grid;
  }

  VtkGrid curves() const {
    VtkGrid grid;
    grid.cell_type = types_.curve;
    grid.nodes_per_cell = mesh_.order + 1;
    VtkArray<int> curve_ids{"curve_id", {}}, names{"name_id", {}}, insides{"is_interface", {}};
    VtkArray<int> lefts{"left_block", {}}, rights{"right_block", {}};
    std::vector<int> point_of(positions_.size(), -1);
    for (const SkeletonCurve& curve : mesh_skeleton(mesh_).curves)
      for (const SkeletonEdge& edge : curve.edges) {
        add_edge(side_nodes(mesh_, edge.elem, edge.side), point_of, grid);
        curve_ids.values.push_back(curve.cad_curve);
        names.values.push_back(curve.cad_curve < 0 ? -1 : groups_.curve2boundary[curve.cad_curve]);
        insides.values.push_back(!curve.is_boundary());
        lefts.values.push_back(curve.blocks[0]);
        rights.values.push_back(curve.blocks[1]);
      }
    grid.cell_integers = {curve_ids, names, insides, lefts, rights};
    grid.texts = texts_of(mesh_, groups_);
    return grid;
  }

 private:
  /// The ends, then the inner nodes; points are numbered in the order of their first use.
  void add_edge(const std::vector<int>& nodes, std::vector<int>& point_of, VtkGrid& grid) const {
    const auto add = [&](int node) {
      if (point_of[node] < 0) {
        point_of[node] = static_cast<int>(grid.points.size());
        grid.points.push_back(positions_[node]);
      }
      grid.connectivity.push_back(point_of[node]);
    };
    add(nodes.front()), add(nodes.back());
    for (int k = 1; k < mesh_.order; ++k) add(nodes[k]);
  }

  const QuadMesh& mesh_;
  Groups groups_;
  CellTypes types_;
  std::vector<std::array<double, 3>> positions_;
};

Exported vtu_files(const VtuWriter& writer) {
  return {vtk_xml(writer.quads()), false, {{vtu_curves_name, vtk_xml(writer.curves())}}, {}};
}

}  // namespace

Exported vtu_lagrange(const QuadMesh& mesh, const Frame& frame) {
  return vtu_files(VtuWriter(mesh, frame, ElementPoints::equispaced, lagrange_cells));
}

Exported vtu_bezier(const QuadMesh& mesh, const Frame& frame) {
  return vtu_files(VtuWriter(mesh, frame, ElementPoints::bezier, bezier_cells));
}

}  // namespace quadrille::exports
