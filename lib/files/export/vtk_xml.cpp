#include "export/vtk_xml.hpp"

#include <fmt/format.h>

#include <bit>
#include <iterator>
#include <span>
#include <string_view>

#include "base/base64.hpp"

namespace quadrille::exports {

namespace {

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
  const std::vector<std::uint8_t> cell_types(count, grid.cell_type);
  append_array<std::uint8_t>("UInt8", named("types"), cell_types, text);
  text += "</Cells>\n";
}

}  // namespace

std::string vtk_xml(const VtkGrid& grid) {
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"{}\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<UnstructuredGrid>\n<FieldData>\n",
      grid.version);
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

std::vector<int> vtk_quad_order(int order) {
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

}  // namespace quadrille::exports
