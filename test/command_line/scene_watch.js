// SPDX-License-Identifier: BSD-3-Clause
// Stands before all of a page: gathers in sceneErrors what goes wrong, and makes frames by the clock, because Chromium without a window
// draws none.
const sceneErrors = [], waitingFrames = [];
for (const name of ["error", "warn"])
  console[name] = (...words) => sceneErrors.push(words.join(" "));
window.onerror = message => { sceneErrors.push(message); };
document.addEventListener("securitypolicyviolation", event => sceneErrors.push("asks for " + event.blockedURI));
window.requestAnimationFrame = call => {
  if (waitingFrames.push(call) === 1)
    setTimeout(() => waitingFrames.splice(0).forEach(one => one(performance.now())), 16);
};
