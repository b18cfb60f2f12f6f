#pragma once
/// \file
/// Names of several samples.

#include <functional>
#include <string>
#include <vector>

namespace mdm {

/// Where samples have the same name, those of their files take its place, as the user gave them; from the
/// second time on that a file is given, with a number. \pre as many names as files
void tell_apart(const std::vector<std::string *> &names, const std::vector<std::string> &files);

/// The same of samples whose name is what `name`, a member or a function, makes of them.
template <class Sample, class Name>
void tell_apart(std::vector<Sample> &samples, Name name, const std::vector<std::string> &files) {
  std::vector<std::string *> names;
  for (Sample &sample : samples)
    names.push_back(&std::invoke(name, sample));
  tell_apart(names, files);
}

} // namespace mdm
