#pragma once
/// \file
/// The parts that all readers of particle files share.

#include "particles/particle_ids.hpp"
#include "particles/particle_reader.hpp"
#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>

#include <functional>

namespace mdm {

/// A unit of lengths that a file states.
struct StatedUnit {
  std::string_view name; ///< a literal
  Rational in_mm;
};

/// A reader's place in its file, and the receiver of its particles.
class ParticleSource {
public:
  ParticleSource(std::string file, ParticleSink &sink, const ParticleOptions &options);

  const std::string &file() const { return file_; }
  const ParticleOptions &options() const { return options_; }
  void next_line() { ++line_; }
  void set_line(std::uint64_t number) { line_ = number; }
  std::uint64_t line() const { return line_; }

  /// Throws the InputError `file:line: what`.
  [[noreturn]] void refuse(const std::string &what) const;

  /// The meaning of sizes and their unit, where neither the user nor the file did say.
  void set_defaults(SizeMeaning meaning, SizeUnit unit);
  /// The unit that the file states in these words. \throws InputError if the user said another one, or there
  /// are particles already, in another one
  void take_unit(const StatedUnit &unit, std::string_view words);
  SizeMeaning meaning() const { return meaning_; }
  /// Nothing where the file states its unit.
  std::optional<SizeUnit> unit() const { return stated_ ? std::nullopt : std::optional(unit_); }

  /// A function that reads a size; `point` is the decimal sign.
  using ReadSize = std::function<RootSize(std::string_view text, char point)>;
  static RootSize read_decimal(std::string_view text, char point) { return {parse_decimal(text, point)}; }
  /// A particle whose size is written as `text`.
  void particle(std::string_view text, const Integer &quantity = 1, char point = '.',
                const ReadSize &read = read_decimal);
  /// \throws InputError if the text is no size
  void check_size(std::string_view text, char point, const ReadSize &read) const {
    diameter(text, point, read);
  }
  /// The exact number. \throws InputError that says what it is if it is none
  Rational number(const char *what, std::string_view text, char point = '.') const;
  /// A particle with its place. \throws InputError if a coordinate is no number
  void particle_at(const SphereSample::Place &place, std::string_view size, char point = '.',
                   const ReadSize &read = read_decimal);
  /// \throws InputError if a word is no number
  void check_number(std::string_view word) const;
  /// The place of the one column of that name. \throws InputError that shows the example if there is none, or
  /// several
  std::size_t column(const std::vector<std::string> &names, std::string_view name, const char *example) const;
  /// \throws InputError if a coordinate is no decimal, such as nan
  void check_place(const SphereSample::Place &place) const;
  /// \throws InputError if a particle's radius is not half the diameter that stands beside it
  void check_agree(std::string_view radius, std::string_view diameter) const;
  /// \throws InputError if a particle of the timestep has this id already, or it is no whole number
  void take_id(std::string_view id);
  bool wants_places() const { return sink_.wants_places(); }
  /// The material of the next particles. \throws InputError where materials have no meaning
  void take_material(const std::string &name);
  /// The class of the next particle; what is no whole number, such as a name, is none.
  void take_class(std::string_view number);
  /// The lower and upper bounds of the box along each axis. \throws InputError if they are none
  void set_box(const std::array<std::array<std::string, 2>, 3> &bounds, const std::array<bool, 3> &periodic);
  /// The box is tilted: mdm knows boxes along the axes alone. The places that follow are left out, with a
  /// note.
  void leave_out_places();
  /// Particles whose size is in [lo, hi], and above `lower` if that is no empty text.
  void particle_between(std::string_view lo, std::string_view hi, std::string_view lower,
                        const Integer &quantity, char point);
  /// Forgets all particles so far: another timestep begins.
  void begin_timestep(const Integer &number);

  /// \throws InputError if there was no particle
  void check_some() const;
  /// Takes the number of particles from a title that mdm export writes.
  void take_title(std::string_view line);
  /// \throws InputError if there are not as many particles as such a title says
  void check_count() const;

  void note(const std::string &text) { notes_.push_back(text); }
  const std::vector<std::string> &notes() const { return notes_; }
  /// The way sizes were taken, for a note.
  std::string size_note() const;

private:
  void count(const Integer &quantity) {
    any_ = true;
    if (stated_count_)
      count_ += quantity;
  }
  RootSize diameter(std::string_view text, char point, const ReadSize &read) const;

  std::string file_;
  ParticleSink &sink_;
  ParticleOptions options_;
  std::uint64_t line_ = 0;
  SizeMeaning meaning_ = SizeMeaning::diameter;
  SizeUnit unit_ = SizeUnit::mm;
  Rational length_ = 1; ///< of the file's unit in the asked one
  Rational factor_ = 1; ///< from the file's number to the diameter in the asked unit
  std::optional<StatedUnit> stated_;
  ParticleIds ids_;
  bool any_ = false;
  std::optional<Integer> stated_count_;
  Integer count_ = 0;      ///< of particles, where one is stated
  bool is_tilted_ = false; ///< the box that was read last
  std::vector<std::string> notes_;
};

/// The lines of one format.
class LineReader {
public:
  virtual ~LineReader() = default;
  /// Takes a line without its end, CR included.
  virtual void line(std::string_view text) = 0;
  /// \throws InputError if the file must not end here
  virtual void end() = 0;
};

std::unique_ptr<LineReader> read_particle_csv(ParticleSource &source);
std::unique_ptr<LineReader> read_xyzr(ParticleSource &source);
std::unique_ptr<LineReader> read_diameters(ParticleSource &source);
std::unique_ptr<LineReader> read_lammps_data(ParticleSource &source);
std::unique_ptr<LineReader> read_dump(ParticleSource &source);
std::unique_ptr<LineReader> read_liggghts_insertion(ParticleSource &source);
std::unique_ptr<LineReader> read_mercurydpm(ParticleSource &source);
std::unique_ptr<LineReader> read_vtk(ParticleSource &source);
std::unique_ptr<LineReader> read_extxyz(ParticleSource &source);
std::unique_ptr<LineReader> read_esys(ParticleSource &source);
std::unique_ptr<LineReader> read_lethe(ParticleSource &source);
std::unique_ptr<LineReader> read_kratos(ParticleSource &source);
std::unique_ptr<LineReader> read_dem_engine(ParticleSource &source);
std::unique_ptr<LineReader> read_musen(ParticleSource &source);
std::unique_ptr<LineReader> read_phasicflow(ParticleSource &source);
std::unique_ptr<LineReader> read_vtp(ParticleSource &source);

/// Moves the first word of `rest`, separated by spaces and tabs, out of it; empty at the end.
std::string_view take_word(std::string_view &rest);

/// The words of a line, not more than max_fields + 1 of them.
void split_words(std::string_view line, std::vector<std::string_view> &words);

/// True for a decimal such as `-1.5e-3`, whatever its length.
bool is_number(std::string_view text);

/// True for a number that is 0, as `0`, `-0.0` or `0.000e+00`.
bool is_zero_number(std::string_view text);

/// A count that a file gives; at most 2^62.
std::optional<std::uint64_t> parse_count(std::string_view text);

} // namespace mdm
