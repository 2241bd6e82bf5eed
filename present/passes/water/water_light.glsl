// Light that leaves a patch of rough water toward the eye. Its facets have slopes of mean m and covariance C
// (normal); what waves hide from the eye and from the sun is that of Smith 1967 for such a surface, in the form of
// Ross, Dion & Potvin 2005. Directions v and l point to the eye and to the sun, y up.
const float pi = 3.14159265;

struct Facets {
  vec2 mean;        // of dh/dx, dh/dz
  vec3 covariance;  // xx, xz, zz
};

// Facets seen from a direction: with u the horizontal unit vector toward it and z the slope along u in standard
// deviations, those with z < bound, each by bound - z.
struct Visibility {
  float bound;
  float area;       // integral of (bound - z) over visible z: the seen area, over |v.xz| deviation
  float mean;       // of z, as seen
  float deviation;  // of z, as seen
  vec2 spread;      // C u / deviation of the slope: what a step of 1 in z adds to the slope
  float scale;      // |v.xz| times the standard deviation along u
};

vec2 covariance_times(vec3 covariance, vec2 u) {
  return vec2(covariance.x * u.x + covariance.y * u.y, covariance.y * u.x + covariance.z * u.y);
}

Visibility visibility(Facets facets, vec3 direction) {
  Visibility seen;
  float level = max(length(direction.xz), 1e-4);
  vec2 u = direction.xz / level;
  vec2 product = covariance_times(facets.covariance, u);
  float deviation = sqrt(max(dot(product, u), 1e-8));
  seen.scale = level * deviation;
  seen.spread = product / deviation;
  // Below -2 hardly anything is seen; the waves before it hide such a patch.
  seen.bound = clamp((direction.y / level - dot(facets.mean, u)) / deviation, -2.0, 1e4);
  float x = min(seen.bound, 6.0);
  float density = exp(-0.5 * x * x) * 0.39894228;
  float below = 1.0 / (1.0 + exp(-x * (1.5976 + 0.07056 * x * x)));  // the normal distribution, to 2e-4
  seen.area = max(seen.bound * below + density, 1e-3);
  seen.mean = -below / seen.area;
  float square = (seen.bound * below + 2.0 * density) / seen.area;
  seen.deviation = sqrt(max(square - seen.mean * seen.mean, 0.0));
  return seen;
}

// Sunlight that the facets reflect, per illuminance of a surface that faces the sun.
float sun_glitter(Facets facets, Visibility seen, vec3 v, vec3 l, float sun_radius_rad) {
  vec3 halfway = normalize(v + l);
  if (halfway.y <= 0.02 || l.y <= -0.02) return 0.0;
  // The disc is not a point: its radius moves the facet that mirrors it by half as much.
  float blur = 0.0625 * sun_radius_rad * sun_radius_rad;
  vec3 c = facets.covariance + vec3(blur, 0.0, blur);
  vec2 offset = -halfway.xz / halfway.y - facets.mean;
  float determinant = max(c.x * c.z - c.y * c.y, 1e-14);
  float exponent =
      (c.z * offset.x * offset.x - 2.0 * c.y * offset.x * offset.y + c.x * offset.y * offset.y) / determinant;
  float density = exp(-0.5 * min(exponent, 80.0)) / (2.0 * pi * sqrt(determinant));
  Visibility lit = visibility(facets, l);
  float unshadowed = clamp(lit.bound / lit.area, 0.0, 1.0);
  float h2 = halfway.y * halfway.y;
  return fresnel(max(dot(v, halfway), 0.0)) * density * unshadowed / (4.0 * h2 * h2 * seen.scale * seen.area);
}
