#pragma once
// Converts names from other programs and people to names as the stage files store them (valid UTF-8, one line,
// trimmed), compares them with patterns, and finds the one that a mistyped word stands for.

#include <string>
#include <string_view>
#include <vector>

namespace quadrille {

/// The bytes of the UTF-8 character with which `text` starts (Unicode 15, table 3-7); 0 if `text` is not UTF-8 there.
int utf8_length(std::string_view text);

bool is_utf8(std::string_view text);

/// `text` itself if it is UTF-8; else every byte read as a character of Latin 1, which never fails.
std::string utf8_or_latin1(const std::string& text);

/// Replaces control characters by blanks and bytes that are not UTF-8 by U+FFFD, and removes blanks at both ends.
std::string clean_name(std::string_view text);

/// For a terminal: control characters other than line feeds, which could begin an escape sequence, and bytes that are
/// not UTF-8 become U+FFFD.
std::string printable_text(std::string_view text);

/// The parts of `text` between its commas; one empty part if it is empty.
std::vector<std::string> split_at_commas(std::string_view text);

/// Whether the whole `text` fits `pattern`, both UTF-8: * is any text, also none, ? one character, all others are
/// themselves. Upper and lower case differ. Cost: product of the lengths.
bool matches_wildcard(std::string_view text, std::string_view pattern);

/// Of `words`, the one with the fewest typing errors (letters that are missing, surplus, wrong or exchanged with their
/// neighbour), at most one in four letters and the first of several; a beginning of a word, of at least 5 letters
/// ("--ver"), counts as one error. An empty text if no word is that similar. pipelines/lib/nearest_word.py has the same
/// rule.
std::string nearest_word(const std::string& word, const std::vector<std::string>& words);

/// " (did you mean NEAREST?)", or an empty text: for a message, behind the word.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& words);

}  // namespace quadrille
