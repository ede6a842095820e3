// SPDX-License-Identifier: BSD-3-Clause
// Uses the scene of a report as a reader does, with pointer, keys and choices, and writes what it sees as JSON into the page.
// It is put at the end of a copy of the page, after scene_watch.js at its beginning.
(async function () {
"use strict";
const section = document.getElementById("scene"), find = selector => section.querySelector(selector);
const canvas = find("canvas"), slider = find("input[type=range]");

const frame = () => new Promise(requestAnimationFrame);
const wait = ms => new Promise(done => setTimeout(done, ms));

/** Does something that draws, and returns the pixels: a WebGL canvas has them until the end of the frame in which it was drawn. */
async function drawn(action) {
  await frame();
  action();
  await frame();
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = copy.getContext("2d");
  context.drawImage(canvas, 0, 0);
  return context.getImageData(0, 0, copy.width, copy.height);
}

function colours(image) {
  const seen = new Set();
  for (let i = 0; i < image.data.length; i += 4)
    seen.add(image.data[i] << 16 | image.data[i + 1] << 8 | image.data[i + 2]);
  return seen.size;
}

/** Number of pixels that differ, and their middle. */
function difference(a, b) {
  let count = 0, x = 0, y = 0;
  for (let i = 0; i < a.data.length; i += 4)
    if (Math.abs(a.data[i] - b.data[i]) + Math.abs(a.data[i + 1] - b.data[i + 1]) + Math.abs(a.data[i + 2] - b.data[i + 2]) > 12) {
      ++count;
      x += i / 4 % a.width;
      y += Math.floor(i / 4 / a.width);
    }
  return {count, x: x / count / a.width, y: y / count / a.height};
}

const slideTo = share => () => { slider.value = share; slider.dispatchEvent(new Event("input")); };
const choose = (name, value) => () => {
  const select = find("[data-choice=" + name + "]");
  select.value = value;
  select.dispatchEvent(new Event("change"));
};
const showTool = shown => () => {
  const box = find("[data-choice=tool]");
  box.checked = shown;
  box.dispatchEvent(new Event("change"));
};
const press = (key, shiftKey) => () => canvas.dispatchEvent(new KeyboardEvent("keydown", {key, shiftKey, bubbles: true, cancelable: true}));
const pointer = (type, x, y) => canvas.dispatchEvent(new PointerEvent(type, {pointerId: 1, clientX: x, clientY: y, bubbles: true}));
const figures = () => find(".figures").textContent;

/** What the tool covers at a share of the time. */
async function toolAt(share) {
  const without = await drawn(() => { showTool(false)(); slideTo(share)(); });
  return difference(without, await drawn(showTool(true)));
}

/** Pixels in the colour of what is not cut yet: more red than blue by far. */
async function uncutAt(share) {
  const image = await drawn(() => { showTool(false)(); choose("line", "none")(); choose("colour", "plain")(); slideTo(share)(); });
  let count = 0;
  for (let i = 0; i < image.data.length; i += 4)
    count += image.data[i] - image.data[i + 2] > 0.35 * image.data[i];
  return count;
}

const result = {ready: section.classList.contains("ready"), errors: sceneErrors};
try {
  const start = await drawn(slideTo(0));
  result.colours = colours(start);
  result.tool = [await toolAt(0.2), await toolAt(0.65)];
  result.figures = [figures()];
  result.uncut = [await uncutAt(0), await uncutAt(0.5), await uncutAt(1)];
  result.times = [];
  for (const action of [slideTo(0.5), press("ArrowRight"), press("ArrowRight", true), press("ArrowLeft"), press("Home")]) {
    await drawn(action);
    result.times.push(Number(slider.value));
    result.figures.push(figures());
  }
  const play = find("[data-do=play]"), before = slider.value;
  await drawn(press(" "));
  result.playing = play.textContent;
  await wait(400);
  await drawn(press(" "));
  result.stopped = play.textContent;
  result.played = slider.value - before;
  result.views = [];
  const shown = await drawn(choose("line", "tip"));
  for (const button of section.querySelectorAll("[data-view]"))
    result.views.push(difference(shown, await drawn(() => button.click())).count);
  const still = await drawn(slideTo(0.5));
  result.turned = difference(still, await drawn(() => {
    pointer("pointerdown", 200, 200);
    pointer("pointermove", 260, 230);
    pointer("pointerup", 260, 230);
  })).count;
  const select = find("[data-choice=colour]");
  result.colourings = [];
  await drawn(slideTo(1));
  for (const option of select.options)
    result.colourings.push([option.value, colours(await drawn(choose("colour", option.value))), find(".legend").textContent]);
}
catch (error) {
  result.errors.push("check: " + error.stack);
}
result.pixels = canvas.width * canvas.height;
result.width = [document.documentElement.scrollWidth, window.innerWidth];
result.requests = performance.getEntriesByType("resource").map(entry => entry.name);
const text = document.createElement("pre");
text.id = "scene-check";
text.textContent = JSON.stringify(result);
document.body.append(text);
})();
