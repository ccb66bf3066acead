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

/// A connected deformable piece or a rigid body with unknowns: what may move as a whole.
struct Piece {
  Vec3 center = Vec3::zero();
  double size = 0.0;
  int body = 0; ///< of the deck
};

/// Pieces that share nodes, and what holds them: the sum of outer products of rows, one for each
/// motion that is not possible. Motions without a row are free.
struct Cluster {
  std::vector<std::size_t> pieces;
  std::vector<double> gram; ///< (6 pieces)^2
};

/// Motion along `direction` at x in each rigid mode.
Mode row(const Vec3& direction, const Vec3& x, const Piece& piece) {
  const Vec3 turn = (1.0 / piece.size) * cross(x - piece.center, direction);
  return {direction[0], direction[1], direction[2], turn[0], turn[1], turn[2]};
}

/// Eigenvalues (into the diagonal of a) and vectors of a symmetric n x n matrix, by Jacobi
/// rotations.
std::vector<double> eigenvectors(std::vector<double>& a, std::size_t n) {
  constexpr double negligible = 1e-15;
  std::vector<double> vectors(n * n, 0.0);
  double trace = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    vectors[(n + 1) * i] = 1.0;
    trace += a[(n + 1) * i];
  }
  bool changed = true;
  for (int sweep = 0; changed && sweep < 60; ++sweep) {
    changed = false;
    for (std::size_t p = 0; p < n; ++p)
      for (std::size_t q = p + 1; q < n; ++q) {
        if (std::fabs(a[n * p + q]) <= negligible * trace)
          continue;
        changed = true;
        const double theta = 0.5 * std::atan2(2.0 * a[n * p + q], a[(n + 1) * q] - a[(n + 1) * p]);
        const double c = std::cos(theta), s = std::sin(theta);
        for (std::size_t k = 0; k < n; ++k) {
          const double kp = a[n * k + p], kq = a[n * k + q];
          a[n * k + p] = c * kp - s * kq;
          a[n * k + q] = s * kp + c * kq;
        }
        for (std::size_t k = 0; k < n; ++k) {
          const double pk = a[n * p + k], qk = a[n * q + k];
          a[n * p + k] = c * pk - s * qk;
          a[n * q + k] = s * pk + c * qk;
          const double vp = vectors[n * k + p], vq = vectors[n * k + q];
          vectors[n * k + p] = c * vp - s * vq;
          vectors[n * k + q] = s * vp + c * vq;
        }
      }
  }
  return vectors;
}

std::string describe(std::size_t mode) {
  const std::string axis(1, "xyz"[mode % 3]);
  return (mode < 3 ? "translation along " : "rotation about ") + axis;
}

Vec3 position(const mesh::Mesh& mesh, Local n) {
  const double* x = &mesh.x[3 * std::size_t(n)];
  return {{x[0], x[1], x[2]}};
}

Vec3 unit(int i) {
  Vec3 e = Vec3::zero();
  e[i] = 1.0;
  return e;
}

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

/// What may move, how it hangs together and what holds it. The same on all ranks.
class Supports {
public:
  explicit Supports(const Model& m) : m_(m) {
    std::vector<char> deformable;
    for (const auto& material : m.material)
      deformable.push_back(material.has_value());
    label_ = mesh::connected_pieces(*m.mesh, deformable);
    find_pieces();
    find_bodies();
    find_clusters();
    prescribed();
    shared_nodes();
    joints();
    contact();
    for (Cluster& c : clusters_)
      m.comm.sum(c.gram.data(), static_cast<int>(c.gram.size()));
  }

  std::vector<FreePiece> free() const {
    std::vector<FreePiece> result;
    for (const Cluster& cluster : clusters_) {
      const std::size_t n = 6 * cluster.pieces.size();
      std::vector<double> gram = cluster.gram;
      double trace = 0.0;
      for (std::size_t i = 0; i < n; ++i)
        trace += gram[(n + 1) * i];
      const std::vector<double> vectors = eigenvectors(gram, n);
      std::map<std::size_t, FreePiece> found;
      for (std::size_t j = 0; j < n; ++j) {
        if (gram[(n + 1) * j] > 1e-10 * trace)
          continue;
        const std::size_t largest = name_giver(cluster, vectors, j);
        const Piece& piece = pieces_[cluster.pieces[largest / 6]];
        FreePiece& free = found[largest / 6];
        free.body = m_.deck.bodies[std::size_t(piece.body)].name;
        free.motions.push_back(describe(largest % 6));
      }
      for (const auto& entry : found)
        result.push_back(entry.second);
    }
    return result;
  }

private:
  /// The largest component of a motion: that of a rigid body where one moves, since what hangs on
  /// it turns about its center and not about its own.
  std::size_t name_giver(const Cluster& cluster, const std::vector<double>& vectors,
                         std::size_t motion) const {
    constexpr double moves = 1e-3;
    const std::size_t n = 6 * cluster.pieces.size();
    std::size_t largest = 0, of_body = 0;
    double size = 0.0, body_size = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      const double component = std::fabs(vectors[n * i + motion]);
      if (component > size + 1e-9) {
        size = component;
        largest = i;
      }
      if (cluster.pieces[i / 6] >= first_body_ && component > body_size + 1e-9) {
        body_size = component;
        of_body = i;
      }
    }
    return body_size > moves ? of_body : largest;
  }

  static constexpr std::size_t none = std::size_t(-1);
  struct Term {
    std::size_t piece;
    Mode row;
  };

  /// Deformable pieces by label, with centre, size and body.
  void find_pieces() {
    const mesh::Mesh& mesh = *m_.mesh;
    std::map<Global, Extent> mine;
    for (std::size_t b = 0; b < mesh.blocks.size(); ++b)
      for (Local n : mesh.blocks[b].nodes)
        if (m_.material[b])
          extend(mine, label_[std::size_t(n)], n, m_.body_of_block[b]);
    for (const auto& [id, e] : on_all_ranks(m_.comm, mine)) {
      piece_of_label_[id] = pieces_.size();
      Piece p;
      for (int i = 0; i < 3; ++i) {
        p.center[i] = 0.5 * (e.low[i] + e.high[i]);
        p.size = std::max(p.size, 0.5 * (e.high[i] - e.low[i]));
      }
      p.body = e.body;
      pieces_.push_back(p);
    }
  }

  void extend(std::map<Global, Extent>& extents, Global label, Local n, int body) const {
    const Extent start{label, {1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}, body};
    Extent& e = extents.try_emplace(label, start).first->second;
    for (int i = 0; i < 3; ++i) {
      e.low[i] = std::min(e.low[i], position(*m_.mesh, n)[i]);
      e.high[i] = std::max(e.high[i], position(*m_.mesh, n)[i]);
    }
  }

  /// Rigid bodies with unknowns, about their own centers.
  void find_bodies() {
    std::map<Global, Extent> mine;
    for (Local n = 0; n < m_.mesh->num_local(); ++n)
      if (m_.rigid_body_of_node[std::size_t(n)] >= 0)
        extend(mine, m_.rigid_body_of_node[std::size_t(n)], n, 0);
    const auto extents = on_all_ranks(m_.comm, mine);
    first_body_ = pieces_.size();
    piece_of_body_.assign(m_.rigid_bodies.size(), none);
    for (std::size_t b = 0; b < m_.rigid_bodies.size(); ++b) {
      if (!m_.rigid_bodies[b].has_unknowns())
        continue;
      Piece p;
      p.center = m_.rigid_bodies[b].center;
      const auto e = extents.find(static_cast<Global>(b));
      for (int i = 0; e != extents.end() && i < 3; ++i)
        p.size = std::max(p.size, 0.5 * (e->second.high[i] - e->second.low[i]));
      if (p.size == 0.0)
        p.size = 1.0;
      while (m_.deck.bodies[std::size_t(p.body)].name != m_.rigid_bodies[b].name)
        ++p.body;
      piece_of_body_[b] = pieces_.size();
      pieces_.push_back(p);
    }
  }

  std::size_t piece_of_label(Local n) const {
    const Global id = label_[std::size_t(n)];
    return id < 0 ? none : piece_of_label_.at(id);
  }
  /// The piece that moves a node: a rigid body before a deformable one; none when it is prescribed.
  std::size_t mover(Local n) const {
    const int body = m_.rigid_body_of_node[std::size_t(n)];
    return body >= 0 ? piece_of_body_[std::size_t(body)] : piece_of_label(n);
  }

  /// Joins pieces and bodies that share nodes or joints.
  void find_clusters() {
    std::vector<Global> pairs;
    for (Local n = 0; n < m_.mesh->num_owned; ++n) {
      const std::size_t a = mover(n), b = piece_of_label(n);
      if (a != none && b != none && a != b)
        pairs.insert(pairs.end(), {Global(a), Global(b)});
    }
    for (const assembly::RigidJoint& joint : m_.joints)
      if (m_.comm.is_root() && joint_piece(joint, 0) != none && joint_piece(joint, 1) != none)
        pairs.insert(pairs.end(), {Global(joint_piece(joint, 0)), Global(joint_piece(joint, 1))});
    std::vector<std::size_t> cluster(pieces_.size());
    for (std::size_t i = 0; i < cluster.size(); ++i)
      cluster[i] = i;
    const std::vector<std::vector<Global>> to_all(static_cast<std::size_t>(m_.comm.size()), pairs);
    for (const auto& list : m_.comm.exchange(to_all))
      for (std::size_t i = 0; i < list.size(); i += 2) {
        const std::size_t a = cluster[std::size_t(list[i])], b = cluster[std::size_t(list[i + 1])];
        if (a != b)
          std::replace(cluster.begin(), cluster.end(), std::max(a, b), std::min(a, b));
      }
    cluster_of_.assign(pieces_.size(), {});
    for (std::size_t i = 0; i < cluster.size(); ++i) {
      if (cluster[i] == i)
        clusters_.emplace_back();
      const std::size_t c = cluster[i] == i ? clusters_.size() - 1 : cluster_of_[cluster[i]].first;
      cluster_of_[i] = {c, clusters_[c].pieces.size()};
      clusters_[c].pieces.push_back(i);
    }
    for (Cluster& c : clusters_)
      c.gram.assign(36 * c.pieces.size() * c.pieces.size(), 0.0);
  }

  /// Adds one row over pieces of one cluster.
  void add(const std::vector<Term>& terms) {
    Cluster& c = clusters_[cluster_of_[terms[0].piece].first];
    const std::size_t n = 6 * c.pieces.size();
    for (const Term& a : terms)
      for (const Term& b : terms)
        for (std::size_t i = 0; i < 6; ++i)
          for (std::size_t j = 0; j < 6; ++j)
            c.gram[n * (6 * cluster_of_[a.piece].second + i) + 6 * cluster_of_[b.piece].second +
                   j] += a.row[i] * b.row[j];
  }
  void hold(std::size_t piece, const Vec3& direction, const Vec3& x) {
    if (piece != none)
      add({{piece, row(direction, x, pieces_[piece])}});
  }

  /// Displacements and components of bodies that are prescribed in the first step.
  void prescribed() {
    const double first = m_.deck.time.end / m_.deck.time.steps;
    for (const assembly::Constraint& c : m_.constraints)
      if (c.window.holds(first))
        hold(mover(c.node), unit(c.field), position(*m_.mesh, c.node));
    if (!m_.comm.is_root())
      return;
    for (std::size_t b = 0; b < m_.rigid_bodies.size(); ++b) {
      if (piece_of_body_[b] == none)
        continue;
      const assembly::RigidBody& body = m_.rigid_bodies[b];
      for (std::size_t i = 0; i < 6; ++i)
        if (body.prescribed[i])
          hold_component(b, i);
      for (const assembly::RigidHold& held : body.holds)
        if (held.window.holds(first))
          hold_component(b, static_cast<std::size_t>(held.component));
    }
  }
  void hold_component(std::size_t body, std::size_t i) {
    Mode component{};
    component[i] = 1.0;
    add({{piece_of_body_[body], component}});
  }

  /// Nodes of a deformable piece that a rigid body moves: both move alike there.
  void shared_nodes() {
    for (Local n = 0; n < m_.mesh->num_owned; ++n) {
      const std::size_t piece = piece_of_label(n), body = mover(n);
      if (piece == none || m_.rigid_body_of_node[std::size_t(n)] < 0)
        continue;
      for (int i = 0; i < 3; ++i) {
        const Vec3 x = position(*m_.mesh, n);
        std::vector<Term> terms{{piece, row(unit(i), x, pieces_[piece])}};
        if (body != none)
          terms.push_back({body, row(-unit(i), x, pieces_[body])});
        add(terms);
      }
    }
  }

  std::size_t joint_piece(const assembly::RigidJoint& joint, std::size_t which) const {
    const int body = joint.body[which];
    return body < 0 ? none : piece_of_body_[std::size_t(body)];
  }

  /// What joints hold and springs resist, in the reference configuration.
  void joints() {
    if (!m_.comm.is_root())
      return;
    for (const assembly::RigidJoint& joint : m_.joints) {
      const auto frame = assembly::joint_frame(joint.axis);
      for (std::size_t i = 0; i < 6; ++i)
        if (joint.held[i])
          connect(joint, frame[i % 3], i >= 3);
      if (!joint.is_spring())
        continue;
      const Vec3 along = joint.end - joint.origin;
      const double length = norm(along);
      if (length > joint.free_length || length == 0.0) // it then resists every direction
        for (int i = 0; i < 3; ++i)
          connect(joint, unit(i), false);
      else
        connect(joint, (1.0 / length) * along, false);
    }
  }

  /// The second body does not move along, or turn about, a direction against the first.
  void connect(const assembly::RigidJoint& joint, const Vec3& direction, bool turns) {
    double size = 0.0;
    for (const std::size_t k : {0u, 1u})
      if (joint_piece(joint, k) != none)
        size = std::max(size, pieces_[joint_piece(joint, k)].size);
    std::vector<Term> terms;
    for (const std::size_t k : {0u, 1u}) {
      const std::size_t piece = joint_piece(joint, k);
      if (piece == none)
        continue;
      const Vec3 d = (k == 0 ? -1.0 : 1.0) * direction;
      const Vec3 turn = size / pieces_[piece].size * d;
      const Vec3& x = joint.is_spring() && k == 1 ? joint.end : joint.origin;
      terms.push_back({piece, turns ? Mode{0.0, 0.0, 0.0, turn[0], turn[1], turn[2]}
                                    : row(d, x, pieces_[piece])});
    }
    if (!terms.empty())
      add(terms);
  }

  /// Contact holds both sides along its normal; the secondary's faces may live on other ranks.
  void contact() {
    struct Entry {
      Global node;
      double normal[3], x[3];
    };
    const mesh::Mesh& mesh = *m_.mesh;
    std::vector<std::vector<Entry>> send(static_cast<std::size_t>(m_.comm.size()));
    for (const auto& contact : m_.contacts)
      for (const contact::ClosedPoint& q : contact->closed_points()) {
        hold(mover(contact->primary().field_index[std::size_t(q.primary_node)]), q.normal, q.x);
        send[static_cast<std::size_t>(mesh.owner(q.secondary_node))].push_back(
            {q.secondary_node, {q.normal[0], q.normal[1], q.normal[2]}, {q.x[0], q.x[1], q.x[2]}});
      }
    const Global first = mesh.first_node[static_cast<std::size_t>(m_.comm.rank())];
    for (const auto& list : m_.comm.exchange(send))
      for (const Entry& e : list)
        hold(mover(static_cast<Local>(e.node - first)), {{e.normal[0], e.normal[1], e.normal[2]}},
             {{e.x[0], e.x[1], e.x[2]}});
  }

  const Model& m_;
  std::vector<Global> label_; ///< of deformable pieces, per local node; -1: none
  std::vector<Piece> pieces_; ///< deformable ones, then rigid bodies
  std::size_t first_body_ = 0;
  std::map<Global, std::size_t> piece_of_label_;
  std::vector<std::size_t> piece_of_body_;
  std::vector<Cluster> clusters_;
  std::vector<std::pair<std::size_t, std::size_t>> cluster_of_; ///< cluster, place in it
};

} // namespace

std::vector<FreePiece> free_pieces(const Model& m) {
  return Supports(m).free();
}

void require_supports(const Model& m) {
  const auto free = free_pieces(m);
  if (free.empty())
    return;
  bool rigid = false;
  for (const auto& body : m.deck.bodies)
    rigid = rigid || (body.name == free[0].body && body.rigid);
  std::string list;
  for (const std::string& motion : free[0].motions)
    list += (list.empty() ? "" : ", ") + motion;
  throw InputError(m.deck.where("bodies." + free[0].body) + ": body '" + free[0].body +
                   "' is free to move: " + list + ". Hold it with " +
                   (rigid ? "prescribed components (those not listed as 'free'), with 'joints'"
                          : "'displacements'") +
                   ", or start it in closed contact");
}

} // namespace abut::app
