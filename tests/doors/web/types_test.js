// The scripts of the page have no type errors.
'use strict';
const {spawnSync} = require('node:child_process');
const test = require('node:test');
const assert = require('node:assert/strict');
const path = require('node:path');

test('the scripts of the page have no type errors', () => {
  const tsc = require.resolve('typescript/bin/tsc');
  const outcome = spawnSync(process.execPath, [tsc, '-p', path.join(__dirname, 'tsconfig.json')], {encoding: 'utf8'});
  assert.equal(outcome.status, 0, outcome.stdout);
});
