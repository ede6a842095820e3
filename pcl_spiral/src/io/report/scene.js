// SPDX-License-Identifier: BSD-3-Clause
// The scene of a report: part, path and stock, and the tool that moves over them. Lengths in mm, times in s.
// The page has its data as JSON in #scene-data, and THREE (three.js, MIT) before this script.
(function () {
"use strict";

const section = document.getElementById("scene");
const find = selector => section.querySelector(selector);
const canvas = find("canvas"), slider = find("input[type=range]");
const data = JSON.parse(document.getElementById("scene-data").textContent);

// ---- Arrays: base64 of little-endian numbers; value = low + step * number, and the number `none` stands for nothing.
const types = {u8: Uint8Array, i8: Int8Array, u16: Uint16Array, u32: Uint32Array, f32: Float32Array};

function unpacked(name) {
  const array = data.arrays[name];
  if (!array)
    return null;
  const text = atob(array.data), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  const numbers = new types[array.type](bytes.buffer);
  array.data = "";
  if (!array.step)
    return numbers;
  const values = new Float32Array(numbers.length), n = array.step.length;
  for (let i = 0; i < numbers.length; ++i)
    values[i] = numbers[i] === array.none ? NaN : array.low[i % n] + array.step[i % n] * numbers[i];
  return values;
}

const [time, tip, contact, axis, length, feed, turn, move, angles, number] =
  ["time", "tip", "contact", "axis", "length", "feed", "turn", "move", "angles", "number"].map(unpacked);
const frames = time.length, lastTime = time[frames - 1];

// ---- Colours
const ramp = ["#2c2f7d", "#2b6fb5", "#35a5a0", "#7cc67a", "#e8df5a"]; // of a range, from low to high
const diverging = ["#2a4fb0", "#9db7e4", "#f1f1ef", "#ecae8e", "#b0282a"];
const plain = "#b9c0c9", uncut = "#d9a860", below = "#d60a12", above = "#ff7a00", unknown = "#8d939c";
const ways = [{name: "path", colour: "#14305f"}, {name: "links between passes", colour: "#c2187a"}, {name: "through the air", colour: "#5d9b3c"}];

function rampTexture(stops) {
  const texels = new Uint8Array(256 * 4), a = new THREE.Color(), b = new THREE.Color();
  for (let i = 0; i < 256; ++i) {
    const at = i / 255 * (stops.length - 1), k = Math.min(stops.length - 2, Math.floor(at));
    const colour = a.set(stops[k]).lerp(b.set(stops[k + 1]), at - k);
    texels.set([255 * colour.r, 255 * colour.g, 255 * colour.b, 255], 4 * i);
  }
  const texture = new THREE.DataTexture(texels, 256, 1, THREE.RGBAFormat);
  texture.magFilter = texture.minFilter = THREE.LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

// ---- The part: each place keeps when its stock falls first, and to what; and when to what is left.
const partShader = {
  vertexShader: `
    attribute float stock, deviation, cutAt, firstAt, firstStock;
    uniform float now, raise, uncutHeight;
    uniform int colouring; // 0 plain, 1 stock, 2 deviation
    varying vec3 shadeNormal, eye;
    varying float value, waiting;
    void main() {
      waiting = now < firstAt ? 1.0 : 0.0;
      float height = now < cutAt ? firstStock : stock;
      float left = waiting > 0.5 ? uncutHeight : height;
      vec4 place = modelViewMatrix * vec4(position + raise * (left > -1e20 ? left : 0.0) * normal, 1.0);
      value = colouring == 2 ? deviation : height;
      shadeNormal = normalMatrix * normal;
      eye = -place.xyz;
      gl_Position = projectionMatrix * place;
    }`,
  fragmentShader: `
    uniform sampler2D colours;
    uniform vec3 plain, uncut, below, above, unknown;
    uniform vec2 range;
    uniform int colouring;
    varying vec3 shadeNormal, eye;
    varying float value, waiting;
    void main() {
      vec3 colour = plain;
      if (colouring > 0) {
        float share = (value - range.x) / (range.y - range.x);
        colour = value < -1e20 ? unknown : share < -1e-4 ? below : share > 1.0001 ? above : texture2D(colours, vec2(share, 0.5)).rgb;
      }
      colour = mix(colour, uncut, clamp(waiting, 0.0, 1.0));
      vec3 n = normalize(shadeNormal);
      float light = dot(n, normalize(eye));
      gl_FragColor = vec4(colour * (0.42 + 0.62 * abs(light)) * (light < 0.0 ? 0.72 : 1.0), 1.0);
    }`
};
const nothing = -1e30; // a value that is not known

function attribute(geometry, name, values, size, count) {
  const known = values || new Float32Array(count).fill(nothing);
  for (let i = 0; values && i < known.length; ++i)
    if (Number.isNaN(known[i]))
      known[i] = nothing;
  geometry.setAttribute(name, new THREE.BufferAttribute(known, size));
}

function makePart() {
  const places = unpacked("places"), triangles = unpacked("triangles"), count = places.length / 3;
  const geometry = new THREE.BufferGeometry();
  attribute(geometry, "position", places, 3, count);
  attribute(geometry, "normal", unpacked("normals"), 3, count);
  for (const name of ["stock", "deviation", "cutAt", "firstStock"])
    attribute(geometry, name, unpacked(name), 1, count);
  geometry.setAttribute("firstAt", data.arrays.firstAt ? new THREE.BufferAttribute(unpacked("firstAt"), 1) : geometry.getAttribute("cutAt"));
  const colours = {plain, uncut, below, above, unknown}, uniforms = {
    now: {value: 0}, raise: {value: 0}, uncutHeight: {value: data.uncut}, colouring: {value: 0},
    range: {value: new THREE.Vector2(0, 1)}, colours: {value: null}
  };
  for (const name in colours)
    uniforms[name] = {value: new THREE.Color(colours[name])};
  const material = new THREE.ShaderMaterial(Object.assign({uniforms, side: THREE.DoubleSide, polygonOffset: true,
                                                           polygonOffsetFactor: 1, polygonOffsetUnits: 1}, partShader));
  geometry.computeBoundingSphere();
  if (triangles.length === 0)
    return new THREE.Points(geometry, material);
  geometry.setIndex(new THREE.BufferAttribute(triangles, 1));
  return new THREE.Mesh(geometry, material);
}

// ---- The path: what is done is strong, what is to come is faint.
const lineShader = {
  vertexShader: `
    attribute float time;
    varying float at;
    void main() {
      at = time;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      gl_Position.z -= 4e-4 * gl_Position.w; // over the part
    }`,
  fragmentShader: `
    uniform vec3 colour;
    uniform float now, strength;
    varying float at;
    void main() { gl_FragColor = vec4(colour, at <= now ? strength : 0.35 * strength); }`
};

function makeLines(places) {
  const group = new THREE.Group(), positions = new THREE.BufferAttribute(places, 3), times = new THREE.BufferAttribute(time, 1);
  ways.forEach((way, kind) => {
    const ends = [];
    for (let i = 1; i < frames; ++i)
      if (move[i] === kind)
        ends.push(i - 1, i);
    way.used = ends.length > 0;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", positions);
    geometry.setAttribute("time", times);
    geometry.setIndex(new THREE.BufferAttribute(new Uint32Array(ends), 1));
    const uniforms = {colour: {value: new THREE.Color(way.colour)}, now: {value: 0}, strength: {value: 0.9}};
    const lines = new THREE.LineSegments(geometry, new THREE.ShaderMaterial(Object.assign({uniforms, transparent: true}, lineShader)));
    lines.frustumCulled = false;
    group.add(lines);
  });
  return group;
}

// ---- The tool: solids of revolution about its axis, with the tip at the origin.
function makeTool() {
  const group = new THREE.Group();
  for (const solid of data.tool) {
    const shape = new THREE.LatheBufferGeometry(solid.profile.map(p => new THREE.Vector2(p[0], p[1])), 48);
    const material = new THREE.MeshLambertMaterial({color: solid.colour, transparent: true, opacity: solid.opacity, side: THREE.FrontSide});
    group.add(new THREE.Mesh(shape, material));
  }
  return group;
}

// ---- Time
let now = lastTime, playing = 0, speed = 1;

/** The frame at or before a time. */
function frameAt(t) {
  let low = 0, high = frames - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (time[middle] <= t)
      low = middle;
    else
      high = middle - 1;
  }
  return low;
}

const between = (values, i, share, k, n) => i + 1 < frames ? values[n * i + k] * (1 - share) + values[n * (i + 1) + k] * share : values[n * i + k];

/** The tool at a time. */
function poseAt(t) {
  const i = frameAt(t), span = i + 1 < frames ? time[i + 1] - time[i] : 0, share = span > 0 ? (t - time[i]) / span : 0;
  const vector = values => new THREE.Vector3(...[0, 1, 2].map(k => between(values, i, share, k, 3)));
  return {i, share, tip: vector(tip), axis: vector(axis).normalize(), value: (values, k = 0, n = 1) => between(values, i, share, k, n)};
}

function clock(seconds) {
  const s = Math.max(0, seconds), two = v => String(Math.floor(v)).padStart(2, "0");
  return (s >= 3600 ? Math.floor(s / 3600) + ":" : "") + two(s / 60 % 60) + ":" + two(s % 60) + (lastTime < 600 ? "." + Math.floor(s * 10 % 10) : "");
}

function showFigures(pose) {
  const to = Math.min(frames - 1, pose.share > 0 ? pose.i + 1 : pose.i), rows = [];
  rows.push(["Time", clock(now) + " of " + clock(lastTime)]);
  rows.push(["Length", (pose.value(length) / 1000).toFixed(3) + " m"]);
  if (feed)
    rows.push([move[to] === 0 ? data.feedWord : "Feed of the tip",
               feed[to] > 0 ? feed[to].toFixed(0) + " mm/min" : move[to] === 0 ? "not known" : "rapid"]);
  if (data.turns > 0)
    rows.push([data.turnWord, Math.min(data.turns, Math.floor(turn[to]) + 1) + " of " + data.turns]);
  if (number && number[to] > 0)
    rows.push([data.numberWord, number[to]]);
  if (angles)
    [0, 1].forEach(k => rows.push([data.rotary[k], pose.value(angles, k, 2).toFixed(2) + "\u00b0"]));
  const box = find(".figures");
  box.textContent = "";
  for (const [name, value] of rows) {
    const item = document.createElement("span"), label = document.createElement("b");
    label.textContent = name + " ";
    item.append(label, String(value));
    box.append(item);
  }
}

// ---- The view: the camera turns round a target, and z stays upright.
const view = {target: new THREE.Vector3(), distance: 1, yaw: 0, pitch: 0};
let renderer, world, camera, part, lines, tool, lamp, waiting = false;

function look(towards) {
  view.yaw = Math.atan2(towards.y, towards.x);
  view.pitch = Math.asin(Math.max(-1, Math.min(1, towards.z / towards.length())));
  view.target.copy(part.geometry.boundingSphere.center);
  view.distance = 6 * part.geometry.boundingSphere.radius;
  showAll();
  draw();
}

/** The ends of the tool at the start, of a long one as much as the part is wide; nothing of a tool far from the part. */
function toolEnds() {
  const sphere = part.geometry.boundingSphere, pose = poseAt(0);
  if (pose.tip.distanceTo(sphere.center) > 3 * sphere.radius)
    return [];
  const top = Math.max(...data.tool.map(solid => Math.max(...solid.profile.map(p => p[1]))));
  const shown = Math.min(top, 2 * sphere.radius);
  return [...pose.tip.toArray(), ...pose.tip.clone().addScaledVector(pose.axis, shown).toArray()];
}

/** Moves the camera so that it sees the whole part, and the tool at the start, in the middle. */
function showAll() {
  const corners = part.geometry.attributes.position.array, ends = toolEnds();
  const places = new Float32Array(corners.length + ends.length);
  places.set(corners);
  places.set(ends, corners.length);
  const high = Math.tan(0.5 * camera.fov * Math.PI / 180);
  for (let round = 0; round < 3; ++round) { // what is near looks larger: the middle depends on the distance
    placeCamera();
    const [right, up, back] = [0, 1, 2].map(k => new THREE.Vector3().setFromMatrixColumn(camera.matrix, k)), p = new THREE.Vector3();
    let low = [1e30, 1e30], most = [-1e30, -1e30], distance = 0;
    for (let i = 0; i < places.length; i += 3) {
      const depth = view.distance - p.set(places[i], places[i + 1], places[i + 2]).sub(view.target).dot(back);
      [p.dot(right), p.dot(up)].forEach((at, k) => {
        low[k] = Math.min(low[k], at / depth);
        most[k] = Math.max(most[k], at / depth);
        distance = Math.max(distance, view.distance - depth + Math.abs(at) / high / (k === 0 ? camera.aspect : 1));
      });
    }
    view.target.addScaledVector(right, 0.5 * (low[0] + most[0]) * view.distance).addScaledVector(up, 0.5 * (low[1] + most[1]) * view.distance);
    view.distance = 1.1 * distance;
  }
}

function lookFrom(name) {
  const out = new THREE.Vector3(...data.outward);
  const beside = new THREE.Vector3(-0.75, -1, 0), slant = out.clone().multiplyScalar(1.15).addScaledVector(beside, 0.62 + 0.1 * (1 - out.z));
  look({slant, top: new THREE.Vector3(0, -1e-4, out.z < -0.1 ? -1 : 1), front: new THREE.Vector3(0, -1, 0), side: new THREE.Vector3(1, 0, 0)}[name]);
}

function placeCamera() {
  const flat = Math.cos(view.pitch);
  const out = new THREE.Vector3(flat * Math.cos(view.yaw), flat * Math.sin(view.yaw), Math.sin(view.pitch));
  camera.position.copy(view.target).addScaledVector(out, view.distance);
  camera.lookAt(view.target);
  camera.near = view.distance / 200;
  camera.far = view.distance + 40 * part.geometry.boundingSphere.radius;
  camera.updateProjectionMatrix();
  camera.updateMatrix();
  lamp.position.copy(camera.position);
}

function turnView(dx, dy) {
  view.yaw -= 0.008 * dx;
  view.pitch = Math.max(-1.5706, Math.min(1.5706, view.pitch + 0.008 * dy));
}

function moveView(dx, dy) {
  const scale = 2 * view.distance * Math.tan(0.5 * camera.fov * Math.PI / 180) / canvas.clientHeight;
  const right = new THREE.Vector3().setFromMatrixColumn(camera.matrix, 0), up = new THREE.Vector3().setFromMatrixColumn(camera.matrix, 1);
  view.target.addScaledVector(right, -scale * dx).addScaledVector(up, scale * dy);
}

function nearer(factor) {
  const radius = part.geometry.boundingSphere.radius;
  view.distance = Math.max(0.01 * radius, Math.min(20 * radius, view.distance * factor));
}

// ---- Drawing, when something has changed
function draw() {
  if (waiting)
    return;
  waiting = true;
  requestAnimationFrame(render);
}

function fit() {
  const width = canvas.clientWidth, height = canvas.clientHeight;
  renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
  renderer.setSize(width, height, false);
  camera.aspect = width / height;
}

function render() {
  waiting = false;
  placeCamera();
  const pose = poseAt(now);
  tool.position.copy(pose.tip);
  tool.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), pose.axis);
  part.material.uniforms.now.value = now;
  for (const one of lines.children)
    one.material.uniforms.now.value = now;
  const pixels = data.spacing / (2 * view.distance * Math.tan(0.5 * camera.fov * Math.PI / 180)) * canvas.clientHeight;
  lines.children[0].material.uniforms.strength.value = Math.max(0.12, Math.min(0.9, pixels / 9)); // close lines would hide the part
  renderer.render(world, camera);
  showFigures(pose);
}

function goTo(t) {
  now = Math.max(0, Math.min(lastTime, t));
  slider.value = lastTime > 0 ? now / lastTime : 0;
  draw();
}

function stop() {
  playing = 0;
  find("[data-do=play]").textContent = "Play";
}

function play() {
  if (now >= lastTime)
    goTo(0);
  const run = playing = playing + 1;
  let before = performance.now();
  find("[data-do=play]").textContent = "Stop";
  requestAnimationFrame(function tick(at) {
    if (run !== playing)
      return;
    goTo(now + speed * Math.max(0, at - before) / 1000);
    before = at;
    now < lastTime ? requestAnimationFrame(tick) : stop();
  });
}

const toggle = () => playing ? stop() : play();

/** One move, or one turn, on or back. Moves that take no time are made with the next. */
function step(sign, byTurn) {
  stop();
  let i = frameAt(now);
  const from = turn[i], inside = at => at + sign >= 0 && at + sign < frames;
  const near = at => sign > 0 ? time[at] <= now : time[at] >= now;
  while (inside(i) && (near(i) || (byTurn && data.turns > 0 && Math.abs(turn[i] - from) < 1)))
    i += sign;
  goTo(time[i]);
}

// ---- Choices
function options(name, entries, chosen) {
  const select = find("[data-choice=" + name + "]");
  for (const [value, text] of entries)
    select.add(new Option(text, value));
  select.value = chosen;
  select.closest("label").hidden = entries.length < 2;
  return select;
}

function swatch(text, background, isRamp) {
  const item = document.createElement("span"), colour = document.createElement("i");
  colour.style.background = background;
  colour.className = isRamp ? "ramp" : "";
  item.append(colour, text);
  find(".legend").append(item);
}

function setColour(name) {
  const uniforms = part.material.uniforms, scale = data.scales[name], legend = find(".legend");
  uniforms.colouring.value = ["plain", "stock", "deviation"].indexOf(name);
  legend.textContent = "";
  if (scale) {
    const stops = name === "stock" ? ramp : diverging, words = name === "stock" ? ["gouge", "above the limit"] : ["deeper", "higher"];
    uniforms.range.value.set(scale.low, scale.high);
    uniforms.colours.value = rampTexture(stops);
    swatch((name === "stock" ? "stock left " : "deviation ") + scale.low.toPrecision(2) + " to " + scale.high.toPrecision(2) + " mm",
           "linear-gradient(90deg," + stops.join() + ")", true);
    swatch(words[0], below);
    swatch(words[1], above);
    swatch("not measured", unknown);
  }
  if (data.arrays.cutAt)
    swatch("not cut yet", uncut);
  ways.forEach(way => way.used && swatch(way.name, way.colour));
  draw();
}

function setLine(name) {
  lines.visible = name !== "none";
  const places = new THREE.BufferAttribute(name === "contact" ? contact : tip, 3);
  for (const one of lines.children)
    one.geometry.setAttribute("position", places);
  draw();
}

function setSpeed(value) {
  speed = Number(value);
  find("[data-choice=speed]").value = value;
}

function makeChoices() {
  const colours = [["plain", "plain"]].concat(data.scales.stock ? [["stock", "stock left"]] : [],
                                              data.scales.deviation ? [["deviation", "deviation"]] : []);
  options("colour", colours, colours[Math.min(1, colours.length - 1)][0]).onchange = event => setColour(event.target.value);
  options("line", (contact ? [["contact", "contact"]] : []).concat([["tip", "tool tip"], ["none", "none"]]), contact ? "contact" : "tip")
    .onchange = event => setLine(event.target.value);
  options("raise", data.uncut > 0 ? [0, 1, 10, 100].map(v => [v, v ? "\u00d7 " + v : "flat"]) : [], 1).onchange =
    event => { part.material.uniforms.raise.value = Number(event.target.value); draw(); };
  part.material.uniforms.raise.value = data.uncut > 0 ? 1 : 0;
  const speeds = [0.1, 1, 3, 10, 30, 100, 300, 1000], wanted = speeds.find(v => lastTime / v < 60) || 1000;
  options("speed", speeds.map(v => [v, "\u00d7 " + v])).onchange = event => setSpeed(event.target.value);
  setSpeed(wanted);
  find("[data-choice=tool]").onchange = event => { tool.visible = event.target.checked; draw(); };
  setColour(colours[Math.min(1, colours.length - 1)][0]);
  setLine(contact ? "contact" : "tip");
}

// ---- Hands
function changeSpeed(by) {
  const select = find("[data-choice=speed]"), at = select.selectedIndex + by;
  if (at >= 0 && at < select.options.length)
    setSpeed(select.options[at].value);
}

function listen() {
  const actions = {play: toggle, back: () => step(-1, false), on: () => step(1, false)};
  section.querySelectorAll("[data-do]").forEach(button => button.onclick = () => actions[button.dataset.do]());
  section.querySelectorAll("[data-view]").forEach(button => button.onclick = () => lookFrom(button.dataset.view));
  slider.oninput = () => { stop(); goTo(slider.value * lastTime); };
  const keys = {" ": toggle, "+": () => changeSpeed(1), "=": () => changeSpeed(1), "-": () => changeSpeed(-1), Home: () => goTo(0),
                End: () => goTo(lastTime), ArrowRight: event => step(1, event.shiftKey), ArrowLeft: event => step(-1, event.shiftKey),
                ArrowUp: event => step(1, event.shiftKey), ArrowDown: event => step(-1, event.shiftKey)};
  section.onkeydown = event => {
    const press = event.target === canvas || event.target === slider;
    if (!press || !keys[event.key] || event.ctrlKey || event.altKey || event.metaKey)
      return;
    event.preventDefault();
    keys[event.key](event);
  };
  listenToPointers();
  new ResizeObserver(() => { fit(); draw(); }).observe(canvas);
}

function listenToPointers() {
  const held = new Map(), middle = () => [...held.values()].reduce((a, p) => [a[0] + p[0] / held.size, a[1] + p[1] / held.size], [0, 0]);
  const spread = () => { const [a, b] = [...held.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
  canvas.onpointerdown = event => {
    canvas.focus({preventScroll: true});
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, [event.clientX, event.clientY]);
  };
  canvas.onpointermove = event => {
    if (!held.has(event.pointerId))
      return;
    const from = middle(), wide = held.size === 2 ? spread() : 0;
    held.set(event.pointerId, [event.clientX, event.clientY]);
    const to = middle(), dx = to[0] - from[0], dy = to[1] - from[1];
    if (held.size === 2)
      nearer(wide / Math.max(1, spread()));
    held.size === 2 || event.shiftKey || event.buttons === 2 ? moveView(dx, dy) : turnView(dx, dy);
    draw();
  };
  canvas.onpointerup = canvas.onpointercancel = event => held.delete(event.pointerId);
  canvas.oncontextmenu = event => event.preventDefault();
  canvas.addEventListener("wheel", event => {
    if (document.activeElement !== canvas)
      return; // the page scrolls
    event.preventDefault();
    nearer(Math.exp(0.0012 * event.deltaY));
    draw();
  }, {passive: false});
}

// ---- All of it
/** Whether the browser draws in 3-D. */
function makeRenderer() {
  const probe = document.createElement("canvas");
  try {
    if (probe.getContext("webgl") || probe.getContext("experimental-webgl"))
      renderer = new THREE.WebGLRenderer({canvas, antialias: true});
  } catch (error) {} // it says so below
  return Boolean(renderer);
}

function start() {
  if (!makeRenderer()) {
    find(".message").textContent = "This browser shows no 3-D (WebGL); the pictures below show the same part.";
    return;
  }
  section.classList.add("ready");
  renderer.setClearColor("#f7f8fa");
  world = new THREE.Scene();
  camera = new THREE.PerspectiveCamera(32, 1, 0.1, 1000);
  camera.up.set(0, 0, 1);
  lamp = new THREE.PointLight("#ffffff", 0.75);
  world.add(part = makePart(), lines = makeLines(contact || tip), tool = makeTool(), lamp, new THREE.AmbientLight("#ffffff", 0.5));
  fit();
  makeChoices();
  listen();
  lookFrom("slant");
  goTo(0);
}

start();
})();
