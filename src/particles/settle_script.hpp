#pragma once
// Lines that the models of all engines share.

#include "particles/settle_model.hpp"

#include <mdm/text/error.hpp>

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

  /// The model's purpose, the command that runs it, and its assumptions; as comments.
  std::string head(const char *engine, const char *command, const char *more_steps,
                   const char *engine_options) const;

  /// `p p f` or `f f f`: the sides of the box in the words of LAMMPS.
  const char *boundary() const { return sides == Sides::periodic ? "p p f" : "f f f"; }

  /// The command that verifies the model's result; as comments.
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
  Sides sides;
  Integer particles;
};

} // namespace mdm
