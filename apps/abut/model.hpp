// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/comm.hpp"
#include "abut/core/timers.hpp"
#include "abut/deck/deck.hpp"
#include "abut/scene/scene.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace abut::app {

/// The scene of a deck, with the deck that it was made from.
struct Model : scene::Scene {
  Comm comm;
  deck::Deck deck;
  std::unique_ptr<PhaseTimers> timers;
  std::uint64_t mesh_fingerprint = 0; ///< on the root
};

/// Reads the deck and its mesh and builds everything. Throws InputError, naming file, line and key,
/// for what does not fit together. `look` sees the whole mesh, with the deck's surfaces, on the
/// root. Collective.
std::unique_ptr<Model> build_model(const Comm& comm, const std::string& deck_file,
                                   const std::function<void(const mesh::MeshData&)>& look = {});

} // namespace abut::app
