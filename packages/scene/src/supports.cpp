// SPDX-License-Identifier: BSD-3-Clause
#include "abut/scene/supports.hpp"

#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "free_motions.hpp"
#include "pieces.hpp"
#include "symmetric_eigen.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace abut::scene {

namespace {

using Mode = std::array<double, 6>; ///< translations, then rotations about the centre times size

/// Pieces that share nodes, and what holds them: the sum of outer products of rows, one for each
/// motion that is not possible. Motions without a row are free.
struct Cluster {
  std::vector<std::size_t> pieces;
  std::vector<double> gram; ///< (6 pieces)^2
};

Vec3 position(const mesh::Mesh& mesh, Local n, const std::vector<double>* u) {
  Vec3 x;
  for (int i = 0; i < 3; ++i) {
    const std::size_t at = 3 * std::size_t(n) + std::size_t(i);
    x[i] = mesh.x[at] + (u ? (*u)[at] : 0.0);
  }
  return x;
}

Vec3 unit(int i) {
  Vec3 e = Vec3::zero();
  e[i] = 1.0;
  return e;
}

/// What may move, how it hangs together and what holds it. The same on all ranks.
class Supports {
public:
  Supports(const Options& options, const Scene& scene, const SupportedAt& at)
      : options_(options), s_(scene), at_(at), pieces_(options, scene),
        cluster_of_(pieces_.size()) {
    find_centers();
    for (std::vector<std::size_t>& pieces : pieces_.clusters()) {
      for (std::size_t i = 0; i < pieces.size(); ++i)
        cluster_of_[pieces[i]] = {clusters_.size(), i};
      clusters_.push_back({std::move(pieces), {}});
      clusters_.back().gram.assign(
          36 * clusters_.back().pieces.size() * clusters_.back().pieces.size(), 0.0);
    }
    prescribed();
    shared_nodes();
    joints();
    if (at_.contact)
      contact();
    for (Cluster& c : clusters_)
      comm().sum(c.gram.data(), static_cast<int>(c.gram.size()));
  }

  std::vector<FreePiece> free() const {
    std::vector<FreePiece> result;
    for (const Cluster& cluster : clusters_) {
      std::vector<Motion> motions = free_motions(cluster);
      // What hangs on a rigid body moves with it: those speak first.
      for (const bool rigid : {true, false})
        for (std::size_t i = 0; i < cluster.pieces.size() && !motions.empty(); ++i) {
          const std::size_t piece = cluster.pieces[i];
          if (pieces_.is_rigid(piece) != rigid)
            continue;
          const std::vector<Twist> own = take_motions(i, motions);
          if (!own.empty())
            result.push_back({options_.bodies[std::size_t(pieces_[piece].body)].name,
                              describe_motions(own, center_[piece], pieces_[piece].size)});
        }
    }
    return result;
  }

private:
  using Motion = std::vector<double>; ///< modes of all pieces of a cluster, 6 each

  /// An orthonormal basis of what nothing holds.
  static std::vector<Motion> free_motions(const Cluster& cluster) {
    constexpr double held = 1e-10; // of the trace
    const std::size_t n = 6 * cluster.pieces.size();
    std::vector<double> gram = cluster.gram;
    double trace = 0.0;
    for (std::size_t i = 0; i < n; ++i)
      trace += gram[(n + 1) * i];
    const std::vector<double> vectors = symmetric_eigen(gram, n);
    std::vector<Motion> motions;
    for (std::size_t j = 0; j < n; ++j) {
      if (gram[(n + 1) * j] > held * trace)
        continue;
      Motion& motion = motions.emplace_back();
      for (std::size_t i = 0; i < n; ++i)
        motion.push_back(vectors[n * i + j]);
    }
    return motions;
  }

  /// What the i-th piece of a cluster can do, orthonormal; leaves the motions in which it rests.
  static std::vector<Twist> take_motions(std::size_t i, std::vector<Motion>& motions) {
    constexpr double moves = 1e-3;
    const std::size_t n = motions.size();
    std::vector<double> gram(n * n, 0.0);
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b)
        for (std::size_t k = 6 * i; k < 6 * i + 6; ++k)
          gram[n * a + b] += motions[a][k] * motions[b][k];
    const std::vector<double> vectors = symmetric_eigen(gram, n);
    std::vector<Twist> own;
    std::vector<Motion> rest;
    for (std::size_t j = 0; j < n; ++j) {
      Motion sum(motions[0].size(), 0.0);
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t k = 0; k < sum.size(); ++k)
          sum[k] += vectors[n * a + j] * motions[a][k];
      const double size = std::sqrt(std::max(0.0, gram[(n + 1) * j]));
      if (size < moves) {
        rest.push_back(std::move(sum));
        continue;
      }
      const double* m = &sum[6 * i];
      own.push_back(
          {{{m[0] / size, m[1] / size, m[2] / size}}, {{m[3] / size, m[4] / size, m[5] / size}}});
    }
    motions = std::move(rest);
    return own;
  }

  static constexpr std::size_t none = Pieces::none;
  struct Term {
    std::size_t piece;
    Mode row;
  };

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
      add({{piece, row(piece, direction, x)}});
  }

  /// Motion along `direction` at x in each rigid mode of a piece.
  Mode row(std::size_t piece, const Vec3& direction, const Vec3& x) const {
    const Vec3 turn = (1.0 / pieces_[piece].size) * cross(x - center_[piece], direction);
    return {direction[0], direction[1], direction[2], turn[0], turn[1], turn[2]};
  }

  /// Those of rigid bodies move with them.
  void find_centers() {
    for (std::size_t p = 0; p < pieces_.size(); ++p)
      center_.push_back(pieces_[p].center);
    if (!at_.u)
      return;
    const std::vector<rigid::BodyState> states = s_.equations->body_states();
    for (std::size_t b = 0; b < states.size(); ++b)
      if (pieces_.of_body(int(b)) != none)
        center_[pieces_.of_body(int(b))] += states[b].displacement;
  }

  /// Displacements and components of bodies that are prescribed.
  void prescribed() {
    for (const assembly::Constraint& c : s_.constraints)
      if (c.window.holds(at_.t))
        hold(pieces_.mover(c.node), unit(c.field), position(*s_.mesh, c.node, at_.u));
    if (!comm().is_root())
      return;
    for (std::size_t b = 0; b < s_.rigid_bodies.size(); ++b) {
      if (pieces_.of_body(int(b)) == none)
        continue;
      const rigid::Body& body = s_.rigid_bodies[b];
      for (std::size_t i = 0; i < 6; ++i)
        if (body.prescribed[i])
          hold_component(b, i);
      for (const rigid::Hold& held : body.holds)
        if (held.window.holds(at_.t))
          hold_component(b, static_cast<std::size_t>(held.component));
    }
  }
  void hold_component(std::size_t body, std::size_t i) {
    Mode component{};
    component[i] = 1.0;
    add({{pieces_.of_body(int(body)), component}});
  }

  /// Nodes of a deformable piece that a rigid body moves: both move alike there.
  void shared_nodes() {
    for (Local n = 0; n < s_.mesh->num_owned; ++n) {
      const std::size_t piece = pieces_.deformable(n), body = pieces_.mover(n);
      if (piece == none || s_.rigid_body_of_node[std::size_t(n)] < 0)
        continue;
      for (int i = 0; i < 3; ++i) {
        const Vec3 x = position(*s_.mesh, n, at_.u);
        std::vector<Term> terms{{piece, row(piece, unit(i), x)}};
        if (body != none)
          terms.push_back({body, row(body, -unit(i), x)});
        add(terms);
      }
    }
  }

  /// What joints hold and springs resist, in the reference configuration.
  void joints() {
    if (!comm().is_root())
      return;
    for (const rigid::Joint& joint : s_.joints) {
      const auto frame = rigid::joint_frame(joint.axis);
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
  void connect(const rigid::Joint& joint, const Vec3& direction, bool turns) {
    double size = 0.0;
    for (const std::size_t k : {0u, 1u})
      if (pieces_.of_body(joint.body[k]) != none)
        size = std::max(size, pieces_[pieces_.of_body(joint.body[k])].size);
    std::vector<Term> terms;
    for (const std::size_t k : {0u, 1u}) {
      const std::size_t piece = pieces_.of_body(joint.body[k]);
      if (piece == none)
        continue;
      const Vec3 d = (k == 0 ? -1.0 : 1.0) * direction;
      const Vec3 turn = size / pieces_[piece].size * d;
      const Vec3& x = joint.is_spring() && k == 1 ? joint.end : joint.origin;
      terms.push_back(
          {piece, turns ? Mode{0.0, 0.0, 0.0, turn[0], turn[1], turn[2]} : row(piece, d, x)});
    }
    if (!terms.empty())
      add(terms);
  }

  /// Contact holds both sides along its normal; what moves the secondary's nodes is known to their
  /// owners.
  void contact() {
    const mesh::Mesh& mesh = *s_.mesh;
    std::vector<contact::ClosedPoint> closed;
    std::vector<Global> secondary;
    for (const auto& contact : s_.contacts) {
      if (!contact->settings().window.holds(at_.t))
        continue;
      for (const contact::ClosedPoint& q : contact->points().closed()) {
        hold(pieces_.mover(contact->primary().field_index[std::size_t(q.primary_node)]), q.normal,
             q.x);
        closed.push_back(q);
        secondary.push_back(q.secondary_node);
      }
    }
    std::vector<std::size_t> movers;
    for (Local n = 0; n < mesh.num_owned; ++n)
      movers.push_back(pieces_.mover(n));
    movers.resize(movers.size() + closed.size(), none);
    NodeExchange(mesh.comm, mesh.first_node, secondary).to_ghosts(movers.data());
    for (std::size_t i = 0; i < closed.size(); ++i)
      hold(movers[std::size_t(mesh.num_owned) + i], closed[i].normal, closed[i].x);
  }

  const Comm& comm() const { return s_.mesh->comm; }

  const Options& options_;
  const Scene& s_;
  const SupportedAt at_;
  const Pieces pieces_;
  std::vector<Vec3> center_; ///< of each piece
  std::vector<Cluster> clusters_;
  std::vector<std::pair<std::size_t, std::size_t>> cluster_of_; ///< cluster, place in it
};

} // namespace

std::vector<FreePiece> free_pieces(const Options& options, const Scene& scene) {
  return Supports(options, scene, {options.time.end / options.time.steps}).free();
}

std::vector<FreePiece> free_pieces(const Options& options, const Scene& scene,
                                   const SupportedAt& at) {
  return scene.joints.empty() ? Supports(options, scene, at).free() : std::vector<FreePiece>();
}

std::string FreePiece::text() const {
  std::string list;
  for (const std::string& motion : motions)
    list += (list.empty() ? "" : ", ") + motion;
  return list;
}

namespace {

/// What stays free when the nearest points of all contacts hold.
std::vector<FreePiece> free_beside_nearest(const Options& options, Scene& scene, const Vector& x) {
  Vector f(x.getMap());
  for (const auto& contact : scene.contacts)
    contact->hold_by_nearest();
  scene.equations->begin_solve(SolveKind::prediction);
  scene.equations->residual(x, f);
  auto free = free_pieces(options, scene);
  scene.equations->begin_solve(SolveKind::newton);
  scene.equations->residual(x, f);
  return free;
}

/// The least gap of all contacts. Collective.
double nearest_gap(const Scene& scene) {
  double least = std::numeric_limits<double>::max();
  for (const auto& contact : scene.contacts)
    if (const auto summary = contact->summary(); summary.paired_points > 0)
      least = std::min(least, summary.min_gap);
  return least;
}

} // namespace

void require_supports(const Options& options, Scene& scene, const Vector& x, const Where& where) {
  auto free = free_pieces(options, scene);
  if (free.empty())
    return;
  const auto held = free;
  if (!scene.contacts.empty())
    free = free_beside_nearest(options, scene, x);
  if (free.empty()) {
    for (const FreePiece& piece : held)
      scene.warnings.push_back(fmt::format(
          "bodies.{}: nothing but contact can hold {}, and nothing touches at the start: "
          "the nearest points, {:.3g} off, hold it until they touch",
          piece.body, piece.text(), nearest_gap(scene)));
    return;
  }
  bool rigid = false;
  for (const auto& body : options.bodies)
    rigid = rigid || (body.name == free[0].body && body.rigid);
  throw InputError(where("bodies." + free[0].body) + ": body '" + free[0].body +
                   "' is free to move: " + free[0].text() + ". Hold it with " +
                   (rigid ? "prescribed components (those not listed as 'free'), with 'joints'"
                          : "'displacements'") +
                   ", or start it in closed contact");
}

} // namespace abut::scene
