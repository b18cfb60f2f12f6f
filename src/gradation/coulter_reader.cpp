#include "gradation/coulter_reader.hpp"

#include "gradation/header_words.hpp"
#include "gradation/number_shares.hpp"
#include "text/lines.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr std::string_view diameters_section = "[#Bindiam]", heights_section = "[#Binheight]";

/// The numbers of a section.
struct Section {
  std::size_t line = 0; ///< of its name; 0 if it is not there
  std::vector<Rational> numbers;
  std::vector<std::size_t> lines;
};

class Coulter {
public:
  Coulter(std::string_view text, const Source &source) : lines_(text), source_(source) {}

  Table read(const std::string &id) {
    while (lines_.next())
      read_line(trimmed(lines_.text()));
    check();
    Table table;
    table.id = id;
    table.column = find_mass_column("mass");
    table.unit = SizeUnit::um;
    table.header_line = heights_.line;
    table.sizes = std::move(diameters_.numbers);
    table.values = std::move(heights_.numbers);
    table.lines = std::move(heights_.lines);
    const Rational last = table.values.back();
    table.values.back() = 0;
    table.format = "Coulter LS file";
    table.sizes_from = "section [#Bindiam], in um";
    table.masses_from = "section [#Binheight]: mass, by volume";
    table.is_canonical = false;
    table.notes.emplace_back("Shares are by volume; the last height is of no class.");
    if (last != 0)
      table.notes.back() += fmt::format(" It is not 0 but {}.", approximate(last, 6));
    return table;
  }

private:
  void read_line(std::string_view line) {
    if (line.starts_with('[')) {
      section_ = line == diameters_section ? &diameters_ : line == heights_section ? &heights_ : nullptr;
      if (section_ != nullptr && section_->line != 0)
        source_.refuse(lines_.number(),
                       fmt::format("{} is there twice: give a file of one measurement", line));
      if (section_ != nullptr)
        section_->line = lines_.number();
    } else if (section_ != nullptr && !line.empty()) {
      read_number(line);
    } else if (const std::size_t sign = line.find('='); sign != std::string_view::npos) {
      check_setting(trimmed(line.substr(0, sign)), trimmed(line.substr(sign + 1)));
    }
  }

  /// What other sections say of the sizes and the heights.
  void check_setting(std::string_view key, std::string_view value) const {
    if (states_other_shares(key, value))
      source_.refuse(lines_.number(), fmt::format("{} is {} here: {}", in_quotes(key), in_quotes(value),
                                                  number_shares_remedy));
    if (key == "Binunits" && unit_of_words(value) != ColumnUnit::um)
      source_.refuse(
          lines_.number(),
          fmt::format("the sizes are in {}, and those of such files are read in um: write them as CSV",
                      in_quotes(value)));
  }

  void read_number(std::string_view line) {
    if (section_->numbers.size() == max_gradation_rows)
      source_.refuse(lines_.number(),
                     fmt::format("there are more than {} rows: give fewer sizes", max_gradation_rows));
    try {
      section_->numbers.push_back(parse_decimal(line, line.find(',') == std::string_view::npos ? '.' : ','));
    } catch (const InputError &error) {
      source_.refuse(lines_.number(), error.what());
    }
    section_->lines.push_back(lines_.number());
  }

  void check() const {
    if (heights_.numbers.size() != diameters_.numbers.size() || heights_.numbers.empty())
      source_.refuse(std::max(heights_.line, diameters_.line),
                     fmt::format("{} has {} numbers, {} has {}: they must be as many", diameters_section,
                                 diameters_.numbers.size(), heights_section, heights_.numbers.size()));
    // Counters of the same maker write particles counted under the same names.
    if (std::all_of(heights_.numbers.begin(), heights_.numbers.end(),
                    [](const Rational &h) { return denominator(h) == 1; }))
      source_.refuse(heights_.line,
                     "the heights are whole numbers, as of a counter, and may be no volumes: write sizes "
                     "and volumes as CSV");
  }

  Lines lines_;
  const Source &source_;
  Section diameters_, heights_;
  Section *section_ = nullptr;
};

} // namespace

bool is_coulter(std::string_view text) {
  for (Lines lines(text); lines.next();)
    if (trimmed(lines.text()) == diameters_section)
      return true;
  return false;
}

Table read_coulter(std::string_view text, const Source &source, const std::string &id) {
  return Coulter(text, source).read(id);
}

} // namespace mdm
