#include "papers/statement.hpp"

#include "text/text_table.hpp"

#include <fmt/core.h>

namespace mdm {

const char *name(Holds holds) {
  switch (holds) {
  case Holds::yes:
    return "holds";
  case Holds::partly:
    return "holds in part";
  case Holds::no:
    return "does not";
  default:
    return "cannot be decided";
  }
}

Holds holds_in(std::size_t some, std::size_t all) {
  return all == 0 ? Holds::open : some == all ? Holds::yes : some == 0 ? Holds::no : Holds::partly;
}

std::string statements_table(const std::vector<Statement> &statements) {
  std::string text = "statement,where,found,holds,command\n";
  for (const Statement &s : statements)
    text += fmt::format("{},{},{},{},{}\n", csv_field(s.statement), csv_field(s.where), csv_field(s.found),
                        name(s.holds), csv_field(s.command));
  return text;
}

} // namespace mdm
