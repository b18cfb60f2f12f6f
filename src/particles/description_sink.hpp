#pragma once
/// \file
/// The particles of a file as a gradation describes them.

#include "gradation/description.hpp"
#include "particles/particle_reader.hpp"

namespace mdm {

/// Adds particles to a description.
class DescriptionSink : public ParticleSink {
public:
  explicit DescriptionSink(Description empty) : empty_(std::move(empty)), description_(empty_) {}

  void restart() override { description_ = empty_; }
  void add(const RootSize &diameter, const Integer &quantity) override {
    description_.add(diameter, quantity);
  }
  void add(const SizeRange &diameter, const Integer &quantity) override {
    description_.add(diameter, quantity);
  }

  const Description &description() const { return description_; }

private:
  Description empty_, description_;
};

} // namespace mdm
