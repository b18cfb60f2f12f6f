#pragma once
/// \file
/// The study of Voivret, Delenne and Radjai: models of size distributions, and packings.

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace mdm::cli {

/// The options of the study.
struct SizeModelFlags {
  std::optional<std::string> only, at_least, at_most, seeds, spans;
  std::optional<unsigned> threads;

  void add_to(CLI::App &command);
  bool is_given() const { return only || at_least || at_most || seeds || spans || threads; }
};

/// Writes the tables into the folder, and the figures as `plots` where that is given; the exit code.
int run_size_models(const SizeModelFlags &flags, const std::string &folder,
                    const std::optional<std::string> &plots, bool quiet);

} // namespace mdm::cli
