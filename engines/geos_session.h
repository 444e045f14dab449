// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <geos_c.h>
#include <touchstone/geometry/polygons.h>
#include <touchstone/geometry/thin_shapes.h>

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace touchstone {

/// GEOS through its C interface: what both of its engines need. Errors of the library are thrown with its own words.
class GeosSession {
 public:
  struct Destroy {
    GEOSContextHandle_t context;
    void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy_r(context, geometry); }
  };
  using Geometry = std::unique_ptr<GEOSGeometry, Destroy>;

  GeosSession() : context_(GEOS_init_r(), GEOS_finish_r) {
    GEOSContext_setErrorMessageHandler_r(
        context(), [](const char* message, void* said) { *static_cast<std::string*>(said) = message; }, &said_);
  }

  GEOSContextHandle_t context() const { return context_.get(); }

  template <class T>
  T* made(T* result) const {
    if (result == nullptr) fail();
    return result;
  }
  Geometry owned(GEOSGeometry* geometry) const { return Geometry(made(geometry), {context()}); }
  bool checked(char result) const {
    if (result == 2) fail();
    return result == 1;
  }
  [[noreturn]] void fail() const { throw std::runtime_error(said_); }

  Geometry point(const Point2d& p) const { return owned(GEOSGeom_createPointFromXY_r(context(), p.x, p.y)); }
  Geometry line(const Segment2d& s) const {
    const double ends[] = {s.a.x, s.a.y, s.b.x, s.b.y};
    return owned(GEOSGeom_createLineString_r(context(), made(GEOSCoordSeq_copyFromBuffer_r(context(), ends, 2, 0, 0))));
  }
  Geometry polygon(const Polygon2d& ring) const {
    return owned(GEOSGeom_createPolygon_r(context(), closed(ring), nullptr, 0));
  }
  Geometry polygon(const Region2d& region) const {
    std::vector<GEOSGeometry*> holes;
    for (const Polygon2d& hole : region.holes) holes.push_back(closed(hole));
    return owned(
        GEOSGeom_createPolygon_r(context(), closed(region.outer), holes.data(), static_cast<unsigned>(holes.size())));
  }
  /// A line string of length zero and a ring that meets itself are invalid, and what follows for invalid geometries is
  /// not promised.
  bool valid(const Geometry& geometry) const { return checked(GEOSisValid_r(context(), geometry.get())); }

  /// The dimensions of what interiors, boundaries and exteriors share: nine characters.
  std::string relate(const Geometry& a, const Geometry& b) const {
    const std::unique_ptr<char, std::function<void(char*)>> matrix(made(GEOSRelate_r(context(), a.get(), b.get())),
                                                                   [this](char* text) { GEOSFree_r(context(), text); });
    return matrix.get();
  }

  Point2d vertex(const GEOSGeometry* geometry, int i) const {
    Point2d p{};
    GEOSCoordSeq_getXY_r(context(), made(GEOSGeom_getCoordSeq_r(context(), geometry)), static_cast<unsigned>(i), &p.x,
                         &p.y);
    return p;
  }

 private:
  GEOSGeometry* closed(const Polygon2d& ring) const {
    std::vector<double> corners;
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      const Point2d& p = ring[i % ring.size()];
      corners.insert(corners.end(), {p.x, p.y});
    }
    const auto size = static_cast<unsigned>(ring.size() + 1);
    auto* sequence = made(GEOSCoordSeq_copyFromBuffer_r(context(), corners.data(), size, 0, 0));
    return made(GEOSGeom_createLinearRing_r(context(), sequence));
  }

  std::unique_ptr<GEOSContextHandle_HS, decltype(&GEOS_finish_r)> context_;
  std::string said_;
};

}  // namespace touchstone
