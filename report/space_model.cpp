// SPDX-License-Identifier: Apache-2.0
#include "report/space_model.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace touchstone::audit {
namespace {

constexpr std::size_t most_items = 3000, most_labels = 40, most_places = 12, parts_apart = 4, longest_numbered = 20;
constexpr int small_extent = steps_of_box / 40;  // about three pixels
constexpr int dot_of_point = 42, dot_of_end = 32, dot_of_centre = 18;

using Kind = SpaceFigure::Kind;

/// Two figures of one list have the same colour.
std::string list_of(const std::string& label) { return label.substr(0, label.find('[')); }

/// Directions of length 1 for the eye: a plane's normal and two across it.
struct Directions {
  std::array<double, 3> normal, across, along;
};

std::array<double, 3> of_length_one(const std::array<double, 3>& v) {
  const double size = std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
  const double x = v[0] / size, y = v[1] / size, z = v[2] / size, length = std::sqrt(x * x + y * y + z * z);
  return {x / length, y / length, z / length};
}

std::array<double, 3> crossed(const std::array<double, 3>& v, const std::array<double, 3>& w) {
  return {v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0]};
}

Directions directions_of(const SpaceFigure& plane) {
  // Subnormal coordinates have few digits, but as many as there are.
  const std::array<double, 3> normal = of_length_one({plane.numbers[0], plane.numbers[1], plane.numbers[2]});
  // The axis that is least along the normal; of equal ones the first, so that a level plane lies along x and z.
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::fabs(normal[i]) < std::fabs(normal[least])) least = i;
  }
  std::array<double, 3> axis{};
  axis[least] = 1;
  const std::array<double, 3> across = of_length_one(crossed(normal, axis));
  return {normal, across, crossed(normal, across)};
}

class Builder {
 public:
  explicit Builder(const std::vector<SpaceFigure>& figures) {
    model_.scale = SpaceScale::of(figures);
    for (const SpaceFigure& figure : figures) ++size_of_list_[list_of(figure.label)];
    std::size_t part = 0, drawn = 0;
    std::string before;
    for (const SpaceFigure& figure : figures) {
      const bool of_question = !figure.answer && !figure.said;
      const std::string list = list_of(figure.label);
      if (of_question && !figure.label.empty() && drawn > 0 && list != before) ++part;
      if (of_question && !figure.label.empty()) before = list, ++drawn;
      style_ = figure.said            ? "said"
               : figure.answer        ? "truth"
               : figure.label.empty() ? "aid"
                                      : "q" + std::to_string(part % parts_apart);
      if (weight(figure) + model_.items.size() > most_items) {
        ++model_.left_out;
        continue;
      }
      build(figure);
    }
    measure_reach();
  }

  SpaceModel model() && { return std::move(model_); }

 private:
  static std::size_t weight(const SpaceFigure& figure) {
    std::size_t weight = figure.numbers.size() / 3 + 1;
    for (const auto& face : figure.faces) weight += 1 + face.size();
    return figure.kind == Kind::box ? 24 : weight;
  }

  int add(const SpacePoint& point) {
    model_.points.push_back(point);
    return static_cast<int>(model_.points.size()) - 1;
  }
  int add(const ExactPlace& place) { return add(model_.scale.at(place)); }
  int add(const SpacePoint& start, const std::array<double, 3>& way, double length) {
    const auto along = [length](int from, double part) {
      return from + static_cast<int>(std::floor(part * length + 0.5));
    };
    return add(SpacePoint{along(start.x, way[0]), along(start.y, way[1]), along(start.z, way[2])});
  }
  const SpacePoint& point(int i) const { return model_.points[static_cast<std::size_t>(i)]; }

  void item(SpaceItem::Kind kind, std::vector<int> numbers) {
    if (kind == SpaceItem::Kind::face) ++faces_;
    model_.items.push_back({kind, style_, std::move(numbers)});
  }

  /// The first element of a list bears its name, the others their numbers; of a long list the first alone is named.
  std::string text_of(const SpaceFigure& figure) const {
    const std::string list = list_of(figure.label), number = figure.label.substr(list.size());
    const bool long_list = size_of_list_.at(list) > longest_numbered;
    if (!number.empty() && number != "[0]") return long_list ? "" : number;
    return (figure.answer ? "truth: " : "") + (long_list ? list : figure.label);
  }

  void label(const SpaceFigure& figure, std::vector<int> places, int radius = 0) {
    const std::string text = text_of(figure);
    if (text.empty() || model_.labels.size() >= most_labels) return;
    if (places.size() > most_places) places.resize(most_places);
    model_.labels.push_back({text, style_, std::move(places), radius});
  }

  /// A point of a straight piece, `hundredths` of the way.
  int between(int a, int b, int hundredths) {
    const auto part = [hundredths](int from, int to) {
      return static_cast<int>(from + static_cast<long long>(to - from) * hundredths / 100);
    };
    const SpacePoint p = point(a), q = point(b);
    return add(SpacePoint{part(p.x, q.x), part(p.y, q.y), part(p.z, q.z)});
  }

  /// Faces with their edges. An edge knows its faces, so that it is drawn as hidden where all of them look away.
  std::vector<int> solid(const std::vector<std::vector<int>>& faces, bool closed) {
    std::map<std::pair<int, int>, std::size_t> edges;
    std::vector<std::vector<int>> numbers;
    for (const std::vector<int>& face : faces) {
      item(SpaceItem::Kind::face, face);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const int a = face[i], b = face[(i + 1) % face.size()];
        const auto [at, is_new] = edges.emplace(std::minmax(a, b), numbers.size());
        if (is_new) numbers.push_back({a, b});
        if (closed) numbers[at->second].push_back(faces_ - 1);
      }
    }
    std::vector<int> middles;
    for (std::vector<int>& edge : numbers) {
      if (middles.size() < most_places) middles.push_back(between(edge[0], edge[1], 50));
      // With one face it is a rim, which nothing of its surface hides.
      if (edge.size() == 3) edge.pop_back();
      item(SpaceItem::Kind::edge, std::move(edge));
    }
    return middles;
  }

  /// What would be too small to see gets a dot.
  void dot_if_small(int first, int last) {
    const SpacePoint& p = point(first);
    for (int i = first; i <= last; ++i) {
      const SpacePoint& q = point(i);
      if (std::max({std::abs(q.x - p.x), std::abs(q.y - p.y), std::abs(q.z - p.z)}) > small_extent) return;
    }
    item(SpaceItem::Kind::dot, {first, dot_of_end});
  }

  void build_plane(const SpaceFigure& figure) {
    const int centre = add(model_.scale.foot(figure));
    const SpacePoint at = point(centre);
    const Directions ways = directions_of(figure);
    const double half = model_.scale.only_planes ? steps_of_box : 0.8 * steps_of_box;
    std::vector<int> corners;
    for (const auto& [u, v] : {std::pair{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}) {
      std::array<double, 3> way{};
      for (std::size_t i = 0; i < 3; ++i) way[i] = u * ways.across[i] + v * ways.along[i];
      corners.push_back(add(at, way, half));
    }
    std::vector<int> places = solid({corners}, false);
    places.insert(places.begin(), corners.begin(), corners.end());
    item(SpaceItem::Kind::arrow, {centre, add(at, ways.normal, half / 2)});
    label(figure, places);
  }

  void build(const SpaceFigure& figure) {
    if (figure.kind == Kind::plane) return build_plane(figure);
    const int first = static_cast<int>(model_.points.size());
    for (const ExactPlace& place : places_of(figure)) add(place);
    const int last = static_cast<int>(model_.points.size()) - 1;
    switch (figure.kind) {
      case Kind::plane: return;
      case Kind::point:
        if (figure.answer) {
          item(SpaceItem::Kind::ring, {first});
        } else {
          item(SpaceItem::Kind::dot, {first, dot_of_point});
        }
        return label(figure, {first});
      case Kind::segment:
      case Kind::arrow: {
        const bool arrow = figure.kind == Kind::arrow;
        item(arrow ? SpaceItem::Kind::arrow : SpaceItem::Kind::edge, {first, last});
        if (!figure.label.empty()) item(SpaceItem::Kind::dot, {first, dot_of_end});
        if (!figure.label.empty() && !arrow) item(SpaceItem::Kind::dot, {last, dot_of_end});
        std::vector<int> places;
        for (const int hundredths : {50, 30, 70, 85, 15}) places.push_back(between(first, last, hundredths));
        return label(figure, places);
      }
      case Kind::polygon: {
        std::vector<int> ring;
        for (int i = first; i <= last; ++i) ring.push_back(i);
        const std::vector<int> places = solid({ring}, false);
        dot_if_small(first, last);
        return label(figure, places);
      }
      case Kind::box: return build_box(figure, first);
      case Kind::sphere: {
        const int radius = model_.scale.radius_in_steps(figure);
        item(SpaceItem::Kind::dot, {first, radius > small_extent ? dot_of_centre : dot_of_end});
        if (radius > 0) item(SpaceItem::Kind::ball, {first, radius});
        return label(figure, {first}, radius);
      }
      case Kind::mesh: return build_mesh(figure, first, last);
    }
  }

  void build_box(const SpaceFigure& figure, int first) {
    const SpacePoint low = point(first), high = point(first + 1);
    std::vector<int> corner;  // bit 0: x, bit 1: y, bit 2: z
    for (int i = 0; i < 8; ++i) {
      corner.push_back(add(SpacePoint{i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z}));
    }
    std::vector<std::vector<int>> faces;
    for (const auto& [a, b, c, d] :
         {std::array{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
      faces.push_back({corner[a], corner[b], corner[c], corner[d]});
    }
    const std::vector<int> places = solid(faces, true);
    dot_if_small(first, first + 1);
    label(figure, places);
  }

  void build_mesh(const SpaceFigure& figure, int first, int last) {
    std::vector<std::vector<int>> faces;
    std::vector<bool> used(static_cast<std::size_t>(last - first + 1));
    for (const auto& given : figure.faces) {
      // A face may name a vertex that is not there: the input is refused, and drawn without it.
      if (std::any_of(given.begin(), given.end(), [&](std::uint32_t i) { return i >= used.size(); })) continue;
      std::vector<int> face;
      for (const std::uint32_t i : given) face.push_back(first + static_cast<int>(i)), used[i] = true;
      faces.push_back(std::move(face));
    }
    std::vector<int> places = solid(faces, true);
    for (std::size_t i = 0; i < used.size(); ++i) {
      if (!used[i]) item(SpaceItem::Kind::dot, {first + static_cast<int>(i), dot_of_end});
    }
    dot_if_small(first, last);
    if (places.empty()) places.push_back(first);
    label(figure, places);
  }

  void measure_reach() {
    double farthest = 0;
    const auto offer = [&](const SpacePoint& p, double radius) {
      const double x = p.x, y = p.y, z = p.z;
      farthest = std::max(farthest, std::sqrt(x * x + y * y + z * z) + radius);
    };
    for (const SpacePoint& p : model_.points) offer(p, 0);
    for (const SpaceItem& item : model_.items) {
      if (item.kind == SpaceItem::Kind::ball) offer(point(item.numbers[0]), item.numbers[1]);
    }
    if (farthest > 0) model_.reach = static_cast<int>(std::ceil(farthest));
  }

  SpaceModel model_;
  std::map<std::string, std::size_t> size_of_list_;
  std::string style_;
  int faces_ = 0;
};

}  // namespace

SpaceModel space_model(const Drawing& scene) {
  std::vector<SpaceFigure> figures;
  for (const SpaceFigure& figure : scene.space) {
    if (drawable(figure)) figures.push_back(figure);
  }
  if (figures.empty()) return {};
  return Builder(figures).model();
}

}  // namespace touchstone::audit
