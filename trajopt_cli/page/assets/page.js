// The core of every page: its data, the one clock, the window of time that all charts share, theme and transport.
// Plain JavaScript without third parties. Scripts that follow call TrajoptPage.register(start).
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const decoded = new WeakMap();
  const starts = [];
  const listeners = { theme: new Set(), selection: new Set(), zoom: new Set(), motion: new Set() };

  // A block of page/encode.py as {data: Float32Array, shape}; decoded once. {same: [cycle, name]}: that of a cycle.
  function decode(block) {
    if (block.same) return decode(data.cycles[block.same[0]][block.same[1]]);
    if (!decoded.has(block)) {
      const text = atob(block.f32);
      const bytes = new Uint8Array(text.length);
      for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
      decoded.set(block, { data: new Float32Array(bytes.buffer), shape: block.shape });
    }
    return decoded.get(block);
  }

  function on(name, callback) {
    listeners[name].add(callback);
    return () => listeners[name].delete(callback);
  }

  function emit(name, value) {
    for (const callback of [...listeners[name]]) callback(value);
  }

  // Play state of the whole page [s]. A cycle that is shorter stands at its end.
  const clock = {
    time: 0,
    duration: data.clock ? data.clock.duration : 0,
    playing: false,
    rate: 1,
    _heard: new Set(),
    on(callback) {
      this._heard.add(callback);
      callback(this.time);
      return () => this._heard.delete(callback);
    },
    seek(time) {
      this.time = Math.min(Math.max(time, 0), this.duration);
      for (const callback of [...this._heard]) callback(this.time);
    },
    setDuration(duration) {
      this.duration = duration;
      this.seek(Math.min(this.time, duration));
    },
    play() {
      if (this.playing || !(this.duration > 0)) return;
      if (this.time >= this.duration) this.time = 0;
      this.playing = true;
      let before = null;
      const step = (now) => {
        if (!this.playing) return;
        const next = before === null ? this.time : this.time + ((now - before) / 1000) * this.rate;
        before = now;
        if (next >= this.duration) this.playing = false;
        this.seek(next);
        if (this.playing) requestAnimationFrame(step);
      };
      this.seek(this.time);
      requestAnimationFrame(step);
    },
    pause() {
      this.playing = false;
      this.seek(this.time);
    },
    toggle() {
      if (this.playing) this.pause();
      else this.play();
    },
  };

  // The window of time that charts show [s].
  const zoom = {
    from: 0,
    to: clock.duration,
    set(from, to) {
      const end = clock.duration;
      const width = Math.min(Math.max(to - from, Math.min(0.01, end)), end);
      this.from = Math.min(Math.max(from, 0), end - width);
      this.to = this.from + width;
      emit("zoom", this);
    },
    all() {
      this.set(0, clock.duration);
    },
    by(factor, about) {
      this.set(about - (about - this.from) * factor, about + (this.to - about) * factor);
    },
    // Shift the window so that a time is in it.
    show(time) {
      const width = this.to - this.from;
      if (time < this.from) this.set(time - 0.1 * width, time + 0.9 * width);
      else if (time > this.to) this.set(time - 0.1 * width, time + 0.9 * width);
    },
  };

  // Which cycles stand beside each other: indices into data.clock.cycles, before first.
  const selection = {
    shown: data.clock && data.clock.shown ? data.clock.shown : (data.clock ? data.clock.cycles : []).map((_, i) => i),
    set(shown) {
      this.shown = shown;
      const ends = shown.map((i) => data.clock.cycles[i].duration);
      clock.setDuration(Math.max(...ends));
      zoom.all();
      emit("selection", shown);
    },
  };

  function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) {
      if (value !== null && value !== undefined && value !== false) element.setAttribute(name, value === true ? "" : value);
    }
    element.append(...children.filter((child) => child !== null && child !== undefined));
    return element;
  }

  // A number for people: real minus sign, digits behind the point.
  function figure(value, digits) {
    return value.toFixed(digits).replace(/^-(?=0(\.0*)?$)/, "").replace("-", "−");
  }

  function color(name) {
    return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  }

  function startTheme() {
    const button = document.getElementById("theme");
    const order = ["system", "light", "dark"];
    let now = 0;
    button.addEventListener("click", () => {
      now = (now + 1) % order.length;
      button.textContent = `Theme: ${order[now]}`;
      if (now) document.documentElement.dataset.theme = order[now];
      else delete document.documentElement.dataset.theme;
      emit("theme", order[now]);
    });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => emit("theme", order[now]));
  }

  function startTransport() {
    const bar = document.getElementById("transport");
    if (!bar) return;
    const play = document.getElementById("play");
    const slider = document.getElementById("time");
    const rate = document.getElementById("rate");
    const clocks = document.getElementById("clocks");
    let texts = [];
    const name = () => {
      texts = selection.shown.map((i, k) => {
        const value = make("b");
        clocks.append(make("span", { class: k ? "after" : "before" }, `${data.clock.cycles[i].name} `, value));
        return [value, data.clock.cycles[i].duration];
      });
    };
    const renew = () => {
      clocks.replaceChildren();
      name();
      slider.max = String(clock.duration);
      clock.seek(clock.time);
    };
    play.addEventListener("click", () => clock.toggle());
    slider.addEventListener("input", () => clock.seek(Number(slider.value)));
    rate.addEventListener("change", () => (clock.rate = Number(rate.value)));
    name();
    slider.max = String(clock.duration);
    clock.on((time) => {
      slider.value = String(time);
      slider.setAttribute("aria-valuetext", `${figure(time, 2)} s`);
      for (const [text, end] of texts) text.textContent = `${figure(Math.min(time, end), 3)} s`;
      const state = clock.playing ? "Pause" : "Play";
      if (play.textContent !== state) {
        play.textContent = state;
        play.setAttribute("aria-pressed", String(clock.playing));
      }
      if (clock.playing) zoom.show(time);
    });
    on("selection", renew);
    const whole = document.getElementById("whole");
    whole.addEventListener("click", () => zoom.all());
    on("zoom", () => (whole.hidden = zoom.to - zoom.from > clock.duration - 1e-6));
    document.addEventListener("keydown", keys);
  }

  // Space plays, arrows step by 10 ms (100 ms with shift), + and - zoom, 0 shows the whole cycle.
  function keys(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || event.defaultPrevented) return;
    const tag = event.target.tagName;
    const slider = event.target.id === "time";
    if (tag === "SELECT" || tag === "TEXTAREA" || (tag === "INPUT" && !slider)) return;
    if (event.key === " " && (tag === "BUTTON" || tag === "SUMMARY" || tag === "A")) return;
    const step = event.shiftKey ? 0.1 : 0.01;
    const scrolls = event.target.classList.contains("scroll") || event.target.classList.contains("own-keys");
    if (scrolls && (event.key.startsWith("Arrow") || event.key === "Home" || event.key === "End")) return;
    const seek = (time) => {
      clock.seek(time);
      zoom.show(clock.time);
    };
    const acts = {
      " ": () => clock.toggle(),
      ArrowLeft: () => seek(clock.time - step),
      ArrowRight: () => seek(clock.time + step),
      "+": () => zoom.by(0.5, clock.time),
      "=": () => zoom.by(0.5, clock.time),
      "-": () => zoom.by(2, clock.time),
      0: () => zoom.all(),
    };
    if (slider) Object.assign(acts, { Home: () => seek(0), End: () => seek(clock.duration) });
    const act = acts[event.key];
    if (act) {
      event.preventDefault();
      act();
    }
  }

  window.TrajoptPage = {
    data, decode, clock, zoom, selection, on, emit, make, figure, color,
    // Scripts' start functions, called in order once all are there and the text is painted.
    register(start) {
      starts.push(start);
    },
  };
  document.addEventListener("DOMContentLoaded", () => {
    if (data.clock && selection.shown.length) {
      clock.duration = Math.max(...selection.shown.map((i) => data.clock.cycles[i].duration));
      zoom.to = clock.duration;
    }
    startTheme();
    startTransport();
    // Each start in a task of its own, so that text and what is ready are painted before the next one.
    const next = () => {
      const start = starts.shift();
      if (!start) {
        document.documentElement.dataset.ready = "yes";
        return;
      }
      try {
        start();
      } finally {
        setTimeout(next);
      }
    };
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(next)));
  });
})();
