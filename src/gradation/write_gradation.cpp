#include "text/json_writer.hpp"
#include "text/text_table.hpp"

#include <mdm/gradation/write_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace mdm {
namespace {

/// `plain` as digits and an exponent of at most 400 either way; nothing if that takes more than 1000 digits.
std::optional<std::string> with_exponent(const std::string &plain) {
  const std::size_t point = plain.find('.');
  std::string digits = plain;
  long exponent = 0;
  if (point != std::string::npos) {
    digits.erase(point, 1);
    exponent = -static_cast<long>(plain.size() - point - 1);
  }
  digits.erase(0, digits.find_first_not_of('0'));
  while (digits.back() == '0') {
    digits.pop_back();
    ++exponent;
  }
  constexpr long limit{max_decimal_exponent};
  if (exponent > limit)
    digits.append(static_cast<std::size_t>(exponent - limit), '0');
  if (exponent < -limit) {
    const auto behind_point = static_cast<std::size_t>(-limit - exponent);
    digits.insert(0, behind_point - std::min(behind_point, digits.size()), '0');
    digits.insert(digits.size() - behind_point, 1, '.');
  }
  if (digits.size() > max_decimal_digits)
    return std::nullopt;
  return fmt::format("{}e{}", digits, std::clamp(exponent, -limit, limit));
}

/// A number as the readers take it: plain, or with an exponent where that would be more than 1000 digits.
std::string file_decimal(const Rational &r) {
  const std::optional<std::string> plain = exact_decimal(r);
  if (plain && plain->size() <= max_decimal_digits)
    return *plain;
  const std::optional<std::string> scientific = plain ? with_exponent(*plain) : std::nullopt;
  if (!scientific)
    throw InputError(
        "a number of this gradation has no decimal of at most 1000 digits, and cannot be written to a file: "
        "round what it comes from");
  return *scientific;
}

void write_column(JsonWriter &json, std::string_view key, const std::vector<Rational> &column) {
  json.key(key).begin_array();
  for (const Rational &value : column)
    json.plain(file_decimal(value));
  json.end_array();
}

/// The factors of all rows, also the last, which no class uses.
std::vector<Rational> factors_of(const Gradation &g) {
  std::vector<Rational> column;
  for (std::size_t j = 0; j < g.sizes().size(); ++j)
    column.push_back(g.factor(j));
  return column;
}

} // namespace

std::string gradation_csv(const Gradation &g) {
  const bool has_tolerances = !g.tolerances().empty();
  fmt::memory_buffer out;
  const auto end = std::back_inserter(out);
  const bool has_materials = !g.materials().empty();
  fmt::format_to(end, "size_{},mass{}{}{}\n", name(g.unit()), has_tolerances ? ",tolerance_percent" : "",
                 g.has_factors() ? ",factor" : "", has_materials ? ",material" : "");
  for (std::size_t j = 0; j < g.sizes().size(); ++j) {
    fmt::format_to(end, "{},{}", file_decimal(g.sizes()[j]), file_decimal(g.masses()[j]));
    if (has_tolerances)
      fmt::format_to(end, ",{}", file_decimal(g.tolerances()[j]));
    if (g.has_factors())
      fmt::format_to(end, ",{}", file_decimal(g.factor(j)));
    if (has_materials)
      fmt::format_to(end, ",{}", csv_field(g.material(j)));
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

std::string gradation_json(const Gradation &g) {
  JsonWriter json(JsonWriter::Spacing::open);
  json.begin_object().key("id").string(g.id()).key("unit").plain(name(g.unit()));
  write_column(json, "sizes", g.sizes());
  write_column(json, "masses", g.masses());
  if (g.has_factors())
    write_column(json, "factors", factors_of(g));
  if (!g.tolerances().empty())
    write_column(json, "tolerances_percent", g.tolerances());
  json.end_object();
  return json.take() + "\n";
}

std::string envelope_csv(const Envelope &envelope) {
  std::string text = fmt::format("size_{},passing_min_percent,passing_max_percent\n", name(envelope.unit));
  for (std::size_t i = 0; i < envelope.sizes.size(); ++i)
    text += fmt::format("{},{},{}\n", file_decimal(envelope.sizes[i]), file_decimal(envelope.passing_min[i]),
                        file_decimal(envelope.passing_max[i]));
  return text;
}

} // namespace mdm
