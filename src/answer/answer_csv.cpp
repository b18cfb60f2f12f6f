#include "answer/answer.hpp"
#include "answer/answer_rows.hpp"
#include "text/long_text.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"

namespace mdm {

std::string answer_csv(const Match &m) {
  TextBuffer out;
  const std::string_view unit = name(m.gradation.unit());
  const bool has_materials = !m.gradation.materials().empty();
  add(out, "lower_{0},upper_{0},mass,quantity,size_lo_{0},size_hi_{0}{1}\n", unit,
      has_materials ? ",material" : "");
  for (const AnswerRow &r : answer_rows(m))
    add(out, "{},{},{},{},{},{}{}\n", r.lower, r.upper, r.mass, r.quantity,
        r.size ? r.size->lower_text() : "", r.size ? r.size->upper_text() : "",
        has_materials ? "," + csv_field(r.material) : "");
  return fmt::to_string(out);
}

void spread_csv(const Match &m, const Spread &spread, const Sink &sink) {
  LongText out(sink);
  out.add("lower_{0},upper_{0},size_lo_{0},size_hi_{0}\n", name(m.gradation.unit()));
  const std::vector<AnswerRow> all = answer_rows(m);
  for (const ClassSpread &c : spread.classes)
    for_each_size(c, m.digits, [&](const Enclosure &size) {
      const AnswerRow &row = all[c.index()];
      out.add("{},{},{},{}\n", row.lower, row.upper, size.lower_text(), size.upper_text());
    });
  out.finish();
}

} // namespace mdm
