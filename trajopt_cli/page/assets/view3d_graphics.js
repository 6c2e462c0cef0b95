// What the 3-D view draws with: shapes as triangles, strokes as ribbons, dots; plain WebGL.
"use strict";
window.TrajoptView3DGraphics = (() => {
  const { at, cross } = window.TrajoptView3DMotion;

  // Triangles as {points, normals}, three points each, flat arrays.
  function capsule(a, b, radius) {
    const along = b.map((v, i) => v - a[i]);
    const length = Math.hypot(...along);
    const w = length > 1e-9 ? along.map((v) => v / length) : [0, 0, 1];
    const side = Math.abs(w[0]) < 0.8 ? [1, 0, 0] : [0, 1, 0];
    const u = normal(cross(side, w));
    const v = cross(w, u);
    const rings = [];
    const around = 28;
    const up = 9;
    for (let k = 0; k < 2 * up; k++) {
      const lower = k < up;
      const angle = ((lower ? k : k - 1) / (2 * up - 2) - 0.5) * Math.PI;
      const centre = lower ? a : b;
      const ring = [];
      for (let i = 0; i <= around; i++) {
        const turn = (2 * Math.PI * i) / around;
        const n = [0, 1, 2].map(
          (c) => Math.cos(angle) * (Math.cos(turn) * u[c] + Math.sin(turn) * v[c]) + Math.sin(angle) * w[c],
        );
        ring.push([centre.map((c, j) => c + radius * n[j]), n]);
      }
      rings.push(ring);
    }
    const out = { points: [], normals: [] };
    for (let k = 0; k + 1 < rings.length; k++) {
      for (let i = 0; i < around; i++) {
        for (const [r, s] of [[k, i], [k, i + 1], [k + 1, i + 1], [k, i], [k + 1, i + 1], [k + 1, i]]) {
          out.points.push(...rings[r][s][0]);
          out.normals.push(...rings[r][s][1]);
        }
      }
    }
    return out;
  }

  function box(size) {
    const out = { points: [], normals: [] };
    for (let axis = 0; axis < 3; axis++) {
      for (const sign of [-1, 1]) {
        const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
        const corner = (p, r) => {
          const x = [0, 0, 0];
          x[axis] = (sign * size[axis]) / 2;
          x[i] = (p * size[i]) / 2;
          x[j] = (r * size[j]) / 2;
          return x;
        };
        const n = [0, 0, 0];
        n[axis] = sign;
        for (const [p, r] of [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]]) {
          out.points.push(...corner(p, r));
          out.normals.push(...n);
        }
      }
    }
    return out;
  }

  function mesh(vertices, triangles) {
    const out = { points: [], normals: [] };
    for (let i = 0; i + 2 < triangles.length; i += 3) {
      const [a, b, c] = [0, 1, 2].map((k) => Array.from(vertices.subarray(3 * triangles[i + k], 3 * triangles[i + k] + 3)));
      const n = normal(cross(b.map((v, k) => v - a[k]), c.map((v, k) => v - a[k])));
      for (const p of [a, b, c]) {
        out.points.push(...p);
        out.normals.push(...n);
      }
    }
    return out;
  }

  function normal(v) {
    const length = Math.hypot(...v) || 1;
    return v.map((one) => one / length);
  }

  function triangles(shape, decode) {
    if (shape.kind === "capsule") return capsule(shape.a, shape.b, shape.radius);
    if (shape.kind === "box") return box(shape.size);
    return mesh(decode(shape.vertices).data, decode(shape.triangles).data);
  }

  // Where a shape reaches: points in its frame, and a radius around them.
  function reach(shape, decode) {
    if (shape.kind === "capsule") return [[shape.a, shape.b], shape.radius];
    let low = [Infinity, Infinity, Infinity];
    let high = low.map((v) => -v);
    if (shape.kind === "box") {
      low = shape.size.map((v) => -v / 2);
      high = shape.size.map((v) => v / 2);
    } else {
      const points = decode(shape.vertices).data;
      for (let i = 0; i < points.length; i++) {
        low[i % 3] = Math.min(low[i % 3], points[i]);
        high[i % 3] = Math.max(high[i % 3], points[i]);
      }
    }
    const corners = [];
    for (let k = 0; k < 8; k++) corners.push(at(shape.X, [0, 1, 2].map((i) => ((k >> i) & 1 ? high[i] : low[i]))));
    return [corners, 0];
  }

  const SOLID = [
    `attribute vec3 position, normal; uniform mat4 model, view, projection; varying vec3 n, p;
    varying float height;
    void main() { height = position.z; vec4 q = view * (model * vec4(position, 1.0)); p = q.xyz;
      n = mat3(view) * (mat3(model) * normal); gl_Position = projection * q; }`,
    `precision mediump float; uniform vec4 color; uniform float lit, least; varying vec3 n, p;
    varying float height;
    void main() { if (height < least) discard;
      vec3 N = normalize(n), V = normalize(-p); if (dot(N, V) < 0.0) N = -N;
      float light = 0.66 + 0.4 * max(dot(N, normalize(vec3(-0.35, 0.75, 0.55))), 0.0);
      float edge = pow(1.0 - max(dot(N, V), 0.0), 3.0);
      gl_FragColor = vec4(mix(color.rgb, color.rgb * light * (1.0 - 0.28 * edge), lit), color.a); }`,
  ];
  const STROKE = [
    `attribute vec3 a, b; attribute vec2 corner; attribute vec3 style; uniform mat4 both; uniform vec2 port;
    uniform float width; varying vec2 s;
    void main() { vec4 A = both * vec4(a, 1.0), B = both * vec4(b, 1.0); s = style.yz;
      if (A.w < 0.01 || B.w < 0.01) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
      vec2 d = (B.xy / B.w - A.xy / A.w) * port; float l = length(d); d = l > 1e-5 ? d / l : vec2(1.0, 0.0);
      vec4 P = corner.y > 0.5 ? B : A; float w = width * style.x;
      P.xy += vec2(-d.y, d.x) * corner.x * w / port * P.w;
      P.z -= 0.0004 * P.w; gl_Position = P; }`,
    `precision mediump float; uniform vec4 color; uniform highp float now; varying vec2 s;
    void main() { gl_FragColor = vec4(color.rgb, color.a * s.x * (s.y > now ? 0.3 : 1.0)); }`,
  ];
  const DOT = [
    `attribute vec3 position; uniform mat4 both; uniform float size;
    void main() { gl_Position = both * vec4(position, 1.0); gl_Position.z -= 0.001 * gl_Position.w;
      gl_PointSize = size; }`,
    `precision mediump float; uniform vec4 color, rim;
    void main() { float r = length(gl_PointCoord - 0.5); if (r > 0.5) discard;
      gl_FragColor = r > 0.34 ? rim : color; }`,
  ];

  class Graphics {
    constructor(gl) {
      this.gl = gl;
      this.solid = this.program(SOLID);
      this.stroke = this.program(STROKE);
      this.dot = this.program(DOT);
    }

    program([vertex, fragment]) {
      const gl = this.gl;
      const program = gl.createProgram();
      for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(kind);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost()) {
          throw new Error(`3-D view: ${gl.getShaderInfoLog(shader)}`);
        }
        gl.attachShader(program, shader);
      }
      gl.linkProgram(program);
      const out = { program, attributes: {}, uniforms: {} };
      const names = (which) => Array.from({ length: gl.getProgramParameter(program, which) || 0 }, (_, i) => i);
      for (const i of names(gl.ACTIVE_ATTRIBUTES)) {
        const { name } = gl.getActiveAttrib(program, i);
        out.attributes[name] = gl.getAttribLocation(program, name);
      }
      for (const i of names(gl.ACTIVE_UNIFORMS)) {
        const { name } = gl.getActiveUniform(program, i);
        out.uniforms[name] = gl.getUniformLocation(program, name);
      }
      return out;
    }

    // A buffer of floats whose rows hold attributes of these widths in order.
    buffer(values, widths) {
      const gl = this.gl;
      const row = Object.values(widths).reduce((sum, one) => sum + one, 0);
      const handle = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, handle);
      gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(values), gl.STATIC_DRAW);
      return { handle, widths, row, count: values.length / row };
    }

    use(shader, uniforms) {
      const gl = this.gl;
      gl.useProgram(shader.program);
      for (const [name, value] of Object.entries(uniforms)) {
        const place = shader.uniforms[name];
        if (typeof value === "number") gl.uniform1f(place, value);
        else if (value.length === 2) gl.uniform2fv(place, value);
        else if (value.length === 4) gl.uniform4fv(place, value);
        else gl.uniformMatrix4fv(place, false, turned(value));
      }
    }

    draw(shader, buffer, mode = this.gl.TRIANGLES) {
      const gl = this.gl;
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer.handle);
      let offset = 0;
      for (const [name, width] of Object.entries(buffer.widths)) {
        const place = shader.attributes[name];
        gl.enableVertexAttribArray(place);
        gl.vertexAttribPointer(place, width, gl.FLOAT, false, 4 * buffer.row, 4 * offset);
        offset += width;
      }
      gl.drawArrays(mode, 0, buffer.count);
    }

    shape(triangles) {
      const values = [];
      for (let i = 0; i < triangles.points.length; i += 3) {
        for (let k = 0; k < 3; k++) values.push(triangles.points[i + k]);
        for (let k = 0; k < 3; k++) values.push(triangles.normals[i + k]);
      }
      return this.buffer(values, { position: 3, normal: 3 });
    }

    // Segments [a, b, width factor, opacity, time] as ribbons that face the viewer.
    ribbons(segments) {
      const values = [];
      for (const [a, b, width, opacity, time] of segments) {
        for (const [side, end] of [[-1, 0], [1, 0], [1, 1], [-1, 0], [1, 1], [-1, 1]]) {
          values.push(...a, ...b, side, end, width, opacity, time);
        }
      }
      return this.buffer(values, { a: 3, b: 3, corner: 2, style: 3 });
    }
  }

  function turned(m) {
    const out = new Float32Array(16);
    for (let i = 0; i < 4; i++) for (let j = 0; j < 4; j++) out[4 * j + i] = m[4 * i + j];
    return out;
  }

  return { Graphics, triangles, reach };
})();
