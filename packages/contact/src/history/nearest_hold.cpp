// SPDX-License-Identifier: BSD-3-Clause
#include "history/nearest_hold.hpp"

#include "law/constants.hpp"

#include <algorithm>
#include <limits>

namespace abut::contact {

void NearestHold::look(InterfaceData& data, bool seeking) {
  constexpr double band = 0.1; // of a face, beyond the nearest point
  gap_ = std::numeric_limits<double>::max();
  double size = 0.0;
  for (Local i = 0; i < data.points.size(); ++i) {
    const SiteReading& r = data.points.reading(i);
    if (!r.covered || r.gap >= gap_)
      continue;
    gap_ = r.gap;
    size = r.size;
  }
  const double here = gap_;
  gap_ = data.comm.min(here);
  size_ = data.comm.max(here == gap_ ? size : 0.0);
  apart_ = gap_ > touching_gap * size_;
  const bool known = size_ > 0.0;
  data.terms.law.hair = apart_ && seeking && known ? gap_ + band * size_ : 0.0;
}

void NearestHold::take_iterate(LawTerms& law, bool is_first) {
  constexpr double overlap = 0.02; // of a face, what the next iterate is to end with
  constexpr double least = 1e-6;
  const double moved = last_gap_ - gap_;
  if (is_first)
    law.hair_share = 1.0;
  else if (apart_ && moved > 0.0)
    law.hair_share = std::clamp(law.hair_share * moved / (gap_ + overlap * size_), least, 1.0);
  last_gap_ = gap_;
}

} // namespace abut::contact
