#pragma once
/// \file
/// The models that mdm export writes, and the files around them.

#include "cli/export_space.hpp"

#include <string>
#include <vector>

namespace mdm::cli {

/// An engine that there is a model for.
struct ModelEngine;

/// Writes a model, and beside it the files that it reads.
class ModelWriter {
public:
  /// \param model, to, out the values of --model, --to and -o
  /// \throws InputError if one of them does not go with a model
  ModelWriter(const std::string &model, const std::string &to, std::string out);

  /// The files beside the model, the particles first.
  std::vector<std::string> other_files() const;

  /// The model as it is asked for, with the start.
  SettleModel model(const ExportCommand &c, const ExportedParticles &found, const Placement &start) const;

  void write(const SettleModel &model, const Placement &start) const;

private:
  const ModelEngine *engine_;
  std::string out_;
};

} // namespace mdm::cli
