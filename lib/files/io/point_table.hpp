#pragma once
// Tables of points, one a line, with commas, semicolons or blanks between the columns (formats/size-field.md, "As a
// table"). A first line of words names the columns, and `#` begins a comment.

#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.hpp"
#include "io/whole_file.hpp"

namespace quadrille::io {

/// Neither JSON nor XML.
bool is_point_table(const InputFile& file);

/// The words of the first line, in small letters; empty if it has a number first.
std::vector<std::string> table_heading(const InputFile& file);

struct TableRow {
  int line = 0;  ///< in the file, from 1
  std::vector<double> values;
};

/// `columns`: the names that each may have, in small letters; without a heading they are in this order. Throws
/// FormatError, with the line, for anything else, and if there are no points.
std::vector<TableRow> table_rows(const InputFile& file, const std::vector<std::vector<std::string>>& columns);

/// Points x, y, z.
std::vector<Vec3> space_points(const InputFile& file);

}  // namespace quadrille::io
