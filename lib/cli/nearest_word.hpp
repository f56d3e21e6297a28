#pragma once
// The word that a mistyped one stands for. pipelines/lib/nearest_word.py has the same rule.

#include <string>
#include <vector>

namespace quadrille::cli {

/// Of `words`, the one with the fewest typing errors (letters that are missing, surplus, wrong or exchanged with their
/// neighbour), at most one in four letters and the first of several; a beginning of a word, of at least 5 letters
/// ("--ver"), counts as one error. An empty text if no word is that similar.
std::string nearest_word(const std::string& word, const std::vector<std::string>& words);

}  // namespace quadrille::cli
