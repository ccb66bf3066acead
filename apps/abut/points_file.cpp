// SPDX-License-Identifier: BSD-3-Clause
#include "points_file.hpp"

#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>

namespace abut::app {

PointsFile::PointsFile(const Model& model, const std::string& stem)
    : model_(model), path_(stem + ".points.csv") {
  model_.comm.on_root([&] {
    std::ofstream out(path_);
    out << "time,interface,face,point,x,y,z,status,gap,slip,pressure,shear,traction_x,traction_y,"
           "traction_z,flips,augmentations\n";
    if (!out)
      throw InputError("cannot write '" + path_ + "'");
  });
}

void PointsFile::write(double time, long long augmentations) const {
  constexpr const char* words[] = {"open", "slip", "stick"};
  std::string text;
  for (const auto& contact : model_.contacts) {
    auto records = model_.comm.gather(contact->points().records());
    std::sort(records.begin(), records.end(), [](const auto& a, const auto& b) {
      return a.face != b.face ? a.face < b.face : a.point < b.point;
    });
    for (const contact::PointRecord& r : records)
      text += fmt::format("{:.12g},{},{},{},{:.12g},{:.12g},{:.12g},{},{:.9g},{:.9g},{:.9g},{:.9g},"
                          "{:.9g},{:.9g},{:.9g},{},{}\n",
                          time, contact->name(), r.face, r.point, r.x[0], r.x[1], r.x[2],
                          words[static_cast<int>(r.status)], r.gap, r.slip, r.pressure, r.shear,
                          r.traction[0], r.traction[1], r.traction[2], r.flips, augmentations);
  }
  model_.comm.on_root([&] {
    std::ofstream out(path_, std::ios::app);
    out << text;
    if (!out.flush())
      throw MachineError("cannot write '" + path_ + "': is the disk full?");
  });
}

} // namespace abut::app
