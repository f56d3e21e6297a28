#pragma once
// The provenance of a file: every stage appends one step to the chain that it read (formats/README.md, "Provenance").
// It has no file names, times or machine names: the same input and options result in the same bytes.

#include <string>
#include <vector>

namespace quadrille {

struct InputDigest {
  std::string format;  ///< "step", "tri-mesh", ...
  std::string sha256;  ///< lower-case hexadecimal, of the input's bytes
};

/// A file as messages and the provenance name it.
struct FileIdentity {
  std::string name;    ///< "standard input" for "-"
  std::string sha256;  ///< of its bytes

  InputDigest digest(const std::string& format) const { return {format, sha256}; }
};

struct ProvenanceStep {
  std::string tool;
  std::string version;
  std::vector<InputDigest> inputs;
  std::string options;  ///< JSON object of the options that can change the result, keys sorted
};

using Provenance = std::vector<ProvenanceStep>;

}  // namespace quadrille
