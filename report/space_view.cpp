// SPDX-License-Identifier: Apache-2.0
#include "report/space_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/labels.h"

namespace touchstone::audit {
namespace {

constexpr double quarter = 0.5522847498;  // of a circle as a Bezier curve
constexpr double head_length = 10, ring_radius = 9, text_spacing = 5, nearer = 0.5;
constexpr double tripod_x = 30, tripod_up = 30, tripod_length = 20;

/// In pixels; depth grows towards the reader.
struct Seen {
  double x, y, depth;
};

/// To the nearest tenth of a pixel, written from an integer.
std::string tenths(double value) {
  const auto n = static_cast<long long>(std::floor(10 * value + 0.5));
  const long long size = n < 0 ? -n : n;
  const std::string text = (n < 0 ? "-" : "") + std::to_string(size / 10);
  return size % 10 == 0 ? text : text + "." + std::to_string(size % 10);
}

std::string pair(double x, double y) { return tenths(x) + " " + tenths(y); }

class View {
 public:
  View(const SpaceModel& model, const Turn& turn)
      : model_(model),
        cos_yaw_(static_cast<double>(turn.cos_yaw) / turn.yaw_over),
        sin_yaw_(static_cast<double>(turn.sin_yaw) / turn.yaw_over),
        cos_pitch_(static_cast<double>(turn.cos_pitch) / turn.pitch_over),
        sin_pitch_(static_cast<double>(turn.sin_pitch) / turn.pitch_over),
        scale_(space_frame.room / model.reach) {
    for (const SpacePoint& p : model.points) {
      const Seen way = direction(p.x, p.y, p.z);
      seen_.push_back({space_frame.frame.width / 2 + way.x * scale_, space_frame.frame.height / 2 - way.y * scale_,
                       way.depth * scale_});
    }
  }

  std::string svg() {
    see_faces();
    for (const SpaceItem& item : model_.items) draw(item);
    std::stable_sort(strokes_.begin(), strokes_.end(),
                     [](const Stroke& a, const Stroke& b) { return a.depth < b.depth; });
    std::string text = tripod();
    for (const Stroke& stroke : strokes_) text += stroke.svg;
    return text + placed_labels(wishes(), drawn_, space_frame.frame);
  }

 private:
  struct Stroke {
    double depth;
    std::string svg;
  };
  struct FaceSeen {
    double depth;
    bool away;
  };

  /// To the right, up, towards the reader.
  Seen direction(double x, double y, double z) const {
    const double right = cos_yaw_ * x - sin_yaw_ * z, forth = sin_yaw_ * x + cos_yaw_ * z;
    return {right, cos_pitch_ * y - sin_pitch_ * forth, sin_pitch_ * y + cos_pitch_ * forth};
  }
  const Seen& seen(int i) const { return seen_[static_cast<std::size_t>(i)]; }

  void see_faces() {
    for (const SpaceItem& item : model_.items) {
      if (item.kind != SpaceItem::Kind::face) continue;
      double area = 0, depth = 0;
      for (std::size_t i = 0; i < item.numbers.size(); ++i) {
        const Seen &p = seen(item.numbers[i]), &q = seen(item.numbers[(i + 1) % item.numbers.size()]);
        area += p.x * q.y - q.x * p.y;
        depth += p.depth;
      }
      // Pixels go downwards: what is counter-clockwise to the reader has a negative area.
      faces_.push_back({depth / static_cast<double>(item.numbers.size()), area > 0});
    }
  }

  void add(double depth, std::string svg) { strokes_.push_back({depth, std::move(svg)}); }

  void mark_line(const Seen& a, const Seen& b) {
    const double dx = b.x - a.x, dy = b.y - a.y;
    const double steps = std::floor(std::sqrt(dx * dx + dy * dy) / text_spacing) + 1;
    for (double i = 0; i <= steps; ++i) drawn_.push_back({a.x + i / steps * dx, a.y + i / steps * dy});
  }
  void mark_round(const Seen& p, double radius) {
    for (const double dy : {-1.0, 0.0, 1.0}) {
      for (const double dx : {-1.0, 0.0, 1.0}) drawn_.push_back({p.x + radius * dx, p.y + radius * dy});
    }
  }

  void draw(const SpaceItem& item) {
    switch (item.kind) {
      case SpaceItem::Kind::face: return face(item);
      case SpaceItem::Kind::edge: return edge(item);
      case SpaceItem::Kind::arrow: return arrow(item);
      case SpaceItem::Kind::ball: return ball(item);
      case SpaceItem::Kind::dot: return dot(item, item.numbers[1] / 10.0, "dot");
      case SpaceItem::Kind::ring: return dot(item, ring_radius, "ring");
    }
  }

  void face(const SpaceItem& item) {
    std::string course;
    for (const int i : item.numbers) course += (course.empty() ? "M" : "L") + pair(seen(i).x, seen(i).y);
    add(faces_[next_face_++].depth, fmt::format("<path class=\"{} face\" d=\"{}Z\"/>", item.style, course));
  }

  void line(const Seen& a, const Seen& b, double depth, const std::string& style) {
    mark_line(a, b);
    add(depth, fmt::format("<path class=\"{}\" d=\"M{}L{}\"/>", style, pair(a.x, a.y), pair(b.x, b.y)));
  }

  void edge(const SpaceItem& item) {
    const Seen &a = seen(item.numbers[0]), &b = seen(item.numbers[1]);
    bool hidden = item.numbers.size() > 2;
    double nearest = (a.depth + b.depth) / 2;
    for (std::size_t i = 2; i < item.numbers.size(); ++i) {
      const FaceSeen& face = faces_[static_cast<std::size_t>(item.numbers[i])];
      hidden = hidden && face.away;
      nearest = std::max(nearest, face.depth);
    }
    // What is seen lies above its own faces.
    line(a, b, hidden ? (a.depth + b.depth) / 2 : nearest, item.style + (hidden ? " stroke hid" : " stroke"));
  }

  void arrow(const SpaceItem& item) {
    const Seen &a = seen(item.numbers[0]), &b = seen(item.numbers[1]);
    const double depth = (a.depth + b.depth) / 2, dx = b.x - a.x, dy = b.y - a.y, length = std::sqrt(dx * dx + dy * dy);
    line(a, b, depth, item.style + " stroke");
    if (length < 4) return;
    const double back = std::min(head_length, length), ux = back * dx / length, uy = back * dy / length;
    add(depth,
        fmt::format("<path class=\"{} head\" d=\"M{}L{}L{}Z\"/>", item.style, pair(b.x, b.y),
                    pair(b.x - ux - 0.4 * uy, b.y - uy + 0.4 * ux), pair(b.x - ux + 0.4 * uy, b.y - uy - 0.4 * ux)));
  }

  /// Its outline, the equator and the meridians across x and z; the half behind of each lighter.
  void ball(const SpaceItem& item) {
    const Seen& c = seen(item.numbers[0]);
    const double r = item.numbers[1] * scale_;
    std::string behind, before;
    for (const Seen& axis : {direction(1, 0, 0), direction(0, 1, 0), direction(0, 0, 1)}) {
      const double length = std::sqrt(axis.x * axis.x + axis.y * axis.y);
      if (length < 1e-6) continue;
      // From the outline at u over the nearest point f to -u; in pixels, y downwards.
      const double ux = r * axis.y / length, uy = r * axis.x / length;
      const double fx = -r * axis.depth * axis.x / length, fy = r * axis.depth * axis.y / length;
      behind += half(c, ux, uy, -fx, -fy);
      before += half(c, ux, uy, fx, fy);
    }
    const std::string round = fmt::format("cx=\"{}\" cy=\"{}\" r=\"{}\"/>", tenths(c.x), tenths(c.y), tenths(r));
    add(c.depth - r, fmt::format("<path class=\"{} stroke hid thin\" d=\"{}\"/>", item.style, behind));
    add(c.depth, fmt::format("<circle class=\"{0} face\" {1}<circle class=\"{0} stroke\" {1}", item.style, round));
    add(c.depth + nearer, fmt::format("<path class=\"{} stroke thin\" d=\"{}\"/>", item.style, before));
    for (const auto& [x, y] : diagonals) {
      for (const double part : {0.92, 1.0, 1.08}) drawn_.push_back({c.x + part * r * x, c.y + part * r * y});
    }
  }

  static std::string half(const Seen& c, double ux, double uy, double fx, double fy) {
    const double k = quarter;
    return "M" + pair(c.x + ux, c.y + uy) + "C" + pair(c.x + ux + k * fx, c.y + uy + k * fy) + " " +
           pair(c.x + fx + k * ux, c.y + fy + k * uy) + " " + pair(c.x + fx, c.y + fy) + "S" +
           pair(c.x - ux + k * fx, c.y - uy + k * fy) + " " + pair(c.x - ux, c.y - uy);
  }

  void dot(const SpaceItem& item, double radius, const char* kind) {
    const Seen& p = seen(item.numbers[0]);
    mark_round(p, radius);
    add(p.depth + nearer, fmt::format("<circle class=\"{} {}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>", item.style, kind,
                                      tenths(p.x), tenths(p.y), tenths(radius)));
  }

  std::vector<LabelWish> wishes() const {
    std::vector<LabelWish> wishes;
    for (const SpaceLabel& label : model_.labels) {
      LabelWish wish{{}, label.text, label.style};
      const Seen& c = seen(label.places[0]);
      for (const auto& [x, y] : diagonals) {
        const double r = label.radius * scale_;
        if (label.radius > 0) wish.places.push_back({c.x + r * x, c.y + r * y});
      }
      for (const int place : label.places) wish.places.push_back({seen(place).x, seen(place).y});
      wishes.push_back(std::move(wish));
    }
    return wishes;
  }

  /// Which way the axes point, in the lower left corner.
  std::string tripod() const {
    const Seen axes[] = {direction(1, 0, 0), direction(0, 1, 0), direction(0, 0, 1)};
    const double x = tripod_x, y = space_frame.frame.height - tripod_up;
    std::string text;
    for (std::size_t i = 0; i < 3; ++i) {
      const double dx = tripod_length * axes[i].x, dy = -tripod_length * axes[i].y;
      text += fmt::format(
          "<path class=\"tick\" d=\"M{}L{}\"/><text class=\"scale\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
          pair(x, y), pair(x + dx, y + dy), tenths(x + 1.4 * dx), tenths(y + 1.4 * dy + 4), "xyz"[i]);
    }
    return text;
  }

  static constexpr double diagonal = 0.7071067811865476;
  static constexpr Pixel diagonals[] = {
      {diagonal, -diagonal}, {-diagonal, -diagonal}, {diagonal, diagonal}, {-diagonal, diagonal}};

  const SpaceModel& model_;
  double cos_yaw_, sin_yaw_, cos_pitch_, sin_pitch_, scale_;
  std::vector<Seen> seen_;
  std::vector<FaceSeen> faces_;
  std::size_t next_face_ = 0;
  std::vector<Stroke> strokes_;
  std::vector<Pixel> drawn_;
};

std::string joined(const std::vector<int>& numbers) {
  std::string text;
  for (const int n : numbers) text += (text.empty() ? "" : " ") + std::to_string(n);
  return text;
}

}  // namespace

std::string turned(const SpaceModel& model, const Turn& turn) { return View(model, turn).svg(); }

std::string model_data(const SpaceModel& model, const Turn& turn) {
  constexpr char letters[] = {'f', 'e', 'a', 'b', 'd', 'r'};
  std::string text = fmt::format("v {} {} {} {} {} {} {} {} {} {}", space_frame.frame.width, space_frame.frame.height,
                                 space_frame.room, model.reach, turn.cos_yaw, turn.sin_yaw, turn.yaw_over,
                                 turn.cos_pitch, turn.sin_pitch, turn.pitch_over);
  for (const SpacePoint& p : model.points) text += fmt::format(";p {} {} {}", p.x, p.y, p.z);
  for (const SpaceItem& item : model.items) {
    text += fmt::format(";{} {} {}", letters[static_cast<std::size_t>(item.kind)], item.style, joined(item.numbers));
  }
  for (const SpaceLabel& label : model.labels) {
    std::string words = label.text;
    std::replace(words.begin(), words.end(), ';', ',');
    text += fmt::format(";t {} {} {} {}", label.style, label.radius, label.places.size(), joined(label.places));
    text += " " + words;
  }
  return text;
}

}  // namespace touchstone::audit
