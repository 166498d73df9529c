// Draws meshes with WebGL: the image's triangles, lit from the eye, with marks in front of them.

const VERTEX = `#version 300 es
in vec3 at;
uniform mat4 model, eye, screen;
out vec3 seen;
void main() {
  vec4 p = eye * model * vec4(at, 1.0);
  seen = p.xyz;
  gl_Position = screen * p;
  gl_PointSize = 7.0;
}`;
const FRAGMENT = `#version 300 es
precision highp float;
in vec3 seen;
uniform vec4 colour;
uniform bool flat_;
out vec4 lit;
void main() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  float light = flat_ ? 1.0 : 0.35 + 0.65 * abs(normal.z);
  lit = vec4(colour.rgb * light, colour.a);
}`;

const IDENTITY = new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);

const times = (a, b) => {
  const product = new Float32Array(16);
  for (let i = 0; i < 16; ++i) {
    for (let k = 0; k < 4; ++k) product[i] += a[4 * k + i % 4] * b[4 * (i >> 2) + k];
  }
  return product;
};
const placed = (m, [x, y, z]) => [0, 1, 2, 3].map(i => m[i] * x + m[4 + i] * y + m[8 + i] * z + m[12 + i]);

// A mesh's own colour, which mixtures with other meshes' at smoothed edges do not have.
const tag_of = mesh => [37, 91, 153].map(factor => factor * (mesh + 1) % 251 + 1);

class View {
  // `meshes`: a list of { vertices: Int16Array, triangles: Uint16Array }. Throws if there is no WebGL.
  constructor(canvas, meshes) {
    const gl = canvas.getContext("webgl2", { alpha: false });
    if (!gl) throw new Error("this browser has no WebGL 2");
    this.gl = gl;
    this.canvas = canvas;
    this.program = this.#program();
    const place = name => gl.getUniformLocation(this.program, name);
    this.places = { model: place("model"), eye: place("eye"), screen: place("screen"), colour: place("colour"), flat: place("flat_") };
    this.meshes = meshes.map(mesh => this.#mesh(mesh));
    this.marks = gl.createBuffer();
    this.look([0, 0, 0], 1);
    gl.enable(gl.DEPTH_TEST);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    this.#fit();
  }

  // Looks at the middle of something of this size from where the page begins.
  look(middle, size) {
    Object.assign(this, { middle, size, turn: { yaw: 0.9, pitch: 0.35 }, distance: 1.3 });
  }

  // Sets the canvas to the page's number of pixels.
  #fit() {
    const ratio = Math.min(devicePixelRatio, 2);
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight].map(size => Math.round(size * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, { width, height });
  }

  #program() {
    const { gl } = this;
    const program = gl.createProgram();
    for (const [kind, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    }
    gl.bindAttribLocation(program, 0, "at");
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
  }

  // Browsers allow only a few contexts at a time.
  close() {
    this.gl.getExtension("WEBGL_lose_context")?.loseContext();
  }

  #mesh({ vertices, triangles }) {
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    for (const [target, data] of [[gl.ARRAY_BUFFER, vertices], [gl.ELEMENT_ARRAY_BUFFER, triangles]]) {
      gl.bindBuffer(target, gl.createBuffer());
      gl.bufferData(target, data, gl.STATIC_DRAW);
    }
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.SHORT, false, 0, 0);
    return { array, count: triangles.length };
  }

  // From the base's frame to the eye's, which looks along -z; the base's z points up.
  eye() {
    const { yaw, pitch } = this.turn;
    const [s, c, t, d] = [Math.sin(yaw), Math.cos(yaw), Math.sin(pitch), Math.cos(pitch)];
    const axes = [[c, s, 0], [-t * s, t * c, d], [d * s, -d * c, t]];  // right, up, back
    const along = axis => -axis.reduce((sum, part, i) => sum + part * this.middle[i], 0);
    return new Float32Array([0, 1, 2].flatMap(i => [...axes.map(axis => axis[i]), 0]).concat(
      along(axes[0]), along(axes[1]), along(axes[2]) - this.distance * this.size, 1));
  }

  screen() {
    const [near, far, focus] = [this.size / 50, this.size * 50, 2.4];
    const wide = this.canvas.width / this.canvas.height;
    return new Float32Array([focus / Math.max(wide, 1), 0, 0, 0, 0, focus * Math.min(wide, 1), 0, 0, 0, 0,
      (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0]);
  }

  // Converts a point of the base's frame to pixels of the page, from the canvas's upper left corner.
  pixel(point) {
    const p = placed(times(this.screen(), this.eye()), point);
    return [(p[0] / p[3] + 1) / 2 * this.canvas.clientWidth, (1 - p[1] / p[3]) / 2 * this.canvas.clientHeight];
  }

  #draw(matrices, colours, flat) {
    const { gl, places } = this;
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.useProgram(this.program);
    gl.uniformMatrix4fv(places.eye, false, this.eye());
    gl.uniformMatrix4fv(places.screen, false, this.screen());
    gl.uniform1i(places.flat, flat);
    this.meshes.forEach((mesh, i) => {
      gl.uniformMatrix4fv(places.model, false, matrices[i]);
      gl.uniform4fv(places.colour, colours[i]);
      gl.bindVertexArray(mesh.array);
      gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_SHORT, 0);
    });
  }

  // `marks`: a list of { kind: "POINTS", "LINES" or "TRIANGLES", points, colour }, in the base's frame. `points`: an
  // array of points or of their coordinates.
  draw(matrices, colours, ground, marks) {
    const { gl, places } = this;
    this.#fit();
    gl.clearColor(...ground);
    this.#draw(matrices, colours, false);
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.marks);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.uniformMatrix4fv(places.model, false, IDENTITY);
    gl.uniform1i(places.flat, true);
    gl.disable(gl.DEPTH_TEST);
    gl.enable(gl.BLEND);
    for (const { kind, points, colour } of marks) {
      const numbers = points instanceof Float32Array ? points : new Float32Array(points.flat());
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.DYNAMIC_DRAW);
      gl.uniform4fv(places.colour, colour);
      gl.drawArrays(gl[kind], 0, numbers.length / 3);
    }
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
  }

  // The mesh at a pixel of the page, or -1. Draws the meshes in their own colours.
  pick(matrices, x, y) {
    const { gl } = this;
    const ratio = this.canvas.width / this.canvas.clientWidth;
    const pixel = new Uint8Array(4);
    const tags = this.meshes.map((_, i) => tag_of(i));
    gl.clearColor(0, 0, 0, 0);
    this.#draw(matrices, tags.map(tag => [...tag.map(part => part / 255), 1]), true);
    gl.readPixels(x * ratio, this.canvas.height - y * ratio, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return tags.findIndex(tag => tag.every((part, i) => part === pixel[i]));
  }
}
