// An object in an environment.

class Scene {
  // bytes: of the meshes.
  constructor(gl, data, bytes) {
    this.gl = gl;
    this.data = data;
    this.bytes = bytes;
    this.programs = new Map();
    this.meshes = new Map();
    this.empty = gl.createVertexArray();
    this.smooth = new SmoothFrame(gl);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
  }

  // light: {textures, uniforms, bytes}. There is one before anything is drawn.
  show(light) {
    this.textures?.forget();
    this.textures = new Textures(this.gl, light.textures, light.bytes);
    this.light = Object.fromEntries(light.uniforms.map((uniform) => [uniform.name, floats(light.bytes, ...uniform.floats)]));
  }

  // vertex, fragment: places of the pieces of their text.
  program(key, vertex, fragment, what) {
    if (!this.programs.has(key)) {
      const text = (pieces) => pieces.map((place) => this.data.shaders.texts[place]).join('');
      this.programs.set(key, new Program(this.gl, text(vertex), text(fragment), what));
    }
    return this.programs.get(key);
  }
  meshProgram(values, measured) {
    const {shaders, techniques} = this.data, technique = techniques.find((t) => t.id === values.technique);
    const kind = values.compare === 0 && !measured ? 'alone' : 'compared';
    return this.program(kind + technique.id, shaders.mesh_vertex, shaders[kind][technique.id], technique.title);
  }
  arrowProgram() {
    const {shaders} = this.data;
    return this.program('arrow', shaders.arrow_vertex, shaders.arrow, 'the arrows');
  }
  backgroundProgram() {
    const {shaders} = this.data;
    return this.program('', shaders.background_vertex, shaders.background, 'the background');
  }

  // Has the programs of the first picture compiled, which many cards do only when something is drawn: an object of no size.
  prepare(values) {
    const gl = this.gl, none = new Uint32Array(12);
    gl.viewport(0, 0, 1, 1);
    gl.bindVertexArray(vertexArray(gl, none, none));
    this.meshProgram(values, false).begin();
    gl.drawElements(gl.TRIANGLES, 3, gl.UNSIGNED_INT, 0);
    gl.bindVertexArray(this.empty);
    this.backgroundProgram().begin();
    gl.drawArraysInstanced(gl.TRIANGLES, 0, 3, 1);
    gl.flush();
  }

  markedLights(values) {
    const technique = this.data.techniques.find((t) => t.id === values.technique);
    return technique.marked_lights[Math.round(values.light_count)];
  }

  numbers(values, width, height, measure) {
    return {
      ...this.light,
      ...values,
      ...cameraMatrices(values, width / height),
      light_from_world: lightFromWorld(values),
      sh_turned: turnedCoefficients(this.light.sh, values, this.data.quarter_turn_blocks),
      split_px: 0.5 * width,
      measure: measure ? 1 : 0,
      time_s: performance.now() / 1000,
      marked_lights: this.markedLights(values),
    };
  }

  uploaded(mesh) {
    if (!this.meshes.has(mesh)) this.meshes.set(mesh, uploadedMesh(this.gl, mesh, this.bytes));
    return this.meshes.get(mesh);
  }

  drawMesh(values, numbers) {
    const {gl, data} = this, mesh = data.meshes.find((m) => m.name === values.mesh);
    this.meshProgram(values, numbers.measure !== 0).use(numbers, this.textures);
    gl.bindVertexArray(this.uploaded(mesh));
    gl.drawElements(gl.TRIANGLES, mesh.index_count, gl.UNSIGNED_INT, 0);
  }

  // One for each light that the technique shades by.
  drawArrows(numbers) {
    if (numbers.marked_lights === 0) return;
    const {gl, data} = this;
    this.arrowProgram().use(numbers, this.textures);
    gl.bindVertexArray(this.uploaded(data.arrow));
    gl.drawElementsInstanced(gl.TRIANGLES, data.arrow.index_count, gl.UNSIGNED_INT, 0, numbers.marked_lights);
  }

  // Smooth edges take several times as long where the processor draws. The first picture does not wait for the program of
  // the arrows: returns whether the picture is all there.
  draw(values, width, height, smooth) {
    const {gl} = this, first = !this.hasDrawn;
    gl.bindFramebuffer(gl.FRAMEBUFFER, smooth ? this.smooth.frame(width, height) : null);
    this.drawAll(values, width, height, !first);
    this.hasDrawn = true;
    if (smooth) this.smooth.show();
    return !first || this.markedLights(values) === 0;
  }

  drawAll(values, width, height, withArrows) {
    const gl = this.gl, numbers = this.numbers(values, width, height, false);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, 0, 1);
    gl.clear(gl.DEPTH_BUFFER_BIT | gl.COLOR_BUFFER_BIT);
    try {
      this.drawMesh(values, numbers);
      if (withArrows) this.drawArrows(numbers);
    } finally {  // last, so that only what is seen of it is drawn
      this.backgroundProgram().use(numbers, this.textures);
      gl.bindVertexArray(this.empty);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
    }
  }
}
