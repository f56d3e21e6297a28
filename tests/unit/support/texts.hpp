#pragma once
// Texts in tests: the message of an error that a test provokes, and the parts of a text.

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace quadrille {

/// What `act` throws as an Error, in words; empty if it throws nothing.
template <typename Error, typename Act>
std::string message_of(const Act& act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// The number of times that `part` occurs in `text`, without overlaps.
inline int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++n;
  return n;
}

/// Each pair holds a part of `text` and the number of times that it must occur.
inline void expect_counts(const std::string& text, const std::vector<std::pair<std::string, int>>& parts) {
  for (const auto& [part, number] : parts) EXPECT_EQ(count(text, part), number) << part;
}

inline void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace quadrille
