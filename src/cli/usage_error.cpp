#include "cli/usage_error.hpp"

#include "text/nearest_name.hpp"
#include "text/short_list.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <cassert>
#include <string_view>
#include <utility>

namespace mdm::cli {
namespace {

/// `text` with what stands between the first `before` and the last `after`, the user's, in quotes, and
/// `words` in place of `after`. \pre both are there
std::string quoted_between(const std::string &text, std::string_view before, std::string_view after,
                           std::string_view words) {
  const std::size_t option_end = text.find(before);
  const std::size_t begin = option_end + before.size();
  const std::size_t end = text.rfind(after);
  assert(option_end != std::string::npos && end != std::string::npos);
  return text.substr(0, option_end) + ": " + in_quotes(text.substr(begin, end - begin)) + std::string(words) +
         text.substr(end + after.size());
}

/// The options of the command that was given, or else of the program.
std::vector<std::string> option_names(const CLI::App &app) {
  const std::vector<CLI::App *> commands = app.get_subcommands();
  std::vector<std::string> names;
  for (const CLI::Option *option : (commands.empty() ? app : *commands.front()).get_options())
    for (const std::string &name : option->get_lnames())
      names.push_back("--" + name);
  return names;
}

/// What to do with one file more than a command takes.
std::string one_at_a_time(const std::string &argument, const CLI::App &app) {
  const std::vector<CLI::App *> commands = app.get_subcommands();
  if (commands.empty() || argument.starts_with('-'))
    return "";
  const std::vector<const CLI::Option *> all = std::as_const(*commands.front()).get_options();
  const auto is_file = [](const CLI::Option *o) { return o->get_positional() && o->count() > 0; };
  const auto files = std::count_if(all.begin(), all.end(), is_file);
  if (files == 0)
    return "";
  return ": mdm " + commands.front()->get_name() +
         (files == 1 ? " takes one file" : " takes one file of each kind") +
         " at a time (mdm batch solves many)";
}

} // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string> &names) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string_view meant = nearest_name(word, views);
  return meant.empty() ? "" : " (did you mean " + std::string(meant) + "?)";
}

std::string usage_error(const CLI::ParseError &error, const CLI::App &app) {
  // CLI11 looks for missing arguments before it looks at those that it does not know.
  const std::vector<std::string> unknown = app.remaining(true);
  if (!unknown.empty()) {
    ShortList list;
    for (const std::string &argument : unknown)
      list.add(argument);
    const std::string option = unknown.front().substr(0, unknown.front().find('='));
    const std::vector<std::string> known = option_names(app);
    if (std::find(known.begin(), known.end(), option) != known.end())
      return in_quotes(option) + " stands before the command: write it behind that";
    return list.text() + (list.size() == 1 ? " was" : " were") + " not expected" +
           (unknown.front().starts_with("--") ? did_you_mean(option, known)
                                              : one_at_a_time(unknown.front(), app));
  }
  const std::string text = error.what();
  constexpr std::string_view unconverted = "Could not convert: ";
  if (text.starts_with(unconverted))
    return quoted_between(text.substr(unconverted.size()), " = ", "", " does not serve");
  constexpr std::string_view twice = ": At Most 1 required but received ";
  if (const std::size_t at = text.find(twice); at != std::string::npos)
    return printable(text.substr(0, at)) + ": given " + text.substr(at + twice.size()) +
           " times: give it once";
  if (text.ends_with('}') && text.find(" not in {") != std::string::npos)
    return quoted_between(text, ": ", " not in ", " is not in ");
  return printable(text);
}

} // namespace mdm::cli
