// An object in an environment.

class Scene {
  // bytes: of the meshes; light: {textures, uniforms, bytes}.
  constructor(gl, data, bytes, light) {
    this.gl = gl;
    this.data = data;
    this.bytes = bytes;
    this.programs = new Map();
    this.meshes = new Map();
    this.empty = gl.createVertexArray();
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    this.show(light);
  }

  show(light) {
    this.textures?.forget();
    this.textures = new Textures(this.gl, light.textures, light.bytes);
    this.light = Object.fromEntries(light.uniforms.map((uniform) => [uniform.name, floats(light.bytes, ...uniform.floats)]));
  }

  program(key, vertex, fragment, what) {
    if (!this.programs.has(key)) this.programs.set(key, new Program(this.gl, vertex, fragment, what));
    return this.programs.get(key);
  }

  numbers(values, width, height, measure) {
    const technique = this.data.techniques.find((t) => t.id === values.technique);
    return {
      ...this.light,
      ...values,
      ...cameraMatrices(values, width / height),
      light_from_world: lightFromWorld(values),
      sh_turned: turnedCoefficients(this.light.sh, values, this.data.quarter_turn_blocks),
      split_px: 0.5 * width,
      measure: measure ? 1 : 0,
      time_s: performance.now() / 1000,
      marked_lights: technique.marked_lights[Math.round(values.light_count)],
    };
  }

  uploaded(mesh) {
    if (!this.meshes.has(mesh)) this.meshes.set(mesh, uploadedMesh(this.gl, mesh, this.bytes));
    return this.meshes.get(mesh);
  }

  drawMesh(values, numbers) {
    const {gl, data} = this, shaders = data.shaders;
    const technique = data.techniques.find((t) => t.id === values.technique);
    const kind = values.compare === 0 && numbers.measure === 0 ? 'alone' : 'compared';
    this.program(kind + technique.id, shaders.mesh_vertex, shaders.shared + shaders[kind][technique.id], technique.title)
        .use(numbers, this.textures);
    const mesh = data.meshes.find((m) => m.name === values.mesh);
    gl.bindVertexArray(this.uploaded(mesh));
    gl.drawElements(gl.TRIANGLES, mesh.index_count, gl.UNSIGNED_INT, 0);
  }

  // One for each light that the technique shades by.
  drawArrows(numbers) {
    if (numbers.marked_lights === 0) return;
    const {gl, data} = this, shaders = data.shaders;
    this.program('arrow', shaders.arrow_vertex, shaders.shared + shaders.arrow, 'the arrows').use(numbers, this.textures);
    gl.bindVertexArray(this.uploaded(data.arrow));
    gl.drawElementsInstanced(gl.TRIANGLES, data.arrow.index_count, gl.UNSIGNED_INT, 0, numbers.marked_lights);
  }

  draw(values, width, height) {
    const {gl, data} = this, shaders = data.shaders, numbers = this.numbers(values, width, height, false);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 1);
    gl.clear(gl.DEPTH_BUFFER_BIT | gl.COLOR_BUFFER_BIT);
    try {
      this.drawMesh(values, numbers);
      this.drawArrows(numbers);
    } finally {  // last, so that only what is seen of it is drawn
      this.program('', shaders.background_vertex, shaders.shared + shaders.background, 'the background')
          .use(numbers, this.textures);
      gl.bindVertexArray(this.empty);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
  }
}
