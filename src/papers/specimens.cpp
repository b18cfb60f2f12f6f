#include "papers/specimens.hpp"

#include "text/lines.hpp"
#include "text/source.hpp"
#include "text/text_table.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::array<std::string_view, 5> column_names = {"diameter_mm", "scale_factor", "height_mm",
                                                          "void_ratio", "particles"};
constexpr const char *column_list = "diameter_mm,scale_factor,height_mm,void_ratio,particles";

/// The place of each of `column_names` in the header.
std::array<std::size_t, 5> places(const Source &source, std::size_t line,
                                  const std::vector<std::string> &header) {
  std::array<std::size_t, 5> at{};
  for (std::size_t i = 0; i < column_names.size(); ++i) {
    const auto found = std::find(header.begin(), header.end(), column_names[i]);
    if (found == header.end() || header.size() != column_names.size())
      source.refuse(line, std::string("the header is not that of specimens: let it name the columns ") +
                              column_list);
    at[i] = static_cast<std::size_t>(found - header.begin());
  }
  return at;
}

Specimen specimen(const Source &source, std::size_t line, const std::array<std::string, 5> &cells) {
  std::array<Rational, 4> numbers;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    try {
      numbers[i] = parse_decimal(cells[i]);
    } catch (const InputError &e) {
      source.refuse(line, fmt::format("{}: {}", column_names[i], e.what()));
    }
    const bool may_be_zero = column_names[i] == "void_ratio";
    if (numbers[i] < 0 || (numbers[i] == 0 && !may_be_zero))
      source.refuse(line, fmt::format("{}: {} is not {}: correct it", column_names[i], in_quotes(cells[i]),
                                      may_be_zero ? "0 or more" : "positive"));
  }
  const std::optional<Integer> particles = parse_natural(cells[4]);
  if (!particles || *particles == 0)
    source.refuse(
        line, fmt::format("particles: {} is not a whole number from 1 on: correct it", in_quotes(cells[4])));
  return {numbers[0], numbers[1], numbers[2], numbers[3], *particles};
}

/// The cells of a row of a report.
std::array<std::string, 7> cells(const Gradation &g, const Specimen &s) {
  const Integer least = least_specimen(g, s);
  return {to_decimal(s.diameter_mm),
          to_decimal(s.scale_factor),
          to_decimal(s.height_mm),
          to_decimal(s.void_ratio),
          to_string(s.reported),
          to_string(least),
          approximate(ratio(s.reported, least), 6)};
}

} // namespace

std::vector<Specimen> read_specimens(std::string_view content, const std::string &file) {
  const Source source(file);
  source.check_length(content, max_gradation_bytes);
  source.check_text(content, max_gradation_bytes);
  std::vector<Specimen> specimens;
  std::optional<std::array<std::size_t, 5>> at;
  std::vector<std::string> fields;
  Lines lines(content);
  while (lines.next()) {
    const std::string_view text = trimmed(lines.text());
    if (text.empty() || text.front() == '#')
      continue;
    if (!split_fields(text, ',', fields))
      source.refuse(lines.number(),
                    "a quoted field does not end with a quote before the next comma: close it");
    if (!at) {
      at = places(source, lines.number(), fields);
      continue;
    }
    if (fields.size() != column_names.size())
      source.refuse(lines.number(), fmt::format("{} columns where the header has {}: give one value a column",
                                                fields.size(), column_names.size()));
    std::array<std::string, 5> ordered;
    for (std::size_t i = 0; i < ordered.size(); ++i)
      ordered[i] = fields[(*at)[i]];
    specimens.push_back(specimen(source, lines.number(), ordered));
  }
  if (specimens.empty())
    source.refuse(std::max(lines.number(), std::size_t{1}),
                  fmt::format("there is no specimen: give {}a row for each: {}",
                              at ? "" : "a header row and below it ", column_list));
  return specimens;
}

Integer least_specimen(const Gradation &g, const Specimen &s) {
  Question question;
  question.size_factor = s.scale_factor;
  question.solids = Cylinder{s.diameter_mm, s.height_mm, s.void_ratio};
  return solve(g, question).particles().value();
}

std::string specimens_csv(const Gradation &g, const std::vector<Specimen> &specimens) {
  std::string text = std::string(column_list) + ",n_exact,ratio\n";
  for (const Specimen &s : specimens)
    text += fmt::format("{}\n", fmt::join(cells(g, s), ","));
  return text;
}

std::string specimens_text(const Gradation &g, const std::vector<Specimen> &specimens) {
  std::vector<std::vector<std::string>> lines = {
      {"diameter (mm)", "scale factor", "height (mm)", "void ratio", "reported", "smallest", "ratio"}};
  for (const Specimen &s : specimens) {
    const std::array<std::string, 7> row = cells(g, s);
    lines.emplace_back(row.begin(), row.end());
  }
  return text_table(lines, ">>>>>><");
}

} // namespace mdm
