// SPDX-License-Identifier: BSD-3-Clause
#include "abut/contact/facing_surface.hpp"

#include "abut/core/error.hpp"
#include "abut/fem/face_map.hpp"
#include "abut/fem/quadrature.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace abut::contact {

using search::Box;

std::vector<double> face_sizes(const mesh::Surface& s) {
  std::vector<double> sizes;
  for (Local f = 0; f < s.num_faces(); ++f) {
    Vec3 x[fem::max_face_nodes];
    for (Local a = s.offset[f]; a < s.offset[f + 1]; ++a)
      for (int i = 0; i < 3; ++i)
        x[a - s.offset[f]][i] = s.x[std::size_t(s.nodes[a]) * 3 + i];
    const fem::Rule<2> rule = fem::face_rule(s.type[f], 2);
    double area = 0.0;
    for (int p = 0; p < rule.size(); ++p) {
      fem::FacePoint<double> point;
      fem::face_point(s.type[f], x, rule.xi[p].data(), point);
      area += rule.weight[p] * norm(cross(point.tangent[0], point.tangent[1]));
    }
    sizes.push_back(std::sqrt(area));
  }
  return sizes;
}

FacingSurface::FacingSurface(const Comm& comm, const mesh::Surface& own, double reach)
    : comm_(comm), own_(own), reach_(reach) {}

namespace {

/// A face on its way to another rank, followed by its node ids.
struct FaceRecord {
  Global face_id;
  int type;
  int nodes;
  double size, modulus, inverse_depth;
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
                            const std::vector<Box<3>>& wanted) {
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
  fetch(x_previous, x_previous_);
  update(x_own);
}

void FacingSurface::pack(Local f, double size, std::size_t rank, std::vector<char>& taken,
                         Parcels& out) {
  const Local n = own_.offset[f + 1] - own_.offset[f];
  out.faces[rank].push_back({own_.face_id[f], static_cast<int>(own_.type[f]), n, size,
                             own_.modulus[f], own_.inverse_depth[f]});
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
  node_.clear();
  receive_nodes_.assign(in.nodes.size(), {});
  std::unordered_map<Global, Local> index;
  for (std::size_t r = 0; r < in.nodes.size(); ++r)
    for (Global g : in.nodes[r]) {
      const auto [it, is_new] = index.try_emplace(g, static_cast<Local>(node_.size()));
      if (is_new)
        node_.push_back(g);
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
  type_.clear(), face_id_.clear(), size_.clear(), modulus_.clear(), inverse_depth_.clear();
  offset_.assign(1, 0);
  face_nodes_.clear();
  for (const Arrived& a : all) {
    type_.push_back(static_cast<fem::FaceType>(a.face.type));
    face_id_.push_back(a.face.face_id);
    size_.push_back(a.face.size);
    modulus_.push_back(a.face.modulus);
    inverse_depth_.push_back(a.face.inverse_depth);
    for (int k = 0; k < a.face.nodes; ++k)
      face_nodes_.push_back(index.at(a.nodes[k]));
    offset_.push_back(static_cast<Local>(face_nodes_.size()));
  }
  largest_size_ = size_.empty() ? 0.0 : *std::max_element(size_.begin(), size_.end());
  x_.assign(node_.size() * 3, 0.0);
  x_previous_ = x_;
  tree_ = {};
}

/// Values at the nodes of the collected faces from those of the own nodes, (nodes, 3). Collective.
void FacingSurface::fetch(const std::vector<double>& x_own, std::vector<double>& x) const {
  std::vector<std::vector<double>> send(send_nodes_.size());
  for (std::size_t r = 0; r < send.size(); ++r)
    for (Local n : send_nodes_[r])
      send[r].insert(send[r].end(), &x_own[std::size_t(n) * 3], &x_own[std::size_t(n) * 3] + 3);
  const auto arrived = comm_.exchange(send);
  for (std::size_t r = 0; r < arrived.size(); ++r)
    for (std::size_t k = 0; k < receive_nodes_[r].size(); ++k)
      std::copy_n(&arrived[r][3 * k], 3, &x[std::size_t(receive_nodes_[r][k]) * 3]);
}

void FacingSurface::update(const std::vector<double>& x_own) {
  fetch(x_own, x_);
  std::vector<Box<3>> boxes;
  for (Local f = 0; f < num_faces(); ++f) {
    boxes.push_back(box(f));
    boxes.back().inflate(0.05 * size_[f]); // a projection may lie a little outside; faces may bulge
  }
  if (tree_.size() == num_faces())
    tree_.refit(boxes);
  else
    tree_.build(boxes);
}

Box<3> FacingSurface::box(Local face) const {
  Box<3> b = Box<3>::empty();
  for (Local a = offset_[face]; a < offset_[face + 1]; ++a)
    b.add(&x_[std::size_t(face_nodes_[a]) * 3]);
  return b;
}

void FacingSurface::gather(const std::vector<double>& x, Local face, Vec3* y) const {
  for (Local a = offset_[face]; a < offset_[face + 1]; ++a, ++y)
    for (int i = 0; i < 3; ++i)
      (*y)[i] = x[std::size_t(face_nodes_[a]) * 3 + i];
}

bool FacingSurface::goes_before(Local face, Local other) const {
  const auto center = [&](Local f) {
    Vec3 y[fem::max_face_nodes], sum = Vec3::zero();
    coordinates(f, y);
    for (int a = 0; a < nodes(f); ++a)
      sum += (1.0 / nodes(f)) * y[a];
    return sum;
  };
  constexpr double same_place = 1e-6; // in face sizes
  const Vec3 apart = center(face) - center(other);
  for (int i = 0; i < 3; ++i)
    if (std::fabs(apart[i]) > same_place * size_[face])
      return apart[i] < 0.0;
  return face < other;
}

Local FacingSurface::find(Global face_id) const {
  const auto it = std::lower_bound(face_id_.begin(), face_id_.end(), face_id);
  return it != face_id_.end() && *it == face_id ? static_cast<Local>(it - face_id_.begin()) : -1;
}

void FacingSurface::global_nodes(Local face, Global* nodes) const {
  for (Local a = offset_[face]; a < offset_[face + 1]; ++a)
    *nodes++ = node_[face_nodes_[a]];
}

} // namespace abut::contact
