#include "io/stage_files.hpp"

namespace quadrille::io {

namespace {

/// The reader of the alternative `I` or of a later one, whichever has the format.
template <std::size_t I = 0>
StageModel read_alternative(const InputFile& file, const std::string& format) {
  if constexpr (I + 1 < stage_formats.size())
    if (format != stage_formats[I].name) return read_alternative<I + 1>(file, format);
  return read_stage<std::variant_alternative_t<I, StageModel>>(file);
}

}  // namespace

StageModel read_any_stage(const InputFile& file) { return read_alternative(file, stage_format(file)); }

}  // namespace quadrille::io
