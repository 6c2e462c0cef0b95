// Motions and dwells over time, a row per cycle; a click goes to where a block begins.
"use strict";
(() => {
  const page = window.TrajoptPage;
  const { clock, figure, color, make } = page;
  const ROW = 38;
  const KINDS = { joint: "joint moves", line: "lines", arc: "arcs", rail: "rail alone", wait: "waits" };

  class Gantt {
    // rows: [{name, style, legs, label(k) -> text, detail(k) -> text, end, bound}]
    constructor(host, rows, label) {
      this.rows = rows;
      this.out = make("output", { class: "sub", "aria-live": "off" });
      const kinds = Object.keys(KINDS).filter((kind) => rows.some((row) => row.legs.kind.includes(kind)));
      const key = make("ul", { class: "legend" }, ...kinds.map((kind) => make("li", { class: `kind ${kind}` }, KINDS[kind])));
      if (rows.some((row) => row.bound)) key.append(make("li", { class: "kind bound" }, "lower bound"));
      host.replaceChildren(make("figcaption", {}, make("b", {}, "Motions over time"), this.out));
      const gantt = this;
      this.panel = new (class extends page.Panel {
        draw(pen, area) {
          gantt.draw(pen, area);
        }
        over(time, y) {
          gantt.tell(gantt.hit(time, y));
        }
        read() {
          if (this.hover === null) gantt.tell(null);
        }
        pressed(time, y) {
          const at = gantt.hit(time, y);
          clock.seek(at ? gantt.rows[at[0]].legs.from[at[1]] : time);
          if (at) page.emit("motion", gantt.rows[at[0]].legs.index[at[1]]);
        }
      })(host, { label, height: 30 + ROW * rows.length, left: host.clientWidth > 700 ? 124 : 88 });
      host.append(key);
    }

    dispose() {
      this.panel.dispose();
    }

    hit(time, y) {
      const row = Math.floor((y - 8) / ROW);
      if (row < 0 || row >= this.rows.length) return null;
      const { legs } = this.rows[row];
      const k = page.last(legs.from, time);
      return k >= 0 && time <= legs.to[k] ? [row, k] : null;
    }

    tell(at) {
      const text = at ? this.rows[at[0]].detail(at[1]) : "";
      if (this.out.textContent !== text) this.out.textContent = text;
    }

    draw(pen, area) {
      const { panel } = this;
      pen.textBaseline = "middle";
      this.rows.forEach((row, r) => {
        const top = area.y0 + r * ROW + 5;
        const height = ROW - 10;
        pen.textAlign = "right";
        pen.fillStyle = color("ink");
        this.fit(pen, row.name, panel.left - 12, (text) => pen.fillText(text, panel.left - 9, top + height / 2));
        pen.save();
        pen.beginPath();
        pen.rect(area.x0, area.y0, area.x1 - area.x0, area.y1 - area.y0);
        pen.clip();
        pen.textAlign = "left";
        row.legs.from.forEach((from, k) => {
          const a = panel.x(from);
          const b = panel.x(row.legs.to[k]);
          if (b < area.x0 || a > area.x1) return;
          const wide = b - a > 2;
          pen.fillStyle = color(`k-${row.legs.kind[k]}`);
          pen.fillRect(a, top, Math.max(b - a - (wide ? 1 : 0), 0.5), height);
          pen.fillStyle = color("paper");
          for (const time of row.legs.points[k]) pen.fillRect(panel.x(time) - 1, top + height - 7, 2, 7);
          if (b - a < 26) return;
          pen.fillStyle = color("ink");
          const x = Math.max(a, area.x0) + 5;
          this.fit(pen, row.label(k), Math.min(b, area.x1) - x - 3, (text) => pen.fillText(text, x, top + height / 2 + 0.5));
        });
        if (row.bound) {
          pen.strokeStyle = color("green");
          pen.lineWidth = 2;
          pen.setLineDash([4, 3]);
          pen.beginPath();
          pen.moveTo(panel.x(row.bound), top - 3);
          pen.lineTo(panel.x(row.bound), top + height + 3);
          pen.stroke();
          pen.setLineDash([]);
        }
        pen.restore();
      });
    }

    // Draw as much of a text as fits; nothing where not even three letters do.
    fit(pen, text, room, draw) {
      if (pen.measureText(text).width <= room) return draw(text);
      for (let n = text.length - 1; n >= 3; n--) {
        const cut = `${text.slice(0, n)}…`;
        if (pen.measureText(cut).width <= room) return draw(cut);
      }
      return undefined;
    }
  }

  page.Gantt = Gantt;
})();
