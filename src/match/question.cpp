#include <mdm/match/question.hpp>

namespace mdm {

Gradation asked_gradation(Gradation g, const Question &question) {
  if (question.pan_size)
    g = g.with_pan_size(*question.pan_size);
  if (question.cut_below)
    g = g.cut_below(*question.cut_below);
  if (question.size_factor != 1)
    g = g.scaled(question.size_factor);
  return g;
}

} // namespace mdm
