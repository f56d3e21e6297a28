#pragma once
// The values of options from texts.

#include <string>

namespace quadrille::cli {

/// `text` as a number in the interval of the option `flag`; a leading + is allowed. Throws UsageError.
double number_within(const std::string& flag, const std::string& text, double low, double high);
int integer_within(const std::string& flag, const std::string& text, int low, int high);

/// The value of --threads: 0 for "auto". Throws UsageError.
int threads_of(const std::string& text);

}  // namespace quadrille::cli
