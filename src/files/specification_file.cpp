#include "files/specification_file.hpp"

#include "ask/option_values.hpp"
#include "files/byte_source.hpp"
#include "files/paths.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

namespace mdm {

Specification specification_at(const std::string &name) {
  if (std::optional<Specification> s = shipped_specification(name))
    return *std::move(s);
  try {
    return read_specification(read_file(name, max_gradation_bytes), shown_name(name));
  } catch (const InputError &e) {
    if (file_bytes(name) || name == "-")
      throw;
    throw InputError(fmt::format("{}: {}; specifications that come with mdm: {}", option("spec"), e.what(),
                                 fmt::join(shipped_specifications(), ", ")));
  }
}

std::string specification_help() {
  return fmt::format(
      "limits of the percent that passes: a table with passing_min_percent,passing_max_percent or "
      "columns such as Lower and Upper, or one of {}",
      fmt::join(shipped_specifications(), ", "));
}

std::optional<Rational> rounding_of(const std::optional<std::string> &text) {
  if (!text)
    return std::nullopt;
  return *text == "none" ? Rational(0) : percent_of("rounding", *text);
}

std::string rounding_help() {
  return "one unit of the last digit of all percents, as 0.1, or none (as the report prints its percents; "
         "masses are exact)";
}

} // namespace mdm
