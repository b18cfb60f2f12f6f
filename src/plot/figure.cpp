#include "plot/figure.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace mdm {
namespace {

/// |n| = mantissa * 2^exponent.
double log10_of_integer(const Integer &n) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, n.backend().data());
  return std::log10(std::abs(mantissa)) + static_cast<double>(exponent) * std::log10(2.0);
}

/// The least of 1, 2 and 5 times a power of ten that is `least` or more.
double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double digit : {1.0, 2.0, 5.0})
    if (digit * power >= least * (1 - 1e-9))
      return digit * power;
  return 10 * power;
}

/// The multiples of `step` in [low, high].
std::vector<double> multiples(double low, double high, double step) {
  std::vector<double> all;
  const double slack = 1e-9 * step;
  for (double i = std::ceil((low - slack) / step); i * step <= high + slack; ++i)
    all.push_back(i * step);
  return all;
}

/// A multiple of `step` with no more places than that needs.
std::string number(double value, double step) {
  const double size = std::max(std::abs(value), step);
  if (size >= 1e6 || step < 1e-9)
    return fmt::format("{:.12g}", std::abs(value) < 1e-9 * step ? 0.0 : value);
  const int places = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  const std::string text = fmt::format("{:.{}f}", value, places);
  return text.find_first_not_of("-0.") == std::string::npos ? "0" : text;
}

/// digit * 10^exponent in plain notation.
std::string multiple_text(int digit, int exponent) {
  return fmt::format("{:.{}f}", digit * std::pow(10.0, exponent), std::max(0, -exponent));
}

/// 10^exponent in plain notation, or as a power.
std::string power_of_ten_text(int exponent, bool plain) {
  if (plain)
    return multiple_text(1, exponent);
  static constexpr std::array<const char *, 10> raised = {"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                                          "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "10\u207B" : "10";
  for (const char digit : std::to_string(std::abs(exponent)))
    text += raised.at(static_cast<std::size_t>(digit - '0'));
  return text;
}

/// Powers of ten, every one or every few; between those of every one, their multiples, of which a short axis
/// shows 2 and 5 and the last.
std::vector<Tick> decades(double low, double high) {
  constexpr double most_labels = 12;
  constexpr double most_with_minor = 8;
  constexpr double most_plain = 4.5;
  constexpr double shortest = 2.2;
  const double slack = 1e-9;
  const bool plain = std::max(-low, high) <= most_plain;
  const double step = std::max(1.0, std::ceil((high - low) / most_labels));
  const bool shows_multiples = plain && high - low <= shortest;
  std::vector<Tick> ticks;
  for (double e = std::floor(low / step) * step; e <= high + slack; e += step) {
    if (e >= low - slack)
      ticks.push_back({e, power_of_ten_text(static_cast<int>(e), plain)});
    for (int digit = 2; digit < 10 && high - low <= most_with_minor; ++digit) {
      const double at = e + std::log10(digit);
      const bool is_last = at <= high + slack && e + std::log10(digit + 1) > high + slack;
      if (at >= low - slack && at <= high + slack)
        ticks.push_back({at, shows_multiples && (digit == 2 || digit == 5 || is_last)
                                 ? multiple_text(digit, static_cast<int>(e))
                                 : ""});
    }
  }
  return ticks;
}

std::size_t labels(const std::vector<Tick> &ticks) {
  return static_cast<std::size_t>(
      std::count_if(ticks.begin(), ticks.end(), [](const Tick &t) { return !t.label.empty(); }));
}

/// The bytes of the first character of well-formed text.
std::size_t character_bytes(std::string_view text) {
  std::size_t bytes = 1;
  while (bytes < text.size() && (static_cast<unsigned char>(text[bytes]) & 0xC0U) == 0x80)
    ++bytes;
  return bytes;
}

/// In parts of the letter size; those of DejaVu Sans, which is wider than most.
double character_width(std::string_view character) {
  if (std::string_view("mwMW@%").find(character) != std::string_view::npos)
    return 1.0;
  return std::string_view(" .,:;'|!ijl()[]").find(character) != std::string_view::npos ? 0.42 : 0.66;
}

/// The code point of one well-formed character.
char32_t code_point(std::string_view character) {
  const auto byte = [character](std::size_t i) { return static_cast<unsigned char>(character[i]); };
  char32_t code = character.size() == 1 ? byte(0) : byte(0) & (0x7FU >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i)
    code = (code << 6) | (byte(i) & 0x3FU);
  return code;
}

/// True for what the fonts of a plain installation have: Latin, Greek, Cyrillic, common signs.
bool is_in_fonts(char32_t code) {
  struct Codes {
    char32_t first, last;
  };
  static constexpr std::array<Codes, 21> all = {
      {{0x20, 0x7E},     {0xA0, 0x17F},    {0x386, 0x386},   {0x388, 0x38A},   {0x38C, 0x38C},
       {0x38E, 0x3A1},   {0x3A3, 0x3CE},   {0x401, 0x40C},   {0x40E, 0x44F},   {0x451, 0x45C},
       {0x2013, 0x2014}, {0x2018, 0x201A}, {0x201C, 0x201E}, {0x2020, 0x2022}, {0x2026, 0x2026},
       {0x2030, 0x2030}, {0x2070, 0x2070}, {0x2074, 0x207B}, {0x20AC, 0x20AC}, {0x2212, 0x2212},
       {0x2264, 0x2265}}};
  return std::any_of(all.begin(), all.end(),
                     [code](const Codes &c) { return c.first <= code && code <= c.last; });
}

} // namespace

double log10_of(const Rational &r) {
  return log10_of_integer(Integer(numerator(r))) - log10_of_integer(Integer(denominator(r)));
}

Axis linear_axis(const std::string &title, double low, double high) {
  if (!(high > low)) {
    const double margin = std::max(std::abs(low) * 0.1, 1e-300);
    low -= margin;
    high += margin;
  }
  constexpr double steps = 6;
  const double step = round_step((high - low) / steps);
  Axis axis{title, std::floor(low / step + 1e-9) * step, std::ceil(high / step - 1e-9) * step, {}};
  for (const double at : multiples(axis.low, axis.high, step))
    axis.ticks.push_back({at, number(at, step)});
  return axis;
}

Axis log_axis(const std::string &title, double low, double high) {
  constexpr double least_span = 1e-9; // what doubles can still tell apart
  if (high - low < least_span) {
    low -= least_span / 2;
    high += least_span / 2;
  }
  Axis axis{title, low, high, decades(low, high)};
  constexpr std::size_t enough = 3;
  if (labels(axis.ticks) >= enough || (labels(axis.ticks) == 2 && high - low >= 1))
    return axis;
  constexpr double most = 300; // what doubles can hold
  if (std::max(-low, high) > most)
    return axis;
  axis.ticks.clear();
  const double first = std::pow(10.0, low);
  const double last = std::pow(10.0, high);
  const double step = round_step((last - first) / 5);
  for (const double value : multiples(first, last, step))
    if (value > 0)
      axis.ticks.push_back({std::log10(value), number(value, step)});
  return axis;
}

double text_width(std::string_view text, double size) {
  double width = 0;
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    width += size * character_width(text.substr(0, bytes));
    text.remove_prefix(bytes);
  }
  return width;
}

std::string drawable(std::string_view text) {
  std::string shown;
  const std::string clean = printable(text);
  for (std::string_view rest = clean; !rest.empty();) {
    const std::string_view next = rest.substr(0, character_bytes(rest));
    const char32_t code = code_point(next);
    shown += is_in_fonts(code) ? std::string(next) : fmt::format("\\u{:04x}", static_cast<unsigned>(code));
    rest.remove_prefix(next.size());
  }
  return shown;
}

std::vector<std::string> escaped_texts(const Figure &figure) {
  std::set<std::string> found;
  const auto look_at = [&found](const std::string &text) {
    if (drawable(text) != printable(text))
      found.insert(text);
  };
  look_at(figure.title);
  for (const std::string &note : figure.notes)
    look_at(note);
  for (const std::string &remark : figure.remarks)
    look_at(remark);
  for (const Panel &panel : figure.panels) {
    look_at(panel.title);
    for (const Series &series : panel.series)
      look_at(series.title);
  }
  return {found.begin(), found.end()};
}

std::string fitted(std::string_view text, double width, double size) {
  constexpr std::string_view dots = "...";
  const std::string clean = drawable(text);
  if (text_width(clean, size) <= width)
    return clean;
  std::string kept;
  for (std::string_view rest = clean; !rest.empty();) {
    const std::string_view next = rest.substr(0, character_bytes(rest));
    if (text_width(kept, size) + text_width(next, size) + text_width(dots, size) > width)
      break;
    kept += next;
    rest.remove_prefix(next.size());
  }
  return kept + std::string(dots);
}

std::vector<std::string> wrapped(std::string_view text, double width) {
  std::vector<std::string> lines;
  const std::string clean = drawable(text);
  for (std::string_view rest = clean; !rest.empty();) {
    const std::size_t end = rest.find(' ');
    const std::string word = fitted(rest.substr(0, end), width);
    if (lines.empty() || text_width(lines.back() + " " + word, letter_size) > width)
      lines.push_back(word);
    else
      lines.back() += " " + word;
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return lines;
}

} // namespace mdm
