#include "cli/reading_flags.hpp"

#include "cli/help.hpp"

namespace mdm::cli {

std::vector<CLI::Option *> ReadingFlags::add_to(CLI::App &command) {
  const OptionGroup group(command, "Reading the gradation");
  std::vector<CLI::Option *> added;
  for (const OptionRow<ReadingTexts> &row : options) {
    const std::string name = std::string("--") + row.name;
    if (command.get_option_no_throw(name) == nullptr)
      added.push_back(command.add_option(name, this->*row.text(), row.help)->type_name(row.values));
  }
  return added;
}

} // namespace mdm::cli
