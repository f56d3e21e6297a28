#include "cli/nearest_word.hpp"

#include <algorithm>

namespace quadrille::cli {

namespace {

constexpr std::size_t least_beginning = 5;

/// Edit distance in which the exchange of two neighbours is one error.
std::size_t num_errors(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = i + j;
        continue;
      }
      const std::size_t wrong = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + wrong});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::size_t num_errors_or_beginning(const std::string& word, const std::string& other) {
  const std::size_t errors = num_errors(word, other);
  return word.size() >= least_beginning && other.starts_with(word) ? std::min<std::size_t>(errors, 1) : errors;
}

}  // namespace

std::string nearest_word(const std::string& word, const std::vector<std::string>& words) {
  std::string nearest;
  std::size_t fewest = (word.size() + 2) / 4 + 1;
  for (const std::string& other : words) {
    const std::size_t errors = num_errors_or_beginning(word, other);
    if (errors >= fewest) continue;
    fewest = errors;
    nearest = other;
  }
  return nearest;
}

}  // namespace quadrille::cli
