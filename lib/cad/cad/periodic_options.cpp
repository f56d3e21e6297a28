#include "cad/periodic_options.hpp"

#include <string_view>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/name_text.hpp"
#include "base/number_list.hpp"

namespace quadrille::cad {
namespace {

constexpr const char* expected =
    ": expected A=B, A=B:translate=DX,DY or A=B:rotate=DEGREES[,CX,CY], where A and B are names of curves";

GivenMotion rotation(double angle, Vec2 centre) {
  const Vec2 turn = unit(angle);
  return {angle, centre - Vec2{turn.x * centre.x - turn.y * centre.y, turn.y * centre.x + turn.x * centre.y}};
}

PeriodicRequest request_of(const std::string& option) {
  PeriodicRequest request;
  request.where = "--periodic " + option;
  std::string names = option;
  for (const std::string kind : {":translate=", ":rotate="}) {
    const std::size_t at = option.rfind(kind);
    if (at == std::string::npos) continue;
    names = option.substr(0, at);
    const std::vector<double> numbers = numbers_of(std::string_view(option).substr(at + kind.size()));
    if (kind == ":translate=" && numbers.size() == 2)
      request.motion = GivenMotion{0, {numbers[0], numbers[1]}};
    else if (kind == ":rotate=" && numbers.size() == 1)
      request.motion = rotation(radians(numbers[0]), {});
    else if (kind == ":rotate=" && numbers.size() == 3)
      request.motion = rotation(radians(numbers[0]), {numbers[1], numbers[2]});
    else
      throw UsageError(request.where + expected);
  }
  const std::size_t equal = names.find('=');
  if (equal == std::string::npos) throw UsageError(request.where + expected);
  request.first = clean_name(names.substr(0, equal));
  request.second = clean_name(names.substr(equal + 1));
  if (request.first.empty() || request.second.empty()) throw UsageError(request.where + expected);
  if (request.first == request.second)
    throw UsageError(request.where + ": both sides have one name; give them two names (--name)");
  return request;
}

}  // namespace

std::vector<PeriodicRequest> periodic_options(const std::vector<std::string>& options) {
  std::vector<PeriodicRequest> requests;
  for (const std::string& option : options) requests.push_back(request_of(option));
  return requests;
}

}  // namespace quadrille::cad
