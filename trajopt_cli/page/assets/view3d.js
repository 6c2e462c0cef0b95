// The 3-D view: robot, rail, path, points and obstacles of the chosen cycles side by side, each at its own time.
//
// TrajoptView3D.create(element, scene, options) -> {setTime(t), resize(), dispose(), select(cycles), theme(), describe(),
// poseOf(cycle, t) -> 16 numbers, the tool in the world row by row, timeAt(cycle, p) -> when it is nearest to a point}.
// scene: of page/scene.py. options: decode (of blocks), pick(point, cycle) for a click on a point. An element with
// data-scene gets data.scene, on the page's clock.
"use strict";
(() => {
  const { times, at, Motion, Camera, onScreen } = window.TrajoptView3DMotion;
  const { Graphics, triangles, reach } = window.TrajoptView3DGraphics;
  const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const COLORS = ["ground", "grid", "link", "link-2", "rail", "obstacle", "tool", "point", "x", "y", "z"];
  const GAP = 6; // px between the cycles
  const NARROW = 640; // px: below, the cycles stand below each other
  const PATH = 3.2; // px, where driven on lines and arcs
  const NEAR = 14; // px from the pointer to a point that is meant
  const VIEWS = [["iso", "Iso"], ["front", "Front"], ["side", "Side"], ["top", "Top"], ["path", "Path"]];
  const HELP = "Drag to turn, two fingers zoom; a tap or click on a point goes to when the tool is there.";
  const KEYS = " With Shift a drag moves. With the view in focus: arrow keys turn, + and − or the wheel zoom, 1 to 5 choose a view, 0 resets.";

  function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  function fixed(value, digits) {
    return value.toFixed(digits).replace(/^-(?=0(\.0*)?$)/, "").replace("-", "−");
  }

  // "#rrggbb" as numbers from 0 to 1.
  function rgb(text) {
    const found = /^#([0-9a-f]{6})$/i.exec(text.trim());
    if (!found) throw new Error(`3-D view: color "${text}", wanted #rrggbb`);
    return [0, 2, 4].map((i) => parseInt(found[1].slice(i, i + 2), 16) / 255);
  }

  class View {
    constructor(element, scene, options) {
      this.scene = scene;
      this.decode = options.decode || window.TrajoptPage.decode;
      this.pick = options.pick || (() => {});
      this.cycles = scene.cycles.map((one) => new Motion(scene, one, this.decode));
      this.shown = this.cycles.map((_, i) => i).slice(0, 2);
      this.foot = Math.min(...scene.bodies.filter((one) => one.role === "link").map((one) => one.link));
      this.time = 0;
      this.hover = null;
      this.held = -1;
      const extent = this.extent();
      this.floor = extent.floor;
      this.size = extent.size;
      this.middle = extent.middle;
      this.camera = new Camera(extent.points, extent.path, extent.along);
      this.build(element);
      this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
      this.canvas.addEventListener("webglcontextrestored", () => this.start());
      this.start();
      this.listen();
      this.renew();
    }

    // ------------------------------------------------------------------------------------------- what there is

    // Points around all that is ever in sight, the floor's height, the horizontal axis along it.
    extent() {
      const points = [];
      const path = [];
      const around = (inside, radius) => {
        const low = [0, 1, 2].map((i) => Math.min(...inside.map((p) => p[i])) - radius);
        const high = [0, 1, 2].map((i) => Math.max(...inside.map((p) => p[i])) + radius);
        for (let k = 0; k < (radius ? 8 : 0); k++) points.push([0, 1, 2].map((i) => ((k >> i) & 1 ? high[i] : low[i])));
        if (!radius) points.push(...inside);
      };
      const bodies = this.scene.bodies.map((one) => [one, ...reach(one, this.decode)]);
      for (const cycle of this.cycles) {
        for (let k = 0; k <= 24; k++) {
          const time = (cycle.end * k) / 24;
          const frames = cycle.frames(time);
          around([this.tcp(cycle, time)], 0.02);
          for (const [body, inside, radius] of bodies) {
            around(inside.map((p) => at(this.frame(frames, body.link, cycle, time), p)), radius);
          }
        }
        for (let i = 0; i + 2 < cycle.path.length; i += 30) path.push(Array.from(cycle.path.subarray(i, i + 3)));
      }
      path.push(...this.scene.points.map((one) => one.position));
      points.push(...path);
      for (const one of this.scene.static) around(reach(one, this.decode)[0], 0);
      if (!points.length) around([[0, 0, 0]], 0.5);
      const low = [0, 1, 2].map((i) => points.reduce((least, p) => Math.min(least, p[i]), Infinity));
      const high = [0, 1, 2].map((i) => points.reduce((most, p) => Math.max(most, p[i]), -Infinity));
      const stands = this.scene.static.filter((one) => one.role === "rail").flatMap((one) => reach(one, this.decode)[0]);
      const floor = stands.length ? Math.min(...stands.map((p) => p[2])) : this.scene.base[11];
      const size = Math.max(...high.map((v, i) => v - low[i]));
      const middle = high.map((v, i) => (v + low[i]) / 2);
      // room around the path for the tool and a part of the arm
      const wide = path.flatMap((p) => [p.map((v) => v - 0.06), p.map((v) => v + 0.06)]);
      return { points, path: wide, floor, size, middle, along: high[1] - low[1] > high[0] - low[0] ? 1 : 0 };
    }

    frame(frames, link, motion, time) {
      const chain = this.scene.chain.length;
      if (link >= chain) return motion.tables(time)[link - chain];
      return link < -1 ? IDENTITY : link < 0 ? this.scene.base : frames[link];
    }

    tcp(cycle, time) {
      const X = cycle.pose(time);
      return [X[3], X[7], X[11]];
    }

    // ------------------------------------------------------------------------------------------------- the page

    build(element) {
      this.canvas = make("canvas", { tabindex: "0", role: "application", "aria-roledescription": "3-D view" });
      this.canvas.className = "own-keys";
      this.tip = make("div", { class: "v3d-tip", "aria-hidden": "true", hidden: "" });
      this.stage = make("div", { class: "v3d-stage" }, this.canvas, this.tip);
      this.tools = make("div", { class: "v3d-tools", role: "toolbar", "aria-label": "3-D view" });
      this.buttons = VIEWS.map(([name, label]) => {
        const button = make("button", { type: "button", "aria-pressed": "false", "aria-label": `${label} view` }, label);
        button.addEventListener("click", () => this.preset(name));
        this.tools.append(button);
        return [name, button];
      });
      for (const [label, name, factor] of [["−", "Zoom out", 1 / 1.25], ["+", "Zoom in", 1.25]]) {
        const button = make("button", { type: "button", "aria-label": name, title: name }, label);
        button.addEventListener("click", () => this.magnify(factor));
        this.tools.append(button);
      }
      if (this.scene.points.length) {
        const choice = make("select", {}, make("option", { value: "-1" }, "none"));
        this.scene.points.forEach((one, i) => choice.append(make("option", { value: String(i) }, one.name)));
        choice.addEventListener("change", () => {
          this.held = Number(choice.value);
          this.renew();
        });
        this.tools.append(make("label", {}, "Show point ", choice));
      }
      this.live = make("p", { class: "v3d-hidden", "aria-live": "polite" });
      this.help = make("p", { class: "v3d-help" }, HELP, make("span", { class: "keys" }, KEYS));
      this.root = make("div", { class: "v3d" }, this.stage, this.tools, this.help, this.live);
      element.append(this.root);
      this.tag();
    }

    // Names and times over the cycles.
    tag() {
      for (const one of this.tags || []) one.box.remove();
      this.tags = this.shown.map((i, k) => {
        const clock = make("span");
        const name = make("b", { class: `key ${this.looks(k)}` }, this.cycles[i].name);
        const box = make("div", { class: "v3d-tag", "aria-hidden": "true" }, name, clock);
        this.stage.append(box);
        return { box, clock };
      });
    }

    // The first of two is the one before, as in the charts.
    looks(k) {
      return this.shown.length > 1 && k === 0 ? "before" : "after";
    }

    start() {
      const gl = this.canvas.getContext("webgl", { antialias: true, alpha: false, stencil: true });
      this.graphics = gl ? new Graphics(gl) : null;
      this.flat = gl ? null : this.canvas.getContext("2d");
      this.colors();
      if (!gl) {
        this.help.append(" This browser has no WebGL: the arm is drawn as lines.");
        return;
      }
      const drawn = (one) => ({ ...one, buffer: this.graphics.shape(triangles(one, this.decode)) });
      this.bodies = this.scene.bodies.map(drawn);
      this.statics = this.scene.static.map(drawn);
      this.parts = this.scene.cycles.map((cycle) => (cycle.parts || []).map(drawn));
      this.grid = this.graphics.ribbons(this.raster());
      this.paths = this.cycles.map((cycle) => this.graphics.ribbons(this.way(cycle)));
      const places = (added) => this.scene.points.filter((one) => Boolean(one.added) === added).flatMap((one) => one.position);
      [this.dots, this.added] = [false, true].map((added) => this.graphics.buffer(places(added), { position: 3 }));
      const unit = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
      this.triad = unit.map((p) => this.graphics.ribbons([[[0, 0, 0], p, 1, 1, -1]]));
      this.rod = this.graphics.ribbons([[[0, 0, 0], [0, 0, 1], 1, 1, -1]]);
      this.spot = this.graphics.buffer([0, 0, 0], { position: 3 });
    }

    colors() {
      const style = getComputedStyle(document.documentElement);
      const read = (name) => rgb(style.getPropertyValue(name));
      this.ink = Object.fromEntries(COLORS.map((name) => [name, read(`--v3d-${name}`)]));
      for (const name of ["before", "after", "paper"]) this.ink[name] = read(`--${name}`);
      if (this.scene.colour) {
        this.ink.link = rgb(this.scene.colour);
        this.ink["link-2"] = this.ink.link.map((v) => 0.92 * v);
      }
    }

    // Lines of the floor, fading outward, in pieces so that none passes behind the eye.
    raster() {
      const step = this.size > 4 ? 0.5 : 0.25;
      const half = Math.ceil((0.9 * this.size) / step);
      const [x, y] = [0, 1].map((i) => Math.round(this.middle[i] / step));
      const out = [];
      for (let i = -half; i <= half; i++) {
        for (let j = -half; j < half; j++) {
          const fade = Math.max(0, 1 - Math.hypot(i, j + 0.5) / half);
          if (!fade) continue;
          const p = (a, b) => [(x + a) * step, (y + b) * step, this.floor];
          out.push([p(i, j), p(i, j + 1), 1, fade, -1], [p(j, i), p(j + 1, i), 1, fade, -1]);
        }
      }
      return out;
    }

    way(cycle) {
      const out = [];
      const point = (i) => Array.from(cycle.path.subarray(3 * i, 3 * i + 3));
      for (let i = 0; i + 1 < cycle.pathTimes.length; i++) {
        const [from, to] = [cycle.pathTimes[i], cycle.pathTimes[i + 1]];
        const driven = cycle.isDriven((from + to) / 2);
        const [a, b] = [point(i), point(i + 1)];
        if (a.some((v, k) => v !== b[k])) out.push([a, b, driven ? 1 : 0.5, driven ? 1 : 0.7, from]);
      }
      return out;
    }

    // ------------------------------------------------------------------------------------------------- the input

    listen() {
      const pointers = new Map();
      const canvas = this.canvas;
      const place = (event) => {
        const box = canvas.getBoundingClientRect();
        return [event.clientX - box.left, event.clientY - box.top];
      };
      canvas.addEventListener("pointerdown", (event) => {
        canvas.setPointerCapture(event.pointerId);
        pointers.set(event.pointerId, place(event));
        this.moved = 0;
      });
      canvas.addEventListener("pointermove", (event) => {
        const now = place(event);
        const before = pointers.get(event.pointerId);
        if (!before) return this.point(now);
        const [dx, dy] = [now[0] - before[0], now[1] - before[1]];
        this.moved += Math.abs(dx) + Math.abs(dy);
        const others = [...pointers].filter(([id]) => id !== event.pointerId).map(([, p]) => p);
        pointers.set(event.pointerId, now);
        if (others.length) {
          const apart = (p) => Math.hypot(p[0] - others[0][0], p[1] - others[0][1]) || 1;
          this.camera.magnify(apart(now) / apart(before));
          this.camera.orbit(0.005 * dx, 0.005 * dy);
        } else if (event.shiftKey || event.buttons & 6) {
          this.camera.shift[0] += dx * this.perPixel;
          this.camera.shift[1] -= dy * this.perPixel;
        } else {
          this.camera.orbit(0.008 * dx, 0.008 * dy);
        }
        this.free();
        return undefined;
      });
      const up = (event) => {
        const clicked = pointers.delete(event.pointerId) && event.type === "pointerup" && this.moved < 4;
        if (clicked && this.hover) this.pick(this.scene.points[this.hover.point], this.shown[this.hover.port]);
      };
      canvas.addEventListener("pointerup", up);
      canvas.addEventListener("pointercancel", up);
      canvas.addEventListener("pointerleave", () => this.point(null));
      canvas.addEventListener("contextmenu", (event) => event.shiftKey || event.preventDefault());
      canvas.addEventListener(
        "wheel",
        (event) => {
          if (document.activeElement !== canvas && !event.ctrlKey) return; // else the page could not be scrolled past
          event.preventDefault();
          this.magnify(Math.exp(-Math.sign(event.deltaY) * Math.min(Math.abs(event.deltaY), 100) * 0.0022));
        },
        { passive: false },
      );
      canvas.addEventListener("keydown", (event) => this.key(event));
      this.watch = new ResizeObserver(() => this.resize());
      this.watch.observe(this.stage);
    }

    key(event) {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const turn = 0.09;
      const acts = {
        ArrowLeft: () => this.camera.orbit(-turn, 0),
        ArrowRight: () => this.camera.orbit(turn, 0),
        ArrowUp: () => this.camera.orbit(0, turn),
        ArrowDown: () => this.camera.orbit(0, -turn),
        "+": () => this.camera.magnify(1.25),
        "=": () => this.camera.magnify(1.25),
        "-": () => this.camera.magnify(1 / 1.25),
      };
      VIEWS.forEach(([name], i) => (acts[i + 1] = () => this.preset(name)));
      acts[0] = acts[1];
      if (!acts[event.key]) return;
      event.preventDefault(); // the page's own keys mean its time
      acts[event.key]();
      if (!(event.key >= "0" && event.key <= "9")) this.free();
    }

    preset(name) {
      this.camera.preset(name);
      for (const [one, button] of this.buttons) button.setAttribute("aria-pressed", String(one === name));
      this.renew();
    }

    magnify(factor) {
      this.camera.magnify(factor);
      this.renew();
    }

    // Turned by hand: none of the views any more.
    free() {
      for (const [, button] of this.buttons) button.setAttribute("aria-pressed", "false");
      this.renew();
    }

    // The point of the program nearest to the pointer.
    point(place) {
      let found = null;
      for (const [k, port] of place ? this.ports.entries() : []) {
        const [x, y] = [place[0] - port.x, place[1] - port.y];
        if (x < 0 || y < 0 || x > port.width || y > port.height) continue;
        let best = NEAR;
        this.scene.points.forEach((one, i) => {
          const s = onScreen(port.look.both, one.position, port.width, port.height);
          const away = s ? Math.hypot(s[0] - x, s[1] - y) : Infinity;
          if (away < best) [best, found] = [away, { point: i, port: k }];
        });
      }
      if (found?.point !== this.hover?.point || found?.port !== this.hover?.port) {
        this.hover = found;
        this.renew();
      }
    }

    // ------------------------------------------------------------------------------------------------ the picture

    renew() {
      if (this.asked) return;
      this.asked = requestAnimationFrame(() => {
        this.asked = 0;
        this.draw();
      });
    }

    resize() {
      this.renew();
    }

    layout() {
      const width = Math.max(this.stage.clientWidth, 1);
      const count = Math.max(this.shown.length, 1);
      const stacked = width < NARROW;
      const one = stacked ? width : (width - GAP * (count - 1)) / count;
      const full = Math.min(Math.max(one * 0.78, 240), 520);
      const tall = Math.round(Math.max(Math.min(full, this.room(stacked ? count : 1)), Math.min(full, 190)));
      const height = stacked ? (tall + GAP) * count - GAP : tall;
      if (this.stage.style.height !== `${height}px`) this.stage.style.height = `${height}px`;
      const sharp = Math.min(window.devicePixelRatio || 1, 2);
      const [w, h] = [Math.round(width * sharp), Math.round(height * sharp)];
      if (this.canvas.width !== w || this.canvas.height !== h) {
        this.canvas.width = w;
        this.canvas.height = h;
      }
      this.sharp = sharp;
      this.ports = this.shown.map((cycle, k) => {
        const port = stacked
          ? { x: 0, y: k * (tall + GAP), width, height: tall }
          : { x: k * (one + GAP), y: 0, width: one, height: tall };
        return { ...port, cycle, look: this.camera.look(port.width, port.height) };
      });
      this.perPixel = this.ports.length ? this.ports[0].look.perPixel : 0;
    }

    // The height for each of so many rows [px], so that all of them are in sight above what is fixed to the foot.
    room(rows) {
      const { clientHeight } = document.documentElement;
      const top = this.stage.getBoundingClientRect().top + window.scrollY;
      const foot = document.getElementById("transport")?.offsetHeight || 0;
      const whole = clientHeight - foot - (rows > 1 ? GAP : this.tools.offsetHeight + 2 * GAP);
      return (top < 0.6 * whole ? whole - top : whole) / rows - GAP;
    }

    draw() {
      this.layout();
      if (this.graphics) this.clear();
      for (const [k, port] of this.ports.entries()) {
        if (this.graphics) this.paint(port, this.ink[this.looks(k)]);
        else this.sketch(port, k);
        const cycle = this.cycles[port.cycle];
        const { box, clock } = this.tags[k];
        box.style.left = `${port.x + 8}px`;
        box.style.top = `${port.y + 8}px`;
        clock.textContent = ` ${fixed(Math.min(this.time, cycle.end), 2)} of ${fixed(cycle.end, 2)} s`;
      }
      this.label();
    }

    clear() {
      const gl = this.graphics.gl;
      gl.disable(gl.SCISSOR_TEST);
      gl.clearColor(...this.ink.paper, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT | gl.STENCIL_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
      gl.enable(gl.SCISSOR_TEST);
    }

    paint({ x, y, width, height, cycle, look }, way) {
      const { graphics: g, ink, sharp } = this;
      const gl = g.gl;
      const box = [x * sharp, this.canvas.height - (y + height) * sharp, width * sharp, height * sharp].map(Math.round);
      gl.viewport(...box);
      gl.scissor(...box);
      gl.clearColor(...ink.ground, 1);
      gl.clear(gl.COLOR_BUFFER_BIT);
      const motion = this.cycles[cycle];
      const frames = motion.frames(this.time);
      const flange = frames[frames.length - 1];
      const X_WT = times(flange, motion.tool(this.time));
      const port = [box[2], box[3]];
      const { both, view, projection } = look;
      const solid = (one, X, color, opacity = 1) => {
        g.use(g.solid, { model: X, view, projection, color: [...color, opacity], lit: 1, least: this.least(one) });
        g.draw(g.solid, one.buffer);
      };
      const stroke = (ribbons, X, color, width, opacity = 1, now = 1e9) => {
        g.use(g.stroke, { both: times(both, X), port, color: [...color, opacity], width: width * sharp, now });
        g.draw(g.stroke, ribbons);
      };
      const dots = (buffer, X, color, size) => {
        g.use(g.dot, { both: times(both, X), size: size * sharp, color: [...color, 1], rim: [...ink.ground, 0.9] });
        g.draw(g.dot, buffer, gl.POINTS);
      };
      const parts = this.parts[cycle].filter((one) => one.from <= this.time && this.time < one.to);
      const placed = (one) => [one, times(this.frame(frames, one.link, motion, this.time), one.X || IDENTITY)];
      const links = [...this.bodies, ...parts].map(placed);

      gl.depthMask(false);
      stroke(this.grid, IDENTITY, ink.grid, 1.1);
      this.shadow(links, view, projection);
      gl.depthMask(true);
      for (const one of this.statics) if (one.role !== "obstacle") solid(one, one.X || IDENTITY, ink.rail);
      for (const [one, X] of links) {
        const color = one.role === "link" ? ink[one.link & 1 ? "link-2" : "link"] : ink[{ tool: "tool", part: "obstacle", obstacle: "obstacle" }[one.role] || "rail"];
        solid(one, X, color);
      }
      const rod = this.rodTo(motion.tool(this.time));
      if (rod) stroke(this.rod, times(flange, rod), ink.tool, 4);
      // What is behind something shows through a little.
      for (const [how, opacity] of [[gl.GREATER, 0.22], [gl.LEQUAL, 1]]) {
        gl.depthFunc(how);
        gl.depthMask(how === gl.LEQUAL);
        for (const [k, other] of this.shown.entries()) {
          if (other !== cycle) stroke(this.paths[other], IDENTITY, this.ink[this.looks(k)], 0.5 * PATH, 0.5 * opacity);
        }
        stroke(this.paths[cycle], IDENTITY, way, PATH, opacity, this.time);
      }
      dots(this.dots, IDENTITY, ink.point, 9);
      dots(this.added, IDENTITY, ink.x, 9);
      gl.depthMask(false);
      for (const one of this.statics) if (one.role === "obstacle") solid(one, one.X || IDENTITY, ink.obstacle, 0.34);
      gl.depthMask(true);
      const length = Math.min(Math.max(0.06 * this.size, 0.05), 0.12);
      const scale = [length, 0, 0, 0, 0, length, 0, 0, 0, 0, length, 0, 0, 0, 0, 1];
      gl.disable(gl.DEPTH_TEST);
      this.triad.forEach((axis, i) => stroke(axis, times(X_WT, scale), ink["xyz"[i]], 3));
      dots(this.spot, X_WT, way, 8);
      gl.enable(gl.DEPTH_TEST);
    }

    // The capsule of the arm's base is larger than the base; what of it lies below the mounting plane is not drawn.
    least(one) {
      return one.role === "link" && one.link === this.foot ? 0 : -1e9;
    }

    // What brings the unit rod along z from the flange to the tool's point; null where they meet.
    rodTo(X_FT) {
      const p = [X_FT[3], X_FT[7], X_FT[11]];
      return Math.hypot(...p) > 1e-4 ? [1, 0, p[0], 0, 0, 1, p[1], 0, 0, 0, p[2], 0, 0, 0, 0, 1] : null;
    }

    // Straight down on the floor, dark once however much lies above.
    shadow(links, view, projection) {
      const gl = this.graphics.gl;
      const down = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, this.floor + 0.001, 0, 0, 0, 1];
      gl.enable(gl.STENCIL_TEST);
      gl.stencilFunc(gl.EQUAL, 0, 255);
      gl.stencilOp(gl.KEEP, gl.KEEP, gl.INCR);
      for (const [one, X] of links) {
        const uniforms = { model: times(down, X), view, projection, color: [0, 0, 0, 0.13], lit: 0, least: this.least(one) };
        this.graphics.use(this.graphics.solid, uniforms);
        this.graphics.draw(this.graphics.solid, one.buffer);
      }
      gl.disable(gl.STENCIL_TEST);
    }

    // Without WebGL: centre lines, path and points, in the same projection.
    sketch({ x, y, width, height, cycle, look }, k) {
      const pen = this.flat;
      const css = (color) => `rgb(${color.map((v) => Math.round(255 * v)).join(" ")})`;
      pen.setTransform(this.sharp, 0, 0, this.sharp, x * this.sharp, y * this.sharp);
      pen.fillStyle = css(this.ink.ground);
      pen.fillRect(0, 0, width, height);
      const line = (points, color, thick) => {
        pen.beginPath();
        for (const p of points) {
          const s = onScreen(look.both, p, width, height);
          if (s) pen.lineTo(...s);
        }
        pen.strokeStyle = css(color);
        pen.lineWidth = thick;
        pen.stroke();
      };
      const motion = this.cycles[cycle];
      const frames = [this.scene.base, ...motion.frames(this.time)].map((X) => [X[3], X[7], X[11]]);
      for (const one of this.scene.static) {
        const c = reach(one, this.decode)[0];
        for (let a = 0; a < c.length; a++) {
          for (let i = 1; i < c.length; i *= 2) if (!(a & i)) line([c[a], c[a | i]], this.ink[one.role], 1);
        }
      }
      const path = [];
      for (let i = 0; i + 2 < motion.path.length; i += 3) path.push(Array.from(motion.path.subarray(i, i + 3)));
      line(path, this.ink[this.looks(k)], 1);
      line(frames, this.ink.link, 7);
      line([frames[frames.length - 1], this.tcp(motion, this.time)], this.ink.tool, 3);
    }

    // The name of the point under the pointer, or of the one that was chosen.
    label() {
      const told = this.hover || (this.held >= 0 && this.ports.length ? { point: this.held, port: 0 } : null);
      this.tip.hidden = !told;
      this.canvas.style.cursor = this.hover ? "pointer" : "";
      if (!told) return;
      const one = this.scene.points[told.point];
      const port = this.ports[told.port];
      const [x, y, z] = one.position.map((v) => fixed(1000 * v, 1));
      this.tip.textContent = `${one.name} (${x}, ${y}, ${z}) mm${one.place ? ` · ${one.place}` : ""}${one.added ? " · added" : ""}`;
      const s = onScreen(port.look.both, one.position, port.width, port.height) || [0, 0];
      const wide = this.tip.offsetWidth;
      const left = Math.min(Math.max(port.x + s[0] - wide / 2, 4), this.stage.clientWidth - wide - 4);
      this.tip.style.left = `${Math.max(left, 4)}px`;
      this.tip.style.top = `${Math.max(port.y + s[1] - this.tip.offsetHeight - 12, 4)}px`;
    }

    // -------------------------------------------------------------------------------------------------- the words

    describe() {
      const told = this.shown.map((i) => {
        const cycle = this.cycles[i];
        const q = cycle.joints(this.time);
        const [x, y, z] = this.tcp(cycle, this.time).map((v) => fixed(1000 * v, 0));
        const kinds = this.scene.chain.filter((one) => one.kind !== "fixed");
        const axes = kinds.map((one, k) =>
          one.kind === "prismatic"
            ? `${one.name} ${fixed(1000 * q[k], 0)} mm`
            : `${one.name} ${fixed((q[k] * 180) / Math.PI, 1)}°`,
        );
        const now = fixed(Math.min(this.time, cycle.end), 2);
        return `${cycle.name} at ${now} s: tool at x ${x}, y ${y}, z ${z} mm; ${axes.join(", ").replaceAll("_", " ")}.`;
      });
      return told.join(" ");
    }

    // A screen reader is told where the arm stands once it has stood there for a moment.
    tell() {
      clearTimeout(this.waiting);
      this.waiting = setTimeout(() => {
        const text = this.describe();
        if (this.live.textContent && this.live.textContent !== text) this.live.textContent = text;
        else if (!this.live.textContent) this.live.textContent = text;
        this.canvas.setAttribute("aria-label", `Arm in space. ${text}`);
      }, 700);
    }

    setTime(time) {
      this.time = time;
      this.renew();
      this.tell();
    }

    select(shown) {
      this.shown = shown;
      this.tag();
      this.renew();
      this.tell();
    }

    theme() {
      this.colors();
      this.renew();
    }

    dispose() {
      cancelAnimationFrame(this.asked);
      clearTimeout(this.waiting);
      this.watch.disconnect();
      this.root.remove();
    }
  }

  function create(element, scene, options = {}) {
    const view = new View(element, scene, options);
    view.canvas.setAttribute("aria-label", `Arm in space. ${view.describe()}`);
    return {
      setTime: (time) => view.setTime(time),
      resize: () => view.resize(),
      dispose: () => view.dispose(),
      timeAt: (cycle, point) => view.cycles[cycle].timeAt(point),
      poseOf: (cycle, time = view.time) => view.cycles[cycle].pose(time),
      describe: () => view.describe(),
      select: (cycles) => view.select(cycles),
      theme: () => view.theme(),
    };
  }

  window.TrajoptView3D = { create };
  if (window.TrajoptPage) {
    window.TrajoptPage.register(() => {
      const page = window.TrajoptPage;
      for (const element of document.querySelectorAll("[data-scene]")) {
        const pick = (point, cycle) => page.clock.seek(view.timeAt(cycle, point.position));
        const view = create(element, page.data.scene, { pick });
        page.view3d = view;
        view.select(page.selection.shown);
        page.clock.on((time) => view.setTime(time));
        page.on("selection", (shown) => view.select(shown));
        page.on("theme", () => view.theme());
      }
    });
  }
})();
