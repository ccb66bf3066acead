// SPDX-License-Identifier: BSD-3-Clause
#include "distribution.hpp"

#include <algorithm>

namespace abut::multigrid {

Distribution::Distribution(const Comm& comm, std::vector<Global> first, std::vector<Global> ghosts)
    : comm_(comm), first_(std::move(first)), ghosts_(std::move(ghosts)),
      begin_(first_[static_cast<std::size_t>(comm.rank())]),
      owned_(static_cast<Local>(first_[static_cast<std::size_t>(comm.rank()) + 1] - begin_)),
      exchange_(std::make_shared<NodeExchange>(comm, first_, ghosts_)) {
  for (std::size_t i = 0; i < ghosts_.size(); ++i)
    ghost_of_.emplace(ghosts_[i], owned_ + static_cast<Local>(i));
}

int Distribution::owner(Global row) const {
  return static_cast<int>(std::upper_bound(first_.begin(), first_.end(), row) - first_.begin()) - 1;
}

std::vector<Global> first_rows(const Comm& comm, Local owned) {
  std::vector<Global> first{0};
  for (const Global count : comm.all_gather(static_cast<Global>(owned)))
    first.push_back(first.back() + count);
  return first;
}

GhostList::GhostList(const Distribution& known, bool with_its_ghosts)
    : begin_(known.first()[static_cast<std::size_t>(known.comm().rank())]), owned_(known.owned()) {
  if (with_its_ghosts)
    for (const Global ghost : known.ghosts())
      local(ghost);
}

Local GhostList::local(Global row) {
  if (row >= begin_ && row < begin_ + owned_)
    return static_cast<Local>(row - begin_);
  const auto [at, is_new] = number_.emplace(row, owned_ + static_cast<Local>(ghosts_.size()));
  if (is_new)
    ghosts_.push_back(row);
  return at->second;
}

} // namespace abut::multigrid
