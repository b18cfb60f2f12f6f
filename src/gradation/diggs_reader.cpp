#include "gradation/diggs_reader.hpp"

#include "gradation/header_words.hpp"
#include "gradation/sample_choice.hpp"
#include "gradation/xml_tree.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

std::string id_of(pugi::xml_node node) {
  for (const pugi::xml_attribute attribute : node.attributes())
    if (local_name(attribute.name()) == "id")
      return attribute.value();
  return {};
}

class Diggs {
public:
  Diggs(std::string_view text, const Source &source)
      : text_(text), tree_(std::string(text), source, "the file"), source_(source) {}

  Table read(const std::string &id, const std::optional<std::string> &specimen) {
    std::vector<pugi::xml_node> tests;
    std::vector<SampleNames> samples;
    for_each_below(tree_.root(), "ParticleSizeTest", [&](pugi::xml_node test) {
      tests.push_back(test);
      samples.push_back({names_of(test), line_of(test)});
    });
    if (tests.empty())
      source_.refuse(1, "this XML has no ParticleSizeTest: DIGGS with one is read");
    const std::size_t chosen = chosen_sample(samples, specimen, source_);
    table_.id = samples[chosen].names.front().empty() ? id : samples[chosen].names.front();
    table_.header_line = samples[chosen].line;
    for (const SampleNames &sample : samples)
      table_.samples.push_back(sample.names.front());
    for_each_below(tests[chosen], "Grading", [this](pugi::xml_node grading) { read_grading(grading); });
    describe(samples.size());
    return std::move(table_);
  }

private:
  std::size_t line_of(pugi::xml_node node) const {
    return line_number(text_, static_cast<std::size_t>(std::max<std::ptrdiff_t>(node.offset_debug(), 0)));
  }

  static std::vector<std::string> names_of(pugi::xml_node test) {
    std::vector<std::string> names = {id_of(test)};
    for (pugi::xml_node around = test.parent(); around; around = around.parent())
      if (local_name(around.name()) == "Test") {
        names.push_back(id_of(around));
        names.push_back(text_below(child_of(around, "name")));
        break;
      }
    return names;
  }

  void read_grading(pugi::xml_node grading) {
    if (table_.sizes.size() == max_gradation_rows)
      source_.refuse(line_of(grading),
                     fmt::format("there are more than {} rows: give fewer sieves", max_gradation_rows));
    const pugi::xml_node size = child_of(grading, "particleSize"),
                         passing = child_of(grading, "percentPassing");
    if (!size || !passing)
      source_.refuse(line_of(grading), "this Grading has no particleSize or no percentPassing: add it");
    check_single(grading, size);
    check_single(grading, passing);
    table_.lines.push_back(line_of(grading));
    table_.sizes.push_back(number(size) * mm_of(size));
    table_.values.push_back(number(passing));
    table_.roundings.push_back(last_digit_unit(trimmed_text(passing)) / 2);
    const std::string_view unit = passing.attribute("uom").value();
    if (!unit.empty() && unit_of_words(unit) != ColumnUnit::percent)
      source_.refuse(line_of(passing),
                     fmt::format("percentPassing has the unit {}, only '%' is read", in_quotes(unit)));
  }

  /// Refuses a second element of the name of `first`, which may say something else.
  void check_single(pugi::xml_node grading, pugi::xml_node first) const {
    for (const pugi::xml_node node : grading.children())
      if (node != first && local_name(node.name()) == local_name(first.name()))
        source_.refuse(line_of(node), fmt::format("a second {} of the same Grading: leave one out",
                                                  local_name(first.name())));
  }

  Rational number(pugi::xml_node node) const {
    try {
      return parse_decimal(trimmed_text(node));
    } catch (const InputError &error) {
      source_.refuse(line_of(node), fmt::format("{} {}", local_name(node.name()), error.what()));
    }
  }

  static std::string trimmed_text(pugi::xml_node node) {
    const std::string text = text_below(node);
    constexpr std::string_view white = " \t\r\n";
    const std::size_t first = std::min(text.find_first_not_of(white), text.size());
    return text.substr(first, text.find_last_not_of(white) + 1 - first);
  }

  Rational mm_of(pugi::xml_node size) const {
    const std::optional<SizeUnit> unit = length_of(unit_of_words(size.attribute("uom").value()));
    if (!unit || unit == SizeUnit::m)
      source_.refuse(line_of(size),
                     fmt::format("particleSize has the unit {}, only 'mm', 'um' and 'in' are read",
                                 in_quotes(size.attribute("uom").value())));
    return in_mm(*unit);
  }

  void describe(std::size_t samples) {
    table_.column = find_mass_column("passing_percent");
    table_.format = "DIGGS";
    table_.sizes_from = "elements particleSize, in mm";
    table_.masses_from = "elements percentPassing: percent passing";
    table_.is_canonical = false;
    table_.notes.push_back(fmt::format("Specimen {} of {}.", in_quotes(table_.id), samples));
  }

  std::string_view text_;
  XmlTree tree_;
  const Source &source_;
  Table table_;
};

} // namespace

Table read_diggs(std::string_view text, const Source &source, const std::string &id,
                 const std::optional<std::string> &specimen) {
  return Diggs(text, source).read(id, specimen);
}

} // namespace mdm
