// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/windows.hpp"

#include <cmath>
#include <fmt/format.h>

namespace abut::scene {

namespace {

constexpr double same = 1e-6; // in steps

/// visit(path, window) for all that holds for a time.
template <class Visit> void each_window(const Options& options, const Visit& visit) {
  for (const auto& d : options.displacements)
    visit("displacements." + d.name, d.window);
  for (const auto& body : options.bodies)
    for (const auto& hold : body.motion.holds)
      visit("bodies." + body.name + ".rigid.holds." + hold.name, hold.window);
  for (const auto& c : options.contact)
    visit("contact." + c.name, c.window);
}

} // namespace

std::vector<std::string> windows_between_steps(const Options& options) {
  std::vector<std::string> result;
  const double step = options.time.end / options.time.steps;
  each_window(options, [&](const std::string& path, const Window& window) {
    for (const double t : {window.from, window.until.value_or(0.0)})
      if (t < options.time.end && std::abs(t / step - std::round(t / step)) > same)
        result.push_back(fmt::format("{}: no step ends at t = {:g}; what begins or ends there does "
                                     "so with the step that goes beyond",
                                     path, t));
  });
  return result;
}

std::vector<std::string> windows_at(const Options& options, double t) {
  std::vector<std::string> result;
  const double step = options.time.end / options.time.steps;
  each_window(options, [&](const std::string& path, const Window& window) {
    const auto is_now = [&](double edge) {
      return edge > 0.0 && std::abs(edge - t) <= same * step;
    };
    if (is_now(window.from) || is_now(window.until.value_or(0.0)))
      result.push_back(path);
  });
  return result;
}

} // namespace abut::scene
