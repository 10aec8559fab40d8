#include "transformation.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <stdexcept>

namespace perinox::invariance {

namespace {

/// Places of xx, xy ... in the list of six.
constexpr std::size_t place_of[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

}  // namespace

std::string digits(double value) { return fmt::format("{:.17g}", value); }

std::array<double, 6> Transformation::tensor(const double* s) const {
  std::array<double, 6> out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < 3; ++l) out[place_of[i][j]] += turn[i][k] * turn[j][l] * s[place_of[k][l]];
  return out;
}

bool Transformation::along_axes() const {
  for (const Vector3& row : turn)
    for (const double entry : row)
      if (entry != 0 && std::abs(entry) != 1) return false;
  return true;
}

std::size_t Transformation::axis(std::size_t old) const {
  for (std::size_t i = 0; i < 3; ++i)
    if (turn[i][old] != 0) return i;
  throw std::logic_error("the transformation loses an axis");
}

bool Transformation::moves_places() const { return length != 1 || shift != Vector3{} || turn != Transformation{}.turn; }

std::string Transformation::formula(const std::string& text) const {
  if (!moves_places()) return text;
  const auto old = [&](std::size_t k) {
    std::string sum;
    for (std::size_t i = 0; i < 3; ++i)
      if (turn[i][k] != 0)
        sum += fmt::format("{}({})*({}-({}))", sum.empty() ? "" : "+", digits(turn[i][k]), "xyz"[i], digits(shift[i]));
    return fmt::format("(({})/{})", sum, digits(length));
  };
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const auto part_of_name = [&](std::size_t k) {
      return std::isalnum(static_cast<unsigned char>(text[k])) || text[k] == '_' || text[k] == '.';
    };
    std::size_t end = at;
    while (end < text.size() && part_of_name(end)) ++end;
    const std::string word = text.substr(at, std::max<std::size_t>(end - at, 1));
    const bool coordinate = word == "x" || word == "y" || word == "z";
    out += coordinate ? old(static_cast<std::size_t>(word[0] - 'x')) : word;
    at += word.size();
  }
  return out;
}

double Transformation::factor(const std::string& unit, int dimension) const {
  const std::map<std::string, double> factors{
      {"", 1},
      {"-", 1},
      {"dimensionless", 1},
      {"length", length},
      {"stress", stress},
      {"force", stress * std::pow(length, dimension - 1)},
      {"force/volume", stress / length},
      {"energy/area", stress * length},
      {"energy/volume^2", stress / std::pow(length, dimension)},
      {"mass/volume", stress / (length * length)},
      {"velocity", length},
      {"time", 1},
      {"1/time", 1},
      {"seconds", 1},
  };
  const auto found = factors.find(unit);
  if (found == factors.end()) throw std::logic_error("a unit that the suite does not know: " + unit);
  return found->second;
}

std::array<Vector3, 3> rotation(const Vector3& axis, double angle) {
  const double size = std::sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
  const Vector3 n{axis[0] / size, axis[1] / size, axis[2] / size};
  const double c = std::cos(angle), s = std::sin(angle);
  const double cross[3][3] = {{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
  std::array<Vector3, 3> out{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) out[i][j] = (i == j ? c : 0) + s * cross[i][j] + (1 - c) * n[i] * n[j];
  return out;
}

}  // namespace perinox::invariance
