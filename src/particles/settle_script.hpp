#pragma once
// What the models of all engines have in common.

#include <mdm/error.hpp>
#include <mdm/particles/settle_model.hpp>

namespace mdm {

/// The name of a file that is a word in any script. \throws InputError if it has other characters
std::string file_word(const std::string &name);

/// Text for a comment or a message of a script: ASCII without signs that are replaced or end it.
std::string comment_word(const std::string &text);

/// `class 2 (0.00015, 0.0003]`, in m.
std::string class_name(const ParticleClass &c);

/// The model with its numbers.
struct SettleScript {
  explicit SettleScript(const SettleModel &m);

  /// What it is, how to run it, and what it assumes; as comments.
  std::string head(const char *engine, const char *command, const char *more_steps,
                   const char *engine_options) const;

  /// How to verify what it leaves; as comments.
  std::string verification(const char *engine_options) const;

  const ParticleSet &set;
  ModelBox box;
  Settling physics;
  double young, poisson;
  std::string dump;
  std::uint64_t seed;
  std::optional<std::string> verify_options;
  std::string question;
  bool is_softer; ///< than rock
  Integer particles;
};

} // namespace mdm
