#include "gradation/json_reader.hpp"

#include "gradation/mass_digits.hpp"
#include "gradation/shown.hpp"
#include "text/json_cursor.hpp"
#include "text/nearest_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace mdm {
namespace {

/// With long double in place of double the parser hands over the text of every number below 2^1024, also of
/// those that round to 2^1024. A value of this type says how large a number is; numbers are read from their
/// text.
using Json =
    nlohmann::basic_json<std::map, std::vector, std::string, bool, std::int64_t, std::uint64_t, long double>;

/// The keys of a gradation; the first four hold columns.
enum Key : std::size_t { sizes, masses, factors, tolerances, unit, id, keys };
constexpr std::size_t column_count = 4;
constexpr std::array<std::string_view, keys> key_names = {"sizes", "masses", "factors", "tolerances_percent",
                                                          "unit",  "id"};

/// Takes the parser's events. The names of the functions are nlohmann's.
class Handler {
public:
  Handler(std::string_view content, const Source &source) : content_(content), source_(source) {}

  const char **reached() { return &reached_; }

  bool null() { return no_value("null"); }
  bool boolean(bool) { return no_value("a truth value"); }
  bool binary(Json::binary_t &) { return no_value("binary data"); }
  bool number_integer(std::int64_t value) { return whole_number(value); }
  bool number_unsigned(std::uint64_t value) { return whole_number(value); }
  bool number_float(long double, const std::string &raw);
  bool string(std::string &text);
  bool start_object(std::size_t);
  bool end_object();
  bool start_array(std::size_t);
  bool end_array();
  bool key(std::string &name);
  bool parse_error(std::size_t, const std::string &token, const nlohmann::detail::exception &error);

  /// The gradation, after the last event.
  Gradation gradation(const std::string &fallback_id, std::optional<unsigned> round, bool is_named);

private:
  [[noreturn]] void refuse(const std::string &what) const { refuse_at(reached_, what); }
  /// \param end one past the byte that the message is about
  [[noreturn]] void refuse_at(const char *end, const std::string &what) const;

  /// True directly below a key of the object.
  bool at_key() const { return depth_ == 1; }
  bool in_column() const { return depth_ == 2 && key_ < column_count; }
  /// `masses[3]` or `unit`.
  std::string place() const;

  [[noreturn]] void refuse_key(const std::string &name) const;
  bool no_value(std::string_view what);
  template <typename Whole>
  bool whole_number(Whole value);
  void check_range(long double value, const std::string &text) const;
  void check_id(const std::string &number) const;
  [[noreturn]] void refuse_large(const std::string &text) const;
  Rational decimal(std::string_view text) const;
  void add(Rational value);
  void check_order(const Rational &size);
  void set_unit(std::string_view text);
  void check_complete() const;
  void to_ascending_mm();

  std::string_view content_;
  const Source &source_;
  const char *reached_ = content_.data();
  std::size_t depth_ = 0;
  Key key_ = id;
  std::array<const char *, keys> found_{}; ///< where each key was read, null if it was not
  std::array<std::vector<Rational>, column_count> columns_;
  std::string id_;
  SizeUnit unit_ = SizeUnit::mm;
  bool inches_ = false;
  bool descending_ = false; ///< as the first two sizes do
};

void Handler::refuse_at(const char *end, const std::string &what) const {
  const auto position = static_cast<std::size_t>(end - content_.data());
  source_.refuse(line_number(content_, position == 0 ? 0 : position - 1), what);
}

std::string Handler::place() const {
  if (in_column())
    return fmt::format("{}[{}]", key_names[key_], columns_[key_].size());
  return std::string(key_names[key_]);
}

/// Refuses a value that no key has.
bool Handler::no_value(std::string_view what) {
  const char *wanted = in_column()           ? "write a decimal"
                       : key_ < column_count ? "write an array of decimals"
                       : key_ == unit        ? "write \"mm\", \"um\", \"m\" or \"in\""
                                             : "write a string or a number";
  refuse(fmt::format("{} is {}: {}", place(), what, wanted));
}

template <typename Whole>
bool Handler::whole_number(Whole value) {
  if (in_column())
    add(Rational(value));
  else if (at_key() && key_ == id)
    id_ = std::is_signed_v<Whole> && value == 0 ? "-0" : std::to_string(value); // a 0 with a sign
  else
    return no_value("a number");
  return true;
}

bool Handler::number_float(long double value, const std::string &raw) {
  std::string text = raw;
  // nlohmann puts the locale's decimal point where the file has `.`.
  const std::size_t point = text.find_first_not_of("+-0123456789eE");
  if (point != std::string::npos)
    text[point] = '.';
  check_range(value, text);
  if (at_key() && key_ == id) {
    check_id(text);
    id_ = std::move(text);
    return true;
  }
  if (!in_column())
    return no_value("a number");
  add(decimal(text));
  return true;
}

/// Refuses what a reader in double precision has no number for. The long double decides but within a factor
/// of 2 of the limit.
void Handler::check_range(long double value, const std::string &text) const {
  constexpr long double near = 0x1p1023L;
  static const Rational limit(power(Integer(2), 1024));
  const long double size = std::fabs(value);
  if (size >= near && (size >= 4 * near || abs(decimal(text)) >= limit))
    refuse_large(text);
}

void Handler::refuse_large(const std::string &text) const {
  refuse(fmt::format("{} {} is too large for a JSON number: write it as a string", place(), in_quotes(text)));
}

/// The limits of numbers are those of an id that is one, too.
void Handler::check_id(const std::string &number) const {
  try {
    parse_decimal(number);
  } catch (const InputError &) {
    refuse(
        fmt::format("id {} is beyond the limits of a JSON number: write it as a string", in_quotes(number)));
  }
}

bool Handler::string(std::string &text) {
  if (in_column())
    add(decimal(text));
  else if (at_key() && key_ == id)
    id_ = std::move(text);
  else if (at_key() && key_ == unit)
    set_unit(text);
  else
    return no_value("a string");
  return true;
}

bool Handler::start_object(std::size_t) {
  if (depth_ > 0)
    no_value("an object");
  ++depth_;
  return true;
}

bool Handler::end_object() {
  --depth_;
  return true;
}

bool Handler::start_array(std::size_t) {
  if (!(at_key() && key_ < column_count))
    no_value("an array");
  columns_[key_].reserve(16);
  ++depth_;
  return true;
}

bool Handler::end_array() {
  --depth_;
  return true;
}

bool Handler::key(std::string &name) {
  const auto known = std::find(key_names.begin(), key_names.end(), name);
  if (known == key_names.end())
    refuse_key(name);
  key_ = static_cast<Key>(known - key_names.begin());
  if (found_[key_] != nullptr)
    refuse(fmt::format("key {} is there twice: leave one", in_quotes(name)));
  found_[key_] = reached_;
  return true;
}

/// A key that means nothing to the reader may mean something to its writer.
void Handler::refuse_key(const std::string &name) const {
  if (name == "schema")
    refuse(
        "this is no gradation but what a command of mdm wrote: give the gradation that it was asked about");
  const std::string_view meant = nearest_name(name, key_names);
  if (!meant.empty())
    refuse(fmt::format("key {} is unknown: is it \"{}\"?", in_quotes(name), meant));
  refuse(fmt::format("key {} is unknown: leave it out; there are \"{}\"", in_quotes(name),
                     fmt::join(key_names, "\", \"")));
}

Rational Handler::decimal(std::string_view text) const {
  try {
    return parse_decimal(text);
  } catch (const InputError &error) {
    refuse(fmt::format("{} {}", place(), error.what()));
  }
}

void Handler::add(Rational value) {
  if (key_ == factors ? value.sign() <= 0 : value.sign() < 0)
    refuse(fmt::format("{} {} is {}", place(), shown(value),
                       key_ == factors ? "not above 0: write a number above 0"
                                       : "negative: write a number from 0 on"));
  if (columns_[key_].size() == max_gradation_rows)
    refuse(
        fmt::format("{} has more than {} entries: give fewer sieves", key_names[key_], max_gradation_rows));
  if (key_ == sizes)
    check_order(value);
  columns_[key_].push_back(std::move(value));
}

/// Sizes go on in the direction of the first two.
void Handler::check_order(const Rational &size) {
  const std::vector<Rational> &x = columns_[sizes];
  if (x.empty())
    return;
  const int order = size.compare(x.back());
  if (order == 0)
    refuse(fmt::format("{} {} repeats the size before it: give each size once", place(), shown(size)));
  if (x.size() == 1)
    descending_ = order < 0;
  else if ((order < 0) != descending_)
    refuse(fmt::format("{} {} breaks the order: sizes must all ascend or all descend", place(), shown(size)));
}

void Handler::set_unit(std::string_view text) {
  const std::optional<SizeUnit> unit = parse_size_unit(text);
  if (!unit)
    refuse(fmt::format("unit {} is unknown: use \"mm\", \"um\", \"m\" or \"in\"", in_quotes(text)));
  inches_ = unit == SizeUnit::in;
  unit_ = inches_ ? SizeUnit::mm : *unit;
}

bool Handler::parse_error(std::size_t, const std::string &token, const nlohmann::detail::exception &error) {
  constexpr int number_overflow = 406; // nlohmann's number of that exception
  if (error.id == number_overflow)
    refuse_large(token);
  constexpr std::size_t shown_bytes = 20;
  const auto position = static_cast<std::size_t>(reached_ - content_.data());
  const std::string_view before = content_.substr(0, position);
  const std::string_view line =
      before.substr(before.substr(0, before.empty() ? 0 : before.size() - 1).rfind('\n') + 1);
  const std::string_view end = line.substr(line.size() - std::min(line.size(), shown_bytes));
  refuse(
      fmt::format("this is not JSON at byte {} of the line, the end of {}: check quotes, commas and brackets",
                  line.size(), in_quotes(end)));
}

void Handler::check_complete() const {
  const std::size_t n = columns_[sizes].size();
  for (const Key key : {sizes, masses})
    if (found_[key] == nullptr)
      refuse(fmt::format("key \"{}\" is missing: give sizes and masses", key_names[key]));
  if (n < 2)
    refuse_at(found_[sizes], fmt::format("sizes has {} entries: a gradation needs at least two", n));
  for (const Key key : {masses, factors, tolerances})
    if (found_[key] != nullptr && columns_[key].size() != n)
      refuse_at(found_[key], fmt::format("{} has {} entries, sizes has {}: give one a size", key_names[key],
                                         columns_[key].size(), n));
}

void Handler::to_ascending_mm() {
  if (descending_)
    for (std::vector<Rational> &column : columns_)
      std::reverse(column.begin(), column.end());
  if (inches_)
    for (Rational &size : columns_[sizes])
      size *= in_mm(SizeUnit::in);
}

Gradation Handler::gradation(const std::string &fallback_id, std::optional<unsigned> round, bool is_named) {
  check_complete();
  to_ascending_mm();
  Gradation::Data data;
  data.id = found_[id] != nullptr ? std::move(id_) : fallback_id;
  if (data.id.empty() && is_named)
    data.id = fallback_id;
  data.unit = unit_;
  data.file_unit = inches_ ? "inches" : "";
  data.sizes = std::move(columns_[sizes]);
  data.masses = std::move(columns_[masses]);
  if (const std::optional<std::string> note = settle_digits(data.masses, round))
    data.notes.push_back(*note);
  data.factors = std::move(columns_[factors]);
  data.tolerances = std::move(columns_[tolerances]);
  if (inches_)
    data.notes.emplace_back("Sizes in inches were converted to mm.");
  try {
    return Gradation(std::move(data));
  } catch (const InputError &error) { // the last mass, or no mass at all
    refuse_at(found_[masses], fmt::format("masses: {}", error.what()));
  }
}

} // namespace

Gradation read_json(std::string_view content, const Source &source, const std::string &fallback_id,
                    std::optional<unsigned> round, bool is_named) {
  if (!content.substr(std::min(content.find_first_not_of(" \t\r\n"), content.size())).starts_with('{'))
    source.refuse(1, "there is no JSON object: write one as {\"sizes\": [...], \"masses\": [...]}");
  Handler handler(content, source);
  const JsonCursor begin(content.data(), handler.reached());
  const JsonCursor end(content.data() + content.size(), handler.reached());
  Json::sax_parse(begin, end, &handler);
  return handler.gradation(fallback_id, round, is_named);
}

} // namespace mdm
