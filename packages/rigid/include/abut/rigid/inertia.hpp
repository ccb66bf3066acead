// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "abut/core/time_integration.hpp"
#include "abut/rigid/body.hpp"

namespace abut::rigid {

/// Rate of momentum of one rigid body, in space axes. Translation follows Newmark's rule as nodes
/// do; rotation applies it to the angular velocity in the body's axes, with the rotation vector of
/// the step as increment, and takes the rate of the angular momentum in space: that momentum is
/// kept where no moment acts, and with the trapezoidal rule the energy too (Simo and Wong, Int. J.
/// Numer. Meth. Eng. 31, 1991). Prescribed motion is differentiated backwards.
/// docs/theory/dynamics.md
class Inertia {
public:
  /// led: directions of the center that are prescribed; turns_led: all of the rotation is.
  Inertia(const Mass& mass, const TimeIntegration& rule, std::array<bool, 3> led, bool turns_led);

  /// Motion at the start; accelerations zero, but for what turning makes of the arm.
  void start(const Vec3& displacement, const Mat3& rotation, const Vec3& velocity,
             const Vec3& spin);
  /// Adds accelerations, of the center and angular, at the start.
  void accelerate(const Vec3& center, const Vec3& angular);

  /// Trial state after a step dt >= 0; 0: the accepted state itself. step_rotation: its rotation
  /// vector in space axes, rotation = exp(skew(step_rotation)) (rotation of the accepted state).
  void move(double dt, const Vec3& displacement, const Mat3& rotation, const Vec3& step_rotation);
  void accept();
  /// The last accepted state, see StateNumbers; the trial state is then that one.
  template <class V> void list_state(V& v) {
    State& s = last_;
    v(s.displacement, s.velocity, s.acceleration, s.rotation, s.spin, s.spin_rate, s.swing,
      s.swing_rate, s.momentum, s.moment, displacement_before_, velocity_before_, before_);
    now_ = last_;
    dt_ = 0.0;
  }
  const Mat3& accepted_rotation() const { return last_.rotation; }

  Vec3 force() const;  ///< rate of momentum
  Vec3 moment() const; ///< rate of angular momentum about the moving center, with its lever

  /// Derivatives of force and moment by the displacement of the center and by step_rotation; after
  /// a step of length zero by the accelerations.
  struct Tangent {
    Mat3 force_by_displacement, force_by_rotation, moment_by_displacement, moment_by_rotation;
  };
  Tangent tangent() const;

  const Vec3& velocity() const { return now_.velocity; }
  Vec3 angular_velocity() const { return now_.rotation * now_.spin; }
  double kinetic_energy() const;
  Vec3 linear_momentum() const { return mass_.mass * (now_.velocity + now_.swing); }
  /// About the origin, when the center stands at a place.
  Vec3 angular_momentum(const Vec3& center) const;

private:
  struct State {
    Vec3 displacement = Vec3::zero(), velocity = Vec3::zero(), acceleration = Vec3::zero();
    Mat3 rotation = Mat3::identity();
    Vec3 spin = Vec3::zero(), spin_rate = Vec3::zero();   ///< in the body's axes
    Vec3 swing = Vec3::zero(), swing_rate = Vec3::zero(); ///< spin x arm
    Vec3 momentum = Vec3::zero(), moment = Vec3::zero();  ///< angular, about the center of mass
  };
  void move_center(double dt, const Vec3& displacement);
  void turn(double dt, const Mat3& rotation, const Vec3& step_rotation);
  void set_momenta();
  Vec3 arm() const { return now_.rotation * mass_.arm; }

  Mass mass_;
  TimeIntegration rule_;
  std::array<bool, 3> led_;
  bool turns_led_;
  State last_, now_;
  Vec3 displacement_before_ = Vec3::zero(), velocity_before_ = Vec3::zero();
  Vec3 step_rotation_ = Vec3::zero();
  double dt_ = 0.0, before_ = 0.0; ///< of this step; of the last one, 0: there was none
};

} // namespace abut::rigid
