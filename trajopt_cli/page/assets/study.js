// A study's points: a map of two columns, parallel coordinates, a histogram; one point is chosen in all of them.
//
// data: {shown, more: [answers of which more is better], factors, answers, units, columns: {name: {values, names?}},
//        axes, lines: what map and parallel axes show at first, point, ok, reason: one for each point, plans: {point: href}}
"use strict";
(() => {
  const page = window.TrajoptPage;
  const { data, make, figure, color, on } = page;
  const { columns, units } = data;
  const count = data.point.length;
  const all = [...data.factors, ...data.answers];
  const FEW = 40; // levels of an axis that cells are drawn for
  const kept = new Map(); // by column: the part of its axis that lines must pass, in shares
  const drawings = [];
  let chosen = -1;

  const told = (name, value, digits = 6) => {
    if (value === null) return "–";
    if (columns[name].names) return columns[name].names[value];
    const time = data.answers.includes(name) && name !== "price";
    return time ? figure(value, 3) : String(Number(value.toPrecision(digits))).replace("-", "−");
  };
  const label = (name) => {
    const unit = units[name];
    const end = `_${unit.replaceAll("/", "_per_")}`;
    return unit && name.endsWith(end) ? `${name.slice(0, -end.length)} [${unit}]` : name;
  };
  const scales = new Map();
  // {low, high, levels (sorted, each once), share(value) in 0..1}
  function scale(name) {
    if (!scales.has(name)) {
      const levels = [...new Set(columns[name].values.filter((v) => v !== null))].sort((a, b) => a - b);
      const [low, high] = [levels[0] ?? 0, levels[levels.length - 1] ?? 1];
      scales.set(name, { low, high, levels, share: (v) => (high > low ? (v - low) / (high - low) : 0.5) });
    }
    return scales.get(name);
  }

  // How good a value is among all of its column: 1 for the best, 0 for the worst.
  const ranks = new Map();
  function rank(name, value) {
    if (!ranks.has(name)) {
      const values = columns[name].values.filter((v, i) => v !== null && data.ok[i]).sort((a, b) => a - b);
      ranks.set(name, values);
    }
    const values = ranks.get(name);
    const below = values.length > 1 ? Math.max(0, page.last(values, value)) / (values.length - 1) : 1;
    return data.more.includes(name) ? below : 1 - below;
  }

  function rgb(name) {
    const hex = color(name).slice(1);
    return [0, 2, 4].map((k) => parseInt(hex.slice(k, k + 2), 16));
  }

  function shade(good) {
    const [a, b] = [rgb("line"), rgb("after")];
    return `rgb(${a.map((from, k) => Math.round(from + (b[k] - from) * good)).join(" ")})`;
  }

  // A canvas in a host that is drawn anew when its size, the theme or the choice changes.
  function drawing(host, name, height, least, draw) {
    const canvas = make("canvas", { role: "img", "aria-label": name });
    const box = make("div", { class: "wide" }, canvas);
    host.append(box);
    const one = {
      canvas,
      renew() {
        const width = Math.max(host.clientWidth, least());
        const ratio = window.devicePixelRatio || 1;
        const high = height();
        canvas.style.width = `${width}px`;
        canvas.style.height = `${high}px`;
        canvas.width = Math.round(width * ratio);
        canvas.height = Math.round(high * ratio);
        const pen = canvas.getContext("2d");
        pen.setTransform(ratio, 0, 0, ratio, 0, 0);
        pen.font = `11px ${getComputedStyle(document.body).fontFamily}`;
        draw(pen, width, high);
      },
    };
    new ResizeObserver(() => one.renew()).observe(host);
    drawings.push(one);
    return one;
  }

  function choose(i) {
    chosen = i;
    const out = document.getElementById("chosen");
    out.hidden = i < 0;
    if (i >= 0) {
      const close = make("button", { type: "button", class: "quiet", "aria-label": "Close" }, "✕");
      close.addEventListener("click", () => choose(-1));
      const link = data.plans[data.point[i]];
      const list = all.map((name) => make("li", {}, `${label(name)}: `, make("b", {}, told(name, columns[name].values[i]))));
      const title = make("b", {}, `Point ${data.point[i]} `);
      out.replaceChildren(close, title, link ? make("a", { href: link }, "its plan") : data.reason[i], make("ul", {}, ...list));
    }
    for (const one of drawings) one.renew();
  }

  function options(id, names, first) {
    const select = document.getElementById(id);
    select.append(...names.map((name) => make("option", { value: name, selected: name === first }, label(name))));
    select.addEventListener("change", () => drawings.forEach((one) => one.renew()));
    return select;
  }

  // As much of a text's end as fits, which tells names apart; drawn inside 0..width.
  function axisText(pen, text, x, y, room, width = Infinity) {
    let cut = pen.measureText(text).width > room ? text.replace(/ \[.*\]$/, "") : text;
    while (cut.length > 3 && pen.measureText(cut).width > room) cut = `…${cut.slice(2)}`;
    const half = pen.measureText(cut).width / 2;
    pen.fillText(cut, pen.textAlign === "center" ? Math.min(Math.max(x, half + 1), width - half - 1) : x, y);
  }

  function startMap() {
    const across = options("across", all, data.axes[0] || data.shown);
    const up = options("up", all, data.axes[1] || data.shown);
    const colour = options("colour", data.answers, data.shown);
    const host = document.getElementById("heat");
    const out = make("figcaption", {});
    host.append(out);
    let spots = []; // [x, y, row]
    const map = drawing(host, "Map of all points", () => 420, () => 0, (pen, width, height) => {
      const [a, b, c] = [across.value, up.value, colour.value];
      const [sa, sb] = [scale(a), scale(b)];
      const area = { x0: width < 500 ? 58 : 84, x1: width - 14, y0: 12, y1: height - 40 };
      // names and few levels stand evenly, in the middle of their cells
      const cells = [sa, sb].map((s) => s.levels.length <= FEW);
      const at = (s, even, v) => (even ? (s.levels.indexOf(v) + 0.5) / s.levels.length : 0.03 + 0.94 * s.share(v));
      const x = (v) => area.x0 + at(sa, cells[0], v) * (area.x1 - area.x0);
      const y = (v) => area.y1 - at(sb, cells[1], v) * (area.y1 - area.y0);
      pen.fillStyle = color("raised");
      pen.fillRect(area.x0, area.y0, area.x1 - area.x0, area.y1 - area.y0);
      spots = [];
      const found = new Map(); // the best of those at one place
      for (let i = 0; i < count; i++) {
        const [va, vb, vc] = [a, b, c].map((name) => columns[name].values[i]);
        if (va === null || vb === null) continue;
        const good = data.ok[i] && vc !== null ? rank(c, vc) : -1;
        spots.push([x(va), y(vb), i, good]);
        const key = `${va} ${vb}`;
        if (!found.has(key) || found.get(key)[3] < good) found.set(key, spots[spots.length - 1]);
      }
      const even = cells[0] && cells[1];
      const [w, h] = [(area.x1 - area.x0) / sa.levels.length, (area.y1 - area.y0) / sb.levels.length];
      const several = even && found.size < spots.length;
      if (even) spots = [...found.values()];
      else spots.sort((p, q) => p[3] - q[3]);
      out.textContent = several ? "Each cell shows the best of the points in it." : "";
      pen.textAlign = "center";
      pen.textBaseline = "middle";
      for (const [px, py, i, good] of spots) {
        if (good >= 0) {
          pen.fillStyle = shade(good);
          if (even) pen.fillRect(px - w / 2 + 0.5, py - h / 2 + 0.5, w - 1, h - 1);
          else {
            pen.beginPath();
            pen.arc(px, py, 4, 0, 7);
            pen.fill();
          }
          if (even && w > 44 && h > 16) {
            pen.fillStyle = good > 0.55 ? color("on-accent") : color("ink");
            pen.fillText(told(c, columns[c].values[i]), px, py);
          }
        } else {
          pen.strokeStyle = color("vermillion");
          pen.beginPath();
          for (const s of [1, -1]) (pen.moveTo(px - 4, py - 4 * s), pen.lineTo(px + 4, py + 4 * s));
          pen.stroke();
        }
      }
      const mark = chosen >= 0 && [columns[a].values[chosen], columns[b].values[chosen]];
      if (mark && mark[0] !== null && mark[1] !== null) {
        pen.strokeStyle = color("ink");
        pen.lineWidth = 2.5;
        if (even) pen.strokeRect(x(mark[0]) - w / 2 + 1, y(mark[1]) - h / 2 + 1, w - 2, h - 2);
        else {
          pen.beginPath();
          pen.arc(x(mark[0]), y(mark[1]), 8, 0, 7);
          pen.stroke();
        }
        pen.lineWidth = 1;
      }
      pen.fillStyle = color("ink-2");
      // [value, words]: of few levels each, or every so many; else round numbers
      const marks = (name, s, levels, most) => {
        if (levels) return s.levels.filter((_, k) => k % Math.ceil(s.levels.length / most) === 0).map((v) => [v, told(name, v, 4)]);
        const { values, digits } = page.ticks(s.low, s.high, most);
        return values.map((v) => [v, figure(v, digits)]);
      };
      const wide = marks(a, sa, cells[0], Math.max(2, Math.floor((area.x1 - area.x0) / 70)));
      for (const [v, words] of wide) axisText(pen, words, x(v), area.y1 + 11, cells[0] ? Math.max(w, 58) : 80);
      pen.fillText(label(a), (area.x0 + area.x1) / 2, height - 9);
      pen.textAlign = "right";
      for (const [v, words] of marks(b, sb, cells[1], 14)) axisText(pen, words, area.x0 - 6, y(v), area.x0 - 8);
      pen.save();
      pen.translate(9, (area.y0 + area.y1) / 2);
      pen.rotate(-Math.PI / 2);
      pen.textAlign = "center";
      pen.fillText(label(b), 0, 0);
      pen.restore();
    });
    map.canvas.addEventListener("click", (event) => {
      const reach = ([x, y]) => Math.hypot(x - event.offsetX, y - event.offsetY);
      const near = spots.reduce((best, one) => (best === null || reach(one) < reach(best) ? one : best), null);
      if (near) choose(near[2]);
    });
  }

  function startLines() {
    const host = document.getElementById("parallel");
    const names = data.lines;
    const top = 34;
    let area = { x0: 0, step: 1, y1: 1 };
    const pass = (i) => [...kept].every(([name, [from, to]]) => {
      const v = columns[name].values[i];
      return v !== null && scale(name).share(v) >= from - 1e-9 && scale(name).share(v) <= to + 1e-9;
    });
    const lines = drawing(host, "Parallel coordinates", () => 340, () => 124 * names.length, (pen, width, height) => {
      area = { x0: 62, step: (width - 124) / Math.max(names.length - 1, 1), y1: height - 22 };
      const y = (share) => area.y1 - share * (area.y1 - top);
      const order = data.point.map((_, i) => i).filter((i) => data.ok[i] && columns[data.shown].values[i] !== null);
      const good = new Map(order.map((i) => [i, rank(data.shown, columns[data.shown].values[i])]));
      order.sort((i, j) => good.get(i) - good.get(j));
      const draw = (i) => {
        pen.beginPath();
        let open = false;
        names.forEach((name, k) => {
          const v = columns[name].values[i];
          if (v === null) return void (open = false);
          pen[open ? "lineTo" : "moveTo"](area.x0 + k * area.step, y(scale(name).share(v)));
          open = true;
        });
        pen.stroke();
      };
      pen.globalAlpha = order.length > 800 ? 0.35 : 0.75;
      for (const i of order.filter(pass)) {
        pen.strokeStyle = shade(good.get(i));
        draw(i);
      }
      pen.globalAlpha = 1;
      if (chosen >= 0) {
        pen.strokeStyle = color("ink");
        pen.lineWidth = 2.5;
        draw(chosen);
        pen.lineWidth = 1;
      }
      pen.textAlign = "center";
      names.forEach((name, k) => {
        const x = area.x0 + k * area.step;
        pen.strokeStyle = color("axis");
        pen.beginPath();
        pen.moveTo(x, top);
        pen.lineTo(x, area.y1);
        pen.stroke();
        if (kept.has(name)) {
          const [from, to] = kept.get(name);
          pen.fillStyle = color("ink");
          pen.fillRect(x - 3, y(to), 6, Math.max(y(from) - y(to), 2));
        }
        pen.fillStyle = color("ink");
        axisText(pen, label(name), x, 10, Math.max(area.step - 8, 90), width);
        pen.fillStyle = color("ink-2");
        axisText(pen, told(name, scale(name).high, 4), x, 25, 90, width);
        axisText(pen, told(name, scale(name).low, 4), x, height - 8, 90, width);
      });
    });
    let start = null;
    const where = (event) => ({
      k: Math.min(Math.max(Math.round((event.offsetX - area.x0) / area.step), 0), names.length - 1),
      share: Math.min(Math.max((area.y1 - event.offsetY) / (area.y1 - top), 0), 1),
      y: event.offsetY,
    });
    lines.canvas.addEventListener("pointerdown", (event) => (start = where(event)));
    lines.canvas.addEventListener("pointerup", (event) => {
      if (!start) return;
      const end = where(event);
      if (Math.abs(end.y - start.y) > 5) kept.set(names[start.k], [start.share, end.share].sort((a, b) => a - b));
      else if (kept.size) kept.clear();
      else {
        // the line that is nearest at this axis
        const { share } = scale(names[end.k]);
        const gap = (i) => Math.abs(share(columns[names[end.k]].values[i] ?? Infinity) - end.share);
        const rows = data.point.map((_, i) => i).filter((i) => data.ok[i]);
        choose(rows.reduce((best, i) => (best < 0 || gap(i) < gap(best) ? i : best), -1));
      }
      start = null;
      lines.renew();
    });
  }

  function startSpread() {
    const values = columns[data.shown].values.filter((v, i) => v !== null && data.ok[i]).sort((a, b) => a - b);
    const quantile = (p) => {
      const at = p * (values.length - 1);
      const k = Math.floor(at);
      return values[k] + (at - k) * ((values[k + 1] ?? values[k]) - values[k]);
    };
    const [low, high] = [values[0], values[values.length - 1]];
    const bins = Math.max(1, Math.min(40, Math.ceil(Math.sqrt(values.length)), high > low ? 40 : 1));
    const size = (high - low) / bins || 1;
    const heights = new Array(bins).fill(0);
    for (const v of values) heights[Math.min(bins - 1, Math.floor((v - low) / size))]++;
    drawing(document.getElementById("spread"), "Histogram", () => 220, () => 0, (pen, width, height) => {
      const area = { x0: 14, x1: width - 14, y0: 30, y1: height - 24 };
      const x = (v) => area.x0 + ((v - low) / (high - low || 1)) * (area.x1 - area.x0);
      const most = Math.max(...heights);
      const wide = (area.x1 - area.x0) / bins;
      heights.forEach((n, k) => {
        const tall = (n / most) * (area.y1 - area.y0);
        pen.fillStyle = shade(rank(data.shown, low + (k + 0.5) * size));
        pen.fillRect(area.x0 + k * wide + 0.5, area.y1 - tall, wide - 1, tall);
      });
      pen.fillStyle = color("ink");
      pen.strokeStyle = color("ink");
      pen.textBaseline = "alphabetic";
      const marks = [0.05, 0.5, 0.95];
      marks.forEach((p, k) => {
        const at = x(quantile(p));
        pen.beginPath();
        pen.moveTo(at, area.y0 - 4);
        pen.lineTo(at, area.y1);
        pen.stroke();
        const words = `${100 * p} %: ${figure(quantile(p), 3)}`;
        const half = pen.measureText(words).width / 2;
        pen.textAlign = "center";
        pen.fillText(words, Math.min(Math.max(at, half + 2), width - half - 2), [12, 24, 12][k]);
      });
      pen.fillStyle = color("ink-2");
      pen.textAlign = "left";
      pen.fillText(figure(low, 3), area.x0, height - 8);
      pen.textAlign = "right";
      pen.fillText(`${figure(high, 3)} ${units[data.shown]}`, area.x1, height - 8);
    });
    if (chosen >= 0) choose(chosen);
  }

  page.register(() => {
    for (const button of document.querySelectorAll("[data-point]")) {
      button.addEventListener("click", () => choose(data.point.indexOf(Number(button.dataset.point))));
    }
    startMap();
    startLines();
    startSpread();
    on("theme", () => drawings.forEach((one) => one.renew()));
  });
})();
