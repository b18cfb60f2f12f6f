#include "cli/describe_shares.hpp"

#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "gradation/number_gradation.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm::cli {

bool is_number_file(const std::string &path) {
  constexpr std::size_t header = std::size_t{1} << 16;
  return is_number_gradation(beginning_of_file(path, header));
}

ClassShares shares_of_mass(const std::string &path) {
  return in_file(path, [&path] {
    return class_shares(read_number_gradation(read_file(path, max_gradation_bytes), shown_name(path)),
                        ShareOf::number);
  });
}

void describe_shares(const ClassShares &shares, const OutputFlags &output, std::optional<unsigned> digits) {
  const unsigned exchanged = digits.value_or(15), read = digits.value_or(4);
  write_output(output.path(), output.report([&] { return shares_text(shares, read); },
                                            [&] { return shares_json(shares, exchanged); },
                                            [&] { return shares_csv(shares, exchanged); }));
  output.tell_notes_beside_csv(shares.gradation.notes());
}

} // namespace mdm::cli
