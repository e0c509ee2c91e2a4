// The speed-against-error plot with controls. The still pictures above it come from the same numbers and stay for print,
// for readers without scripting, and whenever anything here fails.
"use strict";
(function () {
  var WIDTH = 440, HEIGHT = 330;
  var holder = document.getElementById("plot-data");
  if (!holder) return;

  function colour(name) { return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim(); }

  function percent(rate) {
    if (rate === 0) return "0";
    return rate < 1e-3 ? rate.toExponential(1) : (100 * rate).toPrecision(3).replace(/\.?0+$/, "") + " %";
  }

  function describe(p) {
    var count = p.k.toLocaleString("en") + " of " + p.n.toLocaleString("en");
    return {
      title: p.m + (p.d ? " on " + p.d : ""),
      text: p.t + ", " + p.s + "\n" + count + (p.k ? " = " + percent(p.y) : "") + "\n95 %: " +
        (p.k ? percent(p.lo) + " to " + percent(p.hi) : "below " + percent(p.hi)) + "\n" + p.ns.toPrecision(3) + " ns per case"
    };
  }

  function axis(scale, orient, title, ticks) {
    var labels = ticks.map(function (t) { return "datum.value === " + t.v + " ? '" + t.l + "' : "; }).join("") + "''";
    return {
      scale: scale, orient: orient, title: title + " (log)", values: ticks.map(function (t) { return t.v; }), grid: true,
      encode: { labels: { update: { text: { signal: labels } } } }, titlePadding: orient === "left" ? 4 : 6,
      gridColor: colour("line"), gridWidth: 0.7, domainColor: colour("soft"), ticks: false, labelPadding: 5, labelOverlap: false,
      labelColor: colour("soft"), titleColor: colour("soft"), labelFontSize: 11.5, titleFontSize: 11.5, titleFontWeight: "normal",
      titleX: orient === "left" ? -38 : undefined, titleY: orient === "left" ? HEIGHT / 2 : undefined,
      labelFont: "system-ui, sans-serif", titleFont: "system-ui, sans-serif"
    };
  }

  function spec(panel, view, labels) {
    var tiers = ["trivial", "naive", "certified", "exact", "plug-in"];
    var x = { scale: "x", field: "x" }, y = { scale: "y", field: "y" }, tint = { scale: "tint", field: "t" };
    var fade = { signal: "focus && focus !== datum.m ? 0.18 : 1" };
    var hover = { signal: "describe(datum)" };
    function rule(data, encode) {
      encode.stroke = tint; encode.strokeWidth = { value: 1.6 }; encode.opacity = fade;
      return { type: "rule", from: { data: data }, interactive: false, encode: { update: encode } };
    }
    return {
      width: WIDTH, height: HEIGHT, padding: { left: 50, top: 28, right: 10, bottom: 44 }, autosize: "none",
      title: { text: panel.title, anchor: "start", frame: "group", offset: 10, color: colour("ink"), fontSize: 13.5, font: "system-ui, sans-serif", fontWeight: 600 },
      signals: [{ name: "focus", value: "", on: [{ events: "@mark:mouseover", update: "datum.m" }, { events: "@mark:mouseout", update: "''" }] }],
      data: [
        { name: "points", values: view.points },
        { name: "seen", source: "points", transform: [{ type: "filter", expr: "datum.k > 0" }] },
        { name: "zeros", source: "points", transform: [{ type: "filter", expr: "datum.k === 0" }] }
      ],
      scales: [
        { name: "x", type: "log", domain: [view.x.lo, view.x.hi], range: [0, WIDTH] },
        { name: "y", type: "log", domain: [panel.y.lo, panel.y.hi], range: [HEIGHT, 0], clamp: true },
        { name: "tint", type: "ordinal", domain: tiers, range: tiers.map(colour) },
        { name: "shape", type: "ordinal", domain: ["f32", "f64", "other"], range: ["circle", "square", "diamond"] }
      ],
      axes: [axis("x", "bottom", "ns per case", view.x.ticks), axis("y", "left", panel.axis, panel.y.ticks)],
      marks: [].concat.apply([], view.references.map(function (r) { return [
        { type: "rule", interactive: false, encode: { update: { x: { scale: "x", value: r.x }, y: { value: 0 }, y2: { value: HEIGHT }, stroke: { value: colour("exact") }, strokeWidth: { value: 1.5 }, strokeDash: { value: [5, 4] } } } },
        { type: "text", interactive: false, encode: { update: { x: { scale: "x", value: r.x, offset: -5 }, y: { value: 2 }, angle: { value: -90 }, align: { value: "right" }, text: { value: r.l }, fill: { value: colour("soft") }, fontSize: { value: 11.5 }, font: { value: "system-ui, sans-serif" } } } }
      ]; })).concat([
        rule("seen", { x: x, y: { scale: "y", field: "lo" }, y2: { scale: "y", field: "hi" } }),
        rule("zeros", { x: x, y: { scale: "y", field: "y", offset: 5 }, y2: { scale: "y", field: "y", offset: 18 } }),
        { type: "symbol", from: { data: "zeros" }, interactive: false, encode: { update: { x: x, y: { scale: "y", field: "y", offset: 18 }, shape: { value: "triangle-down" }, size: { value: 26 }, fill: tint, opacity: fade } } },
        { name: "mark", type: "symbol", from: { data: "points" }, encode: { update: {
          x: x, y: y, size: { value: 84 }, strokeWidth: { value: 1.8 }, stroke: tint, opacity: fade, cursor: { value: "default" }, tooltip: hover,
          shape: { signal: "scale('shape', datum.s === 'f32' || datum.s === 'f64' ? datum.s : 'other')" },
          fill: [{ test: "datum.k === 0", value: colour("paper") }, tint]
        } } }
      ], labels ? [
        { type: "text", from: { data: "points" }, interactive: false, encode: { update: {
          x: x, y: y, dx: { field: "dx" }, dy: { field: "dy" }, text: { field: "label" }, fontSize: { value: 11.5 }, font: { value: "system-ui, sans-serif" },
          align: { signal: "datum.a === 'start' ? 'left' : datum.a === 'end' ? 'right' : 'center'" }, fill: { value: colour("ink") }, opacity: fade
        } } }
      ] : [])
    };
  }

  // One flat namespace, as vega's own bundle has it, of the parts that a view needs.
  function load() {
    var registry = vega["vega-dataflow"].transforms;
    ["vega-transforms", "vega-view-transforms", "vega-encode"].forEach(function (name) { Object.assign(registry, vega[name]); });
    vega["vega-functions"].expressionFunction("describe", describe);
  }

  var bubble = document.createElement("div");
  bubble.className = "vega-tooltip";
  bubble.hidden = true;
  function tooltip(handler, event, item, value) {
    bubble.hidden = !value;
    if (!value) return;
    bubble.textContent = "";
    var name = document.createElement("b");
    name.textContent = value.title;
    bubble.append(name, "\n" + value.text);
    bubble.style.left = Math.min(event.clientX + 14, innerWidth - bubble.offsetWidth - 8) + "px";
    bubble.style.top = Math.min(event.clientY + 14, innerHeight - bubble.offsetHeight - 8) + "px";
  }

  function select(label, entries) {
    var box = document.createElement("label"), list = document.createElement("select");
    entries.forEach(function (e) { list.append(new Option(e[1], e[0])); });
    box.append(label + " ", list);
    document.getElementById("plot-controls").append(box);
    return list;
  }

  try {
    load();
    var questions = JSON.parse(holder.textContent);
    var live = document.getElementById("plot-live");
    var question = select("Question", questions.map(function (q, i) { return [i, q.name]; }));
    var names = [];
    questions.forEach(function (q) { q.panels.forEach(function (p) { p.views.forEach(function (v) { if (v.name[0] === "=" && names.indexOf(v.name) < 0) names.push(v.name); }); }); });
    var distribution = select("Distribution", [["", "all, pooled"], ["*", "all, each on its own"]].concat(names.sort().map(function (n) { return [n, n.slice(1)]; })));

    var draw = function () {
      live.textContent = "";
      var q = questions[question.value];
      q.panels.forEach(function (panel) {
        var view = panel.views.filter(function (v) { return v.name === distribution.value; })[0];
        if (!view) return;
        var place = document.createElement("div");
        live.append(place);
        new vega["vega-view"].View(vega["vega-parser"].parse(spec(panel, view, distribution.value !== "*")),
          { renderer: "svg", container: place, hover: true, tooltip: tooltip }).run();
        var svg = place.querySelector("svg");
        svg.setAttribute("role", "img");
        svg.setAttribute("aria-label", panel.title + " against time for " + q.name);
        if (!view.points.length) place.append("Nothing was timed and asked here.");
      });
    };
    draw();
    document.body.append(bubble);
    question.onchange = distribution.onchange = draw;
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
    live.hidden = document.getElementById("plot-controls").hidden = false;
    document.querySelectorAll("figure.still").forEach(function (f) { f.hidden = true; });
  } catch (error) {
    document.getElementById("plot-live").textContent = "";
    document.getElementById("plot-controls").textContent = "";
    console.error(error);
  }
})();
