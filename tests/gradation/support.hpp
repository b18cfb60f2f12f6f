#pragma once
/// \file
/// What the tests of this folder share.

#include "../catch.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

namespace mdm::test {

/// Numbers separated by spaces.
inline std::string text(const std::vector<Rational> &numbers) {
  std::string all;
  for (const Rational &number : numbers)
    all += (all.empty() ? "" : " ") + exact_decimal(number).value_or(to_string(number));
  return all;
}

inline Gradation read(const std::string &content) {
  return read_gradation(content, "dir/sand.csv");
}

/// The message of what `action` throws as InputError; a failure if it does not.
template <typename Action>
std::string message_of(Action action) {
  try {
    action();
  } catch (const InputError &error) {
    CHECK(is_utf8(error.what()));
    return error.what();
  }
  FAIL("no InputError");
  return {};
}

/// The message that refuses a file.
inline std::string refusal(const std::string &content) {
  INFO(content.substr(0, 200));
  return message_of([&content] { read_gradation(content, "sand.csv"); });
}

inline bool contains(const std::string &message, const std::string &part) {
  UNSCOPED_INFO("message: " << message << "\nexpected: " << part);
  return message.find(part) != std::string::npos;
}

/// Equal in all that a file holds.
inline bool equal(const Gradation &a, const Gradation &b) {
  const auto factors = [](const Gradation &g) {
    std::vector<Rational> column;
    for (std::size_t j = 0; j < g.classes(); ++j)
      column.push_back(g.factor(j));
    return column;
  };
  return a.unit() == b.unit() && a.root() == b.root() && a.powers() == b.powers() &&
         a.masses() == b.masses() && a.tolerances() == b.tolerances() && a.has_factors() == b.has_factors() &&
         factors(a) == factors(b);
}

/// True where a note of the reading has that in it.
inline bool has_note(const Gradation &g, const std::string &part) {
  std::string all;
  for (const std::string &note : g.notes())
    all += note + "\n";
  return contains(all, part);
}

} // namespace mdm::test
