#include "cli/stage_words.hpp"

namespace quadrille::cli {

std::vector<OptionName> option_names(const Declare& declare) {
  CommandLine line({});
  declare(line);
  return line.option_names();
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
