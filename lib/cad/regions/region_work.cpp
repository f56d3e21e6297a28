#include "regions/region_work.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace quadrille::regions {
namespace {

void merge(const Report& part, const CadFace& face, int region, Report& report) {
  for (const auto& [key, value] : part.entries()) report.set(fmt::format("regions.{}.{}", region, key), value);
  for (const Report::Warning& warning : part.warnings())
    report.warn(warning.code, fmt::format("region {}: {}", face.region_names[region], warning.message));
}

// The errors that an input can cause keep their type, and so their exit code.
void call_named(const std::string& name, const std::function<void()>& work) {
  const auto text = [&](const std::exception& error) { return fmt::format("region {}: {}", name, error.what()); };
  try {
    work();
  } catch (const ComputeError& error) {
    throw ComputeError(text(error));
  } catch (const UsageError& error) {
    throw UsageError(text(error));
  } catch (const FormatError& error) {
    throw FormatError(text(error));
  }
}

}  // namespace

void for_each_region(const CadFace& face, int num_threads, Report& report,
                     const std::function<void(int, int, Report&)>& work) {
  const int n = face.num_regions();
  if (n == 1) return work(0, num_threads, report);
  std::vector<Report> parts(n);
  {
    const Progress::Part done(report.progress(), "regions", n);
    parallel_for(n, num_threads, [&](int r) {
      call_named(face.region_names[r], [&] { work(r, std::max(1, num_threads / n), parts[r]); });
      done.advance();
    });
  }
  for (int r = 0; r < n; ++r) merge(parts[r], face, r, report);
}

}  // namespace quadrille::regions
