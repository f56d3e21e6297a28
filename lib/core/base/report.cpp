#include "base/report.hpp"

#include <algorithm>

namespace quadrille {

void Report::set(const std::string& key, Value value) {
  const auto known = std::find_if(entries_.begin(), entries_.end(), [&](const auto& e) { return e.first == key; });
  if (known != entries_.end())
    known->second = std::move(value);
  else
    entries_.emplace_back(key, std::move(value));
}

void Report::warn(const std::string& code, const std::string& message) { warnings_.push_back({code, message}); }

}  // namespace quadrille
