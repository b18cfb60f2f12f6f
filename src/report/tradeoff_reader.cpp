#include "report/tradeoff_reader.hpp"

#include "answer/string_members.hpp"
#include "report/tradeoff_report.hpp"
#include "text/json_member.hpp"
#include "text/source.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

constexpr const char *tradeoff_schema = "mdm-tradeoff-1";
constexpr const char *tradeoff_remedy = ": give the JSON of mdm tradeoff";

Integer natural_of(const nlohmann::json &row, const std::string &key) {
  const std::string text = text_member(row, key);
  const std::optional<Integer> n = parse_natural(text);
  if (!n)
    throw InputError(key + ": " + in_quotes(text) + " is no natural number");
  return *n;
}

Rational decimal_of(const nlohmann::json &row, const std::string &key) {
  const Rational value = parse_decimal(text_member(row, key));
  if (value < 0)
    throw InputError(key + " is below 0");
  return value;
}

/// p/q, or p, from 0 to 1.
Rational share_of(const nlohmann::json &row, const std::string &key) {
  const std::string text = text_member(row, key);
  const std::size_t slash = text.find('/');
  const std::optional<Integer> p = parse_natural(text.substr(0, slash));
  const std::optional<Integer> q = slash == std::string::npos ? 1 : parse_natural(text.substr(slash + 1));
  if (!p || !q || *q == 0 || *p > *q)
    throw InputError(key + ": " + in_quotes(text) + " is no fraction from 0 to 1");
  return ratio(*p, *q);
}

TradeoffRow row_of(const nlohmann::json &json) {
  TradeoffRow row;
  row.tolerance = decimal_of(json, "tolerance");
  row.smallest = {decimal_of(json, "smallest"), 1};
  row.lost = share_of(json, "lost");
  row.lower_bound = natural_of(json, "lower_bound");
  row.has_none = text_member(json, "status") == "none";
  if (!member_of(json, "particles").is_null()) {
    row.particles = natural_of(json, "particles");
    if (*row.particles == 0 || *row.particles < row.lower_bound)
      throw InputError("particles is 0, or less than lower_bound");
  }
  return row;
}

std::vector<TradeoffRow> rows_of(const nlohmann::json &json, const std::string &key) {
  const nlohmann::json &rows = member_of(json, key);
  if (!rows.is_array() || rows.empty())
    throw InputError(key + " is no list of rows");
  std::vector<TradeoffRow> all;
  for (std::size_t i = 0; i < rows.size(); ++i)
    try {
      all.push_back(row_of(rows[i]));
    } catch (const InputError &e) {
      throw InputError(fmt::format("{}[{}]: {}", key, i, e.what()));
    }
  return all;
}

SizeUnit unit_of(const std::string &written) {
  for (const SizeUnit unit : {SizeUnit::mm, SizeUnit::um, SizeUnit::m})
    if (written == name(unit))
      return unit;
  throw InputError("unit: " + in_quotes(written) + " is none of mm, um and m");
}

AskedTolerance::Kind kind_of(const std::string &written) {
  using Kind = AskedTolerance::Kind;
  for (const auto &[kind, word] : {std::pair{Kind::retained, "retained"}, std::pair{Kind::passing, "passing"},
                                   std::pair{Kind::total, "total"}})
    if (written == word)
      return kind;
  throw InputError("kind: " + in_quotes(written) + " is none of retained, passing and total");
}

StatedTradeoff tradeoff_of(const nlohmann::json &json) {
  if (text_member(json, "schema") != tradeoff_schema)
    throw InputError(std::string("schema is not ") + tradeoff_schema);
  StatedTradeoff t;
  t.id = text_member(json, "id");
  t.question = text_member(json, "question");
  t.unit = unit_of(text_member(json, "unit"));
  t.kind = kind_of(text_member(json, "kind"));
  t.by_tolerance = rows_of(json, "by_tolerance");
  t.by_sieve = rows_of(json, "by_sieve");
  const nlohmann::json &notes = member_of(json, "notes");
  if (!notes.is_array())
    throw InputError("notes is no list");
  for (const nlohmann::json &note : notes) {
    if (!note.is_string())
      throw InputError("notes has what is no string");
    t.notes.push_back(note.get<std::string>());
  }
  return t;
}

} // namespace

StatedTradeoff stated(const Tradeoff &t) {
  return {t.gradation.id(),   in_words(t.question, t.gradation.unit()),
          t.gradation.unit(), t.kind,
          t.by_tolerance,     t.by_sieve,
          tradeoff_notes(t)};
}

bool is_tradeoff(std::string_view content) {
  return json_schema(content) == tradeoff_schema;
}

StatedTradeoff read_tradeoff(std::string_view content, const std::string &file) {
  const Source source(file);
  try {
    return tradeoff_of(json_tree(content));
  } catch (const JsonError &e) {
    source.refuse(e.line, e.what());
  } catch (const InputError &e) {
    throw InputError(file + ": " + e.what() + tradeoff_remedy);
  }
}

} // namespace mdm
