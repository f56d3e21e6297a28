#pragma once
// Messages of a command. What becomes of them changes neither what it does nor its exit code.

#include <unistd.h>

#include <string_view>

namespace quadrille::cli {

/// Writes `text` to a descriptor, by default that of standard error, as far as it is printable (base/name_text). If
/// that is closed, full or a pipe whose reader has gone, the text is lost without a word: no exception, no SIGPIPE.
void print_message(std::string_view text, int descriptor = STDERR_FILENO);

/// The same with all characters, for the line of progress.
void write_to_terminal(std::string_view text) noexcept;

/// Writes what was asked for to standard output, as far as it is printable. Throws OutputError if that is impossible.
void print_to_stdout(std::string_view text);

/// Opens the standard streams that are closed, so that no file of the run gets their descriptors, and with them what is
/// meant for a stream. Input is then empty and output cannot be written. To be called first.
void occupy_standard_streams() noexcept;

}  // namespace quadrille::cli
