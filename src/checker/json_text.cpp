#include "json_text.hpp"

#include <algorithm>
#include <charconv>
#include <set>

namespace mdm::checker {

char JsonText::peek() {
  rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
  return rest_.empty() ? '\0' : rest_[0];
}

bool JsonText::take(char c) {
  const bool yes = peek() == c;
  rest_.remove_prefix(yes ? 1 : 0);
  return yes;
}

void JsonText::demand(char c) {
  if (!take(c))
    throw Malformed(rest_, quoted(rest_) + " in the JSON, where '" + c + "' belongs: put it there");
}

void JsonText::sequence(char open, char close, const std::function<void()> &element) {
  demand(open);
  if (!take(close)) {
    do
      element();
    while (take(','));
    demand(close);
  }
}

void JsonText::object(const std::function<void(const std::string &)> &member) {
  std::set<std::string> keys;
  sequence('{', '}', [&] {
    const auto [key, is_new] = keys.insert(string());
    demand_form(is_new, rest_, "is twice in an object of the JSON: drop one", *key);
    demand(':');
    member(*key);
  });
}

/// The next character of a string, whatever it is; 0 at the end.
char JsonText::next() {
  const char c = rest_.empty() ? '\0' : rest_[0];
  rest_.remove_prefix(rest_.empty() ? 0 : 1);
  return c;
}

std::string JsonText::string() {
  demand('"');
  std::string out;
  for (char c = next(); c != '"'; c = next()) {
    demand_form(static_cast<unsigned char>(c) >= 0x20, rest_, "a string of the JSON is not closed: close it");
    out += c == '\\' ? escaped() : std::string{c};
  }
  return out;
}
/// The character of an escape, in UTF-8.
std::string JsonText::escaped() {
  constexpr std::string_view letters = "\"\\/bfnrt", meanings = "\"\\/\b\f\n\r\t";
  const char c = next();
  const std::size_t simple = letters.find(c);
  if (simple != std::string_view::npos)
    return {meanings[simple]};
  demand_form(c == 'u', rest_, "an unknown escape in a string of the JSON: write \\\\ for a backslash");
  std::uint32_t code = code_unit();
  if (code >= 0xD800 && code < 0xDC00 && next() == '\\' && next() == 'u') {
    const std::uint32_t low = code_unit();
    code = low >= 0xDC00 && low < 0xE000 ? 0x10000 + (code - 0xD800) * 0x400 + (low - 0xDC00) : code;
  }
  demand_form(code < 0xD800 || code >= 0xE000, rest_, "half a surrogate pair: write the character itself");
  const std::uint32_t following = code < 0x80 ? 0 : code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
  std::string out{
      static_cast<char>((following == 0 ? 0 : 0xF00U >> (following + 1) & 0xFFU) | code >> (6 * following))};
  for (std::uint32_t i = following; i-- > 0;)
    out += static_cast<char>(0x80U | (code >> (6 * i) & 0x3FU));
  return out;
}

std::uint32_t JsonText::code_unit() {
  std::uint32_t unit = 0;
  const std::string_view digits = rest_.substr(0, 4);
  const char *const end = std::from_chars(digits.data(), digits.data() + digits.size(), unit, 16).ptr;
  demand_form(end == rest_.data() + 4, rest_, "\\u needs four hexadecimal digits: write them");
  rest_.remove_prefix(4);
  return unit;
}

std::string_view JsonText::number() {
  peek();
  const std::string_view begin = rest_;
  const Decimal d = split_decimal(rest_);
  demand_form(d.sign != "+" && !d.whole.empty() && (d.whole.size() == 1 || d.whole[0] != '0') &&
                  d.point.empty() == d.fraction.empty() && d.e.empty() == d.exponent.empty(),
              rest_, "is no value of JSON: write a string or a number", rest_);
  rest_ = d.rest;
  return begin.substr(0, begin.size() - rest_.size());
}

mpq_class JsonText::decimal() {
  if (peek() == '"')
    return read_decimal(string(), rest_);
  const std::string_view written = number();
  const mpq_class value = read_decimal(written, written);
  demand_form(abs(value) < power(2, 1024), written,
              "is beyond the range of JSON numbers: write it as a string", written);
  return value;
}

void JsonText::skip(unsigned depth) {
  constexpr unsigned deepest = 100;
  demand_form(depth < deepest, rest_, "lists in lists, too deep for JSON of this program: give another file");
  switch (peek()) {
  case '{':
    return object([&](const std::string &) { skip(depth + 1); });
  case '[':
    return sequence('[', ']', [&] { skip(depth + 1); });
  case '"':
    string();
    return;
  default:
    for (const std::string_view word : {"null", "true", "false"})
      if (rest_.starts_with(word)) {
        rest_.remove_prefix(word.size());
        return;
      }
    number();
  }
}

} // namespace mdm::checker
