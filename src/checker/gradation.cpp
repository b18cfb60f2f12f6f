#include "gradation.hpp"

#include <algorithm>

namespace mdm_check {

Gradation read_gradation(std::string_view text) {
  if (text.size() > std::size_t{64} << 20U)
    throw Malformed(1, "more than 64 MiB: no gradation is that long");
  demand_text(text);
  if (text.starts_with("\xEF\xBB\xBF"))
    text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  return begin != std::string_view::npos && text[begin] == '{' ? read_json(text) : read_csv(text);
}

void demand_complete(const Gradation &gradation, const std::vector<std::size_t> &lines) {
  const std::vector<mpq_class> &x = gradation.openings;
  const std::vector<mpq_class> &m = gradation.masses;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (x[j] < 0)
      throw Malformed(lines[j], "a negative size: give the opening of the sieve");
    if (j > 0 && x[j] == x[j - 1])
      throw Malformed(lines[j], "a size that was there before: give each sieve once");
    if (j > 0 && x[j] < x[j - 1])
      throw Malformed(lines[j], "sizes neither ascend nor descend: sort them");
    if (m[j] < 0)
      throw Malformed(lines[j], "a negative mass: no sieve retains less than nothing");
  }
  if (m.back() != 0)
    throw Malformed(lines.back(),
                    "the largest sieve retains something: add the next larger sieve that retains nothing");
  if (std::all_of(m.begin(), m.end(), [](const mpq_class &mass) { return mass == 0; }))
    throw Malformed(lines.front(), "nothing is retained anywhere: give the masses");
}

} // namespace mdm_check
