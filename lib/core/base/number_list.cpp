#include "base/number_list.hpp"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <system_error>

namespace quadrille {

std::vector<double> numbers_of(std::string_view list) {
  std::vector<double> numbers;
  for (;;) {
    double number = 0;
    const auto [end, error] = std::from_chars(list.data(), list.data() + list.size(), number);
    if (error != std::errc() || !std::isfinite(number)) return {};
    numbers.push_back(number);
    list.remove_prefix(static_cast<std::size_t>(end - list.data()));
    if (list.empty()) return numbers;
    if (list.front() != ',') return {};
    list.remove_prefix(1);
  }
}

}  // namespace quadrille
