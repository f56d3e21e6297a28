#include "export/nektar_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quadrille::exports {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// The value of an attribute. XML 1.0 cannot represent control characters.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += is_control(c) ? '_' : c;
  }
  return out;
}

/// "0-3,7": in their order, those that follow each other as ranges.
std::string ranges(const std::vector<int>& numbers) {
  std::string out;
  for (std::size_t k = 0; k < numbers.size();) {
    std::size_t last = k;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    out += fmt::format("{}{}", out.empty() ? "" : ",", numbers[k]);
    if (last > k) out += fmt::format("-{}", numbers[last]);
    k = last + 1;
  }
  return out;
}

}  // namespace

void NektarText::begin(int dim, int space) {
  print("<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<NEKTAR>\n");
  print("  <GEOMETRY DIM=\"{}\" SPACE=\"{}\">\n", dim, space);
}

// Numbers have as many digits as needed to read back the same bits.
void NektarText::write_vertices(const Points& points) {
  print("    <VERTEX>\n");
  for (std::size_t v = 0; v < points.size(); ++v)
    print("      <V ID=\"{}\">{} {} {}</V>\n", v, points[v][0], points[v][1], points[v][2]);
  print("    </VERTEX>\n");
}

void NektarText::begin_edges() { print("    <EDGE>\n"); }

void NektarText::write_edge(int id, const std::array<int, 2>& vertices) {
  print("      <E ID=\"{}\">{} {}</E>\n", id, vertices[0], vertices[1]);
}

void NektarText::end_edges() { print("    </EDGE>\n"); }

void NektarText::write_curve(char letter, const char* what, int id, int of, const Points& points) {
  print("      <{} ID=\"{}\" {}=\"{}\" NUMPOINTS=\"{}\" TYPE=\"GaussLobattoLegendre\">", letter, id, what, of,
        points.size());
  for (std::size_t k = 0; k < points.size(); ++k)
    print("{}{} {} {}", k > 0 ? "  " : "", points[k][0], points[k][1], points[k][2]);
  print("</{}>\n", letter);
}

void NektarText::write_groups(const Groups& groups, char boundary, const std::vector<std::vector<int>>& boundaries,
                              char element, const std::vector<std::vector<int>>& elements) {
  const std::vector<std::string> names = boundary_and_interface_names(groups);
  int id = 1;
  print("    <COMPOSITE>\n");
  for (std::size_t b = 0; b < names.size(); ++b) write_composite(id++, names[b], boundary, boundaries[b]);
  for (int r = 0; r < groups.num_regions(); ++r) {
    if (!elements[r].empty()) region_ids_.push_back(id);
    write_composite(id++, groups.region_names[r], element, elements[r]);
  }
  print("    </COMPOSITE>\n    <DOMAIN>\n      <D ID=\"0\"> C[{}] </D>\n    </DOMAIN>\n", ranges(region_ids_));
}

void NektarText::write_composite(int id, const std::string& name, char letter, const std::vector<int>& members) {
  if (members.empty()) return;  // an empty list is an error of the file
  print("      <C ID=\"{}\" NAME=\"{}\"> {}[{}] </C>\n", id, escaped(name), letter, ranges(members));
}

void NektarText::end(int order) {
  print("  </GEOMETRY>\n  <EXPANSIONS>\n    <E COMPOSITE=\"C[{}]\" NUMMODES=\"{}\" TYPE=\"MODIFIED\" FIELDS=\"u\" />\n",
        ranges(region_ids_), order + 1);
  print("  </EXPANSIONS>\n</NEKTAR>\n");
}

void add_nektar_names_loss(const Groups& groups, Exported& exported) {
  std::size_t count = 0;
  for (const auto* names : {&groups.boundary_names, &groups.interface_names, &groups.region_names})
    count += std::count_if(names->begin(), names->end(),
                           [](const std::string& name) { return std::any_of(name.begin(), name.end(), is_control); });
  if (count > 0)
    exported.add_loss(
        fmt::format("XML cannot represent control characters: those of {} names are replaced by underscores", count));
}

}  // namespace quadrille::exports
