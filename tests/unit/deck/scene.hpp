// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

/// One scene that uses every section, in both languages.
inline const std::string yaml_scene = R"(title: ball on floor
mesh:
  file: ball.exo
surfaces:
  lid: {body: ball, plane: {point: [0, 0, 1], normal: [0, 0, 2]}, normal: {direction: [0, 0, 1], angle: 10}}
  rim: {blocks: [ball, 3], node_set: rim, within: 0.01, cylinder: {point: [0, 0, 0], axis: [0, 0, 1], radius: 2}}
  rest: {part_of: skin, join: [rim], subtract: [lid], sphere: {center: [0, 0, 0], radius: 1},
         box: {low: [-1, -1, -1], high: [1, 1, 1]}}
materials:
  rubber: {model: neo_hookean, young: 10, poisson: 0.3}
bodies:
  ball: {blocks: [ball, core], material: rubber}
  floor:
    blocks: [floor]
    rigid: {displacement: [0, 0, 0.1], rotation: [0, 0, 1e-3], center: [1, 2, 3], curve: up}
displacements:
  top: {set: top, z: -0.5, fix: [x, y]}
loads:
  wind: {traction: [1, 0, 0], side_set: skin, curve: up}
  air: {pressure: 2.5, side_set: inside}
  weight: {body_force: [0, 0, -9.81], block: ball}
  pull: {force: [0, 0, 1], node_set: hook}
curves:
  up: [[0, 0], [0.5, 1], [1, 1]]
contact:
  ball_on_floor:
    primary: ball_bottom
    secondary: floor_top
    enforcement: augmented_lagrangian
    penalty_factor: 20
    gap_tolerance: 1e-3
time: {steps: 4, adaptive: false}
newton: {tolerance: 1e-9, line_search: none}
linear_solver: {method: krylov, direct_limit: 1e5, preconditioner: ilu}
output: {name: ball, every: 2}
trilinos:
  NOX:
    Line Search: {Method: Full Step}
  MueLu: {verbosity: none, "max levels": 3, "sa: damping factor": 1.5, "repartition: enable": false,
          "coarse: sizes": [1, 2], weights: [1, 0.5], names: [a, b]}
verify:
  down: {quantity: force_z, place: ball_on_floor, expected: -3, relative_tolerance: 0.02, source: Hertz}
  lift: {quantity: displacement_z, point: [0, 0, 1], expected: -0.5, tolerance: 1e-9}
)";

inline const std::string xml_scene = R"xml(<?xml version="1.0"?>
<!-- the same scene; <ParameterList name="not this"> -->
<ParameterList name="deck">
  <Parameter name="title" type="string" value="ball on floor"/>
  <ParameterList name="mesh"><Parameter name="file" type="string" value="ball.exo"/></ParameterList>
  <ParameterList name="surfaces">
    <ParameterList name="lid">
      <Parameter name="body" type="string" value="ball"/>
      <ParameterList name="plane">
        <Parameter name="point" type="Array(double)" value="{0, 0, 1}"/>
        <Parameter name="normal" type="Array(double)" value="{0, 0, 2}"/>
      </ParameterList>
      <ParameterList name="normal">
        <Parameter name="direction" type="Array(double)" value="{0, 0, 1}"/>
        <Parameter name="angle" type="double" value="10"/>
      </ParameterList>
    </ParameterList>
    <ParameterList name="rim">
      <Parameter name="blocks" type="Array(string)" value="{ball, 3}"/>
      <Parameter name="node_set" type="string" value="rim"/>
      <Parameter name="within" type="double" value="0.01"/>
      <ParameterList name="cylinder">
        <Parameter name="point" type="Array(double)" value="{0, 0, 0}"/>
        <Parameter name="axis" type="Array(double)" value="{0, 0, 1}"/>
        <Parameter name="radius" type="double" value="2"/>
      </ParameterList>
    </ParameterList>
    <ParameterList name="rest">
      <Parameter name="part_of" type="string" value="skin"/>
      <Parameter name="join" type="Array(string)" value="{rim}"/>
      <Parameter name="subtract" type="Array(string)" value="{lid}"/>
      <ParameterList name="sphere">
        <Parameter name="center" type="Array(double)" value="{0, 0, 0}"/>
        <Parameter name="radius" type="double" value="1"/>
      </ParameterList>
      <ParameterList name="box">
        <Parameter name="low" type="Array(double)" value="{-1, -1, -1}"/>
        <Parameter name="high" type="Array(double)" value="{1, 1, 1}"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="materials">
    <ParameterList name="rubber">
      <Parameter name="model" type="string" value="neo_hookean"/>
      <Parameter name="young" type="int" value="10"/>
      <Parameter name="poisson" type="double" value="0.3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="bodies">
    <ParameterList name="ball">
      <Parameter name="blocks" type="Array(string)" value="{ball, core}"/>
      <Parameter name="material" type="string" value="rubber"/>
    </ParameterList>
    <ParameterList name="floor">
      <Parameter name="blocks" type="Array(string)" value="{floor}"/>
      <ParameterList name="rigid">
        <Parameter name="displacement" type="Array(double)" value="{0, 0, 0.1}"/>
        <Parameter name="rotation" type="Array(double)" value="{0, 0, 1e-3}"/>
        <Parameter name="center" type="Array(int)" value="{1, 2, 3}"/>
        <Parameter name="curve" type="string" value="up"/>
      </ParameterList>
    </ParameterList>
  </ParameterList>
  <ParameterList name="displacements">
    <ParameterList name="top">
      <Parameter name="set" type="string" value="top"/>
      <Parameter name="z" type="double" value="-0.5"/>
      <Parameter name="fix" type="Array(string)" value="{x, y}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="loads">
    <ParameterList name="wind">
      <Parameter name="traction" type="Array(double)" value="{1, 0, 0}"/>
      <Parameter name="side_set" type="string" value="skin"/>
      <Parameter name="curve" type="string" value="up"/>
    </ParameterList>
    <ParameterList name="air">
      <Parameter name="pressure" type="double" value="2.5"/>
      <Parameter name="side_set" type="string" value="inside"/>
    </ParameterList>
    <ParameterList name="weight">
      <Parameter name="body_force" type="Array(double)" value="{0, 0, -9.81}"/>
      <Parameter name="block" type="string" value="ball"/>
    </ParameterList>
    <ParameterList name="pull">
      <Parameter name="force" type="Array(double)" value="{0, 0, 1}"/>
      <Parameter name="node_set" type="string" value="hook"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="curves">
    <Parameter name="up" type="TwoDArray(double)" value="3x2:{0, 0, 0.5, 1, 1, 1}"/>
  </ParameterList>
  <ParameterList name="contact">
    <ParameterList name="ball_on_floor">
      <Parameter name="primary" type="string" value="ball_bottom"/>
      <Parameter name="secondary" type="string" value="floor_top"/>
      <Parameter name="enforcement" type="string" value="augmented_lagrangian"/>
      <Parameter name="penalty_factor" type="double" value="20"/>
      <Parameter name="gap_tolerance" type="double" value="1e-3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="time">
    <Parameter name="steps" type="int" value="4"/>
    <Parameter name="adaptive" type="bool" value="false"/>
  </ParameterList>
  <ParameterList name="newton">
    <Parameter name="tolerance" type="double" value="1e-9"/>
    <Parameter name="line_search" type="string" value="none"/>
  </ParameterList>
  <ParameterList name="linear_solver">
    <Parameter name="method" type="string" value="krylov"/>
    <Parameter name="direct_limit" type="int" value="100000"/>
    <Parameter name="preconditioner" type="string" value="ilu"/>
  </ParameterList>
  <ParameterList name="output">
    <Parameter name="name" type="string" value="ball"/>
    <Parameter name="every" type="int" value="2"/>
  </ParameterList>
  <ParameterList name="trilinos">
    <ParameterList name="NOX">
      <ParameterList name="Line Search">
        <Parameter name="Method" type="string" value="Full Step"/>
      </ParameterList>
    </ParameterList>
    <ParameterList name="MueLu">
      <Parameter name="verbosity" type="string" value="none"/>
      <Parameter name="max levels" type="int" value="3"/>
      <Parameter name="sa: damping factor" type="double" value="1.5"/>
      <Parameter name="repartition: enable" type="bool" value="false"/>
      <Parameter name="coarse: sizes" type="Array(int)" value="{1, 2}"/>
      <Parameter name="weights" type="Array(double)" value="{1, 0.5}"/>
      <Parameter name="names" type="Array(string)" value="{a, b}"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="verify">
    <ParameterList name="down">
      <Parameter name="quantity" type="string" value="force_z"/>
      <Parameter name="place" type="string" value="ball_on_floor"/>
      <Parameter name="expected" type="double" value="-3"/>
      <Parameter name="relative_tolerance" type="double" value="0.02"/>
      <Parameter name="source" type="string" value="Hertz"/>
    </ParameterList>
    <ParameterList name="lift">
      <Parameter name="quantity" type="string" value="displacement_z"/>
      <Parameter name="point" type="Array(double)" value="{0, 0, 1}"/>
      <Parameter name="expected" type="double" value="-0.5"/>
      <Parameter name="tolerance" type="double" value="1e-9"/>
    </ParameterList>
  </ParameterList>
</ParameterList>
)xml";
