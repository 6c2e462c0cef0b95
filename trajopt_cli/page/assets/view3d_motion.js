// What the 3-D view needs of mechanics and optics: forward kinematics along the chain of page/scene.py, and a camera.
// Matrices are arrays of 16 numbers, row by row.
"use strict";
window.TrajoptView3DMotion = (() => {
  const FIELD = (30 * Math.PI) / 180;

  function times(a, b) {
    const out = new Array(16);
    for (let i = 0; i < 4; i++) {
      for (let j = 0; j < 4; j++) {
        out[4 * i + j] =
          a[4 * i] * b[j] + a[4 * i + 1] * b[4 + j] + a[4 * i + 2] * b[8 + j] + a[4 * i + 3] * b[12 + j];
      }
    }
    return out;
  }

  function at(X, p) {
    return [0, 1, 2].map((i) => X[4 * i] * p[0] + X[4 * i + 1] * p[1] + X[4 * i + 2] * p[2] + X[4 * i + 3]);
  }

  function joint(kind, axis, q) {
    const [x, y, z] = axis;
    if (kind === "prismatic") return [1, 0, 0, q * x, 0, 1, 0, q * y, 0, 0, 1, q * z, 0, 0, 0, 1];
    const c = Math.cos(q);
    const s = Math.sin(q);
    const d = 1 - c;
    return [
      c + x * x * d, x * y * d - z * s, x * z * d + y * s, 0,
      y * x * d + z * s, c + y * y * d, y * z * d - x * s, 0,
      z * x * d - y * s, z * y * d + x * s, c + z * z * d, 0,
      0, 0, 0, 1,
    ];
  }

  // The row at or before a time, by halving.
  function rowAt(t, time) {
    let low = 0;
    let high = t.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (t[middle] <= time) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  // ------------------------------------------------------------------------------------------------- the motion

  class Motion {
    constructor(scene, cycle, decode) {
      this.scene = scene;
      this.name = cycle.name;
      this.t = decode(cycle.t).data;
      this.q = decode(cycle.q).data;
      this.axes = scene.axes.length;
      this.turned = cycle.turned ? decode(cycle.turned).data : null;
      this.path = decode(cycle.path).data;
      this.pathTimes = decode(cycle.path_t).data;
      this.driven = cycle.driven;
      this.tools = cycle.tools;
      this.end = this.t[this.t.length - 1];
    }

    // Axis positions, linear between rows; of positioners, how far they have turned since the start.
    joints(time, rows = this.q, axes = this.axes) {
      const now = Math.min(Math.max(time, this.t[0]), this.end);
      const i = Math.min(rowAt(this.t, now), Math.max(this.t.length - 2, 0));
      const j = Math.min(i + 1, this.t.length - 1);
      const share = j > i && this.t[j] > this.t[i] ? (now - this.t[i]) / (this.t[j] - this.t[i]) : 0;
      const out = [];
      for (let k = 0; k < axes; k++) out.push(rows[i * axes + k] * (1 - share) + rows[j * axes + k] * share);
      return out;
    }

    // How what positioners carry has moved in the world, by axis.
    tables(time) {
      const axes = this.scene.tables;
      const turned = this.turned ? this.joints(time, this.turned, axes.length) : axes.map(() => 0);
      const out = [];
      axes.forEach(({ parent, X, back, kind }, i) => {
        const own = times(times(X, joint(kind, [0, 0, 1], turned[i])), back);
        out.push(parent < 0 ? own : times(out[parent - this.scene.chain.length], own));
      });
      return out;
    }

    // Every frame of the chain in the world, the flange last.
    frames(time) {
      const q = this.joints(time);
      let X = this.scene.base;
      let next = 0;
      return this.scene.chain.map((one) => {
        X = times(X, one.placement);
        if (one.kind !== "fixed") {
          const less = one.less ? one.less * q[next - 1] : 0; // a parallel linkage
          X = times(X, joint(one.kind, one.axis, q[next++] - less));
        }
        return X;
      });
    }

    tool(time) {
      let found = this.tools[0].X;
      for (const one of this.tools) if (one.t <= Math.min(time, this.end)) found = one.X;
      return found;
    }

    pose(time) {
      const frames = this.frames(time);
      return times(frames[frames.length - 1], this.tool(time));
    }

    // When the tool is first as near to a point as it ever is, to a tenth of a millimetre.
    timeAt(point) {
      let [best, when] = [Infinity, 0];
      const p = (i) => [0, 1, 2].map((k) => this.path[3 * i + k]);
      for (let i = 0; i + 1 < this.pathTimes.length; i++) {
        const [a, b] = [p(i), p(i + 1)];
        const way = b.map((v, k) => v - a[k]);
        const long = dot(way, way);
        const share = long ? Math.min(Math.max(dot(way, point.map((v, k) => v - a[k])) / long, 0), 1) : 0;
        const away = Math.hypot(...point.map((v, k) => v - a[k] - share * way[k]));
        if (away < best - 1e-4) {
          [best, when] = [away, this.pathTimes[i] + share * (this.pathTimes[i + 1] - this.pathTimes[i])];
        }
      }
      return when;
    }

    isDriven(time) {
      return this.driven.some(([from, to]) => time >= from && time <= to);
    }
  }

  function cross(a, b) {
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  }

  class Camera {
    // all: what should be in sight; path: of it, where the tool goes, for a view of its own. along: the horizontal axis
    // that the front view has across the page.
    constructor(all, path, along) {
      this.sets = { all, path };
      this.fits = new Map();
      this.front = along === 1 ? 0 : -Math.PI / 2;
      this.preset("iso");
    }

    preset(name) {
      const ways = { iso: [-0.62, 0.36], front: [0, 0.06], side: [Math.PI / 2, 0.06], top: [0, Math.PI / 2 - 1e-3] };
      this.near = name === "path";
      this.points = this.near ? this.sets.path : this.sets.all;
      const [turn, up] = ways[name] || ways.iso;
      this.azimuth = this.front + turn;
      this.elevation = up;
      this.zoom = 1;
      this.shift = [0, 0];
    }

    orbit(turn, up) {
      this.azimuth -= turn;
      this.elevation = Math.min(Math.max(this.elevation + up, -1.2), Math.PI / 2 - 1e-3);
    }

    magnify(factor) {
      this.zoom = Math.min(Math.max(this.zoom * factor, 0.3), 12);
    }

    // Least distance from which all points lie within the field, and where the eye then stands across.
    fit(right, up, back, aspect, tall) {
      const key = `${this.near} ${this.azimuth} ${this.elevation} ${aspect}`;
      if (!this.fits.has(key)) {
        let [left, most, low, top, near, far, sum] = [Infinity, -Infinity, Infinity, -Infinity, Infinity, -Infinity, 0];
        for (const p of this.points) {
          const [x, y, d] = [dot(right, p), dot(up, p), dot(back, p)];
          // |x - middle| <= (distance - d) tall aspect for every point, from both sides; the same for y
          left = Math.min(left, x - d * tall * aspect);
          most = Math.max(most, x + d * tall * aspect);
          low = Math.min(low, y - d * tall);
          top = Math.max(top, y + d * tall);
          near = Math.min(near, -d);
          far = Math.max(far, -d);
          sum += d;
        }
        const distance = Math.max((most - left) / (2 * tall * aspect), (top - low) / (2 * tall));
        const middle = [(left + most) / 2, (low + top) / 2];
        if (this.fits.size > 8) this.fits.clear();
        this.fits.set(key, { distance, middle, focus: sum / this.points.length, near, far });
      }
      return this.fits.get(key);
    }

    // View and projection for a viewport [px]; everything is in sight where nobody has zoomed.
    look(width, height) {
      const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
      const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
      const back = [ce * ca, ce * sa, se];
      const right = [-sa, ca, 0];
      const up = cross(back, right);
      const aspect = width / height;
      const tall = Math.tan(FIELD / 2);
      const { distance, middle, focus, near, far } = this.fit(right, up, back, aspect, tall);
      const away = focus + (1.06 * (distance - focus)) / this.zoom;
      const eye = [0, 1, 2].map(
        (i) =>
          (middle[0] - this.shift[0]) * right[i] + (middle[1] - this.shift[1]) * up[i] + away * back[i],
      );
      const view = [
        ...right, -dot(right, eye), ...up, -dot(up, eye), ...back, -dot(back, eye), 0, 0, 0, 1,
      ];
      const from = Math.max(0.02, (away + near) * 0.4);
      const to = away + far + 20;
      const f = 1 / tall;
      const projection = [
        f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (to + from) / (from - to), (2 * to * from) / (from - to), 0, 0, -1, 0,
      ];
      return { view, projection, both: times(projection, view), perPixel: (2 * tall * (away - focus)) / height };
    }
  }

  function dot(a, b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  // Where a world point is in a viewport [px from its top left], null behind the camera.
  function onScreen(both, p, width, height) {
    const x = at(both, p);
    const w = both[12] * p[0] + both[13] * p[1] + both[14] * p[2] + both[15];
    return w > 1e-6 ? [((x[0] / w + 1) * width) / 2, ((1 - x[1] / w) * height) / 2] : null;
  }

  return { times, at, cross, Motion, Camera, onScreen };
})();
