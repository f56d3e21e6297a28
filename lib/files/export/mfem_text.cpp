#include "export/mfem_text.hpp"

#include <fmt/format.h>

#include "base/message_text.hpp"

namespace quadrille::exports {

namespace {

/// As std::quoted writes it, which is how MFEM reads it.
std::string mfem_quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace

void MfemText::begin(bool with_names, int dim) { print("MFEM mesh v1.{}\n\ndimension\n{}\n", with_names ? 3 : 0, dim); }

void MfemText::write_sets(const char* title, const std::vector<std::string>& names) {
  print("\n{}\n{}\n", title, names.size());
  for (std::size_t k = 0; k < names.size(); ++k) print("{} 1 {}\n", mfem_quoted(names[k]), k + 1);
}

// Ordering 1: the coordinates of a node together.
void MfemText::write_space(const char* kind, int dim, int order, int space_dim) {
  print("\nnodes\nFiniteElementSpace\nFiniteElementCollection: {}_{}D_P{}\nVDim: {}\nOrdering: 1\n\n", kind, dim, order,
        space_dim);
}

void add_mfem_names(const Groups& groups, Exported& exported) {
  exported.side_files.push_back(names_table(groups, groups.boundary_names, groups.region_names, true));
  exported.add_loss(
      fmt::format("MFEM v1.0 stores {} and {} by number only; their names are in *.names.json "
                  "(--format mfem13 keeps them, for MFEM 4.7 and later)",
                  groups.num_boundaries() == 1 ? "1 boundary" : fmt::format("{} boundaries", groups.num_boundaries()),
                  counted(groups.num_regions(), "region")));
}

}  // namespace quadrille::exports
