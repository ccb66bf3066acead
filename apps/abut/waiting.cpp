// SPDX-License-Identifier: BSD-3-Clause
// The profiling interface of MPI: a program that defines MPI_X is called in its place, by libraries
// too, and calls PMPI_X itself.
#include "waiting.hpp"

#include <chrono>
#include <mpi.h>

namespace {

bool watching = false;
double waited = 0.0; ///< [s]

template <class Call> int timed(Call call) {
  if (!watching)
    return call();
  const auto start = std::chrono::steady_clock::now();
  const int status = call();
  waited += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return status;
}

} // namespace

namespace abut::app {

WaitingWatch::WaitingWatch() {
  watching = true;
  waited = 0.0;
}

WaitingWatch::~WaitingWatch() {
  watching = false;
}

double WaitingWatch::seconds() {
  return watching ? waited : 0.0;
}

} // namespace abut::app

extern "C" {

int MPI_Barrier(MPI_Comm comm) {
  return timed([&] { return PMPI_Barrier(comm); });
}
int MPI_Bcast(void* data, int count, MPI_Datatype type, int root, MPI_Comm comm) {
  return timed([&] { return PMPI_Bcast(data, count, type, root, comm); });
}
int MPI_Allreduce(const void* in, void* out, int count, MPI_Datatype type, MPI_Op op,
                  MPI_Comm comm) {
  return timed([&] { return PMPI_Allreduce(in, out, count, type, op, comm); });
}
int MPI_Reduce(const void* in, void* out, int count, MPI_Datatype type, MPI_Op op, int root,
               MPI_Comm comm) {
  return timed([&] { return PMPI_Reduce(in, out, count, type, op, root, comm); });
}
int MPI_Exscan(const void* in, void* out, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  return timed([&] { return PMPI_Exscan(in, out, count, type, op, comm); });
}
int MPI_Allgather(const void* in, int in_count, MPI_Datatype in_type, void* out, int out_count,
                  MPI_Datatype out_type, MPI_Comm comm) {
  return timed(
      [&] { return PMPI_Allgather(in, in_count, in_type, out, out_count, out_type, comm); });
}
int MPI_Allgatherv(const void* in, int in_count, MPI_Datatype in_type, void* out,
                   const int* out_counts, const int* offsets, MPI_Datatype out_type,
                   MPI_Comm comm) {
  return timed([&] {
    return PMPI_Allgatherv(in, in_count, in_type, out, out_counts, offsets, out_type, comm);
  });
}
int MPI_Gatherv(const void* in, int in_count, MPI_Datatype in_type, void* out,
                const int* out_counts, const int* offsets, MPI_Datatype out_type, int root,
                MPI_Comm comm) {
  return timed([&] {
    return PMPI_Gatherv(in, in_count, in_type, out, out_counts, offsets, out_type, root, comm);
  });
}
int MPI_Alltoall(const void* in, int in_count, MPI_Datatype in_type, void* out, int out_count,
                 MPI_Datatype out_type, MPI_Comm comm) {
  return timed(
      [&] { return PMPI_Alltoall(in, in_count, in_type, out, out_count, out_type, comm); });
}
int MPI_Alltoallv(const void* in, const int* in_counts, const int* in_offsets, MPI_Datatype in_type,
                  void* out, const int* out_counts, const int* out_offsets, MPI_Datatype out_type,
                  MPI_Comm comm) {
  return timed([&] {
    return PMPI_Alltoallv(in, in_counts, in_offsets, in_type, out, out_counts, out_offsets,
                          out_type, comm);
  });
}
int MPI_Recv(void* data, int count, MPI_Datatype type, int from, int tag, MPI_Comm comm,
             MPI_Status* status) {
  return timed([&] { return PMPI_Recv(data, count, type, from, tag, comm, status); });
}
int MPI_Wait(MPI_Request* request, MPI_Status* status) {
  return timed([&] { return PMPI_Wait(request, status); });
}
int MPI_Waitall(int count, MPI_Request* requests, MPI_Status* statuses) {
  return timed([&] { return PMPI_Waitall(count, requests, statuses); });
}

} // extern "C"
