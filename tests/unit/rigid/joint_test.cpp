// SPDX-License-Identifier: BSD-3-Clause
#include "abut/assembly/equation_system.hpp"
#include "abut/core/error.hpp"
#include "abut/core/trilinos.hpp"
#include "abut/meshgen/generate.hpp"
#include "abut/rigid/rotation.hpp"

#include <gtest/gtest.h>

using namespace abut;
using rigid::Body;
using rigid::Joint;

namespace {

using Held = std::array<bool, 6>;
constexpr Held revolute{true, true, true, true, true, false};
constexpr Held prismatic{true, true, false, true, true, true};
constexpr Held cylindrical{true, true, false, true, true, false};
constexpr Held spherical{true, true, true, false, false, false};
constexpr Held lock{true, true, true, true, true, true};

const Vec3 first_turn{{0.5, 0.9, -0.6}};

Joint joint(const char* name, const Held& held, int a, int b) {
  Joint j;
  j.name = name;
  j.body = {a, b};
  j.origin = {{0.4, 0.7, 0.3}};
  j.axis = {{1.0, -2.0, 2.0}};
  j.held = held;
  return j;
}

Joint spring(int a, int b, double free_length) {
  Joint j;
  j.name = "spring";
  j.body = {a, b};
  j.origin = {{0.1, 0.2, -0.1}};
  j.end = {{0.9, 0.5, 1.2}};
  j.stiffness = 3.0;
  j.free_length = free_length;
  return j;
}

/// Three bodies without anything elastic: `floor` and `roof` all free, `edge` follows t.
struct Scene {
  mesh::Mesh mesh;
  PhaseTimers timers;
  std::vector<Body> body{3};
  std::unique_ptr<assembly::EquationSystem> system;

  Scene(const Comm& comm, const std::vector<Joint>& joints) : mesh(make_mesh(comm)) {
    body[0].name = "floor";
    body[0].center = {{0.5, 0.4, -0.2}};
    body[1].name = "roof";
    body[1].center = {{0.3, 0.5, 1.1}};
    body[2].name = "edge";
    body[2].center = {{0.0, 0.2, 0.5}};
    for (int i = 0; i < 3; ++i) {
      const double a = first_turn[i];
      body[2].prescribed[std::size_t(i)] = [i](double t) { return t * (0.2 + 0.1 * i); };
      body[2].prescribed[std::size_t(i + 3)] = [a](double t) { return t * a; };
    }
    unknowns::RigidNodes nodes;
    for (Local n = 0; n < mesh.num_local(); ++n) {
      const double* x = &mesh.x[3 * std::size_t(n)];
      nodes.body.push_back(x[2] < 0.25 ? 0 : x[2] > 0.75 ? 1 : 2);
    }
    nodes.has_unknowns = {1, 1, 0};
    for (const Joint& j : joints)
      nodes.links.push_back({j.body, !j.is_spring()});
    system = std::make_unique<assembly::EquationSystem>(
        unknowns::DofMap(mesh, {"x", "y", "z"}, nodes), timers, body, joints);
  }

  static mesh::Mesh make_mesh(const Comm& comm) {
    mesh::MeshData data;
    if (comm.is_root())
      data = meshgen::generate("box", {{"divisions", "2,2,2"}});
    return mesh::distribute(data, comm);
  }

  /// The length that the unknowns of a rotation are scaled with.
  double length(std::size_t b) const {
    double largest = 0.0;
    for (Local n = 0; n < mesh.num_owned; ++n) {
      const double* x = &mesh.x[3 * std::size_t(n)];
      if ((b == 0) == (x[2] < 0.25) && (b == 1) == (x[2] > 0.75))
        largest = std::max(largest, norm(Vec3{{x[0], x[1], x[2]}} - body[b].center));
    }
    return mesh.comm.max(largest);
  }

  struct Move {
    Vec3 shift, turn;
  };
  /// Unknowns of given motions of both free bodies; multipliers 0.3, 0.4, ...
  Vector unknowns(const Move& floor, const Move& roof) const {
    const unknowns::DofMap& dofs = system->dofs();
    Vector x(dofs.map());
    const double lengths[2] = {length(0), length(1)};
    const auto view = x.getLocalViewHost(Tpetra::Access::OverwriteAll);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      view(i, 0) = 0.0;
    const auto put = [&](Global row, const auto& value) {
      row -= dofs.first_row();
      for (std::size_t i = 0; row >= 0 && row < dofs.num_rows() && i < 6; ++i)
        view(3 * std::size_t(row) + i, 0) = value(i);
    };
    for (int b = 0; b < 2; ++b) {
      const Move& m = b == 0 ? floor : roof;
      put(dofs.row_of_body(b),
          [&](std::size_t i) { return i < 3 ? m.shift[int(i)] : lengths[b] * m.turn[int(i) - 3]; });
    }
    for (int l = 0; l < dofs.num_links(); ++l)
      if (dofs.row_of_link(l) >= 0)
        put(dofs.row_of_link(l), [&](std::size_t i) { return 0.3 + 0.1 * double(i) - 0.05 * l; });
    return x;
  }

  /// Zero where a constraint prescribes the unknown, else a number that depends on its row.
  Vector direction() const {
    Vector d(system->dofs().map()), moved(system->dofs().map());
    {
      const auto view = d.getLocalViewHost(Tpetra::Access::OverwriteAll);
      for (std::size_t i = 0; i < view.extent(0); ++i)
        view(i, 0) = 2.0 + std::sin(3.7 * double(d.getMap()->getGlobalElement(Local(i))));
    }
    moved.putScalar(1e3);
    system->apply_constraints(moved);
    const auto free = moved.getLocalViewHost(Tpetra::Access::ReadOnly);
    const auto view = d.getLocalViewHost(Tpetra::Access::ReadWrite);
    for (std::size_t i = 0; i < view.extent(0); ++i)
      if (free(i, 0) != 1e3)
        view(i, 0) = 0.0;
    return d;
  }
};

/// Large rotations, the first one accepted; the bodies stand askew against each other.
Vector turned_twice(Scene& scene) {
  scene.system->set_time(0.5);
  Vector unused(scene.system->dofs().map());
  Vector first = scene.unknowns({{{0.1, 0.2, 0.3}}, {{0.4, 0.3, 0.2}}},
                                {{{0.1, 0.0, 0.2}}, {{0.3, 0.4, 0.3}}});
  scene.system->residual(first, unused);
  scene.system->apply_constraints(first);
  scene.system->residual(first, unused);
  scene.system->accept(first);
  scene.system->set_time(1.0);
  Vector x = scene.unknowns({{{0.3, -0.1, 0.4}}, {{1.0, -0.2, 0.5}}},
                            {{{0.2, 0.1, 0.5}}, {{0.7, 0.2, 0.6}}});
  scene.system->apply_constraints(x);
  return x;
}

std::vector<std::pair<std::string, std::vector<Joint>>> cases() {
  Joint driven = joint("driven", cylindrical, 0, 1);
  driven.held = lock;
  driven.motion = {[](double t) { return 0.2 * t; }, [](double t) { return 0.5 * t; }};
  Joint loaded = joint("loaded", cylindrical, 0, 1);
  loaded.load = {[](double t) { return 2.0 * t; }, [](double t) { return -3.0 * t; }};
  Joint ball = joint("ball", lock, 0, 1);
  ball.turn = [](double t) { return t * Vec3{{0.3, -0.8, 0.5}}; };
  Joint couple = joint("couple", spherical, 0, 1);
  couple.couple = [](double t) { return t * Vec3{{1.0, 2.0, -0.5}}; };
  return {{"driven ball", {ball}},
          {"ball with a moment", {couple}},
          {"revolute", {joint("j", revolute, 0, 1)}},
          {"prismatic", {joint("j", prismatic, 1, 0)}},
          {"spherical", {joint("j", spherical, 0, 1)}},
          {"lock", {joint("j", lock, 0, 1)}},
          {"driven", {driven}},
          {"loaded", {loaded}},
          {"on a body that is prescribed", {joint("j", lock, 2, 1), spring(0, 1, 0.7)}},
          {"on the ground", {joint("j", revolute, -1, 0), spring(0, 1, 0.7)}},
          {"of the ground", {joint("j", revolute, 0, -1), spring(0, 1, 0.7)}},
          {"spring", {spring(0, 1, 0.7)}},
          {"spring from nothing", {spring(0, 1, 0.0)}},
          {"spring on what is prescribed", {spring(2, 0, 0.7), spring(0, 1, 0.9)}},
          {"chain", {joint("a", revolute, -1, 0), joint("b", spherical, 0, 1), spring(1, 2, 0.5)}}};
}

double difference(const Vector& a, const Vector& b) {
  Vector d(a.getMap());
  d.assign(a);
  d.update(-1.0, b, 1.0);
  return d.norm2();
}

} // namespace

// Central differences of the residual: error h^2, rounding 1e-16 / h.
TEST(RigidJoint, TangentIsTheDerivativeOfTheResidual) {
  for (const auto& [name, joints] : cases()) {
    Scene scene(Comm(MPI_COMM_WORLD), joints);
    const Vector x = turned_twice(scene), d = scene.direction();
    const auto map = scene.system->dofs().map();
    Vector product(map), plus(map), minus(map), y(map);
    scene.system->tangent(x)->apply(d, product);
    const double h = 1e-5;
    y.update(1.0, x, h, d, 0.0);
    scene.system->residual(y, plus);
    y.update(1.0, x, -h, d, 0.0);
    scene.system->residual(y, minus);
    plus.update(-0.5 / h, minus, 0.5 / h);
    EXPECT_GT(product.norm2(), 1.0) << name;
    EXPECT_LT(difference(product, plus), 1e-8 * product.norm2()) << name;
  }
}

// Joints and springs are internal: their forces on two bodies balance, and so do the moments.
TEST(RigidJoint, ForcesAndMomentsBalance) {
  for (const auto& [name, joints] : cases()) {
    if (joints.size() != 1 || joints[0].body[0] < 0 || joints[0].body[0] == 2 ||
        joints[0].body[1] < 0)
      continue;
    Scene scene(Comm(MPI_COMM_WORLD), joints);
    const Vector x = turned_twice(scene);
    Vector f(x.getMap());
    scene.system->residual(x, f);
    const auto states = scene.system->body_states();
    const unknowns::DofMap& dofs = scene.system->dofs();
    const auto& raw = scene.system->raw_residual();
    const double lengths[2] = {scene.length(0), scene.length(1)};
    double sum[6] = {}, size = 0.0;
    for (int b = 0; b < 2; ++b) {
      const Global row = dofs.row_of_body(b) - dofs.first_row();
      if (row < 0 || row >= dofs.num_rows())
        continue;
      const double* r = &raw[3 * std::size_t(row)];
      const Vec3 force{{r[0], r[1], r[2]}};
      const Vec3 at = scene.body[std::size_t(b)].center + states[std::size_t(b)].displacement;
      const Vec3 moment = lengths[b] * Vec3{{r[3], r[4], r[5]}} + cross(at, force);
      for (int i = 0; i < 3; ++i) {
        sum[i] += force[i];
        sum[3 + i] += moment[i];
      }
      size += norm(force);
    }
    scene.mesh.comm.sum(sum, 6);
    EXPECT_GT(scene.mesh.comm.sum(size), 0.1) << name;
    for (const double s : sum)
      EXPECT_NEAR(s, 0.0, 1e-13 * 10) << name;
  }
}

// A rotation of everything turns forces along and leaves the relative motion alone.
TEST(RigidJoint, IsObjective) {
  const Vec3 turns[2] = {{{0.4, -0.2, 0.3}}, {{0.2, 0.1, 0.5}}}, all{{0.8, 0.5, -0.7}};
  const Vec3 shifts[2] = {{{0.1, 0.2, 0.3}}, {{0.2, 0.1, 0.4}}}, shift{{1.0, -2.0, 0.5}};
  const Mat3 q = rigid::rotation(all);
  for (const auto& [name, joints] : cases()) {
    if (joints[0].body[0] < 0 || joints[0].body[0] == 2 || joints[0].body[1] < 0 ||
        joints[0].couple) // fixed in space
      continue;
    rigid::JointState states[2];
    for (const int turned : {0, 1}) {
      Scene scene(Comm(MPI_COMM_WORLD), joints);
      Scene::Move moves[2];
      for (int b = 0; b < 2; ++b) {
        const Vec3& c = scene.body[std::size_t(b)].center;
        moves[b] = {shifts[b], turns[b]};
        if (turned) {
          moves[b].shift = q * (c + shifts[b]) + shift - c;
          moves[b].turn = rigid::rotation_vector(q * rigid::rotation(turns[b]), Vec3::zero());
        }
      }
      Vector x = scene.unknowns(moves[0], moves[1]), f(x.getMap());
      scene.system->set_time(1.0);
      scene.system->residual(x, f);
      scene.system->apply_constraints(x);
      scene.system->residual(x, f);
      states[turned] = scene.system->joints().states()[0];
    }
    EXPECT_GT(norm(states[0].force), 0.01) << name;
    EXPECT_LT(norm(q * states[0].force - states[1].force), 1e-13) << name;
    EXPECT_LT(norm(q * states[0].moment - states[1].moment), 1e-13) << name;
    EXPECT_NEAR(states[0].translation, states[1].translation, 1e-14) << name;
    EXPECT_NEAR(states[0].rotation, states[1].rotation, 1e-14) << name;
  }
}

TEST(RigidJoint, SameNormsOnAnyNumberOfRanks) {
  MPI_Comm self;
  MPI_Comm_split(MPI_COMM_WORLD, Comm(MPI_COMM_WORLD).rank(), 0, &self);
  for (const auto& [name, joints] : cases()) {
    Scene scene(Comm(MPI_COMM_WORLD), joints), alone(Comm(self), joints);
    double found[2][3];
    Vec3 forces[2];
    int i = 0;
    for (Scene* s : {&scene, &alone}) {
      const Vector x = turned_twice(*s);
      Vector f(x.getMap()), product(x.getMap());
      s->system->residual(x, f);
      s->system->tangent(x)->apply(x, product);
      found[i][0] = f.norm2();
      found[i][1] = product.norm2();
      found[i][2] = s->system->measure().reference;
      forces[i++] = s->system->joints().states()[0].force;
    }
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(found[0][k], found[1][k], 1e-12 * found[1][k]) << name;
    EXPECT_LT(norm(forces[0] - forces[1]), 1e-13) << name;
  }
  MPI_Comm_free(&self);
}

// What other joints hold already is left out, prescribed motion last; what contradicts is told.
TEST(RigidJoint, NothingIsHeldTwice) {
  const auto implied = [](const std::vector<Joint>& joints) {
    return Scene(Comm(MPI_COMM_WORLD), joints).system->joints().implied();
  };
  EXPECT_TRUE(implied({joint("a", revolute, -1, 0), joint("b", revolute, 0, 1)}).empty());
  // A loop of parallel hinges: three of its equations hold no matter what.
  Joint far = joint("c", revolute, 1, -1), middle = joint("b", revolute, 0, 1);
  middle.origin = {{0.9, 0.2, 0.4}};
  far.origin = {{0.1, -0.3, 1.0}};
  EXPECT_EQ(implied({joint("a", revolute, -1, 0), middle, far}).size(), 3u);
  // Two hinges on one line, as exact as files have it; then off it.
  Joint near = joint("a", revolute, 0, 1), second = joint("b", revolute, 0, 1);
  second.origin += 0.5 * second.axis;
  second.axis += Vec3{{3e-6, 0.0, 0.0}};
  EXPECT_EQ(implied({near, second}).size(), 5u);
  second.axis += Vec3{{3e-3, 0.0, 0.0}};
  EXPECT_EQ(implied({near, second}).size(), 4u);
  // The same motion twice: the second time a driver of the loop's own.
  Joint driver = joint("d", revolute, 0, 1);
  driver.held[5] = true;
  driver.motion[1] = [](double t) { return t; };
  const auto list = implied({joint("a", lock, 0, 1), driver});
  ASSERT_EQ(list.size(), 6u);
  EXPECT_EQ(list.back(), (std::pair<std::string, std::string>("d", "rotation about its axis")));

  Scene scene(Comm(MPI_COMM_WORLD), {joint("a", lock, 0, 1), driver});
  const Scene::Move still{Vec3::zero(), Vec3::zero()};
  Vector x = scene.unknowns(still, still), f(x.getMap());
  scene.system->residual(x, f);
  scene.system->require_consistent();
  scene.system->set_time(0.1);
  scene.system->residual(x, f);
  EXPECT_THROW(scene.system->require_consistent(), SolveError);
}

TEST(RigidJoint, RejectsHalfATurnInAStepAndAnAxisWithoutDirection) {
  Joint driver = joint("d", lock, -1, 0);
  driver.motion[1] = [](double t) { return t; };
  Scene scene(Comm(MPI_COMM_WORLD), {driver});
  const Scene::Move still{Vec3::zero(), Vec3::zero()};
  Vector x = scene.unknowns(still, still), f(x.getMap());
  scene.system->set_time(3.1);
  scene.system->residual(x, f);
  scene.system->set_time(3.2);
  EXPECT_THROW(scene.system->residual(x, f), SolveError);
  Joint ball = joint("b", lock, -1, 0);
  ball.turn = [](double t) { return t * Vec3{{0.6, 0.0, 0.8}}; };
  Scene turned(Comm(MPI_COMM_WORLD), {ball});
  turned.system->set_time(1.5);
  turned.system->residual(x, f);
  turned.system->set_time(1.6);
  EXPECT_THROW(turned.system->residual(x, f), SolveError);
  driver.axis = Vec3::zero();
  EXPECT_THROW(Scene(Comm(MPI_COMM_WORLD), {driver}), InputError);
}

TEST(RigidJoint, ASpringPullsByItsElongation) {
  Scene scene(Comm(MPI_COMM_WORLD), {spring(0, 1, 0.7)});
  const Vec3 shift{{0.2, 0.1, 0.4}};
  const Vector x = scene.unknowns({Vec3::zero(), Vec3::zero()}, {shift, Vec3::zero()});
  Vector f(x.getMap());
  scene.system->residual(x, f);
  const auto state = scene.system->joints().states()[0];
  const Vec3 d = Vec3{{0.8, 0.3, 1.3}} + shift;
  EXPECT_NEAR(state.translation, norm(d) - 0.7, 1e-15);
  EXPECT_LT(norm(state.force + (3.0 * (norm(d) - 0.7) / norm(d)) * d), 1e-14);
  EXPECT_NEAR(state.energy, 1.5 * std::pow(norm(d) - 0.7, 2), 1e-14);
  EXPECT_FALSE(scene.system->indefinite());
}
