// Ends a test that cannot run on this machine: CTest shows it as skipped.
'use strict';
const path = require('node:path');

const skipped = 77;

/** @param {string} why */
function skip(why) {
  console.log(`skipped: ${why}`);
  process.exit(skipped);
}

/** A package of tests/page/package.json, or of POINSOT_NODE_MODULES. @param {string} name */
function needed(name) {
  const folders = [process.env['POINSOT_NODE_MODULES'] ?? '', path.join(__dirname, 'node_modules')].filter(Boolean);
  try {
    return require.resolve(name, {paths: folders.map((folder) => path.dirname(path.resolve(folder, 'x')))
      .concat(folders.map((folder) => path.resolve(folder, '..')))});
  } catch {
    return skip(`${name} is missing; run npm ci in tests/page`);
  }
}

module.exports = {skip, needed};
