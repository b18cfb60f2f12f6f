#include "files/deposit_journal.hpp"

#include "files/paths.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

DepositJournal::DepositJournal(const std::string &folder, const PackingTerms &terms)
    : file_(folder + "/figure9.journal.jsonl"), terms_(terms.text()) {
  file_.read([this](std::string_view line, std::size_t number) { take(line, number); }, no_deposit_line);
  if (!has_terms_)
    file_.add(terms_line(terms_));
}

const DepositFacts *DepositJournal::find(const std::string &key) const {
  const auto found = deposits_.find(key);
  return found == deposits_.end() ? nullptr : &found->second;
}

void DepositJournal::add(const KeptDeposit &deposit) {
  file_.add(deposit_line(deposit));
}

void DepositJournal::take(std::string_view line, std::size_t number) {
  const std::string where = line_name(file_.path(), number);
  if (!has_terms_) {
    check_terms(line, where);
    has_terms_ = true;
    return;
  }
  KeptDeposit deposit = in_file(where, [line] { return read_deposit_line(line); });
  deposits_[deposit.key] = std::move(deposit.facts);
}

void DepositJournal::check_terms(std::string_view line, const std::string &where) const {
  const std::string terms = in_file(where, [line] { return read_terms_line(line); });
  if (terms != terms_)
    throw file_error(where, "has the deposits of a study with " + in_quotes(terms) + ", not " +
                                in_quotes(terms_) + ": ask for the same, remove the file, or name another " +
                                option("out"));
}

} // namespace mdm
