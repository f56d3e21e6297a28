#pragma once
// A stage file of the chain: a struct in memory, a file, or both.

#include <optional>
#include <string>
#include <utility>

#include "io/stage_files.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::chain {

template <typename Model>
class StageFile {
 public:
  /// `path`: where the file is, or would be.
  explicit StageFile(std::string path) : path_(std::move(path)) {}

  const std::string& path() const { return path_; }
  /// The struct with the name and digest of its file; read from there if it is not in memory. Throws FormatError.
  stage::Input<Model> input() {
    if (!model_) read(io::read_input(path_));
    return {*model_, {name(), sha256_}};
  }
  const Model& model() { return input().model; }

  const std::string& name() const { return name_.empty() ? path_ : name_; }  ///< for messages
  /// The struct, which is then no longer kept.
  Model release() {
    if (!model_) read(io::read_input(path_));
    Model model = std::move(*model_);
    model_.reset();
    return model;
  }
  /// Keeps the struct. With `is_written`, its file is written and so its digest known. Throws OutputError.
  void set(Model model, bool is_written) {
    model_ = std::move(model);
    sha256_.clear();
    if (is_written) write();
  }
  /// Writes the file, if it is not there.
  void write() {
    if (!model_ || !sha256_.empty()) return;
    const std::string bytes = io::stage_bytes(*model_);
    io::write_stage_bytes(path_, bytes, io::Lasting::for_the_run);  // the same command makes it again
    sha256_ = io::identity_of(path_, bytes).sha256;
  }
  /// The file was written by another program: the struct is read when it is needed.
  void forget() {
    model_.reset();
    sha256_.clear();
  }
  /// Reads the struct from the bytes of another file.
  void read(const io::InputFile& file) {
    model_ = io::read_stage<Model>(file);
    sha256_ = file.sha256;
    name_ = file.name;
  }
  /// Takes the struct of another file, which is then empty; the file itself is not touched.
  void take(StageFile& other) {
    model_ = std::exchange(other.model_, std::nullopt);
    sha256_ = std::exchange(other.sha256_, {});
    name_.clear();
  }
  bool is_in_memory() const { return model_.has_value(); }

 private:
  std::string path_;
  std::string name_;  ///< of the file that it was read from, if that is another one
  std::optional<Model> model_;
  std::string sha256_;  ///< empty: there is no file, as far as is known
};

}  // namespace quadrille::chain
