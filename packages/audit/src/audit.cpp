// SPDX-License-Identifier: BSD-3-Clause
#include "abut/audit/audit.hpp"

#include "ask.hpp"
#include "facets.hpp"
#include "forces.hpp"
#include "known.hpp"
#include "passages.hpp"
#include "skin_distance.hpp"

#include <algorithm>

namespace abut::audit {

namespace {

std::vector<Vec3> moved(const mesh::Mesh& mesh, const double* u) {
  std::vector<Vec3> x(mesh.node.size());
  for (std::size_t n = 0; n < x.size(); ++n)
    for (int i = 0; i < 3; ++i)
      x[n][i] = mesh.x[3 * n + std::size_t(i)] + (u ? u[3 * n + std::size_t(i)] : 0.0);
  return x;
}

} // namespace

struct Audit::Parts {
  Parts(const mesh::Mesh& m, Bodies b, std::vector<Interface> i, double allowed)
      : mesh(m), bodies(std::move(b)), exchange(mesh::node_exchange(m)), skin(make_skin(m)),
        facets(m, skin), pieces(m, skin, bodies.frame_of_node),
        sides(m, i, exchange, pieces.of_nodes()), tolerance(allowed) {
    pose.x = pose.before = moved(m, nullptr);
    samples = make_samples(skin, facets, pose.x);
    names.bodies = bodies.names;
    for (const Interface& one : i) {
      names.interfaces.push_back(one.name);
      names.primaries.push_back(one.primary);
      names.secondaries.push_back(one.secondary);
      primary_nodes.push_back(nodes_of_primary(one));
    }
  }

  std::vector<char> nodes_of_primary(const Interface& one) const;
  std::vector<Overlap> overlaps(const Scan& scan);
  void judge_overlaps(const Scan& scan, const std::vector<Belief>& beliefs, Findings& findings,
                      std::vector<Finding>& mine);
  void judge_passages(const Scan& scan, Findings& findings, std::vector<Finding>& mine) const;
  Finding finding(Kind kind, const Scan& scan, Local sample, const Vec3& x,
                  const Owner& other) const;
  std::vector<Finding> worst(const std::vector<Finding>& mine) const;

  const mesh::Mesh& mesh;
  Bodies bodies;
  Names names;
  NodeExchange exchange;
  Skin skin;
  Facets facets;
  Pieces pieces;
  InterfaceSides sides;
  std::vector<std::vector<char>> primary_nodes; ///< (interfaces) see judge_balance
  double tolerance;
  Pose pose;
  std::vector<Sample> samples;
};

/// Empty where the sides share nodes. Collective.
std::vector<char> Audit::Parts::nodes_of_primary(const Interface& one) const {
  std::vector<int> mark(mesh.node.size(), 0);
  for (const Local n : mesh::extract_surface(mesh, one.primary).field_index)
    mark[std::size_t(n)] = 1;
  exchange.max_to_owners(mark.data());
  exchange.to_ghosts(mark.data());
  bool shared = false;
  for (const Local n : mesh::extract_surface(mesh, one.secondary).field_index)
    shared = shared || mark[std::size_t(n)];
  return mesh.comm.any(shared) ? std::vector<char>() : std::vector<char>(mark.begin(), mark.end());
}

/// Normals and roundness are asked for where something overlaps only. Collective.
std::vector<Overlap> Audit::Parts::overlaps(const Scan& scan) {
  std::vector<Overlap> found = find_overlaps(scan);
  if (!mesh.comm.any(!found.empty()))
    return found;
  pose.normal = nodal_normals(skin, exchange, pose.x);
  pose.rise = facets.rises(skin, pose.x);
  measure_depths(scan, found);
  return found;
}

Finding Audit::Parts::finding(Kind kind, const Scan& scan, Local sample, const Vec3& x,
                              const Owner& other) const {
  const Owner own = scan.owner_of_face(scan.samples[std::size_t(sample)].face);
  Finding f;
  f.kind = kind;
  f.place = x;
  f.body[0] = own.body;
  f.body[1] = other.body;
  f.element[0] = own.element;
  f.element[1] = other.element;
  return f;
}

void Audit::Parts::judge_overlaps(const Scan& scan, const std::vector<Belief>& beliefs,
                                  Findings& findings, std::vector<Finding>& mine) {
  std::vector<Overlap> suspects;
  std::vector<double> allowed, size;
  Measures& m = findings.measures;
  for (const Overlap& o : overlaps(scan)) {
    const auto face = std::size_t(samples[std::size_t(o.sample)].face);
    const double smaller = std::min(o.size, skin.size[face]);
    m.overlap = std::max(m.overlap, o.depth);
    m.overlap_over_face_size = std::max(m.overlap_over_face_size, o.depth / smaller);
    const double none = tolerance * std::min(o.scale, skin.scale[face]) + o.rise + pose.rise[face];
    if (o.depth <= none)
      continue;
    suspects.push_back(o);
    allowed.push_back(none);
    size.push_back(smaller);
  }
  const std::vector<Knowledge> known = what_is_known(scan, suspects, beliefs);
  const Knowledge* k = known.data();
  const Knowledge* const end = k + known.size();
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    const Knowledge* const first = k;
    while (k != end && k->overlap == static_cast<int>(i))
      ++k;
    const Overlap& o = suspects[i];
    Finding f = finding(Kind::overlap, scan, o.sample, o.x, o.owner);
    f.value = o.depth;
    f.in_faces = o.depth / size[i];
    if (is_known(scan, o, allowed[i], beliefs, first, k, f))
      continue;
    m.unseen_overlap = std::max(m.unseen_overlap, o.depth);
    mine.push_back(f);
  }
}

void Audit::Parts::judge_passages(const Scan& scan, Findings& findings,
                                  std::vector<Finding>& mine) const {
  for (const Passage& p : find_passages(scan)) {
    Finding f = finding(Kind::passage, scan, p.sample, p.x, p.owner);
    f.value = p.way;
    f.in_faces = p.way / p.size;
    const Global own = pieces.of_face(skin, samples[std::size_t(p.sample)].face);
    f.cause = Cause::no_contact;
    for (int i = 0; i < sides.size() && f.cause == Cause::no_contact; ++i)
      if (sides.joins_bodies(i, own, p.piece)) {
        f.cause = Cause::step;
        f.interface = i;
      }
    findings.measures.unseen_overlap = std::max(findings.measures.unseen_overlap, p.way);
    mine.push_back(f);
  }
}

/// Those of all ranks, of each kind the worst. Collective.
std::vector<Finding> Audit::Parts::worst(const std::vector<Finding>& mine) const {
  std::vector<Finding> kept;
  const auto keep = [&](const std::vector<Finding>& list) {
    for (const Finding& f : list) {
      const auto like =
          std::find_if(kept.begin(), kept.end(), [&](const Finding& k) { return are_alike(f, k); });
      if (like == kept.end())
        kept.push_back(f);
      else if (is_worse(f, *like))
        *like = f;
    }
  };
  keep(mine);
  const std::vector<Finding> all = share(mesh.comm, kept);
  kept.clear();
  keep(all);
  std::sort(kept.begin(), kept.end(), is_worse);
  return kept;
}

Audit::Audit(const mesh::Mesh& mesh, Bodies bodies, std::vector<Interface> interfaces,
             double tolerance)
    : parts_(std::make_unique<Parts>(mesh, std::move(bodies), std::move(interfaces), tolerance)) {}

Audit::~Audit() = default;

const Names& Audit::names() const {
  return parts_->names;
}

void Audit::begin_step(const double* u) {
  parts_->pose.before = moved(parts_->mesh, u);
}

Findings Audit::look(const double* u, const std::vector<Belief>& beliefs) {
  Parts& p = *parts_;
  p.pose.x = moved(p.mesh, u);
  const std::vector<PiecePart> parts = p.pieces.parts(p.skin, p.pose);
  const Scan scan{p.mesh, p.skin, p.pieces, p.sides, p.samples, p.pose, parts, p.bodies.of_block};
  Findings findings;
  std::vector<Finding> mine;
  p.judge_overlaps(scan, beliefs, findings, mine);
  p.judge_passages(scan, findings, mine);
  Measures& m = findings.measures;
  double deepest[3] = {m.overlap, m.overlap_over_face_size, m.unseen_overlap};
  p.mesh.comm.max(deepest, 3);
  m.overlap = deepest[0];
  m.overlap_over_face_size = deepest[1];
  m.unseen_overlap = deepest[2];
  for (std::size_t i = 0; i < beliefs.size(); ++i) {
    judge_tractions(p.mesh, static_cast<int>(i), beliefs[i], m, mine);
    judge_balance(p.mesh, p.pose, static_cast<int>(i), beliefs[i], p.primary_nodes[i], m, mine);
  }
  findings.list = p.worst(mine);
  return findings;
}

} // namespace abut::audit
