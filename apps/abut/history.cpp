// SPDX-License-Identifier: BSD-3-Clause
#include "history.hpp"

#include "abut/scene/globals.hpp"

#include <numeric>

namespace abut::app {

History::History(const Model& model, std::string stem) : model_(model), stem_(std::move(stem)) {
  columns_.push_back({"t", "", "load parameter; with dynamics, time", ""});
  for (const scene::GlobalVariable& v : scene::global_variables(model))
    columns_.push_back({v.name, v.key, v.meaning, v.unit});
}

std::vector<double> History::row_of(const scene::State& state) const {
  std::vector<double> row{state.time};
  for (const scene::GlobalVariable& v : scene::global_variables(model_, state))
    row.push_back(v.value);
  return row;
}

void History::add(const scene::State& state) {
  if (!model_.deck.output.history)
    return;
  model_.comm.on_root([&] {
    if (!file_)
      file_.emplace(stem_, columns_, rows_);
    const std::vector<double> row = row_of(state);
    if (model_.deck.output.checkpoint.active)
      rows_.insert(rows_.end(), row.begin(), row.end());
    else
      rows_.clear();
    file_->add(row);
  });
}

void History::exchange_state(StateArchive& archive) {
  if (!archive.holds("history")) // it is of a version without
    return;
  Global count = static_cast<Global>(rows_.size() / columns_.size());
  model_.comm.broadcast(&count, sizeof count);
  std::size_t width = columns_.size();
  archive.numbers("history", [&](auto& v) { v(count, width); });
  if (width != columns_.size())
    return;
  std::vector<Global> keys(model_.comm.is_root() ? static_cast<std::size_t>(count) : 0);
  std::iota(keys.begin(), keys.end(), Global(0));
  rows_.resize(keys.size() * width);
  archive.rows("history.rows", keys, static_cast<int>(width), rows_.data());
}

} // namespace abut::app
