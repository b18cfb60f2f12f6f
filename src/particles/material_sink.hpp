#pragma once
/// \file
/// The particles of a file as a gradation of several materials describes them.

#include "particles/description_sink.hpp"

#include <mdm/text/error.hpp>

namespace mdm {

/// Adds particles, each in the classes of its material, to a description.
class MaterialSink : public ParticleSink {
public:
  /// \param empty  of a gradation of several materials
  explicit MaterialSink(Description empty) : empty_(std::move(empty)), description_(empty_) {}

  void restart() override { description_ = empty_; }
  void set_material(const std::string &name) override { material_ = name; }
  void add(const RootSize &diameter, const Integer &quantity) override { add_any(diameter, quantity); }
  void add(const SizeRange &diameter, const Integer &quantity) override { add_any(diameter, quantity); }

  const Description &description() const { return description_; }

private:
  template <class Size>
  void add_any(const Size &diameter, const Integer &quantity) {
    if (!material_)
      throw InputError(
          "the particles have no materials, and the gradation has several: give CSV with a column "
          "material, such as size_mm,quantity,material");
    description_.add_of(*material_, diameter, quantity);
  }

  Description empty_, description_;
  std::optional<std::string> material_; ///< of the next particles
};

} // namespace mdm
