#pragma once
/// \file
/// The one reader of answers in JSON.

#include "answer/answer_sample.hpp"
#include "answer/answer_schema.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <nlohmann/json.hpp>

namespace mdm {

/// Quantities and sizes as an answer states them, not compared with its masses and scale.
struct StatedParticles {
  struct Class {
    Integer quantity;
    std::optional<std::pair<Rational, Rational>> size; ///< lo and hi; nothing where there is none
    /// Of its openings, as decimals; nothing where it does not say them.
    std::optional<std::pair<Rational, Rational>> bounds;
  };
  std::vector<Class> classes; ///< all of the answer's, empty ones included; none where it has no match
  SizeUnit unit = SizeUnit::mm;
  std::optional<Integer> particles; ///< that it says it has
};

/// Reads the members of an mdm-answer-1. All throw an InputError that begins with the key.
class AnswerReader {
public:
  /// \param answer what json_tree has made of the answer; it must outlive the reader
  explicit AnswerReader(const nlohmann::json &answer) : answer_(answer) {}

  /// The whole of it, for read_answer.
  AnswerSample sample();
  /// The classes with the shares of the match, for answer_gradation.
  Gradation gradation(PhiReading phi);
  /// The particles' curve, for answer_curve.
  Gradation curve();
  /// The particles alone; what does not concern them is not looked at, not even the schema.
  StatedParticles particles() const;

private:
  using Json = nlohmann::json;

  const Json &array(const char *key) const;
  const Json *achieved_shares(std::size_t classes) const;
  ShareErrors errors_of(const Json &classes, const Json &achieved) const;
  SizeUnit unit() const;
  RootSize opening(const Json &from, const char *key, const char *power_key, const std::string &place) const;
  void add_class(AnswerSample &sample, const Json &from, std::size_t j, const Json *achieved) const;

  const Json &answer_;
  unsigned size_power_ = 1;
};

} // namespace mdm
