#pragma once
// Classes of ties: values that differ by rounding only are decided together. Tolerances are absolute: the caller
// multiplies a relative one (1e-6 of a diameter) by its scale. Comparison with a tolerance is not an ordering: sort by
// the exact values first.

#include <iterator>

namespace quadrille {

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
