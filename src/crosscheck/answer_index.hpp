#pragma once
/// \file
/// The answers of a file, by the gradation that they are for.

#include "crosscheck/other_answer.hpp"

#include <mdm/crosscheck/crosscheck.hpp>

#include <atomic>
#include <functional>
#include <unordered_map>

namespace mdm {

/// Answers by id and by setting: the value of the label `by`, or one setting for all without it. The settings
/// are those of the answers that could be read, in the order of the file. Those of a journal are answers to
/// the gradation that was asked alone (asked_digest), not to what has its id since.
class AnswerIndex {
public:
  /// \throws InputError if no answer has the label
  explicit AnswerIndex(std::vector<OtherAnswer> answers, std::optional<std::string> by = std::nullopt);

  /// Judges the answers to the gradation: rows by setting, each in the order of the file; `no-answer` for a
  /// setting that has none. Several threads may call it.
  /// \param seen  called for each answer that is judged, if it is there
  std::vector<CrosscheckRow> judge(const Crosscheck &problem, const Rational &size_tolerance,
                                   const std::function<void(const OtherAnswer &)> &seen = {}) const;

  /// Rows of the answers that have no id that could be read.
  std::vector<CrosscheckRow> rows_without_id() const;

  /// Notes after the last gradation: ids that came in no judge(), ids with several answers,
  /// answers to gradations that were corrected since.
  std::vector<std::string> notes() const;

private:
  struct Entry {
    std::vector<std::size_t> answers;       ///< positions
    mutable std::atomic<bool> asked{false}; ///< a gradation had this id
  };

  std::string setting_of(const OtherAnswer &answer) const;
  std::size_t place(const std::string &setting) const;
  std::string labels() const;
  bool is_outdated(const Entry &entry, std::size_t i) const;
  bool has_several(const Entry &entry) const;

  std::vector<OtherAnswer> answers_;
  std::vector<std::optional<std::string>> asked_;    ///< digest, by position
  mutable std::vector<std::atomic<bool>> is_judged_; ///< by position
  std::optional<std::string> by_;
  std::unordered_map<std::string, Entry> by_id_;
  std::vector<std::size_t> without_id_;
  std::vector<std::string> settings_;
};

} // namespace mdm
