// SPDX-License-Identifier: Apache-2.0
// qhull as peer: hulls by index, with option Qt (all facets are triangles).
extern "C" {
#include <libqhull_r/qhull_ra.h>
}

#include <gmpxx.h>
#include <touchstone/program/engine_main.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

using namespace touchstone;

/// One run of qhull. Its documentation excludes flat input, with rounding allowed for. It says so itself (error 2),
/// except where it meets with an error before that: then it is decided exactly.
class Run {
 public:
  Run(int dimension, std::vector<double> coordinates) : points_(std::move(coordinates)) {
    char* text = nullptr;
    std::size_t size = 0;
    std::FILE* said = open_memstream(&text, &size);
    qh_zero(&qh_, said);
    char command[] = "qhull Qt";
    const int count = static_cast<int>(points_.size()) / dimension;
    const int error = qh_new_qhull(&qh_, dimension, count, points_.data(), False, command, nullptr, said);
    std::fclose(said);
    const std::string complaint(text, size);
    std::free(text);
    qh_.ferr = stderr;
    flat_ = error == qh_ERRsingular || (error != 0 && rank(dimension) < dimension);
    if (error == 0 || flat_) return;
    release();
    throw std::runtime_error("error " + std::to_string(error) + ": " + complaint.substr(0, complaint.find('\n')));
  }
  ~Run() { release(); }
  Run(const Run&) = delete;

  bool flat() const { return flat_; }
  qhT* qh() { return &qh_; }
  Index index(vertexT* vertex) { return static_cast<Index>(qh_pointid(&qh_, vertex->point)); }

 private:
  /// The dimension of the points' hull, by elimination.
  int rank(int dimension) const {
    std::vector<std::vector<mpq_class>> rows;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (i % dimension == 0) rows.emplace_back();
      rows.back().push_back(mpq_class(points_[i]) - mpq_class(points_[i % dimension]));
    }
    std::size_t found = 0;
    for (int column = 0; column < dimension; ++column) {
      for (std::size_t i = found; i < rows.size(); ++i) {
        if (rows[i][column] != 0) std::swap(rows[i], rows[found]);
      }
      if (found == rows.size() || rows[found][column] == 0) continue;
      for (std::size_t i = found + 1; i < rows.size(); ++i) {
        const mpq_class factor = rows[i][column] / rows[found][column];
        for (int k = column; k < dimension; ++k) rows[i][k] = rows[i][k] - factor * rows[found][k];
      }
      ++found;
    }
    return static_cast<int>(found);
  }

  void release() {
    qh_freeqhull(&qh_, !qh_ALL);
    int bytes = 0, blocks = 0;
    qh_memfreeshort(&qh_, &bytes, &blocks);
  }

  std::vector<double> points_;
  qhT qh_;
  bool flat_ = false;
};

struct Qhull {
  static constexpr const char* name = "qhull 2020.2";
  static constexpr auto boundary = Boundary::closed;

  std::optional<ConvexHull2> convex_hull_2d(const std::vector<Point2d>& points) {
    std::vector<double> coordinates;
    for (const Point2d& p : points) coordinates.insert(coordinates.end(), {p.x, p.y});
    Run run(2, std::move(coordinates));
    if (run.flat()) return std::nullopt;
    std::vector<Index> ring;
    const qhT* qh = run.qh();
    for (facetT* facet = qh->facet_list; ring.size() < static_cast<std::size_t>(qh->num_facets);) {
      vertexT* vertex = nullptr;
      facet = qh_nextfacet2d(facet, &vertex);
      ring.push_back(run.index(vertex));
    }
    return ConvexHull2{2, {}, {}, ring};
  }

  std::optional<ConvexHull> convex_hull(const std::vector<Point3d>& points) {
    std::vector<double> coordinates;
    for (const Point3d& p : points) coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    Run run(3, std::move(coordinates));
    if (run.flat()) return std::nullopt;
    std::vector<Face> faces;
    qhT* qh = run.qh();
    facetT* facet = nullptr;
    vertexT *vertex = nullptr, **vertexp = nullptr;
    FORALLfacets {
      std::vector<Index> corners;
      setT* vertices = qh_facet3vertex(qh, facet);
      FOREACHvertex_(vertices) corners.push_back(run.index(vertex));
      qh_settempfree(qh, &vertices);
      if (corners.size() != 3) throw std::runtime_error("a facet is no triangle");
      faces.push_back({corners[2], corners[1], corners[0]});  // qh_ORIENTclock: they turn inwards
    }
    return ConvexHull{3, {}, {}, {}, faces};
  }
};

TOUCHSTONE_ENGINE_MAIN(Qhull)
