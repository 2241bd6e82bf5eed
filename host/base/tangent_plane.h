#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

/// Directions, frames and symmetric tensors in the plane that touches a surface.
namespace offing {

/// A symmetric 3 x 3 matrix.
struct SymmetricTensor {
  double xx = 0.0, xy = 0.0, xz = 0.0, yy = 0.0, yz = 0.0, zz = 0.0;

  SymmetricTensor& operator+=(const SymmetricTensor& other) {
    xx += other.xx, xy += other.xy, xz += other.xz;
    yy += other.yy, yz += other.yz, zz += other.zz;
    return *this;
  }
  friend SymmetricTensor operator*(double factor, const SymmetricTensor& tensor) {
    return {factor * tensor.xx, factor * tensor.xy, factor * tensor.xz,
            factor * tensor.yy, factor * tensor.yz, factor * tensor.zz};
  }
  glm::dvec3 operator*(const glm::dvec3& vector) const {
    return {xx * vector.x + xy * vector.y + xz * vector.z, xy * vector.x + yy * vector.y + yz * vector.z,
            xz * vector.x + yz * vector.y + zz * vector.z};
  }
};

/// factor * vector vector^T.
inline SymmetricTensor outer_square(double factor, const glm::dvec3& vector) {
  const glm::dvec3 scaled = factor * vector;
  return {scaled.x * vector.x, scaled.x * vector.y, scaled.x * vector.z,
          scaled.y * vector.y, scaled.y * vector.z, scaled.z * vector.z};
}

/// Two unit vectors that make a right-handed frame u, w, normal. Duff et al. 2017, "Building an orthonormal
/// basis, revisited", which no direction of the normal breaks.
struct TangentFrame {
  glm::dvec3 u, w;

  explicit TangentFrame(const glm::dvec3& normal) {
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z), b = normal.x * normal.y * a;
    u = {1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x};
    w = {b, sign + normal.y * normal.y * a, -normal.y};
  }
};

/// Eigenvalues of a symmetric 2 x 2 matrix, and the eigenvector (cosine, sine) of the larger.
struct PlaneEigen {
  double larger = 0.0, smaller = 0.0;
  double cosine = 1.0, sine = 0.0;
};

/// Of [[uu, uw], [uw, ww]]. Where both eigenvalues are one, the first axis is as good an answer as any.
inline PlaneEigen plane_eigen(double uu, double uw, double ww) {
  const double mean = 0.5 * (uu + ww), half = 0.5 * (uu - ww);
  const double root = std::sqrt(half * half + uw * uw);
  if (!(root > 0.0)) return {mean, mean, 1.0, 0.0};
  // The half angle of (half, uw), from whichever of its cosine and sine is not small.
  const double double_cosine = half / root, double_sine = uw / root;
  const double large = std::sqrt(0.5 * (1.0 + std::abs(double_cosine)));
  const double small = 0.5 * double_sine / large;
  return double_cosine >= 0.0
             ? PlaneEigen{mean + root, mean - root, large, small}
             : PlaneEigen{mean + root, mean - root, std::abs(small), std::copysign(large, small)};
}

/// Eigenvalues of a tensor within the plane across a unit normal; of_larger x of_smaller = normal.
struct TangentEigen {
  double larger = 0.0, smaller = 0.0;
  glm::dvec3 of_larger{}, of_smaller{};
};

inline TangentEigen tangent_eigen(const SymmetricTensor& tensor, const glm::dvec3& normal) {
  const TangentFrame frame(normal);
  const glm::dvec3 of_u = tensor * frame.u, of_w = tensor * frame.w;
  const PlaneEigen eigen =
      plane_eigen(glm::dot(frame.u, of_u), glm::dot(frame.w, of_u), glm::dot(frame.w, of_w));
  return {eigen.larger, eigen.smaller, eigen.cosine * frame.u + eigen.sine * frame.w,
          eigen.cosine * frame.w - eigen.sine * frame.u};
}

}  // namespace offing
