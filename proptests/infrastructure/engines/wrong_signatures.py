#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A member of an engine that has an operation's name and does not take its arguments does not compile, and the message
names the operation and the signature expected; whatever takes them does.

  wrong_signatures.py COMPILER ROOT GENERATED
"""
import re
import subprocess
import sys

ENGINES = """
#include "audit/engines/adapter.h"
using namespace touchstone;
struct Wrong {
  static constexpr const char* name = "wrong 1";
  bool point_in_polygon(Point2d, Polygon2d);                         // swapped
  bool segment_segment(Point2d, Point2d, Point2d, Point2d);          // other types
  bool ray_segment(Ray2d&, Segment2d&);                              // takes nothing that is const
  static bool line_line(Line2d);                                     // one argument less
  bool sphere_aabb(Sphere3d, Aabb2d);                                // of no alternative
  int momentum;                                                      // no function
  Side orientation(Point2d, Point2d, Point2d) const;
 private:
  Height explicit_line(double, double, Point2d);                     // cannot be called
};
struct Base {
  std::optional<Point2d> line_point_at(const ParametricLine2d&, double);
};
struct Right : Base {
  static constexpr const char* name = "right 1";
  using number = float;
  Side orientation(Point2<float>, Point2<float>, Point2<float>) const;
  static bool segment_segment(const Segment2d&, const Segment2d&);
  Height explicit_line(auto slope, auto, const auto&) { return slope > 0 ? Height::above : Height::on; }
  bool sphere_sphere(Circle2d, Circle2d);
  bool sphere_sphere(Sphere3d, Sphere3d);
  bool aabb_aabb(Aabb3d, Aabb3d);
  bool meets(int);
};
struct Closed final {
  static constexpr const char* name = "closed 1";
  Side orientation(Point2d, Point2d, Point2d);
};
std::size_t all(Wrong& wrong, Right& right, Closed& closed) {
  return audit::members_of(wrong).members.size() + audit::members_of(right).members.size() +
         audit::members_of(closed).members.size();
}
"""

# Engines with nothing that could be asked: what the compiler must say, and what it must not.
NOTHING_RIGHT = """
#include "audit/engines/adapter.h"
using namespace touchstone;
struct Lonely {
  static constexpr const char* name = "lonely 1";
  %s
};
std::size_t all(Lonely& lonely) { return audit::members_of(lonely).members.size(); }
"""
NO_OPERATION = "the engine has no member function of the name and arguments of an operation"
WRONG_MEMBER = "the engine's member point_in_polygon cannot be called"

# The message has to hold these, as both compilers write types.
EXPECTED = {
    "explicit_line": "Height ?(double, double, Point2<double>)",
    "line_line": "LineLine<double> ?(Line2<double>, Line2<double>)",
    "momentum": "Vector3<double> ?(std::vector<Body<double>",
    "point_in_polygon": "Location ?(Polygon2<double>, Point2<double>)",
    "ray_segment": "RaySegment<double> ?(Ray2<double>, Segment2<double>)",
    "segment_segment": "SegmentSegment<double> ?(Segment2<double>, Segment2<double>)",
    "sphere_aabb": "Contact ?(Sphere3<double>, Aabb3<double>)",
}


def main():
    compiler, root, generated = sys.argv[1:]

    def compiled(source):
        return subprocess.run([compiler, "-std=c++20", f"-I{root}", f"-I{generated}", "-fsyntax-only", "-x", "c++", "-"],
                              input=source, capture_output=True, text=True)
    done = compiled(ENGINES)
    said = done.stderr.replace("touchstone::", "")
    wrong = [] if done.returncode else ["it compiles"]
    named = set(re.findall(r"error: static.*the engine's member (\w+) cannot be called with the arguments of the operation \1: the signature",
                           said))
    if named != EXPECTED.keys():
        wrong.append(f"named are {sorted(named)}, expected {sorted(EXPECTED)}")
    # Clang goes on where it has refused that the struct is final, and then misses its result.
    usual = re.compile(r"the engine's member|is not final|has_signature|require_signature")
    wrong += [f"another error: {line}" for line in said.splitlines() if "error: " in line and not usual.search(line)]
    if "an engine's struct is not final" not in said:
        wrong.append("an engine that is final is not refused")
    for operation, signature in EXPECTED.items():
        pattern = re.escape(signature).replace(r"\ \?", " ?")
        if not any(re.search(rf"{operation}::require_signature.*{pattern}", line) for line in said.splitlines()):
            wrong.append(f"{operation}: no line with {signature}")
    for member, message, other in (("bool point_in_polygon(Point2d, Polygon2d);", WRONG_MEMBER, NO_OPERATION),
                                   ("bool meets(int);", NO_OPERATION, "cannot be called")):
        errors = [line for line in compiled(NOTHING_RIGHT % member).stderr.splitlines() if "error: " in line]
        if not any(message in line for line in errors) or any(other in line for line in errors):
            wrong += [f"{member} is refused otherwise:", *errors]
    print("\n".join([said] * bool(wrong) + wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
