#include "base/report.hpp"

namespace quadrille {

void Report::set(const std::string& key, Value value) {
  const auto [known, is_new] = positions_.try_emplace(key, entries_.size());
  if (is_new)
    entries_.emplace_back(key, std::move(value));
  else
    entries_[known->second].second = std::move(value);
}

void Report::warn(const std::string& code, const std::string& message) { warnings_.push_back({code, message}); }

}  // namespace quadrille
