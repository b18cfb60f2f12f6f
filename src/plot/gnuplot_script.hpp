#pragma once
/// \file
/// A figure as a script of gnuplot 5.4 or later.

#include "plot/figure.hpp"

namespace mdm {

/// The format that gnuplot writes.
enum class Picture { svg, png, pdf };

/// The script that writes the figure to gnuplot's standard output, data included. Run by `gnuplot -d`.
/// Texts of a figure are data: they appear as drawable() has them, whatever characters they have, and are
/// never executed. The same figure gives the same script.
std::string gnuplot_script(const Figure &figure, Picture picture);

/// drawable(text) as gnuplot's string of these very characters: in one line and without any quote, backslash,
/// `$`, `@` or backtick of the text's own, so that nothing of it can end the string, be replaced or be
/// executed.
std::string gnuplot_string(std::string_view text);

} // namespace mdm
