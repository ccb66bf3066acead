// SPDX-License-Identifier: BSD-3-Clause
#include "abut/io/checkpoint_file.hpp"

#include "abut/core/checksum.hpp"
#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"
#include "linked.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <unistd.h>

namespace abut::io {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* magic = "abut checkpoint ";
constexpr int format = 1;
constexpr std::size_t first_line = 16 + 4 + 1 + 20 + 1; ///< magic, format, space, bytes, new line

static_assert(sizeof(Global) == 8 && sizeof(double) == 8, "what the file holds");

/// First line of a file of so many bytes.
std::string head(std::size_t bytes) {
  char line[first_line + 1];
  std::snprintf(line, sizeof line, "%s%4d %20zu\n", magic, format, bytes);
  return line;
}

Json facts_of(const Checkpoint& c) {
  Json arrays = Json::array();
  for (const StateArchive::Array& a : c.arrays)
    arrays.push_back({{"name", a.name},
                      {"width", a.width},
                      {"keys", a.keys.size()},
                      {"values", a.values.size()}});
  return {{"program", c.program}, {"deck", c.deck}, {"t", c.t},         {"step", c.step},
          {"part", c.part},       {"mesh", c.mesh}, {"model", c.model}, {"arrays", arrays}};
}

template <class T> void append(std::string& bytes, const std::vector<T>& list) {
  bytes.append(reinterpret_cast<const char*>(list.data()), list.size() * sizeof(T));
}

template <class T> std::vector<T> cut_off(const char*& from, std::size_t count) {
  std::vector<T> list(count);
  std::memcpy(list.data(), from, count * sizeof(T));
  from += count * sizeof(T);
  return list;
}

std::uint64_t checksum(const std::string& bytes, std::size_t count) {
  Checksum sum;
  sum.add(bytes.data(), count);
  return sum.value();
}

std::string encoded(const Checkpoint& checkpoint) {
  const std::string facts =
      facts_of(checkpoint).dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  std::size_t count = first_line + facts.size() + sizeof(std::uint64_t);
  for (const StateArchive::Array& a : checkpoint.arrays)
    count += 8 * (a.keys.size() + a.values.size());
  std::string bytes = head(count) + facts;
  bytes.reserve(count);
  for (const StateArchive::Array& a : checkpoint.arrays) {
    append(bytes, a.keys);
    append(bytes, a.values);
  }
  append(bytes, std::vector<std::uint64_t>{checksum(bytes, bytes.size())});
  return bytes;
}

/// A file that is closed, and removed where it did not come to be.
struct Draft {
  explicit Draft(std::string p)
      : path(std::move(p)), id(open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  }
  ~Draft() {
    if (id >= 0)
      close(id);
    if (!kept)
      unlink(path.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  bool put(const std::string& bytes) const {
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t count = write(id, bytes.data() + done, bytes.size() - done);
      if (count < 0 && errno != EINTR)
        return false;
      done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    return fsync(id) == 0;
  }

  std::string path;
  int id;
  bool kept = false;
};

/// The rename itself reaches the disk with the folder; some file systems cannot be asked for it.
void sync_folder(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  const int id = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (id < 0)
    return;
  fsync(id);
  close(id);
}

/// The bytes of a file that is what its first line says, up to the checksum.
std::string read_whole(const std::string& path) {
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path))
    throw InputError("it cannot be read: " +
                     std::string(errno ? std::strerror(errno) : "it is a folder"));
  std::string bytes(std::istreambuf_iterator<char>(in), {});
  if (bytes.compare(0, std::strlen(magic), magic) != 0)
    throw InputError("it is not a checkpoint of abut");
  int version = 0;
  std::size_t count = 0;
  if (bytes.size() < first_line)
    throw InputError("it is cut short: " + std::to_string(bytes.size()) + " bytes");
  if (std::sscanf(bytes.c_str() + std::strlen(magic), "%d %zu", &version, &count) != 2)
    throw InputError("it is damaged: its first line cannot be read");
  if (version != format)
    throw InputError("its format is " + std::to_string(version) + ", this abut reads format " +
                     std::to_string(format));
  if (bytes.size() != count)
    throw InputError((bytes.size() < count ? "it is cut short: " : "it is damaged: ") +
                     std::to_string(bytes.size()) + " of " + std::to_string(count) + " bytes");
  std::uint64_t written = 0;
  const std::size_t content = count - sizeof written;
  std::memcpy(&written, bytes.data() + content, sizeof written);
  if (written != checksum(bytes, content))
    throw InputError("it is damaged: its checksum does not fit");
  return bytes;
}

Checkpoint decoded(const std::string& bytes) {
  const std::size_t end = bytes.find('\n', first_line);
  const Json facts =
      Json::parse(bytes.begin() + first_line, bytes.begin() + static_cast<std::ptrdiff_t>(end));
  Checkpoint c;
  facts.at("program").get_to(c.program);
  facts.at("deck").get_to(c.deck);
  facts.at("t").get_to(c.t);
  facts.at("step").get_to(c.step);
  facts.at("part").get_to(c.part);
  facts.at("mesh").get_to(c.mesh);
  facts.at("model").get_to(c.model);
  const char* from = bytes.data() + end + 1;
  for (const Json& shape : facts.at("arrays")) {
    StateArchive::Array& a = c.arrays.emplace_back();
    shape.at("name").get_to(a.name);
    shape.at("width").get_to(a.width);
    a.keys = cut_off<Global>(from, shape.at("keys").get<std::size_t>());
    a.values = cut_off<double>(from, shape.at("values").get<std::size_t>());
  }
  return c;
}

} // namespace

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  const std::string place = linked(path).string();
  Draft draft(place + ".unfinished");
  if (draft.id < 0 || !draft.put(encoded(checkpoint)) ||
      std::rename(draft.path.c_str(), place.c_str()) != 0)
    throw MachineError("cannot write '" + path + "': " + std::strerror(errno));
  draft.kept = true;
  sync_folder(place);
}

Checkpoint read_checkpoint(const std::string& path) {
  try {
    return decoded(read_whole(path));
  } catch (const InputError& e) {
    throw InputError("checkpoint '" + path + "': " + e.what());
  } catch (const Json::exception& e) {
    throw InputError("checkpoint '" + path + "': it cannot be understood: " + e.what());
  }
}

bool is_checkpoint(const std::string& path) {
  std::string start(std::strlen(magic), '\0');
  std::ifstream(path, std::ios::binary).read(start.data(), static_cast<long>(start.size()));
  return start == magic;
}

} // namespace abut::io
