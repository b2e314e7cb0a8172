// The eye, on a sphere about the object. Matrices are columns first. The same as camera_matrices() of the library.

const product4 = (a, b) => {
  const result = new Float32Array(16);
  for (let column = 0; column < 4; ++column) {
    for (let row = 0; row < 4; ++row) {
      for (let k = 0; k < 4; ++k) result[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    }
  }
  return result;
};

const cameraMatrices = ({yaw, pitch, distance, fov}, aspect) => {
  const near = 0.05, far = 100, radians = Math.PI / 180;
  const a = yaw * radians, b = pitch * radians;
  const back = [Math.cos(b) * Math.cos(a), Math.cos(b) * Math.sin(a), Math.sin(b)];
  const right = [-Math.sin(a), Math.cos(a), 0];
  const up = [-Math.sin(b) * Math.cos(a), -Math.sin(b) * Math.sin(a), Math.cos(b)];
  const eye = back.map((x) => distance * x);
  const scale = 1 / Math.tan(fov * radians / 2);
  const depth = (far + near) / (near - far), shift = 2 * far * near / (near - far);
  const clipFromEye = [scale / aspect, 0, 0, 0, 0, scale, 0, 0, 0, 0, depth, -1, 0, 0, shift, 0];
  const eyeFromClip = [aspect / scale, 0, 0, 0, 0, 1 / scale, 0, 0, 0, 0, 0, 1 / shift, 0, 0, -1, depth / shift];
  const rows = [0, 1, 2].map((i) => [right[i], up[i], back[i]]);
  const eyeFromWorld = [...rows[0], 0, ...rows[1], 0, ...rows[2], 0, 0, 0, -distance, 1];
  const worldFromEye = [...right, 0, ...up, 0, ...back, 0, ...eye, 1];
  return {
    eye: Float32Array.from(eye),
    clip_from_world: product4(clipFromEye, eyeFromWorld),
    world_from_clip: product4(worldFromEye, eyeFromClip),
    eye_from_world: Float32Array.from(rows.flat()),
  };
};
