#include "cli/whole_number.hpp"

#include "number/typed_number.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm::cli {

CLI::Validator whole_number(unsigned least, unsigned most) {
  const auto read = [least, most](std::string &text) {
    const std::optional<Integer> n = parse_typed_natural(text);
    if (!n || *n < least || *n > most)
      return fmt::format("{} is not a whole number from {} to {}", in_quotes(text), least, most);
    text = to_string(*n);
    return std::string();
  };
  return {read, fmt::format("INT in [{} - {}]", least, most)};
}

} // namespace mdm::cli
