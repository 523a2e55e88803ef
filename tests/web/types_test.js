// The scripts of the page have no type errors.
'use strict';
const {spawnSync} = require('node:child_process');
const path = require('node:path');

const tsc = require.resolve('typescript/bin/tsc');
const outcome = spawnSync(process.execPath, [tsc, '-p', path.join(__dirname, 'tsconfig.json')], {stdio: 'inherit'});
process.exit(outcome.status ?? 1);
