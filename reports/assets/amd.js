// Vega's packaged components are anonymous AMD modules; they come in dependency order, so this is loader enough.
var modules = {}, current = "";
function define(needs, make) {
  var made = modules[current] = {};
  make.apply(null, needs.map(function (n) { return n === "exports" ? made : modules[n]; }));
}
define.amd = true;
