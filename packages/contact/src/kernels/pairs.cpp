// SPDX-License-Identifier: BSD-3-Clause
#include "kernels/pairs.hpp"

#include <array>

namespace abut::contact {

namespace {

/// Secondary faces of an active point: of the force, and of the anchor where its nodes take part.
struct Faces {
  Local facing = -1, anchor = -1;
  bool operator==(const Faces& o) const { return facing == o.facing && anchor == o.anchor; }
};

Faces faces_of(const PointState& s) {
  const bool both = s.site.rule == PointRule::inclined_slip && s.anchor != s.facing;
  return {s.facing, both ? s.anchor : -1};
}

void add_cell(const PrimaryView& primary, const FacingView& facing, Local face, const Faces& other,
              Connectivity& cells) {
  Global nodes[3 * fem::max_face_nodes];
  int n = 0;
  for (Local a = primary.first_node(face); a < primary.first_node(face + 1); ++a)
    nodes[n++] = primary.global_node(a);
  for (const Local secondary : {other.facing, other.anchor})
    for (int a = 0; secondary >= 0 && a < facing.nodes(secondary); ++a)
      nodes[n++] = facing.mesh_node(secondary, a);
  cells.add(nodes, n);
}

/// Views over growing lists would be made again for each pair: they are filled behind each other
/// and made once.
struct Lists {
  Kokkos::View<Local*, Memory> list;
  Local size = 0;
  explicit Lists(Local most) : list("abut::contact::pair_list", std::size_t(most)) {}
  void add(Local value) { list(size++) = value; }
  View<Local> taken() const {
    return Kokkos::subview(list, std::make_pair(Local(0), size));
  }
};

} // namespace

PairArrays make_pairs(const PrimaryView& primary, const FacingView& facing,
                      const PointArrays& points, Connectivity& cells) {
  const Local most = primary.points();
  Lists face(most), other(most), anchor(most), first_point(most + 1), point(most),
      first_column(most + 1);
  first_point.add(0);
  first_column.add(0);
  std::array<Faces, 64> met; // of one face; it has fewer points
  for (Local f = 0; f < primary.faces(); ++f) {
    std::size_t count = 0;
    const Local begin = primary.first_point(f), end = primary.first_point(f + 1);
    for (Local p = begin; p < end; ++p) {
      if (!points.state(p).site.active())
        continue;
      const Faces faces = faces_of(points.state(p));
      std::size_t k = 0;
      while (k < count && !(met[k] == faces))
        ++k;
      if (k == count)
        met[count++] = faces;
    }
    for (std::size_t k = 0; k < count; ++k) {
      face.add(f);
      other.add(met[k].facing);
      anchor.add(met[k].anchor);
      for (Local p = begin; p < end; ++p)
        if (points.state(p).site.active() && faces_of(points.state(p)) == met[k])
          point.add(p);
      first_point.add(point.size);
      add_cell(primary, facing, f, met[k], cells);
      first_column.add(static_cast<Local>(cells.nodes.size()));
    }
  }
  return {face.taken(),        other.taken(), anchor.taken(),
          first_point.taken(), point.taken(), first_column.taken()};
}

} // namespace abut::contact
