#pragma once
/// \file
/// Particle files, line by line.

#include "gradation/size_range.hpp"
#include "packing/sphere_sample.hpp"
#include "particles/particle_format.hpp"

#include <mdm/gradation/root_size.hpp>

#include <memory>
#include <string>
#include <vector>

namespace mdm {

/// The box of a simulation, in the unit that was asked for.
struct ParticleBox {
  SpaceBox sides;
  std::array<bool, 3> periodic{};
};

/// Takes the particles that a file has.
class ParticleSink {
public:
  virtual ~ParticleSink() = default;
  /// Forget what came so far: another timestep begins.
  virtual void restart() = 0;
  /// A timestep of that number begins.
  virtual void begin_timestep(const Integer &number) {
    static_cast<void>(number);
    restart();
  }
  /// Particles of one diameter > 0, in the unit that was asked for.
  virtual void add(const RootSize &diameter, const Integer &quantity) = 0;
  /// Particles of diameters of which the file gives a range.
  virtual void add(const SizeRange &diameter, const Integer &quantity) = 0;
  /// A particle with its place. \param unit  length of the unit of the place, in the unit that was asked for
  virtual void add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) {
    static_cast<void>(place);
    static_cast<void>(unit);
    add(diameter, 1);
  }
  /// The material of the particles that come next. \throws InputError where materials have no meaning
  virtual void set_material(const std::string &name);
  /// The number of the class of the particle that comes next, where the file says it, as `type` or `class`.
  virtual void set_class(std::uint64_t number) { static_cast<void>(number); }
  /// True if places are wanted: they are not kept elsewhere.
  virtual bool wants_places() const { return false; }
  /// The box of the particles, before they come.
  virtual void set_box(const ParticleBox &box) { static_cast<void>(box); }
};

/// The way a particle file is read. Open choices follow the content, or the custom of the format.
struct ParticleOptions {
  std::optional<ParticleFormat> format;
  /// The meaning of sizes. Open: as their column says, radii in xyzr, else diameters.
  std::optional<SizeMeaning> meaning;
  /// The column of sizes in a dump or CSV, or array in VTK. Open: the one whose name says so.
  std::optional<std::string> size_column;
  /// Unit of the file. Open: what a CSV header says, m in files of LAMMPS, LIGGGHTS and VTK, else `target`.
  std::optional<SizeUnit> unit;
  /// The timestep of a dump to read; of several of that number the last counts. Open: the last.
  std::optional<Integer> timestep;
  /// Hands on each timestep, one after the other; without `timestep`.
  bool every_timestep = false;
  /// The user can say which, for the note about the last.
  bool can_choose_timestep = false;
  /// The unit that diameters are handed on in.
  SizeUnit target = SizeUnit::mm;
  /// The options that say meaning and unit otherwise, for the note about them: `--a and --b`; or none.
  std::string says_otherwise = {};
  /// The option that says `unit`.
  std::string unit_option = "size-unit";
};

/// The format that the beginning of a file tells; nothing where it is that of a gradation, of an answer, or
/// of no file of particles. A last line that is cut off may be left out.
std::optional<ParticleFormat> told_format(std::string_view beginning);

/// What was said and assumed of a file beside its particles.
struct ReadParticles {
  std::vector<std::string> notes;
  std::optional<SizeUnit> unit; ///< of the file; nothing where it states its unit itself
};

class LineReader;
class ParticleSource;

/// Reads a particle file of any format but `answer` whose lines it is given one by one; numbers are decimals
/// as written. Memory does not depend on the length of the file, but for the ids of particles, some 5 bits
/// each where they mostly follow each other, the points of VTK and Kratos, and the text of VTK's XML. All
/// members throw InputError `file:line: what is wrong and what to do`.
class ParticleReader {
public:
  /// \param sink must outlive the reader
  ParticleReader(const std::string &file, ParticleSink &sink, const ParticleOptions &options);
  ~ParticleReader();
  ParticleReader(const ParticleReader &) = delete;
  ParticleReader &operator=(const ParticleReader &) = delete;

  /// Takes the next line, without its LF.
  void line(std::string_view text);
  /// The file is at its end. \throws InputError if something is missing
  void end();

  /// The format; after the end, or after enough lines to tell it.
  std::optional<ParticleFormat> format() const { return format_; }
  /// The unit of the file, unless it states that itself; after the end.
  std::optional<SizeUnit> unit() const;
  /// The assumptions made, for the report; after the end.
  std::vector<std::string> notes() const;

private:
  void begin(ParticleFormat format);
  void hand_on(std::string_view text);

  std::unique_ptr<ParticleSource> source_;
  std::unique_ptr<LineReader> reader_; ///< null until the format is known
  std::optional<ParticleFormat> format_;
  std::vector<std::string> pending_; ///< lines that came before
};

} // namespace mdm
