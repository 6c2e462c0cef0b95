// Charts over time on canvas: a Panel has the time axis, zoom, pointer and cursor; LineChart draws curves into it.
//
// data.charts[name] draws itself in <figure data-chart="name">:
//   {title, unit, digits, zero, height, series: [{name, t: "array", y: "array", column, scale, style, cycle}],
//    limits: [{value, name}], spans: [[from, to]], alerts: [[from, to]], steps: [{from, to, y}], marks: [{t, to, low, high}], points: [{t, y}]}
// where t and y name blocks in data.arrays. style: "before", "after" or "a" to "f".
"use strict";
(() => {
  const page = window.TrajoptPage;
  const { clock, zoom, make, figure, color } = page;
  const GAP = { left: 54, right: 12, top: 8, bottom: 22 };
  const STYLES = {
    before: { color: "before", dash: [5, 3], width: 1.4 },
    after: { color: "after", dash: [], width: 1.7 },
    a: { color: "ink", dash: [], width: 1.5 },
    b: { color: "vermillion", dash: [6, 2], width: 1.5 },
    c: { color: "blue", dash: [2, 2], width: 1.5 },
    d: { color: "green", dash: [6, 2, 2, 2], width: 1.5 },
    e: { color: "purple", dash: [], width: 1.5 },
    f: { color: "orange", dash: [3, 2], width: 1.5 },
  };

  // Round numbers within low..high, about count of them.
  function ticks(low, high, count) {
    const rough = (high - low) / Math.max(count, 1);
    if (!(rough > 0)) return { values: [low], digits: 3 };
    const power = 10 ** Math.floor(Math.log10(rough));
    const steps = [0.2, 0.5, 1, 2, 5, 10].map((f) => f * power);
    const within = (step) => Math.floor(high / step + 1e-9) - Math.ceil(low / step - 1e-9) + 1;
    let k = steps.findIndex((s) => s >= rough * 0.999);
    while (k > 0 && within(steps[k]) < 2) k--; // one figure says nothing of a scale
    const step = steps[k];
    const values = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) values.push(i * step);
    return { values, digits: Math.max(0, -Math.floor(Math.log10(step) + 1e-9)) };
  }

  // The last index of t (sorted) that is not after time; -1 before the first.
  function last(t, time) {
    let a = 0;
    let b = t.length;
    while (a < b) {
      const m = (a + b) >> 1;
      if (t[m] <= time) a = m + 1;
      else b = m;
    }
    return a - 1;
  }

  class Panel {
    constructor(host, { label, height = 170, left = GAP.left }) {
      this.left = left;
      this.canvas = make("canvas", { role: "img", tabindex: "0", "aria-label": label, height });
      this.cursor = make("div", { class: "cursor", "aria-hidden": "true" });
      this.brush = make("div", { class: "brush", "aria-hidden": "true", hidden: true });
      this.box = make("div", { class: "panel" }, this.canvas, this.cursor, this.brush);
      this.height = height;
      this.box.style.height = `${height}px`;
      host.append(this.box);
      this.hover = null;
      this.dirty = true;
      this.seen = false;
      this.offs = [
        page.on("zoom", () => this.renew()),
        page.on("theme", () => this.renew()),
        clock.on((time) => this.place(time)),
      ];
      this.sight = new IntersectionObserver((entries) => {
        this.seen = entries[entries.length - 1].isIntersecting;
        if (this.seen && this.dirty) this.renew();
      }, { rootMargin: "200px" });
      this.sight.observe(this.box);
      this.size = new ResizeObserver(() => this.renew());
      this.size.observe(this.box);
      this.listen();
    }

    dispose() {
      this.offs.forEach((off) => off());
      this.sight.disconnect();
      this.size.disconnect();
      this.box.remove();
    }

    get width() {
      return this.box.clientWidth;
    }

    x(time) {
      const span = zoom.to - zoom.from || 1;
      return this.left + ((time - zoom.from) / span) * (this.width - this.left - GAP.right);
    }

    timeAt(x) {
      const share = (x - this.left) / (this.width - this.left - GAP.right);
      return zoom.from + Math.min(Math.max(share, 0), 1) * (zoom.to - zoom.from);
    }

    // Draw in the next frame, or when it comes into sight.
    renew() {
      this.dirty = true;
      if (!this.seen || this.asked) return;
      this.asked = true;
      requestAnimationFrame(() => {
        this.asked = false;
        if (this.dirty && this.box.isConnected && this.width > this.left + GAP.right) this.paint();
      });
    }

    paint() {
      this.dirty = false;
      const ratio = window.devicePixelRatio || 1;
      const width = this.width;
      this.canvas.width = Math.round(width * ratio);
      this.canvas.height = Math.round(this.height * ratio);
      const pen = this.canvas.getContext("2d");
      pen.setTransform(ratio, 0, 0, ratio, 0, 0);
      pen.clearRect(0, 0, width, this.height);
      pen.font = `11px ${getComputedStyle(document.body).fontFamily}`;
      this.pen = pen;
      this.area = { x0: this.left, x1: width - GAP.right, y0: GAP.top, y1: this.height - GAP.bottom };
      this.timeAxis();
      this.draw(pen, this.area);
      this.place(clock.time);
    }

    timeAxis() {
      const { pen, area } = this;
      const { values, digits } = ticks(zoom.from, zoom.to, Math.max(2, Math.floor((area.x1 - area.x0) / 62)));
      pen.strokeStyle = color("grid");
      pen.fillStyle = color("ink-2");
      pen.lineWidth = 1;
      pen.textBaseline = "top";
      pen.textAlign = "center";
      values.forEach((value) => {
        const x = Math.round(this.x(value)) + 0.5;
        pen.beginPath();
        pen.moveTo(x, area.y0);
        pen.lineTo(x, area.y1);
        pen.stroke();
        const text = figure(value, digits);
        const half = pen.measureText(text).width / 2 + 2;
        pen.fillText(text, Math.min(Math.max(x, half), this.width - half), area.y1 + 6);
      });
      pen.textAlign = "right";
      const end = values.length ? this.x(values[values.length - 1]) : area.x0;
      if (area.x1 - end > 26) pen.fillText("s", area.x1, area.y1 + 6);
    }

    place(time) {
      if (!this.seen || !this.area) return;
      const inside = time >= zoom.from - 1e-9 && time <= zoom.to + 1e-9;
      this.cursor.hidden = !inside;
      if (inside) this.cursor.style.transform = `translateX(${this.x(time)}px)`;
      this.read(this.hover === null ? time : this.hover);
    }

    // What subclasses say and do.
    draw() {}
    read() {}
    pressed(time) {
      clock.seek(time);
    }

    listen() {
      const { canvas } = this;
      const touches = new Map();
      let start = null;
      let pinch = null;
      const local = (event) => event.clientX - canvas.getBoundingClientRect().left;
      canvas.addEventListener("pointerdown", (event) => {
        if (event.button) return;
        touches.set(event.pointerId, local(event));
        canvas.setPointerCapture(event.pointerId);
        if (touches.size === 2) {
          const [a, b] = [...touches.values()];
          pinch = { gap: Math.max(Math.abs(a - b), 10), from: zoom.from, to: zoom.to, at: this.timeAt((a + b) / 2) };
          start = null;
        } else start = { x: local(event), y: event.offsetY, touch: event.pointerType === "touch", moved: false };
      });
      canvas.addEventListener("pointermove", (event) => {
        const x = local(event);
        if (touches.has(event.pointerId)) touches.set(event.pointerId, x);
        if (pinch && touches.size === 2) {
          const [a, b] = [...touches.values()];
          const factor = pinch.gap / Math.max(Math.abs(a - b), 10);
          zoom.set(pinch.at - (pinch.at - pinch.from) * factor, pinch.at + (pinch.to - pinch.at) * factor);
        } else if (start) {
          start.moved ||= Math.abs(x - start.x) > 4;
          if (start.moved && start.touch) clock.seek(this.timeAt(x));
          else if (start.moved) {
            const [a, b] = [start.x, x].sort((p, q) => p - q);
            this.brush.hidden = false;
            this.brush.style.transform = `translateX(${a}px)`;
            this.brush.style.width = `${b - a}px`;
          }
        } else {
          this.hover = this.timeAt(x);
          this.over(this.hover, event.offsetY);
          this.read(this.hover);
        }
      });
      const up = (event) => {
        touches.delete(event.pointerId);
        if (pinch) {
          if (touches.size === 0) pinch = null;
        } else if (start && event.type === "pointerup") {
          const x = local(event);
          if (!start.moved) this.pressed(this.timeAt(x), start.y);
          else if (!start.touch) zoom.set(...[this.timeAt(start.x), this.timeAt(x)].sort((a, b) => a - b));
        }
        start = null;
        this.brush.hidden = true;
      };
      canvas.addEventListener("pointerup", up);
      canvas.addEventListener("pointercancel", up);
      canvas.addEventListener("pointerleave", () => {
        this.hover = null;
        this.read(clock.time);
      });
      canvas.addEventListener("dblclick", () => zoom.all());
      // The wheel scrolls the page; over a chart that has the focus, or with Ctrl, it zooms.
      canvas.addEventListener("wheel", (event) => {
        if (!event.ctrlKey && document.activeElement !== canvas) return;
        event.preventDefault();
        if (Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
          const by = (event.deltaX / this.width) * (zoom.to - zoom.from);
          zoom.set(zoom.from + by, zoom.to + by);
        } else zoom.by(1.0015 ** event.deltaY, this.timeAt(local(event)));
      }, { passive: false });
    }

    over() {}
  }

  class LineChart {
    // spec: as data.charts, but t and y are arrays: series [{name, t, y, stride, offset, scale, style}].
    constructor(host, spec) {
      this.spec = spec;
      this.outputs = spec.series.map((one) => make("output", { class: `key ${one.style}`, "aria-live": "off" }));
      const head = make("figcaption", {}, make("b", {}, spec.title), make("span", { class: "unit" }, spec.unit || ""), ...this.outputs);
      host.replaceChildren(head);
      const chart = this;
      this.panel = new (class extends Panel {
        draw(pen, area) {
          chart.draw(pen, area);
        }
        read(time) {
          chart.read(time);
        }
      })(host, { label: spec.label || spec.title, height: spec.height });
    }

    dispose() {
      this.panel.dispose();
    }

    value(one, i) {
      return one.y[i * (one.stride || 1) + (one.offset || 0)] * (one.scale || 1);
    }

    // Linear between samples; the end after the end.
    at(one, time) {
      const i = last(one.t, time);
      if (i < 0) return this.value(one, 0);
      if (i >= one.t.length - 1) return this.value(one, one.t.length - 1);
      const gap = one.t[i + 1] - one.t[i];
      const share = gap > 0 ? (time - one.t[i]) / gap : 0;
      return this.value(one, i) * (1 - share) + this.value(one, i + 1) * share;
    }

    read(time) {
      const digits = this.spec.digits ?? 1;
      this.spec.series.forEach((one, k) => {
        const text = `${one.name} ${figure(this.at(one, time), digits)}`;
        if (this.outputs[k].textContent !== text) this.outputs[k].textContent = text;
      });
    }

    range() {
      if (this.spec.range) return this.spec.range;
      let low = Infinity;
      let high = -Infinity;
      const take = (value) => {
        low = Math.min(low, value);
        high = Math.max(high, value);
      };
      for (const one of this.spec.series) for (let i = 0; i < one.t.length; i++) take(this.value(one, i));
      for (const one of this.spec.limits || []) take(one.value);
      for (const one of this.spec.steps || []) take(one.y);
      for (const one of this.spec.marks || []) (take(one.low), take(one.high));
      for (const one of this.spec.points || []) take(one.y);
      if (this.spec.zero) take(0);
      if (!(high > low)) [low, high] = [low - 1, high + 1];
      const room = 0.06 * (high - low);
      this.spec.range = [this.spec.zero && low >= 0 ? low : low - room, high + room];
      return this.spec.range;
    }

    draw(pen, area) {
      const [low, high] = this.range();
      const y = (value) => area.y1 - ((value - low) / (high - low)) * (area.y1 - area.y0);
      const x = (time) => this.panel.x(time);
      const { spec } = this;
      const { values, digits } = ticks(low, high, Math.max(3, Math.floor((area.y1 - area.y0) / 28)));
      pen.textAlign = "right";
      pen.textBaseline = "middle";
      for (const value of values) {
        const row = Math.round(y(value)) + 0.5;
        if (row < area.y0 - 1 || row > area.y1 + 1) continue;
        pen.strokeStyle = color(value === 0 ? "axis" : "grid");
        pen.beginPath();
        pen.moveTo(area.x0, row);
        pen.lineTo(area.x1, row);
        pen.stroke();
        pen.fillStyle = color("ink-2");
        pen.fillText(figure(value, digits), area.x0 - 7, row);
      }
      pen.save();
      pen.beginPath();
      pen.rect(area.x0, area.y0 - 2, area.x1 - area.x0, area.y1 - area.y0 + 4);
      pen.clip();
      pen.fillStyle = color("wait");
      for (const [from, to] of spec.spans || []) pen.fillRect(x(from), area.y0, Math.max(x(to) - x(from), 1), area.y1 - area.y0);
      pen.fillStyle = color("alert");
      for (const [from, to] of spec.alerts || []) pen.fillRect(x(from), area.y0, Math.max(x(to) - x(from), 1), area.y1 - area.y0);
      this.marks(pen, x, y);
      this.limits(pen, area, y);
      pen.setLineDash([]);
      pen.strokeStyle = color("vermillion");
      pen.lineWidth = 2;
      for (const one of spec.steps || []) {
        pen.beginPath();
        pen.moveTo(x(one.from), y(one.y));
        pen.lineTo(Math.max(x(one.to), x(one.from) + 1), y(one.y));
        pen.stroke();
      }
      for (const one of spec.series) this.curve(pen, one, x, y, area);
      pen.setLineDash([]);
      pen.strokeStyle = color("vermillion");
      pen.lineWidth = 2;
      for (const one of spec.points || []) {
        const [a, b] = [x(one.t), y(one.y)];
        pen.beginPath();
        pen.moveTo(a - 4, b - 4);
        pen.lineTo(a + 4, b + 4);
        pen.moveTo(a - 4, b + 4);
        pen.lineTo(a + 4, b - 4);
        pen.stroke();
      }
      pen.restore();
    }

    marks(pen, x, y) {
      for (const one of this.spec.marks || []) {
        const at = x(one.t);
        const right = one.to === undefined ? at : x(one.to);
        pen.fillStyle = color("reach");
        pen.fillRect(at - 2, y(one.high), right - at + 4, Math.max(y(one.low) - y(one.high), 1));
        pen.fillStyle = color("sky");
        for (const end of [one.low, one.high]) pen.fillRect(at - 5, y(end) - 1, right - at + 10, 2);
      }
    }

    limits(pen, area, y) {
      pen.setLineDash([6, 4]);
      pen.lineWidth = 1.2;
      pen.textAlign = "right";
      for (const one of this.spec.limits || []) {
        const row = y(one.value);
        pen.strokeStyle = color("limit");
        pen.beginPath();
        pen.moveTo(area.x0, row);
        pen.lineTo(area.x1, row);
        pen.stroke();
        if (!one.name) continue;
        const above = row - 14 > area.y0;
        pen.textBaseline = above ? "bottom" : "top";
        pen.fillStyle = color("ink-2");
        pen.fillText(one.name, area.x1 - 3, above ? row - 2 : row + 3);
      }
    }

    // Of many samples per pixel the first, least, greatest and last are drawn, in their order: no peak is lost.
    curve(pen, one, x, y, area) {
      const style = STYLES[one.style] || STYLES.a;
      pen.strokeStyle = color(style.color);
      pen.lineWidth = style.width;
      pen.setLineDash(style.dash);
      pen.lineJoin = "round";
      pen.beginPath();
      const first = Math.max(last(one.t, zoom.from) - 1, 0);
      const end = Math.min(last(one.t, zoom.to) + 2, one.t.length - 1);
      let column = null;
      let [low, high, now] = [0, 0, 0];
      const flush = (at) => {
        if (low !== high) {
          pen.lineTo(at, low);
          pen.lineTo(at, high);
          pen.lineTo(at, now);
        }
      };
      for (let i = first; i <= end; i++) {
        const px = x(one.t[i]);
        const row = y(this.value(one, i));
        if (column !== null && Math.abs(px - column) < 0.5) {
          low = Math.min(low, row);
          high = Math.max(high, row);
          now = row;
          continue;
        }
        if (column !== null) flush(column);
        if (column === null) pen.moveTo(px, row);
        else pen.lineTo(px, row);
        [column, low, high, now] = [px, row, row, row];
      }
      flush(column);
      pen.stroke();
      pen.setLineDash([]);
    }
  }

  // A chart of data.charts with its arrays in place.
  function resolved(spec) {
    const series = spec.series.map((one) => {
      const t = page.decode(page.data.arrays[one.t]);
      const y = page.decode(page.data.arrays[one.y]);
      return { ...one, t: t.data, y: y.data, stride: y.shape[1] || 1, offset: one.column || 0 };
    });
    return { ...spec, series };
  }

  page.Panel = Panel;
  page.LineChart = LineChart;
  page.last = last;
  page.ticks = ticks;
  page.register(() => {
    for (const host of document.querySelectorAll("[data-chart]")) {
      const spec = (page.data.charts || {})[host.dataset.chart];
      if (spec) new LineChart(host, { label: host.getAttribute("aria-label"), ...resolved(spec) });
    }
  });
})();
