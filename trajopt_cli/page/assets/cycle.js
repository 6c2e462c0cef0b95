// The rail job's page: which two cycles stand beside each other, and all that follows the clock: Gantt, axes, rail, TCP
// speed, table of motions and source.
"use strict";
(() => {
  const page = window.TrajoptPage;
  const { data, clock, zoom, selection, make, figure, decode, last } = page;
  const MM = 1000;
  let drawn = [];
  const state = { quantity: "q", share: false };
  const QUANTITIES = { q: "position", qd: "speed", qdd: "acceleration" };

  const style = (k) => (selection.shown.length > 1 && k === 0 ? "before" : "after");
  const cycle = (i) => data.cycles[i];
  const shown = () => selection.shown.map(cycle);
  const after = () => cycle(selection.shown[selection.shown.length - 1]);
  const motion = (one, index) => {
    const of = data.programs[one.program];
    return index < 0 ? null : { instruction: of.instruction[index], target: of.target[index], place: of.place[index], file: of.file[index], line: of.line[index] };
  };

  function name(one, k) {
    const known = motion(one, one.legs.index[k]);
    if (!known) return one.legs.kind[k] === "wait" ? "rests" : "moves";
    return known.instruction.startsWith("Wait") ? known.target : known.target || known.instruction;
  }

  function detail(one, k) {
    const known = motion(one, one.legs.index[k]);
    const time = `${figure(one.legs.to[k] - one.legs.from[k], 3)} s`;
    if (!known) return `${one.name}: ${name(one, k)}, ${time}`;
    const limit = one.legs.binding[k] ? `, limited by ${one.legs.binding[k]}` : "";
    const way = one.legs.way[k] ? ` (${one.legs.way[k]})` : "";
    return `${one.name}: ${known.place} ${known.instruction} ${known.target}${way}, ${time}${limit}`;
  }

  // The leg of a cycle at a time; at its end the last one.
  function legAt(one, time) {
    const k = last(one.legs.from, Math.min(time, one.duration) + 1e-9);
    return Math.max(Math.min(k, one.legs.from.length - 1), 0);
  }

  function startChoice() {
    const host = document.getElementById("choice");
    if (!host || data.cycles.length < 2) return;
    const pick = (k, label) => {
      const select = make("select", { id: `cycle-${k}` }, ...data.cycles.map((one, i) => make("option", { value: i }, one.name)));
      select.value = String(selection.shown[k]);
      select.addEventListener("change", () => {
        const wanted = [...selection.shown];
        const other = wanted[1 - k];
        wanted[k] = Number(select.value);
        if (wanted[k] === other) wanted[1 - k] = selection.shown[k];
        selection.set(wanted);
      });
      page.on("selection", (now) => (select.value = String(now[k])));
      return make("label", { class: k ? "key after" : "key before" }, `${label} `, select);
    };
    host.append(pick(0, "Compare"), pick(1, "with"));
  }

  function startGantt() {
    const host = document.getElementById("gantt");
    if (!host) return;
    const rows = shown().map((one) => ({
      name: one.name,
      legs: one.legs,
      bound: one.bound,
      label: (k) => name(one, k),
      detail: (k) => detail(one, k),
    }));
    const label = `Motions and waits over time: ${shown().map((one) => `${one.name} ${figure(one.duration, 3)} s`).join(", ")}. The table of motions has every number.`;
    drawn.push(new page.Gantt(host, rows, label));
  }

  function series(take) {
    return shown().map((one, k) => ({ name: one.name, t: decode(one.t).data, style: style(k), ...take(one) }));
  }

  const spans = () => {
    const { legs } = after();
    return legs.from.map((from, k) => [from, legs.to[k], legs.kind[k]]).filter((one) => one[2] === "wait").map(([a, b]) => [a, b]);
  };

  function axisChart(host, axis, k) {
    const { quantity, share } = state;
    const per = { q: "", qd: "/s", qdd: "/s²" }[quantity];
    const [low, high] = { q: [axis.lower, axis.upper], qd: [-axis.velocity, axis.velocity], qdd: [-axis.acceleration, axis.acceleration] }[quantity];
    const least = axis.least_acceleration;
    const limits = quantity === "qdd" && least < high ? [low, -least, least, high] : [low, high];
    const middle = share ? (low + high) / 2 : 0;
    const figureOf = (value) => figure((value - middle) * scale, 0);
    const scale = share ? 200 / (high - low) : 1 / axis.scale;
    const told = limits.length > 2 ? `${figureOf(least)} to ${figureOf(high)} by posture` : figureOf(high);
    const unit = share ? "% of the limit" : `${axis.unit}${per}`;
    const stride = data.axes.length;
    const chart = {
      title: axis.name,
      unit,
      digits: share ? 1 : axis.unit === "mm" || quantity !== "q" ? 0 : 1,
      height: 150,
      spans: spans(),
      limits: limits.map((value, i) => ({ value: (value - middle) * scale, name: i === limits.length - 1 ? `limit ${told}` : "" })),
      series: series((one) => {
        const all = decode(one[quantity]).data;
        if (!middle) return { y: all, stride, offset: k, scale };
        const y = new Float32Array(all.length / stride);
        for (let i = 0; i < y.length; i++) y[i] = all[i * stride + k] - middle;
        return { y, scale };
      }),
    };
    chart.label = `${axis.name}, ${QUANTITIES[quantity]} in ${unit}, limits ${chart.limits.map((one) => figure(one.value, 1)).join(" and ")}`;
    const figureElement = make("figure", { class: "chart" });
    host.append(figureElement);
    drawn.push(new page.LineChart(figureElement, chart));
  }

  function startAxes() {
    const host = document.getElementById("axes-charts");
    if (!host) return;
    host.replaceChildren();
    data.axes.forEach((axis, k) => axisChart(host, axis, k));
  }

  function startAxesChoice() {
    const host = document.getElementById("axes-choice");
    if (!host) return;
    const radios = Object.entries(QUANTITIES).map(([key, text]) => {
      const radio = make("input", { type: "radio", name: "quantity", value: key, checked: key === state.quantity });
      radio.addEventListener("change", () => {
        state.quantity = key;
        renew();
      });
      return make("label", {}, radio, text);
    });
    const share = make("input", { type: "checkbox" });
    share.addEventListener("change", () => {
      state.share = share.checked;
      renew();
    });
    host.append(
      make("fieldset", { class: "choice" }, make("legend", {}, "Show"), ...radios),
      make("fieldset", { class: "choice" }, make("legend", { class: "quiet-text" }, "Scale"), make("label", {}, share, "as share of the limit")),
    );
  }

  function startRail() {
    const host = document.getElementById("rail-chart");
    if (!host) return;
    const axis = data.axes[0];
    const one = after();
    const { legs } = one;
    const marks = [];
    const points = [];
    let held = []; // of the point last reached: through a wait it stays in reach
    legs.index.forEach((index, k) => {
      const waits = legs.kind[k] === "wait";
      held = waits ? held : data.reach.ranges[index] || [];
      for (const [low, high] of held) marks.push({ t: waits ? legs.from[k] : legs.to[k], to: legs.to[k], low: low * MM, high: high * MM });
      const asked = data.reach.asked[index];
      if (asked !== undefined && one.program === 0) points.push({ t: legs.to[k], y: asked * MM });
    });
    drawn.push(new page.LineChart(host, {
      title: "rail", unit: "mm", digits: 0, height: 300, spans: spans(), marks: one.program === 0 ? marks : [], points,
      label: "Rail position over time, with the range from which each point is in reach at the time it is reached",
      limits: [{ value: axis.lower * MM, name: "end of the rail" }, { value: axis.upper * MM, name: "end of the rail" }],
      series: series((each) => ({ y: decode(each.q).data, stride: data.axes.length, offset: 0, scale: MM })),
    }));
  }

  function startSpeed() {
    const host = document.getElementById("tcp-chart");
    if (!host) return;
    const one = after();
    drawn.push(new page.LineChart(host, {
      title: "TCP speed", unit: "mm/s", digits: 0, zero: true, height: 260, spans: spans(), alerts: one.dips,
      label: `Speed of the tool centre point against the programmed speed and the cap of ${figure(data.cap * MM, 0)} mm/s`,
      limits: [{ value: data.cap * MM, name: `cap ${figure(data.cap * MM, 0)} mm/s` }],
      steps: one.programmed.map(([from, to, v]) => ({ from, to, y: v * MM })),
      series: series((each) => ({ y: decode(each.speed).data, scale: MM })),
    }));
  }

  // What each motion of the user's program takes, by its index; a cycle of another program has none of them.
  function times(one) {
    const out = new Map();
    if (one.program) return out;
    one.legs.index.forEach((index, k) => out.set(index, { time: one.legs.to[k] - one.legs.from[k], from: one.legs.from[k], binding: one.legs.binding[k] }));
    return out;
  }

  function startTable() {
    const body = document.querySelector("#motions tbody");
    if (!body) return;
    const cells = new Map([...body.querySelectorAll("tr[data-motion]")].map((row) => [Number(row.dataset.motion), row]));
    const two = shown();
    const [before, now] = two.length > 1 ? two.map(times) : [null, times(two[0])];
    const heads = document.querySelectorAll("#motions thead th");
    if (before) heads[3].textContent = `${two[0].name} [s]`;
    heads[before ? 4 : 3].textContent = `${after().name} [s]`;
    heads[heads.length - 1].textContent = `what limits the ${after().name}`;
    for (const [index, row] of cells) {
      const was = before ? before.get(index) : null;
      const is = now.get(index);
      const texts = [is ? figure(is.time, 3) : "–"];
      if (before) {
        texts.unshift(was ? figure(was.time, 3) : "–");
        texts.push(was && is ? figure(was.time - is.time, 3) : "");
      }
      texts.push(is ? is.binding : "");
      texts.forEach((text, i) => (row.cells[3 + i].textContent = text));
    }
    const total = document.querySelector("#motions tfoot tr");
    if (total) {
      const ends = two.map((one) => one.duration);
      const sums = before ? [ends[0], ends[1], ends[0] - ends[1]] : ends;
      sums.forEach((value, i) => (total.cells[3 + i].textContent = figure(value, 3)));
    }
    return undefined;
  }

  // ------------------------------------------------------------------------------------------------------- source

  const lines = new Map();

  function startSource() {
    const host = document.getElementById("source");
    if (!host) return;
    data.sources.forEach((file, f) => {
      if (!file.parts.length) return;
      host.append(make("h3", {}, file.name));
      file.parts.forEach(([first, texts], p) => {
        if (p || first > 1) host.append(make("div", { class: "gap" }, "⋯"));
        texts.forEach((text, i) => {
          const row = make("div", { class: text.trimStart().startsWith("!") ? "src comment" : "src" },
            make("span", { class: "number" }, String(first + i)), make("span", { class: "text" }, text || " "), make("span", { class: "saved" }));
          lines.set(`${f}:${first + i}`, row);
          host.append(row);
        });
      });
      if (file.cut) host.append(make("p", { class: "sub" }, "The rest of the module is left out; input/ in the results folder has it."));
    });
    host.addEventListener("click", (event) => {
      const row = event.target.closest(".src");
      if (row && row.dataset.from !== undefined) clock.seek(Number(row.dataset.from));
    });
  }

  // Seconds saved beside each line, and where a click on it leads: its first motion in the later cycle.
  function markLines() {
    const two = shown();
    const [was, is] = two.length > 1 ? two.map(times) : [null, times(after())];
    const sums = new Map();
    for (const [index, one] of is) {
      const known = motion(after(), index);
      const row = known && lines.get(`${known.file}:${known.line}`);
      if (!row) continue;
      if (!sums.has(row)) sums.set(row, { saved: 0, from: one.from });
      if (was && was.has(index)) sums.get(row).saved += was.get(index).time - one.time;
    }
    for (const row of lines.values()) {
      const known = sums.get(row);
      row.classList.toggle("moves", Boolean(known));
      if (known) row.dataset.from = String(known.from);
      else delete row.dataset.from;
      const felt = known && was && Math.abs(known.saved) > 5e-4;
      row.lastChild.textContent = felt ? `${known.saved < 0 ? "+" : ""}${figure(-known.saved, 3)} s` : "";
      row.lastChild.classList.toggle("costs", Boolean(felt) && known.saved < 0);
    }
  }

  let lit = [];
  let told = "";

  function follow(time) {
    const two = shown();
    const now = two.map((one) => ({ one, k: legAt(one, time) }));
    const key = now.map(({ k }) => k).join();
    const rows = document.querySelectorAll("#now > *");
    if (key === told) return;
    told = key;
    for (const [element, mark] of lit) element.classList.remove(mark);
    lit = [];
    now.forEach(({ one, k }, i) => {
      if (rows[i]) rows[i].lastChild.textContent = one.legs.index.length ? detail(one, k).slice(one.name.length + 2) : "";
      const known = motion(one, one.legs.index[k] ?? -1);
      if (!known) return;
      const mark = `now-${style(i)}`;
      const line = lines.get(`${known.file}:${known.line}`);
      const row = document.querySelector(`#motions tr[data-motion="${one.legs.index[k]}"]`);
      for (const element of [line, one.program === 0 ? row : null]) {
        if (!element) continue;
        element.classList.add(mark);
        lit.push([element, mark]);
      }
      if (mark === "now-after") for (const [element, box] of [[line, document.getElementById("source")], [row, document.querySelector("#motions")]]) into(element, box);
    });
  }

  // Bring an element into its own box; the page stays where it is.
  function into(element, box) {
    if (!element || !box || box.scrollHeight <= box.clientHeight) return;
    const [a, b] = [element.getBoundingClientRect(), box.getBoundingClientRect()];
    const margin = 60;
    if (a.top < b.top + margin) box.scrollTop -= b.top + margin - a.top;
    else if (a.bottom > b.bottom - margin) box.scrollTop += a.bottom - b.bottom + margin;
  }

  function startNow() {
    const host = document.getElementById("now");
    if (!host) return;
    host.replaceChildren(...shown().map((one, i) => make("p", { class: `key ${style(i)}` }, make("b", {}, `${one.name} `), make("span", { class: "code" }))));
  }

  function renew() {
    for (const chart of drawn) chart.dispose();
    drawn = [];
    startNow();
    startGantt();
    startAxes();
    startRail();
    startSpeed();
  }

  // n and p go to the next and the previous motion of the later cycle.
  function keys(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || !["n", "p"].includes(event.key)) return;
    if (["SELECT", "TEXTAREA"].includes(event.target.tagName)) return;
    const { from } = after().legs;
    const k = legAt(after(), clock.time);
    const at = event.key === "n" ? k + 1 : clock.time > from[k] + 1e-6 ? k : k - 1;
    if (at >= 0 && at < from.length) {
      clock.seek(from[at]);
      zoom.show(from[at]);
    }
  }

  page.register(() => {
    startChoice();
    startAxesChoice();
    startSource();
    renew();
    startTable();
    markLines();
    for (const host of document.querySelectorAll("#motions, #changes")) {
      host.addEventListener("click", (event) => {
        const row = event.target.closest("[data-motion]");
        const at = row && times(after()).get(Number(row.dataset.motion));
        if (at) {
          clock.seek(at.from);
          zoom.show(at.from);
        }
      });
    }
    page.on("selection", () => {
      told = "";
      renew();
      startTable();
      markLines();
      follow(clock.time);
    });
    clock.on(follow);
    document.addEventListener("keydown", keys);
  });
})();
