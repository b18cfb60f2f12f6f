#include "particles/line_reader.hpp"
#include "particles/particle_writer.hpp"
#include "text/lines.hpp"
#include "text/long_text.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// CSV of DEM-Engine, found by the names of its columns: X, Y, Z, and r of a file of spheres, or clump_type
/// of a file of clumps, whose types are then named r and their radius, `r0.00025`.
class DemEngineReader : public LineReader {
public:
  explicit DemEngineReader(ParticleSource &source) : source_(source) {
    source.set_defaults(SizeMeaning::radius, SizeUnit::m);
  }

  void line(std::string_view text) override {
    const std::string_view row = trimmed(text);
    if (row.empty())
      return;
    if (!split_fields(row, ',', fields_))
      source_.refuse("a quoted field does not end: DEM-Engine writes no quotes");
    if (width_ == 0)
      read_names();
    else
      read_particle();
  }

  void end() override { source_.check_some(); }

private:
  std::size_t column(std::string_view name) const {
    return source_.column(fields_, name, "X,Y,Z,Qw,Qx,Qy,Qz,clump_type");
  }

  void read_names() {
    const auto has = [this](std::string_view name) {
      return std::find(fields_.begin(), fields_.end(), name) != fields_.end();
    };
    has_radii_ = has("r");
    columns_ = {column("X"), column("Y"), column("Z"), column(has_radii_ ? "r" : "clump_type")};
    if (has_radii_ && has("clump_type"))
      source_.refuse("there are columns r and clump_type, which both tell the radius: leave one out");
    width_ = fields_.size();
  }

  std::string_view radius() const {
    const std::string_view field = fields_[columns_[3]];
    if (has_radii_)
      return field;
    if (!field.starts_with('r') || !is_number(field.substr(1)))
      source_.refuse(fmt::format("clump_type {} does not tell a radius: name types of spheres r and their "
                                 "radius, as r0.00025, or give a file of WriteSphereFile",
                                 in_quotes(field)));
    return field.substr(1);
  }

  void read_particle() {
    if (fields_.size() != width_)
      source_.refuse(fmt::format("the row has {} fields, and the header {}: is the file cut off?",
                                 fields_.size(), width_));
    for (const std::size_t axis : {columns_[0], columns_[1], columns_[2]})
      source_.check_number(fields_[axis]);
    source_.particle_at({fields_[columns_[0]], fields_[columns_[1]], fields_[columns_[2]]}, radius());
  }

  ParticleSource &source_;
  std::vector<std::string> fields_;
  std::array<std::size_t, 4> columns_{}; ///< X, Y, Z and the size
  bool has_radii_ = false;
  std::size_t width_ = 0; ///< 0 above the names
};

} // namespace

std::unique_ptr<LineReader> read_dem_engine(ParticleSource &source) {
  return std::make_unique<DemEngineReader>(source);
}

void write_dem_engine(const Placement &start, const Sink &out) {
  LongText text(out);
  text.add("X,Y,Z,Qw,Qx,Qy,Qz,clump_type\n");
  start.each([&](const Placement::Sphere &s) {
    text.add("{},{},{},1,0,0,0,r{}\n", start.text(s.at[0]), start.text(s.at[1]), start.text(s.at[2]),
             s.size->radius.text);
  });
  text.finish();
}

} // namespace mdm
