#include "answer/answer_rows.hpp"

#include <mdm/number/decimal.hpp>

namespace mdm {

std::vector<AnswerRow> answer_rows(const Match &m) {
  const Gradation &g = m.gradation;
  std::vector<AnswerRow> rows;
  rows.reserve(g.classes());
  for (std::size_t j = 0; j < g.classes(); ++j) {
    if (!g.is_class(j))
      continue;
    const bool follows = j > 0 && g.is_class(j - 1);
    rows.push_back({j, g.material(j), follows ? rows.back().upper : g.opening_text(j), g.opening_text(j + 1),
                    to_decimal(g.mass(j)), "", nullptr});
    if (!m.has_answer())
      continue;
    rows.back().quantity = to_string(m.sample->quantities[j]);
    if (const std::optional<Enclosure> &size = m.sample->sizes[j])
      rows.back().size = &*size;
  }
  return rows;
}

std::string margin_text(const MatchScale &scale) {
  static const Rational tiny = ratio(1, 1000000);
  return scale.margin < tiny ? approximate(scale.margin, 3) : to_decimal(scale.margin);
}

} // namespace mdm
