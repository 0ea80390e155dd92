// SPDX-FileCopyrightText: racebeam contributors
// SPDX-License-Identifier: Apache-2.0
// Draws the charts of a report from its data, and makes its tables sortable.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("data").textContent);
  const by_id = (id) => document.getElementById(id);
  const points = data.points.name.map((name, at) => at);
  const figures = new Map(data.figures.map((figure) => [figure.name, figure]));
  const knobs = new Map(data.knobs.map((knob) => [knob.name, knob]));
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const views = new Map();
  let on = points.map(() => true);
  let brushed = points.map(() => true);

  // Okabe and Ito's colours, told apart by all kinds of eyes; light ones on dark paper.
  const colours = () => dark.matches
    ? ["#56b4e9", "#e69f00", "#00c08b", "#f0e442", "#ff8a4c", "#e29ac6", "#b0b8c0", "#8fa6ff"]
    : ["#0072b2", "#d98200", "#009e73", "#a08a00", "#d55e00", "#b8578f", "#6b7480", "#5a5fcf"];
  const Standings = [
    ["base", "diamond", 4, [1, 0]],
    ["front", "circle", 0, [1, 0]],
    ["undecided", "triangle-up", 1, [8, 3]],
    ["measured", "circle", 2, [1, 0]],
    ["dominated", "square", 6, [2, 3]],
    ["unwanted", "cross", 5, [1, 5]],
  ];
  const standing_of = (at) => (at === 0 ? "base" : data.points.standing[at]);

  const css = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const config = () => ({
    background: null,
    font: "system-ui, DejaVu Sans, sans-serif",
    view: { stroke: css("--line") },
    axis: {
      labelColor: css("--ink"), titleColor: css("--ink"), gridColor: css("--line"), gridOpacity: 0.6,
      domainColor: css("--faint"), tickColor: css("--faint"), labelFontSize: 12, titleFontSize: 12,
      titleFontWeight: "normal", labelLimit: 260,
    },
    legend: { labelColor: css("--ink"), titleColor: css("--ink"), labelFontSize: 12, titleFontSize: 12,
      titleFontWeight: "normal", labelLimit: 260, symbolLimit: 30 },
    text: { color: css("--ink") },
  });

  const shown = (number) => number === null || number === undefined
    ? "-" : Number(number.toPrecision(5)).toLocaleString("en");
  const title_of = (name) => {
    const figure = figures.get(name);
    return figure && figure.unit && figure.unit !== name ? `${name} (${figure.unit})` : name;
  };
  const half_of = (figure, at) => (figure.half && figure.half[at]) || 0;

  // --- Pictures and the tip under the mouse ---
  const pictures_of = (at) => data.pictures.point
    .map((point, number) => ({ point, number, scene: data.pictures.scene[number],
      frame: data.pictures.frame[number], source: by_id(`picture-${number}`).src }))
    .filter((picture) => picture.point === at);
  const element = (name, text, parent) => {
    const made = document.createElement(name);
    if (text) made.textContent = text;
    if (parent) parent.append(made);
    return made;
  };
  const tip = element("div", "", document.body);
  tip.id = "tip";
  tip.hidden = true;
  tip.setAttribute("role", "tooltip");

  function show_tip(event, lines, at) {
    tip.replaceChildren();
    lines.forEach((line, number) => element(number ? "div" : "strong", line, tip));
    const [picture] = at === undefined ? [] : pictures_of(at);
    if (picture) {
      const image = element("img", "", tip);
      image.src = picture.source;
      image.alt = `frame ${picture.frame} as this point draws it`;
    }
    tip.hidden = false;
    const box = tip.getBoundingClientRect(), gap = 14;
    const left = event.clientX + gap + box.width > innerWidth ? event.clientX - gap - box.width
      : event.clientX + gap;
    const top = Math.min(event.clientY + gap, innerHeight - box.height - gap);
    tip.style.left = `${Math.max(0, left)}px`;
    tip.style.top = `${Math.max(0, top)}px`;
  }
  const hide_tip = () => { tip.hidden = true; };

  const settings_of = (at) => data.knobs.map((knob) => `${knob.name}=${knob.value[at]}`).join(" ");
  const interval = (figure, at) => half_of(figure, at)
    ? `${shown(figure.value[at])} +/- ${Number(half_of(figure, at).toPrecision(2))}`
    : shown(figure.value[at]);
  function lines_of(datum) {
    if (datum.point === undefined || datum.lines) return datum.lines || [];
    const at = datum.point;
    const names = [...new Set([...(datum.names || []), ...data.led])];
    return [`${data.points.name[at]}, ${data.points.standing[at]}`, settings_of(at),
      ...names.map((name) => `${title_of(name)}: ${interval(figures.get(name), at)}`)];
  }
  const handle_tip = (handler, event, item) => {
    const datum = item && item.datum && (item.datum.datum || item.datum);
    const lines = datum ? lines_of(datum) : [];
    if (event && !event.type.match(/out|leave/) && lines.length) show_tip(event, lines, datum.point);
    else hide_tip();
  };

  // --- Drawing ---
  async function draw(id, spec) {
    const place = by_id(id);
    if (!place) return;
    const before = views.get(id);
    if (before) before.finalize();
    const result = await vegaEmbed(place, {
      $schema: "https://vega.github.io/schema/vega-lite/v6.json",
      width: "container", autosize: { type: "fit-x", contains: "padding" }, ...spec,
    }, { ast: true, renderer: "svg", actions: false, config: config(), tooltip: handle_tip });
    views.set(id, result);
    result.view.addEventListener("click", (event, item) => {
      const datum = item && item.datum;
      if (datum && datum.point !== undefined && !datum.lines) choose(datum.point);
    });
    return result.view;
  }
  const tooltip = { value: "point" }; // any: the handler makes the words

  const standing_scales = (symbols) => {
    const legend = { orient: "top", symbolOpacity: 1, ...symbols };
    const there = Standings.filter(([name]) => points.some((at) => standing_of(at) === name));
    return {
      color: { field: "standing", title: null, legend, scale: { domain: there.map((row) => row[0]),
        range: there.map((row) => colours()[row[2]]) } },
      shape: { field: "standing", title: null, legend, scale: { domain: there.map((row) => row[0]),
        range: there.map((row) => row[1]) } },
      dash: { field: "standing", title: null, legend, scale: { domain: there.map((row) => row[0]),
        range: there.map((row) => row[3]) } },
    };
  };

  const rank_of = (row) => Standings.findIndex(([name]) => name === row.standing);
  function front_rows() {
    const x = figures.get(by_id("front-x").value), y = figures.get(by_id("front-y").value);
    return points.filter((at) => x.value[at] !== null && y.value[at] !== null).map((at) => ({
      point: at, name: data.points.name[at], standing: standing_of(at), on: on[at],
      front: data.points.standing[at] === "front", names: [x.name, y.name], x: x.value[at], y: y.value[at],
      left: x.value[at] - half_of(x, at), right: x.value[at] + half_of(x, at),
      low: y.value[at] - half_of(y, at), high: y.value[at] + half_of(y, at),
      // A point alone says its name; where there are many only the base does
      label: at === 0 || points.length <= 12 ? data.points.name[at] : "",
    })).sort((a, b) => rank_of(b) - rank_of(a)); // the base and the front above the others
  }
  function draw_front() {
    const x = by_id("front-x").value, y = by_id("front-y").value;
    // As wide as the points lie, with room for the usual interval: a few wide ones are cut
    const domain = (figure) => {
      const there = points.filter((at) => figure.value[at] !== null);
      const values = there.map((at) => figure.value[at]);
      const halves = there.map((at) => half_of(figure, at)).sort((a, b) => a - b);
      const low = Math.min(...values), high = Math.max(...values);
      const more = Math.min(halves[halves.length >> 1], 1.5 * (high - low) || Infinity);
      return [low - more, high + more];
    };
    const axis = (name) => ({ type: "quantitative", title: title_of(name),
      scale: { zero: false, nice: false, padding: 14, domain: domain(figures.get(name)) }, axis: { tickCount: 8 } });
    const { color, shape } = standing_scales();
    const faded = (strong) => ({ condition: { test: "datum.on", value: strong }, value: 0.08 });
    const goals = data.goals.includes(x) && data.goals.includes(y) &&
      front_rows().some((row) => row.front);
    const whiskers = [
      ["left", "right", { x: { field: "left", ...axis(x) }, x2: { field: "right" }, y: { field: "y", ...axis(y) } }],
      ["low", "high", { y: { field: "low", ...axis(y) }, y2: { field: "high" }, x: { field: "x", ...axis(x) } }],
    ].filter(([from, to]) => front_rows().some((row) => row[from] !== row[to]))
      .map(([, , encoding]) => ({
        // Of many points only the base and the front have room for theirs
        transform: points.length > 100 ? [{ filter: "datum.front || datum.point === 0" }] : [],
        mark: { type: "rule", strokeWidth: 1.2, clip: true, aria: false },
        encoding: { ...encoding, color, opacity: faded(0.45) },
      }));
    return draw("front-chart", {
      height: 380,
      data: { name: "points", values: front_rows() },
      layer: [
        ...whiskers,
        ...(goals ? [{
          transform: [{ filter: "datum.front" }],
          mark: { type: "line", strokeDash: [4, 3], strokeWidth: 1, color: css("--faint"), aria: false },
          encoding: { x: { field: "x", ...axis(x) }, y: { field: "y", ...axis(y) }, order: { field: "x" } },
        }] : []),
        { mark: { type: "point", filled: true, size: 90, cursor: "pointer" },
          encoding: { x: { field: "x", ...axis(x) }, y: { field: "y", ...axis(y) }, color, shape,
            opacity: faded(1), tooltip } },
        { transform: [{ filter: "datum.label !== ''" }],
          mark: { type: "text", dy: -11, fontSize: 11, limit: 140, aria: false },
          encoding: { x: { field: "x", ...axis(x) }, y: { field: "y", ...axis(y) },
            text: { field: "label" }, opacity: faded(1) } },
      ],
    });
  }

  // --- Parallel coordinates ---
  const axes = () => [
    ...data.knobs.map((knob) => ({ name: knob.name, words: knob.order,
      of: (at) => knob.order.indexOf(knob.value[at]) })),
    ...data.led.map((name) => ({ name, of: (at) => figures.get(name).value[at] })),
  ].map((axis) => {
    const values = points.map(axis.of).filter((value) => value !== null);
    return { ...axis, low: Math.min(...values), high: Math.max(...values) };
  });
  const height_on = (axis, at) => {
    const value = axis.of(at);
    if (value === null) return null;
    return axis.high === axis.low ? 0.5 : (value - axis.low) / (axis.high - axis.low);
  };
  const measured = (at) => !["failed", "not measured"].includes(data.points.standing[at]);
  const parallel_rows = () => axes().flatMap((axis) => points.filter(measured).map((at) => ({
    point: at, standing: standing_of(at), on: on[at], axis: axis.name, height: height_on(axis, at),
  }))).filter((row) => row.height !== null);
  async function draw_parallel() {
    if (!by_id("parallel-chart")) return;
    const { color, dash } = standing_scales({ symbolType: "stroke", symbolSize: 500, symbolStrokeWidth: 2 });
    const ends = axes().flatMap((axis) => {
      const word = (value) => (axis.words ? axis.words[value] : shown(value));
      const all = axis.words && axis.words.length <= 16 ? axis.words.map((text, at) => [at, text])
        : [[axis.low, word(axis.low)], [axis.high, word(axis.high)]];
      return all.filter(([value], at) => at === 0 || axis.high !== axis.low).map(([value, text]) => ({
        axis: axis.name, text,
        height: axis.high === axis.low ? 0.5 : (value - axis.low) / (axis.high - axis.low) }));
    });
    const x = { field: "axis", type: "nominal", sort: null, title: null, scale: { type: "point", padding: 0.4 },
      axis: { labelAngle: 0, grid: true, orient: "top", labelOverlap: false, labelLimit: 150 } };
    const y = { field: "height", type: "quantitative", axis: null, scale: { domain: [0, 1], padding: 12 } };
    const few = points.length < 60;
    const view = await draw("parallel-chart", {
      height: 300,
      data: { name: "points", values: parallel_rows() },
      layer: [
        { mark: { type: "line", strokeWidth: few ? 1.8 : 1, aria: false },
          encoding: { x, y, color, detail: { field: "point" }, strokeDash: dash,
            opacity: { condition: { test: "datum.on", value: few ? 0.8 : 0.4 }, value: 0.04 } } },
        { params: [{ name: "brush", select: { type: "interval" } }],
          mark: { type: "point", filled: true, size: 36 },
          encoding: { x, y, color, tooltip,
            opacity: { condition: { test: "datum.on", value: 0.9 }, value: 0.04 } } },
        ...[{ stroke: css("--paper"), strokeWidth: 4 }, {}].map((halo) => ({
          data: { values: ends },
          mark: { type: "text", align: "left", dx: 7, fontSize: 11, aria: false, ...halo },
          encoding: { x, y, text: { field: "text" } } })),
      ],
    });
    // The brush is for the mouse; the words above the table do the same for all
    for (const path of by_id("parallel-chart").querySelectorAll("path[class*=brush_brush]"))
      path.setAttribute("aria-hidden", "true");
    for (const group of by_id("parallel-chart").querySelectorAll("g[class*=brush_brush]"))
      group.setAttribute("aria-hidden", "true");
    view.addSignalListener("brush", (name, value) => {
      const wanted = value.axis || [], heights = value.height || [];
      const chosen = axes().filter((axis) => wanted.includes(axis.name));
      const [low, high] = [Math.min(...heights), Math.max(...heights)];
      brushed = points.map((at) => heights.length === 0 || chosen.every((axis) => {
        const height = height_on(axis, at);
        return height !== null && measured(at) && height >= low && height <= high;
      }));
      pick();
    });
  }

  // --- Who is picked: by the brush and by the words above the table ---
  function pick() {
    const wanted = by_id("only") ? by_id("only").value.trim().toLowerCase().split(/\s+/) : [];
    on = points.map((at) => brushed[at] && wanted.every((word) =>
      `${data.points.name[at]} ${data.points.standing[at]} ${settings_of(at)}`.toLowerCase().includes(word)));
    for (const row of document.querySelectorAll("#points-table tbody tr"))
      row.hidden = !on[row.dataset.point];
    say_picked();
    for (const [id, rows] of [["front-chart", front_rows], ["parallel-chart", parallel_rows], ["heat-chart", heat_rows]])
      if (views.has(id)) views.get(id).view.data("points", rows()).runAsync();
  }
  function say_picked() {
    if (by_id("picked")) by_id("picked").textContent = `${on.filter(Boolean).length} of ${points.length} points`;
  }

  // --- Sensitivity, heat map ---
  function draw_effects() {
    const effect = data.effects.find((one) => one.figure === by_id("effects-figure").value);
    const figure = figures.get(effect.figure);
    const rows = effect.value.map((value, at) => ({
      label: `${effect.knob[at]} ${effect.step[at]}`, value,
      sure: Math.abs(value) > (effect.half[at] || 0) ? "surely" : "not surely",
      low: value - (effect.half[at] || 0), high: value + (effect.half[at] || 0),
      lines: [`${effect.knob[at]}: ${effect.step[at]}`,
        `${data.steps ? "change" : "mean"} of ${title_of(effect.figure)}: ${shown(value)}` +
        (effect.half[at] ? ` +/- ${Number(effect.half[at].toPrecision(2))}` : ""),
        `${effect.count[at]} ${data.steps ? "pairs" : "points"}`],
    }));
    const unit = figure.unit.startsWith("%") && data.steps ? figure.unit.replace("%", "points") : figure.unit;
    const x = { type: "quantitative", title: `${data.steps ? "change of " : ""}${effect.figure} (${unit})`,
      scale: { zero: data.steps } };
    const y = { field: "label", type: "nominal", sort: null, title: null };
    const sure = { field: "sure", title: null, legend: { orient: "top" },
      scale: { domain: ["surely", "not surely"], range: [colours()[0], css("--faint")] } };
    const end = (field) => ({ mark: { type: "tick", thickness: 1.6, size: 9, color: css("--ink"), aria: false },
      encoding: { x: { field, ...x }, y } });
    return draw("effects-chart", {
      height: Math.max(70, 24 * rows.length),
      data: { values: rows },
      layer: [
        { mark: data.steps ? { type: "bar", height: { band: 0.62 } } : { type: "point", filled: true, size: 70 },
          encoding: { x: { field: "value", ...x }, y, tooltip,
            ...(data.steps ? { color: sure,
              fillOpacity: { condition: { test: "datum.sure === 'surely'", value: 1 }, value: 0.45 } }
              : { color: { value: colours()[0] } }) } },
        { mark: { type: "rule", strokeWidth: 1.6, color: css("--ink"), aria: false },
          encoding: { x: { field: "low", ...x }, x2: { field: "high" }, y } },
        end("low"), end("high"),
      ],
    });
  }
  function heat_rows() {
    const x = knobs.get(by_id("heat-x").value), y = knobs.get(by_id("heat-y").value);
    const figure = figures.get(by_id("heat-figure").value);
    const fields = new Map();
    for (const at of points) {
      if (figure.value[at] === null || !on[at]) continue;
      const key = JSON.stringify([x.value[at], y.value[at]]);
      if (!fields.has(key)) fields.set(key, { x: x.value[at], y: y.value[at], sum: 0, count: 0 });
      fields.get(key).sum += figure.value[at];
      fields.get(key).count += 1;
    }
    return [...fields.values()].map((field) => ({ ...field, mean: field.sum / field.count,
      text: shown(Number((field.sum / field.count).toPrecision(4))),
      lines: [`${title_of(figure.name)}: ${shown(field.sum / field.count)}`, `${x.name}=${field.x}`,
        `${y.name}=${field.y}`, `${field.count} ${field.count === 1 ? "point" : "points"}`] }));
  }
  function draw_heat() {
    const x = knobs.get(by_id("heat-x").value), y = knobs.get(by_id("heat-y").value);
    const name = by_id("heat-figure").value;
    const rows = heat_rows();
    const low = Math.min(...rows.map((row) => row.mean)), high = Math.max(...rows.map((row) => row.mean));
    const place = {
      x: { field: "x", type: "nominal", sort: x.order, scale: { domain: x.order }, title: x.name, axis: { labelAngle: 0 } },
      y: { field: "y", type: "nominal", sort: y.order, scale: { domain: [...y.order].reverse() }, title: y.name },
    };
    return draw("heat-chart", {
      height: Math.min(420, Math.max(90, 44 * y.order.length)),
      data: { name: "points", values: rows },
      layer: [
        { mark: { type: "rect", stroke: css("--paper") }, encoding: { ...place, tooltip,
          color: { field: "mean", type: "quantitative", title: title_of(name),
            scale: { scheme: "cividis", domain: [low, high] } } } },
        ...(x.order.length <= 16 ? [{ mark: { type: "text", fontSize: 11, aria: false },
          encoding: { ...place, text: { field: "text" },
            color: { condition: { test: `datum.mean > ${(low + high) / 2}`, value: "#000" }, value: "#fff" } } }] : []),
      ],
    });
  }

  // --- Cells, slack, causes: of a few points ---
  const focus_names = () => data.focus.map((at) => data.points.name[at]);
  // Beyond eight they come again, half as strong
  const mixed = (colour, paper) => "#" + [1, 3, 5].map((at) => Math.round(
    (parseInt(colour.slice(at, at + 2), 16) + parseInt(paper.slice(at, at + 2), 16)) / 2)
    .toString(16).padStart(2, "0")).join("");
  const many = (count) => Array.from({ length: count }, (unused, at) =>
    at % 16 < 8 ? colours()[at % 8] : mixed(colours()[at % 8], css("--paper")));
  function stacked(id, rows, parts, title) {
    const height = Math.max(60, 34 * new Set(rows.map((row) => row.name)).size);
    return draw(id, {
      height,
      data: { values: rows },
      mark: { type: "bar", stroke: css("--paper"), strokeWidth: 1.5 },
      encoding: {
        y: { field: "name", type: "nominal", sort: focus_names(), title: null },
        x: { field: "value", type: "quantitative", title, stack: "zero" },
        order: { field: "rank" },
        color: { field: "part", title: null, sort: parts, scale: { domain: parts, range: many(parts.length) },
          legend: { orient: "bottom", columns: 5 } },
        tooltip,
      },
    });
  }
  function draw_units() {
    const { point, unit, cells, flip_flops } = data.units;
    const sums = new Map();
    unit.forEach((name, at) => sums.set(name, (sums.get(name) || 0) + cells[at]));
    const parts = [...sums.keys()].sort((a, b) => sums.get(b) - sums.get(a));
    return stacked("units-chart", unit.map((name, at) => ({
      name: data.points.name[point[at]], part: name, value: cells[at], rank: parts.indexOf(name),
      lines: [`${name} of ${data.points.name[point[at]]}`, `${shown(cells[at])} cells`,
        `${shown(flip_flops[at])} flip-flops`],
    })), parts, "generic cells");
  }
  function draw_causes() {
    return stacked("causes-chart", data.causes.flatMap((name, rank) => data.focus
      .filter((at) => figures.get(name).value[at] !== null).map((at) => ({
        name: data.points.name[at], part: name, value: figures.get(name).value[at], rank,
        lines: [`${name} of ${data.points.name[at]}`, `${interval(figures.get(name), at)} % of the pixels`,
          figures.get(name).meaning] }))), data.causes, "% of the pixels");
  }
  function draw_slack() {
    const step = data.slack.step;
    const bins = 2 + Math.max(...data.slack.points.map((one) => one.percent.findLastIndex((share) => share > 0.001)));
    const rows = data.slack.points.flatMap((one) => one.percent.slice(0, bins).map((percent, bin) => ({
      name: data.points.name[one.point], clocks: bin * step, percent,
      lines: [data.points.name[one.point],
        `${bin * step} to ${(bin + 1) * step - 1} clocks: ${shown(percent)} % of the pixels`] })));
    const names = data.slack.points.map((one) => data.points.name[one.point]);
    const dashes = [[1, 0], [6, 3], [2, 2], [8, 2, 2, 2], [12, 4], [4, 4], [1, 3], [10, 3, 3, 3]];
    const legend = { symbolType: "stroke", symbolSize: 500, symbolStrokeWidth: 2 };
    const color = { field: "name", title: null, sort: names, legend, scale: { domain: names, range: many(names.length) } };
    return draw("slack-chart", {
      height: 260,
      data: { values: rows },
      encoding: {
        x: { field: "clocks", type: "quantitative", title: "clocks from known to shown", scale: { nice: false } },
        y: { field: "percent", type: "quantitative", title: "% of the pixels" },
        color,
      },
      layer: [
        { mark: { type: "line", interpolate: "step-after", strokeWidth: 2, aria: false },
          encoding: { strokeDash: { field: "name", title: null, sort: names, legend,
            scale: { domain: names, range: dashes.slice(0, names.length) } } } },
        { mark: { type: "point", opacity: 0, size: 60 }, encoding: { tooltip } },
      ],
    });
  }

  // --- One point beside the base ---
  function difference(of, base, parent) {
    const canvas = element("canvas", "", parent);
    canvas.width = of.naturalWidth;
    canvas.height = of.naturalHeight;
    const pen = canvas.getContext("2d", { willReadFrequently: true });
    const pixels = [of, base].map((image) => {
      pen.drawImage(image, 0, 0);
      return pen.getImageData(0, 0, canvas.width, canvas.height);
    });
    let count = 0;
    for (let at = 0; at < pixels[0].data.length; at += 4) {
      const differs = [0, 1, 2].some((i) => pixels[0].data[at + i] !== pixels[1].data[at + i]);
      count += differs;
      const grey = (pixels[0].data[at] + pixels[0].data[at + 1] + pixels[0].data[at + 2]) / 9;
      const colour = differs ? [255, 176, 0] : [grey, grey, grey];
      for (let i = 0; i < 3; ++i) pixels[0].data[at + i] = colour[i];
    }
    pen.putImageData(pixels[0], 0, 0);
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", `where they differ: ${count} pixels`);
    element("p", `where they differ: ${count.toLocaleString("en")} pixels`, parent);
  }
  async function choose(at) {
    const look = by_id("look");
    look.replaceChildren();
    element("h3", `${data.points.name[at]}, ${data.points.standing[at]}`, look);
    element("p", settings_of(at), look);
    for (const row of document.querySelectorAll("#points-table tbody tr"))
      row.classList.toggle("chosen", Number(row.dataset.point) === at);
    const add = (picture, words) => {
      const image = element("img", "", look);
      image.alt = words;
      image.src = picture.source;
      element("p", words, look);
      return image;
    };
    const [own] = pictures_of(at);
    if (own) {
      const image = add(own, `frame ${own.frame} as ${data.points.name[at]} draws it`);
      const base = pictures_of(0).find((one) => one.frame === own.frame && one.scene === own.scene);
      if (base && at !== 0) {
        const other = add(base, `as ${data.points.name[0]} draws it`);
        await Promise.all([image.decode(), other.decode()]);
        if (image.naturalWidth === other.naturalWidth && image.isConnected) difference(image, other, look);
      }
    } else {
      element("p", "No picture of it is on this page; this command draws one:", look);
    }
    const row = document.querySelector(`#points-table tr[data-point="${at}"] code`);
    if (row) element("code", row.textContent, look);
  }

  // --- Tables ---
  function make_sortable(table) {
    const heads = [...table.tHead.rows[0].cells];
    heads.forEach((head, column) => {
      const button = element("button");
      button.type = "button";
      button.append(...head.childNodes);
      head.append(button);
      button.addEventListener("click", () => {
        const up = head.getAttribute("aria-sort") !== "ascending";
        heads.forEach((one) => one.removeAttribute("aria-sort"));
        head.setAttribute("aria-sort", up ? "ascending" : "descending");
        const key = (row) => row.cells[column].dataset.by ?? row.cells[column].textContent;
        const order = (a, b) => {
          const [x, y] = [key(a), key(b)], [p, q] = [Number(x), Number(y)];
          if (x === "-" || y === "-") return (x === "-") - (y === "-"); // nothing: at the end
          const numbers = x !== "" && y !== "" && !Number.isNaN(p) && !Number.isNaN(q);
          return (up ? 1 : -1) * (numbers ? p - q : x.localeCompare(y, "en", { numeric: true }));
        };
        const body = table.tBodies[0];
        body.append(...[...body.rows].sort(order));
      });
    });
  }
  function make_points_table() {
    const table = by_id("points-table");
    if (!table) return;
    for (const row of table.tBodies[0].rows) {
      const at = Number(row.dataset.point);
      const name = row.cells[0], code = row.querySelector("code");
      const button = element("button");
      button.type = "button";
      button.append(...name.childNodes);
      name.append(button);
      button.addEventListener("click", () => choose(at));
      const copy = element("button", "copy", code.parentNode);
      copy.type = "button";
      copy.className = "copy";
      copy.setAttribute("aria-label", `copy the command of ${data.points.name[at]}`);
      copy.addEventListener("click", async () => {
        const range = document.createRange();
        range.selectNodeContents(code);
        getSelection().removeAllRanges();
        getSelection().addRange(range);
        // A page from the disk may have no clipboard: then the words are selected, to be copied
        try {
          await navigator.clipboard.writeText(code.textContent);
          copy.textContent = "copied";
        } catch (refused) {
          copy.textContent = document.execCommand("copy") ? "copied" : "selected";
        }
      });
      name.addEventListener("mouseenter", (event) => show_tip(event, lines_of({ point: at }), at));
      name.addEventListener("mouseleave", hide_tip);
    }
    by_id("only").addEventListener("input", pick);
  }

  // --- Controls ---
  function fill(id, names, chosen, draw_again) {
    const select = by_id(id);
    for (const name of names) {
      const option = element("option", name, select);
      option.value = name;
      option.selected = name === chosen;
    }
    select.addEventListener("change", draw_again);
  }
  function draw_all() {
    const all = [];
    if (by_id("front-chart")) all.push(draw_front());
    if (by_id("parallel-chart")) all.push(draw_parallel());
    if (by_id("effects-chart")) all.push(draw_effects());
    if (by_id("heat-chart")) all.push(draw_heat());
    if (by_id("units-chart")) all.push(draw_units());
    if (by_id("slack-chart")) all.push(draw_slack());
    if (by_id("causes-chart")) all.push(draw_causes());
    return Promise.all(all);
  }

  document.documentElement.classList.add("scripts");
  const names = [...figures.keys()];
  const preferred = [...new Set([...data.goals, ...data.led, ...names])].filter((name) => figures.has(name));
  if (by_id("front-chart")) {
    const across = preferred.length > 1 ? preferred[1] : preferred[0];
    fill("front-x", names, across, draw_front);
    fill("front-y", names, preferred[0], draw_front);
  }
  if (by_id("effects-chart")) fill("effects-figure", data.effects.map((one) => one.figure),
    data.effects[0].figure, draw_effects);
  if (by_id("heat-chart")) {
    const all = [...knobs.keys()];
    fill("heat-x", all, all[0], draw_heat);
    fill("heat-y", all, all[1], draw_heat);
    fill("heat-figure", names, preferred[0], draw_heat);
  }
  for (const table of document.querySelectorAll("table")) make_sortable(table);
  make_points_table();
  if (by_id("all-points")) by_id("all-points").addEventListener("click", () => {
    if (by_id("only")) by_id("only").value = "";
    brushed = points.map(() => true);
    on = points.map(() => true);
    draw_parallel();
    pick();
  });
  say_picked();
  if (by_id("look") && data.focus.length) choose(data.focus[data.focus.length - 1]);
  const drawn = () => draw_all().then(() => { document.documentElement.dataset.drawn = "yes"; });
  dark.addEventListener("change", drawn);
  drawn();
})();
