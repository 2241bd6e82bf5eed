// Light that meshes send to the eye, kcd/m2, linear Rec.709. Places are relative to the eye, in the world's axes.
const float pi = 3.14159265;

struct Material {
  vec3 colour;      // diffuse reflectance
  float specular;   // reflectance of Blinn's highlight
  float shininess;  // its exponent
};

// Where normals cancel between vertices there is none, and no light but that from around.
vec3 unit_or_zero(vec3 v) {
  return v * inversesqrt(max(dot(v, v), 1e-20));
}

vec3 toward_light(int i, vec3 place_m) {
  return normalize(lighting.lights[2 * i].xyz - lighting.lights[2 * i].w * place_m);
}

// On a surface at a place that faces the light.
vec3 light_klx(int i, vec3 place_m) {
  return lighting.lights[2 * i + 1].rgb * (i == lighting.sun ? cloud_share(place_m) : 1.0);
}

vec3 around_klx(float rise) {
  return mix(lighting.ground_klx, lighting.sky_klx, 0.5 + 0.5 * rise);
}

// Lambert's law and Blinn's highlight, (n + 8) / (8 pi) (N.H)^n times the light on the surface, which keeps the
// light that is sent the same for all n.
vec3 smooth_light(Material material, vec3 place_m, vec3 normal) {
  vec3 toward_eye = -normalize(place_m);
  vec3 on_surface_klx = around_klx(normal.y), mirrored_klx = vec3(0.0);
  for (int i = 0; i < lighting.count; ++i) {
    vec3 toward = toward_light(i, place_m);
    vec3 klx = light_klx(i, place_m) * max(dot(normal, toward), 0.0);
    on_surface_klx += klx;
    vec3 between = toward + toward_eye;
    float cosine = max(dot(normal, between) * inversesqrt(max(dot(between, between), 1e-12)), 0.0);
    mirrored_klx += klx * pow(max(cosine, 1e-6), material.shininess);
  }
  float gain = material.specular * (material.shininess + 8.0) / (8.0 * pi);
  return material.colour / pi * on_surface_klx + gain * mirrored_klx;
}
