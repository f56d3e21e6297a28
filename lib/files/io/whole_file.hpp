#pragma once
// Files as a whole: an input is read into memory, with its digest; an output is written to a temporary name in the same
// folder, flushed, then renamed, so that there is never a half file under the final name.

#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/provenance.hpp"

namespace quadrille::io {

struct InputFile : FileIdentity {
  std::string bytes;
};

/// Reads `path` ("-": standard input). Throws FormatError when it cannot be read, is a directory or a terminal.
InputFile read_input(const std::string& path);

/// Whether a file has to survive a failure of the machine, or only the run (its scratch files).
enum class Lasting { on_disk, for_the_run };

/// Writes `bytes` to `path` ("-": standard output; binary is refused on a terminal). A file that exists keeps its mode,
/// a symbolic link its place. Throws OutputError.
void write_output(const std::string& path, const std::string& bytes, bool is_binary,
                  Lasting lasting = Lasting::on_disk);

/// Writes a report as JSON: {"tool", "version", entries nested by their dots, "warnings": [{code, message}]}.
void write_report(const std::string& path, const std::string& tool, const std::string& version, const Report& report);

/// Its text.
std::string report_text(const std::string& tool, const std::string& version, const Report& report);

/// A JSON object in one line, as a report that was written before. Throws FormatError if the file is no JSON object;
/// `what`: what it should be, and `page`, where that is described, for the message.
std::string read_object(const std::string& path, const std::string& what, const std::string& page);

}  // namespace quadrille::io
