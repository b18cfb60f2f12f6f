#include "cli/help.hpp"

#include <sstream>

namespace mdm::cli {
namespace {

constexpr std::size_t columns = 100;
constexpr std::size_t name_columns = 30;

/// The words of `text` behind what the line has already, `indent` spaces before further lines.
std::string wrapped(std::string line, const std::string &text, std::size_t indent) {
  std::string lines, word;
  std::istringstream words(text);
  bool begins = true; // no space before the word
  while (words >> word) {
    if (!begins && line.size() + 1 + word.size() > columns) {
      lines += line + '\n';
      line = std::string(indent, ' ');
      begins = true;
    }
    line += (begins ? "" : " ") + word;
    begins = false;
  }
  return lines + line + '\n';
}

/// A name and its description beside it, or below it where the name is too long.
std::string entry(const std::string &name, const std::string &description) {
  std::string line = "  " + name;
  std::string above;
  if (line.size() + 1 > name_columns) {
    above = line + '\n';
    line.clear();
  }
  line.resize(name_columns, ' ');
  return above + wrapped(line, description, name_columns);
}

} // namespace

std::string HelpFormatter::make_description(const CLI::App *app) const {
  return wrapped("", app->get_description(), 0);
}

std::string HelpFormatter::make_option(const CLI::Option *option, bool is_positional) const {
  std::string name = make_option_name(option, is_positional) + make_option_opts(option);
  constexpr std::string_view dots = " ..."; // of options that may be repeated; a value each
  if (!option->get_allow_extra_args() && name.ends_with(dots))
    name.resize(name.size() - dots.size());
  return entry(name, make_option_desc(option));
}

std::string HelpFormatter::make_help(const CLI::App *app, std::string name, CLI::AppFormatMode mode) const {
  std::string text = Formatter::make_help(app, std::move(name), mode);
  for (std::size_t i = text.find("\n\n\n"); i != std::string::npos; i = text.find("\n\n\n", i))
    text.erase(i, 1);
  return text;
}

std::string HelpFormatter::make_subcommand(const CLI::App *sub) const {
  return entry(sub->get_name(), sub->get_description());
}

OptionGroup::OptionGroup(CLI::App &command, const std::string &heading)
    : command_(command), before_(command.option_defaults()->get_group()) {
  command_.option_defaults()->group(heading);
}

OptionGroup::~OptionGroup() {
  command_.option_defaults()->group(before_);
}

std::string paragraph(const std::string &text) {
  return wrapped("", text, 0);
}

std::string footer(const std::string &about, const std::vector<std::string> &examples) {
  std::string text = about.empty() ? "" : about + "\n";
  text += examples.size() == 1 ? "Example:" : "Examples:";
  for (const std::string &example : examples)
    text += "\n  " + example;
  return text;
}

std::string help_text(const CLI::App &app, const CLI::App &command) {
  const std::string text = &command == &app ? app.help() : command.help(app.get_name());
  return text.substr(text.find_first_not_of('\n')) + "\n";
}

} // namespace mdm::cli
