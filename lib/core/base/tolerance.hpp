#pragma once
// When two values count as equal. There is one number for each kind of comparison; every rule that compares, rounds or
// sorts takes it from here, so that a symmetric face gets a symmetric mesh (lib/README.md, "Invariants"). Numbers at
// which an iteration stops, or at which a rule begins to act, are no equality: they stand where they are used.

#include <iterator>

namespace quadrille {
namespace tolerance {

/// Points no farther apart are one place; relative to the diameter of the face. Far above errors of positions, far
/// below any element.
inline constexpr double same_point = 1e-6;

/// Angles and directions that differ by no more are equal; radians.
inline constexpr double same_angle = 1e-6;

/// Costs, lengths and distances that differ by no more are tied, and decided together; relative to their scale, which
/// is the diameter for distances in a face. Errors of what is computed from a field, and of drawings that are meant to
/// be symmetric, stay below.
inline constexpr double tied = 1e-6;

/// What is left by rounding where the exact values are equal; relative to their scale.
inline constexpr double round_off = 1e-9;

}  // namespace tolerance

// Classes of ties. Comparison with a tolerance is not an ordering: sort by the exact values first. `tol` is absolute.

/// The end of the class that starts at `first` in a range of ascending `value`s: each value is at most `tol` above the
/// one before. A class may be wider than `tol`, and the gap between two classes is always larger than `tol`. first !=
/// last.
template <typename Iterator, typename Value>
Iterator end_of_chained_ties(Iterator first, Iterator last, double tol, const Value& value) {
  Iterator end = std::next(first);
  while (end != last && value(*end) - value(*std::prev(end)) <= tol) ++end;
  return end;
}

/// The same, but each value is at most `tol` above the first of its class: no class is wider than `tol`, but values of
/// two classes may be nearer than `tol`.
template <typename Iterator, typename Value>
Iterator end_of_ties(Iterator first, Iterator last, double tol, const Value& value) {
  Iterator end = std::next(first);
  while (end != last && value(*end) - value(*first) <= tol) ++end;
  return end;
}

}  // namespace quadrille
