// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/node_exchange.hpp"

#include <memory>
#include <unordered_map>
#include <vector>

namespace abut::multigrid {

/// Block rows over the ranks, and those of other ranks that this one needs: its ghosts. Local
/// numbers: owned first, ghosts behind them.
class Distribution {
public:
  /// first: (ranks+1) first row of each rank. ghosts: rows of other ranks, each once. Collective.
  Distribution(const Comm& comm, std::vector<Global> first, std::vector<Global> ghosts);

  Local owned() const { return owned_; }
  Local size() const { return owned_ + static_cast<Local>(ghosts_.size()); }
  Global total() const { return first_.back(); }
  const std::vector<Global>& first() const { return first_; }
  const std::vector<Global>& ghosts() const { return ghosts_; }
  const Comm& comm() const { return comm_; }
  const NodeExchange& exchange() const { return *exchange_; }

  bool owns(Global row) const { return row >= begin_ && row < begin_ + owned_; }
  Global global(Local row) const {
    return row < owned_ ? begin_ + row : ghosts_[static_cast<std::size_t>(row - owned_)];
  }
  Local local(Global row) const {
    return owns(row) ? static_cast<Local>(row - begin_) : ghost_of_.at(row);
  }
  int owner(Global row) const;

private:
  Comm comm_;
  std::vector<Global> first_, ghosts_;
  Global begin_;
  Local owned_;
  std::unordered_map<Global, Local> ghost_of_;
  std::shared_ptr<const NodeExchange> exchange_;
};

/// (ranks+1) first rows where this rank has `owned` ones. Collective.
std::vector<Global> first_rows(const Comm& comm, Local owned);

/// Numbers rows of other ranks in the order in which they are first asked for.
class GhostList {
public:
  GhostList(const Distribution& known, bool with_its_ghosts);
  Local local(Global row);
  const std::vector<Global>& ghosts() const { return ghosts_; }

private:
  Global begin_;
  Local owned_;
  std::vector<Global> ghosts_;
  std::unordered_map<Global, Local> number_;
};

} // namespace abut::multigrid
