#pragma once
// The same work on each region, on threads, with one report.

#include <functional>
#include <utility>
#include <vector>

#include "base/report.hpp"
#include "model/cad_face.hpp"

namespace quadrille::regions {

/// Calls work(region, threads, report) for each region, on `num_threads` threads in all, and adds what each reports to
/// `report`: its keys as regions.<number>.<key>, its warnings with the name of the region. Of one region, it reports
/// straight to `report`. An exception of the work names the region.
void for_each_region(const CadFace& face, int num_threads, Report& report,
                     const std::function<void(int, int, Report&)>& work);

/// One result for each region.
template <typename Result>
std::vector<Result> map_regions(const CadFace& face, int num_threads, Report& report,
                                const std::function<Result(int, int, Report&)>& work) {
  std::vector<Result> results(face.num_regions());
  for_each_region(face, num_threads, report,
                  [&](int r, int threads, Report& part) { results[r] = work(r, threads, part); });
  return results;
}

}  // namespace quadrille::regions
