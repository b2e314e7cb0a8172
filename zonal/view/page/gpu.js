// What lies on the graphics card: programs, textures, meshes. Made when first used.

class Program {
  // The card compiles while the page goes on.
  constructor(gl, vertex, fragment, what) {
    this.gl = gl;
    this.what = what;
    this.id = gl.createProgram();
    this.shaders = [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]].map(([kind, source]) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(this.id, shader);
      return shader;
    });
    gl.linkProgram(this.id);
  }

  // Waits for the card. Each sampler gets a texture unit of its own for good.
  get uniforms() {
    if (this.found) return this.found;
    const gl = this.gl;
    if (!gl.getProgramParameter(this.id, gl.LINK_STATUS)) {
      const words = [...this.shaders.map((s) => gl.getShaderInfoLog(s)), gl.getProgramInfoLog(this.id)].filter((w) => w);
      if (gl.isContextLost()) throw new LostContext();
      throw new Error(`the graphics driver refuses the shaders of “${this.what}”: ${words.join('\n')}`);
    }
    this.shaders.forEach((shader) => gl.deleteShader(shader));
    this.found = [];
    gl.useProgram(this.id);
    const count = gl.getProgramParameter(this.id, gl.ACTIVE_UNIFORMS);
    for (let i = 0, units = 0; i < count; ++i) {
      const {name, type} = gl.getActiveUniform(this.id, i), place = gl.getUniformLocation(this.id, name);
      const unit = type === gl.SAMPLER_2D || type === gl.SAMPLER_CUBE ? units++ : undefined;
      if (unit !== undefined) gl.uniform1i(place, unit);
      this.found.push({name: name.replace(/\[0\]$/, ''), type, place, unit});
    }
    return this.found;
  }

  // Draws with whatever numbers there are.
  begin() {
    void this.uniforms;
    this.gl.useProgram(this.id);
  }

  // Gives every uniform the number (or array) that `numbers` has under its name, and every sampler its texture.
  use(numbers, textures) {
    const gl = this.gl, uniforms = this.uniforms;
    gl.useProgram(this.id);
    for (const {name, type, place, unit} of uniforms) {
      if (unit !== undefined) {
        gl.activeTexture(gl.TEXTURE0 + unit);
        textures.bind(name);
        continue;
      }
      const value = numbers[name];
      if (value === undefined) throw new Error(`this page has no number “${name}” for its shaders`);
      if (typeof value === 'object') {
        if (type === gl.FLOAT) gl.uniform1fv(place, value);
        else if (type === gl.FLOAT_VEC2) gl.uniform2fv(place, value);
        else if (type === gl.FLOAT_VEC3) gl.uniform3fv(place, value);
        else if (type === gl.FLOAT_VEC4) gl.uniform4fv(place, value);
        else if (type === gl.FLOAT_MAT3) gl.uniformMatrix3fv(place, false, value);
        else if (type === gl.FLOAT_MAT4) gl.uniformMatrix4fv(place, false, value);
        else throw new Error(`“${name}” is of a type that this page cannot set`);
      } else if (type === gl.FLOAT) {
        gl.uniform1f(place, value);
      } else {
        gl.uniform1i(place, value);
      }
    }
  }
}

// The context went away while it was asked for something; what is to be done then is done by its event.
class LostContext extends Error {}

class Textures {
  constructor(gl, list, bytes) {
    this.gl = gl;
    this.bytes = bytes;
    this.own = new Map();  // name -> picture in place of that in the bytes
    this.list = new Map(list.map((texture) => [texture.name, texture]));
    this.made = new Map();
  }

  bind(name) {
    const texture = this.list.get(name);
    if (!texture) throw new Error(`this page has no picture “${name}” for its shaders`);
    const target = texture.cube ? this.gl.TEXTURE_CUBE_MAP : this.gl.TEXTURE_2D;
    if (this.made.has(name)) {
      this.gl.bindTexture(target, this.made.get(name));
    } else {
      this.made.set(name, this.make(texture, target));
    }
  }

  // A square picture of one level, three numbers a texel, from now on.
  replace(name, picture) {
    this.own.set(name, picture);
    this.gl.deleteTexture(this.made.get(name) ?? null);
    this.made.delete(name);
  }

  // The numbers of a level as they are in the bytes.
  texels(name, level) {
    const texture = this.list.get(name), [at, width, height] = texture.levels[level];
    return texture.table ? shorts(this.bytes, at, 3 * width * height) : words(this.bytes, at, width * height);
  }

  // Gives the card its memory back.
  forget() {
    this.made.forEach((id) => this.gl.deleteTexture(id));
    this.made.clear();
  }

  make(texture, target) {
    const gl = this.gl, own = this.own.get(texture.name);
    const texels = own ? [] : texture.levels.map((_, level) => this.texels(texture.name, level));
    const id = gl.createTexture();
    gl.bindTexture(target, id);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 2);
    const format = texture.table ? gl.RGB16F : gl.RGB9_E5;
    const type = texture.table ? gl.HALF_FLOAT : gl.UNSIGNED_INT_5_9_9_9_REV;
    texture.levels.forEach(([, width, height], level) => {
      if (own) {
        gl.texImage2D(target, level, gl.RGB16F, width, height, 0, gl.RGB, gl.FLOAT, own);
        return;
      }
      if (!texture.cube) {
        gl.texImage2D(target, level, format, width, height, 0, gl.RGB, type, texels[level]);
        return;
      }
      for (let face = 0, size = texels[level].length / 6; face < 6; ++face) {
        gl.texImage2D(gl.TEXTURE_CUBE_MAP_POSITIVE_X + face, level, format, width, width, 0, gl.RGB, type,
                      texels[level].subarray(face * size, (face + 1) * size));
      }
    });
    const set = (parameter, value) => gl.texParameteri(target, parameter, value);
    set(gl.TEXTURE_MAX_LEVEL, texture.levels.length - 1);
    set(gl.TEXTURE_MIN_FILTER, texture.levels.length > 1 ? gl.LINEAR_MIPMAP_LINEAR : gl.LINEAR);
    set(gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    set(gl.TEXTURE_WRAP_S, texture.repeats_x ? gl.REPEAT : gl.CLAMP_TO_EDGE);
    set(gl.TEXTURE_WRAP_T, texture.repeats_y ? gl.REPEAT : gl.CLAMP_TO_EDGE);
    return id;
  }
}

// A vertex is eight shorts: position and normal in units of 1/32767, texture coordinates in units of 1/65535.
const uploadedMesh = (gl, mesh, bytes) => {
  const vertices = summedRows(shorts(bytes, mesh.vertices_at, 8 * mesh.vertex_count), 8);
  return vertexArray(gl, vertices, summedRows(words(bytes, mesh.indices_at, mesh.index_count), 3));
};

const vertexArray = (gl, vertices, indices) => {
  const array = gl.createVertexArray();
  gl.bindVertexArray(array);
  gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ARRAY_BUFFER, vertices, gl.STATIC_DRAW);
  gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
  gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
  [[3, gl.SHORT, 0], [3, gl.SHORT, 6], [2, gl.UNSIGNED_SHORT, 12]].forEach(([components, type, offset], place) => {
    gl.enableVertexAttribArray(place);
    gl.vertexAttribPointer(place, components, type, true, 16, offset);
  });
  return array;
};
