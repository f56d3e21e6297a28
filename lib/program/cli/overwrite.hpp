#pragma once
// A command never replaces a file that it reads, nor one that it has just written. Private to cli.

#include <string>
#include <vector>

namespace quadrille::cli {

/// Throws UsageError if an entry of `written` is the same regular file as an entry of `read`, also by another name of
/// it: another path, or a link. "-" is standard input in `read` and standard output, which is not examined, in
/// `written`. Files that do not exist are different from all of these. Throws UsageError too if two entries of
/// `written` are one file, existing or not, or both are standard output.
void refuse_to_overwrite(const std::vector<std::string>& read, const std::vector<std::string>& written);

}  // namespace quadrille::cli
