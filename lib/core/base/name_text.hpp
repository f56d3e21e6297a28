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

/// The parts of `text` between its commas outside brackets ( ); one empty part if it is empty.
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

// Names of the entities of a list: given ones, of which no entity may get two, and for unnamed entities their kind and
// number, "curve_3".

struct GivenName {
  std::string name;
  std::vector<int> targets;  ///< numbers of the entities that get the name
  bool is_for_rest = false;  ///< the name is for those of the targets that no other entry names
  std::string where{};       ///< the file and the entry, for messages
};

/// Sets names[target] for all of `given`. Throws FormatError, naming both entries, if two entries name the same `kind`
/// ("curve") or if two are for the rest of it. Returns the numbers of the named entities, ascending.
std::vector<int> assign_names(std::vector<std::string>& names, const std::vector<GivenName>& given,
                              const std::string& kind);

/// Replaces empty names by "<kind>_<number>", followed by as many "_" as are necessary to differ from all given names.
/// Returns the numbers of the names that it replaced, ascending.
std::vector<int> replace_empty_names(std::vector<std::string>& names, const std::string& kind);

/// The numbers of the names that replace_empty_names may have made, ascending: for files that do not state whether a
/// name was given.
std::vector<int> presumed_numbered_names(const std::vector<std::string>& names, const std::string& kind);

}  // namespace quadrille
