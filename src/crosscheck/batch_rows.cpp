#include "crosscheck/batch_rows.hpp"

#include "answer/batch_csv.hpp"
#include "text/lines.hpp"
#include "text/source.hpp"

#include <mdm/gradation/size_unit.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

namespace mdm {
namespace {

/// The places of the columns.
constexpr std::size_t at_id = 0, at_class = 1, at_lower = 2, at_upper = 3, at_quantity = 5, at_size_lo = 6,
                      at_size_hi = 7, batch_columns = 8;

/// The unit of the header; nothing of another line. The share may be that of the match.
std::optional<SizeUnit> unit_of_header(std::string_view line) {
  std::string plain(line);
  if (const std::size_t at = plain.find("match_share"); at != std::string::npos)
    plain.erase(at, std::string_view("match_").size());
  for (const SizeUnit unit : {SizeUnit::mm, SizeUnit::um, SizeUnit::m})
    if (plain + "\n" == batch_csv_header(name(unit)))
      return unit;
  return std::nullopt;
}

void add_class(OtherAnswer &answer, const std::vector<std::string> &fields) {
  if (fields[at_quantity].empty()) { // there is no answer
    answer.failure = AnswerVerdict::no_answer;
    answer.reason = "there are no quantities";
    return;
  }
  const std::optional<Integer> q = parse_natural(fields[at_quantity]);
  if (!q)
    throw InputError(in_quotes(fields[at_quantity]) + " is no quantity");
  answer.quantities.push_back(*q);
  answer.classes.emplace_back(std::pair(parse_decimal(fields[at_lower]), parse_decimal(fields[at_upper])));
  answer.sizes.emplace_back();
  if (!fields[at_size_lo].empty())
    answer.sizes.back() = {parse_decimal(fields[at_size_lo]), parse_decimal(fields[at_size_hi])};
}

} // namespace

bool is_batch_header(std::string_view line) {
  return unit_of_header(line).has_value();
}

std::vector<OtherAnswer> read_batch_rows(std::string_view content, const std::string &file) {
  const Source source(file);
  std::vector<OtherAnswer> answers;
  std::optional<SizeUnit> unit;
  std::vector<std::string> fields;
  std::size_t classes = 0; // of the last answer
  Lines lines(without_byte_order_mark(content));
  while (lines.next()) {
    const std::string_view line = trimmed(lines.text());
    if (line.empty())
      continue;
    if (!unit) {
      unit = unit_of_header(line);
      continue;
    }
    if (!split_fields(line, ',', fields) || fields.size() != batch_columns)
      source.refuse(lines.number(), "this is no row of mdm batch: give what it wrote");
    try {
      if (fields[at_class] == "1") {
        answers.emplace_back();
        answers.back().id = fields[at_id];
        answers.back().has_id = true;
        classes = 0;
        answers.back().unit_mm = in_mm(*unit);
      }
      if (answers.empty() || answers.back().id != fields[at_id] ||
          fields[at_class] != std::to_string(++classes))
        throw InputError("the classes of an answer are not in order from 1 on");
      add_class(answers.back(), fields);
    } catch (const InputError &error) {
      source.refuse(lines.number(), std::string(error.what()) + ": give what mdm batch wrote");
    }
  }
  return answers;
}

} // namespace mdm
