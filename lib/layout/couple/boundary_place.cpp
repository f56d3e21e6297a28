#include "couple/boundary_place.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "curve/project.hpp"

namespace quadrille::couple {
namespace {

// The next sector about a joint in clockwise direction lies behind the outgoing curve.
std::optional<Place> behind_outgoing(const CadFace& face, int joint) {
  if (!face.is_interface(joint)) return std::nullopt;
  return place_at(face, face.partners[joint], face.curves[face.partners[joint]].end());
}

// In counter-clockwise direction it lies behind the incoming curve.
std::optional<Place> behind_incoming(const CadFace& face, int joint) {
  const int incoming = face.previous_in_loop(joint);
  if (!face.is_interface(incoming)) return std::nullopt;
  return place_at(face, face.partners[incoming], face.curves[face.partners[incoming]].begin());
}

}  // namespace

Place place_at(const CadFace& face, int curve, double t) {
  if (t < face.curves[curve].end()) return {curve, t};
  const int next = face.next_in_loop(curve);
  return {next, face.curves[next].begin()};
}

Place place_on_loop(const CadFace& face, int loop, Vec2 position) {
  constexpr double relative_same = 1e-9;  // relative to the diameter
  Place best;
  double least = std::numeric_limits<double>::infinity();
  for (int c = face.loop_offsets[loop]; c < face.loop_offsets[loop + 1]; ++c) {
    if (distance(face.joints[c].position, position) <= relative_same * face.diameter)
      return {c, face.curves[c].begin()};
    const curve::Projection p = curve::project(face.curves[c], position);
    if (p.distance < least) {
      least = p.distance;
      best = place_at(face, c, p.t);
    }
  }
  return best;
}

double partner_parameter(const CadFace& face, int curve, double t) {
  const Nurbs &own = face.curves[curve], &other = face.curves[face.partners[curve]];
  if (t == own.begin()) return other.end();
  if (t == own.end()) return other.begin();
  return std::clamp(other.begin() + (own.end() - t), other.begin(), other.end());
}

std::vector<Place> places_of_point(const CadFace& face, const Place& place) {
  std::vector<Place> places{place};
  if (!place.is_joint(face)) {
    if (face.is_interface(place.curve))
      places.push_back(place_at(face, face.partners[place.curve], partner_parameter(face, place.curve, place.t)));
  } else {
    for (auto next = behind_incoming(face, place.curve); next; next = behind_incoming(face, next->curve)) {
      if (*next == place) break;
      places.push_back(*next);
    }
    if (!is_inside_whole(face, place)) {
      std::vector<Place> before;
      for (auto next = behind_outgoing(face, place.curve); next; next = behind_outgoing(face, next->curve))
        before.push_back(*next);
      places.insert(places.begin(), before.rbegin(), before.rend());
      return places;
    }
  }
  std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
  return places;
}

bool is_inside_whole(const CadFace& face, const Place& place) {
  if (!place.is_joint(face)) return face.is_interface(place.curve);
  for (auto next = behind_incoming(face, place.curve); next; next = behind_incoming(face, next->curve))
    if (*next == place) return true;
  return false;
}

}  // namespace quadrille::couple
