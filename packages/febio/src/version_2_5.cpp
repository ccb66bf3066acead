// SPDX-License-Identifier: BSD-3-Clause
#include "versions.hpp"

#include <algorithm>
#include <cstring>

namespace abut::febio {

namespace {

/// Parameters of the solver stand beside those of the steps before 3.0.
constexpr const char* solver_words[] = {"dtol",
                                        "etol",
                                        "rtol",
                                        "lstol",
                                        "lsmin",
                                        "lsiter",
                                        "lscheck_jacobians",
                                        "ls_check_jacobians",
                                        "max_refs",
                                        "max_ups",
                                        "qnmethod",
                                        "qn_method",
                                        "cmax",
                                        "cycle_buffer",
                                        "max_buffer_size",
                                        "check_zero_diagonal",
                                        "zero_diagonal_tol",
                                        "reform_each_time_step",
                                        "reform_augment",
                                        "diverge_reform",
                                        "do_augmentations",
                                        "min_residual",
                                        "max_residual",
                                        "symmetric_stiffness",
                                        "optimize_bw",
                                        "optimize_bfgs",
                                        "bandwidth_opt",
                                        "linear_solver",
                                        "equation_scheme",
                                        "equation_order",
                                        "force_partition",
                                        "logSolve",
                                        "arc_length",
                                        "arc_length_scale",
                                        "alpha",
                                        "beta",
                                        "gamma",
                                        "rhoi",
                                        "msymm",
                                        "augment",
                                        "print_stiffness_matrix"};

class Translation {
public:
  explicit Translation(Tree& tree) : tree_(tree), root_(tree.root()) {}

  void run() {
    if (!root_.child("Geometry"))
      tree_.fail(root_, "expected an element <Geometry> in it");
    geometry_to_mesh(tree_);
    for (const pugi::xml_node phase : phases(tree_)) {
      for (pugi::xml_node control : child_elements(phase, "Control"))
        this->control(control);
      boundary(phase);
      initial(phase);
      for (pugi::xml_node loads : child_elements(phase, "Loads"))
        for (pugi::xml_node load : child_elements(loads, "nodal_load"))
          nodal_load(load);
      contact(phase);
    }
    for (pugi::xml_node data : child_elements(root_, "LoadData"))
      for (pugi::xml_node curve : child_elements(data, "loadcurve"))
        load_curve(curve);
    steps();
  }

private:
  void control(pugi::xml_node control) {
    for (pugi::xml_node analysis : child_elements(control, "analysis"))
      if (const auto type = take_attribute(analysis, "type"))
        analysis.text().set(*type == "transient"
                                ? "dynamic"
                                : (*type == "steady-state" ? "static" : type->c_str()));
    for (pugi::xml_node child : child_elements(control)) {
      const auto is = [&](const char* word) { return std::strcmp(child.name(), word) == 0; };
      if (std::any_of(std::begin(solver_words), std::end(solver_words), is))
        tree_.child(control, "solver", child).append_move(child);
      else if (is("print_level") || is("restart") || is("debug") || is("shell_formulation") ||
               is("shell_normal_nodal") || is("use_three_field_shell"))
        tree_.settle(child, Fate::ignored, "it cannot change what abut does");
      else if (is("use_three_field_hex") || is("use_three_field_tet"))
        three_field(child);
    }
  }

  /// FEBio's own choice is the one that abut has.
  void three_field(pugi::xml_node child) {
    const bool usual = text_of(child) == (std::strstr(child.name(), "hex") ? "1" : "0");
    tree_.settle(child, usual ? Fate::ignored : Fate::refused,
                 usual ? "it is so anyway"
                       : "abut takes a mean dilatation for hex8 of uncoupled materials alone: "
                         "change 'element' in the deck");
  }

  void boundary(pugi::xml_node phase) {
    for (pugi::xml_node section : child_elements(phase, "Boundary"))
      for (pugi::xml_node node : child_elements(section)) {
        const auto is = [&](const char* word) { return std::strcmp(node.name(), word) == 0; };
        if (is("fix"))
          condition(node, "fix", "dofs");
        else if (is("prescribe"))
          condition(node, "prescribe", "dof");
        else if (is("rigid"))
          rigid_nodes(node);
        else if (is("rigid_body"))
          rigid_body(node, phase);
      }
  }

  void condition(pugi::xml_node node, const char* type, const char* dofs) {
    const auto bc = take_attribute(node, "bc");
    if (!bc)
      tree_.fail(node, "expected an attribute 'bc'");
    tree_.rename(node, "bc");
    node.append_attribute("type").set_value(type);
    if (const auto surface = take_attribute(node, "surface"))
      node.append_attribute("node_set").set_value(("@surface:" + *surface).c_str());
    tree_.append_text(node, dofs, *bc, node);
    merge_scale_and_value(tree_, node);
  }

  void rigid_nodes(pugi::xml_node node) {
    const auto body = take_attribute(node, "rb");
    tree_.rename(node, "bc");
    node.append_attribute("type").set_value("rigid");
    if (body)
      tree_.append_text(node, "rb", *body, node);
  }

  /// What holds, moves and loads a rigid body: each child an element of <Rigid>.
  void rigid_body(pugi::xml_node body, pugi::xml_node phase) {
    const auto material = take_attribute(body, "mat");
    if (!material)
      tree_.fail(body, "expected an attribute 'mat'");
    pugi::xml_node rigid = tree_.child(phase, "Rigid", body);
    for (pugi::xml_node part : child_elements(body)) {
      const std::string word = part.name();
      if (word == "fixed")
        rigid_part(part, "fix", "dofs");
      else if (word == "prescribed")
        rigid_part(part, "prescribe", "dof");
      else if (word == "force")
        rigid_part(part, "force", "dof");
      else if (word == "initial_velocity" || word == "initial_angular_velocity")
        rigid_part(part,
                   word == "initial_velocity" ? "initial_rigid_velocity"
                                              : "initial_rigid_angular_velocity",
                   nullptr);
      else
        continue;
      tree_.append_text(rigid.append_move(part), "rb", *material, part);
    }
    if (child_elements(body).empty())
      body.parent().remove_child(body);
  }

  void rigid_part(pugi::xml_node part, const char* type, const char* dofs) {
    const std::string number = text_of(part);
    const auto bc = take_attribute(part, "bc"), curve = take_attribute(part, "lc"),
               kind = take_attribute(part, "type");
    while (part.first_child())
      part.remove_child(part.first_child());
    tree_.rename(part, "rigid_constraint");
    part.append_attribute("type").set_value(type);
    if (dofs) {
      if (!bc)
        tree_.fail(part, "expected an attribute 'bc'");
      tree_.append_text(part, dofs, rigid_dof(part, *bc), part);
    }
    if (std::strcmp(type, "fix") == 0)
      return;
    pugi::xml_node value = tree_.append(part, "value", part);
    value.text().set(number.c_str());
    if (curve && *curve != "0")
      value.append_attribute("lc").set_value(curve->c_str());
    if (kind)
      kind_of(part, *kind);
  }

  /// Before 3.0 Rx is the rotation about x, since then a displacement along it.
  std::string rigid_dof(pugi::xml_node part, const std::string& bc) const {
    const char* const old[] = {"x", "y", "z", "Rx", "Ry", "Rz"};
    const char* const now[] = {"Rx", "Ry", "Rz", "Ru", "Rv", "Rw"};
    for (std::size_t i = 0; i < 6; ++i)
      if (bc == old[i])
        return now[i];
    tree_.fail(part, "expected x, y, z, Rx, Ry or Rz as bc, got '" + bc + "'");
  }

  void kind_of(pugi::xml_node part, const std::string& kind) {
    if (kind == "relative")
      tree_.append_text(part, "relative", "1", part);
    else if (kind == "follow")
      tree_.append_text(part, "load_type", "FOLLOW", part);
    else if (kind == "ramp")
      tree_.append_text(part, "load_type", "TARGET", part);
    else if (kind != "absolute")
      tree_.fail(part, "type '" + kind + "' is none that FEBio has");
  }

  void initial(pugi::xml_node phase) {
    for (pugi::xml_node section : child_elements(phase, "Initial"))
      for (pugi::xml_node node : child_elements(section)) {
        if (std::strcmp(node.name(), "rigid_body") == 0)
          rigid_body(node, phase);
        else if (std::strcmp(node.name(), "init") == 0)
          initial_component(node, section);
      }
  }

  /// One component of a velocity; those of one set are one condition.
  void initial_component(pugi::xml_node node, pugi::xml_node section) {
    const std::string bc = trimmed(node.attribute("bc").value());
    const char* const words[] = {"vx", "vy", "vz"};
    const auto word = std::find(std::begin(words), std::end(words), bc);
    if (word == std::end(words) || node.child("value").attribute("node_data"))
      return;
    const char* const set = node.attribute("node_set").value();
    pugi::xml_node ic = section.find_child_by_attribute("ic", "node_set", set);
    if (!ic) {
      ic = tree_.append(section, "ic", node);
      ic.append_attribute("type").set_value("velocity");
      ic.append_attribute("node_set").set_value(set);
      tree_.append_text(ic, "value", "0,0,0", node);
    }
    std::vector<std::string> parts = words_of(text_of(ic.child("value")), ",");
    if (parts.size() != 3)
      tree_.fail(node, "velocities of node set '" + std::string(set) + "' are given twice");
    parts[static_cast<std::size_t>(word - std::begin(words))] = text_of(node.child("value"));
    const std::string all = parts[0] + "," + parts[1] + "," + parts[2];
    ic.child("value").text().set(all.c_str());
    section.remove_child(node);
  }

  void nodal_load(pugi::xml_node load) {
    const auto bc = take_attribute(load, "bc");
    if (!bc)
      return;
    load.append_attribute("type").set_value("nodal_load");
    tree_.append_text(load, "dof", *bc, load);
    merge_scale_and_value(tree_, load);
  }

  void contact(pugi::xml_node phase) {
    const std::pair<const char*, const char*> types[] = {
        {"sliding_with_gaps", "sliding-node-on-facet"},
        {"facet-to-facet sliding", "sliding-facet-on-facet"},
        {"sliding-tension-compression", "sliding-elastic"},
        {"tied", "tied-node-on-facet"},
        {"facet-to-facet tied", "tied-facet-on-facet"}};
    for (pugi::xml_node section : child_elements(phase, "Contact"))
      for (pugi::xml_node contact : child_elements(section, "contact"))
        for (const auto& [old, name] : types)
          if (trimmed(contact.attribute("type").value()) == old)
            contact.attribute("type").set_value(name);
  }

  void load_curve(pugi::xml_node curve) {
    tree_.rename(curve, "load_controller");
    const auto type = take_attribute(curve, "type"), extend = take_attribute(curve, "extend");
    curve.append_attribute("type").set_value("loadcurve");
    const auto points = child_elements(curve);
    if (type)
      tree_.append_text(curve, "interpolate", *type, curve);
    if (extend)
      tree_.append_text(curve, "extend", *extend, curve);
    pugi::xml_node list = tree_.append(curve, "points", curve);
    for (pugi::xml_node point : points) {
      list.append_move(point);
      if (std::strcmp(point.name(), "loadpoint") == 0)
        tree_.rename(point, "point");
    }
  }

  /// Before 3.0 each step is a <Step> of its own.
  void steps() {
    const auto steps = child_elements(root_, "Step");
    if (steps.empty())
      return;
    pugi::xml_node all = tree_.insert_before(steps.front(), "Step");
    for (pugi::xml_node step : steps) {
      tree_.rename(step, "step");
      all.append_move(step);
    }
  }

  Tree& tree_;
  pugi::xml_node root_;
};

} // namespace

void from_2_5(Tree& tree) {
  Translation(tree).run();
}

} // namespace abut::febio
