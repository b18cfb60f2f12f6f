#pragma once
/// \file
/// Files of particles, in all formats, and the gradations that commands take from files of any kind.

#include "ask/reading_options.hpp"
#include "files/file_lines.hpp"
#include "particles/particle_reader.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <string>
#include <vector>

namespace mdm {

/// True for a file that begins as files of particles do, or is a set of mdm generate; standard input is not
/// looked at.
bool is_sample_file(const std::string &path);
/// True for a content that begins so, such as that of standard input.
bool is_sample(const std::string &content);

/// True for a file of GSD; standard input is not looked at.
bool is_gsd_file(const std::string &path);

/// True for a file that begins as sets of mdm generate do; standard input is not looked at.
bool is_generated_file(const std::string &path);

/// True for a file of JSON that is no such set, and for standard input.
bool is_answer_file(const std::string &path);

/// Refuses a line, or an answer, that is longer than lines may be.
[[noreturn]] void refuse_long(const std::string &where, const char *what);

/// The lines of a file of particles that are taken at once.
inline constexpr std::size_t lines_at_once = 4096;

/// Hands the particles on of a file of which the first lines were taken already.
/// \throws InputError naming the line
ReadParticles read_lines(std::vector<FileLines::Line> first, FileLines &rest, const std::string &path,
                         const ParticleOptions &options, ParticleSink &sink, bool quiet);

/// Hands the particles of a file of GSD on, which is read as a whole.
/// \throws InputError naming the file
ReadParticles read_gsd_file(const std::string &path, const ParticleOptions &options, ParticleSink &sink);

/// Hands the particles of a file on: of any format but an answer of mdm solve in JSON. Notes say what was
/// assumed. Cost: the file line by line; a set in JSON is read as a whole.
/// \throws InputError naming the file
std::vector<std::string> read_sample_file(const std::string &path, const ParticleOptions &options,
                                          ParticleSink &sink, bool quiet);

/// Refuses a file that holds particles or a set where a gradation is wanted, and says what makes one of it.
void refuse_sample(const std::string &path);

/// The gradation that a file is, or that a set of mdm generate or a sample of particles in it has.
/// \throws InputError naming the file
UnderstoodGradation any_gradation(const std::string &path, const ReadingTexts &reading, bool quiet,
                                  PhiReading phi = PhiReading::exact);
/// The same where it is asked what passes between its sieves: of a sample no particle is between two sizes.
UnderstoodGradation any_curve(const std::string &path, const ReadingTexts &reading, bool quiet);

} // namespace mdm
