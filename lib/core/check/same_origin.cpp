#include "check/same_origin.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace quadrille::check {

bool have_same_origin(const FileIdentity& first, const Provenance& first_chain, const FileIdentity& second,
                      const Provenance& second_chain) {
  const auto holds = [](const Provenance& chain, const std::string& sha256) {
    return std::any_of(chain.begin(), chain.end(), [&](const ProvenanceStep& step) {
      return std::any_of(step.inputs.begin(), step.inputs.end(),
                         [&](const InputDigest& input) { return input.sha256 == sha256; });
    });
  };
  return holds(second_chain, first.sha256) || holds(first_chain, second.sha256);
}

void require_same_origin(const FileIdentity& first, const Provenance& first_chain, const FileIdentity& second,
                         const Provenance& second_chain) {
  if (have_same_origin(first, first_chain, second, second_chain)) return;
  throw OtherOriginError(fmt::format("{} was not made from {}: neither provenance chain holds the other's digest",
                                     second.name, first.name));
}

}  // namespace quadrille::check
