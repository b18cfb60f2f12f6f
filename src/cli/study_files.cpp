#include "cli/study_files.hpp"

#include "files/output.hpp"
#include "files/paths.hpp"

#include <memory>

namespace mdm::cli {

StudyFile StudyPictures::drawn(const std::string &name, const Figure &figure) const {
  if (!quiet_)
    tell_escapes(figure);
  const Picture picture = format_ == "png" ? Picture::png : format_ == "pdf" ? Picture::pdf : Picture::svg;
  return {name + "." + format_, picture_of(figure, picture)};
}

void write_all(const std::string &folder, const std::vector<StudyFile> &files) {
  make_folder(folder);
  std::vector<std::unique_ptr<Output>> outputs;
  for (const StudyFile &file : files) {
    outputs.push_back(std::make_unique<Output>(folder + "/" + file.name));
    outputs.back()->write(file.text);
  }
  for (const std::unique_ptr<Output> &output : outputs)
    output->commit();
}

} // namespace mdm::cli
