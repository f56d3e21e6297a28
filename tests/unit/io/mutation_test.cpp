// Readers against damaged files: whatever the bytes, a reader succeeds or throws FormatError.

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "../chart_samples.hpp"
#include "../region_samples.hpp"
#include "base/error.hpp"
#include "io/digest.hpp"
#include "io/stage_files.hpp"
#include "scratch.hpp"

namespace quadrille::io {
namespace {

struct Format {
  std::string name;
  bool is_hdf5;
  std::function<void(const std::string&)> write;
  std::function<void(const InputFile&)> read;
};

template <typename Model>
Format format_of_sample(Model (*sample)()) {
  const StageFormat& format = format_of<Model>();
  return {format.name, format.storage == Storage::hdf5,
          [sample](const std::string& path) { write_stage(path, sample()); }, read_stage<Model>};
}

const std::vector<Format>& formats() {
  static const std::vector<Format> all{format_of_sample(samples::tri_mesh),
                                       format_of_sample(samples::field),
                                       format_of_sample(samples::critical_points),
                                       format_of_sample(samples::resolved_points),
                                       format_of_sample(samples::phase_field),
                                       format_of_sample(samples::separatrix_graph),
                                       format_of_sample(samples::block_layout),
                                       format_of_sample(samples::quad_mesh),
                                       format_of_sample(samples::two_regions_mesh),
                                       format_of_sample(samples::two_regions_phase_field),
                                       format_of_sample(samples::two_regions_points),
                                       format_of_sample(samples::charted_face),
                                       format_of_sample(samples::hex_mesh)};
  return all;
}

/// The message of the FormatError that reading `bytes` raises; empty when it succeeds. Anything else fails the test.
std::string refusal(const Format& format, const std::string& bytes) {
  try {
    format.read({{"file", ""}, bytes});
    return {};
  } catch (const FormatError& e) {
    EXPECT_EQ(std::string(e.what()).substr(0, 4), "file") << e.what();
    return e.what();
  }
}

class Damaged : public Scratch {
 protected:
  std::string sample(const Format& format) const {
    format.write(path("sample"));
    return bytes_of("sample");
  }
};

TEST_F(Damaged, TruncatedAnywhere) {
  for (const Format& format : formats()) {
    const std::string bytes = sample(format);
    EXPECT_EQ(refusal(format, bytes), "");
    for (int i = 0; i < 40; ++i) {
      const std::size_t size = bytes.size() * static_cast<std::size_t>(i) / 40;
      EXPECT_NE(refusal(format, bytes.substr(0, size)), "") << format.name << " cut to " << size;
    }
  }
}

TEST_F(Damaged, RandomGarbage) {
  std::mt19937 random(1);
  for (const Format& format : formats())
    for (int i = 0; i < 20; ++i) {
      std::string bytes(1 + random() % 5000, '\0');
      for (char& c : bytes) c = static_cast<char>(random());
      EXPECT_NE(refusal(format, bytes), "");
      EXPECT_NE(refusal(format, "\x89HDF\r\n\x1a\n" + bytes), "");
      EXPECT_NE(refusal(format, "{" + bytes), "");
    }
}

TEST_F(Damaged, EveryFlippedBitOfAnHdf5FileIsSeen) {
  std::mt19937 random(2);
  for (const Format& format : formats()) {
    if (!format.is_hdf5) continue;
    const std::string bytes = sample(format);
    for (int i = 0; i < 300; ++i) {
      std::string damaged = bytes;
      damaged[random() % bytes.size()] ^= static_cast<char>(1 << random() % 8);
      EXPECT_NE(refusal(format, damaged), "") << format.name;
    }
  }
}

#ifdef QUADRILLE_SANITIZE
constexpr int num_unsealed = 40;  // the copy of a process with sanitizers takes a quarter of a second
#else
constexpr int num_unsealed = 150;
#endif

/// Without the checksum the bytes reach libhdf5, in a child process first.
TEST_F(Damaged, UnsealedHdf5FilesNeverCrashTheReader) {
  std::mt19937 random(3);
  for (const Format& format : formats()) {
    if (!format.is_hdf5) continue;
    const std::string sealed = sample(format);
    std::string_view image;
    ASSERT_EQ(verify_checksum(sealed, image), Checksum::right);
    const std::string bytes(image);
    EXPECT_EQ(refusal(format, bytes), "") << "a foreign writer's file has no checksum";
    for (int i = 0; i < num_unsealed; ++i) {
      std::string damaged = bytes;
      for (int k = 0; k < 3; ++k) damaged[random() % (i % 2 ? 2048 : bytes.size())] = static_cast<char>(random());
      refusal(format, damaged);
    }
  }
}

TEST_F(Damaged, MutatedJsonIsReadOrRefused) {
  std::mt19937 random(4);
  const std::string alphabet = R"({}[]",:0123456789.eE+-truefalsn\ )";
  for (const Format& format : formats()) {
    if (format.is_hdf5) continue;
    const std::string bytes = sample(format);
    int num_refused = 0;
    for (int i = 0; i < 500; ++i) {
      std::string damaged = bytes;
      for (unsigned k = 0; k <= random() % 3; ++k)
        damaged[random() % bytes.size()] = i % 4 ? alphabet[random() % alphabet.size()] : static_cast<char>(random());
      num_refused += !refusal(format, damaged).empty();
    }
    EXPECT_GT(num_refused, 250) << format.name;
  }
}

TEST_F(Damaged, JsonOfBracketsOnlyDoesNotUseUpTheStack) {
  const std::string brackets(2000000, '[');
  for (const Format& format : formats()) {
    EXPECT_NE(refusal(format, brackets), "");
    EXPECT_NE(refusal(format, R"({"provenance":[{"options":)" + brackets), "");
  }
}

TEST_F(Damaged, OtherMajorVersionsGetTwoDifferentSentences) {
  for (const Format& format : formats()) {
    if (format.is_hdf5) continue;
    const std::string bytes = sample(format);
    const auto with_version = [&](const std::string& version) {
      std::string changed = bytes;
      return refusal(format, changed.replace(changed.find("[2, "), 6, version));
    };
    EXPECT_NE(with_version("[3, 0]").find("is newer than this program"), std::string::npos);
    EXPECT_NE(with_version("[1, 9]").find("is from an older program"), std::string::npos);
    EXPECT_EQ(with_version("[2, 7]"), "");
    EXPECT_NE(with_version("[1]").find("'version' must be [major, minor]"), std::string::npos);
    EXPECT_NE(with_version("\"1.0\"").find("'version' must be an array"), std::string::npos);
  }
}

TEST_F(Damaged, AProvenanceThatNoFileCanHoldIsRefused) {
  const Format& format = formats()[2];
  std::string bytes = sample(format);
  const std::size_t at = bytes.find("\"tool\": \"");
  ASSERT_NE(at, std::string::npos);
  bytes.insert(at + 9, std::string(70000, 'x'));
  EXPECT_EQ(refusal(format, bytes), "file: 'provenance' is longer than 60000 characters, which no stage file can hold");
}

TEST_F(Damaged, AnotherFormatIsNamed) {
  for (const Format& written : formats())
    for (const Format& wanted : formats()) {
      if (written.name == wanted.name) continue;
      const std::string message = refusal(wanted, sample(written));
      EXPECT_NE(message, "");
      if (written.is_hdf5 != wanted.is_hdf5) continue;
      EXPECT_EQ(message, "file: expected a " + wanted.name + " file, found a " + written.name + " file");
    }
}

TEST_F(Damaged, MissingAndMistypedMembersAreNamed) {
  const Format& format = formats()[2];
  const std::string bytes = sample(format);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = bytes;
    return refusal(format, changed.replace(changed.find(from), from.size(), to));
  };
  EXPECT_EQ(with("\"corners\"", "\"cornerz\""), "file: 'corners' is missing");
  EXPECT_EQ(with("\"critical-points\"", "\"a\\nb\""), "file: expected a critical-points file, found a a b file");
  EXPECT_EQ(with("\"valence\": 3", "\"valence\": 3.5"), "file: 'critical_points[0].valence' must be an integer");
  EXPECT_EQ(with("\"valence\": 3", "\"valence\": 3e99"), "file: 'critical_points[0].valence' must be an integer");
  EXPECT_EQ(with("\"valence\": 3", "\"valence\": 3000000000"),
            "file: 'critical_points[0].valence' is an integer out of range");
  EXPECT_EQ(with("\"position\": [0.25, 0.5]", "\"position\": [0.25]"),
            "file: 'critical_points[0].position' must be an array of 2 numbers");
}

/// JSON members are cut by their key's name; the first place where `name` stands is the one.
TEST_F(Damaged, RequiredMembersOfCriticalPointsAreMissed) {
  const Format format = format_of_sample(samples::resolved_points);
  const std::string bytes = sample(format);
  const auto without = [&](const std::string& name) {
    std::string changed = bytes;
    const std::size_t at = changed.find('"' + name + "\":");
    EXPECT_NE(at, std::string::npos) << name;
    return refusal(format, changed.replace(at + 1, name.size(), name + "?"));
  };
  EXPECT_EQ(without("origin"), "file: 'origin' is missing");
  EXPECT_EQ(without("critical_points"), "file: 'critical_points' is missing");
  EXPECT_EQ(without("position"), "file: 'critical_points[0].position' is missing");
  EXPECT_EQ(without("valence"), "file: 'critical_points[0].valence' is missing");
  EXPECT_EQ(without("corners"), "file: 'corners' is missing");
  EXPECT_EQ(without("joint"), "file: 'corners[0].joint' is missing");
  EXPECT_EQ(without("angle_degrees"), "file: 'corners[0].angle_degrees' is missing");
  EXPECT_EQ(without("curve"), "file: 'boundary_nodes[0].curve' is missing");
  EXPECT_EQ(without("index_sum"), "file: 'index_sum' is missing");
  EXPECT_EQ(without("expected"), "file: 'index_sum.expected' is missing");
  EXPECT_EQ(without("reason"), "file: 'changes[0].reason' is missing");
  EXPECT_EQ(without("where"), "file: 'changes[0].before[0].where' is missing");
  EXPECT_EQ(without("radius"), "file: 'clusters[0].radius' is missing");
  EXPECT_EQ(without("disc_radii"), "file: 'certificate.disc_radii' is missing");
  EXPECT_EQ(without("verdict"), "file: 'certificate.cells[0].verdict' is missing");
  for (const char* optional :
       {"form", "id", "index", "elem", "xi", "jacobian", "error", "source", "boundary_nodes", "hole_winding_offsets",
        "value", "changes", "clusters", "zeros", "certificate", "degenerate"})
    EXPECT_EQ(without(optional), "") << optional;
}

/// May be missing, but must be what the page says where they are there.
TEST_F(Damaged, MistypedOptionalMembersOfCriticalPointsAreNamed) {
  const Format format = format_of_sample(samples::resolved_points);
  const std::string bytes = sample(format);
  const auto with = [&](const std::string& from, const std::string& to) {
    std::string changed = bytes;
    const std::size_t at = changed.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return refusal(format, changed.replace(at, from.size(), to));
  };
  EXPECT_EQ(with("\"form\": \"phase\"", "\"form\": 2"), "file: 'form' must be a string");
  EXPECT_EQ(with("\"index\": 1", "\"index\": \"1\""), "file: 'critical_points[0].index' must be an integer");
  EXPECT_EQ(with("\"elem\": 3", "\"elem\": 3.5"), "file: 'critical_points[0].elem' must be an integer");
  EXPECT_EQ(with("\"xi\": [", "\"xi\": [1, "), "file: 'critical_points[0].xi' must be an array of 2 numbers");
  EXPECT_EQ(with("\"jacobian\": [", "\"jacobian\": [1, "),
            "file: 'critical_points[0].jacobian' must be an array of 4 numbers");
  EXPECT_EQ(with("\"error\": ", "\"error\": -"), "") << "of the right type, but CRT-R11 refuses it";
  EXPECT_EQ(with("\"error\": ", "\"error\": true, \"was\": "), "file: 'critical_points[0].error' must be a number");
  EXPECT_EQ(with("\"hole_winding_offsets\": [", "\"hole_winding_offsets\": [0.5"),
            "file: 'hole_winding_offsets' must be an integer");
  EXPECT_EQ(with("\"value\": 4", "\"value\": 4.5"), "file: 'index_sum.value' must be an integer");
  EXPECT_EQ(with("\"verdict\": \"zero\"", "\"verdict\": \"maybe\""),
            "file: 'certificate.cells[0].verdict' must be zero or open, not 'maybe' (CRT-R15)");
  EXPECT_EQ(with("\"verdict\": \"zero\"", "\"verdict\": \"a\\n\\u001b[2Jb\""),
            "file: 'certificate.cells[0].verdict' must be zero or open, not 'a  [2Jb' (CRT-R15)")
      << "control characters stay out of messages";
  EXPECT_EQ(with("\"certificate\": {", "\"certificate\": 1, \"was\": {"), "file: 'certificate' must be an object");
}

TEST_F(Damaged, ValencesOfAnySizeAreReadAndRefusedLater) {
  const Format& format = formats()[2];
  std::string bytes = sample(format);
  bytes.replace(bytes.find("\"index\": 1,"), 11, "");
  bytes.replace(bytes.find("\"value\""), 7, "\"other\"");
  for (const char* valence : {"-2147483648", "2147483647"}) {
    std::string changed = bytes;
    changed.replace(changed.find("\"valence\": 3"), 12, std::string("\"valence\": ") + valence);
    EXPECT_EQ(refusal(format, changed), "") << valence;
  }
}

}  // namespace
}  // namespace quadrille::io
