#include "offset/offset_request.hpp"

#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "base/name_text.hpp"

namespace quadrille::offset {
namespace {

OffsetRequest request_of(const std::string& option) {
  const std::string where = "--offset " + option;
  const std::size_t equal = option.rfind('=');
  if (equal == std::string::npos || equal == 0)
    throw UsageError(where + ": expected NAME=T, with the distance T in file units");
  OffsetRequest request{split_at_commas(option.substr(0, equal)), 0, where};
  const char *begin = option.data() + equal + 1, *end = option.data() + option.size();
  const auto [stop, error] = std::from_chars(begin, end, request.distance);
  if (error != std::errc() || stop != end || !std::isfinite(request.distance))
    throw UsageError(where + ": '" + std::string(begin, end) + "' is not a number");
  if (!(request.distance > 0)) throw UsageError(where + ": the distance must be positive");
  for (const std::string& name : request.names)
    if (name.empty()) throw UsageError(where + ": the name of a boundary is empty");
  return request;
}

}  // namespace

std::vector<OffsetRequest> offset_requests(const std::vector<std::string>& options) {
  std::vector<OffsetRequest> requests;
  for (const std::string& option : options) requests.push_back(request_of(option));
  return requests;
}

}  // namespace quadrille::offset
