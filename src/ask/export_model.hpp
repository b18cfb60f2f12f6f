#pragma once
/// \file
/// The models that mdm export writes, and the files around them.

#include "ask/export_space.hpp"

#include <functional>
#include <string>
#include <vector>

namespace mdm {

/// An engine that there is a model for.
struct ModelEngine;

/// A file of a model, with what writes it.
struct ModelFile {
  std::string path;
  std::function<void(const Sink &)> write;
};

/// Writes the files, all or none.
using WriteFiles = std::function<void(const std::vector<ModelFile> &)>;
/// The content of the file of materials.
using ReadMaterial = std::function<std::string(const std::string &path)>;

/// Writes a model, and beside it the files that it reads.
class ModelWriter {
public:
  /// \param model, to, out the values of --model, --to and -o
  /// \throws InputError if one of them does not go with a model
  ModelWriter(const std::string &model, const std::string &to, std::string out);

  /// The files beside the model, the particles first.
  std::vector<std::string> other_files() const;

  /// The model as it is asked for, with the start.
  SettleModel model(const ExportTexts &c, const ExportedParticles &found, const Placement &start,
                    const ReadMaterial &read) const;

  /// The script first.
  void write(const SettleModel &model, const Placement &start, const WriteFiles &write) const;

private:
  const ModelEngine *engine_;
  const char *plane_; ///< what the engine reads as a mesh, where it does: the lid, or each wall
  std::string out_;
};

} // namespace mdm
