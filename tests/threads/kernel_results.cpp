// SPDX-License-Identifier: BSD-3-Clause
// Results of the kernels of search, contact and solid, to be compared between builds whose kernels
// run on different numbers of threads. Usage: kernel_results OUT. Writes OUT.txt, a line "name
// count" for each array, and OUT.bin, the values of all arrays one after another.
#include "abut/meshgen/generate.hpp"
#include "abut/search/brute_force.hpp"
#include "abut/search/queries.hpp"
#include "abut/solid/load_contribution.hpp"
#include "abut/solid/solid_contribution.hpp"
#include "dual_scene.hpp"

#include <cstdio>
#include <fstream>
#include <random>

using namespace abut;

namespace {

class Results {
public:
  explicit Results(const std::string& path)
      : names_(path + ".txt"), values_(path + ".bin", std::ios::binary) {}

  void add(const std::string& name, const std::vector<double>& v) {
    names_ << name << ' ' << v.size() << '\n';
    values_.write(reinterpret_cast<const char*>(v.data()),
                  static_cast<std::streamsize>(v.size() * sizeof(double)));
  }
  bool good() const { return names_.good() && values_.good(); }

private:
  std::ofstream names_, values_;
};

struct Kind {
  std::string name;
  contact::ContactOptions options;
  fem::FaceType primary = fem::FaceType::quad4, secondary = fem::FaceType::quad4;
  int cells = 6; ///< of the primary, along a side
};

/// Every formulation with every space, without and with friction; every map, other tangents,
/// curved faces, ties, and one scene of many points.
std::vector<Kind> kinds() {
  using namespace contact;
  std::vector<Kind> list;
  Kind k;
  k.options.penalty = 20.0;
  k.options.enforcement = Enforcement::augmented_lagrangian;
  const auto add = [&](const std::string& name, const auto& change) {
    Kind other = k;
    other.name = name;
    change(other);
    list.push_back(other);
  };
  const char* formulations[] = {"node_on_facet", "facet_on_facet", "sliding_elastic"};
  const char* spaces[] = {"per_point", "smoothed", "dual"};
  for (int f = 0; f < 3; ++f)
    for (int m = 0; m < 3; ++m) {
      k.options.formulation = Formulation(f);
      k.options.multipliers = Multipliers(int(Multipliers::per_point) + m);
      const std::string name = std::string(formulations[f]) + "." + spaces[m];
      add(name, [](Kind&) {});
      k.options.friction = 0.3;
      k.options.friction_map = FrictionMap::incremental;
      add(name + ".friction", [](Kind&) {});
      add(name + ".curved", [](Kind& c) {
        c.primary = fem::FaceType::quad8;
        c.secondary = fem::FaceType::tri6;
        c.cells = 4;
      });
      k.options.friction = 0.0;
      k.options.friction_map = FrictionMap::automatic;
    }
  k.options.multipliers = Multipliers::per_point;
  k.options.friction = 0.3;
  add("inclined_ray", [](Kind& c) { c.options.friction_map = FrictionMap::inclined_ray; });
  add("literal", [](Kind& c) { c.options.friction_map = FrictionMap::literal; });
  add("automatic_tangent", [](Kind& c) { c.options.tangent = Tangent::automatic; });
  add("symmetric_tangent", [](Kind& c) { c.options.tangent = Tangent::symmetric; });
  k.options.friction = 0.0;
  add("tied", [](Kind& c) { c.options.tied = true; });
  k.options.formulation = Formulation::facet_on_facet;
  k.options.friction = 0.3;
  add("many_points", [](Kind& c) {
    c.options.multipliers = Multipliers::dual;
    c.cells = 24;
  });
  return list;
}

void add_sites(Results& out, const std::string& name, const contact::Interaction& pair) {
  std::vector<double> site, record;
  for (const contact::Site& s : pair.points().sites()) {
    const Vec3 t = s.traction();
    site.insert(site.end(), {s.gap, s.multiplier, t[0], t[1], t[2]});
  }
  std::vector<double> status;
  for (const contact::PointRecord& r : pair.points().records()) {
    record.insert(record.end(), {r.gap, r.slip, r.pressure, r.shear, r.traction[0], r.traction[1],
                                 r.traction[2]});
    status.insert(status.end(), {double(r.status), double(r.flips)});
  }
  out.add(name + ".sites", site);
  out.add(name + ".records", record);
  out.add(name + ".status!", status); // exactly equal
}

/// Two steps of a story, by hand: each event of contribution.hpp once.
void run_contact(Results& out, const Kind& kind) {
  contact::testing::DualScene scene(kind.primary, kind.secondary, kind.options, 0.05, kind.cells,
                                    0.04, 0.2);
  scene.pair->set_exact_tangent(false);
  const auto at = [&](double phase, const Vec3& shift, const std::string& what) {
    scene.move(0.01, shift, phase);
    scene.system.evaluate(*scene.pair, true);
    const std::string name = "contact." + kind.name + "." + what;
    out.add(name + ".residual", scene.system.residual);
    out.add(name + ".tangent", scene.system.tangent);
    add_sites(out, name, *scene.pair);
  };
  at(0.0, {{0.0, 0.0, 0.0}}, "touch");
  scene.pair->accept();
  scene.pair->begin_step();
  scene.pair->begin_solve(SolveKind::newton);
  at(0.3, {{0.02, 0.01, -0.01}}, "iterate");
  scene.pair->iterate_taken();
  at(0.6, {{0.05, 0.03, -0.02}}, "slide");
  scene.pair->augment();
  scene.pair->begin_solve(SolveKind::after_augmentation);
  at(0.6, {{0.05, 0.03, -0.02}}, "augmented");
  scene.pair->accept();
  scene.pair->begin_step();
  at(0.9, {{0.04, 0.02, -0.03}}, "next_step");
}

/// 20,000 points and lines against a wavy sheet.
void run_search(Results& out, fem::FaceType type, const std::string& name) {
  const mesh::Surface s = contact::testing::patch(type, 24, 0.0, 1.0, false, 0, 0, [](double* x) {
    x[2] = 0.1 * std::sin(7.0 * x[0]) * std::cos(5.0 * x[1]);
  });
  std::vector<Vec3> x;
  for (Local a = 0; a < s.num_nodes(); ++a)
    x.push_back({{s.x[3 * a], s.x[3 * a + 1], s.x[3 * a + 2]}});
  const search::Faces faces{make_view("type", s.type), make_view("offset", s.offset),
                            make_view("node", s.nodes), make_view("x", x)};
  std::vector<search::Box<3>> boxes;
  for (Local f = 0; f < faces.size(); ++f) {
    Vec3 y[fem::max_face_nodes];
    faces.coordinates(f, y);
    boxes.push_back(search::face_box(type, y));
  }
  search::Bvh<3> tree;
  tree.build(boxes);
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> random(-0.2, 1.2);
  std::vector<Vec3> points;
  std::vector<search::Line> lines;
  for (int i = 0; i < 20000; ++i) {
    points.push_back({{random(engine), random(engine), 0.3 * random(engine)}});
    const Vec3 d{{0.5 * random(engine), 0.5 * random(engine), 1.0}};
    lines.push_back({points.back(), (1.0 / norm(d)) * d});
  }
  const auto write = [&](const std::string& what, const View<search::Nearest>& found) {
    std::vector<double> face, place;
    for (std::size_t i = 0; i < found.extent(0); ++i) {
      face.push_back(double(found(i).face));
      place.insert(place.end(), {found(i).xi[0], found(i).xi[1], found(i).distance});
    }
    out.add("search." + name + "." + what + ".face!", face);
    out.add("search." + name + "." + what + ".place", place);
  };
  write("closest", closest_points(faces, tree.view(), make_view("points", points), 0.5));
  write("hits", line_hits(faces, tree.view(), make_view("lines", lines), 0.5));
}

/// A block of one material, bent, under its weight.
void run_solid(Results& out, const std::string& element, int cells) {
  const std::string n = std::to_string(cells);
  const mesh::Mesh mesh = mesh::distribute(
      meshgen::generate("box", {{"divisions", n + "," + n + "," + n}, {"element", element}}),
      Comm(MPI_COMM_WORLD));
  solid::MaterialOptions material;
  material.young = 10.0;
  material.poisson = 0.3;
  solid::SolidContribution body(mesh, 0, solid::make_material(material));
  abut_test::DenseSystem system(mesh.num_local(), 3);
  for (Local a = 0; a < mesh.num_local(); ++a)
    for (int i = 0; i < 3; ++i)
      system.u[std::size_t(3 * a + i)] =
          0.03 * std::sin(2.0 * mesh.x[std::size_t(3 * a + (i + 1) % 3)] + i);
  system.evaluate(body, true);
  out.add("solid." + element + ".residual", system.residual);
  out.add("solid." + element + ".tangent", system.tangent);
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "usage: kernel_results OUT\n");
    return 2;
  }
  MPI_Init(&argc, &argv);
  bool good = false;
  {
    const Kokkos::ScopeGuard kokkos(argc, argv);
    std::printf("kernels on %s, %d threads\n", Execution::name(), Execution().concurrency());
    Results out(argv[1]);
    for (const Kind& kind : kinds())
      run_contact(out, kind);
    run_search(out, fem::FaceType::quad8, "quad8");
    run_search(out, fem::FaceType::tri3, "tri3");
    run_solid(out, "hex8", 8);
    run_solid(out, "tet10", 3);
    good = out.good();
  }
  MPI_Finalize();
  return good ? 0 : 1;
}
