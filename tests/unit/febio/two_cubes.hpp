// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/error.hpp"
#include "abut/febio/import.hpp"

#include <map>
#include <sstream>
#include <string>
#include <vector>

/// A FEBio file of two cubes, one on the other, that tests change line by line.
namespace abut::febio::test {

inline const std::vector<std::string>& two_cubes() {
  static const std::vector<std::string> lines = {
      /* 1 */ "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>",
      /* 2 */ "<febio_spec version=\"4.0\"><Module type=\"solid\"/>",
      /* 3 */ "<Control><time_steps>4</time_steps><step_size>0.5</step_size></Control>",
      /* 4 */ "<Material>",
      /* 5 */
      "<material id=\"1\" name=\"soft one\" type=\"neo-Hookean\"><E>10</E><v>0.3</v></material>",
      /* 6 */
      "<material id=\"2\" name=\"plate\" type=\"rigid body\"><density>2</density></material>",
      /* 7 */ "</Material>",
      /* 8 */ "<Mesh><Nodes name=\"all\">",
      /* 9 */ "<node id=\"1\">0,0,0</node><node id=\"2\">1,0,0</node>",
      /* 10 */ "<node id=\"3\">1,1,0</node><node id=\"4\">0,1,0</node>",
      /* 11 */ "<node id=\"5\">0,0,1</node><node id=\"6\">1,0,1</node>",
      /* 12 */ "<node id=\"7\">1,1,1</node><node id=\"8\">0,1,1</node>",
      /* 13 */ "<node id=\"11\">0,0,1</node><node id=\"12\">1,0,1</node>",
      /* 14 */ "<node id=\"13\">1,1,1</node><node id=\"14\">0,1,1</node>",
      /* 15 */ "<node id=\"15\">0,0,2</node><node id=\"16\">1,0,2</node>",
      /* 16 */ "<node id=\"17\">1,1,2</node><node id=\"18\">0,1,2</node>",
      /* 17 */ "<node id=\"99\">5,5,5</node></Nodes>",
      /* 18 */ "<Elements type=\"hex8\" name=\"lower\">",
      /* 19 */ "<elem id=\"7\">1,2,3,4,5,6,7,8</elem></Elements>",
      /* 20 */ "<Elements type=\"hex8\" name=\"upper\">",
      /* 21 */ "<elem id=\"9\">11,12,13,14,15,16,17,18</elem></Elements>",
      /* 22 */ "<NodeSet name=\"bottom\">1:4</NodeSet>",
      /* 23 */ "<NodeSet name=\"top\">15, 16,17, 18</NodeSet>",
      /* 24 */ "<Surface name=\"low face\"><quad4 id=\"1\">5,6,7,8</quad4></Surface>",
      /* 25 */ "<Surface name=\"up_face\"><quad4 id=\"1\">14,13,12,11</quad4></Surface>",
      /* 26 */ "<SurfacePair name=\"pair\"><primary>low face</primary>",
      /* 27 */ "<secondary>up_face</secondary></SurfacePair></Mesh>",
      /* 28 */ "<MeshDomains><SolidDomain name=\"lower\" mat=\"soft one\"/>",
      /* 29 */ "<SolidDomain name=\"upper\" mat=\"soft one\"/></MeshDomains>",
      /* 30 */ "<Boundary>",
      /* 31 */ "<bc name=\"hold\" node_set=\"bottom\" type=\"zero displacement\">",
      /* 32 */ "<x_dof>1</x_dof><y_dof>1</y_dof><z_dof>1</z_dof></bc>",
      /* 33 */ "<bc name=\"press\" node_set=\"top\" type=\"prescribed displacement\">",
      /* 34 */ "<dof>z</dof><value lc=\"1\">-0.1</value></bc>",
      /* 35 */ "</Boundary>",
      /* 36 */ "<Rigid></Rigid>",
      /* 37 */ "<Loads></Loads>",
      /* 38 */ "<Contact><contact name=\"touch\" surface_pair=\"pair\" type=\"sliding-elastic\">",
      /* 39 */ "<laugon>PENALTY</laugon>",
      /* 40 */ "<penalty>5</penalty>",
      /* 41 */ "<two_pass>0</two_pass>",
      /* 42 */ "</contact></Contact>",
      /* 43 */ "<LoadData><load_controller id=\"1\" name=\"LC1\" type=\"loadcurve\">",
      /* 44 */ "<points><pt>0,0</pt><pt>2,1</pt></points></load_controller></LoadData>",
      /* 45 */ "</febio_spec>"};
  return lines;
}

/// The file with lines (counted from 1) replaced.
inline std::string with(const std::map<std::size_t, std::string>& changes) {
  std::vector<std::string> lines = two_cubes();
  for (const auto& [line, text] : changes)
    lines.at(line - 1) = text;
  std::string out;
  for (const std::string& line : lines)
    out += line + "\n";
  return out;
}

inline Scene scene_with(const std::map<std::size_t, std::string>& changes) {
  return import(with(changes), "m.feb", "m");
}

/// The message of the InputError, or "no error".
inline std::string error_of(const std::string& text) {
  try {
    import(text, "m.feb", "m");
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}
inline std::string error_with(const std::map<std::size_t, std::string>& changes) {
  return error_of(with(changes));
}

/// Lines of the deck between a section's name and the next section.
inline std::string section(const std::string& deck, const std::string& name) {
  std::istringstream in(deck);
  std::string line, out;
  bool inside = false;
  while (std::getline(in, line)) {
    if (!line.empty() && line[0] != ' ')
      inside = line.compare(0, name.size() + 1, name + ":") == 0;
    if (inside)
      out += line + "\n";
  }
  return out;
}

} // namespace abut::febio::test
