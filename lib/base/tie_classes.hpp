#pragma once
// Classes of ties: values that rounding must not tell apart are decided together. Tolerances are absolute: the caller
// multiplies a relative one (1e-6 of a diameter) by its scale. Tolerances are no ordering: sort first, by the values.

#include <iterator>

namespace quadrille {

/// The end of the class that starts at `first` in a range of ascending `value`s: each is at most `tol` above the one
/// before, so that a class may be wider than `tol` and no two classes are nearer than that. first != last.
template <typename Iterator, typename Value>
Iterator end_of_chained_ties(Iterator first, Iterator last, double tol, const Value& value) {
  Iterator end = std::next(first);
  while (end != last && value(*end) - value(*std::prev(end)) <= tol) ++end;
  return end;
}

/// The same where each is at most `tol` above the first of its class: no class is wider than `tol`, but values of two
/// classes may be nearer than that.
template <typename Iterator, typename Value>
Iterator end_of_ties(Iterator first, Iterator last, double tol, const Value& value) {
  Iterator end = std::next(first);
  while (end != last && value(*end) - value(*first) <= tol) ++end;
  return end;
}

}  // namespace quadrille
