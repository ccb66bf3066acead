// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/types.hpp"

#include <cstddef>
#include <functional>
#include <mpi.h>
#include <string>
#include <vector>

namespace abut {

/// A communicator passed in by the host, with the few collective operations that abut needs.
/// Every member that is not const-trivial (sum, exchange, ...) is collective.
class Comm {
public:
  explicit Comm(MPI_Comm comm);

  int rank() const { return rank_; }
  int size() const { return size_; }
  bool is_root() const { return rank_ == 0; }
  MPI_Comm mpi() const { return comm_; }

  double sum(double x) const;
  double max(double x) const;
  double min(double x) const;
  Global sum(Global x) const;
  Global max(Global x) const;
  bool any(bool x) const;
  void sum(double* x, int count) const;
  void max(double* x, int count) const;
  /// Sum of x over the ranks below this one.
  Global exclusive_scan(Global x) const;

  std::vector<Global> all_gather(Global x) const;
  std::vector<double> all_gather(const std::vector<double>& x) const;

  void broadcast(void* data, std::size_t bytes, int root = 0) const;
  void broadcast(std::string& s, int root = 0) const;
  template <class T> void broadcast(std::vector<T>& v, int root = 0) const {
    Global n = static_cast<Global>(v.size());
    broadcast(&n, sizeof n, root);
    v.resize(static_cast<std::size_t>(n));
    broadcast(v.data(), v.size() * sizeof(T), root);
  }

  /// Sends send[r] to each rank r; returns what each rank sent here.
  template <class T>
  std::vector<std::vector<T>> exchange(const std::vector<std::vector<T>>& send) const {
    std::vector<std::vector<char>> bytes(send.size());
    for (std::size_t r = 0; r < send.size(); ++r) {
      const char* p = reinterpret_cast<const char*>(send[r].data());
      bytes[r].assign(p, p + send[r].size() * sizeof(T));
    }
    const auto received = exchange_bytes(bytes);
    std::vector<std::vector<T>> out(received.size());
    for (std::size_t r = 0; r < received.size(); ++r) {
      const T* p = reinterpret_cast<const T*>(received[r].data());
      out[r].assign(p, p + received[r].size() / sizeof(T));
    }
    return out;
  }

  /// Concatenation, in rank order, of every rank's v; empty on all ranks but the root.
  template <class T> std::vector<T> gather(const std::vector<T>& v) const {
    std::vector<std::vector<T>> send(static_cast<std::size_t>(size_));
    send[0] = v;
    const auto received = exchange(send);
    std::vector<T> out;
    for (const auto& part : received)
      out.insert(out.end(), part.begin(), part.end());
    return out;
  }

  /// Runs `work` on every rank. If it throws anywhere, all ranks throw the error of the lowest
  /// failing rank, so that no rank waits for another: InputError before SolveError before Defect.
  void together(const std::function<void()>& work) const;

  /// Runs `work` on the root only; an exception there is thrown on all ranks.
  void on_root(const std::function<void()>& work) const;

private:
  std::vector<std::vector<char>> exchange_bytes(const std::vector<std::vector<char>>& send) const;

  MPI_Comm comm_;
  int rank_ = 0;
  int size_ = 1;
};

} // namespace abut
