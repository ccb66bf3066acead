// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/error.hpp"
#include "abut/gmsh/import.hpp"
#include "readers.hpp"

#include <set>

namespace abut::gmsh {

namespace {

constexpr const char* saving = "; save it as version 4.1 or 2.2 (gmsh -format msh41)";

/// Version, kind of file and byte order. Returns 22 or 41.
int read_format(Cursor& cursor, Model& model) {
  const std::string version = cursor.word(), kind = cursor.word(), size = cursor.word();
  if (version != "4.1" && version != "2.2")
    cursor.fail("expected version 4.1 or 2.2, got " + Cursor::shown(version) + saving);
  if (kind != "0" && kind != "1")
    cursor.fail("expected 0 (ASCII) or 1 (binary), got " + Cursor::shown(kind));
  if (size != "8")
    cursor.fail("expected numbers of 8 bytes, got " + Cursor::shown(size));
  if (kind == "1") {
    cursor.skip_line();
    model.binary = true;
    cursor.set_binary(true);
    int one = cursor.integer("the number 1");
    if (one != 1) {
      cursor.set_swapped(true);
      if (one != 1 << 24)
        cursor.fail("expected the number 1 in 4 bytes, which tells of the order of bytes");
    }
    cursor.set_binary(false);
  }
  return version == "2.2" ? 22 : 41;
}

/// What is known of sections that do not make a mesh.
const char* why_ignored(const std::string& name) {
  const std::pair<const char*, const char*> known[] = {
      {"Comments", "a comment"},         {"Periodic", "abut has no periodic conditions"},
      {"Parametrizations", "geometry"},  {"NodeData", "results"},
      {"ElementData", "results"},        {"ElementNodeData", "results"},
      {"InterpolationScheme", "results"}};
  for (const auto& [section, why] : known)
    if (name == section)
      return why;
  return "abut does not know it";
}

class Reader {
public:
  Reader(const std::string& text, Model& model, translation::Report& report)
      : cursor_(text, model), model_(model), report_(report) {}

  void run() {
    while (!cursor_.at_end()) {
      cursor_.section("");
      const std::size_t at = cursor_.at();
      const std::string word = cursor_.word();
      if (word[0] != '$')
        cursor_.fail("expected the beginning of a section, as $Nodes, got " + Cursor::shown(word),
                     at);
      const std::string name = word.substr(1);
      cursor_.section(name);
      if (version_ == 0 && name != "MeshFormat" && name != "Comments")
        cursor_.fail("expected $MeshFormat first", at);
      if (!is_read(name, at))
        skip(name, at);
    }
    cursor_.section("");
    for (const char* name : {"MeshFormat", "Nodes", "Elements"})
      if (!done_.count(name))
        cursor_.fail(std::string("the file ends without a section $") + name);
  }

private:
  bool is_read(const std::string& name, std::size_t at) {
    const bool has_numbers = name == "Nodes" || name == "Elements" || name == "Entities";
    if (!has_numbers && name != "MeshFormat" && name != "PhysicalNames")
      return false;
    if (!done_.insert(name).second)
      cursor_.fail("there is a second section of this name", at);
    if (name == "Entities" && done_.count("Elements"))
      cursor_.fail("expected before $Elements, whose groups it tells", at);
    if (has_numbers && model_.binary && version_ != 22) {
      cursor_.skip_line();
      cursor_.set_binary(true);
    }
    read(name, at);
    cursor_.set_binary(false);
    const std::size_t at_end = cursor_.at();
    const std::string end = cursor_.word();
    if (end != "$End" + name)
      cursor_.fail("expected $End" + name + ", got " + Cursor::shown(end), at_end);
    return true;
  }

  void read(const std::string& name, std::size_t at) {
    const bool is_old = version_ == 22;
    if (name == "MeshFormat") {
      version_ = read_format(cursor_, model_);
    } else if (name == "PhysicalNames") {
      read_names(cursor_, model_);
    } else if (name == "Entities") {
      physical_ = read_entities(cursor_);
    } else if (name == "Nodes") {
      model_.nodes_at = at;
      is_old ? read_nodes_2(cursor_, model_) : read_nodes(cursor_, model_);
    } else {
      model_.elements_at = at;
      is_old ? read_elements_2(cursor_, model_) : read_elements(cursor_, physical_, model_);
    }
  }

  void skip(const std::string& name, std::size_t at) {
    if (name == "PartitionedEntities")
      cursor_.fail(in_parts, at);
    cursor_.skip_to("$End" + name);
    report_.add({static_cast<long long>(at), "$" + Cursor::plain(name), translation::Fate::ignored,
                 why_ignored(name)});
  }

  Cursor cursor_;
  Model& model_;
  translation::Report& report_;
  int version_ = 0;
  std::set<std::string> done_;
  Physical physical_;
};

} // namespace

bool is_msh(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos &&
         (text.compare(first, 11, "$MeshFormat") == 0 || text.compare(first, 9, "$Comments") == 0);
}

Model read_model(const std::string& text, const std::string& file, translation::Report& report) {
  Model model;
  model.file = file;
  Reader(text, model, report).run();
  report.count_bytes(model.binary);
  return model;
}

} // namespace abut::gmsh
