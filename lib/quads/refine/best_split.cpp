#include "refine/best_split.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "refine/remedies.hpp"
#include "sizing/element_limit.hpp"

namespace quadrille::refine {

BestSplit best_split(const SplitRequest& request) {
  const Progress::Part part(request.report.progress(), "attempt");
  part.advance();
  SplitSettings settings = first_settings(request);
  BestSplit best{split(request, settings, nullptr)};
  std::optional<SplitMesh> worse;  // the last attempt, if it is not the best one
  for (; best.num_splits < max_splits; ++best.num_splits) {
    const SplitMesh& last = worse ? *worse : best.split;
    if (std::ranges::none_of(remedies(), [&](Remedy remedy) { return remedy(request, last, settings); })) break;
    part.advance();
    std::optional<SplitMesh> next = sizing::unless_too_many([&] { return split(request, settings, &last); });
    if (!next) break;
    if (mesh::is_better(next->score, best.split.score)) {
      best.split = std::move(*next);
      worse.reset();
    } else {
      worse = std::move(next);
    }
  }
  return best;
}

}  // namespace quadrille::refine
