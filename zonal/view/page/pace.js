// Some exact answers are sums over thousands of texels for each pixel: too slow for some cards, and a card that works
// for seconds is taken away. Their pictures are drawn as large as the card can in the time there is.

class Pace {
  // Of the picture's edge. The first picture is small and shows what the card can do.
  scale(pixels, milliseconds) {
    if (this.cost === undefined) return 1 / 16;
    return Math.min(1, Math.max(1 / 24, Math.sqrt(milliseconds / (this.cost * pixels))));
  }

  // Resolves when the card has drawn what it was given, and learns from the time that took.
  async learn(gl, pixels) {
    const begin = performance.now();
    await finished(gl);
    this.cost = Math.max(1e-6, (performance.now() - begin) / pixels);
  }
}

const finished = async (gl) => {
  const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
  gl.flush();
  // Not UNSIGNALED is SIGNALED, or nothing when the context was lost in between.
  while (!gl.isContextLost() && gl.getSyncParameter(fence, gl.SYNC_STATUS) === gl.UNSIGNALED) {
    await new Promise((later) => setTimeout(later, 10));
  }
  gl.deleteSync(fence);
};
