#include "answer/answer_rows.hpp"

#include <mdm/number/decimal.hpp>

namespace mdm {

std::vector<AnswerRow> answer_rows(const Match &m) {
  const Gradation &g = m.gradation;
  std::vector<AnswerRow> rows(g.classes());
  for (std::size_t j = 0; j < rows.size(); ++j)
    rows[j] = {j == 0 ? g.opening_text(0) : rows[j - 1].upper, g.opening_text(j + 1), to_decimal(g.mass(j)),
               "", nullptr};
  for (std::size_t j = 0; m.has_answer() && j < rows.size(); ++j) {
    rows[j].quantity = to_string(m.sample->quantities[j]);
    if (const std::optional<Enclosure> &size = m.sample->sizes[j])
      rows[j].size = &*size;
  }
  return rows;
}

std::string margin_text(const MatchScale &scale) {
  static const Rational tiny = ratio(1, 1000000);
  return scale.margin < tiny ? approximate(scale.margin, 3) : to_decimal(scale.margin);
}

} // namespace mdm
