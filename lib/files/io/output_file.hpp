#pragma once
// Atomic output: a temporary name in the same folder, flushed, then renamed; never a half file under the final name.

#include <string>

#include "base/report.hpp"

namespace quadrille::io {

/// Whether a file has to survive a failure of the machine, or only the run (its scratch files).
enum class Lasting { on_disk, for_the_run };

/// Writes `bytes` to `path` ("-": standard output; binary is refused on a terminal). A file that exists keeps its mode,
/// a symbolic link its target's place. Throws OutputError.
void write_output(const std::string& path, const std::string& bytes, bool is_binary, Lasting lasting = Lasting::on_disk);

/// Writes a report as JSON: {"tool", "version", entries nested by their dots, "warnings": [{code, message}]}.
void write_report(const std::string& path, const std::string& tool, const std::string& version, const Report& report);

/// Its text.
std::string report_text(const std::string& tool, const std::string& version, const Report& report);

/// A report that was written before, as JSON in one line. Throws FormatError if the file is no JSON object.
std::string read_report(const std::string& path);

}  // namespace quadrille::io
