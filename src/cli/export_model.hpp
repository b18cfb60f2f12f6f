#pragma once
/// \file
/// The models that mdm export writes, and the files around them.

#include "particles/settle_model.hpp"

#include <string>

namespace mdm::cli {

/// An engine that there is a model for.
struct ModelEngine;

/// Writes a model, and beside it the particles that it reads.
class ModelWriter {
public:
  /// \param model, to, out the values of --model, --to and -o
  /// \param has_start there is one for every engine
  /// \throws InputError if one of them does not go with a model
  ModelWriter(const std::string &model, const std::string &to, std::string out, bool has_start);

  /// The file of the particles; empty if the engine inserts them itself.
  const std::string &particles() const { return particles_; }

  /// The model in the box of the start; without one in a box on the floor that insertion has room in.
  /// \throws InputError if the largest particle does not fit into it
  SettleModel model(const ParticleSet &set, const std::optional<Placement> &start,
                    const std::optional<Footprint> &floor) const;

  /// \pre there is a start if particles() is not empty
  void write(const SettleModel &model, const std::optional<Placement> &start) const;

private:
  const ModelEngine *engine_;
  std::string out_, particles_;
};

} // namespace mdm::cli
