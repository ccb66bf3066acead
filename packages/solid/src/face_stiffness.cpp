// SPDX-License-Identifier: BSD-3-Clause
#include "abut/solid/face_stiffness.hpp"

#include "abut/core/error.hpp"
#include "abut/solid/face_kernel.hpp"
#include "abut/solid/reference_checks.hpp"

namespace abut::solid {
namespace {

struct FaceMeasure {
  double area = 0.0;
  Vec3 normal; ///< unit, mean over the face
};

FaceMeasure measure(const mesh::Mesh& mesh, const mesh::Side& s) {
  const mesh::Block& block = mesh.blocks[s.block];
  const fem::CellSide& side = fem::side(block.type, s.side);
  const std::size_t first = static_cast<std::size_t>(s.element) * fem::info(block.type).nodes;
  Vec3 x[fem::max_face_nodes];
  for (int a = 0; a < fem::face_nodes(side.type); ++a)
    for (int i = 0; i < 3; ++i)
      x[a][i] = mesh.x[static_cast<std::size_t>(block.nodes[first + side.nodes[a]]) * 3 + i];
  FaceMeasure m;
  m.normal = Vec3::zero();
  fem::dispatch_face(side.type, [&](auto shape) {
    const auto& face = reference_face<decltype(shape)::type>();
    for (int p = 0; p < face.points; ++p) {
      Vec3 t1, t2;
      face_tangents(face, p, x, t1, t2);
      const Vec3 n = cross(t1, t2);
      m.normal += face.weight[p] * n;
      m.area += face.weight[p] * norm(n);
    }
  });
  const double length = norm(m.normal);
  if (!(length > 0.0))
    throw InputError("element " + std::to_string(block.element_id[std::size_t(s.element)]) +
                     " has a face without area");
  m.normal *= 1.0 / length;
  return m;
}

} // namespace

FaceStiffness face_stiffness(const mesh::Mesh& mesh, const std::vector<mesh::Side>& sides,
                             const BlockMaterials& materials) {
  ABUT_REQUIRE(materials.size() == mesh.blocks.size(), "one material for each block");
  FaceStiffness out;
  for (const mesh::Side& s : sides) {
    const FaceMeasure face = measure(mesh, s);
    const Material* material = materials[s.block];
    out.modulus.push_back(material ? modulus_along(*material, face.normal) : 0.0);
    out.inverse_depth.push_back(face.area / element_volume(mesh, s.block, s.element));
  }
  return out;
}

std::vector<double> penalty_base(const mesh::Mesh& mesh, const std::vector<mesh::Side>& sides,
                                 const BlockMaterials& materials) {
  FaceStiffness stiffness = face_stiffness(mesh, sides, materials);
  for (std::size_t f = 0; f < sides.size(); ++f)
    stiffness.modulus[f] *= stiffness.inverse_depth[f];
  return stiffness.modulus;
}

} // namespace abut::solid
