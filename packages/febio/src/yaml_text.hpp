// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/translation/yaml_text.hpp"

namespace abut::febio {

using translation::DeckNames;
using translation::FlowMap;
using translation::list_text;
using translation::number_text;
using translation::quoted;
using translation::rounded;
using translation::vector_text;

} // namespace abut::febio
