// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/audit/belief.hpp"
#include "abut/audit/findings.hpp"
#include "abut/mesh/mesh.hpp"

#include <memory>
#include <string>
#include <vector>

namespace abut::audit {

/// Whose elements are whose.
struct Bodies {
  std::vector<std::string> names;
  std::vector<int> of_block;      ///< (blocks) index in names
  std::vector<int> frame_of_node; ///< (N) the frame that a node is fixed to, >= 0; -1: it deforms
};

/// Looks at a converged state with means of its own: samples the skin of every body, faces, edges
/// and corners, in the present configuration and finds which of these points lie in an element of
/// another body, or of their own that they do not touch; and sums what interfaces exert. It shares
/// nothing with the search of contact. Pieces of one frame do not count as in each other.
/// docs/user/audit.md
class Audit {
public:
  /// The mesh must outlive the object. tolerance: overlap beyond what is known that counts as none,
  /// in sizes of the smaller face. Collective.
  Audit(const mesh::Mesh& mesh, Bodies bodies, std::vector<Interface> interfaces, double tolerance);
  ~Audit();

  const Names& names() const;

  /// Displacements u (N,3) from which the next step begins: what goes through a body between them
  /// and those of the next look is found. Not collective.
  void begin_step(const double* u);

  /// A state with displacements u (N,3) and what each interface believes of it. Collective.
  Findings look(const double* u, const std::vector<Belief>& beliefs);

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace abut::audit
