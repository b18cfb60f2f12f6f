#pragma once
/// \file
/// The sample that an answer of mdm states.

#include "gradation/description.hpp"
#include "gradation/share_errors.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <string>
#include <utility>
#include <vector>

namespace mdm {

/// The particles of an mdm-answer-1. A particle of a class has the mass s m / q and the size f^-1
/// of it, of which the answer prints an enclosure; m is the mass of the class, or within a tolerance the
/// share that it achieved.
struct AnswerSample {
  /// A class with particles.
  struct Class {
    std::size_t number;   ///< in the answer, from 1
    std::string material; ///< empty: it has no name
    RootSize lower, upper;
    Rational mass;
    Integer quantity; ///< 1 or more
    Rational size_lo, size_hi;
    std::vector<std::pair<Rational, Rational>> sizes; ///< of a spread's particles, lo and hi; or none
  };

  std::string id;       ///< of the gradation; empty if there is none
  std::string question; ///< in words; empty if there is none
  std::vector<std::string> notes;
  SizeUnit unit = SizeUnit::mm;
  std::vector<Class> classes; ///< those with particles
  Rational scale;             ///< s, to the power scale_power
  unsigned size_power = 1;    ///< root of the gradation
  unsigned scale_power = 1;   ///< p, b of the law times the root of the gradation
  Integer particles;          ///< N as it is stated
  ShareErrors errors = {};    ///< of achieved shares, by those of the masses
  bool has_spread = false;    ///< particles have other sizes as well, which are not read
};

/// Reads an mdm-answer-1. `file` precedes messages.
/// \throws InputError if it is none, or has no sample (its status is none or unknown), or is of several
/// materials
AnswerSample read_answer(std::string_view content, const std::string &file);
/// The same of an answer whose classes may have materials.
AnswerSample read_material_answer(std::string_view content, const std::string &file);

/// True of a text that begins as an mdm-answer-1.
bool is_answer(std::string_view begin);

/// The gradation that the particles of an answer have: its classes, empty ones too, with the masses of an
/// exact match, or the shares of one within a tolerance.
/// \throws InputError as read_answer
Gradation answer_gradation(std::string_view content, const std::string &file,
                           PhiReading phi = PhiReading::exact);

/// The curve of the particles of an answer, with steps at their sizes: nothing is between two. Those of a
/// spread are taken as spheres.
/// \throws InputError as read_answer
Gradation answer_curve(std::string_view content, const std::string &file);

/// \throws InputError if the answer's scale is not to the power that the law has it to
void check_power(const AnswerSample &answer, const MassLaw &law);

/// An answer's particles as a gradation describes them.
struct AnswerDescription {
  Description description;
  /// Where sizes are not in their enclosures, or those of a spread do not lie in their class, one a particle,
  /// around its mass: the sample is not what the answer says.
  std::vector<std::string> objections;
  /// Other mistakes of the answer: its N.
  std::vector<std::string> notes;
  /// The particles of each class, as if they had one size.
  std::vector<std::pair<RootSize, Integer>> particles;
  bool is_spread = false; ///< their sizes differ
};

/// The description of the answer's sample by g, exactly: a size is judged by its power x^(a d) = (s m / (c
/// q))^(b d), c being the factor of the class of g that has the answer's bounds. Masses are in units of s.
/// \throws InputError if the law does not fit the answer, or g has factors and not the answer's classes, or
/// openings inside a class that is spread
AnswerDescription describe_answer(const AnswerSample &answer, Gradation g, const MassLaw &law,
                                  const Rational &snap);

} // namespace mdm
