#include "host/bodies/panel_method.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/Dense>
#include <glm/geometric.hpp>

#include "host/base/parallel_for.h"
#include "host/bodies/panel_hull.h"
#include "host/bodies/wave_green_function.h"

namespace offing::bodies {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;
using Matrix = Eigen::MatrixXd;
using ComplexMatrix = Eigen::MatrixXcd;

constexpr std::size_t direction_count = 24;
constexpr double longest_wave = 60.0, shortest_wave = 0.6;  // of the hull's length

/// The integral of 1 / r over a panel and its gradient at a place, exact (Hess & Smith 1964; the solid angle
/// by van Oosterom & Strackee 1983). On the panel itself: the mean of both sides.
struct Rankine {
  double value = 0.0;
  glm::dvec3 gradient{0.0};
};
Rankine rankine(const Panel& panel, const glm::dvec3& place, bool is_self, double flip) {
  // flip -1: the image of the panel in y = 0.
  std::array<glm::dvec3, 4> to{};
  std::array<double, 4> distance{};
  const std::size_t n = panel.corner_count;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3& corner = panel.corners_m[flip > 0.0 ? i : n - 1 - i];
    to[i] = glm::dvec3(corner.x, flip * corner.y, corner.z) - place;
    distance[i] = glm::length(to[i]);
  }
  // An image turns round as its corners are reversed.
  const glm::dvec3 normal(panel.normal.x, flip * panel.normal.y, panel.normal.z);
  Rankine result;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const glm::dvec3 edge = to[j] - to[i];
    const double length = glm::length(edge);
    // A quadrangle at a tip of the cover has but three corners.
    if (!(length > 0.0)) continue;
    const glm::dvec3 outward = glm::cross(edge / length, normal);
    const double sum = distance[i] + distance[j];
    const double log = std::log((sum + length) / std::max(sum - length, 1e-14 * sum));
    result.value += glm::dot(to[i], outward) * log;
    result.gradient -= outward * log;
  }
  if (is_self) return result;
  double angle = 0.0;
  for (std::size_t i = 2; i < n; ++i) {
    const glm::dvec3 &a = to[0], &b = to[i - 1], &c = to[i];
    const double la = distance[0], lb = distance[i - 1], lc = distance[i];
    const double det = glm::dot(a, glm::cross(b, c));
    const double rest = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
    angle -= 2.0 * std::atan2(det, rest);
  }
  // Positive on the side of the normal.
  const double height = -glm::dot(to[0], normal);
  result.value -= height * angle;
  result.gradient -= normal * angle;
  return result;
}

/// Influence of sources of strength 1 on panels at the images of the centres of all: 1 / r and 1 / r' with
/// their derivatives along the normal there.
struct Statics {
  Matrix direct, image, direct_n, image_n;
};
Statics statics_of(const PanelHull& hull, const glm::dvec3& image) {
  const std::vector<Panel>& panels = hull.panels;
  const auto n = static_cast<Eigen::Index>(panels.size());
  Statics s{Matrix(n, n), Matrix(n, n), Matrix(n, n), Matrix(n, n)};
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i < n; ++i) {
      const Panel &from = panels[static_cast<std::size_t>(j)], &at = panels[static_cast<std::size_t>(i)];
      const glm::dvec3 place = image * at.centre_m, normal = image * at.normal;
      const bool is_self = i == j && image == glm::dvec3(1.0);
      const Rankine direct = rankine(from, place, is_self, 1.0), above = rankine(from, place, false, -1.0);
      s.direct(i, j) = direct.value;
      s.image(i, j) = above.value;
      s.direct_n(i, j) = glm::dot(direct.gradient, normal);
      s.image_n(i, j) = glm::dot(above.gradient, normal);
    }
  }
  return s;
}

/// The part of waves of the potential at a place and its derivative along a normal there, of a source of
/// strength 1 at a point. image: 1 / r' is left to the panel.
struct Wave {
  Complex value, normal;
};
Wave waves_of(const WavePart& part, double nu, const glm::dvec3& normal, double along) {
  const Complex value = nu * Complex(part.f, 2.0 * pi * part.decay_j0);
  const Complex outward = nu * nu * Complex(part.f_x, -2.0 * pi * part.decay_j1);
  return {value, outward * along + nu * normal.y * value};
}

/// Points of equal shares of a panel, to integrate over it close by: halved `times` times along its edges.
void share_out(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, int times,
               std::vector<glm::dvec3>& points) {
  if (times == 0) {
    points.push_back((a + b + c) / 3.0);
    return;
  }
  const glm::dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
  share_out(a, ab, ca, times - 1, points);
  share_out(ab, b, bc, times - 1, points);
  share_out(ca, bc, c, times - 1, points);
  share_out(ab, bc, ca, times - 1, points);
}
std::vector<glm::dvec3> points_of(const Panel& panel, int times) {
  std::vector<glm::dvec3> points;
  const auto& c = panel.corners_m;
  share_out(c[0], c[1], c[2], times, points);
  if (panel.corner_count == 4) share_out(c[0], c[2], c[3], times, points);
  return points;
}

struct Influence {
  ComplexMatrix value, normal;
};

/// Adds the waves of all panels to `influence` at one frequency.
Influence waves_at(const PanelHull& hull, const Statics& statics, double nu, const glm::dvec3& image) {
  const std::vector<Panel>& panels = hull.panels;
  const auto n = static_cast<Eigen::Index>(panels.size());
  Influence influence{ComplexMatrix(n, n), ComplexMatrix(n, n)};
  const auto one = [&](const glm::dvec3& place, const glm::dvec3& normal, const glm::dvec3& source) {
    const double dx = place.x - source.x, dz = place.z - source.z, r = std::sqrt(dx * dx + dz * dz);
    const double along = r > 0.0 ? (normal.x * dx + normal.z * dz) / r : 0.0;
    return waves_of(wave_part(nu * r, -nu * (place.y + source.y)), nu, normal, along);
  };
  const auto set = [&](Eigen::Index i, Eigen::Index j, double normal_y, const Wave& wave, double area) {
    influence.value(i, j) = area * wave.value;
    influence.normal(i, j) = area * wave.normal + 2.0 * nu * normal_y * statics.image(i, j);
  };
  for (Eigen::Index j = 0; j < n; ++j) {
    for (Eigen::Index i = 0; i <= j; ++i) {
      const Panel &a = panels[static_cast<std::size_t>(i)], &b = panels[static_cast<std::size_t>(j)];
      const glm::dvec3 a_place = image * a.centre_m, b_place = image * b.centre_m;
      const glm::dvec3 a_normal = image * a.normal, b_normal = image * b.normal;
      const double dx = a_place.x - b.centre_m.x, dz = a_place.z - b.centre_m.z;
      const double r2 = dx * dx + dz * dz, y = a.centre_m.y + b.centre_m.y;
      const double apart2 = r2 + y * y, size2 = std::max(a.area_m2, b.area_m2);
      if (apart2 < 4.0 * size2) {
        // Near the surface F is singular like a logarithm: integrated over the panel.
        const int times = apart2 < size2 ? 2 : 1;
        const auto integrate = [&](Eigen::Index to, Eigen::Index from) {
          const Panel &at = panels[static_cast<std::size_t>(to)],
                      &of = panels[static_cast<std::size_t>(from)];
          const glm::dvec3 place = image * at.centre_m, normal = image * at.normal;
          const std::vector<glm::dvec3> points = points_of(of, times);
          Wave sum{};
          for (const glm::dvec3& point : points) {
            const Wave wave = one(place, normal, point);
            sum.value += wave.value;
            sum.normal += wave.normal;
          }
          set(to, from, normal.y, sum, of.area_m2 / static_cast<double>(points.size()));
        };
        integrate(i, j);
        if (i != j) integrate(j, i);
        continue;
      }
      const double r = std::sqrt(r2), over_r = r > 0.0 ? 1.0 / r : 0.0;
      const WavePart part = wave_part(nu * r, -nu * y);
      set(i, j, a.normal.y, waves_of(part, nu, a_normal, (a_normal.x * dx + a_normal.z * dz) * over_r),
          b.area_m2);
      if (i == j) continue;
      const double back_dx = b_place.x - a.centre_m.x, back_dz = b_place.z - a.centre_m.z;
      set(j, i, b.normal.y,
          waves_of(part, nu, b_normal, (b_normal.x * back_dx + b_normal.z * back_dz) * over_r), a.area_m2);
    }
  }
  return influence;
}

/// One hull in its axes: what is even and odd across its planes of symmetry is solved apart.
class Solver {
 public:
  Solver(const TriangleMesh& mesh, double level_m, const glm::dvec3& about_m, double density, double gravity,
         const PanelOptions& options)
      : hull_(panel_hull(mesh, level_m, options.panels)),
        about_(about_m - hull_.origin_m),
        density_(density),
        gravity_(gravity),
        is_direct_(options.is_direct),
        parts_(hull_.images.size()) {
    for (const glm::dvec3& image : hull_.images) statics_.push_back(statics_of(hull_, image));
    normals_.assign(parts_, Matrix::Zero(all(), 6));
    for (Eigen::Index i = 0; i < wetted(); ++i) {
      const Panel& panel = hull_.panels[static_cast<std::size_t>(i)];
      for (std::size_t k = 0; k < parts_; ++k) {
        const glm::dvec3& image = hull_.images[k];
        const std::array<double, 6> moved = motions(image * panel.centre_m, image * panel.normal);
        for (std::size_t part = 0; part < parts_; ++part) {
          for (Eigen::Index m = 0; m < 6; ++m)
            normals_[part](i, m) += sign(part, k) / parts() * moved[static_cast<std::size_t>(m)];
        }
      }
    }
  }

  double length_m() const { return hull_.length_m; }

  HullMatrix at_infinity() const {
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    for (std::size_t part = 0; part < parts_; ++part) {
      Matrix value = Matrix::Zero(all(), all()), normal = value;
      for (std::size_t k = 0; k < parts_; ++k) {
        value += sign(part, k) * (statics_[k].direct - statics_[k].image);
        normal += sign(part, k) * (statics_[k].direct_n - statics_[k].image_n);
      }
      normal.diagonal().array() -= 2.0 * pi;
      const Matrix potentials = value * normal.partialPivLu().solve(normals_[part]);
      sum += density_ * weighted(part).transpose() * -potentials;
    }
    return symmetric(sum);
  }

  void solve(double frequency, const std::vector<double>& directions, HullMatrix& added_mass,
             HullMatrix& damping, HullWrench* excitation) const {
    const double nu = frequency * frequency / gravity_;
    const auto wave_count = static_cast<Eigen::Index>(directions.size());
    // The derivative of the incident potential along the normal, by parts, and the force of its
    // pressure, per direction. A rule of three points is exact where pressures are linear over a panel, as
    // those of long waves are: their moments hardly depend on the panels.
    std::vector<ComplexMatrix> incident_n(parts_, ComplexMatrix::Zero(all(), wave_count));
    Eigen::Matrix<Complex, 6, Eigen::Dynamic> forces =
        Eigen::Matrix<Complex, 6, Eigen::Dynamic>::Zero(6, wave_count);
    const Complex to_force(0.0, -frequency * density_);
    for (Eigen::Index b = 0; b < wave_count; ++b) {
      const double c = std::cos(directions[static_cast<std::size_t>(b)]);
      const double s = std::sin(directions[static_cast<std::size_t>(b)]);
      for (Eigen::Index i = 0; i < wetted(); ++i) {
        const Panel& panel = hull_.panels[static_cast<std::size_t>(i)];
        for (std::size_t k = 0; k < parts_; ++k) {
          const glm::dvec3& image = hull_.images[k];
          const glm::dvec3 normal = image * panel.normal;
          Complex mean = 0.0;
          for (std::size_t corner = 0; corner < 3; ++corner) {
            const glm::dvec3 place =
                image * 0.5 * (panel.corners_m[corner] + panel.corners_m[(corner + 1) % 3]);
            const double phase = nu * ((place.x - about_.x) * c + (place.z - about_.z) * s);
            const Complex value =
                Complex(0.0, -gravity_ / frequency) * std::polar(std::exp(nu * place.y) / 3.0, phase);
            mean += value;
            const std::array<double, 6> moved = motions(place, normal);
            for (Eigen::Index m = 0; m < 6; ++m)
              forces(m, b) += to_force * panel.area_m2 * moved[static_cast<std::size_t>(m)] * value;
          }
          const Complex slope = mean * nu * Complex(normal.y, normal.x * c + normal.z * s);
          for (std::size_t part = 0; part < parts_; ++part)
            incident_n[part](i, b) += sign(part, k) / parts() * slope;
        }
      }
    }
    std::vector<Influence> waves;
    for (std::size_t k = 0; k < parts_; ++k)
      waves.push_back(waves_at(hull_, statics_[k], nu, hull_.images[k]));
    Eigen::Matrix<Complex, 6, 6> sum = Eigen::Matrix<Complex, 6, 6>::Zero();
    for (std::size_t part = 0; part < parts_; ++part) {
      ComplexMatrix value = ComplexMatrix::Zero(all(), all()), normal = value;
      for (std::size_t k = 0; k < parts_; ++k) {
        const Statics& still = statics_[k];
        value += sign(part, k) * (waves[k].value + (still.direct + still.image).cast<Complex>());
        normal += sign(part, k) * (waves[k].normal + (still.direct_n + still.image_n).cast<Complex>());
      }
      normal.diagonal().array() -= 2.0 * pi;
      const Eigen::PartialPivLU<ComplexMatrix> inverse(normal);
      const Matrix weights = weighted(part);
      const ComplexMatrix potentials = value * inverse.solve(normals_[part].cast<Complex>());
      sum += weights.transpose() * potentials;
      if (is_direct_) {
        const ComplexMatrix diffracted = value * inverse.solve(-incident_n[part]);
        forces += to_force * (weights.transpose() * diffracted);
      } else {
        // Haskind 1957: the reciprocity of diffracted and radiated waves.
        const ComplexMatrix reach = areas().asDiagonal() * potentials;
        forces -= to_force * (reach.transpose() * incident_n[part]);
      }
    }
    added_mass = symmetric(-density_ * sum.real());
    if (is_direct_) {
      damping = symmetric(-density_ * frequency * sum.imag());
    } else {
      // The energy of the waves far away (Newman 1962): k omega / (4 pi rho g^2) integral of X X* over
      // direction.
      const double share = nu * frequency / (4.0 * pi * density_ * gravity_ * gravity_) * 2.0 * pi /
                           static_cast<double>(wave_count);
      damping = symmetric(share * (forces * forces.adjoint()).real());
    }
    for (Eigen::Index b = 0; b < wave_count; ++b) {
      for (Eigen::Index m = 0; m < 6; ++m) excitation[b][static_cast<std::size_t>(m)] = forces(m, b);
    }
  }

 private:
  Eigen::Index all() const { return static_cast<Eigen::Index>(hull_.panels.size()); }
  Eigen::Index wetted() const { return static_cast<Eigen::Index>(hull_.wetted_count); }

  double parts() const { return static_cast<double>(parts_); }
  /// Of a part at an image: both count the planes across which they are odd, or lie, in bits.
  static double sign(std::size_t part, std::size_t image) {
    return std::popcount(part & image) % 2 == 0 ? 1.0 : -1.0;
  }

  std::array<double, 6> motions(const glm::dvec3& place, const glm::dvec3& normal) const {
    const glm::dvec3 moment = glm::cross(place - about_, normal);
    return {normal.x, normal.y, normal.z, moment.x, moment.y, moment.z};
  }

  /// Areas of the hull's panels with their images, 0 on the cover.
  Eigen::VectorXd areas() const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(all());
    for (Eigen::Index i = 0; i < wetted(); ++i) {
      result[i] = parts() * hull_.panels[static_cast<std::size_t>(i)].area_m2;
    }
    return result;
  }
  Matrix weighted(std::size_t part) const { return areas().asDiagonal() * normals_[part]; }

  template <typename Sum>
  static HullMatrix symmetric(const Sum& sum) {
    HullMatrix result{};
    for (Eigen::Index i = 0; i < 6; ++i) {
      for (Eigen::Index j = 0; j < 6; ++j) {
        result[static_cast<std::size_t>(6 * i + j)] = 0.5 * (sum(i, j) + sum(j, i));
      }
    }
    return result;
  }

  PanelHull hull_;
  glm::dvec3 about_;
  double density_, gravity_;
  bool is_direct_;
  std::size_t parts_;             // of what is even or odd in each plane of symmetry: as many as images
  std::vector<Statics> statics_;  // [image]
  std::vector<Matrix> normals_;   // [part][panel][motion]
};

/// The place among rising values: the interval and, within it, 0 ... 1.
std::pair<std::size_t, double> place_in(const std::vector<double>& values, double at) {
  if (values.size() < 2 || at <= values.front()) return {0, 0.0};
  if (at >= values.back()) return {values.size() - 2, 1.0};
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(values, at) - values.begin());
  return {above - 1, (at - values[above - 1]) / (values[above] - values[above - 1])};
}

/// Calls add(index, weight) for the up to 4 frequencies of a cubic (Catmull & Rom 1974, for uneven places).
template <typename Add>
void weigh(const std::vector<double>& x, double at, const Add& add) {
  const auto place = place_in(x, at);
  const std::size_t i = place.first;
  const double u = place.second;
  if (x.size() == 1 || u == 0.0) return add(i, 1.0);
  if (u == 1.0) return add(i + 1, 1.0);
  const double h = x[i + 1] - x[i];
  const double h00 = (1 + 2 * u) * (1 - u) * (1 - u), h10 = u * (1 - u) * (1 - u), h01 = 1 - h00,
               h11 = u * u * (u - 1);
  add(i, h00);
  add(i + 1, h01);
  // Slopes from the parabola of three neighbours.
  const auto slope = [&](std::size_t k, double weight) {
    if (k == 0 || k + 1 == x.size()) {
      add(i, -weight / h);
      add(i + 1, weight / h);
      return;
    }
    const double a = x[k] - x[k - 1], b = x[k + 1] - x[k];
    add(k - 1, -weight * b / (a * (a + b)));
    add(k, weight * (b - a) / (a * b));
    add(k + 1, weight * a / (b * (a + b)));
  };
  slope(i, h10 * h);
  slope(i + 1, h11 * h);
}

HullMatrix matrix_at(const std::vector<double>& frequencies, const std::vector<HullMatrix>& matrices,
                     double at) {
  HullMatrix result{};
  weigh(frequencies, at, [&](std::size_t k, double weight) {
    for (std::size_t i = 0; i < result.size(); ++i) result[i] += weight * matrices[k][i];
  });
  return result;
}

using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
Eigen::Map<const Matrix6> as_matrix(const HullMatrix& matrix) {
  return Eigen::Map<const Matrix6>(matrix.data());
}

}  // namespace

HydrodynamicData panel_method(const TriangleMesh& hull, double level_m, const glm::dvec3& about_m,
                              double density_kgpm3, double gravity_mps2, const PanelOptions& options) {
  const Solver solver(hull, level_m, about_m, density_kgpm3, gravity_mps2, options);
  HydrodynamicData data;
  data.source = "panel method";
  data.about_m = about_m;
  data.water_level_m = level_m;
  data.density_kgpm3 = density_kgpm3;
  data.gravity_mps2 = gravity_mps2;
  for (std::size_t i = 0; i < direction_count; ++i) {
    data.directions_rad.push_back(2.0 * pi * static_cast<double>(i) / direction_count);
  }
  const std::size_t count = std::max<std::size_t>(options.frequencies, 2);
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double wave_m = solver.length_m() * longest_wave * std::pow(shortest_wave / longest_wave, share);
    data.frequencies_radps.push_back(std::sqrt(2.0 * pi * gravity_mps2 / wave_m));
  }
  data.added_mass.resize(count);
  data.damping.resize(count);
  data.excitation.resize(count * direction_count);
  data.added_mass_at_infinity = solver.at_infinity();
  parallel_rows(
      static_cast<int>(count),
      [&](int row) {
        const auto i = static_cast<std::size_t>(row);
        solver.solve(data.frequencies_radps[i], data.directions_rad, data.added_mass[i], data.damping[i],
                     &data.excitation[i * direction_count]);
      },
      options.threads);
  return data;
}

HullMatrix added_mass_at(const HydrodynamicData& data, double frequency_radps) {
  return matrix_at(data.frequencies_radps, data.added_mass, frequency_radps);
}

HullMatrix damping_at(const HydrodynamicData& data, double frequency_radps) {
  return matrix_at(data.frequencies_radps, data.damping, frequency_radps);
}

HullWrench excitation_at(const HydrodynamicData& data, double frequency_radps, double direction_rad) {
  const std::vector<double>& directions = data.directions_rad;
  // One turn more, so that the last interval closes where the data go around.
  std::vector<double> around = directions;
  std::vector<std::size_t> index(directions.size());
  for (std::size_t i = 0; i < index.size(); ++i) index[i] = i;
  const bool goes_around = directions.size() > 3 && directions.front() + 2.0 * pi - directions.back() < pi;
  double at = direction_rad - 2.0 * pi * std::floor((direction_rad - directions.front()) / (2.0 * pi));
  if (goes_around) {
    around.insert(around.begin(), directions.back() - 2.0 * pi);
    index.insert(index.begin(), directions.size() - 1);
    for (std::size_t i = 0; i < 2; ++i) {
      around.push_back(directions[i] + 2.0 * pi);
      index.push_back(i);
    }
  } else if (at - directions.back() > directions.front() + 2.0 * pi - at) {
    at = directions.front();  // the nearer end
  }
  HullWrench result{};
  weigh(data.frequencies_radps, frequency_radps, [&](std::size_t k, double weight) {
    weigh(around, at, [&](std::size_t b, double part) {
      const HullWrench& wrench = data.excitation[k * directions.size() + index[b]];
      for (std::size_t m = 0; m < hull_motions; ++m) result[m] += weight * part * wrench[m];
    });
  });
  return result;
}

std::vector<HullMatrix> retardation(const HydrodynamicData& data, double step_s, std::size_t count) {
  const double first = data.frequencies_radps.front(), last = data.frequencies_radps.back();
  // So fine that the largest t still has 8 samples a turn, and the data some between neighbours.
  const double most_t = step_s * static_cast<double>(count);
  const double step = std::min(last / 400.0, 2.0 * pi / (8.0 * most_t));
  const std::size_t samples = static_cast<std::size_t>(std::ceil(3.0 * last / step));
  const HullMatrix& low = data.damping.front();
  const HullMatrix& high = data.damping.back();
  HullMatrix power{};
  const HullMatrix before = damping_at(data, 0.85 * last);
  for (std::size_t i = 0; i < power.size(); ++i) {
    const double ratio = high[i] == 0.0 ? 0.0 : before[i] / high[i];
    power[i] = ratio > 0.0 ? std::clamp(std::log(ratio) / -std::log(0.85), 2.0, 8.0) : 8.0;
  }
  std::vector<HullMatrix> result(count, HullMatrix{});
  std::vector<double> cosines(count);
  for (std::size_t k = 1; k <= samples; ++k) {
    const double frequency = step * static_cast<double>(k);
    HullMatrix value{};
    if (frequency < first) {
      // Long waves lift a hull as they pass: X stays, so that B grows like omega^3.
      for (std::size_t i = 0; i < value.size(); ++i) value[i] = low[i] * std::pow(frequency / first, 3.0);
    } else if (frequency <= last) {
      value = damping_at(data, frequency);
    } else {
      for (std::size_t i = 0; i < value.size(); ++i)
        value[i] = high[i] * std::pow(last / frequency, power[i]);
    }
    // A half cosine leads B to 0 between 2 and 3 times the last frequency. At a step, B of the sampled memory
    // would ring below 0.
    const double beyond = std::max(frequency / last - 2.0, 0.0);
    const double weight = 2.0 / pi * step * (0.5 + 0.5 * std::cos(pi * beyond));
    for (double& entry : value) entry *= weight;
    // cos(n a) by its recurrence.
    const double a = frequency * step_s, twice = 2.0 * std::cos(a);
    double earlier = std::cos(a), now = 1.0;
    for (std::size_t n = 0; n < count; ++n) {
      for (std::size_t i = 0; i < value.size(); ++i) result[n][i] += now * value[i];
      const double next = twice * now - earlier;
      earlier = now;
      now = next;
    }
  }
  return result;
}

HullMatrix added_mass_by_damping(const HydrodynamicData& data) {
  const std::vector<double>& frequencies = data.frequencies_radps;
  // Waves die out within a few turns of the longest ones; beyond 3 times the highest frequency K has no part.
  const double step = 2.0 * pi / (24.0 * frequencies.back());
  const auto count =
      static_cast<std::size_t>(std::ceil(std::min(4.0 * pi / frequencies.front() / step, 4000.0)));
  const std::vector<HullMatrix> memory = retardation(data, step, count);
  HullMatrix result{};
  const std::size_t first = frequencies.size() / 2;
  for (std::size_t k = first; k < frequencies.size(); ++k) {
    HullMatrix value = data.added_mass[k];
    for (std::size_t n = 1; n < count; ++n) {
      const double weight = step * std::sin(frequencies[k] * step * static_cast<double>(n)) / frequencies[k];
      for (std::size_t i = 0; i < value.size(); ++i) value[i] += weight * memory[n][i];
    }
    for (std::size_t i = 0; i < value.size(); ++i)
      result[i] += value[i] / static_cast<double>(frequencies.size() - first);
  }
  return result;
}

HullMatrix restoring_matrix(const Submerged& below, const glm::dvec3& mass_centre_m,
                            const glm::dvec3& about_m, double density_kgpm3, double gravity_mps2) {
  const double weight = density_kgpm3 * gravity_mps2;
  const double x = below.plane_centre_m.x - about_m.x, z = below.plane_centre_m.z - about_m.z;
  const double arm = below.volume_m3 * (below.centre_m.y - mass_centre_m.y);
  HullMatrix c{};
  // A turn d about an axis lifts a place by (d x r)_y = d_z x - d_x z.
  c[1 * 6 + 1] = weight * below.plane_m2;
  c[1 * 6 + 3] = c[3 * 6 + 1] = -weight * below.plane_m2 * z;
  c[1 * 6 + 5] = c[5 * 6 + 1] = weight * below.plane_m2 * x;
  c[3 * 6 + 5] = c[5 * 6 + 3] = -weight * below.plane_m2 * x * z;
  c[3 * 6 + 3] = weight * (below.plane_zz_m4 + below.plane_m2 * z * z + arm);
  c[5 * 6 + 5] = weight * (below.plane_xx_m4 + below.plane_m2 * x * x + arm);
  return c;
}

HullMatrix mass_matrix(double body_kg, const std::array<double, 9>& inertia_kgm2,
                       const glm::dvec3& mass_centre_m, const glm::dvec3& about_m) {
  const glm::dvec3 r = mass_centre_m - about_m;
  Eigen::Matrix3d cross;  // cross * v = r x v
  cross << 0, -r.z, r.y, r.z, 0, -r.x, -r.y, r.x, 0;
  Matrix6 mass = Matrix6::Zero();
  mass.topLeftCorner<3, 3>().diagonal().setConstant(body_kg);
  mass.topRightCorner<3, 3>() = -body_kg * cross;
  mass.bottomLeftCorner<3, 3>() = body_kg * cross;
  mass.bottomRightCorner<3, 3>() =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(inertia_kgm2.data()) -
      body_kg * cross * cross;
  HullMatrix result;
  Eigen::Map<Matrix6>(result.data()) = mass;
  return result;
}

HullWrench linear_response(const HydrodynamicData& data, const HullMatrix& mass, const HullMatrix& restoring,
                           double frequency_radps, double direction_rad) {
  const HullMatrix a = added_mass_at(data, frequency_radps), b = damping_at(data, frequency_radps);
  const HullWrench x = excitation_at(data, frequency_radps, direction_rad);
  const double w = frequency_radps;
  const Eigen::Matrix<Complex, 6, 6> left =
      (as_matrix(restoring) - w * w * (as_matrix(mass) + as_matrix(a))).cast<Complex>() -
      Complex(0.0, w) * as_matrix(b).cast<Complex>();
  const Eigen::Matrix<Complex, 6, 1> motion =
      left.partialPivLu().solve(Eigen::Map<const Eigen::Matrix<Complex, 6, 1>>(x.data()));
  HullWrench result;
  std::ranges::copy(motion, result.begin());
  return result;
}

NaturalPeriods natural_periods(const HydrodynamicData& data, const HullMatrix& mass,
                               const HullMatrix& restoring) {
  const auto period = [&](Eigen::Index motion) {
    if (!(restoring[static_cast<std::size_t>(7 * motion)] > 0.0)) return 0.0;
    double frequency = data.frequencies_radps[data.frequencies_radps.size() / 2];
    // omega^2 (M + A(omega)) x = C x, of the solutions the one that stores most of its energy in this motion.
    for (int i = 0; i < 60; ++i) {
      const HullMatrix added = added_mass_at(data, frequency);
      const Matrix6 inertia = as_matrix(mass) + as_matrix(added);
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solved(as_matrix(restoring), inertia);
      double most = 0.0, found = 0.0;
      for (Eigen::Index k = 0; k < 6; ++k) {
        const double value = solved.eigenvalues()[k], share = solved.eigenvectors()(motion, k);
        if (!(value > 0.0)) continue;
        const double energy = share * share * restoring[static_cast<std::size_t>(7 * motion)] / value;
        if (energy > most) {
          most = energy;
          found = std::sqrt(value);
        }
      }
      if (found == 0.0) return 0.0;
      const double next = 0.5 * (frequency + found);
      if (std::abs(next - frequency) < 1e-9 * frequency) break;
      frequency = next;
    }
    return 2.0 * pi / frequency;
  };
  return {period(1), period(3), period(5)};
}

}  // namespace offing::bodies
