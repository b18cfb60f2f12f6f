#pragma once
// Lines that the models of all engines share.

#include "particles/settle_model.hpp"

#include <mdm/text/error.hpp>

#include <initializer_list>
#include <utility>

namespace mdm {

/// The name of a file that is a word in any script. \throws InputError if it has other characters
std::string file_word(const std::string &name);

/// Text for a comment or a message of a script: ASCII without signs that are replaced or end it.
std::string comment_word(const std::string &text);

/// A number with six digits, as it stands in scripts.
std::string digits6(double x);
/// With 17, from which the same double is read.
std::string digits17(double x);

/// `variable steps index 300      # at most`, of LIGGGHTS and LAMMPS.
std::string script_setting(const char *name, const std::string &value, const std::string &meaning);

/// The text with each `@name@` replaced.
std::string filled(std::string text,
                   std::initializer_list<std::pair<const char *, std::string>> replacements);

/// How a model is run, for its first lines.
struct RunCommands {
  const char *engine, *run, *fewer_steps, *go_on, *in_parallel;
  const char *verify_options;
};

/// The model with its numbers.
struct SettleScript {
  /// \param ending of the file that is written at the end
  SettleScript(const SettleModel &m, const char *ending);

  /// The model's purpose, the commands that run it, and its assumptions; as comments.
  /// \param contacts  the table of its contacts
  std::string head(const RunCommands &commands, const std::string &contacts) const;

  /// The command that verifies the model's result; as comments.
  std::string verification(const char *engine_options) const;

  bool has_lid() const { return model.has_lid(); }
  bool has_six_walls() const { return model.has_six_walls(); }
  bool is_sheared() const { return model.shear.has_value(); }
  /// Of the grains while they settle and are compacted, and of walls; where classes have their own friction
  /// and nothing is asked for, it is the most that any has.
  double friction_while_filling() const;
  /// True if classes keep their own friction while they settle, and it is lowered where it hinders
  /// compaction.
  bool keeps_friction() const { return !model.materials.empty() && !model.friction_while_filling; }
  bool is_frictionless() const;
  bool all_resist_rolling() const;
  /// True if it is not certain that grains carry each other at the void ratio that is asked for.
  bool seeks_jamming() const { return !has_lid() && model.target && model.target->void_ratio; }
  /// True if grains have another friction at the end than while they settle.
  bool changes_friction() const;
  std::size_t types() const { return model.types_of_classes ? set.classes.size() + 1 : 1; }
  /// The material of a type, from 1 on.
  GrainMaterial material(std::size_t type) const;

  const SettleModel &model;
  const ParticleSet &set;
  ModelBox box;
  Settling physics;
  std::string name, result; ///< how the names of files begin, and of those that are written at the end
  std::string dump;
  Integer particles;
};

} // namespace mdm
