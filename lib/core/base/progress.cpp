#include "base/progress.hpp"

#include <algorithm>

namespace quadrille {

Progress::Part::Part(Progress* progress, const char* name, long long total, Total kind) : progress_(progress) {
  if (progress_ == nullptr) return;
  ++progress_->changes_;
  const int depth = progress_->depth_++;
  if (depth < max_depth) {
    Level& level = progress_->levels_[depth];
    level.name = name;
    level.done = 0;
    level.total = total;
    level.kind = total > 0 ? kind : Total::unknown;
    done_ = &level.done;
  }
  ++progress_->changes_;
}

Progress::Part::~Part() {
  if (progress_ == nullptr) return;
  ++progress_->changes_;
  --progress_->depth_;
  ++progress_->changes_;
}

std::optional<std::vector<Progress::Count>> Progress::counts() const {
  const unsigned changes = changes_;
  if (changes % 2 == 1) return std::nullopt;
  std::vector<Count> counts;
  const int depth = std::min<int>(depth_, max_depth);
  for (int i = 0; i < depth; ++i) {
    const Level& level = levels_[i];
    counts.push_back({level.name, level.done, level.total, level.kind});
  }
  if (changes_ != changes) return std::nullopt;
  return counts;
}

}  // namespace quadrille
