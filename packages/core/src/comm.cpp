// SPDX-License-Identifier: BSD-3-Clause
#include "abut/core/comm.hpp"

#include "abut/core/error.hpp"
#include "abut/core/machine_error.hpp"

#include <algorithm>
#include <limits>
#include <new>

namespace abut {

Comm::Comm(MPI_Comm comm) : comm_(comm) {
  MPI_Comm_rank(comm_, &rank_);
  MPI_Comm_size(comm_, &size_);
}

namespace {

template <class T> T reduce(T x, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  T result = x;
  MPI_Allreduce(&x, &result, 1, type, op, comm);
  return result;
}

} // namespace

double Comm::sum(double x) const {
  return reduce(x, MPI_DOUBLE, MPI_SUM, comm_);
}
double Comm::max(double x) const {
  return reduce(x, MPI_DOUBLE, MPI_MAX, comm_);
}
double Comm::min(double x) const {
  return reduce(x, MPI_DOUBLE, MPI_MIN, comm_);
}
Global Comm::sum(Global x) const {
  return reduce(x, MPI_LONG_LONG, MPI_SUM, comm_);
}
Global Comm::max(Global x) const {
  return reduce(x, MPI_LONG_LONG, MPI_MAX, comm_);
}
bool Comm::any(bool x) const {
  return max(Global(x ? 1 : 0)) != 0;
}

void Comm::sum(double* x, int count) const {
  MPI_Allreduce(MPI_IN_PLACE, x, count, MPI_DOUBLE, MPI_SUM, comm_);
}

void Comm::max(double* x, int count) const {
  MPI_Allreduce(MPI_IN_PLACE, x, count, MPI_DOUBLE, MPI_MAX, comm_);
}

Global Comm::exclusive_scan(Global x) const {
  Global result = 0;
  MPI_Exscan(&x, &result, 1, MPI_LONG_LONG, MPI_SUM, comm_);
  return rank_ == 0 ? 0 : result;
}

std::vector<Global> Comm::all_gather(Global x) const {
  std::vector<Global> out(static_cast<std::size_t>(size_));
  MPI_Allgather(&x, 1, MPI_LONG_LONG, out.data(), 1, MPI_LONG_LONG, comm_);
  return out;
}

std::vector<double> Comm::all_gather(const std::vector<double>& x) const {
  std::vector<int> counts(static_cast<std::size_t>(size_)), offsets(counts.size() + 1, 0);
  const int mine = static_cast<int>(x.size());
  MPI_Allgather(&mine, 1, MPI_INT, counts.data(), 1, MPI_INT, comm_);
  for (std::size_t r = 0; r < counts.size(); ++r)
    offsets[r + 1] = offsets[r] + counts[r];
  std::vector<double> out(static_cast<std::size_t>(offsets.back()));
  MPI_Allgatherv(x.data(), mine, MPI_DOUBLE, out.data(), counts.data(), offsets.data(), MPI_DOUBLE,
                 comm_);
  return out;
}

void Comm::broadcast(void* data, std::size_t bytes, int root) const {
  const std::size_t chunk = std::size_t(1) << 30;
  for (std::size_t done = 0; done < bytes; done += chunk)
    MPI_Bcast(static_cast<char*>(data) + done, static_cast<int>(std::min(chunk, bytes - done)),
              MPI_BYTE, root, comm_);
}

void Comm::broadcast(std::string& s, int root) const {
  std::vector<char> bytes(s.begin(), s.end());
  broadcast(bytes, root);
  s.assign(bytes.begin(), bytes.end());
}

std::vector<std::vector<char>>
Comm::exchange_bytes(const std::vector<std::vector<char>>& send) const {
  ABUT_REQUIRE(static_cast<int>(send.size()) == size_, "exchange needs one list for each rank");
  const std::size_t ranks = send.size();
  std::vector<int> send_count(ranks), receive_count(ranks), send_offset(ranks + 1, 0),
      receive_offset(ranks + 1, 0);
  for (std::size_t r = 0; r < ranks; ++r) {
    ABUT_REQUIRE(send[r].size() < std::size_t(std::numeric_limits<int>::max()),
                 "a message between two ranks is larger than 2 GiB");
    send_count[r] = static_cast<int>(send[r].size());
  }
  MPI_Alltoall(send_count.data(), 1, MPI_INT, receive_count.data(), 1, MPI_INT, comm_);
  for (std::size_t r = 0; r < ranks; ++r) {
    send_offset[r + 1] = send_offset[r] + send_count[r];
    receive_offset[r + 1] = receive_offset[r] + receive_count[r];
  }
  std::vector<char> out_buffer, in_buffer(static_cast<std::size_t>(receive_offset[ranks]));
  out_buffer.reserve(static_cast<std::size_t>(send_offset[ranks]));
  for (const auto& part : send)
    out_buffer.insert(out_buffer.end(), part.begin(), part.end());
  MPI_Alltoallv(out_buffer.data(), send_count.data(), send_offset.data(), MPI_BYTE,
                in_buffer.data(), receive_count.data(), receive_offset.data(), MPI_BYTE, comm_);
  std::vector<std::vector<char>> received(ranks);
  for (std::size_t r = 0; r < ranks; ++r)
    received[r].assign(in_buffer.begin() + receive_offset[r],
                       in_buffer.begin() + receive_offset[r + 1]);
  return received;
}

void Comm::together(const std::function<void()>& work) const {
  enum Kind : Global { none = 0, defect = 1, solve = 2, input = 3, machine = 4 };
  Global kind = none;
  std::string message;
  try {
    work();
  } catch (const InputError& e) {
    kind = input, message = e.what();
  } catch (const SolveError& e) {
    kind = solve, message = e.what();
  } catch (const MachineError& e) {
    kind = machine, message = e.what();
  } catch (const std::bad_alloc&) {
    kind = machine, message = out_of_memory;
  } catch (const std::exception& e) {
    kind = defect, message = e.what();
  }
  const Global worst = max(kind);
  if (worst == none)
    return;
  const Global speaker = -max(kind == worst ? Global(-rank_) : Global(-size_));
  broadcast(message, static_cast<int>(speaker));
  if (worst == machine)
    throw MachineError(message);
  if (worst == input)
    throw InputError(message);
  if (worst == solve)
    throw SolveError(message);
  throw Defect(message);
}

void Comm::on_root(const std::function<void()>& work) const {
  together([&] {
    if (is_root())
      work();
  });
}

} // namespace abut
