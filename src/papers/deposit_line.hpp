#pragma once
/// \file
/// The lines of the journal of deposits.

#include "papers/packing_study.hpp"

namespace mdm {

/// What a line keeps.
struct KeptDeposit {
  std::string key; ///< DepositQuestion::key()
  DepositFacts facts;
};

/// The message about a line that is none of a journal.
inline constexpr const char *no_deposit_line =
    "is no line of a journal of mdm study: remove the file, or name "
    "another --out";

/// The first line of a journal: PackingTerms::text().
std::string terms_line(const std::string &terms);
/// Reads it. \throws InputError if it is anything else
std::string read_terms_line(std::string_view line);

/// A JSON object without a line end.
std::string deposit_line(const KeptDeposit &deposit);

/// Reads one. \throws InputError if it is anything else
KeptDeposit read_deposit_line(std::string_view line);

} // namespace mdm
