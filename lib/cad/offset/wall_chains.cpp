#include "offset/wall_chains.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/number_list.hpp"
#include "curve/named_places.hpp"
#include "surface/positions.hpp"

namespace quadrille::offset {

namespace {

OffsetRequest request_of(const std::string& option) {
  const std::string where = "--offset " + option;
  const std::size_t equal = option.rfind('=');
  if (equal == std::string::npos || equal == 0)
    throw UsageError(where + ": expected NAME=T, with the distance T in file units");
  OffsetRequest request{split_at_commas(option.substr(0, equal)), 0, where};
  const std::string text = option.substr(equal + 1);
  const std::optional<double> distance = finite_number_of(text);
  if (!distance) throw UsageError(where + ": '" + text + "' is not a number");
  if (*distance <= 0) throw UsageError(where + ": the distance must be positive");
  request.distance = *distance;
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

namespace {

bool goes_on(const CadFace& face, int joint) {
  return face.joints[joint].interior_angle > offset_constants.greatest_end_angle;
}

/// Gives the request of a wall to its neighbours, forwards or backwards, until a corner ends it.
void extend(const CadFace& face, int wall, bool is_forwards, const std::vector<int>& named, std::vector<int>& extended,
            const std::vector<OffsetRequest>& requests, const std::vector<bool>& is_on_line) {
  const int request = named[wall];
  for (int c = wall;;) {
    const int next = is_forwards ? face.next_in_loop(c) : face.previous_in_loop(c);
    if (!goes_on(face, is_forwards ? next : c) || is_on_line[next] || named[next] >= 0 || extended[next] == request)
      return;
    if (extended[next] >= 0 && requests[extended[next]].distance != requests[request].distance)
      throw UsageError(
          fmt::format("{} and {}: both curves go on along the boundary {} between them: give both the "
                      "same distance",
                      requests[request].where, requests[extended[next]].where, face.curve_names[next]));
    extended[next] = request;
    c = next;
  }
}

void require_equal_distances(const CadFace& face, int joint, int before, int after,
                             const std::vector<OffsetRequest>& requests) {
  const double angle = face.joints[joint].interior_angle;
  const bool is_bend = std::abs(angle - pi) < pi / 4;
  if (!is_bend || requests[before].distance == requests[after].distance) return;
  throw UsageError(fmt::format("{} and {}: the walls continue each other at {}: give both the same distance",
                               requests[before].where, requests[after].where,
                               surface::position_text(face, face.joints[joint].position)));
}

WallChain chain_from(const CadFace& face, int first, const std::vector<int>& curve_requests,
                     const std::vector<OffsetRequest>& requests) {
  WallChain chain;
  for (int c = first;;) {
    chain.curves.push_back(c);
    chain.requests.push_back(curve_requests[c]);
    chain.distances.push_back(requests[curve_requests[c]].distance);
    const int next = face.next_in_loop(c);
    if (curve_requests[next] < 0) return chain;
    require_equal_distances(face, next, curve_requests[c], curve_requests[next], requests);
    if (next == first) {
      chain.is_closed = true;
      return chain;
    }
    c = next;
  }
}

}  // namespace

std::vector<int> requests_of_curves(const CadFace& face, const std::vector<OffsetRequest>& requests) {
  std::vector<int> named(face.curves.size(), -1);
  for (std::size_t r = 0; r < requests.size(); ++r)
    for (const std::string& name : requests[r].names)
      for (const int c : curve::named_curves(face, name, requests[r].where)) {
        if (named[c] >= 0)
          throw UsageError(fmt::format("{}: the boundary '{}' is named twice", requests[r].where, name));
        named[c] = static_cast<int>(r);
      }
  return named;
}

std::vector<WallChain> wall_chains(const CadFace& face, const std::vector<OffsetRequest>& requests,
                                   const std::vector<bool>& is_on_line) {
  const std::vector<int> named = requests_of_curves(face, requests);
  std::vector<int> extended(named.size(), -1);
  for (int c = 0; c < face.num_curves(); ++c)
    if (named[c] >= 0)
      for (const bool is_forwards : {true, false}) extend(face, c, is_forwards, named, extended, requests, is_on_line);
  for (int c = 0; c < face.num_curves(); ++c)
    if (named[c] >= 0) extended[c] = named[c];
  std::vector<WallChain> chains;
  for (int l = 0; l < face.num_loops(); ++l) {
    const int begin = face.loop_offsets[l], end = face.loop_offsets[l + 1];
    bool is_whole = true;
    for (int c = begin; c < end; ++c) is_whole = is_whole && extended[c] >= 0;
    if (is_whole) {
      chains.push_back(chain_from(face, begin, extended, requests));
      continue;
    }
    for (int c = begin; c < end; ++c)
      if (extended[c] >= 0 && extended[face.previous_in_loop(c)] < 0)
        chains.push_back(chain_from(face, c, extended, requests));
  }
  for (WallChain& chain : chains) {
    chain.begins_on_line = is_on_line[face.previous_in_loop(chain.curves.front())];
    chain.ends_on_line = is_on_line[face.next_in_loop(chain.curves.back())];
  }
  return chains;
}

}  // namespace quadrille::offset
