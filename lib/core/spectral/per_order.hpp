#pragma once
// Tables that depend on an order only: computed on first use, kept until the program ends, thread-safe.

#include <map>
#include <memory>
#include <mutex>

namespace quadrille::spectral {

template <class Table>
class PerOrder {
 public:
  explicit PerOrder(Table (*make)(int)) : make_(make) {}

  /// The table for `order`; the reference stays valid.
  const Table& operator[](int order) {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Table>& entry = tables_[order];
    if (!entry) entry = std::make_unique<Table>(make_(order));
    return *entry;
  }

 private:
  Table (*make_)(int);
  std::mutex mutex_;
  std::map<int, std::unique_ptr<Table>> tables_;
};

/// The table that its constructor makes from the order.
template <class Table>
const Table& table_per_order(int order) {
  static PerOrder<Table> tables([](int n) { return Table(n); });
  return tables[order];
}

}  // namespace quadrille::spectral
