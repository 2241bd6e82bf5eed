// A paraboloid map of the upper half of the sky: the direction d lies at d.xz / (1 + d.y), the zenith in the middle
// and the horizon on the unit circle.
const float environment_margin = 1.04;  // half the map's width
