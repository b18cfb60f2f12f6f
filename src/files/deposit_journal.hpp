#pragma once
/// \file
/// The deposits of a study that an earlier run made.

#include "files/journal_file.hpp"
#include "papers/deposit_line.hpp"

#include <map>
#include <string>
#include <string_view>

namespace mdm {

/// The deposits that were made so far: a line that says their terms, then a line a deposit.
class DepositJournal {
public:
  /// \throws InputError naming the line, or where the deposits have other terms
  DepositJournal(const std::string &folder, const PackingTerms &terms);

  /// Null for one that was not made yet.
  const DepositFacts *find(const std::string &key) const;
  void add(const KeptDeposit &deposit);

private:
  void take(std::string_view line, std::size_t number);
  void check_terms(std::string_view line, const std::string &where) const;

  JournalFile file_;
  std::string terms_;
  bool has_terms_ = false;
  std::map<std::string, DepositFacts> deposits_;
};

} // namespace mdm
