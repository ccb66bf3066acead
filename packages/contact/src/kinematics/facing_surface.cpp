// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/facing_surface.hpp"

#include "kinematics/facet_rise.hpp"
#include "kinematics/primary_surface.hpp"

#include <algorithm>
#include <unordered_map>

namespace abut::contact {

using search::Box;

FacingSurface::FacingSurface(const Comm& comm, const mesh::Surface& own, double reach)
    : comm_(comm), own_(own), reach_(reach), rise_(facet_rises(comm, own)) {}

namespace {

/// A face on its way to another rank, followed by its node ids.
struct FaceRecord {
  Global face_id;
  int type;
  int nodes;
  double size, modulus, inverse_depth, thickness, rise[2];
};

/// Every rank's boxes, one list for each rank.
std::vector<std::vector<Box<3>>> share_boxes(const Comm& comm, const std::vector<Box<3>>& mine) {
  std::vector<double> packed;
  for (const Box<3>& b : mine) {
    packed.insert(packed.end(), b.low, b.low + 3);
    packed.insert(packed.end(), b.high, b.high + 3);
  }
  const auto counts = comm.all_gather(static_cast<Global>(mine.size()));
  packed = comm.all_gather(packed);
  std::vector<std::vector<Box<3>>> boxes(counts.size());
  const double* p = packed.data();
  for (std::size_t r = 0; r < counts.size(); ++r)
    for (Global k = 0; k < counts[r]; ++k, p += 6) {
      Box<3> b;
      std::copy_n(p, 3, b.low);
      std::copy_n(p + 3, 3, b.high);
      boxes[r].push_back(b);
    }
  return boxes;
}

} // namespace

/// Faces on their way, per rank: records, their node ids, and each node's id once.
struct FacingSurface::Parcels {
  explicit Parcels(std::size_t ranks) : faces(ranks), face_nodes(ranks), nodes(ranks) {}
  std::vector<std::vector<FaceRecord>> faces;
  std::vector<std::vector<Global>> face_nodes, nodes;
};

void FacingSurface::collect(const std::vector<double>& x_own, const std::vector<double>& x_previous,
                            const std::vector<Box<3>>& wanted, bool at_rest) {
  const auto ranks = static_cast<std::size_t>(comm_.size());
  const auto wanted_by = share_boxes(comm_, wanted);
  const std::vector<double> sizes = face_sizes(own_);
  std::vector<Box<3>> boxes;
  for (Local f = 0; f < own_.num_faces(); ++f) {
    Box<3> box = Box<3>::empty();
    for (Local a = own_.offset[f]; a < own_.offset[f + 1]; ++a)
      box.add(&x_own[std::size_t(own_.nodes[a]) * 3]);
    box.inflate(reach_ * sizes[f]);
    boxes.push_back(box);
  }
  Parcels out(ranks), in(0);
  send_nodes_.assign(ranks, {});
  for (std::size_t r = 0; r < ranks; ++r) {
    std::vector<char> taken(own_.node.size(), 0);
    for (Local f = 0; f < own_.num_faces(); ++f)
      if (std::any_of(wanted_by[r].begin(), wanted_by[r].end(),
                      [&](const Box<3>& b) { return b.overlaps(boxes[f]); }))
        pack(f, sizes[f], r, taken, out);
  }
  in.faces = comm_.exchange(out.faces);
  in.face_nodes = comm_.exchange(out.face_nodes);
  in.nodes = comm_.exchange(out.nodes);
  unpack(in);
  fetch(x_previous, view_.x_previous);
  if (at_rest)
    fetch(own_.x, view_.x_reference);
  update(x_own);
}

void FacingSurface::pack(Local f, double size, std::size_t rank, std::vector<char>& taken,
                         Parcels& out) {
  const Local n = own_.offset[f + 1] - own_.offset[f];
  out.faces[rank].push_back({own_.face_id[f],
                             static_cast<int>(own_.type[f]),
                             n,
                             size,
                             own_.modulus[f],
                             own_.inverse_depth[f],
                             own_.thickness_behind(f),
                             {rise_[std::size_t(2 * f)], rise_[std::size_t(2 * f + 1)]}});
  for (Local a = own_.offset[f]; a < own_.offset[f + 1]; ++a) {
    const Local node = own_.nodes[a];
    out.face_nodes[rank].push_back(own_.node[node]);
    if (taken[node])
      continue;
    taken[node] = 1;
    send_nodes_[rank].push_back(node);
    out.nodes[rank].push_back(own_.node[node]);
  }
}

void FacingSurface::unpack(const Parcels& in) {
  std::vector<Global> node;
  receive_nodes_.assign(in.nodes.size(), {});
  std::unordered_map<Global, Local> index;
  for (std::size_t r = 0; r < in.nodes.size(); ++r)
    for (Global g : in.nodes[r]) {
      const auto [it, is_new] = index.try_emplace(g, static_cast<Local>(node.size()));
      if (is_new)
        node.push_back(g);
      receive_nodes_[r].push_back(it->second);
    }
  struct Arrived {
    FaceRecord face;
    const Global* nodes;
  };
  std::vector<Arrived> all;
  for (std::size_t r = 0; r < in.faces.size(); ++r) {
    const Global* p = in.face_nodes[r].data();
    for (const FaceRecord& f : in.faces[r]) {
      all.push_back({f, p});
      p += f.nodes;
    }
  }
  std::sort(all.begin(), all.end(),
            [](const Arrived& a, const Arrived& b) { return a.face.face_id < b.face.face_id; });
  FacingView v;
  v.face_type = make_view<fem::FaceType>("abut::contact::facing_type", all.size());
  v.face_id = make_view<Global>("abut::contact::facing_id", all.size());
  v.face_size = make_view<double>("abut::contact::facing_size", all.size());
  v.face_modulus = make_view<double>("abut::contact::facing_modulus", all.size());
  v.face_inverse_depth = make_view<double>("abut::contact::facing_inverse_depth", all.size());
  v.face_thickness = make_view<double>("abut::contact::facing_thickness", all.size());
  v.face_rise = make_view<double>("abut::contact::facing_rise", 2 * all.size());
  std::vector<Local> offset{0}, face_node;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const FaceRecord& face = all[i].face;
    v.face_type(i) = static_cast<fem::FaceType>(face.type);
    v.face_id(i) = face.face_id;
    v.face_size(i) = face.size;
    v.face_modulus(i) = face.modulus;
    v.face_inverse_depth(i) = face.inverse_depth;
    v.face_thickness(i) = face.thickness;
    std::copy_n(face.rise, 2, &v.face_rise(2 * i));
    v.largest_size = std::max(v.largest_size, face.size);
    for (int k = 0; k < face.nodes; ++k)
      face_node.push_back(index.at(all[i].nodes[k]));
    offset.push_back(static_cast<Local>(face_node.size()));
  }
  v.offset = make_view("abut::contact::facing_offset", offset);
  v.face_node = make_view("abut::contact::facing_face_node", face_node);
  v.node = make_view("abut::contact::facing_node", node);
  v.x = make_view("abut::contact::facing_x", node.size(), Vec3::zero());
  v.x_previous = make_view("abut::contact::facing_x_previous", node.size(), Vec3::zero());
  v.x_reference = make_view("abut::contact::facing_x_reference", node.size(), Vec3::zero());
  view_ = v;
  tree_ = {};
}

/// Values at the nodes of the collected faces from those of the own nodes, (nodes, 3). Collective.
void FacingSurface::fetch(const std::vector<double>& x_own, View<Vec3>& x) const {
  std::vector<std::vector<double>> send(send_nodes_.size());
  for (std::size_t r = 0; r < send.size(); ++r)
    for (Local n : send_nodes_[r])
      send[r].insert(send[r].end(), &x_own[std::size_t(n) * 3], &x_own[std::size_t(n) * 3] + 3);
  const auto arrived = comm_.exchange(send);
  for (std::size_t r = 0; r < arrived.size(); ++r)
    for (std::size_t k = 0; k < receive_nodes_[r].size(); ++k)
      std::copy_n(&arrived[r][3 * k], 3, x(receive_nodes_[r][k]).v);
}

/// A node that came from several ranks goes back to one of them.
std::vector<double> FacingSurface::give_back(const std::vector<double>& values,
                                             std::size_t width) const {
  std::vector<std::vector<double>> send(std::size_t(comm_.size()));
  std::vector<char> gone(values.size() / width, 0);
  for (std::size_t r = 0; r < receive_nodes_.size(); ++r)
    for (const Local n : receive_nodes_[r])
      for (std::size_t k = 0; k < width; ++k) {
        send[r].push_back(gone[std::size_t(n)] ? 0.0 : values[std::size_t(n) * width + k]);
        gone[std::size_t(n)] = char(gone[std::size_t(n)] || k + 1 == width);
      }
  const auto arrived = comm_.exchange(send);
  std::vector<double> sums(own_.node.size() * width, 0.0);
  for (std::size_t r = 0; r < send_nodes_.size(); ++r)
    for (std::size_t i = 0; i < send_nodes_[r].size(); ++i)
      for (std::size_t k = 0; k < width; ++k)
        sums[std::size_t(send_nodes_[r][i]) * width + k] += arrived[r][i * width + k];
  return sums;
}

void FacingSurface::update(const std::vector<double>& x_own) {
  fetch(x_own, view_.x);
  std::vector<Box<3>> boxes;
  for (Local f = 0; f < view_.faces(); ++f) {
    Box<3> box = Box<3>::empty();
    for (Local a = view_.offset(f); a < view_.offset(f + 1); ++a)
      box.add(view_.x(view_.face_node(a)).v);
    box.inflate(0.05 * view_.size(f)); // a projection may lie a little outside; faces may bulge
    boxes.push_back(box);
  }
  if (tree_.size() == view_.faces())
    tree_.refit(boxes);
  else
    tree_.build(boxes);
  view_.tree = tree_.view();
}

} // namespace abut::contact
