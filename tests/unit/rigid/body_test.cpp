// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/equation_system.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/meshgen/generate.hpp"
#include "abut/rigid/rotation.hpp"
#include "abut/solid/inertia_contribution.hpp"
#include "abut/solid/solid_contribution.hpp"

#include <gtest/gtest.h>

using namespace abut;
using rigid::Body;

namespace {

constexpr int bodies = 3;

const Vec3 first_turn{{0.5, 0.9, -0.6}}, second_turn{{0.8, -1.0, 0.7}};
const Vec3 shift{{0.3, -0.1, 0.2}};

/// A distorted neo-Hookean box with three rigid bodies on it: `floor` (the face z = 0) all free and
/// under follower loads, `roof` (z = 1) free but for one component and under dead loads, `edge`
/// (between them) prescribed: at t = 0.5 it made the first turn, at t = 1 also the second.
struct Scene {
  mesh::Mesh mesh;
  PhaseTimers timers;
  std::vector<Body> body;
  std::vector<int> body_of_node;
  std::unique_ptr<assembly::EquationSystem> system;

  explicit Scene(const Comm& comm) : mesh(make_mesh(comm)) {
    body.resize(bodies);
    body[0].name = "floor";
    body[0].center = {{0.5, 0.4, -0.2}};
    body[0].force = {{0.3, -0.2, 0.5}};
    body[0].moment = {{-0.4, 0.1, 0.2}};
    body[0].load_factor.fill([](double t) { return t; });
    body[0].follower = true;
    body[1].name = "roof";
    body[1].center = {{0.3, 0.5, 1.0}};
    body[1].force = {{0.1, 0.2, -0.3}};
    body[1].moment = {{0.2, 0.3, -0.1}};
    body[1].prescribed[0] = [](double) { return 0.0; };
    body[2].name = "edge";
    const Mat3 q = rigid::rotation(second_turn) * rigid::rotation(first_turn);
    const Vec3 whole = rigid::rotation_vector(q, first_turn);
    for (int i = 0; i < 3; ++i) {
      const double a = first_turn[i], b = whole[i], s = shift[i];
      body[2].prescribed[std::size_t(i)] = [s](double) { return s; };
      body[2].prescribed[std::size_t(i + 3)] = [a, b](double t) { return t < 0.75 ? a : b; };
    }
    for (Local n = 0; n < mesh.num_local(); ++n) {
      const double* x = &mesh.x[3 * std::size_t(n)];
      const bool edge = x[0] < 1e-12 && x[1] < 1e-12;
      body_of_node.push_back(x[2] < 1e-12 ? 0 : x[2] > 1 - 1e-12 ? 1 : edge ? 2 : -1);
    }
    build();
  }

  /// The equations of the bodies as they are described now.
  void build() {
    unknowns::RigidNodes nodes{body_of_node, {}, {}};
    for (const Body& b : body)
      nodes.has_unknowns.push_back(b.has_unknowns());
    system = std::make_unique<assembly::EquationSystem>(
        unknowns::DofMap(mesh, {"x", "y", "z"}, nodes), timers, body);
    solid::MaterialOptions material;
    material.young = 2.0;
    material.poisson = 0.3;
    system->add(
        std::make_shared<solid::SolidContribution>(mesh, 0, solid::make_material(material)));
  }

  static mesh::Mesh make_mesh(const Comm& comm) {
    mesh::MeshData data;
    if (comm.is_root())
      data = meshgen::generate("box", {{"divisions", "4,3,3"}, {"distortion", "0.1"}});
    return mesh::distribute(data, comm);
  }

  Vec3 node(Local n) const {
    const double* x = &mesh.x[3 * std::size_t(n)];
    return {{x[0], x[1], x[2]}};
  }

  /// The length that the unknowns of a rotation are scaled with.
  double length(int b) const {
    double largest = 0.0;
    for (Local n = 0; n < mesh.num_owned; ++n)
      if (body_of_node[std::size_t(n)] == b)
        largest = std::max(largest, norm(node(n) - body[std::size_t(b)].center));
    return mesh.comm.max(largest);
  }

  /// Unknowns with nodes at Q X + c + scale * wave, bodies moved along and turned by turn(b) more.
  Vector unknowns(const Mat3& q, const Vec3& c, double scale, const Vec3 (&turn)[bodies]) const {
    const unknowns::DofMap& dofs = system->dofs();
    Vector x(dofs.map());
    double lengths[bodies];
    for (int b = 0; b < bodies; ++b)
      lengths[b] = length(b);
    const auto view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (Local r = 0; r < dofs.num_node_rows(); ++r) {
      const Vec3 p = node(dofs.node_of_row(r));
      const Vec3 u = q * p - p + c;
      for (int i = 0; i < 3; ++i)
        view(3 * std::size_t(r) + std::size_t(i), 0) =
            u[i] + scale * std::sin(p[0] + 2 * p[1] * (i + 1) - p[2]);
    }
    for (int b = 0; b < bodies; ++b) {
      const Global row = dofs.row_of_body(b) - dofs.first_row();
      if (dofs.row_of_body(b) < 0 || row < 0 || row >= dofs.num_rows())
        continue;
      const Vec3 p = body[std::size_t(b)].center, u = q * p - p + c;
      for (int i = 0; i < 3; ++i) {
        view(3 * std::size_t(row) + std::size_t(i), 0) = u[i] + scale * (0.3 + 0.2 * i);
        view(3 * std::size_t(row) + 3 + std::size_t(i), 0) = lengths[b] * turn[b][i];
      }
    }
    return x;
  }
};

double difference(const Vector& a, const Vector& b) {
  Vector d(a.getMap());
  d.assign(a);
  d.update(-1.0, b, 1.0);
  return d.norm2();
}

/// Two large rotations, the first one accepted, so that the second counts from there.
Vector turned_twice(Scene& scene) {
  const Vec3 once[bodies] = {first_turn, first_turn, first_turn};
  scene.system->set_time(0.5);
  scene.system->accept(scene.unknowns(rigid::rotation(first_turn), shift, 0.0, once));
  const Mat3 q = rigid::rotation(second_turn) * rigid::rotation(first_turn);
  const Vec3 sum = first_turn + second_turn;
  const Vec3 more[bodies] = {sum + Vec3{{0.03, 0.01, -0.02}}, sum - Vec3{{0.01, 0.02, 0.02}}, sum};
  return scene.unknowns(q, shift, 0.02, more);
}

/// Gives the bodies mass and lets everything move from the first turn on.
std::shared_ptr<solid::InertiaContribution> set_in_motion(Scene& scene, double radius) {
  const auto rule = TimeIntegration::with_spectral_radius(radius);
  std::vector<solid::Lead> lead;
  for (const int b : scene.body_of_node)
    lead.insert(lead.end(), 3, b >= 0 ? solid::Lead::rigid : solid::Lead::free);
  for (std::size_t b = 0; b < bodies; ++b) {
    Body& body = scene.body[b];
    body.mass.mass = 1.5;
    body.mass.arm = {{0.2, -0.1, 0.15}};
    for (int i = 0; i < 3; ++i)
      body.mass.inertia[i][i] = 0.4 + 0.1 * i;
    if (b < 2) {
      body.velocity = {{b == 0 ? 0.3 : 0.0, 0.2, -0.1}};
      body.spin = {{0.5, -0.4, 0.6}};
    }
  }
  scene.build();
  const auto inertia = std::make_shared<solid::InertiaContribution>(
      scene.mesh, std::vector<solid::BlockDensity>{{0, 1.7}}, rule, lead);
  scene.system->add(inertia);
  const Vec3 once[bodies] = {first_turn, first_turn, first_turn};
  const Vector x = scene.unknowns(rigid::rotation(first_turn), shift, 0.0, once);
  Vector f(x.getMap());
  scene.system->set_time(0.0);
  inertia->motion().start(0.0, scene.system->nodal_values(x),
                          std::vector<double>(lead.size(), 0.2));
  scene.system->start_motion(rule, x, f);
  scene.system->accelerate(x, f); // some accelerations
  return inertia;
}

} // namespace

// As for forces without inertia below; the time step enters with a step accepted before.
TEST(RigidBody, TangentWithInertia) {
  for (const double radius : {1.0, 0.5}) {
    Scene scene(Comm(MPI_COMM_WORLD));
    set_in_motion(scene, radius);
    const Vector x = turned_twice(scene);
    scene.system->set_time(1.2);
    const auto map = scene.system->dofs().map();
    const Vec3 turns[bodies] = {{{1.0, -0.5, 0.7}}, {{0.4, 0.8, -0.3}}, {{0.0, 0.0, 0.0}}};
    Vector v = scene.unknowns(Mat3::identity(), Vec3::zero(), 1.0, turns);
    const Global row = scene.system->dofs().row_of_body(1) - scene.system->dofs().first_row();
    if (row >= 0 && row < scene.system->dofs().num_rows()) // the constrained component
      v.getLocalViewHost(Tpetra::Access::ReadWrite)(3 * std::size_t(row), 0) = 0.0;
    Vector product(map), plus(map), minus(map), y(map);
    scene.system->tangent(x)->apply(v, product);
    const double h = 1e-5;
    y.update(1.0, x, h, v, 0.0);
    scene.system->residual(y, plus);
    y.update(1.0, x, -h, v, 0.0);
    scene.system->residual(y, minus);
    plus.update(-0.5 / h, minus, 0.5 / h);
    EXPECT_GT(product.norm2(), 10.0);
    EXPECT_LT(difference(product, plus), 1e-8 * product.norm2()) << radius;
  }
}

// Where no time goes by the state stands, and the tangent is the mass.
TEST(RigidBody, MassAndRejectedSteps) {
  Scene scene(Comm(MPI_COMM_WORLD));
  const auto inertia = set_in_motion(scene, 0.5);
  const Vec3 once[bodies] = {first_turn, first_turn, first_turn};
  const Vector x = scene.unknowns(rigid::rotation(first_turn), shift, 0.0, once);
  Vector before(x.getMap()), between(x.getMap()), after(x.getMap());
  scene.system->set_time(0.5);
  scene.system->residual(x, before);
  const auto acceleration = [&] {
    const View<const double> a = inertia->motion().acceleration();
    return std::vector<double>(a.data(), a.data() + a.extent(0));
  };
  const std::vector<double> a = acceleration();
  scene.system->set_time(0.25); // a step that is cut
  scene.system->residual(x, between);
  EXPECT_GT(difference(before, between), 1.0);
  scene.system->reject();
  scene.system->set_time(0.5);
  scene.system->residual(x, after);
  EXPECT_EQ(difference(before, after), 0.0);
  EXPECT_EQ(acceleration(), a);
  scene.system->accept(x);
  scene.system->residual(x, between);
  EXPECT_EQ(acceleration(), a);
  // The mass of the whole body answers a uniform acceleration, less what is prescribed.
  Vector uniform(x.getMap()), force(x.getMap());
  const unknowns::DofMap& dofs = scene.system->dofs();
  {
    const auto view = uniform.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (Local r = 0; r < dofs.num_rows(); ++r) // along y: nodes and translations of bodies
      view(3 * std::size_t(r) + 1, 0) = r < dofs.num_node_rows() ? 1.0 : 0.0;
    for (int b = 0; b < 2; ++b) {
      const Global row = dofs.row_of_body(b) - dofs.first_row();
      if (row >= 0 && row < dofs.num_rows())
        view(3 * std::size_t(row) + 1, 0) = 1.0;
    }
  }
  scene.system->mass(x)->apply(uniform, force);
  // Kinetic energy of that motion, twice, from the nodes and the bodies by themselves.
  const std::vector<double> nodal = scene.system->nodal_rates(uniform);
  double expected = 0.0;
  solid::InertiaContribution alone(scene.mesh, {{0, 1.7}}, TimeIntegration(),
                                   std::vector<solid::Lead>(nodal.size(), solid::Lead::free));
  alone.motion().start(0.0, std::vector<double>(nodal.size(), 0.0), nodal);
  const std::vector<double> still(nodal.size(), 0.0);
  expected = scene.mesh.comm.sum(2.0 * alone.momentum({still.data(), 3, 0.0}).kinetic_energy);
  EXPECT_NEAR(uniform.dot(force), expected + 2 * 1.5, 1e-12);
}

TEST(RigidBody, NodesFollowTheirBody) {
  Scene scene(Comm(MPI_COMM_WORLD));
  const Vector x = turned_twice(scene);
  scene.system->set_time(1.0);
  const auto u = scene.system->nodal_values(x);
  const Mat3 q =
      rigid::rotation(second_turn + Vec3{{0.03, 0.01, -0.02}}) * rigid::rotation(first_turn);
  const Mat3 whole = rigid::rotation(second_turn) * rigid::rotation(first_turn);
  Global found[2] = {0, 0};
  for (Local n = 0; n < scene.mesh.num_local(); ++n) { // ghosts too
    const int b = scene.body_of_node[std::size_t(n)];
    if (b != 0 && b != 2)
      continue;
    ++found[b / 2];
    const Vec3 p = scene.node(n), center = scene.body[0].center;
    Vec3 expected = whole * p + shift;
    if (b == 0) {
      expected = q * (p - center) + whole * center + shift;
      for (int i = 0; i < 3; ++i)
        expected[i] += 0.02 * (0.3 + 0.2 * i);
    }
    for (int i = 0; i < 3; ++i)
      EXPECT_NEAR(p[i] + u[3 * std::size_t(n) + std::size_t(i)], expected[i], 5e-15);
  }
  EXPECT_GE(scene.mesh.comm.sum(found[0]), 20);
  EXPECT_GE(scene.mesh.comm.sum(found[1]), 2);
}

// Central differences of the residual: error h^2, rounding 1e-16 / h.
TEST(RigidBody, TangentIsTheDerivativeOfTheResidual) {
  Scene scene(Comm(MPI_COMM_WORLD));
  const Vector x = turned_twice(scene);
  scene.system->set_time(1.0);
  EXPECT_FALSE(scene.system->symmetric());
  const auto map = scene.system->dofs().map();
  const Vec3 turns[bodies] = {{{1.0, -0.5, 0.7}}, {{0.4, 0.8, -0.3}}, {{0.0, 0.0, 0.0}}};
  Vector v = scene.unknowns(Mat3::identity(), Vec3::zero(), 1.0, turns);
  const Global row = scene.system->dofs().row_of_body(1) - scene.system->dofs().first_row();
  if (row >= 0 && row < scene.system->dofs().num_rows()) // the constrained component stands still
    v.getLocalViewHost(Tpetra::Access::ReadWrite)(3 * std::size_t(row), 0) = 0.0;
  Vector product(map), plus(map), minus(map), y(map);
  scene.system->tangent(x)->apply(v, product); // before any residual at x
  const double h = 1e-5;
  y.update(1.0, x, h, v, 0.0);
  scene.system->residual(y, plus);
  y.update(1.0, x, -h, v, 0.0);
  scene.system->residual(y, minus);
  plus.update(-0.5 / h, minus, 0.5 / h);
  EXPECT_GT(product.norm2(), 0.1);
  EXPECT_LT(difference(product, plus), 1e-8 * product.norm2());
  // The rows of the bodies by themselves: what stands there is not lost in the others' size.
  for (int b = 0; b < 2; ++b) {
    const unknowns::DofMap& dofs = scene.system->dofs();
    const Global r = dofs.row_of_body(b) - dofs.first_row();
    if (r < 0 || r >= dofs.num_rows())
      continue;
    const auto exact = product.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto numeric = plus.getLocalViewHost(Tpetra::Access::ReadOnly);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(exact(3 * std::size_t(r) + i, 0), numeric(3 * std::size_t(r) + i, 0), 1e-8);
  }
}

TEST(RigidBody, SameNormsOnAnyNumberOfRanks) {
  Scene scene(Comm(MPI_COMM_WORLD));
  MPI_Comm self;
  MPI_Comm_split(MPI_COMM_WORLD, Comm(MPI_COMM_WORLD).rank(), 0, &self);
  {
    Scene alone((Comm(self)));
    double found[2][3];
    std::vector<rigid::BodyState> states[2];
    int i = 0;
    for (Scene* s : {&scene, &alone}) {
      const Vector x = turned_twice(*s);
      s->system->set_time(1.0);
      Vector f(x.getMap()), product(x.getMap());
      s->system->residual(x, f);
      const Vec3 turns[bodies] = {{{1.0, -0.5, 0.7}}, {{0.4, 0.8, -0.3}}, {{0.0, 0.0, 0.0}}};
      s->system->tangent(x)->apply(s->unknowns(Mat3::identity(), shift, 1.0, turns), product);
      found[i][0] = f.norm2();
      found[i][1] = product.norm2();
      found[i][2] = s->system->measure().reference;
      states[i++] = s->system->body_states();
    }
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(found[0][k], found[1][k], 1e-12 * found[1][k]);
    for (std::size_t b = 0; b < bodies; ++b) {
      EXPECT_LT(norm(states[0][b].rotation - states[1][b].rotation), 1e-13);
      EXPECT_LT(norm(states[0][b].force - states[1][b].force), 1e-13);
      EXPECT_LT(norm(states[0][b].moment - states[1][b].moment), 1e-13);
    }
    EXPECT_GT(norm(states[0][2].force), 1e-3);
    EXPECT_GT(norm(states[0][2].moment), 1e-3);
  }
  MPI_Comm_free(&self);
}

// The forces of an elastic body are in balance: those on nodes without a body, on bodies that are
// held and on free ones sum up to nothing, and so do their moments.
TEST(RigidBody, ForcesAndMomentsBalance) {
  Scene scene(Comm(MPI_COMM_WORLD));
  for (std::size_t b = 0; b < bodies; ++b) {
    scene.body[b].force = scene.body[b].moment = Vec3::zero();
    scene.body[b].follower = false;
  }
  scene.build();
  const Vector x = turned_twice(scene);
  scene.system->set_time(1.0);
  Vector f(x.getMap());
  scene.system->residual(x, f);
  const auto& raw = scene.system->raw_residual();
  const auto u = scene.system->nodal_values(x);
  const unknowns::DofMap& dofs = scene.system->dofs();
  const auto states = scene.system->body_states();
  double sum[6] = {}, size = 0.0;
  const auto add = [&](const Vec3& force, const Vec3& moment, const Vec3& at) {
    const Vec3 m = moment + cross(at, force);
    for (int i = 0; i < 3; ++i) {
      sum[i] += force[i];
      sum[3 + i] += m[i];
    }
    size += norm(force);
  };
  for (Local r = 0; r < dofs.num_node_rows(); ++r) {
    const auto n = static_cast<std::size_t>(dofs.node_of_row(r));
    const std::size_t k = 3 * std::size_t(r);
    add({{raw[k], raw[k + 1], raw[k + 2]}}, Vec3::zero(),
        scene.node(Local(n)) + Vec3{{u[3 * n], u[3 * n + 1], u[3 * n + 2]}});
  }
  for (int b = 0; b < bodies; ++b) {
    const Vec3 at = scene.body[std::size_t(b)].center + states[std::size_t(b)].displacement;
    const Global r = dofs.row_of_body(b) - dofs.first_row();
    if (dofs.row_of_body(b) < 0) {
      if (scene.mesh.comm.is_root())
        add(states[std::size_t(b)].force, states[std::size_t(b)].moment, at);
    } else if (r >= 0 && r < dofs.num_rows()) {
      const std::size_t k = 3 * std::size_t(r);
      add({{raw[k], raw[k + 1], raw[k + 2]}}, Vec3::zero(), at);
    }
  }
  for (int b = 0; b < 2; ++b) {
    const double l = scene.length(b); // collective
    const Global r = dofs.row_of_body(b) - dofs.first_row();
    if (r >= 0 && r < dofs.num_rows())
      for (std::size_t i = 0; i < 3; ++i)
        sum[3 + i] += l * raw[3 * std::size_t(r) + 3 + i];
  }
  scene.mesh.comm.sum(sum, 6);
  EXPECT_GT(scene.mesh.comm.sum(size), 0.1);
  for (double s : sum)
    EXPECT_NEAR(s, 0.0, 1e-13);
}

TEST(RigidBody, RejectLeavesNothingBehind) {
  Scene scene(Comm(MPI_COMM_WORLD));
  const Vector x = turned_twice(scene);
  scene.system->set_time(1.0);
  Vector before(x.getMap()), between(x.getMap()), after(x.getMap());
  scene.system->residual(x, before);
  const Vec3 sum = first_turn + second_turn, other = sum + Vec3{{0.1, 0.0, 0.1}};
  const Vec3 turns[bodies] = {other, other, other};
  scene.system->residual(scene.unknowns(rigid::rotation(second_turn) * rigid::rotation(first_turn),
                                        shift, 0.01, turns),
                         between);
  EXPECT_GT(difference(before, between), 1e-2);
  scene.system->reject();
  scene.system->residual(x, after);
  EXPECT_EQ(difference(before, after), 0.0);
  // An accepted state is the same state: only its increments count anew.
  scene.system->accept(x);
  scene.system->residual(x, after);
  EXPECT_LT(difference(before, after), 1e-14 * before.norm2());
}

TEST(RigidBody, RowCoordinatesOfABodyAreItsCenter) {
  Scene scene(Comm(MPI_COMM_WORLD));
  const auto x = scene.system->row_coordinates();
  const unknowns::DofMap& dofs = scene.system->dofs();
  ASSERT_EQ(x.size(), 3 * std::size_t(dofs.num_rows()));
  Global found = 0;
  for (int b = 0; b < 2; ++b) {
    const Global r = dofs.row_of_body(b) - dofs.first_row();
    if (r < 0 || r >= dofs.num_rows())
      continue;
    ++found;
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_EQ(x[3 * std::size_t(r) + i], scene.body[std::size_t(b)].center[int(i % 3)]);
  }
  EXPECT_EQ(scene.mesh.comm.sum(found), 2);
  EXPECT_EQ(dofs.row_of_body(2), -1);
}
