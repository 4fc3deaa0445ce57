// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "paint.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

namespace gestalt::synthesis {

namespace {

constexpr double print_texel = 0.0012;

struct Hsv {
  double hue, saturation, value;  // 0-1
};

cv::Vec3b from_hsv(const Hsv& colour) {
  const double sector = 6 * (colour.hue - std::floor(colour.hue));
  const auto channel = [&](double offset) {
    const double k = std::fmod(offset + sector, 6.0);
    const double dip = std::clamp(std::min(k, 4 - k), 0.0, 1.0);
    return cv::saturate_cast<uchar>(255 * colour.value * (1 - colour.saturation * dip));
  };
  return {channel(1), channel(3), channel(5)};
}

cv::Vec3b random_colour(Random& random) {
  const double kind = random.uniform();
  if (kind < 0.2) return from_hsv({random.uniform(), random.uniform(0, 0.08), random.uniform(0.75, 0.95)});  // white
  if (kind < 0.28) return from_hsv({random.uniform(), random.uniform(0, 0.1), random.uniform(0.2, 0.6)});    // grey
  if (kind < 0.4) return from_hsv({random.uniform(0.06, 0.1), random.uniform(0.3, 0.5), random.uniform(0.5, 0.75)});
  return from_hsv({random.uniform(), random.uniform(0.45, 0.9), random.uniform(0.35, 0.95)});
}

cv::Vec3b shifted(const cv::Vec3b& colour, double amount, Random& random) {
  cv::Vec3b result;
  for (int c = 0; c < 3; ++c) result[c] = cv::saturate_cast<uchar>(colour[c] + random.uniform(-amount, amount));
  return result;
}

cv::Vec3b mixed(const cv::Vec3b& a, const cv::Vec3b& b, double share) {
  cv::Vec3b result;
  for (int c = 0; c < 3; ++c) result[c] = cv::saturate_cast<uchar>((1 - share) * a[c] + share * b[c]);
  return result;
}

Texture blank(double width, double height, double texel, const cv::Vec3b& colour) {
  const auto texels = [&](double length) { return std::max(4, int(std::lround(length / texel))); };
  return {cv::Mat_<cv::Vec3b>(texels(height), texels(width), colour), texel};
}

std::string word(Random& random, int letters) {
  static const std::string syllables[] = {"ba", "co",  "di", "fru", "ga", "ko",  "li",  "mel", "no", "pa", "ri", "so",
                                          "ta", "ves", "za", "tin", "mu", "cho", "sal", "ker", "X",  "-",  "99", "o"};
  std::string text;
  while (int(text.size()) < letters) text += random.pick(syllables);
  if (random.chance(0.5))
    for (char& letter : text)
      if (letter >= 'a' && letter <= 'z') letter = char(letter - 'a' + 'A');
  return text;
}

void write_title(cv::Mat& image, const cv::Vec3b& ink, Random& random) {
  static const int faces[] = {cv::FONT_HERSHEY_DUPLEX, cv::FONT_HERSHEY_TRIPLEX, cv::FONT_HERSHEY_SIMPLEX,
                              cv::FONT_HERSHEY_COMPLEX | cv::FONT_ITALIC};
  const std::string text = word(random, random.integer(3, 8));
  const int face = random.pick(faces), thickness = random.integer(2, 4);
  int base = 0;
  const cv::Size size = cv::getTextSize(text, face, 1, thickness, &base);
  const double scale = std::min(random.uniform(0.6, 0.95) * image.cols / size.width, 0.45 * image.rows / size.height);
  const int x = int((image.cols - scale * size.width) * random.uniform(0.2, 0.8));
  const int y = int(scale * size.height + random.uniform(0.05, 0.8) * (image.rows - 1.3 * scale * size.height));
  cv::putText(image, text, {x, y}, face, scale, cv::Scalar(ink), std::max(1, int(std::lround(thickness * scale))),
              cv::LINE_AA);
}

void write_small_print(cv::Mat& image, cv::Rect area, const cv::Vec3b& ink, Random& random) {
  const int pitch = random.integer(4, 6);
  for (int y = area.y; y + pitch / 2 <= area.y + area.height; y += pitch)
    for (int x = area.x; x < area.x + area.width;) {
      const int length = std::min(random.integer(3, 12), area.x + area.width - x);
      cv::rectangle(image, cv::Rect(x, y, length, pitch / 2), cv::Scalar(ink), cv::FILLED);
      x += length + random.integer(1, 3);
    }
}

void paint_picture(cv::Mat& image, const Palette& palette, Random& random) {
  const cv::Point centre{int(image.cols * random.uniform(0.25, 0.75)), int(image.rows * random.uniform(0.3, 0.8))};
  const double reach = random.uniform(0.15, 0.4) * std::min(image.cols, image.rows);
  const int blobs = random.integer(4, 14);
  for (int i = 0; i < blobs; ++i) {
    const cv::Point at{centre.x + int(reach * random.normal()), centre.y + int(0.6 * reach * random.normal())};
    const cv::Size axes{1 + int(reach * random.uniform(0.15, 0.6)), 1 + int(reach * random.uniform(0.15, 0.5))};
    const cv::Vec3b colour = shifted(
        random.chance(0.5) ? palette.accent : mixed(palette.band, palette.ground, random.uniform()), 50, random);
    cv::ellipse(image, at, axes, random.uniform(0, 180), 0, 360, cv::Scalar(colour), cv::FILLED, cv::LINE_AA);
  }
}

/// Smooth noise with mean 0 and a range of about 1, its lumps width x height pixels.
cv::Mat_<float> lumps(cv::Size size, double width, double height, Random& random) {
  cv::Mat_<float> seeds(std::max(2, int(size.height / height)) + 1, std::max(2, int(size.width / width)) + 1);
  for (float& seed : seeds) seed = random.normal() * 0.5f;
  cv::Mat_<float> noise;
  cv::resize(seeds, noise, size, 0, 0, cv::INTER_CUBIC);
  return noise;
}

}  // namespace

cv::Vec3f Texture::sample(const Eigen::Vector2f& at) const {
  if (image.total() == 1) return image(0, 0);
  const float x = at.x() / float(texel) - 0.5f, y = at.y() / float(texel) - 0.5f;
  const float left = std::floor(x), top = std::floor(y);
  const auto wrap = [](int i, int size) { return (i % size + size) % size; };
  const int x0 = wrap(int(left), image.cols), x1 = wrap(int(left) + 1, image.cols);
  const int y0 = wrap(int(top), image.rows), y1 = wrap(int(top) + 1, image.rows);
  const float s = x - left, t = y - top;
  const auto row = [&](int r) { return cv::Vec3f(image(r, x0)) * (1 - s) + cv::Vec3f(image(r, x1)) * s; };
  return row(y0) * (1 - t) + row(y1) * t;
}

Palette random_palette(Random& random) {
  Palette palette{random_colour(random), random_colour(random), random_colour(random), {}};
  const int brightness = palette.ground[0] + palette.ground[1] + palette.ground[2];
  palette.ink = brightness > 380 ? shifted({40, 35, 35}, 30, random) : shifted({220, 225, 225}, 30, random);
  return palette;
}

Palette similar_palette(const Palette& palette, Random& random) {
  const auto near = [&](const cv::Vec3b& colour) { return shifted(colour, 14, random); };
  return {near(palette.ground), near(palette.band), near(palette.accent), near(palette.ink)};
}

Texture plain(const cv::Vec3b& colour) { return {cv::Mat_<cv::Vec3b>(1, 1, colour), 1}; }

Texture print(double width, double height, const Palette& palette, Random& random) {
  Texture texture = blank(width, height, print_texel, palette.ground);
  cv::Mat image = texture.image;
  struct Share {
    double x, y, width, height;  // of the image
  };
  const auto area = [&](const Share& share) {
    return cv::Rect(int(share.x * image.cols), int(share.y * image.rows), std::max(1, int(share.width * image.cols)),
                    std::max(1, int(share.height * image.rows)));
  };
  if (random.chance(0.3)) {  // fading from the ground to the band's colour
    for (int y = 0; y < image.rows; ++y)
      image.row(y).setTo(mixed(palette.ground, palette.band, double(y) / image.rows));
  } else if (random.chance(0.7)) {
    const double thickness = random.uniform(0.12, 0.45);
    const double start = random.chance(0.5) ? 0 : random.uniform(0, 1 - thickness);
    cv::rectangle(image, random.chance(0.75) ? area({0, start, 1, thickness}) : area({start, 0, thickness, 1}),
                  cv::Scalar(palette.band), cv::FILLED);
  }
  for (int i = random.integer(0, 2); i > 0; --i) {
    const cv::Rect block =
        area({random.uniform(0, 0.7), random.uniform(0, 0.8), random.uniform(0.1, 0.4), random.uniform(0.06, 0.3)});
    const cv::Vec3b colour = random.chance(0.5) ? palette.accent : shifted(palette.band, 60, random);
    cv::rectangle(image, block, cv::Scalar(colour), cv::FILLED);
  }
  if (random.chance(0.75)) paint_picture(image, palette, random);
  if (random.chance(0.9)) write_title(image, random.chance(0.6) ? palette.ink : palette.accent, random);
  if (random.chance(0.6))
    write_small_print(image,
                      area({random.uniform(0.05, 0.5), random.uniform(0.1, 0.6), random.uniform(0.25, 0.45),
                            random.uniform(0.12, 0.35)}),
                      palette.ink, random);
  return texture;
}

Texture glaze(double width, double height, const Palette& palette, Random& random) {
  Texture texture = blank(width, height, 0.002, palette.ground);
  if (random.chance(0.3)) {
    const int bands = random.integer(1, 3);
    for (int i = 0; i < bands; ++i) {
      const int top = int(random.uniform(0, 0.9) * texture.image.rows);
      const int bottom = std::min(texture.image.rows, top + 1 + random.integer(1, 6));
      texture.image.rowRange(top, bottom).setTo(palette.accent);
    }
  }
  const double strength = random.uniform(0, 16);
  const cv::Mat_<float> noise = lumps(texture.image.size(), 8, 8, random);
  for (int y = 0; y < texture.image.rows; ++y)
    for (int x = 0; x < texture.image.cols; ++x)
      for (int c = 0; c < 3; ++c)
        texture.image(y, x)[c] = cv::saturate_cast<uchar>(texture.image(y, x)[c] + strength * noise(y, x));
  return texture;
}

Texture wood(double width, double height, Random& random) {
  static const cv::Vec3b tops[] = {{150, 178, 205}, {120, 155, 190}, {190, 195, 200}, {205, 208, 210},
                                   {90, 115, 150},  {150, 160, 165}, {70, 85, 110},   {160, 190, 215}};
  Texture texture = blank(width, height, 0.004, shifted(random.pick(tops), 12, random));
  const double strength = random.uniform(1, 12);
  const cv::Mat_<float> grain = lumps(texture.image.size(), 60, 1.5, random);
  const cv::Mat_<float> cloud = lumps(texture.image.size(), 70, 25, random);
  for (int y = 0; y < texture.image.rows; ++y)
    for (int x = 0; x < texture.image.cols; ++x)
      for (int c = 0; c < 3; ++c)
        texture.image(y, x)[c] =
            cv::saturate_cast<uchar>(texture.image(y, x)[c] + strength * grain(y, x) + 5 * cloud(y, x));
  return texture;
}

Texture room(double width, double height, Random& random) {
  const double bright = random.uniform(60, 190);
  Texture texture = blank(width, height, 0.01, shifted(cv::Vec3b::all(uchar(bright)), 20, random));
  for (int i = random.integer(3, 9); i > 0; --i) {
    const cv::Point corner{int(random.uniform(-0.2, 1) * texture.image.cols),
                           int(random.uniform(-0.2, 1) * texture.image.rows)};
    const cv::Size size{int(random.uniform(0.03, 0.3) * texture.image.cols),
                        int(random.uniform(0.03, 0.3) * texture.image.rows)};
    const cv::Vec3b grey = cv::Vec3b::all(uchar(random.uniform(20, 200)));
    cv::rectangle(texture.image, cv::Rect(corner, size), cv::Scalar(shifted(grey, 25, random)), cv::FILLED);
  }
  cv::GaussianBlur(texture.image, texture.image, {}, 2);
  return texture;
}

}  // namespace gestalt::synthesis
