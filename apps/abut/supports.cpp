// SPDX-License-Identifier: BSD-3-Clause
#include "supports.hpp"

#include "abut/core/error.hpp"
#include "abut/core/tensor.hpp"
#include "abut/mesh/components.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace abut::app {

namespace {

using Mode = std::array<double, 6>; ///< translations, then rotations about the centre times size
using Gram = std::array<double, 36>;

struct Piece {
  Vec3 center = Vec3::zero();
  double size = 0.0;
  Gram gram{};
  int body = 0;
};

/// Motion along `direction` at x in each rigid mode.
Mode row(const Vec3& direction, const Vec3& x, const Piece& piece) {
  const Vec3 turn = (1.0 / piece.size) * cross(x - piece.center, direction);
  return {direction[0], direction[1], direction[2], turn[0], turn[1], turn[2]};
}

void add(Piece& piece, const Mode& r) {
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = 0; j < 6; ++j)
      piece.gram[6 * i + j] += r[i] * r[j];
}

/// Eigenvalues and vectors of a symmetric 6x6 matrix by Jacobi rotations.
void eigen(Gram a, std::array<double, 6>& values, Gram& vectors) {
  vectors.fill(0.0);
  for (std::size_t i = 0; i < 6; ++i)
    vectors[7 * i] = 1.0;
  for (int sweep = 0; sweep < 60; ++sweep)
    for (std::size_t p = 0; p < 6; ++p)
      for (std::size_t q = p + 1; q < 6; ++q) {
        if (a[6 * p + q] == 0.0)
          continue;
        const double theta = 0.5 * std::atan2(2.0 * a[6 * p + q], a[7 * q] - a[7 * p]);
        const double c = std::cos(theta), s = std::sin(theta);
        for (std::size_t k = 0; k < 6; ++k) {
          const double kp = a[6 * k + p], kq = a[6 * k + q];
          a[6 * k + p] = c * kp - s * kq;
          a[6 * k + q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < 6; ++k) {
          const double pk = a[6 * p + k], qk = a[6 * q + k];
          a[6 * p + k] = c * pk - s * qk;
          a[6 * q + k] = s * pk + c * qk;
          const double vp = vectors[6 * k + p], vq = vectors[6 * k + q];
          vectors[6 * k + p] = c * vp - s * vq;
          vectors[6 * k + q] = s * vp + c * vq;
        }
      }
  for (std::size_t i = 0; i < 6; ++i)
    values[i] = a[7 * i];
}

std::string describe(const Gram& vectors, std::size_t column) {
  std::size_t largest = 0;
  for (std::size_t i = 1; i < 6; ++i)
    if (std::fabs(vectors[6 * i + column]) > std::fabs(vectors[6 * largest + column]) + 1e-9)
      largest = i;
  const std::string axis(1, "xyz"[largest % 3]);
  return (largest < 3 ? "translation along " : "rotation about ") + axis;
}

Vec3 position(const mesh::Mesh& mesh, Local n) {
  const double* x = &mesh.x[3 * std::size_t(n)];
  return {{x[0], x[1], x[2]}};
}

/// Pieces by label, with centre, size and body; the same on all ranks.
std::map<Global, Piece> find_pieces(const Model& m, const std::vector<Global>& label) {
  struct Entry {
    Global label;
    double low[3], high[3];
    int body;
  };
  const mesh::Mesh& mesh = *m.mesh;
  std::map<Global, Entry> mine;
  for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
    for (Local n : mesh.blocks[b].nodes) {
      if (!m.material[b])
        continue;
      Entry start{label[n], {1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}, m.body_of_block[b]};
      Entry& e = mine.try_emplace(label[n], start).first->second;
      for (int i = 0; i < 3; ++i) {
        e.low[i] = std::min(e.low[i], position(mesh, n)[i]);
        e.high[i] = std::max(e.high[i], position(mesh, n)[i]);
      }
    }
  std::vector<Entry> list;
  for (const auto& entry : mine)
    list.push_back(entry.second);
  const std::vector<std::vector<Entry>> to_all(static_cast<std::size_t>(m.comm.size()), list);
  std::map<Global, Entry> all;
  for (const auto& part : m.comm.exchange(to_all))
    for (const Entry& e : part) {
      Entry& total = all.try_emplace(e.label, e).first->second;
      for (int i = 0; i < 3; ++i) {
        total.low[i] = std::min(total.low[i], e.low[i]);
        total.high[i] = std::max(total.high[i], e.high[i]);
      }
      total.body = std::min(total.body, e.body);
    }
  std::map<Global, Piece> pieces;
  for (const auto& [id, e] : all) {
    Piece p;
    for (int i = 0; i < 3; ++i) {
      p.center[i] = 0.5 * (e.low[i] + e.high[i]);
      p.size = std::max(p.size, 0.5 * (e.high[i] - e.low[i]));
    }
    p.body = e.body;
    pieces[id] = p;
  }
  return pieces;
}

void add_supports(const Model& m, const std::vector<Global>& label,
                  std::map<Global, Piece>& pieces) {
  const mesh::Mesh& mesh = *m.mesh;
  const auto unit = [](int i) {
    Vec3 e = Vec3::zero();
    e[i] = 1.0;
    return e;
  };
  for (const assembly::Constraint& c : m.constraints)
    if (label[c.node] >= 0 && !m.without_unknowns[c.node]) {
      Piece& p = pieces.at(label[c.node]);
      add(p, row(unit(c.field), position(mesh, c.node), p));
    }
  for (Local n = 0; n < mesh.num_local(); ++n)
    if (m.without_unknowns[n] && label[n] >= 0)
      for (int i = 0; i < 3; ++i) {
        Piece& p = pieces.at(label[n]);
        add(p, row(unit(i), position(mesh, n), p));
      }
  for (const auto& contact : m.contacts)
    for (const contact::ClosedPoint& q : contact->closed_points()) {
      const Local n = contact->primary().field_index[std::size_t(q.primary_node)];
      if (label[n] >= 0) {
        Piece& p = pieces.at(label[n]);
        add(p, row(q.normal, q.x, p));
      }
    }
}

/// Contact holds the secondary too, whose faces may live on other ranks: told by node number.
void add_secondary_supports(const Model& m, const std::vector<Global>& label,
                            std::map<Global, Piece>& pieces) {
  struct Entry {
    Global node;
    double normal[3], x[3];
  };
  const mesh::Mesh& mesh = *m.mesh;
  std::vector<std::vector<Entry>> send(static_cast<std::size_t>(m.comm.size()));
  for (const auto& contact : m.contacts)
    for (const contact::ClosedPoint& q : contact->closed_points())
      send[static_cast<std::size_t>(mesh.owner(q.secondary_node))].push_back(
          {q.secondary_node, {q.normal[0], q.normal[1], q.normal[2]}, {q.x[0], q.x[1], q.x[2]}});
  const Global first = mesh.first_node[static_cast<std::size_t>(m.comm.rank())];
  for (const auto& list : m.comm.exchange(send))
    for (const Entry& e : list) {
      const Global id = label[static_cast<std::size_t>(e.node - first)];
      if (id < 0)
        continue;
      Piece& p = pieces.at(id);
      add(p, row({{e.normal[0], e.normal[1], e.normal[2]}}, {{e.x[0], e.x[1], e.x[2]}}, p));
    }
}

} // namespace

std::vector<FreePiece> free_pieces(const Model& m) {
  std::vector<char> deformable;
  for (const auto& material : m.material)
    deformable.push_back(material.has_value());
  const std::vector<Global> label = mesh::connected_pieces(*m.mesh, deformable);
  std::map<Global, Piece> pieces = find_pieces(m, label);
  add_supports(m, label, pieces);
  add_secondary_supports(m, label, pieces);
  std::vector<FreePiece> result;
  for (auto& [id, piece] : pieces) {
    m.comm.sum(piece.gram.data(), 36);
    double trace = 0.0;
    for (std::size_t i = 0; i < 6; ++i)
      trace += piece.gram[7 * i];
    std::array<double, 6> values;
    Gram vectors;
    eigen(piece.gram, values, vectors);
    FreePiece free{m.deck.bodies[std::size_t(piece.body)].name, {}};
    for (std::size_t i = 0; i < 6; ++i)
      if (values[i] <= 1e-10 * trace)
        free.motions.push_back(describe(vectors, i));
    if (!free.motions.empty())
      result.push_back(free);
  }
  return result;
}

void require_supports(const Model& m) {
  const auto free = free_pieces(m);
  if (free.empty())
    return;
  std::string list;
  for (const std::string& motion : free[0].motions)
    list += (list.empty() ? "" : ", ") + motion;
  throw InputError(m.deck.where("bodies." + free[0].body) + ": body '" + free[0].body +
                   "' is free to move: " + list +
                   ". Hold it with 'displacements', or start it in closed contact");
}

} // namespace abut::app
