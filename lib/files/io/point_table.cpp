#include "io/point_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <optional>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/number_list.hpp"

namespace quadrille::io {

namespace {

constexpr std::string_view separators = ",; \t\r\"";

/// Words between commas, semicolons and blanks; quotation marks are no part of them.
std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  for (std::size_t begin = line.find_first_not_of(separators); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    words.emplace_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(separators, end);
  }
  return words;
}

std::vector<std::string> in_small_letters(std::vector<std::string> words) {
  for (std::string& word : words)
    std::transform(word.begin(), word.end(), word.begin(), [](unsigned char c) { return std::tolower(c); });
  return words;
}

/// visit(line number, words) for each line that has words, as long as it returns true.
template <class Visit>
void for_each_line(std::string_view bytes, const Visit& visit) {
  int line = 0;
  for (std::size_t begin = 0; begin < bytes.size();) {
    const std::size_t end = std::min(bytes.find('\n', begin), bytes.size());
    const std::string_view text = bytes.substr(begin, end - begin);
    ++line;
    begin = end + 1;
    const std::vector<std::string> words = words_of(text.substr(0, text.find('#')));
    if (!words.empty() && !visit(line, words)) return;
  }
}

/// Errors name the line.
class TableReader {
 public:
  TableReader(const InputFile& file, const std::vector<std::vector<std::string>>& names)
      : file_(file), names_(names), columns_(names.size()) {
    std::iota(columns_.begin(), columns_.end(), 0);
  }

  std::vector<TableRow> read() {
    for_each_line(file_.bytes, [&](int line, const std::vector<std::string>& words) {
      line_ = line;
      read_line(words);
      return true;
    });
    if (rows_.empty()) throw FormatError(fmt::format("{}: there are no points", file_.name));
    return std::move(rows_);
  }

 private:
  void read_line(const std::vector<std::string>& words) {
    if (rows_.empty() && !has_heading_ && !number_of<double>(words[0])) return read_heading(words);
    const std::size_t needed = *std::max_element(columns_.begin(), columns_.end()) + 1;
    if (words.size() < needed || (!has_heading_ && words.size() != needed))
      fail(fmt::format("expected {} numbers, found {}", needed, words.size()));
    TableRow row{line_, {}};
    for (const std::size_t column : columns_) {
      const std::optional<double> value = finite_number_of(words[column]);
      if (!value) fail(fmt::format("'{}' is not a number", words[column]));
      row.values.push_back(*value);
    }
    rows_.push_back(std::move(row));
  }

  void read_heading(const std::vector<std::string>& given) {
    has_heading_ = true;
    const std::vector<std::string> words = in_small_letters(given);
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const auto at = std::find_first_of(words.begin(), words.end(), names_[k].begin(), names_[k].end());
      if (at == words.end())
        fail(fmt::format("there is no column {}, only {}", fmt::join(names_[k], " or "), fmt::join(given, ", ")));
      columns_[k] = at - words.begin();
    }
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw FormatError(fmt::format("{}:{}: {}", file_.name, line_, why));
  }

  const InputFile& file_;
  const std::vector<std::vector<std::string>>& names_;
  std::vector<TableRow> rows_;
  std::vector<std::size_t> columns_;
  bool has_heading_ = false;
  int line_ = 0;
};

}  // namespace

bool is_point_table(const InputFile& file) {
  const std::size_t first = file.bytes.find_first_not_of(" \t\r\n");
  return first != std::string::npos && file.bytes[first] != '{' && file.bytes[first] != '<';
}

std::vector<std::string> table_heading(const InputFile& file) {
  std::vector<std::string> heading;
  for_each_line(file.bytes, [&](int, const std::vector<std::string>& words) {
    if (!number_of<double>(words[0])) heading = in_small_letters(words);
    return false;
  });
  return heading;
}

std::vector<TableRow> table_rows(const InputFile& file, const std::vector<std::vector<std::string>>& columns) {
  return TableReader(file, columns).read();
}

std::vector<Vec3> space_points(const InputFile& file) {
  std::vector<Vec3> points;
  for (const TableRow& row : table_rows(file, {{"x", "points:0"}, {"y", "points:1"}, {"z", "points:2"}}))
    points.push_back({row.values[0], row.values[1], row.values[2]});
  return points;
}

}  // namespace quadrille::io
