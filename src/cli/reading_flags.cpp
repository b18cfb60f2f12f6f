#include "cli/reading_flags.hpp"

#include "cli/help.hpp"
#include "files/paths.hpp"

namespace mdm::cli {

std::vector<CLI::Option *> ReadingFlags::add_to(CLI::App &command) {
  const OptionGroup group(command, "Reading the gradation");
  std::vector<CLI::Option *> added;
  for (const OptionRow<ReadingTexts> &row : options) {
    const std::string name = std::string("--") + row.name;
    if (command.get_option_no_throw(name) == nullptr)
      added.push_back(command.add_option(name, this->*row.text, row.help)->type_name(row.values));
  }
  return added;
}

std::string ReadingFlags::given() const {
  const std::string all = words();
  return all.empty() ? all : all.substr(1, all.find(' ', 1) - 1);
}

bool ReadingFlags::is_unit_at_most() const {
  ReadingFlags others = *this;
  others.unit.reset();
  return !others.is_given();
}

std::string ReadingFlags::words() const {
  std::string text;
  for (const OptionRow<ReadingTexts> &row : options)
    if (const OptionText &value = this->*row.text)
      text += std::string(" --") + row.name + " " + shell_word(*value);
  return text;
}

} // namespace mdm::cli
