// How far a technique is from its exact answer: both are drawn once more, small and in linear light, and compared.

const sizes = {whole: [160, 90], slow: [64, 36]};

class Measure {
  constructor(gl) {
    this.gl = gl;
    this.possible = gl.getExtension('EXT_color_buffer_float') !== null;
    if (!this.possible) return;
    const [width, height] = sizes.whole;
    this.frame = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    for (const [place, format] of [[gl.COLOR_ATTACHMENT0, gl.RGBA32F], [gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24]]) {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
    }
    this.possible = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }

  // What is under way is of no use any more.
  forget() { this.ticket = undefined; }

  // The root of the mean square of the difference over that of the exact answer, or words about why it cannot be had;
  // undefined when it was forgotten meanwhile. The page goes on while the card works.
  async difference(scene, values, slow) {
    if (!this.possible) {
      return 'the difference as a number cannot be had: this browser cannot draw into floats (EXT_color_buffer_float)';
    }
    const gl = this.gl, ticket = this.ticket = {}, [width, height] = slow ? sizes.slow : sizes.whole;
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
    gl.viewport(0, 0, width, height);
    gl.clearColor(0, 0, -1, 0);  // blue tells the pixels that the object covers: it writes 0
    gl.clear(gl.DEPTH_BUFFER_BIT | gl.COLOR_BUFFER_BIT);
    scene.drawMesh(values, scene.numbers(values, width, height, true));
    const squares = new Float32Array(4 * width * height), pixels = gl.createBuffer();
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, pixels);
    gl.bufferData(gl.PIXEL_PACK_BUFFER, squares.byteLength, gl.STREAM_READ);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, 0);
    gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    await finished(gl);
    const wanted = this.ticket === ticket && !gl.isContextLost();
    if (wanted) {
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, pixels);
      gl.getBufferSubData(gl.PIXEL_PACK_BUFFER, 0, squares);
      gl.bindBuffer(gl.PIXEL_PACK_BUFFER, null);
    }
    gl.deleteBuffer(pixels);
    if (!wanted) return undefined;
    let error = 0, truth = 0;
    for (let i = 0; i < squares.length; i += 4) {
      if (squares[i + 2] !== 0) continue;
      error += squares[i];
      truth += squares[i + 1];
    }
    return truth > 0 ? Math.sqrt(error / truth) : 0;
  }
}
