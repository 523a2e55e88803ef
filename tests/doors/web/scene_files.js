// The files that a scene of scenes/ names; the module needs them before it reads the scene.
'use strict';

/** @param {string} text of the scene @returns {string[]} */
function files_of(text) {
  return [...text.matchAll(/^(?:file|mesh) *= *"(.*)"/gm)].map(([, name]) => name);
}

module.exports = {files_of};
