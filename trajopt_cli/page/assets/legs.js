// The table of legs: a click goes to a leg's beginning, the leg at hand is marked.
"use strict";
window.TrajoptPage.register(() => {
  const page = window.TrajoptPage;
  const rows = [...document.querySelectorAll("#legs tbody tr")];
  for (const row of rows) {
    row.querySelector("button").addEventListener("click", () => {
      page.clock.seek(Number(row.dataset.from));
      page.zoom.show(page.clock.time);
    });
  }
  let now = null;
  page.clock.on((time) => {
    const found = rows.find((row) => time < Number(row.dataset.to)) || rows[rows.length - 1];
    if (found === now) return;
    if (now) now.removeAttribute("aria-current");
    if (found) found.setAttribute("aria-current", "time");
    now = found;
  });
});
