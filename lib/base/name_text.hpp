#pragma once
// Names as other programs and people give them -> names as our files hold them: valid UTF-8, one line, trimmed.

#include <string>
#include <string_view>

namespace quadrille {

/// The length in bytes of the UTF-8 character at the start of `text`; 0 where there is none (Unicode 15, table 3-7).
int utf8_length(std::string_view text);

bool is_utf8(std::string_view text);

/// `text` itself where it is UTF-8; else every byte taken as a character of Latin 1, which never fails.
std::string utf8_or_latin1(const std::string& text);

/// Control characters become blanks, bytes that are no UTF-8 become U+FFFD, blanks at both ends go.
std::string clean_name(std::string_view text);

}  // namespace quadrille
