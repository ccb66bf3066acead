// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/deck/value.hpp"

#include <string>

namespace abut::deck {

/// YAML text -> tree. Anchors, aliases and merge keys (<<) are resolved. Throws InputError
/// "FILE:LINE: ..." for syntax errors, duplicate keys, a top level that is not a map, several
/// documents, endless or excessive nesting.
Value parse_yaml(const std::string& text, const std::string& file);

/// Teuchos ParameterList XML -> tree: sublists are maps, Array(...) lists, TwoDArray(...) lists of
/// lists. Throws InputError as parse_yaml does.
Value parse_xml(const std::string& text, const std::string& file);

/// By the file's extension (.yaml, .yml, .xml), else by the first character: XML begins with '<'.
Value parse(const std::string& text, const std::string& file);

/// A free map -> Teuchos ParameterList XML text. Types follow the values: whole numbers int (long
/// long when large), numbers double, true/false bool, lists of one of them Array, maps sublists,
/// the rest string. Throws InputError for a list of maps and other things that have no type.
std::string to_parameter_list_xml(const Value& map, const std::string& name);

} // namespace abut::deck
