#include "base/number_list.hpp"

#include <cmath>

#include "base/message_text.hpp"
#include "base/name_text.hpp"

namespace quadrille {

std::optional<double> finite_number_of(std::string_view text) {
  const std::optional<double> number = number_of<double>(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::vector<double> numbers_of(std::string_view list) {
  std::vector<double> numbers;
  for (const std::string& part : split_at_commas(list)) {
    const std::optional<double> number = finite_number_of(part);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace quadrille
