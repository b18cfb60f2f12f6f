#include "packing/packing_reader.hpp"

#include "packing/disc_sizes.hpp"
#include "packing/packing_writer.hpp"
#include "text/lines.hpp"
#include "text/source.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace mdm {
namespace {

constexpr std::string_view first_line = "mdm-packing 1";
constexpr std::int64_t most_units = std::int64_t{1} << 52;
constexpr unsigned most_places = 40;

template <class Number>
std::optional<Number> number(std::string_view text) {
  Number n{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
  if (error != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return n;
}

/// A support as it is written; earlier discs only.
std::optional<std::int32_t> support(std::string_view text, std::size_t disc) {
  for (const Support s : {on_floor, on_left_wall, on_right_wall, unsupported})
    if (text == name(s))
      return s;
  const std::optional<std::int32_t> n = number<std::int32_t>(text);
  return n && *n >= 0 && static_cast<std::size_t>(*n) < disc ? n : std::nullopt;
}

class PackingReader {
public:
  PackingReader(std::string_view text, std::string_view file) : source_(file), lines_(text) {}

  Packing read() {
    if (!lines_.next() || lines_.text() != first_line)
      refuse("the first line is not " + in_quotes(first_line) + ": write the file with mdm pack -o");
    read_header();
    for (std::size_t i = 0; i < discs_; ++i)
      p_.discs.push_back(disc(i));
    while (lines_.next())
      if (!trimmed(lines_.text()).empty())
        refuse("more lines than the header says discs: write the file anew");
    if (p_.radii_hash() != radii_)
      refuse("the radii are not those that the header's line radii is about: write the file anew");
    return std::move(p_);
  }

private:
  [[noreturn]] void refuse(const std::string &what) const { source_.refuse(lines_.number(), what); }

  /// The value of the header's next line.
  std::string_view value(std::string_view key) {
    if (!lines_.next() || lines_.text().substr(0, key.size() + 1) != std::string(key) + " ")
      refuse("the line " + in_quotes(std::string(key) + " ...") +
             " is missing here: write the file with mdm pack -o");
    return lines_.text().substr(key.size() + 1);
  }

  template <class Number>
  Number whole(std::string_view key, Number most) {
    const std::string_view text = value(key);
    const std::optional<Number> n = number<Number>(text);
    if (!n || *n < 0 || *n > most)
      refuse(in_quotes(text) + " is no whole number from 0 to " + std::to_string(most) +
             ": write the file with mdm "
             "pack -o");
    return *n;
  }

  /// True for the first of two words.
  bool is_first(std::string_view key, std::string_view first, std::string_view second) {
    const std::string_view text = value(key);
    if (text != first && text != second)
      refuse(in_quotes(text) + " is neither " + std::string(first) + " nor " + std::string(second));
    return text == first;
  }

  DepositRule rule(std::string_view text) const {
    for (const DepositRule r : {DepositRule::lowest, DepositRule::drop, DepositRule::apollonian})
      if (text == name(r))
        return r;
    refuse(in_quotes(text) + " is none of lowest, drop and apollonian");
  }

  void read_header() {
    const std::string_view unit = value("unit");
    constexpr std::array<std::string_view, 5> units = {"any", "mm", "um", "m", "in"};
    if (std::find(units.begin(), units.end(), unit) == units.end())
      refuse(in_quotes(unit) + " is no unit: any, mm, um, m or in");
    p_.unit = unit == "any" ? "" : unit;
    p_.places = whole<unsigned>("places", most_places);
    p_.width = whole<std::int64_t>("width", most_units);
    p_.periodic = is_first("sides", "periodic", "walls");
    p_.rule = rule(value("rule"));
    p_.floor = is_first("floor", "left", "centred") ? FloorRule::left : FloorRule::centred;
    p_.seed = whole<std::uint64_t>("seed", UINT64_MAX);
    p_.front = whole<std::int64_t>("front", most_units);
    radii_ = value("radii");
    discs_ = whole<std::size_t>("discs", most_discs);
    if (!lines_.next() || lines_.text() != "x y r left right")
      refuse("the line 'x y r left right' is missing here: write the file with mdm pack -o");
  }

  PackedDisc disc(std::size_t number_of_disc) {
    if (!lines_.next())
      refuse("fewer discs than the header says: write the file anew");
    std::array<std::string_view, 5> fields;
    std::string_view rest = lines_.text();
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const std::size_t space = i + 1 < fields.size() ? rest.find(' ') : rest.size();
      if (space == std::string_view::npos)
        refuse("not five fields x y r left right, one space apart");
      fields[i] = rest.substr(0, space);
      rest.remove_prefix(std::min(rest.size(), space + 1));
    }
    const auto x = number<std::int64_t>(fields[0]), y = number<std::int64_t>(fields[1]),
               r = number<std::int64_t>(fields[2]);
    if (!x || !y || !r || *r <= 0 || *r > most_units || *x < 0 || *x > p_.width || *y < 0 || *y > most_units)
      refuse("x, y and r are not whole numbers in the box: x from 0 to the width, r above 0, all below 2^52");
    const auto left = support(fields[3], number_of_disc), right = support(fields[4], number_of_disc);
    if (!left || !right)
      refuse("a support is neither an earlier disc's number nor floor, left-wall, right-wall or none");
    return {*x, *y, *r, *left, *right};
  }

  Source source_;
  Lines lines_;
  Packing p_;
  std::string radii_;
  std::size_t discs_ = 0;
};

} // namespace

bool is_packing(std::string_view text) {
  return text.substr(0, first_line.size()) == first_line;
}

Packing read_packing(std::string_view text, std::string_view file) {
  return PackingReader(text, file).read();
}

} // namespace mdm
