#pragma once
/// \file
/// What must hold for every text that a reader of gradations is given.

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <cstdlib>
#include <string>

namespace mdm::fuzz {

inline void demand(bool holds) {
  if (!holds)
    std::abort();
}

/// The canonical file of g, or nothing where g has numbers of more digits than a file may have.
inline std::string canonical(const Gradation &g, std::string (*write)(const Gradation &)) {
  try {
    return write(g);
  } catch (const InputError &) {
    return {};
  }
}

/// The canonical file of g reads back to g.
inline void check_round_trip(const Gradation &g, std::string (*write)(const Gradation &)) {
  const std::string content = canonical(g, write);
  if (content.empty())
    return;
  const Gradation back = read_gradation(content, "canonical");
  demand(back.unit() == g.unit() && back.sizes() == g.sizes() && back.masses() == g.masses());
  demand(back.tolerances() == g.tolerances() && back.has_factors() == g.has_factors());
  demand(canonical(back, write) == content || write == gradation_json); // JSON has the id in it
}

/// `read` gives a sound gradation or an InputError whose message is UTF-8.
template <typename Read>
void check_reader(Read read) {
  try {
    const Gradation g = read();
    g.check_invariant();
    check_round_trip(g, gradation_csv);
    check_round_trip(g, gradation_json);
  } catch (const InputError &error) {
    const std::string message = error.what();
    demand(is_utf8(message) &&
           (message.starts_with("fuzz") || message.starts_with("--"))); // the file or an option
  }
}

} // namespace mdm::fuzz
