// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// What the program must not write over. Serial; all throw InputError.
namespace abut::app {

/// Results replace nothing but results: not a mesh, a deck, anything else.
void protect_from_results(const std::string& path);
/// An imported deck replaces nothing but an imported deck.
void protect_from_import(const std::string& path);
/// A mesh replaces nothing but a mesh.
void protect_from_mesh(const std::string& path);
/// The two files of a history replace nothing but a history.
void protect_from_history(const std::string& stem);
/// A checkpoint replaces nothing but a checkpoint, whole or not.
void protect_from_checkpoint(const std::string& path);
/// A summary replaces nothing but a summary, and must be writable: better known before the solve.
void protect_from_summary(const std::string& path);

} // namespace abut::app
