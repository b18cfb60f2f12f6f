#include "answer/batch_csv.hpp"

#include "answer/answer_rows.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"

#include <mdm/number/decimal.hpp>

namespace mdm {

std::string batch_csv_header(std::string_view unit) {
  return fmt::format("id,class,lower_{0},upper_{0},share_percent,quantity,size_lo_{0},size_hi_{0}\n", unit);
}

std::string batch_csv(const Match &m) {
  constexpr unsigned digits = 15;
  const std::vector<AnswerRow> rows = answer_rows(m);
  const std::vector<Rational> achieved =
      m.has_answer() && m.sample->shares ? *m.sample->shares : shares(m.gradation);
  const std::string id = csv_field(m.gradation.id());
  TextBuffer out;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const AnswerRow &r = rows[j];
    add(out, "{},{},{},{},{},{},{},{}\n", id, j + 1, r.lower, r.upper,
        approximate(Rational(achieved[j] * 100), digits), r.quantity, r.size ? r.size->lower_text() : "",
        r.size ? r.size->upper_text() : "");
  }
  return fmt::to_string(out);
}

} // namespace mdm
