#include "text/option_name.hpp"

#include <algorithm>
#include <atomic>

namespace mdm {
namespace {

std::atomic<OptionSpelling> chosen = OptionSpelling::program;

std::string member_name(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i)
    if (name[i] == '-' && i + 1 < name.size())
      text += static_cast<char>(name[++i] - 'a' + 'A');
    else
      text += name[i];
  return text;
}

} // namespace

void spell_options(OptionSpelling spelling) {
  chosen = spelling;
}

std::string option(std::string_view name) {
  return option(name, chosen.load());
}

std::string option(std::string_view name, OptionSpelling spelling) {
  std::string text(name);
  switch (spelling) {
  case OptionSpelling::keyword:
    if (text == "from") // a word of the language itself
      return "from_format";
    std::replace(text.begin(), text.end(), '-', '_');
    return text;
  case OptionSpelling::member:
    return member_name(name);
  default:
    return "--" + text;
  }
}

} // namespace mdm
