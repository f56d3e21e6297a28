#pragma once
// Counts in messages.

#include <concepts>
#include <string>

namespace quadrille {

/// "1 block", "2 blocks".
std::string counted(std::integral auto count, const std::string& noun) {
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

}  // namespace quadrille
