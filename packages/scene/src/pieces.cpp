// SPDX-License-Identifier: BSD-3-Clause
#include "pieces.hpp"

#include "abut/mesh/components.hpp"

#include <algorithm>

namespace abut::scene {

namespace {

struct Extent {
  Global label;
  double low[3], high[3];
  int body;
};

/// The union of all ranks' extents, by label.
std::map<Global, Extent> on_all_ranks(const Comm& comm, const std::map<Global, Extent>& mine) {
  std::vector<Extent> list;
  for (const auto& entry : mine)
    list.push_back(entry.second);
  const std::vector<std::vector<Extent>> to_all(static_cast<std::size_t>(comm.size()), list);
  std::map<Global, Extent> all;
  for (const auto& part : comm.exchange(to_all))
    for (const Extent& e : part) {
      Extent& total = all.try_emplace(e.label, e).first->second;
      for (int i = 0; i < 3; ++i) {
        total.low[i] = std::min(total.low[i], e.low[i]);
        total.high[i] = std::max(total.high[i], e.high[i]);
      }
      total.body = std::min(total.body, e.body);
    }
  return all;
}

void extend(std::map<Global, Extent>& extents, const mesh::Mesh& mesh, Global label, Local n,
            int body) {
  const Extent start{label, {1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}, body};
  Extent& e = extents.try_emplace(label, start).first->second;
  for (int i = 0; i < 3; ++i) {
    const double x = mesh.x[3 * std::size_t(n) + std::size_t(i)];
    e.low[i] = std::min(e.low[i], x);
    e.high[i] = std::max(e.high[i], x);
  }
}

double half_size(const Extent& e) {
  double size = 0.0;
  for (int i = 0; i < 3; ++i)
    size = std::max(size, 0.5 * (e.high[i] - e.low[i]));
  return size;
}

} // namespace

Pieces::Pieces(const Options& options, const Scene& scene) : scene_(scene) {
  std::vector<char> deformable;
  for (const auto& material : scene.material)
    deformable.push_back(material.has_value());
  label_ = mesh::connected_pieces(*scene.mesh, deformable);
  find_deformable();
  find_bodies(options);
}

/// Deformable pieces by label, with centre, size and body.
void Pieces::find_deformable() {
  const mesh::Mesh& mesh = *scene_.mesh;
  std::map<Global, Extent> mine;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (Local n : mesh.blocks[b].nodes)
      if (scene_.material[b])
        extend(mine, mesh, label_[std::size_t(n)], n, scene_.body_of_block[b]);
  for (const auto& [id, e] : on_all_ranks(mesh.comm, mine)) {
    piece_of_label_[id] = pieces_.size();
    Piece& p = pieces_.emplace_back();
    for (int i = 0; i < 3; ++i)
      p.center[i] = 0.5 * (e.low[i] + e.high[i]);
    p.size = half_size(e);
    p.body = e.body;
  }
}

/// Rigid bodies with unknowns, about their own centers.
void Pieces::find_bodies(const Options& options) {
  const mesh::Mesh& mesh = *scene_.mesh;
  std::map<Global, Extent> mine;
  for (Local n = 0; n < mesh.num_local(); ++n)
    if (scene_.rigid_body_of_node[std::size_t(n)] >= 0)
      extend(mine, mesh, scene_.rigid_body_of_node[std::size_t(n)], n, 0);
  const auto extents = on_all_ranks(mesh.comm, mine);
  first_body_ = pieces_.size();
  piece_of_body_.assign(scene_.rigid_bodies.size(), none);
  for (std::size_t b = 0; b < scene_.rigid_bodies.size(); ++b) {
    if (!scene_.rigid_bodies[b].has_unknowns())
      continue;
    Piece p;
    p.center = scene_.rigid_bodies[b].center;
    const auto e = extents.find(static_cast<Global>(b));
    p.size = e != extents.end() ? half_size(e->second) : 0.0;
    if (p.size == 0.0)
      p.size = 1.0;
    while (options.bodies[std::size_t(p.body)].name != scene_.rigid_bodies[b].name)
      ++p.body;
    piece_of_body_[b] = pieces_.size();
    pieces_.push_back(p);
  }
}

std::size_t Pieces::deformable(Local n) const {
  const Global id = label_[std::size_t(n)];
  return id < 0 ? none : piece_of_label_.at(id);
}

std::size_t Pieces::mover(Local n) const {
  const int body = scene_.rigid_body_of_node[std::size_t(n)];
  return body >= 0 ? of_body(body) : deformable(n);
}

std::vector<std::vector<std::size_t>> Pieces::clusters() const {
  const mesh::Mesh& mesh = *scene_.mesh;
  std::vector<Global> pairs;
  for (Local n = 0; n < mesh.num_owned; ++n) {
    const std::size_t a = mover(n), b = deformable(n);
    if (a != none && b != none && a != b)
      pairs.insert(pairs.end(), {Global(a), Global(b)});
  }
  for (const rigid::Joint& joint : scene_.joints) {
    const std::size_t a = of_body(joint.body[0]), b = of_body(joint.body[1]);
    if (mesh.comm.is_root() && a != none && b != none)
      pairs.insert(pairs.end(), {Global(a), Global(b)});
  }
  std::vector<std::size_t> first(pieces_.size()); // of the cluster of each piece
  for (std::size_t i = 0; i < first.size(); ++i)
    first[i] = i;
  const std::vector<std::vector<Global>> to_all(static_cast<std::size_t>(mesh.comm.size()), pairs);
  for (const auto& list : mesh.comm.exchange(to_all))
    for (std::size_t i = 0; i < list.size(); i += 2) {
      const std::size_t a = first[std::size_t(list[i])], b = first[std::size_t(list[i + 1])];
      if (a != b)
        std::replace(first.begin(), first.end(), std::max(a, b), std::min(a, b));
    }
  std::map<std::size_t, std::vector<std::size_t>> by_first;
  for (std::size_t i = 0; i < first.size(); ++i)
    by_first[first[i]].push_back(i);
  std::vector<std::vector<std::size_t>> result;
  for (auto& entry : by_first)
    result.push_back(std::move(entry.second));
  return result;
}

} // namespace abut::scene
