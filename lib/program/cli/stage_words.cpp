#include "cli/stage_words.hpp"

#include "cli/command_line.hpp"

namespace quadrille::cli {

namespace {

/// Keeps the names alone.
class NameList : public Options {
 public:
  void number(const std::string& flag, double&, double, double, const std::string&, const std::string&) override {
    add(flag);
  }
  void optional_number(const std::string& flag, std::optional<double>&, double, double, const std::string&,
                       const std::string&) override {
    add(flag);
  }
  void integer(const std::string& flag, int&, int, int, const std::string&) override { add(flag); }
  void text(const std::string& flag, std::string&, const std::string&, const std::string&, bool) override { add(flag); }
  void texts(const std::string& flag, std::vector<std::string>&, const std::string&, const std::string&,
             bool) override {
    add(flag);
  }
  void flag(const std::string& flag, bool&, const std::string&) override { names_.push_back({flag, false}); }
  void one_of(const std::string& flag, const std::vector<std::string>&, const std::function<std::string()>&,
              const std::function<void(const std::string&)>&, const std::string&) override {
    add(flag);
  }
  const std::vector<OptionName>& names() const { return names_; }

 private:
  void add(const std::string& flag) { names_.push_back({flag, true}); }
  std::vector<OptionName> names_;
};

}  // namespace

std::vector<OptionName> option_names(const Declare& declare) {
  NameList list;
  declare(list);
  return list.names();
}

void add_files(const Declare& declare, RunFiles& files) {
  CommandLine line({});
  declare(line);
  line.add_files(files);
}

std::string option_rows(const Declare& declare) {
  CommandLine line({});
  declare(line);
  return help_rows(line.page().options);
}

void set_options(const Declare& declare, const std::vector<std::string>& words) {
  CommandLine line({});
  declare(line);
  std::vector<std::string> texts{"stage"};
  texts.insert(texts.end(), words.begin(), words.end());
  std::vector<char*> argv;
  for (std::string& text : texts) argv.push_back(text.data());
  line.parse(static_cast<int>(argv.size()), argv.data());
}

}  // namespace quadrille::cli
