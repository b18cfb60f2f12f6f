/// \file
/// libFuzzer target: particle files of every format, and answers.

#include "answer/answer_sample.hpp"
#include "gradation_property.hpp"
#include "particles/gsd.hpp"
#include "particles/particle_reader.hpp"

#include <cmath>

namespace {

using namespace mdm;

Gradation gradation() {
  Gradation::Data d;
  d.sizes = {0, 1, 2, 3};
  d.masses = {1, 0, 2, 0};
  return Gradation(std::move(d));
}

/// Counts on its own what the description is given.
class Counter : public ParticleSink {
public:
  void restart() override {
    description_ = Description(gradation());
    count_ = 0;
  }
  void add(const RootSize &diameter, const Integer &quantity) override {
    fuzz::demand(diameter.power > 0 && quantity > 0);
    description_.add(diameter, quantity);
    count_ += quantity;
  }
  void add(const SizeRange &diameter, const Integer &quantity) override {
    fuzz::demand(diameter.lo >= 0 && diameter.hi >= diameter.lo && diameter.hi > 0 && quantity > 0);
    description_.add(diameter, quantity);
    count_ += quantity;
  }
  void add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) override {
    SphereSample sample;
    sample.add(place, unit, drawn_size(diameter), 0);
    fuzz::demand(std::abs(sample.centre(0)[2]) <= 1e60);
    fuzz::demand(cut_double(sample.exact_coordinate(0, 2)) == sample.centre(0)[2]);
    add(diameter, 1);
  }
  bool wants_places() const override { return true; }
  void set_box(const ParticleBox &box) override { fuzz::demand(!box.sides.is_empty()); }
  void check() const {
    fuzz::demand(count_ > 0 && description_.particles() == count_);
    const MatchError e = description_.error();
    Rational least = 0, most = 0;
    for (const Interval &share : e.shares) {
      least += share.lo;
      most += share.hi;
    }
    fuzz::demand(most == 0 || (least <= 1 && most >= 1)); // sizes may be ranges
  }

private:
  Description description_{gradation()};
  Integer count_ = 0;
};

/// Runs `read`, which may throw an InputError with a message that names the file.
template <typename Read>
void check(Read read) {
  try {
    read();
  } catch (const InputError &error) {
    fuzz::demand(is_utf8(error.what()) && std::string(error.what()).starts_with("fuzz"));
  }
}

void read_particles(std::string_view content, const ParticleOptions &options) {
  Counter counter;
  ParticleReader reader("fuzz", counter, options);
  while (!content.empty()) {
    reader.line(content.substr(0, content.find('\n')));
    content.remove_prefix(std::min(content.find('\n'), content.size() - 1) + 1);
  }
  reader.end();
  counter.check();
}

void read_answer_of(std::string_view content) {
  const AnswerSample answer = read_answer(content, "fuzz");
  if (answer.scale_power == 1)
    describe_answer(answer, gradation(), {}, 0).description.error();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  const std::string content(reinterpret_cast<const char *>(data), size);
  ParticleOptions options;
  check([&content, &options] { read_particles(content, options); });
  for (const ParticleFormat format :
       {ParticleFormat::csv, ParticleFormat::xyzr, ParticleFormat::lammps_data, ParticleFormat::lammps_dump,
        ParticleFormat::vtk, ParticleFormat::diameters, ParticleFormat::liggghts_insertion,
        ParticleFormat::mercurydpm, ParticleFormat::extxyz, ParticleFormat::esys, ParticleFormat::lethe,
        ParticleFormat::kratos, ParticleFormat::dem_engine, ParticleFormat::musen, ParticleFormat::phasicflow,
        ParticleFormat::vtp}) {
    options.format = format;
    check([&content, &options] { read_particles(content, options); });
  }
  check([&content] { read_answer_of(content); });
  check([&content] {
    Counter counter;
    read_gsd(content, "fuzz", counter, {});
    counter.check();
  });
  return 0;
}
