// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Kokkos_Macros.hpp>
#include <cmath>

/// Small fixed-size vectors and matrices for kernels, on any scalar (double or an AD type).
namespace abut {

/// Column vector of D components.
template <class T, int D> struct Vec {
  T v[D];

  KOKKOS_INLINE_FUNCTION T& operator[](int i) { return v[i]; }
  KOKKOS_INLINE_FUNCTION const T& operator[](int i) const { return v[i]; }

  KOKKOS_INLINE_FUNCTION static Vec zero() {
    Vec r;
    for (int i = 0; i < D; ++i)
      r.v[i] = T(0.0);
    return r;
  }
  KOKKOS_INLINE_FUNCTION Vec& operator+=(const Vec& b) {
    for (int i = 0; i < D; ++i)
      v[i] += b.v[i];
    return *this;
  }
  KOKKOS_INLINE_FUNCTION Vec& operator-=(const Vec& b) {
    for (int i = 0; i < D; ++i)
      v[i] -= b.v[i];
    return *this;
  }
  template <class S> KOKKOS_INLINE_FUNCTION Vec& operator*=(const S& s) {
    for (int i = 0; i < D; ++i)
      v[i] *= s;
    return *this;
  }
};

template <class T, int D>
KOKKOS_INLINE_FUNCTION Vec<T, D> operator+(Vec<T, D> a, const Vec<T, D>& b) {
  return a += b;
}
template <class T, int D>
KOKKOS_INLINE_FUNCTION Vec<T, D> operator-(Vec<T, D> a, const Vec<T, D>& b) {
  return a -= b;
}
template <class S, class T, int D>
KOKKOS_INLINE_FUNCTION Vec<T, D> operator*(const S& s, Vec<T, D> a) {
  return a *= s;
}
template <class T, int D> KOKKOS_INLINE_FUNCTION Vec<T, D> operator-(Vec<T, D> a) {
  return a *= -1.0;
}

template <class T, int D> KOKKOS_INLINE_FUNCTION T dot(const Vec<T, D>& a, const Vec<T, D>& b) {
  T s = a[0] * b[0];
  for (int i = 1; i < D; ++i)
    s += a[i] * b[i];
  return s;
}

template <class T, int D> KOKKOS_INLINE_FUNCTION T norm(const Vec<T, D>& a) {
  using std::sqrt;
  return sqrt(dot(a, a));
}

template <class T> KOKKOS_INLINE_FUNCTION Vec<T, 3> cross(const Vec<T, 3>& a, const Vec<T, 3>& b) {
  return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

/// Square matrix of D x D components, row by row.
template <class T, int D> struct Mat {
  T m[D][D];

  KOKKOS_INLINE_FUNCTION T* operator[](int i) { return m[i]; }
  KOKKOS_INLINE_FUNCTION const T* operator[](int i) const { return m[i]; }

  KOKKOS_INLINE_FUNCTION static Mat zero() {
    Mat r;
    for (int i = 0; i < D; ++i)
      for (int j = 0; j < D; ++j)
        r.m[i][j] = T(0.0);
    return r;
  }
  KOKKOS_INLINE_FUNCTION static Mat identity() {
    Mat r = zero();
    for (int i = 0; i < D; ++i)
      r.m[i][i] = T(1.0);
    return r;
  }
};

template <class T, int D>
KOKKOS_INLINE_FUNCTION Mat<T, D> operator*(const Mat<T, D>& a, const Mat<T, D>& b) {
  Mat<T, D> r = Mat<T, D>::zero();
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < D; ++k)
      for (int j = 0; j < D; ++j)
        r[i][j] += a[i][k] * b[k][j];
  return r;
}

template <class T, int D>
KOKKOS_INLINE_FUNCTION Vec<T, D> operator*(const Mat<T, D>& a, const Vec<T, D>& b) {
  Vec<T, D> r = Vec<T, D>::zero();
  for (int i = 0; i < D; ++i)
    for (int k = 0; k < D; ++k)
      r[i] += a[i][k] * b[k];
  return r;
}

template <class T, int D> KOKKOS_INLINE_FUNCTION Mat<T, D> transpose(const Mat<T, D>& a) {
  Mat<T, D> r;
  for (int i = 0; i < D; ++i)
    for (int j = 0; j < D; ++j)
      r[i][j] = a[j][i];
  return r;
}

template <class T> KOKKOS_INLINE_FUNCTION T det(const Mat<T, 2>& a) {
  return a[0][0] * a[1][1] - a[0][1] * a[1][0];
}
template <class T> KOKKOS_INLINE_FUNCTION T det(const Mat<T, 3>& a) {
  return a[0][0] * (a[1][1] * a[2][2] - a[1][2] * a[2][1]) -
         a[0][1] * (a[1][0] * a[2][2] - a[1][2] * a[2][0]) +
         a[0][2] * (a[1][0] * a[2][1] - a[1][1] * a[2][0]);
}

/// Inverse of a with the determinant d = det(a), which must not be zero.
template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 2> inverse(const Mat<T, 2>& a, const T& d) {
  return {{{a[1][1] / d, -a[0][1] / d}, {-a[1][0] / d, a[0][0] / d}}};
}
template <class T> KOKKOS_INLINE_FUNCTION Mat<T, 3> inverse(const Mat<T, 3>& a, const T& d) {
  Mat<T, 3> r;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int a1 = (j + 1) % 3, a2 = (j + 2) % 3, b1 = (i + 1) % 3, b2 = (i + 2) % 3;
      r[i][j] = (a[a1][b1] * a[a2][b2] - a[a1][b2] * a[a2][b1]) / d;
    }
  return r;
}

/// Value of a scalar without its derivatives; overloaded for AD types where they are used.
KOKKOS_INLINE_FUNCTION double value_of(double x) {
  return x;
}

using Vec3 = Vec<double, 3>;
using Mat3 = Mat<double, 3>;

} // namespace abut
