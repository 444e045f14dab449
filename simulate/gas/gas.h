// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <queue>
#include <stdexcept>
#include <vector>

#include "geometry/int128.h"

/// An exact gas: equal cubes in a cubic room, which fly without forces and bounce elastically (deck p. 45-47, 65-69).
/// All numbers are integers, and nothing is rounded: energy and momentum are identical after any number of collisions,
/// and if run backwards the gas returns to its initial bits.
namespace touchstone::simulate::gas {

using Int64 = std::int64_t;
using Wide = Int128;

/// On each axis the low corner of the cube is at line + velocity t.
struct Cube {
  std::array<Int64, 3> line{}, velocity{};
  friend bool operator==(const Cube&, const Cube&) = default;
};

/// p / q with q > 0.
struct Instant {
  Int64 p = 0, q = 1;
  friend bool operator<(const Instant& a, const Instant& b) { return Wide(a.p) * b.q < Wide(b.p) * a.q; }
  friend bool operator==(const Instant& a, const Instant& b) { return Wide(a.p) * b.q == Wide(b.p) * a.q; }
};

/// Cubes that met, or one that met a wall, with their new velocities.
struct Hit {
  Instant at;
  std::vector<std::size_t> cubes;                  ///< ascending
  std::vector<std::array<Int64, 3>> velocities{};  ///< of each of them, afterwards
};

/// The numbers became too long for 64 bits, or the start is invalid.
struct GasError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Counts {
  std::uint64_t pairs = 0;      ///< that met
  std::uint64_t at_walls = 0;   ///< single cubes that met a wall
  std::uint64_t crossings = 0;  ///< from cell to cell of the grid
  std::uint64_t groups = 0;     ///< of three or more cubes that met at one instant
  std::uint64_t mirrored = 0;   ///< groups among these that were reflected about their mean
};

/// The response at one instant t. Two cubes are joined if they have a point in common at t. In a connected part with a
/// pair that is about to overlap, or a cube that is about to leave the room, each axis is handled separately, and there
/// each group of cubes whose faces touch along the axis:
///   - a cube of the group is at a wall: all velocities change their sign;
///   - the group is a row, and the connected part has no contact at an edge or a corner: its velocities are reversed
///     from end to end, as in Newton's cradle; two cubes exchange theirs;
///   - otherwise each velocity v becomes 2 V - v, where V is the mean. If this is not an integer, the unit of length is
///     divided.
/// Each of them keeps energy and, except at walls, momentum, leaves no pair approaching, and undoes itself if time runs
/// backwards. None depends on the order of cubes or axes.
class Gas {
 public:
  /// Low corners are from 0 to `room`. Nothing overlaps, and cubes that touch do not separate: they would have met
  /// before. Throws GasError.
  Gas(Int64 side, Int64 room, std::vector<Cube> cubes);

  /// Runs up to that time, including the events at it. Throws GasError.
  void run(Int64 until);
  /// From now on each hit is added to the list, in order; at one instant those with the least cube first.
  void record(std::vector<Hit>& hits) { hits_ = &hits; }
  /// Reverses every velocity at that time, at which the clock restarts at 0.
  void reverse(Int64 at);

  const std::vector<Cube>& cubes() const { return cubes_; }
  const Counts& counts() const { return counts_; }
  /// The number of current units of length in one at the start.
  Int64 scale() const { return scale_; }
  /// In current units; the sum of squares of velocities, and the sum of velocities including the walls' share.
  Wide doubled_energy() const;
  std::array<Wide, 3> momentum_with_walls() const;
  /// Independent of the order of the cubes.
  std::uint64_t hash() const;

 private:
  enum class Kind : std::uint8_t { pair, wall, crossing };
  struct Event {
    Instant at;
    std::size_t first, second;
    std::uint32_t first_stamp, second_stamp;
    Kind kind;
    int axis;
    friend bool operator<(const Event& a, const Event& b) { return b.at < a.at; }  // the earliest on top
  };
  struct Place {  ///< of a cube in the grid; stamp counts its changes of velocity
    std::array<int, 3> cell;
    std::uint32_t stamp = 0;
  };
  struct Join {
    std::size_t first, second;
    std::array<bool, 3> face;  ///< axes along which faces touch
  };
  /// Cubes that are connected at this instant, and all their joins.
  struct Part {
    std::vector<std::size_t> cubes;
    std::vector<Join> joins;
    bool faces_only = true;
  };

  // gas.cpp: the times of events
  void begin();
  std::vector<std::size_t>& cell(const std::array<int, 3>& at);
  template <class Visit>
  void each_near(std::size_t cube, const Visit& visit) const;
  bool stale(const Event& event) const;
  void expect(Instant at, std::size_t first, std::size_t second, Kind kind, int axis);
  void expect_alone(std::size_t cube);
  void expect_pair(std::size_t a, std::size_t b);
  void expect_near(std::size_t cube);
  void cross(const Event& event);

  // response.cpp: the response to events
  void respond(const std::vector<std::size_t>& seeds);
  Part part_of(std::size_t seed, std::vector<bool>& seen) const;
  void add_hit(const Part& part, const std::vector<bool>& changed);
  void answer(const Part& part, int axis, std::vector<bool>& changed);
  void answer_group(const Part& part, std::vector<std::size_t> group, bool row, int axis, std::vector<bool>& changed);
  void mirror(const std::vector<std::size_t>& group, int axis);
  /// The current position of the cube, times the denominator of the current time.
  Wide scaled_place(std::size_t cube, int axis) const;
  bool at_wall(std::size_t cube, int axis) const;
  bool joined(std::size_t a, std::size_t b, Join& join) const;
  /// True if two joined cubes approach on every axis on which their faces touch; with `backwards`, if they separate.
  bool approach(const Join& join, bool backwards = false) const;
  void require_meeting(std::size_t cube) const;
  void set(std::size_t cube, int axis, Wide line, Wide velocity);
  void rescale(Int64 factor);

  Int64 side_, room_, width_ = 1, scale_ = 1;
  int cells_ = 1;
  std::vector<Cube> cubes_;
  std::vector<Place> places_;
  std::vector<std::vector<std::size_t>> grid_;
  std::priority_queue<Event> events_;
  Instant now_;
  std::array<Wide, 3> wall_impulse_{};
  Counts counts_;
  std::vector<Hit>* hits_ = nullptr;
};

/// SplitMix64: the same integers everywhere.
std::uint64_t mixed(std::uint64_t z);

}  // namespace touchstone::simulate::gas
