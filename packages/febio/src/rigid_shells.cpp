// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace abut::febio {

namespace {

/// How deep cells are behind their faces, in face sizes: contact takes a point for one that has
/// come in by a face until it lies in the middle of the body behind it.
constexpr double depth = 4.0;

/// A face of a shell and whether surfaces list it in the order of the element or against it.
struct Listed {
  bool forward = false, backward = false;
};

bool same_direction(const std::vector<Global>& a, const std::vector<Global>& b, std::size_t count) {
  const auto start = static_cast<std::size_t>(
      std::find(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(count), a[0]) - b.begin());
  return b[(start + 1) % count] == a[1];
}

class Extrusion {
public:
  explicit Extrusion(Model& model) : mesh_(model.mesh) {
    for (std::size_t n = 0; n < mesh_.node_id.size(); ++n) {
      index_.emplace(mesh_.node_id[n], n);
      last_node_ = std::max(last_node_, mesh_.node_id[n]);
    }
    for (const Domain& d : mesh_.domains)
      for (const Global id : d.id)
        last_element_ = std::max(last_element_, id);
    for (const Surface& s : mesh_.surfaces)
      for (const Facet& f : s.facets)
        facets_[key(f.nodes, f.corners)].push_back(&f);
  }

  /// Cells of their own behind each face: their back nodes are shared with none, so that no cell
  /// turns inside out where the shell is curved.
  void extrude(Domain& domain) {
    const Domain shell = domain;
    const std::size_t corners = domain.cell == fem::CellType::wedge6 ? 3 : 4;
    domain.id.clear();
    domain.lines.clear();
    domain.nodes.clear();
    for (std::size_t e = 0; e < shell.id.size(); ++e) {
      std::vector<Global> face(shell.nodes.begin() + static_cast<std::ptrdiff_t>(e * corners),
                               shell.nodes.begin() +
                                   static_cast<std::ptrdiff_t>((e + 1) * corners));
      const Listed listed = listing(face);
      if (listed.forward || !listed.backward)
        add(domain, face, shell.id[e], shell.lines[e]);
      std::reverse(face.begin(), face.end());
      if (listed.backward)
        add(domain, face, listed.forward ? ++last_element_ : shell.id[e], shell.lines[e]);
    }
  }

private:
  static std::vector<Global> key(const std::vector<Global>& nodes, std::size_t corners) {
    std::vector<Global> k(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(corners));
    std::sort(k.begin(), k.end());
    return k;
  }

  Listed listing(const std::vector<Global>& face) const {
    Listed result;
    const auto found = facets_.find(key(face, face.size()));
    if (found != facets_.end())
      for (const Facet* f : found->second)
        (same_direction(face, f->nodes, face.size()) ? result.forward : result.backward) = true;
    return result;
  }

  Vec3 position(Global id) const {
    const double* x = &mesh_.x[3 * index_.at(id)];
    return {{x[0], x[1], x[2]}};
  }

  /// The face becomes the upper one of its cell, whose normal points out.
  void add(Domain& domain, const std::vector<Global>& face, Global id, int line) {
    const Vec3 a = position(face[0]), b = position(face[1]), c = position(face[2]);
    const Vec3 area =
        face.size() == 3 ? 0.5 * cross(b - a, c - a) : 0.5 * cross(c - a, position(face[3]) - b);
    const double size = norm(area);
    const Vec3 back = size > 0.0 ? -depth / std::sqrt(size) * area : Vec3::zero();
    for (const Global node : face) {
      const Vec3 x = position(node) + back;
      mesh_.node_id.push_back(++last_node_);
      mesh_.x.insert(mesh_.x.end(), {x[0], x[1], x[2]});
      domain.nodes.push_back(last_node_);
    }
    domain.nodes.insert(domain.nodes.end(), face.begin(), face.end());
    domain.id.push_back(id);
    domain.lines.push_back(line);
  }

  Mesh& mesh_;
  std::map<Global, std::size_t> index_; ///< of node ids
  Global last_node_ = 0, last_element_ = 0;
  std::map<std::vector<Global>, std::vector<const Facet*>> facets_; ///< by their corners
};

} // namespace

void read_mesh_data(Element section, Model& model) {
  for (Element data : section.children()) {
    const std::string what = data.attribute("type").value_or(data.attribute_or("var", ""));
    const std::string set = data.attribute_or("elem_set", "");
    const auto domain = std::find_if(model.mesh.domains.begin(), model.mesh.domains.end(),
                                     [&](const Domain& d) { return d.is_shell && d.name == set; });
    if (data.name() != "ElementData" || what != "shell thickness" ||
        domain == model.mesh.domains.end()) {
      data.refuse("abut has no data that vary from element to element");
      continue;
    }
    std::vector<double> thickness;
    for (Element e : data.bulk()) {
      e.attribute("lid");
      const std::vector<double> t =
          e.numbers(domain->cell == fem::CellType::wedge6 ? std::size_t(3) : std::size_t(4));
      thickness.insert(thickness.end(), t.begin(), t.end());
    }
    const auto [least, most] = std::minmax_element(thickness.begin(), thickness.end());
    if (!thickness.empty() && *least == *most)
      domain->thickness = *least;
    else
      data.refuse("a rigid shell has one thickness, as <shell_thickness> of its <ShellDomain>");
  }
}

void extrude_rigid_shells(Model& model) {
  const auto is_rigid_shell = [&](const Domain& d) {
    const Material* material = model.material(d.material);
    return d.is_shell && material && material->is_rigid();
  };
  auto& domains = model.mesh.domains;
  if (std::none_of(domains.begin(), domains.end(), is_rigid_shell))
    return;
  Extrusion extrusion(model);
  for (Domain& d : domains)
    if (is_rigid_shell(d))
      extrusion.extrude(d);
}

} // namespace abut::febio
