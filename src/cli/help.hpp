#pragma once
/// \file
/// The text of --help.

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace mdm::cli {

/// CLI11's help in lines of at most 100 columns, as far as single words allow.
class HelpFormatter : public CLI::Formatter {
public:
  std::string make_description(const CLI::App *app) const override;
  std::string make_option(const CLI::Option *option, bool is_positional) const override;
  std::string make_help(const CLI::App *app, std::string name, CLI::AppFormatMode mode) const override;
  std::string make_subcommand(const CLI::App *sub) const override;
};

/// The heading of the options that are added while it is there.
class OptionGroup {
public:
  OptionGroup(CLI::App &command, const std::string &heading);
  ~OptionGroup();
  OptionGroup(const OptionGroup &) = delete;
  OptionGroup &operator=(const OptionGroup &) = delete;

private:
  CLI::App &command_;
  std::string before_;
};

/// A paragraph for the end of a help, in lines of at most 100 columns.
std::string paragraph(const std::string &text);

/// The end of a help: `about`, which may be empty, and the examples, a line each.
std::string footer(const std::string &about, const std::vector<std::string> &examples);

/// `app`'s help, or that of `command` if it is another.
std::string help_text(const CLI::App &app, const CLI::App &command);

} // namespace mdm::cli
