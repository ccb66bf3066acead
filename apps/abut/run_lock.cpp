// SPDX-License-Identifier: BSD-3-Clause
#include "run_lock.hpp"

#include "abut/core/error.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace abut::app {

/// An open file of that name.
struct RunLock::File {
  explicit File(const std::string& p)
      : path(p), id(open(p.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (id < 0)
      throw InputError("cannot write '" + path + "': " + std::strerror(errno));
  }
  ~File() {
    if (owned)
      unlink(path.c_str());
    close(id);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// Whether the path leads elsewhere by now: who held the lock before has removed its file.
  bool lost() {
    struct stat mine {
    }, there{};
    if (!owned ||
        (fstat(id, &mine) == 0 && stat(path.c_str(), &there) == 0 && mine.st_ino == there.st_ino))
      return false;
    owned = false;
    return true;
  }
  std::string text() const {
    std::array<char, 256> bytes{};
    const ssize_t count = pread(id, bytes.data(), bytes.size(), 0);
    return count > 0 ? std::string(bytes.data(), static_cast<std::size_t>(count))
                     : "another process";
  }
  /// Some file systems cannot lock; a run there goes on without.
  bool lock() {
    owned = flock(id, LOCK_EX | LOCK_NB) == 0;
    return owned || errno != EWOULDBLOCK;
  }
  void sign() const {
    std::array<char, 256> host{};
    gethostname(host.data(), host.size() - 1);
    const std::string text = "process " + std::to_string(getpid()) + " on " + host.data();
    if (ftruncate(id, 0) != 0 || pwrite(id, text.data(), text.size(), 0) < 0)
      return; // only the message of another run lacks it
  }

  std::string path;
  int id;
  bool owned = false;
};

RunLock::RunLock(const Comm& comm, const std::string& file) {
  namespace fs = std::filesystem;
  comm.on_root([&] {
    if (file.empty() || (fs::exists(file) && !fs::is_regular_file(file)))
      return;
    do {
      file_ = std::make_unique<File>(file + ".lock");
      if (!file_->lock())
        throw InputError("another run (" + file_->text() + ") is writing '" + file +
                         "'; wait for it, or give this one names of its own");
    } while (file_->lost());
    if (file_->owned)
      file_->sign();
  });
}

RunLock::~RunLock() = default;

} // namespace abut::app
