// A frame with several samples a pixel, whose means are the picture.

const edgeSamples = 4;  // an edge has five steps

class SmoothFrame {
  constructor(gl) {
    this.gl = gl;
    this.samples = Math.min(edgeSamples, gl.getParameter(gl.MAX_SAMPLES));
    this.size = [0, 0];
  }

  frame(width, height) {
    const gl = this.gl;
    if (this.size[0] === width && this.size[1] === height) return this.id;
    this.size = [width, height];
    this.buffers?.forEach((buffer) => gl.deleteRenderbuffer(buffer));
    this.id ??= gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.id);
    this.buffers = [[gl.COLOR_ATTACHMENT0, gl.RGBA8], [gl.DEPTH_ATTACHMENT, gl.DEPTH_COMPONENT24]].map(([place, format]) => {
      const buffer = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
      gl.renderbufferStorageMultisample(gl.RENDERBUFFER, this.samples, format, width, height);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
      return buffer;
    });
    return this.id;
  }

  // Into the canvas, which has the same format (alpha included) or this were refused.
  show() {
    const gl = this.gl, [width, height] = this.size;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.id);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
}
