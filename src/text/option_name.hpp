#pragma once
/// \file
/// The options of a question, as the user's front end spells them.

#include <string>
#include <string_view>

namespace mdm {

/// How a front end writes the option `contact-gap`.
enum class OptionSpelling {
  program, ///< `--contact-gap`, of the command line
  keyword, ///< `contact_gap`, of Python
  member   ///< `contactGap`, of JavaScript
};

/// Chooses the spelling for all messages of this process; without it they have that of the program. Call it
/// once, before anything is read.
void spell_options(OptionSpelling spelling);

/// An option in a message: option("contact-gap") is `--contact-gap`, or what was chosen.
/// \param name as the command line has it, without hyphens before it
std::string option(std::string_view name);
/// The same in a spelling that need not be the chosen one.
std::string option(std::string_view name, OptionSpelling spelling);

} // namespace mdm
