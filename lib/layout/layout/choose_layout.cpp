#include "layout/choose_layout.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "simplify/block_quality.hpp"

namespace quadrille::layout {
namespace {

// The number of blocks between whole lines grows with the square of the number of lines.
constexpr int max_traced_lines = 500;

// Lines that stop at each other result in one block per line plus the Euler characteristic of the domain. If whole
// lines result in this many times as many blocks, they probably cross each other more often than necessary.
constexpr double many_blocks = 1.2;

// Integer lengths displace lines by up to their unit; between corners that are much nearer to each other blocks become
// so skew that more of them are the lesser evil.
constexpr double poor_scaled_jacobian = 0.3;

void report_choice(LayoutMethod method, const std::string& reason, Report& report) {
  report.set("layout.method", enum_name(method));
  if (!reason.empty()) report.set("layout.reason", reason);
}

// The quantized layout if it is preferable to `traced`.
std::optional<graph::CandidateLayout> preferable_layout(const graph::CandidateLayout& traced,
                                                        const LayoutComputation& quantized, Report& report) {
  Report attempt_report(report.progress());
  LayoutAttempt attempt = quantized(attempt_report);
  if (!attempt.layout || attempt.layout->subdivision.num_faces() >= traced.subdivision.num_faces()) return std::nullopt;
  const LayoutQuality before = quality_of(traced.subdivision), after = quality_of(attempt.layout->subdivision);
  if (!is_preferable(after, before)) return std::nullopt;
  for (const auto& [key, value] : attempt_report.entries()) report.set(key, value);
  attempt.layout->certificate.reason =
      fmt::format("{} separatrices that are followed to their ends make {} blocks, {} will do", traced.lines.size(),
                  before.num_blocks, after.num_blocks);
  return std::move(attempt.layout);
}

ChosenLayout traced_or_preferable(graph::CandidateLayout traced, const LayoutComputation& quantized, Report& report) {
  ChosenLayout chosen{std::move(traced), LayoutMethod::traced, ""};
  const auto num_lines = static_cast<int>(chosen.layout.lines.size());
  if (has_many_blocks(chosen.layout.subdivision.num_faces(), num_lines,
                      chosen.layout.graph().face.euler_characteristic()))
    if (std::optional<graph::CandidateLayout> other = preferable_layout(chosen.layout, quantized, report))
      chosen = {std::move(*other), LayoutMethod::quantized, ""};
  report_choice(chosen.method, chosen.layout.certificate.reason, report);
  return chosen;
}

ChosenLayout midpoint_instead(const std::string& reason, const CertainLayout& midpoint, Report& report) {
  if (!midpoint) throw ComputeError(reason);
  report_choice(LayoutMethod::midpoint, reason, report);
  ChosenLayout chosen{midpoint(report), LayoutMethod::midpoint, midpoint_warning(reason)};
  chosen.layout.certificate.reason = reason;
  return chosen;
}

ChosenLayout instead(graph::CandidateLayout layout, LayoutMethod method, const std::string& reason,
                     const char* consequence, Report& report) {
  report_choice(method, reason, report);
  layout.certificate.reason = reason;
  return {std::move(layout), method, reason + consequence};
}

constexpr const char* crowded_consequence =
    ": each separatrix was followed to its end all the same, which makes many blocks";

// The crowded layout if the quantized one is poor and this is better.
std::optional<graph::CandidateLayout> better_crowded_layout(const graph::CandidateLayout& quantized,
                                                            const LayoutComputation& crowded, Report& report) {
  const LayoutQuality poor = quality_of(quantized.subdivision);
  if (poor.is_valid && poor.least_scaled_jacobian >= poor_scaled_jacobian) return std::nullopt;
  Report attempt_report(report.progress());
  LayoutAttempt attempt = crowded(attempt_report);
  if (!attempt.layout || !is_better_shaped(quality_of(attempt.layout->subdivision), poor)) return std::nullopt;
  for (const auto& [key, value] : attempt_report.entries()) report.set(key, value);
  return std::move(attempt.layout);
}

ChosenLayout instead_of_traced(const LayoutAttempt& traced, bool is_traceable, const LayoutComputations& compute,
                               Report& report) {
  LayoutAttempt quantized = compute.quantized(report);
  if (quantized.layout && traced.is_crowded && is_traceable)
    if (auto crowded = better_crowded_layout(*quantized.layout, compute.crowded, report))
      return instead(std::move(*crowded), LayoutMethod::traced,
                     traced.reason + "; stopped where they meet, they make blocks with angles near 180 degrees",
                     crowded_consequence, report);
  if (quantized.layout)
    return instead(
        std::move(*quantized.layout), LayoutMethod::quantized, traced.reason,
        ": each separatrix was stopped at the first line that crosses it, and continued by an integer program", report);
  const std::string reason = quantized.reason == traced.reason
                                 ? traced.reason
                                 : traced.reason + "; stopped where they meet: " + quantized.reason;
  if (traced.is_crowded) {
    LayoutAttempt crowded = compute.crowded(report);
    if (crowded.layout)
      return instead(std::move(*crowded.layout), LayoutMethod::traced, reason, crowded_consequence, report);
  }
  return midpoint_instead(reason, compute.midpoint, report);
}

}  // namespace

std::string midpoint_warning(const std::string& reason) {
  return reason +
         ": the face was divided into triangles, and each of them into three blocks, with many irregular nodes";
}

ChosenLayout choose_layout(int num_separatrices, const LayoutComputations& compute, Report& report) {
  LayoutAttempt attempt{
      std::nullopt, fmt::format("{} separatrices are too many to be followed to their ends", num_separatrices), true};
  const bool is_traceable = num_separatrices <= max_traced_lines;
  if (is_traceable) attempt = compute.traced(report);
  if (!attempt.layout) return instead_of_traced(attempt, is_traceable, compute, report);
  return traced_or_preferable(std::move(*attempt.layout), compute.quantized, report);
}

bool has_many_blocks(int num_blocks, int num_lines, int euler_characteristic) {
  return num_blocks > many_blocks * (static_cast<double>(num_lines) + euler_characteristic);
}

LayoutQuality quality_of(const graph::Subdivision& subdivision) {
  simplify::BlockQuads quads;
  const simplify::BlockQuality quality = simplify::worst_quality(subdivision, simplify::all_faces(subdivision), quads);
  return {subdivision.num_faces(), simplify::are_valid(quads), quality.least_scaled_jacobian};
}

bool is_preferable(const LayoutQuality& quantized, const LayoutQuality& traced) {
  return quantized.num_blocks < traced.num_blocks && quantized.is_valid &&
         quantized.least_scaled_jacobian >= traced.least_scaled_jacobian - tolerance::tied;
}

bool is_better_shaped(const LayoutQuality& crowded, const LayoutQuality& quantized) {
  return crowded.is_valid && (!quantized.is_valid || crowded.least_scaled_jacobian > quantized.least_scaled_jacobian);
}

}  // namespace quadrille::layout
