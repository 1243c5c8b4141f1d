// Weighted blended order-independent transparency: nearer fragments weigh more.
float blend_weight(float depth, float alpha) {
  float z = depth / max(forward.w, 1e-20);
  return alpha * clamp(3.0 / (0.01 + z * z * z * z), 0.02, 300.0);
}
