#include "answer/shard.hpp"

#include "number/typed_number.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

Shard parse_shard(const std::string &text) {
  const Integer most = 1'000'000'000;
  const std::size_t slash = text.find('/');
  if (slash != std::string::npos) {
    const std::optional<Integer> number = parse_typed_natural(text.substr(0, slash)),
                                 count = parse_typed_natural(text.substr(slash + 1));
    if (number && count && *number >= 1 && *number <= *count && *count <= most)
      return {static_cast<std::uint64_t>(*number), static_cast<std::uint64_t>(*count)};
  }
  throw InputError(in_quotes(text) + " is not I/N with I from 1 to N, such as 7/100");
}

} // namespace mdm
