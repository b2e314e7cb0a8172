// The brush of the library (view/paint.h): a soft disc of linear light, and one stroke of it over a square picture of
// three numbers a texel. A texel is covered as much as the nearest point of the whole stroke covers it.

const brushCover = (distance, radius) => {
  const inside = 1 - distance * distance / (radius * radius);
  return inside > 0 ? inside * inside : 0;
};

class Stroke {
  constructor(before, {radius, light}) {
    this.before = before;
    this.picture = Float32Array.from(before);
    this.px = Math.round(Math.sqrt(before.length / 3));
    this.covered = new Float32Array(this.px * this.px);
    this.radius = radius;
    this.light = light;
  }

  moveTo(u, v) {
    const {px, radius} = this, [u0, v0] = this.last ?? [u, v];
    this.last = [u, v];
    const du = u - u0, dv = v - v0, square = du * du + dv * dv, clamped = (x, most) => Math.min(most, Math.max(0, x));
    const first = (a, b) => clamped(Math.floor((Math.min(a, b) - radius) * px), px);
    const end = (a, b) => clamped(Math.ceil((Math.max(a, b) + radius) * px), px);
    for (let y = first(v0, v); y < end(v0, v); ++y) {
      for (let x = first(u0, u); x < end(u0, u); ++x) {
        const toU = (x + 0.5) / px - u0, toV = (y + 0.5) / px - v0;
        const part = square > 0 ? clamped((toU * du + toV * dv) / square, 1) : 0;
        const cover = brushCover(Math.hypot(toU - part * du, toV - part * dv), radius), i = y * px + x;
        if (cover <= this.covered[i]) continue;
        this.covered[i] = cover;
        for (let c = 0; c < 3; ++c) this.picture[3 * i + c] = (1 - cover) * this.before[3 * i + c] + cover * this.light[c];
      }
    }
  }
}
