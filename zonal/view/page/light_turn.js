// The light turned freely, as turned() of the library: roll about +X first, then pitch, then yaw about +Z.

const rotationAbout = (axis, degrees) => {  // rows; the axis is 0, 1 or 2
  const c = Math.cos(degrees * Math.PI / 180), s = Math.sin(degrees * Math.PI / 180), i = (axis + 1) % 3, j = (axis + 2) % 3;
  const rows = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
  [rows[i][i], rows[i][j], rows[j][i], rows[j][j]] = [c, -s, s, c];
  return rows;
};
const product3 = (a, b) => a.map((row) => [0, 1, 2].map((k) => row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]));

// Columns of the inverse: rows of what turns the light into the world.
const lightFromWorld = ({light_yaw_deg, light_pitch_deg, light_roll_deg}) =>
    Float32Array.from([[2, light_yaw_deg], [1, -light_pitch_deg], [0, light_roll_deg]]
                          .map(([axis, degrees]) => rotationAbout(axis, degrees)).reduce(product3).flat());

// Coefficients l(l+1)+m of three colours each. About Z, those of m and -m turn into each other by m times the angle.
const coefficientsAboutZ = (from, degrees) => {
  const to = from.slice(), bands = Math.sqrt(from.length / 3);
  for (let l = 1; l < bands; ++l) {
    for (let m = 1; m <= l; ++m) {
      const angle = m * degrees * Math.PI / 180, c = Math.cos(angle), s = Math.sin(angle), zero = l * (l + 1);
      for (let color = 0; color < 3; ++color) {
        const even = 3 * (zero + m) + color, odd = 3 * (zero - m) + color;
        to[even] = c * from[even] - s * from[odd];
        to[odd] = s * from[even] + c * from[odd];
      }
    }
  }
  return to;
};

// By the library's matrices, a block for each band, or (back) by their transposes.
const coefficientsByBlocks = (from, blocks, back) => {
  const to = new Float64Array(from.length);
  for (let l = 0, at = 0; at < blocks.length; ++l) {
    const first = l * l, size = 2 * l + 1;
    for (let m = 0; m < size; ++m) {
      for (let n = 0; n < size; ++n) {
        const entry = blocks[at + (back ? n * size + m : m * size + n)];
        for (let color = 0; color < 3; ++color) to[3 * (first + m) + color] += entry * from[3 * (first + n) + color];
      }
    }
    at += size * size;
  }
  return to;
};

// As turned_coefficients() of the library. Every rotation is turns about Z between quarter turns Q about X: Y(b) = Q' Z(b) Q, and X(c) = Z(-90) Y(c) Z(90).
const turnedCoefficients = (sh, {turn_by, light_yaw_deg, light_pitch_deg, light_roll_deg}, quarter) => {
  if (turn_by === 0) return sh;
  const aboutY = (from, degrees) =>
      coefficientsByBlocks(coefficientsAboutZ(coefficientsByBlocks(from, quarter, false), degrees), quarter, true);
  const rolled = coefficientsAboutZ(aboutY(coefficientsAboutZ(Float64Array.from(sh), 90), light_roll_deg), -90);
  return Float32Array.from(coefficientsAboutZ(aboutY(rolled, -light_pitch_deg), light_yaw_deg));
};
