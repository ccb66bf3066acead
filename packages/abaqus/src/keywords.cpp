// SPDX-License-Identifier: BSD-3-Clause
#include "keywords.hpp"

#include "abut/abaqus/model.hpp"
#include "abut/core/error.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace abut::abaqus {

namespace {

constexpr const char* output = "output; abut's own is in the deck";
constexpr const char* numerics = "settings of the solver";
constexpr const char* heat = "abut has no temperature";
constexpr const char* procedure = "abut has *STATIC and *DYNAMIC";
constexpr const char* constraint =
    "abut has no equations between nodes; it has *TIE, *RIGID BODY and *COUPLING with *KINEMATIC";
constexpr const char* structure = "abut has solid elements alone";
constexpr const char* general = "abut needs pairs of surfaces: *CONTACT PAIR";
constexpr const char* not_elastic = "abut's materials are elastic: *ELASTIC and *HYPERELASTIC";

constexpr Keyword keywords[] = {
    {"AMPLITUDE", nullptr, nullptr},
    {"ASSEMBLY", nullptr, nullptr},
    {"BOUNDARY", nullptr, nullptr},
    {"CHANGE FRICTION", nullptr, nullptr},
    {"CLEARANCE", nullptr, nullptr},
    {"CLOAD", nullptr, nullptr},
    {"CONTACT PAIR", nullptr, nullptr},
    {"COUPLING", nullptr, nullptr},
    {"DENSITY", nullptr, nullptr},
    {"DLOAD", nullptr, nullptr},
    {"DSLOAD", nullptr, nullptr},
    {"DYNAMIC", nullptr, nullptr},
    {"ELASTIC", nullptr, nullptr},
    {"ELEMENT", nullptr, nullptr},
    {"ELSET", nullptr, nullptr},
    {"END ASSEMBLY", nullptr, nullptr},
    {"END INSTANCE", nullptr, nullptr},
    {"END PART", nullptr, nullptr},
    {"END STEP", nullptr, nullptr},
    {"EXPANSION", nullptr, nullptr},
    {"FRICTION", nullptr, nullptr},
    {"HEADING", nullptr, nullptr},
    {"HYPERELASTIC", nullptr, nullptr},
    {"INCLUDE", nullptr, nullptr},
    {"INITIAL CONDITIONS", nullptr, nullptr},
    {"INSTANCE", nullptr, nullptr},
    {"KINEMATIC", nullptr, nullptr},
    {"MATERIAL", nullptr, nullptr},
    {"MODEL CHANGE", nullptr, nullptr},
    {"NODE", nullptr, nullptr},
    {"NSET", nullptr, nullptr},
    {"PART", nullptr, nullptr},
    {"RIGID BODY", nullptr, nullptr},
    {"SOLID SECTION", nullptr, nullptr},
    {"STATIC", nullptr, nullptr},
    {"STEP", nullptr, nullptr},
    {"SURFACE", nullptr, nullptr},
    {"SURFACE BEHAVIOR", nullptr, nullptr},
    {"SURFACE INTERACTION", nullptr, nullptr},
    {"TEMPERATURE", nullptr, nullptr},
    {"TIE", nullptr, nullptr},
    {"TRANSFORM", nullptr, nullptr},

    {"CONTACT FILE", output, nullptr},
    {"CONTACT OUTPUT", output, nullptr},
    {"CONTACT PRINT", output, nullptr},
    {"EL FILE", output, nullptr},
    {"EL PRINT", output, nullptr},
    {"ELEMENT OUTPUT", output, nullptr},
    {"ENERGY FILE", output, nullptr},
    {"ENERGY OUTPUT", output, nullptr},
    {"ENERGY PRINT", output, nullptr},
    {"FACE PRINT", output, nullptr},
    {"FILE FORMAT", output, nullptr},
    {"FILE OUTPUT", output, nullptr},
    {"MONITOR", output, nullptr},
    {"NODE FILE", output, nullptr},
    {"NODE OUTPUT", output, nullptr},
    {"NODE PRINT", output, nullptr},
    {"OUTPUT", output, nullptr},
    {"PREPRINT", output, nullptr},
    {"PRINT", output, nullptr},
    {"RADIATION FILE", output, nullptr},
    {"RESTART", output, nullptr},
    {"SECTION FILE", output, nullptr},
    {"SECTION PRINT", output, nullptr},
    {"TIME POINTS", output, nullptr},
    {"CONTACT CONTROLS", numerics, nullptr},
    {"CONTROLS", numerics, nullptr},
    {"SECTION CONTROLS", numerics, nullptr},
    {"SOLVER CONTROLS", numerics, nullptr},
    {"CONDUCTIVITY", heat, nullptr},
    {"GAP CONDUCTANCE", heat, nullptr},
    {"PHYSICAL CONSTANTS", heat, nullptr},
    {"SPECIFIC HEAT", heat, nullptr},
    {"COLOR", "colours", nullptr},
    {"SYSTEM CHECK", numerics, nullptr},

    {"BEAM SECTION", nullptr, structure},
    {"BUCKLE", nullptr, procedure},
    {"CFD", nullptr, procedure},
    {"CFLUX", nullptr, heat},
    {"CHANGE SURFACE BEHAVIOR", nullptr, "the law of a contact stays the same in abut"},
    {"COMPLEX FREQUENCY", nullptr, procedure},
    {"CONTACT", nullptr, general},
    {"CONTACT CLEARANCE", nullptr, general},
    {"CONTACT CLEARANCE ASSIGNMENT", nullptr, general},
    {"CONTACT DAMPING", nullptr, "abut's contact has no damping"},
    {"CONTACT EXCLUSIONS", nullptr, general},
    {"CONTACT INCLUSIONS", nullptr, general},
    {"CONTACT INITIALIZATION ASSIGNMENT", nullptr, general},
    {"CONTACT INITIALIZATION DATA", nullptr, general},
    {"CONTACT INTERFERENCE", nullptr,
     "give 'interference' to the contact in the deck that comes of the file without it"},
    {"CONTACT PROPERTY ASSIGNMENT", nullptr, general},
    {"COUPLED TEMPERATURE-DISPLACEMENT", nullptr, procedure},
    {"CREEP", nullptr, not_elastic},
    {"CYCLIC SYMMETRY MODEL", nullptr, "abut has no cyclic symmetry"},
    {"DAMPING", nullptr, "abut's materials have no damping"},
    {"DASHPOT", nullptr, structure},
    {"DEFORMATION PLASTICITY", nullptr, not_elastic},
    {"DEPVAR", nullptr, not_elastic},
    {"DFLUX", nullptr, heat},
    {"DISTRIBUTING", nullptr, "abut has *KINEMATIC below *COUPLING"},
    {"DISTRIBUTING COUPLING", nullptr, "abut has *COUPLING with *KINEMATIC"},
    {"EMBEDDED ELEMENT", nullptr, constraint},
    {"EQUATION", nullptr, constraint},
    {"FILM", nullptr, heat},
    {"FREQUENCY", nullptr, procedure},
    {"GAP", nullptr, structure},
    {"HEAT TRANSFER", nullptr, procedure},
    {"HYPERFOAM", nullptr,
     "abut has no such law; it has *HYPERELASTIC of NEO HOOKE, MOONEY-RIVLIN "
     "and OGDEN"},
    {"KINEMATIC COUPLING", nullptr, "write *COUPLING with *KINEMATIC"},
    {"MASS", nullptr, structure},
    {"MEMBRANE SECTION", nullptr, structure},
    {"MODAL DAMPING", nullptr, procedure},
    {"MODAL DYNAMIC", nullptr, procedure},
    {"MPC", nullptr, constraint},
    {"ORIENTATION", nullptr, "abut has no directions in materials"},
    {"PLASTIC", nullptr, not_elastic},
    {"PRE-TENSION SECTION", nullptr, constraint},
    {"RADIATE", nullptr, heat},
    {"ROTARY INERTIA", nullptr, structure},
    {"SELECT CYCLIC SYMMETRY MODES", nullptr, procedure},
    {"SHELL SECTION", nullptr, structure},
    {"SPRING", nullptr, structure},
    {"STEADY STATE DYNAMICS", nullptr, procedure},
    {"UNCOUPLED TEMPERATURE-DISPLACEMENT", nullptr, procedure},
    {"USER MATERIAL", nullptr, not_elastic},
    {"VISCO", nullptr, procedure},
    {"VISCOELASTIC", nullptr, not_elastic},
};

} // namespace

const Keyword* find_keyword(const std::string& name) {
  constexpr std::size_t least = 4;
  const std::string key = key_of(name);
  const Keyword* found = nullptr;
  int beginnings = 0;
  for (const Keyword& k : keywords) {
    const std::string known = key_of(k.name);
    if (known == key)
      return &k;
    if (key.size() >= least && known.compare(0, key.size(), key) == 0) {
      found = &k;
      ++beginnings;
    }
  }
  return beginnings == 1 ? found : nullptr;
}

std::string keyword_hint(const std::string& name) {
  std::vector<std::string> valid;
  for (const Keyword& k : keywords)
    if (!k.why_ignored && !k.why_refused)
      valid.emplace_back(k.name);
  return nearest_word_hint(name, valid.data(), valid.size());
}

} // namespace abut::abaqus
