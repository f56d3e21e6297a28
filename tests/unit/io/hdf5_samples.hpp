#pragma once
// A small HDF5 file.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "io/hdf5_file.hpp"

namespace quadrille::io {

inline std::string image_of(const std::function<void(const Hdf5GroupWriter&)>& fill) {
  Hdf5Writer writer;
  fill(writer.root());
  return writer.image();
}

/// What a reader says to a part of a file; empty if it takes it.
inline std::string refusal(const std::string& image, const std::function<void(const Hdf5GroupReader&)>& part) {
  return message_of<FormatError>([&] {
    const Hdf5Reader reader(image, "sample.h5");
    part(reader.root());
  });
}

inline const std::string sample = image_of([](const Hdf5GroupWriter& root) {
  const std::vector<int> numbers{1, -2, 3, 4, 5, 6};
  const std::vector<double> reals{0.1, -1e300, std::numeric_limits<double>::infinity(), 4};
  root.text_attribute("format", "sample");
  root.integer_attribute("version", {1, 2});
  root.integers("one", numbers.data(), {}, "1", "a number");
  root.integers("list", numbers.data(), {6}, "", "");
  root.integers("table", numbers.data(), {2, 3}, "", "");
  root.reals("reals", reals.data(), {2, 2}, "length", "");
  root.texts("words",
             {"",
              "Stra\xc3\x9f"
              "e",
              "two words"},
             false, "", "");
  root.group("inner").texts("name", {"deep"}, true, "", "");
});

}  // namespace quadrille::io
