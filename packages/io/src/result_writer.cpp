// SPDX-License-Identifier: BSD-3-Clause
#include "abut/io/result_writer.hpp"

#include "abut/core/error.hpp"
#include "exodus_file.hpp"
#include "linked.hpp"
#include "put_mesh.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <set>

namespace abut::io {

namespace {

namespace fs = std::filesystem;

constexpr Global one_file_nodes = 200000;

/// FILE.04.1 -> the same width for all ranks, as the Exodus tools expect.
std::string rank_path(const std::string& file, const Comm& comm) {
  const std::string ranks = std::to_string(comm.size()), rank = std::to_string(comm.rank());
  return file + "." + ranks + "." + std::string(ranks.size() - rank.size(), '0') + rank;
}

/// Facts that tell which part of the whole a file is (Nemesis).
void put_parallel_info(const ExodusFile& file, const mesh::Mesh& mesh,
                       const std::vector<Global>& block_counts) {
  char kind[] = "p";
  file.check(ex_put_init_info(file.id(), mesh.comm.size(), 1, kind), "write the rank count");
  file.check(ex_put_init_global(file.id(), mesh.num_nodes, mesh.num_elements,
                                static_cast<std::int64_t>(mesh.blocks.size()),
                                static_cast<std::int64_t>(mesh.node_sets.size()),
                                static_cast<std::int64_t>(mesh.side_sets.size())),
             "write the global sizes");
  if (mesh.blocks.empty())
    return;
  std::vector<std::int64_t> ids, counts(block_counts.begin(), block_counts.end());
  for (const mesh::Block& b : mesh.blocks)
    ids.push_back(b.id);
  file.check(ex_put_eb_info_global(file.id(), ids.data(), counts.data()),
             "write the global blocks");
}

void put_names(const ExodusFile& file, ex_entity_type type, const std::vector<std::string>& names) {
  if (names.empty())
    return;
  const int count = static_cast<int>(names.size());
  file.check(ex_put_variable_param(file.id(), type, count), "write the field count");
  std::vector<std::string> copies = names;
  std::vector<char*> pointers;
  for (std::string& name : copies)
    pointers.push_back(name.data());
  file.check(ex_put_variable_names(file.id(), type, count, pointers.data()),
             "write the field names");
}

int longest(const ResultNames& names, int length) {
  for (const auto* list : {&names.nodal, &names.element, &names.global})
    for (const std::string& name : *list)
      length = std::max(length, static_cast<int>(name.size()));
  return length;
}

std::string lower(std::string name) {
  for (char& c : name)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return name;
}

/// Gives sets a longer name where it is taken.
template <class Sets>
void rename_taken(Sets& sets, const char* kind, std::set<std::string>& taken) {
  Sets renamed;
  for (auto& [name, set] : sets) {
    std::string own = name;
    while (!taken.insert(lower(own)).second)
      own += kind;
    renamed.emplace(std::move(own), std::move(set));
  }
  sets = std::move(renamed);
}

/// IOSS, through which ParaView reads, refuses a file where a block and a set, or two sets, have
/// one name, of whatever kind and case.
void make_names_unique(mesh::MeshData& part) {
  std::set<std::string> taken;
  for (const mesh::BlockData& b : part.blocks)
    taken.insert(lower(b.name));
  rename_taken(part.side_sets, "_faces", taken);
  rename_taken(part.node_sets, "_nodes", taken);
}

} // namespace

std::string part_suffix(int part) {
  std::string number = std::to_string(part);
  if (number.size() < 3)
    number.insert(0, 3 - number.size(), '0');
  return part > 1 ? "-s" + number : "";
}

struct ResultWriter::Impl {
  Impl(const mesh::Mesh& m, const ResultNames& n)
      : mesh(m), names(n), ghosts(mesh::node_exchange(m)) {}

  const mesh::Mesh& mesh;
  ResultNames names;
  NodeExchange ghosts;
  bool one = true;
  std::string path;
  std::optional<ExodusFile> file; ///< open on the ranks that write
  std::vector<int> block_ids;
  std::vector<Local> block_sizes; ///< elements in the file
  std::vector<Global> node_at;    ///< root, one file: place of each gathered node
  std::vector<Global> element_at; ///< root, one file: place of each gathered element
  Local elements = 0;             ///< of this rank
  int steps = 0;
  double last_time = 0.0;

  void create(const mesh::MeshData& part, const std::vector<Global>& block_counts);
  void put_header(const std::string& file_path, const mesh::MeshData& part,
                  const std::vector<Global>& block_counts);
  void require_sizes(const ResultStep& step) const;
  std::vector<std::vector<double>> nodal_values(const ResultStep& step) const;
  std::vector<std::vector<double>> element_values(const ResultStep& step) const;
  void put_step(const ResultStep& step, const std::vector<std::vector<double>>& nodal,
                const std::vector<std::vector<double>>& element);
};

/// block_counts: elements over all ranks, for a file for each rank.
void ResultWriter::Impl::put_header(const std::string& file_path, const mesh::MeshData& part,
                                    const std::vector<Global>& block_counts) {
  file.emplace(ExodusFile::create(file_path));
  put_mesh(*file, part, longest(names, longest_name(part)));
  for (const mesh::BlockData& b : part.blocks) {
    block_ids.push_back(b.id);
    block_sizes.push_back(static_cast<Local>(b.nodes.size() / fem::info(b.type).nodes));
  }
  if (!one)
    put_parallel_info(*file, mesh, block_counts);
  if (!part.x.empty()) // Exodus refuses fields where there is nothing to carry them
    put_names(*file, EX_NODAL, names.nodal);
  if (part.num_elements() > 0)
    put_names(*file, EX_ELEM_BLOCK, names.element);
  put_names(*file, EX_GLOBAL, names.global);
  file->check(ex_update(file->id()), "write to the disk");
}

/// A run may be killed at any moment: the file has its name once it can be read as results. Links
/// are followed, and what is no file is written as it is.
void ResultWriter::Impl::create(const mesh::MeshData& part,
                                const std::vector<Global>& block_counts) {
  const std::string place = linked(path).string(), draft = place + ".unfinished";
  std::error_code ignored;
  if (fs::exists(place, ignored) && !fs::is_regular_file(place, ignored))
    return put_header(place, part, block_counts);
  try {
    put_header(draft, part, block_counts);
    file->move_to(place);
  } catch (...) {
    fs::remove(draft, ignored);
    throw;
  }
}

ResultWriter::ResultWriter(const std::string& stem, const mesh::Mesh& mesh,
                           const ResultNames& names, Files files, int part_number)
    : impl_(std::make_unique<Impl>(mesh, names)) {
  Impl& w = *impl_;
  const Comm& comm = mesh.comm;
  for (const mesh::Block& b : mesh.blocks)
    w.elements += b.size();
  w.one = comm.size() == 1 || files == Files::one ||
          (files == Files::automatic && mesh.num_nodes <= one_file_nodes);
  const std::string file = stem + ".exo" + part_suffix(part_number);
  w.path = w.one ? file : rank_path(file, comm);

  mesh::MeshData part;
  std::vector<Global> block_counts;
  if (w.one) {
    part = mesh::gather(mesh);
    w.node_at = comm.gather(
        std::vector<Global>(mesh.node_input.begin(), mesh.node_input.begin() + mesh.num_owned));
    std::vector<Global> order;
    for (const mesh::Block& b : mesh.blocks)
      order.insert(order.end(), b.element.begin(), b.element.end());
    w.element_at = comm.gather(order);
  } else {
    part = mesh::local_part(mesh);
    for (const mesh::Block& b : mesh.blocks)
      block_counts.push_back(comm.sum(Global(b.size())));
  }
  make_names_unique(part);
  part.title = stem.substr(stem.find_last_of('/') + 1);

  comm.together([&] {
    if (!w.one || comm.is_root())
      w.create(part, block_counts);
  });
}

ResultWriter::~ResultWriter() = default;
ResultWriter::ResultWriter(ResultWriter&&) noexcept = default;
ResultWriter& ResultWriter::operator=(ResultWriter&&) noexcept = default;

const std::string& ResultWriter::path() const {
  return impl_->path;
}
int ResultWriter::steps() const {
  return impl_->steps;
}

void ResultWriter::Impl::require_sizes(const ResultStep& step) const {
  ABUT_REQUIRE(step.nodal.size() == names.nodal.size(), "one list for each nodal field");
  ABUT_REQUIRE(step.element.size() == names.element.size(), "one list for each element field");
  ABUT_REQUIRE(step.global.size() == names.global.size() || !mesh.comm.is_root(),
               "one value for each global variable");
  for (const auto& v : step.nodal)
    ABUT_REQUIRE(v.size() == static_cast<std::size_t>(mesh.num_owned), "a value for each own node");
  for (const auto& v : step.element)
    ABUT_REQUIRE(v.size() == static_cast<std::size_t>(elements), "a value for each element");
  ABUT_REQUIRE(steps == 0 || step.time > last_time, "times of steps must grow");
}

/// Values in the order of the file's nodes; nothing on ranks that do not write.
std::vector<std::vector<double>> ResultWriter::Impl::nodal_values(const ResultStep& step) const {
  std::vector<std::vector<double>> out;
  for (const std::vector<double>& mine : step.nodal) {
    std::vector<double> values(mine);
    if (one) {
      const std::vector<double> all = mesh.comm.gather(mine);
      values.resize(all.size());
      for (std::size_t i = 0; i < all.size(); ++i)
        values[node_at[i]] = all[i];
    } else {
      values.resize(mesh.node.size());
      ghosts.to_ghosts(values.data());
    }
    out.push_back(std::move(values));
  }
  return out;
}

std::vector<std::vector<double>> ResultWriter::Impl::element_values(const ResultStep& step) const {
  std::vector<std::vector<double>> out;
  for (const std::vector<double>& mine : step.element) {
    std::vector<double> values(mine);
    if (one) {
      const std::vector<double> all = mesh.comm.gather(mine);
      values.resize(all.size());
      for (std::size_t i = 0; i < all.size(); ++i)
        values[element_at[i]] = all[i];
    }
    out.push_back(std::move(values));
  }
  return out;
}

void ResultWriter::Impl::put_step(const ResultStep& step,
                                  const std::vector<std::vector<double>>& nodal,
                                  const std::vector<std::vector<double>>& element) {
  const int id = file->id(), number = steps + 1;
  file->check(ex_put_time(id, number, &step.time), "write a time");
  if (!step.global.empty())
    file->check(ex_put_var(id, number, EX_GLOBAL, 1, 0,
                           static_cast<std::int64_t>(step.global.size()), step.global.data()),
                "write the global variables");
  for (std::size_t f = 0; f < nodal.size(); ++f) {
    if (nodal[f].empty())
      continue;
    file->check(ex_put_var(id, number, EX_NODAL, static_cast<int>(f) + 1, 1,
                           static_cast<std::int64_t>(nodal[f].size()), nodal[f].data()),
                "write a nodal field");
  }
  for (std::size_t f = 0; f < element.size(); ++f) {
    const double* values = element[f].data();
    for (std::size_t b = 0; b < block_ids.size(); ++b) {
      if (block_sizes[b] > 0)
        file->check(ex_put_var(id, number, EX_ELEM_BLOCK, static_cast<int>(f) + 1, block_ids[b],
                               block_sizes[b], values),
                    "write an element field");
      values += block_sizes[b];
    }
  }
  file->check(ex_update(id), "write to the disk");
}

void ResultWriter::write_step(const ResultStep& step) {
  Impl& w = *impl_;
  const Comm& comm = w.mesh.comm;
  comm.together([&] { w.require_sizes(step); });
  const auto nodal = w.nodal_values(step);
  const auto element = w.element_values(step);
  ResultStep common{step.time, {}, {}, step.global};
  comm.broadcast(common.global);
  comm.together([&] {
    if (w.file)
      w.put_step(common, nodal, element);
  });
  ++w.steps;
  w.last_time = step.time;
}

} // namespace abut::io
