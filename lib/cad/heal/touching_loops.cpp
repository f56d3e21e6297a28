#include "heal/touching_loops.hpp"

#include <algorithm>
#include <map>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"

namespace quadrille::heal {
namespace {

/// The directions of curves are compared at this part of the shortest one's length from the point of contact, where
/// curves with a common tangent have left each other.
constexpr double compared_at = 1e-3;

// ---- Joints that lie on another curve

using Cuts = std::map<double, Vec2>;  // by parameter

Cuts cuts_of(const Nurbs& curve, const std::vector<Vec2>& joints, const ContactTolerance& tol) {
  Cuts cuts;
  const curve::PoleBox box = curve::pole_box(curve);
  for (const Vec2 x : joints) {
    if (!box.contains(x, tol.of_curves)) continue;
    if (std::min(distance(x, curve.poles.front()), distance(x, curve.poles.back())) <= tol.of_joints) continue;
    const auto nearest = curve::project(curve, x);
    const bool is_inside = curve.begin() < nearest.t && nearest.t < curve.end();
    if (is_inside && nearest.distance <= tol.of_curves) cuts.emplace(nearest.t, x);
  }
  return cuts;
}

void add_pieces(const LoopCurve& whole, const Cuts& cuts, Loop& loop) {
  double begin = whole.curve.begin();
  Vec2 start = whole.curve.poles.front();
  const auto add = [&](double end, Vec2 x) {
    loop.push_back(whole);
    loop.back().curve = curve::with_ends(curve::trimmed(whole.curve, begin, end), start, x);
    begin = end, start = x;
  };
  for (const auto& [t, x] : cuts) add(t, x);
  add(whole.curve.end(), whole.curve.poles.back());
}

std::vector<Loop> split_at_joints(const std::vector<Loop>& loops, const ContactTolerance& tol) {
  std::vector<Vec2> joints;
  for (const Loop& loop : loops)
    for (const LoopCurve& c : loop) joints.push_back(c.curve.poles.front());
  std::vector<Loop> result;
  for (const Loop& loop : loops) {
    result.emplace_back();
    for (const LoopCurve& c : loop) {
      const Cuts cuts = cuts_of(c.curve, joints, tol);
      if (cuts.empty())
        result.back().push_back(c);
      else
        add_pieces(c, cuts, result.back());
    }
  }
  return result;
}

// ---- Curves in one list, and which one follows

struct Chain {
  std::vector<LoopCurve> curves;
  std::vector<int> previous, next;
};

Chain chain_of(const std::vector<Loop>& loops) {
  Chain chain;
  for (const Loop& loop : loops) {
    const int first = static_cast<int>(chain.curves.size()), count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i) {
      chain.curves.push_back(loop[i]);
      chain.previous.push_back(first + (i + count - 1) % count);
      chain.next.push_back(first + (i + 1) % count);
    }
  }
  return chain;
}

std::vector<Loop> loops_of(const Chain& chain, std::vector<bool> is_done) {
  std::vector<Loop> loops;
  for (size_t first = 0; first < chain.curves.size(); ++first) {
    if (is_done[first]) continue;
    loops.emplace_back();
    for (size_t i = first; !is_done[i]; i = chain.next[i]) {
      is_done[i] = true;
      loops.back().push_back(chain.curves[i]);
    }
  }
  return loops;
}

// ---- Points of contact

using Contact = std::vector<int>;  // the curves that start there

// Whether joint j is the next one after joint i, or the other way round, and the curve between them is as short as the
// tolerance: that is no contact.
bool are_neighbours(const Chain& chain, int i, int j, double tol) {
  const auto is_short = [&](int curve) { return curve::pole_box(chain.curves[curve].curve).diagonal() <= 2 * tol; };
  return (chain.next[i] == j && is_short(i)) || (chain.next[j] == i && is_short(j));
}

// Joints within the tolerance of each other, by a sweep from left to right.
std::vector<Contact> contacts_of(const Chain& chain, double tol) {
  std::vector<int> order;
  const auto at = [&](int i) { return chain.curves[i].curve.poles.front(); };
  for (int i = 0; i < static_cast<int>(chain.curves.size()); ++i) order.push_back(i);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return at(a).x < at(b).x; });
  std::vector<Contact> contacts;
  std::vector<bool> is_done(order.size(), false);
  for (size_t m = 0; m < order.size(); ++m) {
    if (is_done[order[m]]) continue;
    Contact contact{order[m]};
    for (size_t n = m + 1; n < order.size() && at(order[n]).x <= at(order[m]).x + tol; ++n)
      if (!is_done[order[n]] && distance(at(order[n]), at(order[m])) <= tol &&
          !are_neighbours(chain, order[n], order[m], tol))
        contact.push_back(order[n]);
    for (const int i : contact) is_done[i] = true;
    std::sort(contact.begin(), contact.end());
    if (contact.size() > 1) contacts.push_back(std::move(contact));
  }
  return contacts;
}

void give_one_position(const Contact& contact, Chain& chain) {
  const Vec2 x = chain.curves[contact.front()].curve.poles.front();
  for (const int i : contact) {
    Nurbs &out = chain.curves[i].curve, &in = chain.curves[chain.previous[i]].curve;
    out = curve::with_ends(out, x, &in == &out ? x : out.poles.back());
    in = curve::with_ends(in, in.poles.front(), x);
  }
}

// A curve seen from the point of contact.
struct Ray {
  double angle = 0;
  int curve = 0;
  bool starts = false;  // there; the face lies counter-clockwise of it
};

std::vector<Ray> rays_of(const Contact& contact, const Chain& chain) {
  const Vec2 x = chain.curves[contact.front()].curve.poles.front();
  std::vector<std::pair<curve::ArcLength, Ray>> ends;
  for (const int i : contact) {
    ends.emplace_back(curve::ArcLength(chain.curves[i].curve), Ray{0, i, true});
    const int in = chain.previous[i];
    ends.emplace_back(curve::ArcLength(chain.curves[in].curve), Ray{0, in, false});
  }
  double shortest = ends.front().first.total();
  for (const auto& [length, ray] : ends) shortest = std::min(shortest, length.total());
  std::vector<Ray> rays;
  for (auto& [length, ray] : ends) {
    const double s = compared_at * shortest;
    const double t = length.parameter(ray.starts ? s : length.total() - s);
    ray.angle = wrap_two_pi(angle_of(curve::point(chain.curves[ray.curve].curve, t) - x));
    rays.push_back(ray);
  }
  std::stable_sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.angle < b.angle; });
  return rays;
}

// Each curve that starts bounds the sector up to the next curve that ends, counter-clockwise. Otherwise curves cross or
// lie upon each other.
bool bound_sectors(const std::vector<Ray>& rays) {
  for (size_t i = 0; i < rays.size(); ++i) {
    const Ray& next = rays[(i + 1) % rays.size()];
    if (next.starts == rays[i].starts || next.angle == rays[i].angle) return false;
  }
  return true;
}

void separate(const Contact& contact, Chain& chain) {
  const std::vector<Ray> rays = rays_of(contact, chain);
  if (!bound_sectors(rays)) return;
  for (size_t i = 0; i < rays.size(); ++i) {
    if (!rays[i].starts) continue;
    const int in = rays[(i + 1) % rays.size()].curve;
    chain.next[in] = rays[i].curve;
    chain.previous[rays[i].curve] = in;
  }
}

// ---- Curves that lie upon each other

bool lie_upon_each_other(const Nurbs& a, const Nurbs& b, double tol) {
  if (a.poles.front() != b.poles.back() || a.poles.back() != b.poles.front()) return false;
  constexpr int num_samples = 16;
  for (int i = 1; i < num_samples; ++i)
    if (curve::project(b, curve::point(a, a.begin() + (a.end() - a.begin()) * i / num_samples)).distance > tol)
      return false;
  return true;
}

/// For each curve the one that lies upon it in the opposite direction, or -1. Both start at points of contact.
std::vector<int> twins_of(const Chain& chain, const std::vector<Contact>& contacts, double tol) {
  std::vector<int> twins(chain.curves.size(), -1), starts;
  for (const Contact& contact : contacts) starts.insert(starts.end(), contact.begin(), contact.end());
  for (size_t m = 0; m < starts.size(); ++m)
    for (size_t n = m + 1; n < starts.size(); ++n) {
      const int a = starts[m], b = starts[n];
      if (twins[a] >= 0 || twins[b] >= 0) continue;
      if (lie_upon_each_other(chain.curves[a].curve, chain.curves[b].curve, tol)) twins[a] = b, twins[b] = a;
    }
  return twins;
}

/// Where a curve with a twin follows, the boundary goes on behind its twin.
void leave_out(const std::vector<int>& twins, Chain& chain, std::vector<CommonLine>& common) {
  const std::vector<int> next = chain.next;
  for (int i = 0; i < static_cast<int>(twins.size()); ++i) {
    if (twins[i] >= 0) {
      const LoopCurve &a = chain.curves[i], &b = chain.curves[twins[i]];
      if (i < twins[i])
        common.push_back(
            {a.cad_edge, b.cad_edge, a.curve.poles.front(), a.curve.poles.back(), curve::ArcLength(a.curve).total()});
      continue;
    }
    int n = next[i];
    while (twins[n] >= 0) n = next[twins[n]];
    chain.next[i] = n, chain.previous[n] = i;
  }
}

}  // namespace

std::vector<Loop> separated_loops(const std::vector<Loop>& loops, const ContactTolerance& tol,
                                  std::vector<CommonLine>* common) {
  Chain chain = chain_of(split_at_joints(loops, tol));
  std::vector<Contact> contacts = contacts_of(chain, tol.of_joints);
  if (contacts.empty()) return loops;
  for (const Contact& contact : contacts) give_one_position(contact, chain);
  std::vector<bool> is_left_out(chain.curves.size(), false);
  const std::vector<int> twins = twins_of(chain, contacts, tol.of_joints);
  const bool has_others = std::find(twins.begin(), twins.end(), -1) != twins.end();  // else nothing would be left
  if (common != nullptr && has_others) {
    leave_out(twins, chain, *common);
    for (size_t i = 0; i < twins.size(); ++i) is_left_out[i] = twins[i] >= 0;
    for (Contact& contact : contacts) std::erase_if(contact, [&](int i) { return is_left_out[i]; });
    std::erase_if(contacts, [](const Contact& contact) { return contact.size() < 2; });
  }
  for (const Contact& contact : contacts) separate(contact, chain);
  return loops_of(chain, is_left_out);
}

std::vector<std::vector<bool>> contacts_at_starts(const std::vector<Loop>& loops) {
  const auto less = [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  std::map<Vec2, int, decltype(less)> counts(less);
  for (const Loop& loop : loops)
    for (const LoopCurve& c : loop) ++counts[c.curve.poles.front()];
  std::vector<std::vector<bool>> result;
  for (const Loop& loop : loops) {
    result.emplace_back();
    for (const LoopCurve& c : loop) result.back().push_back(counts[c.curve.poles.front()] > 1);
  }
  return result;
}

}  // namespace quadrille::heal
