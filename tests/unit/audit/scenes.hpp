// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/audit/audit.hpp"
#include "abut/mesh/surface.hpp"
#include "abut/meshgen/generators.hpp"
#include "abut/meshgen/merge.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace audit_test {

using namespace abut;

/// A mesh whose blocks are bodies, moved by hand, with interfaces that say what a test wants.
class Scene {
public:
  using Motion = std::function<Vec3(const Vec3&)>;

  explicit Scene(const mesh::MeshData& data, std::vector<audit::Interface> interfaces = {})
      : comm_(MPI_COMM_WORLD),
        mesh_(mesh::distribute(comm_.is_root() ? data : mesh::MeshData{}, comm_)),
        u_(3 * mesh_.node.size(), 0.0), frame_(mesh_.node.size(), -1),
        interfaces_(std::move(interfaces)), beliefs(interfaces_.size()) {}

  const mesh::Mesh& mesh() const { return mesh_; }
  bool is_root() const { return comm_.is_root(); }

  /// Adds to the displacements of the nodes of a block.
  void move(const std::string& block, const Motion& by) {
    for (const Local n : nodes(block)) {
      const Vec3 d = by(reference(n));
      for (int i = 0; i < 3; ++i)
        u_[3 * std::size_t(n) + std::size_t(i)] += d[i];
    }
  }
  void move(const std::string& block, const Vec3& by) {
    move(block, [&](const Vec3&) { return by; });
  }
  void fix(const std::string& block, int frame) {
    for (const Local n : nodes(block))
      frame_[std::size_t(n)] = frame;
  }

  /// The present displacements are where the next step begins.
  void begin_step() {
    make();
    audit_->begin_step(u_.data());
  }
  audit::Findings look() {
    make();
    return audit_->look(u_.data(), beliefs);
  }
  /// The one thing that is found.
  audit::Finding only(const audit::Findings& found) const {
    EXPECT_EQ(found.list.size(), 1u) << texts(found);
    return found.list.empty() ? audit::Finding() : found.list.front();
  }
  std::string texts(const audit::Findings& found) const {
    std::string all;
    for (const audit::Finding& f : found.list)
      all += audit::text(f, audit_->names()) + "\n";
    return all;
  }

  /// Points of an interface in the middles of its primary faces and near their corners, each as
  /// `say` changes it; on the ranks that have the faces.
  void believe(std::size_t i, const std::function<void(audit::BelievedPoint&)>& say) {
    const mesh::Surface s = mesh::extract_surface(mesh_, interfaces_[i].primary);
    beliefs[i].points.clear();
    for (Local f = 0; f < s.num_faces(); ++f) {
      Vec3 corner[4], middle = Vec3::zero();
      for (int a = 0; a < 4; ++a) {
        corner[a] =
            present(s.field_index[std::size_t(s.nodes[std::size_t(s.offset[std::size_t(f)] + a)])]);
        middle += 0.25 * corner[a];
      }
      for (int a = 0; a < 4; ++a) {
        audit::BelievedPoint p{s.face_id[std::size_t(f)],
                               middle + 0.5773502691896258 * (corner[a] - middle),
                               true,
                               false,
                               0.0,
                               0.0,
                               0.0};
        say(p);
        beliefs[i].points.push_back(p);
      }
    }
  }

  Vec3 present(Local n) const {
    Vec3 x = reference(n);
    for (int i = 0; i < 3; ++i)
      x[i] += u_[3 * std::size_t(n) + std::size_t(i)];
    return x;
  }

private:
  void make() {
    if (!audit_) {
      audit::Bodies bodies{{}, {}, frame_};
      for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
        bodies.names.push_back(mesh_.blocks[b].name);
        bodies.of_block.push_back(static_cast<int>(b));
      }
      audit_ = std::make_unique<audit::Audit>(mesh_, bodies, interfaces_, tolerance);
    }
  }
  Vec3 reference(Local n) const {
    const double* x = &mesh_.x[3 * std::size_t(n)];
    return {{x[0], x[1], x[2]}};
  }
  std::vector<Local> nodes(const std::string& block) const {
    std::vector<char> seen(mesh_.node.size(), 0);
    std::vector<Local> list;
    for (const mesh::Block& b : mesh_.blocks)
      for (const Local n : b.nodes)
        if (b.name == block && !seen[std::size_t(n)]) {
          seen[std::size_t(n)] = 1;
          list.push_back(n);
        }
    return list;
  }

  Comm comm_;
  mesh::Mesh mesh_;
  std::vector<double> u_;
  std::vector<int> frame_;
  std::vector<audit::Interface> interfaces_;
  std::unique_ptr<audit::Audit> audit_;

public:
  std::vector<audit::Belief> beliefs;
  double tolerance = 0.05;
};

/// Lower block [0,1]^2 x [-1,0] of one element, upper block of edge 1/2 above its middle.
inline mesh::MeshData small_on_large(fem::CellType element = fem::CellType::hex8) {
  meshgen::BlockPairOptions o;
  o.lower_divisions = {1, 1, 1};
  o.upper_size = {0.5, 0.5, 0.5};
  o.upper_divisions = {2, 2, 2};
  o.element = element;
  return meshgen::block_pair(o);
}

inline std::vector<audit::Interface> pair() {
  return {{"pair", "lower_top", "upper_bottom"}};
}

/// A block of its own, named as its sets begin.
inline mesh::MeshData block(const std::string& name, meshgen::Size size, meshgen::Divisions n,
                            meshgen::Size origin) {
  meshgen::BoxOptions o;
  o.name = name;
  o.prefix = name + "_";
  o.size = size;
  o.divisions = n;
  o.origin = origin;
  return meshgen::box(o);
}

inline mesh::MeshData both(mesh::MeshData a, const mesh::MeshData& b) {
  meshgen::append(a, b);
  return a;
}

} // namespace audit_test
