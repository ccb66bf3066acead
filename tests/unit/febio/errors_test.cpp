// SPDX-License-Identifier: BSD-3-Clause
#include "two_cubes.hpp"

#include <gtest/gtest.h>

using namespace abut;
using namespace abut::febio::test;

namespace {

struct Broken {
  std::size_t line;
  std::string text, message;
};

class Errors : public ::testing::TestWithParam<Broken> {};

TEST_P(Errors, NameFileLineElementAndWhatWasExpected) {
  EXPECT_EQ(error_with({{GetParam().line, GetParam().text}}), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Broken, Errors,
    ::testing::Values(
        Broken{45, "", "m.feb:45: not a complete XML file: Start-end tags mismatch"},
        Broken{19, "<elem id=\"7\">1,2,3,4,5,6,7,77</elem></Elements>",
               "m.feb:19: <elem>: there is no node 77"},
        Broken{14, "<node id=\"13\">1,1,1</node><node id=\"11\">0,1,1</node>",
               "m.feb:14: <node>: node 11 is defined in line 13 already"},
        Broken{21, "<elem id=\"7\">11,12,13,14,15,16,17,18</elem></Elements>",
               "m.feb:21: <elem>: element 7 is defined in line 19 already"},
        Broken{28, "<MeshDomains><SolidDomain name=\"lower\" mat=\"soft\"/>",
               "m.feb:28: <SolidDomain>: there is no material 'soft'; valid: soft one, plate"},
        Broken{28, "<MeshDomains>",
               "m.feb:28: <MeshDomains>: expected a <SolidDomain> for <Elements> 'lower' in line "
               "18"},
        Broken{19, "<elem id=\"7\">1,2,3,4,5,6,7</elem></Elements>",
               "m.feb:19: <elem>: element 7 of type hex8 has 7 nodes, expected 8"},
        Broken{19, "<elem id=\"7\">1,2,3,4,5,6,7,7</elem></Elements>",
               "m.feb:19: <elem>: element 7 has node 7 more than once"},
        Broken{44, "<points></points></load_controller></LoadData>",
               "m.feb:44: <points>: a load curve needs points"},
        Broken{44, "<points><pt>0,0</pt><pt>0,1</pt></points></load_controller></LoadData>",
               "m.feb:44: <pt>: times must grow from point to point"},
        Broken{43, "<LoadData><load_controller id=\"2\" type=\"loadcurve\">",
               "m.feb:34: there is no load controller 1"},
        Broken{21, "<elem id=\"9\">15,16,17,18,11,12,13,14</elem></Elements>",
               "m.feb:21: <elem>: element 9 is inside out or degenerate: its Jacobian has "
               "determinant -0.125, expected > 0. Check the order of its nodes"},
        Broken{9, "<node id=\"1\">0,0</node><node id=\"2\">1,0,0</node>",
               "m.feb:9: <node>: expected 3 numbers, got 2"},
        Broken{9, "<node id=\"1\">0,0,nan</node><node id=\"2\">1,0,0</node>",
               "m.feb:9: <node>: expected 3 numbers, got '0,0,nan'"},
        Broken{24, "<Surface name=\"low face\"><quad4 id=\"1\">5,6,7,1</quad4></Surface>",
               "m.feb:24: face of surface 'low face' is no side of an element"},
        Broken{22, "<NodeSet name=\"bottom\">1:4:0</NodeSet>",
               "m.feb:22: <NodeSet>: expected a range FIRST:LAST:STEP that grows, got '1:4:0'"},
        Broken{22, "<NodeSet name=\"bottom\">1:1000000000</NodeSet>",
               "m.feb:22: <NodeSet>: the range '1:1000000000' is longer than the mesh"},
        Broken{31, "<bc name=\"hold\" node_set=\"botom\" type=\"zero displacement\">",
               "m.feb:31: there is no node set 'botom'; valid: all, bottom, top; did you mean "
               "'bottom'?"},
        Broken{27, "<secondary>up</secondary></SurfacePair></Mesh>",
               "m.feb:27: <secondary>: there is no surface 'up'"},
        Broken{5,
               "<material id=\"1\" name=\"soft one\" type=\"neo-Hookean\"><E>10</E><v>0.5</v>"
               "</material>",
               "m.feb:5: <v>: expected a number > -1 and < 0.5, got 0.500000"},
        Broken{2, "<febio_spec version=\"1.2\"><Module type=\"solid\"/>",
               "m.feb:2: <febio_spec>: version '1.2': expected a file of version 2.0, 2.5, 3.0 or "
               "4.0"},
        Broken{3, "",
               "m.feb:2: <febio_spec>: expected an element <Control> in it or in its <step>"},
        Broken{40, "<penalty>0</penalty>", "m.feb:40: <penalty>: expected a number > 0"},
        Broken{40, "<penalty>1e200</penalty>",
               "m.feb:40: <penalty>: expected a number from 1e-100 to 1e100, got '1e200'"},
        Broken{41, "<fric_coeff>-0.1</fric_coeff>",
               "m.feb:41: <fric_coeff>: expected a number >= 0, got '-0.1'"},
        Broken{41, "<two_pass>2</two_pass>", "m.feb:41: <two_pass>: expected 0 or 1, got '2'"},
        Broken{41, "<maxaug>2.5</maxaug>",
               "m.feb:41: <maxaug>: expected a whole number from 0 to a billion, got '2.5'"},
        Broken{
            5, "<material id=\"1\" name=\"soft one\" type=\"Ogden\"><k>9</k></material>",
            "m.feb:5: <material>: expected terms c1, ... whose sum, twice the shear modulus, is > "
            "0"},
        Broken{22, "<NodeSet name=\"bottom\">9223372036854775807</NodeSet>",
               "m.feb:22: <NodeSet>: there is no node 9223372036854775807"},
        Broken{22, "<NodeSet name=\"" + std::string(300, 'a') + "\">1</NodeSet>",
               "m.feb:22: <NodeSet>: attribute 'name' is longer than 240 bytes"},
        Broken{19, "<elem id=\"2147483648\">1,2,3,4,5,6,7,8</elem></Elements>",
               "m.feb:19: <elem>: expected a whole number from 1 to 2000000000 as id, got "
               "'2147483648'"},
        // Two nodes of the unit cube have changed places: it folds over.
        Broken{19, "<elem id=\"7\">2,1,3,4,5,6,7,8</elem></Elements>",
               "m.feb:19: <elem>: element 7 is inside out or degenerate: its Jacobian has "
               "determinant -0.0305021, expected > 0. Check the order of its nodes"}));

// What is merely not supported is told all at once.
INSTANTIATE_TEST_SUITE_P(
    Unsupported, Errors,
    ::testing::Values(
        Broken{3,
               "<Control><analysis>MODAL</analysis><arc>1</arc><time_steps>4</time_steps>"
               "<step_size>0.5</step_size></Control>",
               "m.feb:3: Control/analysis: 'MODAL': abut has STATIC and DYNAMIC\n"
               "m.feb:3: Control/arc: not supported here; valid: analysis, time_steps, step_size, "
               "time_stepper, solver, plot_zero_state, plot_range, plot_level, output_level, "
               "plot_stride, output_stride, adaptor_re_solve, title"},
        Broken{5,
               "<material id=\"1\" name=\"soft one\" type=\"neo-Hokean\"><E>10</E><v>0.3</v>"
               "</material>",
               "m.feb:5: Material/material 'soft one': type 'neo-Hokean'; valid: neo-Hookean, "
               "Mooney-Rivlin, Ogden, Ogden unconstrained, Holmes-Mow, isotropic elastic, "
               "St.Venant-Kirchhoff, rigid body, incomp neo-Hookean; did you mean 'neo-Hookean'?"},
        Broken{
            18, "<Elements type=\"quad8\" name=\"lower\">",
            "m.feb:18: Mesh/Elements 'lower': elements of type 'quad8' are shells, of which abut "
            "has rigid quad4 and tri3; valid: hex8, hex20, hex27, tet4, tet10, penta6"},
        Broken{38, "<Contact><contact name=\"touch\" surface_pair=\"pair\" type=\"stucky\">",
               "m.feb:38: Contact/contact 'touch': type 'stucky'; valid: sliding-node-on-facet, "
               "sliding-facet-on-facet, sliding-elastic, tied-node-on-facet, tied-facet-on-facet, "
               "tied-elastic, sticky; did you mean 'sticky'?"},
        Broken{41, "<smooth_aug>1</smooth_aug>",
               "m.feb:41: Contact/contact/smooth_aug: multipliers from the stresses of "
               "elements: set 0, and 'multipliers: smoothed' in the deck for smooth ones"},
        Broken{41, "<two_pas>1</two_pas>",
               "m.feb:41: Contact/contact/two_pas: not supported here; did you mean 'two_pass'? "
               "valid: max_penalty_sf, penalty_sf, laugon, tolerance, penalty, auto_penalty, "
               "two_pass, gaptol, minaug, maxaug, "
               "search_tol, seg_up, node_reloc, fric_coeff, search_radius, tension, offset, "
               "flip_primary, flip_secondary, knmult, symmetric_stiffness, update_penalty, "
               "shell_bottom_primary, shell_bottom_secondary, smooth_aug"},
        Broken{41, "<penalty>7</penalty>", "m.feb:41: Contact/contact/penalty: given twice"},
        Broken{35,
               "</Boundary><Constraints><constraint type=\"volume\"/></Constraints>"
               "<Initial/><Physics/>",
               "m.feb:35: Constraints/constraint: type 'volume': abut has rigid_wall\n"
               "m.feb:35: Physics: not supported here; valid: Module, Globals, Material, Mesh, "
               "MeshDomains, LoadData, Discrete, MeshAdaptor, MeshData, "
               "Boundary, Rigid, Loads, Contact, Initial, Constraints, Control, Step, Output"}));

TEST(BrokenFiles, EndWithAnErrorWhereverTheyAreCut) {
  const std::string whole = with({});
  for (std::size_t length = 0; length + 3 < whole.size(); length += 7) {
    const std::string message = error_of(whole.substr(0, length));
    EXPECT_EQ(message.compare(0, 6, "m.feb:"), 0) << length << ": " << message;
  }
}

} // namespace
