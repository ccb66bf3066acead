// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

/// One model in the words of each specification: a cube on a rigid plate that rises, with a load of
/// each kind. Lines that a test changes have a number.
namespace abut::febio::test {

/// PRIMARY and SECONDARY in the words of before 3.0.
inline std::string in_old_words(std::string text) {
  const std::pair<std::string, std::string> words[] = {{"PRIMARY", "sla"
                                                                   "ve"},
                                                       {"SECONDARY", "ma"
                                                                     "ster"}};
  for (const auto& [word, old] : words)
    for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos;)
      text.replace(at, word.size(), old);
  return text;
}

inline std::string mesh_of(const std::string& lower, const std::string& plate,
                           const std::string& set_id) {
  std::string sets;
  const std::pair<const char*, std::string> lists[] = {{"bottom", "1 2 3 4"}, {"top", "5 6 7 8"}};
  for (const auto& [name, ids] : lists) {
    sets += std::string("<NodeSet name=\"") + name + "\">";
    for (const char c : ids)
      if (c != ' ')
        sets += "<" + set_id + " id=\"" + c + "\"/>";
    sets += "</NodeSet>\n";
  }
  return R"(<node id="1">0,0,0</node><node id="2">1,0,0</node><node id="3">1,1,0</node>
<node id="4">0,1,0</node><node id="5">0,0,1</node><node id="6">1,0,1</node>
<node id="7">1,1,1</node><node id="8">0,1,1</node><node id="11">0,0,1</node>
<node id="12">1,0,1</node><node id="13">1,1,1</node><node id="14">0,1,1</node>
<node id="15">0,0,2</node><node id="16">1,0,2</node><node id="17">1,1,2</node>
<node id="18">0,1,2</node></Nodes>
<Elements type="hex8" )" +
         lower + R"(><elem id="7">1,2,3,4,5,6,7,8</elem></Elements>
<Elements type="hex8" )" +
         plate + R"(><elem id="9">11,12,13,14,15,16,17,18</elem></Elements>
)" + sets +
         R"(<Surface name="low face"><quad4 id="1">5,6,7,8</quad4></Surface>
<Surface name="up_face"><quad4 id="1">14,13,12,11</quad4></Surface>
)";
}

inline const std::string& materials() {
  static const std::string text = R"(<Material>
<material id="1" name="soft one" type="neo-Hookean"><density>3</density><E>10</E><v>0.3</v></material>
<material id="2" name="plate" type="rigid body"><density>2</density></material>
</Material>
)";
  return text;
}

inline const std::string& contact_parameters() {
  static const std::string text = R"(<laugon>1</laugon><tolerance>0.05</tolerance>
<penalty>5</penalty><auto_penalty>1</auto_penalty><search_tol>0.02</search_tol><maxaug>7</maxaug>
)";
  return text;
}

/// Since 3.0.
inline std::string mesh_and_domains() {
  return "<Mesh><Nodes name=\"all\">" + mesh_of("name=\"lower\"", "name=\"upper\"", "n") +
         R"(<SurfacePair name="touch"><primary>low face</primary><secondary>up_face</secondary>
</SurfacePair></Mesh>
<MeshDomains><SolidDomain name="lower" mat="soft one"/><SolidDomain name="upper" mat="plate"/>
</MeshDomains>
)";
}

/// Since 3.0.
inline std::string loads_and_contact() {
  return R"(<Loads><nodal_load name="pull" type="nodal_load" node_set="top"><dof>y</dof>
<scale lc="2">0.25</scale></nodal_load>
<surface_load name="push" type="pressure" surface="low face"><pressure lc="1">0.3</pressure>
</surface_load>
<body_load type="const"><z lc="1">9.8</z></body_load></Loads>
<Contact><contact name="touch" type="sliding-facet-on-facet" surface_pair="touch">
)" + contact_parameters() +
         R"(</contact></Contact>
)";
}

inline std::string model_4_0() {
  return R"(<?xml version="1.0" encoding="ISO-8859-1"?>
<febio_spec version="4.0"><Module type="solid"><units>mm-N-s</units></Module>
<Control><analysis>STATIC</analysis><time_steps>4</time_steps><step_size>0.5</step_size>
<solver type="solid"><dtol>0.002</dtol><etol>0.03</etol><max_refs>15</max_refs></solver></Control>
)" + materials() +
         mesh_and_domains() +
         R"(<Boundary><bc name="hold" type="zero displacement" node_set="bottom">
<x_dof>1</x_dof><y_dof>1</y_dof><z_dof>1</z_dof></bc>
<bc name="shear" type="prescribed displacement" node_set="top"><dof>x</dof>
<value lc="1">0.1</value></bc></Boundary>
<Rigid><rigid_bc name="guide" type="rigid_fixed"><rb>plate</rb><Rx_dof>1</Rx_dof>
<Ru_dof>1</Ru_dof><Rv_dof>1</Rv_dof><Rw_dof>1</Rw_dof></rigid_bc>
<rigid_bc type="rigid_displacement"><rb>plate</rb><dof>z</dof><value lc="2">-0.2</value></rigid_bc>
<rigid_load type="rigid_force"><rb>plate</rb><dof>Ry</dof><value lc="1">0.5</value></rigid_load>
</Rigid>
)" + loads_and_contact() +
         R"(<LoadData><load_controller id="1" type="loadcurve"><interpolate>SMOOTH</interpolate>
<points><pt>0,0</pt><pt>1,0.5</pt><pt>2,1</pt></points></load_controller>
<load_controller id="2" type="loadcurve"><interpolate>STEP</interpolate><extend>REPEAT</extend>
<points><pt>0,0</pt><pt>1,1</pt></points></load_controller></LoadData>
<Output><plotfile type="febio"><var type="displacement"/></plotfile></Output>
</febio_spec>
)";
}

inline std::string model_3_0() {
  return R"(<?xml version="1.0" encoding="ISO-8859-1"?>
<febio_spec version="3.0"><Module type="solid"/>
<Control><analysis>STATIC</analysis><time_steps>4</time_steps><step_size>0.5</step_size>
<solver><dtol>0.002</dtol><etol>0.03</etol><max_refs>15</max_refs></solver></Control>
)" + materials() +
         mesh_and_domains() +
         R"(<Boundary><bc name="hold" type="fix" node_set="bottom"><dofs>x,y,z</dofs></bc>
<bc name="shear" type="prescribe" node_set="top"><dof>x</dof><scale lc="1">0.1</scale>
<relative>0</relative></bc></Boundary>
<Rigid><rigid_constraint name="guide" type="fix"><rb>2</rb><dofs>Rx,Ru,Rv,Rw</dofs>
</rigid_constraint>
<rigid_constraint type="prescribe"><rb>2</rb><dof>Rz</dof><value lc="2">-0.2</value>
</rigid_constraint>
<rigid_constraint type="force"><rb>plate</rb><dof>Ry</dof><value lc="1">0.5</value>
</rigid_constraint></Rigid>
)" + loads_and_contact() +
         R"(<LoadData><load_controller id="1" type="loadcurve"><interpolate>SMOOTH</interpolate>
<points><point>0,0</point><point>1,0.5</point><point>2,1</point></points></load_controller>
<load_controller id="2" type="loadcurve"><interpolate>STEP</interpolate><extend>REPEAT</extend>
<points><point>0,0</point><point>1,1</point></points></load_controller></LoadData>
<Output><plotfile type="febio"><var type="displacement"/></plotfile></Output>
</febio_spec>
)";
}

/// Before 3.0.
inline const std::string& old_control() {
  static const std::string text = R"(<Control><analysis type="static"/><time_steps>4</time_steps>
<step_size>0.5</step_size><max_refs>15</max_refs><max_ups>0</max_ups><dtol>0.002</dtol>
<etol>0.03</etol><rtol>0</rtol><lstol>0.9</lstol><optimize_bfgs>1</optimize_bfgs>
<plot_level>PLOT_MAJOR_ITRS</plot_level><print_level>PRINT_MINOR_ITRS</print_level></Control>
)";
  return text;
}

inline const std::string& old_load_data() {
  static const std::string text = R"(<LoadData>
<loadcurve id="1" type="smooth"><point>0,0</point><point>1,0.5</point><point>2,1</point></loadcurve>
<loadcurve id="2" type="step" extend="repeat"><loadpoint>0,0</loadpoint><loadpoint>1,1</loadpoint>
</loadcurve></LoadData>
<Output><plotfile type="febio"><var type="displacement"/></plotfile></Output>
</febio_spec>
)";
  return text;
}

inline const std::string& old_rigid_body() {
  static const std::string text = R"(<rigid_body mat="2"><fixed bc="x"/><fixed bc="Rx"/>
<fixed bc="Ry"/><fixed bc="Rz"/><prescribed bc="z" lc="2">-0.2</prescribed>
<force bc="y" lc="1">0.5</force></rigid_body>)";
  return text;
}

inline std::string model_2_5() {
  return in_old_words(
      R"(<?xml version="1.0" encoding="ISO-8859-1"?>
<febio_spec version="2.5"><Module type="solid"/>
)" + old_control() +
      materials() + "<Geometry><Nodes name=\"all\">" +
      mesh_of("name=\"lower\" mat=\"1\"", "name=\"upper\" mat=\"plate\"", "node") +
      R"(<SurfacePair name="touch"><SECONDARY surface="up_face"/><PRIMARY surface="low face"/>
</SurfacePair></Geometry>
<Boundary><fix name="hold" bc="x,y,z" node_set="bottom"/>
<prescribe name="shear" bc="x" node_set="top"><scale lc="1">1</scale><relative>0</relative>
<value>0.1</value></prescribe>
)" + old_rigid_body() +
      R"(</Boundary>
<Loads><nodal_load name="pull" bc="y" node_set="top"><scale lc="2">0.25</scale></nodal_load>
<surface_load name="push" type="pressure" surface="low face"><pressure lc="1">0.3</pressure>
</surface_load>
<body_load type="const"><z lc="1">9.8</z></body_load></Loads>
<Contact><contact name="touch" type="sliding-facet-on-facet" surface_pair="touch">
)" + contact_parameters() +
      "</contact></Contact>\n" + old_load_data());
}

inline std::string model_2_0() {
  return in_old_words(
      R"(<?xml version="1.0" encoding="ISO-8859-1"?>
<febio_spec version="2.0">
)" + old_control() +
      materials() + "<Geometry><Nodes set=\"all\">" +
      mesh_of("elset=\"lower\" mat=\"1\"", "elset=\"upper\" mat=\"2\"", "node") +
      R"(</Geometry>
<Boundary><fix name="hold" bc="xyz" set="bottom"/>
<prescribe name="shear" bc="x" lc="1" set="top">0.1</prescribe></Boundary>
<Constraints>)" +
      old_rigid_body() +
      R"(</Constraints>
<Loads><nodal_load name="pull" bc="y" lc="2" set="top" scale="0.25"/>
<surface_load name="push" type="pressure"><pressure lc="1">0.3</pressure><surface set="low face"/>
</surface_load>
<body_load type="const"><z lc="1">9.8</z></body_load></Loads>
<Contact><contact name="touch" type="facet-to-facet sliding">
)" + contact_parameters() +
      R"(<surface type="SECONDARY" set="up_face"/><surface type="PRIMARY" set="low face"/>
</contact></Contact>
)" + old_load_data());
}

/// The text with one piece of it replaced; throws where it is not there.
inline std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

} // namespace abut::febio::test
