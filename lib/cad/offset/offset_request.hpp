#pragma once
// The option --offset of cad2tri: which walls get a curve at a distance.

#include <string>
#include <vector>

namespace quadrille::offset {

struct OffsetRequest {
  std::vector<std::string> names;  ///< of boundary curves, or their numbers
  double distance = 0;             ///< a length, above 0
  std::string where;               ///< the option, for messages
};

/// "NAME=T" or "NAME,NAME=T". Throws UsageError, with the option, for anything else.
std::vector<OffsetRequest> offset_requests(const std::vector<std::string>& options);

}  // namespace quadrille::offset
