// SPDX-License-Identifier: BSD-3-Clause
// An interface under the nodal law: points give their gaps to the nodes and get tractions back.
#include "abut/core/error.hpp"
#include "constants.hpp"
#include "dual_law.hpp"
#include "held_nodes.hpp"
#include "node_cells.hpp"
#include "point_search.hpp"

#include <Kokkos_Core.hpp>
#include <algorithm>

namespace abut::contact {

Interaction::~Interaction() = default;

void Interaction::make_dual() {
  if (options_.multipliers != Multipliers::dual)
    return;
  const auto refuse = [&](bool refused, const char* option) {
    if (refused)
      throw InputError("contact." + options_.name + ": 'multipliers: dual' does not go with '" +
                       option + "'");
  };
  refuse(options_.tied, "tied");
  refuse(options_.tension, "tension");
  refuse(options_.tangent == Tangent::automatic, "tangent: automatic");
  refuse(options_.friction_map == FrictionMap::inclined_ray, "friction_map: inclined_ray");
  refuse(options_.friction_map == FrictionMap::literal, "friction_map: literal");
  std::vector<std::array<double, 2>> xi;
  for (Local f = 0; f < primary_.num_faces(); ++f)
    xi.insert(xi.end(), table_[f]->rule.xi.begin(), table_[f]->rule.xi.end());
  std::vector<double> soft(size_.size(), 0.0);
  for (std::size_t f = 0; f < soft.size(); ++f)
    if (options_.friction_switching == FrictionSwitching::primal_dual)
      soft[f] = soft_switching * softest_modulus_ *
                (primary_.modulus[f] > 0.0 ? primary_.inverse_depth[f] : 1.0 / size_[f]);
  dual_ = std::make_unique<DualLaw>(comm_, primary_, corners_, first_point_, xi, area_, size_, soft,
                                    options_.friction > 0.0);
  node_cells_ = std::make_unique<NodeCells>();
}

void Interaction::set_prescribed(const std::vector<char>& directions) {
  held_ = held_nodes(primary_, corners_, directions);
  if (dual_ && options_.formulation != Formulation::node_on_facet) // there each node is a point
    dual_->set_prescribed(held_);
}

/// The point as the kernels take it, with the pressure that the nodes give it.
ContactPoint Interaction::given_point(Local face, int point, const Vec3* y_previous) const {
  ContactPoint c = contact_point(face, point, y_previous);
  c.rule = PointRule::frictionless;
  c.multiplier = points_[point_index(face, point)].pressure;
  c.penalty = c.offset = 0.0;
  return c;
}

Vec3 Interaction::given_shear(Local face, int point) const {
  const PointState& state = points_[point_index(face, point)];
  return state.traction - state.pressure * state.normal;
}

/// Partner, gap and slip of a point.
DualPoint Interaction::read_point(Local face, int point) {
  const Local index = point_index(face, point);
  PointState& state = points_[index];
  const auto at = primary_point(shape(face, point), primary_nodes(face));
  state.offset = present_offset(state);
  const Partner best = lasting_partner(face, point, at);
  DualPoint d;
  state.facing = best.face;
  state.anchor = -1;
  if (best.face < 0) {
    state.gap = options_.reach * size_[face];
    return d;
  }
  state.xi[0] = best.xi[0];
  state.xi[1] = best.xi[1];
  state.penalty = penalty_of(face, best.face);
  Vec3 y[fem::max_face_nodes], y_previous[fem::max_face_nodes];
  facing_.coordinates(best.face, y);
  facing_.previous_coordinates(best.face, y_previous);
  const ContactPoint c = contact_point(face, point, y_previous);
  const auto partner = contact_partner<double>(c, at, y);
  state.xi[0] = partner.xi[0]; // to rounding, the search stops before
  state.xi[1] = partner.xi[1];
  state.gap = partner.gap;
  state.normal = partner.c;
  d.covered = true;
  d.gap = effective_gap(state);
  d.penalty = state.penalty;
  d.normal = partner.c;
  if (options_.friction == 0.0)
    return d;
  d.slip = objective_slip(c, partner);
  for (int a = 0; a < dual_->corners(face); ++a)
    d.carried[std::size_t(a)] = turned_traction(dual_->carried(index, a), at);
  return d;
}

void Interaction::evaluate_nodes() {
  using Execution = Kokkos::DefaultHostExecutionSpace;
  std::vector<DualPoint> read(points_.size());
  const auto faces = Kokkos::RangePolicy<Execution>(0, primary_.num_faces());
  Kokkos::parallel_for("abut::contact::read", faces, [&](Local f) {
    for (int p = 0; p < face_points(f); ++p)
      read[std::size_t(point_index(f, p))] = read_point(f, p);
  });
  dual_->gather(read);
  if (dual_->is_new())
    dual_->start();
  dual_->decide(friction_, frozen_, predicting_);
  Kokkos::parallel_for("abut::contact::spread", faces, [&](Local f) {
    for (int p = 0; p < face_points(f); ++p) {
      PointState& state = points_[point_index(f, p)];
      const Status before = state.status();
      take_traction(f, p);
      state.flips = new_step_ ? 0 : state.flips + (state.status() != before);
    }
  });
}

/// Traction of the nodes at the point; its status is that of the node with most weight there.
void Interaction::take_traction(Local face, int point) {
  const Local index = point_index(face, point);
  PointState& state = points_[index];
  const double *psi = dual_->psi(index), *field = dual_->field(index);
  state.rule = PointRule::open;
  state.touching = true;
  state.pressure = state.multiplier = 0.0;
  Vec3 shear = Vec3::zero();
  double most = 0.0;
  for (int a = 0; state.facing >= 0 && a < dual_->corners(face); ++a) {
    const DualNode& node = dual_->node(dual_->corner_nodes(face)[a]);
    if (!node.active() || psi[a] == 0.0)
      continue;
    state.touching = state.touching && node.touching;
    state.pressure += psi[a] * node.pressure;
    state.multiplier += psi[a] * node.history.multiplier;
    shear += psi[a] * node.traction;
    if (state.rule == PointRule::open || field[a] > most) {
      state.rule = node.rule;
      most = field[a];
    }
  }
  state.touching = state.touching && state.active();
  state.traction = state.pressure * state.normal + shear;
}

/// The rows of this rank's points in the nodes' means.
void Interaction::node_rows(const std::function<bool(Local)>& wanted, const AddRow& add) const {
  const bool friction = friction_ > 0.0;
  PointRows rows;
  Vec3 y[fem::max_face_nodes], y_previous[fem::max_face_nodes];
  for (const Pair& pair : pair_list_) {
    const Local* corner = dual_->corner_nodes(pair.face);
    const int corners = dual_->corners(pair.face);
    const auto takes_part = [&](Local n) { return dual_->node(n).active() && wanted(n); };
    if (std::none_of(corner, corner + corners, takes_part))
      continue;
    facing_.coordinates(pair.facing, y);
    facing_.previous_coordinates(pair.facing, y_previous);
    Global column[2 * fem::max_face_nodes];
    const Local first = primary_.offset[pair.face], n1 = primary_.offset[pair.face + 1] - first;
    for (Local a = 0; a < n1; ++a)
      column[a] = primary_.node[primary_.nodes[first + a]];
    facing_.global_nodes(pair.facing, column + n1);
    for (Local p : pair.points) {
      const Local index = point_index(pair.face, p);
      const ContactPoint c = given_point(pair.face, p, y_previous);
      if (!point_rows(c, primary_nodes(pair.face), y, friction, rows))
        continue; // the tangent of the pair tells of it
      for (int a = 0; a < corners; ++a) {
        const double psi = dual_->psi(index)[a];
        if (psi == 0.0 || !takes_part(corner[a]))
          continue;
        const DualNode& n = dual_->node(corner[a]);
        const NodeFrame frame{n.area,   n.normal_sum, n.penalty * n.share,
                              n.normal, n.trial,      n.out_of_plane};
        const StoredTraction stored = friction ? dual_->carried(index, a) : StoredTraction();
        const TurnedColumns turned(stored, rows.primary, turned_traction(stored, rows.primary.at));
        for (int q = 0; q < rows.columns; ++q)
          add(corner[a], column[q],
              node_row(c, rows, q, psi, area_[index] * psi, friction, frame, &turned));
      }
    }
  }
}

/// Cells of the nodes behind those of the pairs.
void Interaction::add_node_cells(Connectivity& cells) {
  std::vector<std::vector<Global>> columns(primary_.node.size());
  for (std::size_t i = 0; i < pair_list_.size(); ++i) {
    const Local face = pair_list_[i].face;
    for (int a = 0; a < dual_->corners(face); ++a) {
      const Local n = dual_->corner_nodes(face)[a];
      if (dual_->node(n).active())
        columns[n].insert(columns[n].end(), cells.nodes.begin() + cells.offsets[i],
                          cells.nodes.begin() + cells.offsets[i + 1]);
    }
  }
  node_cells_->build(comm_, primary_, dual_->space(), std::move(columns),
                     [&](const auto& wanted, const auto& add) { node_rows(wanted, add); });
  for (Local i = 0; i < node_cells_->size(); ++i) {
    const std::vector<Global>& list = node_cells_->columns(i);
    cells.add(list.data(), static_cast<Local>(list.size()));
  }
}

/// Room for the cells of nodes whose faces come near the other surface.
void Interaction::add_node_candidates(Connectivity& cells,
                                      const std::vector<Local>& cell_face) const {
  std::vector<std::vector<Global>> columns(primary_.node.size());
  for (std::size_t i = 0; i < cell_face.size(); ++i)
    for (int a = 0; a < dual_->corners(cell_face[i]); ++a) {
      auto& list = columns[dual_->corner_nodes(cell_face[i])[a]];
      list.insert(list.end(), cells.nodes.begin() + cells.offsets[i],
                  cells.nodes.begin() + cells.offsets[i + 1]);
    }
  join_columns(comm_, primary_, dual_->space(), columns);
  for (const std::vector<Global>& list : columns)
    if (!list.empty())
      cells.add(list.data(), static_cast<Local>(list.size()));
}

namespace {

/// D t of a node's tangential traction: that of the trial in stick, along the cone in slip.
Mat3 shear_column(const DualNode& n, double friction, const NodeRow& row) {
  Mat3 d = row.trial;
  add_dyad(d, (-n.penalty * n.share_slope / n.area) * (n.slip - dot(n.normal, n.slip) * n.normal),
           row.gap);
  if (n.rule != PointRule::incremental_slip)
    return d;
  add_dyad(d, -n.line.direction, row_times(n.line.direction, d));
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      d[i][j] *= n.line.turning;
  add_dyad(d, (-friction * n.penalty / n.area) * n.line.direction, row.gap);
  return d;
}

} // namespace

void Interaction::scatter_node_cells(const TangentScatter& scatter) {
  node_cells_->fill([&](const auto& wanted, const auto& add) { node_rows(wanted, add); });
  const bool friction = friction_ > 0.0;
  std::vector<double> k;
  for (Local i = 0; i < node_cells_->size(); ++i) {
    const std::vector<NodeRow>& rows = node_cells_->rows(i);
    const DualNode& node = dual_->node(node_cells_->node(i));
    const std::size_t n = rows.size(), width = 3 * n;
    const double stiffness = node.penalty / node.area;
    k.assign(width * width, 0.0);
    for (std::size_t b = 0; b < n; ++b) {
      const Mat3 shear = friction ? shear_column(node, friction_, rows[b]) : Mat3::zero();
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t s = 0; s < 3; ++s)
            k[(3 * a + r) * width + 3 * b + s] =
                stiffness * rows[a].force.v[r] * rows[b].gap.v[s] - rows[a].spread * shear.m[r][s];
    }
    if (options_.tangent == Tangent::symmetric)
      for (std::size_t r = 0; r < width; ++r)
        for (std::size_t s = 0; s < r; ++s)
          k[r * width + s] = k[s * width + r] = 0.5 * (k[r * width + s] + k[s * width + r]);
    scatter.add(static_cast<Local>(pair_list_.size()) + i, k.data());
  }
}

/// The shear of the nodes becomes their multiplier, stored where each point turns it.
void Interaction::store_node_shear() {
  if (options_.friction == 0.0)
    return;
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const auto at = primary_point(shape(f, p), primary_nodes(f));
      for (int a = 0; a < dual_->corners(f); ++a)
        dual_->carried(point_index(f, p), a) =
            store_traction(at, dual_->node(dual_->corner_nodes(f)[a]).traction);
    }
}

void Interaction::augment_nodes() {
  dual_->augment(update_, next_pressures());
  store_node_shear();
}

void Interaction::accept_nodes() {
  for (Local f = 0; f < primary_.num_faces(); ++f)
    for (int p = 0; p < face_points(f); ++p) {
      const Local index = point_index(f, p);
      PointHistory& history = points_[index].history;
      history.gap = points_[index].gap;
      history.in_contact = points_[index].active();
      for (int a = 0; points_[index].facing >= 0 && a < dual_->corners(f); ++a) {
        const DualNode& n = dual_->node(dual_->corner_nodes(f)[a]);
        const double weight = dual_->field(index)[a];
        history.path += weight * dual_->slipped(n);
        history.dissipated += weight * share_ * measure(f, p) * dual_->dissipated(n);
      }
    }
  store_node_shear();
  if (options_.carries_tractions()) {
    std::vector<double> pressures;
    for (Local n = 0; n < primary_.num_nodes(); ++n)
      pressures.push_back(dual_->node(n).pressure);
    const auto pressure_only = [&](const PointState& state, double& pressure, Vec3 shear) {
      update_(state, pressure, shear);
    };
    dual_->augment(update_ ? MultiplierUpdate(pressure_only) : MultiplierUpdate(), pressures);
  }
  dual_->accept();
}

double Interaction::node_pressure(Local face, int face_node) const {
  return dual_->face_value(face, face_node, [](const DualNode& n) { return n.pressure; });
}

Vec3 Interaction::node_shear(Local face, int face_node) const {
  return dual_->face_value(face, face_node, [](const DualNode& n) { return n.traction; });
}

/// Pressure and shear of the nodes read at a point, as the nodes' own functions interpolate them.
double Interaction::field_pressure(Local face, int point) const {
  return dual_->interpolate(face, point, [](const DualNode& n) { return n.pressure; });
}

Vec3 Interaction::field_shear(Local face, int point) const {
  return dual_->interpolate(face, point, [](const DualNode& n) { return n.traction; });
}

/// Twice the energy in the springs of the nodes, per area at a point.
double Interaction::node_spring(Local face, int point) const {
  const Local index = point_index(face, point);
  double sum = 0.0;
  for (int a = 0; a < dual_->corners(face); ++a) {
    const DualNode& n = dual_->node(dual_->corner_nodes(face)[a]);
    if (!n.active() || !(n.penalty > 0.0))
      continue;
    const double normal = n.penalty * n.gap;
    const bool augmented = options_.enforcement == Enforcement::augmented_lagrangian;
    const double shear = augmented ? 0.0 : dot(n.traction, n.traction);
    sum += dual_->field(index)[a] * (normal * normal + shear) / n.penalty;
  }
  return sum;
}

} // namespace abut::contact
