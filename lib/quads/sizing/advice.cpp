#include "sizing/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/tolerance.hpp"
#include "mesh/element_sizes.hpp"
#include "mesh/finer_elements.hpp"

namespace quadrille::sizing {

namespace {

struct AdviceLimits {
  std::array<double, 5> divisors{2, 3, 4, 6, 8};  ///< of the size
  double gain = 5;                                ///< of the resolution ratio, where it does not become good
  double most_quads = 20;                         ///< times those of now
};
constexpr AdviceLimits limits;

/// The number with three digits.
double rounded(double value) { return std::stod(fmt::format("{:.3g}", value)); }

/// By element: the length of now over that of other sizes.
class LengthRatios {
 public:
  LengthRatios(const QuadMesh& mesh, const SizeOptions& applied)
      : mesh_(mesh), applied_(make_size_field(mesh.face, applied)) {}

  double greatest() const { return applied_.greatest_in_space(); }
  double of(int elem, const SizeField& other) const {
    const Vec2 x = mesh::centre(mesh_, elem);
    const int region = mesh_.region_of(elem);
    return applied_.at(x, region) / other.at(x, region);
  }
  std::vector<double> of(const SizeOptions& options) const {
    const SizeField other = make_size_field(mesh_.face, options);
    std::vector<double> ratios;
    for (int elem = 0; elem < mesh_.num_elems(); ++elem) ratios.push_back(of(elem, other));
    return ratios;
  }

 private:
  const QuadMesh& mesh_;
  SizeField applied_;
};

/// The options with this size. An automatic least number of elements along each curve applies only without a size.
SizeOptions with_size(SizeOptions options, double size) {
  options.size = size;
  if (options.per_curve == SizeOptions::automatic) options.per_curve = 0;
  return options;
}

/// A size must shorten the elements that have most of the error: others are prescribed by something else.
std::optional<Advice> smaller_size(const QuadMesh& mesh, const mesh::Fault& fault, const SizeOptions& prescribed,
                                   const SizeOptions& applied) {
  const LengthRatios lengths(mesh, applied);
  const std::vector<std::array<int, 2>> rows = mesh::element_rows(mesh);
  const std::vector<mesh::ElementPowers> powers = mesh::element_powers(mesh);
  for (const double divisor : limits.divisors) {
    const double size = rounded(lengths.greatest() / divisor);
    const std::vector<double> ratios = lengths.of(with_size(prescribed, size));
    if (!(ratios[fault.elem] > 1 + tolerance::tied)) continue;
    const mesh::ExpectedMesh expected = mesh::expected_mesh(rows, powers, ratios);
    if (expected.num_elems > limits.most_quads * mesh.num_elems()) break;
    if (expected.resolution <= std::max(mesh::resolution_limits.good, fault.value / limits.gain))
      return Advice{fmt::format("--size {:g}", size), std::llround(expected.num_elems)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Advice> advice_for(const QuadMesh& mesh, const mesh::Verdict& verdict, const SizeOptions& prescribed,
                                 const SizeOptions& applied) {
  const auto found = std::ranges::find(verdict.faults, mesh::Limit::resolution, &mesh::Fault::limit);
  return found == verdict.faults.end() ? std::nullopt : smaller_size(mesh, *found, prescribed, applied);
}

std::string describe(const Advice& advice) {
  const double digit = std::pow(10, std::floor(std::log10(std::max(advice.quads, 1LL))) - 1);  // two digits are kept
  return fmt::format("; give {} (about {:.0f} quads) for a lower resolution ratio", advice.option,
                     std::round(static_cast<double>(advice.quads) / digit) * digit);
}

}  // namespace quadrille::sizing
