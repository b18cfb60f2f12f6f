#include "gradation.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace mdm_check {
namespace {

/// Reads JSON in one pass, with every number from its text. The position never moves past the end.
class Reader {
public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string &what) const { throw Malformed(line_, what); }

  /// The next character that is no white space; 0 at the end.
  char peek() {
    while (at_ < text_.size() && std::string_view(" \t\r\n").find(text_[at_]) != std::string_view::npos)
      line_ += text_[at_++] == '\n' ? 1U : 0U;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    const bool yes = peek() == c;
    at_ += yes ? 1 : 0;
    return yes;
  }
  void demand(char c) {
    if (!take(c))
      fail(std::string("'") + c + "' is missing in the JSON: " + quoted(text_.substr(at_, 81)) +
           " stands there");
  }

  /// Calls member(key) at each value of an object.
  template <class Member>
  void object(Member member) {
    const Level level(*this);
    std::vector<std::string> keys;
    demand('{');
    if (!take('}')) {
      do {
        keys.push_back(string());
        demand(':');
        member(std::as_const(keys.back()));
      } while (take(','));
      demand('}');
    }
    std::sort(keys.begin(), keys.end());
    const auto twice = std::adjacent_find(keys.begin(), keys.end());
    if (twice != keys.end())
      fail("key " + quoted(*twice) + " is twice in an object that ends here: drop one");
  }

  /// Calls element() at each value of an array.
  template <class Element>
  void array(Element element) {
    const Level level(*this);
    demand('[');
    if (take(']'))
      return;
    do
      element();
    while (take(','));
    demand(']');
  }

  std::string string() {
    demand('"');
    std::string out;
    while (true) {
      const char c = next();
      if (c == '"')
        return out;
      if (static_cast<unsigned char>(c) < 0x20)
        fail("a string of the JSON has a line break, a tab or no end: close its quotes");
      if (c == '\\')
        escape(out);
      else
        out += c;
    }
  }

  /// The text of a number as JSON writes it.
  std::string_view number() {
    peek();
    const std::size_t begin = at_;
    if (is_at('-'))
      ++at_;
    bool well_formed = is_at('0') ? (++at_, true) : digits();
    if (is_at('.')) {
      ++at_;
      well_formed = digits() && well_formed;
    }
    if (is_at('e') || is_at('E')) {
      ++at_;
      if (is_at('+') || is_at('-'))
        ++at_;
      well_formed = digits() && well_formed;
    }
    if (!well_formed)
      fail(quoted(text_.substr(begin, 81)) + " is no value of JSON: write a string or a number");
    return text_.substr(begin, at_ - begin);
  }

  /// A string that holds a decimal, or a number.
  mpq_class decimal() {
    if (peek() == '"')
      return read_decimal(string(), '.', line_);
    const std::string_view written = number();
    const mpq_class value = read_decimal(written, '.', line_);
    if (abs(value) >= power(2, 1024))
      fail(quoted(written) + " is beyond the range of JSON numbers: write it as a string");
    return value;
  }

  void skip_value() {
    const char c = peek();
    if (c == '{')
      object([this](const std::string &) { skip_value(); });
    else if (c == '[')
      array([this] { skip_value(); });
    else if (c == '"')
      string();
    else if (!skip_word("true") && !skip_word("false") && !skip_word("null"))
      number();
  }

private:
  /// Counts the objects and arrays around the position.
  class Level {
  public:
    explicit Level(Reader &reader) : reader_(reader) {
      if (++reader_.depth_ > 64)
        reader_.fail("JSON nested more than 64 deep: flatten it");
    }
    ~Level() { --reader_.depth_; }
    Level(const Level &) = delete;
    Level &operator=(const Level &) = delete;

  private:
    Reader &reader_;
  };

  bool is_at(char c) const { return at_ < text_.size() && text_[at_] == c; }
  char next() { return at_ < text_.size() ? text_[at_++] : '\0'; }
  bool digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_]))
      ++at_;
    return at_ > begin;
  }
  bool skip_word(std::string_view word) {
    const bool yes = text_.substr(at_, word.size()) == word;
    at_ += yes ? word.size() : 0;
    return yes;
  }

  unsigned long code_unit() {
    unsigned long unit = 0;
    for (int i = 0; i < 4; ++i) {
      const char c = next();
      const std::size_t value = std::string_view("0123456789abcdef0123456789ABCDEF").find(c);
      if (value == std::string_view::npos)
        fail("\\u needs four hexadecimal digits");
      unit = unit * 16 + value % 16;
    }
    return unit;
  }

  void escape(std::string &out) {
    constexpr std::string_view letters = "\"\\/bfnrt";
    constexpr std::string_view meanings = "\"\\/\b\f\n\r\t";
    const char c = next();
    const std::size_t simple = letters.find(c);
    if (simple != std::string_view::npos) {
      out += meanings[simple];
      return;
    }
    if (c != 'u')
      fail("an unknown escape in a string of the JSON: write \\\\ for a backslash");
    unsigned long code = code_unit();
    if (code >= 0xD800 && code < 0xDC00 && next() == '\\' && next() == 'u') {
      const unsigned long low = code_unit();
      code = low >= 0xDC00 && low < 0xE000 ? 0x10000 + (code - 0xD800) * 0x400 + (low - 0xDC00) : 0xD800;
    }
    if (code >= 0xD800 && code < 0xE000)
      fail("half a surrogate pair in a string of the JSON: write the character itself");
    const auto put = [&](unsigned long byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (code < 0x80) {
      put(code);
    } else {
      const unsigned long following = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
      put((0xF00UL >> following & 0xFFUL) | code >> (6 * following));
      for (unsigned long i = following; i-- > 0;)
        put(0x80UL | (code >> (6 * i) & 0x3FUL));
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  int depth_ = 0;
};

using Decimals = std::vector<mpq_class>;

Decimals read_decimals(Reader &json, std::vector<std::size_t> &lines) {
  Decimals values;
  json.array([&] {
    if (values.size() == most_rows)
      json.fail("more than 1048576 numbers: give fewer sieves");
    values.push_back(json.decimal());
    lines.push_back(json.line());
  });
  return values;
}

} // namespace

Gradation read_json(std::string_view text) {
  Reader json(text);
  Gradation gradation;
  std::vector<std::size_t> lines;
  std::optional<Decimals> sizes, masses, factors, tolerances;
  mpq_class unit = 1;
  json.object([&](const std::string &key) {
    std::vector<std::size_t> unused;
    if (key == "sizes")
      sizes = read_decimals(json, lines);
    else if (key == "masses")
      masses = read_decimals(json, unused);
    else if (key == "factors")
      factors = read_decimals(json, unused);
    else if (key == "tolerances_percent")
      tolerances = read_decimals(json, unused);
    else if (key == "unit") {
      const std::string name = json.string();
      if (name != "mm" && name != "um" && name != "m" && name != "in")
        json.fail(quoted(name) + " is no unit: write mm, um, m or in");
      unit = name == "in" ? mpq_class(127, 5) : mpq_class(1);
    } else if (key == "id" && json.peek() != '"')
      json.number();
    else
      json.skip_value();
  });
  if (json.peek() != '\0')
    json.fail("something follows the JSON object: give one object");

  if (!sizes || !masses)
    json.fail("\"sizes\" or \"masses\" is missing: give both");
  const std::size_t n = sizes->size();
  if (n < 2)
    json.fail("fewer than two sizes: give at least two");
  if (masses->size() != n || (factors && factors->size() != n) || (tolerances && tolerances->size() != n))
    json.fail("arrays of different lengths: give one number for each size");
  if (factors && !std::all_of(factors->begin(), factors->end(), [](const mpq_class &c) { return c > 0; }))
    json.fail("a factor that is not positive: give positive factors");
  if (tolerances &&
      !std::all_of(tolerances->begin(), tolerances->end(), [](const mpq_class &t) { return t >= 0; }))
    json.fail("a negative tolerance: give 0 or more");

  gradation.openings = *std::move(sizes);
  gradation.masses = *std::move(masses);
  gradation.factors = factors ? *std::move(factors) : Decimals(n, 1);
  if (gradation.openings[0] > gradation.openings[1]) {
    std::reverse(gradation.openings.begin(), gradation.openings.end());
    std::reverse(gradation.masses.begin(), gradation.masses.end());
    std::reverse(gradation.factors.begin(), gradation.factors.end());
    std::reverse(lines.begin(), lines.end());
  }
  for (mpq_class &opening : gradation.openings)
    opening *= unit;
  demand_complete(gradation, lines);
  return gradation;
}

} // namespace mdm_check
