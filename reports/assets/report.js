// Sorting and filtering the table of rows; buttons that copy. Without scripting the page is the same, minus these.
"use strict";
(function () {
  var table = document.querySelector("table.rows");
  if (table) {
    var body = table.tBodies[0];
    var rows = Array.from(body.rows);

    Array.from(table.tHead.rows[0].cells).forEach(function (head, column) {
      var button = document.createElement("button");
      button.append.apply(button, Array.from(head.childNodes));
      head.append(button);
      button.onclick = function () {
        var up = head.getAttribute("aria-sort") === "descending";
        Array.from(table.tHead.rows[0].cells).forEach(function (h) { h.removeAttribute("aria-sort"); });
        head.setAttribute("aria-sort", up ? "ascending" : "descending");
        var numeric = rows[0].cells[column].hasAttribute("data-key");
        var key = function (row) { return numeric ? Number(row.cells[column].dataset.key) : row.cells[column].textContent; };
        rows.map(function (row, i) { return [key(row), i, row]; }).sort(function (a, b) {
          var order = numeric ? a[0] - b[0] : a[0].localeCompare(b[0], "en");
          return (up ? order : -order) || a[1] - b[1];
        }).forEach(function (entry) { body.append(entry[2]); });
      };
    });

    var filters = document.getElementById("row-filters");
    var chosen = {};
    var count = document.createElement("span");
    count.setAttribute("aria-live", "polite");
    var apply = function () {
      var seen = 0;
      rows.forEach(function (row) {
        row.hidden = Object.keys(chosen).some(function (k) {
          return chosen[k] && (k === "text" ? row.textContent.toLowerCase().indexOf(chosen[k]) < 0 : row.dataset[k] !== chosen[k]);
        });
        seen += row.hidden ? 0 : 1;
      });
      count.textContent = seen + " of " + rows.length + " rows";
    };
    [["question", "Question"], ["method", "Method"], ["distribution", "Distribution"], ["wrong", "Errors"]].forEach(function (f) {
      var values = Array.from(new Set(rows.map(function (r) { return r.dataset[f[0]]; })));
      var label = document.createElement("label"), list = document.createElement("select");
      list.append(new Option("any", ""));
      values.forEach(function (v) { list.append(new Option(v, v)); });
      list.onchange = function () { chosen[f[0]] = list.value; apply(); };
      label.append(f[1] + " ", list);
      filters.append(label);
    });
    var find = document.createElement("input");
    find.type = "search";
    find.placeholder = "any text";
    find.setAttribute("aria-label", "Filter rows by text");
    find.oninput = function () { chosen.text = find.value.toLowerCase(); apply(); };
    filters.append(find, count);
    filters.hidden = false;
    apply();
  }

  document.querySelectorAll("pre.copy").forEach(function (pre) {
    var box = document.createElement("div"), button = document.createElement("button");
    box.className = "copyable";
    button.textContent = "copy";
    button.onclick = function () {
      var done = function () { button.textContent = "copied"; setTimeout(function () { button.textContent = "copy"; }, 1500); };
      var byHand = function () { getSelection().selectAllChildren(pre); button.textContent = "selected"; };
      if (navigator.clipboard) { navigator.clipboard.writeText(pre.textContent).then(done, byHand); } else { byHand(); }
    };
    pre.replaceWith(box);
    box.append(pre, button);
  });
})();
