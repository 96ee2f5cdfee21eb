// Under the pointer: a line at that x, and what every source says there. The pictures work without it.
(() => {
  const data = JSON.parse(document.getElementById("curves").textContent);
  const area = data.area;
  const at = (series, x) => {
    const places = series.x;
    let right = places.findIndex((place) => place >= x);
    if (right < 0 || (right === 0 && places[0] > x)) return null;
    if (right === 0) return series.z[0];
    const [a, b] = [series.z[right - 1], series.z[right]];
    if (a === null || b === null) return null;
    return a + ((b - a) * (x - places[right - 1])) / (places[right] - places[right - 1]);
  };
  for (const picture of data.pictures) {
    const figure = document.getElementById("figure_" + picture.id);
    const svg = figure && figure.querySelector("svg");
    if (!svg) continue;
    figure.classList.add("hover");
    const line = figure.appendChild(document.createElement("div"));
    line.className = "hair";
    const box = figure.appendChild(document.createElement("div"));
    box.className = "values";
    const hide = () => { line.style.display = box.style.display = "none"; };
    hide();
    const show = (event) => {
      const frame = svg.getBoundingClientRect();
      const outer = figure.getBoundingClientRect();
      const share = (event.clientX - frame.left) / frame.width;
      const part = (share - area.left) / (area.right - area.left);
      if (part < 0 || part > 1) return hide();
      const x = data.x_from + part * (data.x_to - data.x_from);
      const rows = picture.series.map((series) => {
        const z = at(series, x);
        const value = z === null ? "–" : z.toFixed(data.decimals);
        return `<tr><td style="color:${series.colour}">${series.curve}</td><td>${series.source}</td><td class="n">${value}</td></tr>`;
      });
      box.innerHTML = `<b>x = ${x.toFixed(3)} m</b><table><tr><th></th><th></th><th class="n">z [${data.unit}]</th></tr>${rows.join("")}</table>`;
      line.style.display = box.style.display = "block";
      const left = event.clientX - outer.left;
      line.style.left = left + "px";
      line.style.top = frame.top - outer.top + frame.height * (1 - area.top) + "px";
      line.style.height = frame.height * (area.top - area.bottom) + "px";
      box.style.left = (left > outer.width / 2 ? left - box.offsetWidth - 12 : left + 12) + "px";
      box.style.top = frame.top - outer.top + "px";
    };
    svg.addEventListener("pointermove", show);
    svg.addEventListener("pointerdown", show);
    svg.addEventListener("pointerleave", hide);
  }
})();
