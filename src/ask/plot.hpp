#pragma once
/// \file
/// Pictures of gradations and packings: what is asked, and what is drawn of particles.

#include "answer/answer_sample.hpp"
#include "ask/option_row.hpp"
#include "ask/soil_options.hpp"
#include "ask/solve_options.hpp"
#include "particles/description_sink.hpp"
#include "particles/placed_sink.hpp"
#include "particles/sample_sieves.hpp"
#include "plot/gradation_figure.hpp"
#include "plot/packing_figure.hpp"
#include "soil/texture.hpp"

#include <mdm/match/match.hpp>

#include <vector>

namespace mdm {

/// What is asked of a picture, as texts.
struct PlotTexts {
  OptionText sample; ///< its name: an answer, or another file of particles
  bool match = false, coarse_left = false;
  OptionText what, band, bands, sieve_names, colour, size_unit, texture;
  bool bare = false;
  OptionText language, width, caption;
  SoilTexts soil;
  SolveTexts solve; ///< of the match; its band is `band`, its pan that of the soil
  BudgetTexts budget;

  /// All but those of the soil and of solving.
  static const std::vector<OptionRow<PlotTexts>> options;

  bool wants_section() const { return what == "section"; }
  /// An option of solving that is given, as messages name it; empty: none.
  std::string given_of_solving() const;
  /// True if a match is to be solved: also where an option says how.
  bool wants_match() const { return match || !given_of_solving().empty(); }
  /// The options of solving, in bounded time where they are of exact matches and have no limit.
  SolveTexts match_texts() const;
  /// Refuses options that do not go together. \throws InputError naming them
  void check() const;
  /// The figure as far as options say it. \param is_sample  the curve is that of particles
  GradationFigure figure(bool is_sample) const;
  PackingColour packing_colour() const;
  /// Whose triangle is drawn; nothing: none.
  std::optional<TextureSystem> texture_system() const;
  /// What is said of the figure's form.
  FigureForm form() const;
  /// True if one of the options is given that only a picture of a gradation has a use for.
  bool is_of_gradation() const;
  /// True if something is said of the form.
  bool has_form() const { return bare || language || width || caption; }

private:
  SieveNames names_of_sieves(bool is_sample) const;
};

/// The classes of an answer with lengths in the gradation's unit.
std::vector<DrawnClass> drawn(const AnswerSample &answer, SizeUnit unit);
std::vector<DrawnClass> drawn(const Match &m);
/// True if each class of the particles is one of the gradation: not so after a cut, a pan size or a factor.
bool are_of(const std::vector<DrawnClass> &classes, const Gradation &g);

/// Gathers the particles of a sample class by class and size by size, and their places where they are wanted.
class DrawnSample {
public:
  explicit DrawnSample(const Gradation &g) : gradation_(g), gathered_(g), placed_(g, gathered_) {}

  /// Takes the particles. \param with_places  a section is wanted
  ParticleSink &sink(bool with_places) {
    return with_places ? static_cast<ParticleSink &>(placed_) : gathered_;
  }
  /// Adds what came in to a figure.
  void add_to(GradationFigure &figure) const;
  /// Those of the places. \throws InputError where there are none
  SphereSample places() { return placed_.sample(); }

private:
  class Gathered : public ParticleSink {
  public:
    explicit Gathered(const Gradation &g) : classes_(Description(g)) {}

    void restart() override {
      classes_.restart();
      sieves_.restart();
    }
    void add(const RootSize &diameter, const Integer &quantity) override {
      classes_.add(diameter, quantity);
      sieves_.add(diameter, quantity);
    }
    void add(const SizeRange &diameter, const Integer &quantity) override {
      classes_.add(diameter, quantity);
      sieves_.add(diameter, quantity);
    }

    const Description &description() const { return classes_.description(); }
    const SampleSieves &sieves() const { return sieves_; }

  private:
    DescriptionSink classes_;
    SampleSieves sieves_;
  };

  const Gradation &gradation_;
  Gathered gathered_;
  PlacedSink placed_;
};

} // namespace mdm
