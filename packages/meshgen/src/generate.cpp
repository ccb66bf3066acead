// SPDX-License-Identifier: BSD-3-Clause
#include "abut/meshgen/generate.hpp"

#include "abut/core/error.hpp"
#include "abut/meshgen/contact_generators.hpp"
#include "abut/meshgen/generators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <type_traits>

namespace abut::meshgen {

namespace {

const std::array<std::string, 6> cell_names{"hex8", "hex20", "hex27", "tet4", "tet10", "wedge6"};
const std::array<fem::CellType, 6> cell_types{fem::CellType::hex8,  fem::CellType::hex20,
                                              fem::CellType::hex27, fem::CellType::tet4,
                                              fem::CellType::tet10, fem::CellType::wedge6};

const std::array<std::string, 4> interface_names{"plane", "cylinder", "sphere", "sine"};
const std::array<std::string, 2> punch_names{"strip", "disc"};

using Written = std::map<std::string, std::string>;

double number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
    throw InputError("expected a number, got '" + text + "'");
  return value;
}

void read(const std::string& text, double& value) {
  value = number(text);
}
void read(const std::string& text, int& value) {
  const double v = number(text);
  if (v != std::floor(v) || std::abs(v) > std::numeric_limits<int>::max())
    throw InputError("expected a whole number, got '" + text + "'");
  value = static_cast<int>(v);
}
void read(const std::string& text, std::string& value) {
  value = text;
}
void read(const std::string& text, fem::CellType& value) {
  value = cell_type_from_name(text);
}
void read(const std::string& text, bool& value) {
  const bool yes = text == "true" || text == "yes" || text == "on" || text == "1";
  const bool no = text == "false" || text == "no" || text == "off" || text == "0";
  if (!yes && !no)
    throw InputError("expected true or false, got '" + text + "'");
  value = yes;
}
template <class Enum, std::size_t N>
void read_word(const std::string& text, const std::array<std::string, N>& words, Enum& value) {
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end())
    throw InputError("unknown word '" + text + "'; " + nearest_word_hint(text, words.data(), N));
  value = static_cast<Enum>(found - words.begin());
}
void read(const std::string& text, InterfaceShape& value) {
  read_word(text, interface_names, value);
}
void read(const std::string& text, PunchShape& value) {
  read_word(text, punch_names, value);
}
template <class T> void read(const std::string& text, std::array<T, 3>& value) {
  std::string words = text;
  for (char& c : words)
    if (c == ',' || c == '[' || c == ']')
      c = ' ';
  std::istringstream in(words);
  std::vector<std::string> parts;
  for (std::string word; in >> word;)
    parts.push_back(word);
  if (parts.size() == 1)
    parts.resize(3, parts[0]);
  if (parts.size() != 3)
    throw InputError("expected three numbers, got '" + text + "'");
  for (std::size_t i = 0; i < 3; ++i)
    read(parts[i], value[i]);
}

std::string write(fem::CellType value) {
  return cell_names[std::find(cell_types.begin(), cell_types.end(), value) - cell_types.begin()];
}
std::string write(InterfaceShape value) {
  return interface_names[static_cast<std::size_t>(value)];
}
std::string write(PunchShape value) {
  return punch_names[static_cast<std::size_t>(value)];
}
std::string write(bool value) {
  return value ? "true" : "false";
}
std::string write(const std::string& value) {
  return value;
}
template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>> std::string write(T value) {
  std::ostringstream out;
  out << value;
  return out.str();
}
template <class T> std::string write(const std::array<T, 3>& v) {
  return write(v[0]) + "," + write(v[1]) + "," + write(v[2]);
}

/// Reads options into a struct and remembers which keys there are.
class Binder {
public:
  explicit Binder(const Written& written) : written_(written) {}

  template <class T> Binder& operator()(const std::string& key, T& value, const std::string& help) {
    keys.push_back({key, write(value), help});
    const auto given = written_.find(key);
    if (given == written_.end())
      return *this;
    try {
      read(given->second, value);
    } catch (const InputError& e) {
      throw InputError("'" + key + "': " + e.what());
    }
    return *this;
  }

  void require_known() const {
    std::vector<std::string> names;
    for (const GeneratorKey& k : keys)
      names.push_back(k.name);
    for (const auto& [key, value] : written_)
      if (std::find(names.begin(), names.end(), key) == names.end())
        throw InputError("unknown option '" + key + "'; " +
                         nearest_word_hint(key, names.data(), names.size()));
  }

  std::vector<GeneratorKey> keys;

private:
  const Written& written_;
};

void bind(Binder& b, BoxOptions& o) {
  b("size", o.size, "edge lengths")("divisions", o.divisions, "cells along each edge");
  b("origin", o.origin, "corner of smallest coordinates")("name", o.name, "name of the block");
  b("prefix", o.prefix, "before the names of the sets");
  b("distortion", o.distortion, "random moves of inner nodes, fraction of the cell size");
  b("element", o.element, "hex8, hex20, hex27, tet4, tet10 or wedge6");
}

void bind(Binder& b, BlockPairOptions& o) {
  b("lower_size", o.lower_size, "edge lengths of the lower block");
  b("lower_divisions", o.lower_divisions, "its cells along each edge");
  b("upper_size", o.upper_size, "edge lengths of the upper block");
  b("upper_divisions", o.upper_divisions, "its cells along each edge");
  b("gap", o.gap, "distance between the blocks");
  b("rotation", o.rotation, "degrees, turns the upper mesh inside its outline about the normal");
  b("turn", o.turn, "degrees, turns the upper block about the normal");
  b("shift", o.shift, "moves the upper block along x");
  b("flat", o.flat, "half width along x of the plane part of lower_top, from its middle");
  b("drop", o.drop, "beyond it lower_top lies drop (|x - middle| - flat)^2 lower");
  b("distortion", o.distortion, "random moves of inner nodes, fraction of the cell size");
  b("element", o.element, "hex8, hex20, hex27, tet4, tet10 or wedge6");
}

void bind_round(Binder& b, RoundOptions& o) {
  b("radius", o.radius, "of the body")("core", o.core, "extent of the uniform fine region");
  b("facets", o.facets, "faces along the core");
  b("growth", o.growth, "largest ratio of neighbouring cells outside the core");
  b("depth", o.depth, "uniform layers below the surface; negative: core / 8");
  b("max_size", o.max_size, "largest cell; 0: radius / 5");
  b("gap", o.gap, "height of the lowest point above z = 0");
  b("plate", o.plate, "adds a plate below z = 0");
  b("plate_size", o.plate_size, "reach of the plate from the contact point; 0: 2.5 core");
  b("plate_divisions", o.plate_divisions, "cells along the plate");
  b("plate_thickness", o.plate_thickness, "0: core");
  b("element", o.element, "of the round body: hex8, hex20, hex27, tet4, tet10, wedge6 (cylinder)");
}

void bind(Binder& b, RoundOptions& o) {
  bind_round(b, o);
}

void bind(Binder& b, CylinderOptions& o) {
  bind_round(b, o);
  b("thickness", o.thickness, "along y")("thickness_divisions", o.thickness_divisions, "along y");
}

void bind(Binder& b, RingsOptions& o) {
  b("inner_radius", o.inner_radius, "of the inner ring");
  b("interface_radius", o.interface_radius, "outer face of the inner ring");
  b("outer_radius", o.outer_radius, "of the outer ring");
  b("gap", o.gap, "radial clearance; negative: interference");
  b("thickness", o.thickness, "along z");
  b("inner_theta", o.inner_theta, "cells of the inner ring over 90 degrees");
  b("outer_theta", o.outer_theta, "cells of the outer ring over 90 degrees");
  b("inner_r", o.inner_r, "cells of the inner ring along the radius");
  b("outer_r", o.outer_r, "cells of the outer ring along the radius");
  b("thickness_divisions", o.thickness_divisions, "cells along z");
  b("element", o.element, "hex8, hex20, hex27, tet4, tet10 or wedge6");
}

void bind(Binder& b, HertzBlockOptions& o) {
  b("size", o.size, "edge length")("core", o.core, "extent of the uniform fine region");
  b("facets", o.facets, "faces along the core");
  b("growth", o.growth, "largest ratio of neighbouring cells outside the core");
  b("depth", o.depth, "uniform layers below the surface; negative: core / 8");
  b("max_size", o.max_size, "largest cell; 0: size / 5");
  b("element", o.element, "hex8, hex20, hex27, tet4, tet10 or wedge6");
}

void bind(Binder& b, InterfaceOptions& o) {
  b("shape", o.shape, "of the interface: plane, cylinder, sphere or sine");
  b("angle", o.angle, "degrees, of the plane")("radius", o.radius, "of cylinder and sphere");
  b("amplitude", o.amplitude, "of the sine");
  b("width", o.width, "along x")("depth", o.depth, "along y");
  b("lower_height", o.lower_height, "of the box below z = 0");
  b("upper_height", o.upper_height, "of the box above z = 0");
  b("lower_divisions", o.lower_divisions, "cells of the lower block along each edge");
  b("upper_divisions", o.upper_divisions, "cells of the upper block along each edge");
  b("element", o.element, "hex8, hex20, hex27, tet4, tet10 or wedge6");
}

void bind_round_pair(Binder& b, RoundPairOptions& o) {
  b("upper_radius", o.upper_radius, "of the upper body");
  b("lower_radius", o.lower_radius, "of the lower body");
  b("core", o.core, "extent of the uniform fine region");
  b("upper_facets", o.upper_facets, "faces of the upper body along the core");
  b("lower_facets", o.lower_facets, "faces of the lower body along the core");
  b("growth", o.growth, "largest ratio of neighbouring cells outside the core");
  b("depth", o.depth, "uniform layers below the surface; negative: core / 8");
  b("max_size", o.max_size, "largest cell; 0: radius / 5");
  b("element", o.element, "hex8, hex20, hex27, tet4, tet10, wedge6 (cylinders)");
}

void bind(Binder& b, RoundPairOptions& o) {
  bind_round_pair(b, o);
}

void bind(Binder& b, CylinderPairOptions& o) {
  bind_round_pair(b, o);
  b("thickness", o.thickness, "along y")("thickness_divisions", o.thickness_divisions, "along y");
}

void bind(Binder& b, ParaboloidOptions& o) {
  b("radius", o.radius, "R of the face z = r^2/(2 R)")("size", o.size, "edge length");
  b("core", o.core, "extent of the uniform fine region");
  b("facets", o.facets, "faces along the core");
  b("growth", o.growth, "largest ratio of neighbouring cells outside the core");
  b("depth", o.depth, "uniform layers below the surfaces; negative: core / 2");
  b("max_size", o.max_size, "largest cell; 0: size / 5");
  b("gap", o.gap, "height of the lowest point above z = 0");
  b("plate_facets", o.plate_facets, "faces of the plate along the core; 0: one cell, to be rigid");
  b("element", o.element, "hex8, hex20, hex27, tet4, tet10 or wedge6; a plate of one cell is hex8");
}

void bind(Binder& b, PunchOptions& o) {
  b("shape", o.shape, "strip or disc")("radius", o.radius, "half width of the punch");
  b("facets", o.facets, "faces of the body from the middle to the edge of the punch");
  b("offset", o.offset, "the edge lies so many cells inside a line of the mesh");
  b("size", o.size, "reach of the body sideways and downwards");
  b("growth", o.growth, "largest ratio of neighbouring cells away from the punch");
  b("max_size", o.max_size, "largest cell; 0: size / 5");
  b("thickness", o.thickness, "of the strip along y");
  b("punch_divisions", o.punch_divisions, "faces of the punch from its middle to its edge");
  b("element", o.element, "of the body: hex8, hex20, hex27, tet4, tet10");
}

/// Makes the mesh, or only lists the keys when `keys` is given.
template <class Options>
mesh::MeshData run(const Written& written, mesh::MeshData (*make)(const Options&),
                   std::vector<GeneratorKey>* keys) {
  Options options;
  Binder binder(written);
  bind(binder, options);
  if (keys) {
    *keys = binder.keys;
    return {};
  }
  binder.require_known();
  return make(options);
}

mesh::MeshData dispatch(const std::string& kind, const Written& written,
                        std::vector<GeneratorKey>* keys) {
  if (kind == "box")
    return run(written, &box, keys);
  if (kind == "blocks")
    return run(written, &block_pair, keys);
  if (kind == "quarter_cylinder")
    return run(written, &quarter_cylinder, keys);
  if (kind == "sphere_plane")
    return run(written, &quarter_sphere, keys);
  if (kind == "rings")
    return run(written, &rings, keys);
  if (kind == "hertz_block")
    return run(written, &hertz_block, keys);
  if (kind == "interface")
    return run(written, &interface_pair, keys);
  if (kind == "two_spheres")
    return run(written, &sphere_pair, keys);
  if (kind == "two_cylinders")
    return run(written, &cylinder_pair, keys);
  if (kind == "paraboloid")
    return run(written, &paraboloid, keys);
  if (kind == "punch")
    return run(written, &punch, keys);
  const auto& kinds = generator_kinds();
  throw InputError("unknown mesh kind '" + kind + "'; " +
                   nearest_word_hint(kind, kinds.data(), kinds.size()));
}

} // namespace

const std::vector<std::string>& generator_kinds() {
  static const std::vector<std::string> kinds{
      "box",       "blocks",      "quarter_cylinder", "sphere_plane", "rings", "hertz_block",
      "interface", "two_spheres", "two_cylinders",    "paraboloid",   "punch"};
  return kinds;
}

std::vector<GeneratorKey> generator_keys(const std::string& kind) {
  std::vector<GeneratorKey> keys;
  dispatch(kind, {}, &keys);
  return keys;
}

mesh::MeshData generate(const std::string& kind,
                        const std::map<std::string, std::string>& options) {
  generator_keys(kind); // the kind is known
  try {
    return dispatch(kind, options, nullptr);
  } catch (const InputError& e) {
    throw InputError("mesh '" + kind + "': " + e.what());
  }
}

fem::CellType cell_type_from_name(const std::string& name) {
  const auto found = std::find(cell_names.begin(), cell_names.end(), name);
  if (found == cell_names.end())
    throw InputError("unknown element '" + name + "'; " +
                     nearest_word_hint(name, cell_names.data(), cell_names.size()));
  return cell_types[found - cell_names.begin()];
}

} // namespace abut::meshgen
