#include "io/renamed_keys.hpp"

#include <cstdlib>

namespace quadrille::io {

namespace {

/// Forwards every call to another archive, with the former names of members.
class FormerNames : public Archive {
 public:
  FormerNames(Archive& inner, std::span<const RenamedKey> renamed, std::string path)
      : inner_(inner), renamed_(renamed), path_(std::move(path)) {}

  bool is_reading() const override { return inner_.is_reading(); }
  bool has(const char* name) const override { return inner_.has(former(name)); }
  [[noreturn]] void fail(const char* name, const std::string& problem) const override {
    inner_.fail(former(name), problem);
    std::abort();  // not reached: the compiler cannot see that
  }
  void integers(const char* name, int* values, std::size_t count, Doc doc) override {
    inner_.integers(former(name), values, count, doc);
  }
  void reals(const char* name, double* values, std::size_t count, Doc doc) override {
    inner_.reals(former(name), values, count, doc);
  }
  void text(const char* name, std::string& value, Doc doc) override { inner_.text(former(name), value, doc); }
  void json(const char* name, std::string& value, Doc doc) override { inner_.json(former(name), value, doc); }
  void flag(const char* name, bool& value, Doc doc) override { inner_.flag(former(name), value, doc); }
  void integer_list(const char* name, std::vector<int>& flat, std::size_t width, Doc doc) override {
    inner_.integer_list(former(name), flat, width, doc);
  }
  void real_list(const char* name, std::vector<double>& flat, std::size_t width, Doc doc) override {
    inner_.real_list(former(name), flat, width, doc);
  }
  void text_list(const char* name, std::vector<std::string>& values, Doc doc) override {
    inner_.text_list(former(name), values, doc);
  }
  void object(const char* name, const std::function<void(Archive&)>& describe) override {
    inner_.object(former(name), [&](Archive& archive) {
      FormerNames members(archive, renamed_, path_ + name + '.');
      describe(members);
    });
  }
  void records(const char* name, std::size_t count, const std::function<void(std::size_t)>& resize,
               const Each& each) override {
    inner_.records(former(name), count, resize, [&](Archive& archive, std::size_t i) {
      FormerNames members(archive, renamed_, path_ + name + '.');
      each(members, i);
    });
  }

 private:
  const char* former(const char* name) const {
    const std::string key = path_ + name;
    for (const RenamedKey& renamed : renamed_)
      if (renamed.key == key) return renamed.former;
    return name;
  }

  Archive& inner_;
  std::span<const RenamedKey> renamed_;
  std::string path_;
};

}  // namespace

void describe_with_former_names(Archive& archive, std::span<const RenamedKey> renamed,
                                const std::function<void(Archive&)>& describe) {
  FormerNames former(archive, renamed, "");
  describe(former);
}

}  // namespace quadrille::io
