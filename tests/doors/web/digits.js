// node digits.js POINSOT MODULE FONTS PROGRAM_JS SCENES_FOLDER [N_INSTANTS [SCENE…]]: the digits of the page's
// module are those of `poinsot sample`: free motions bit for bit, others within 1e-15 of the largest.
'use strict';
const {execFileSync} = require('node:child_process');
const test = require('node:test');
const assert = require('node:assert/strict');
const fs = require('node:fs');
const path = require('node:path');
const {files_of} = require('./scene_files.js');

const [poinsot, module_file, fonts_file, program_file, folder, n_given, ...only] = process.argv.slice(2);
const n_instants = Number(n_given || 200);
const all = fs.readdirSync(folder).filter((name) => name.endsWith('.toml')).map((name) => name.slice(0, -5));
const scenes = only.length > 0 ? only : all;

// A fixed sequence, so that every run has the same instants (Numerical Recipes' quick generator).
let seed = 12345;
const random = () => {
  seed = (Math.imul(seed, 1664525) + 1013904223) >>> 0;
  return seed / 4294967296;
};

/** Instants to ±1e9 s for a closed form; of the film for a stepped one. */
function instants(loaded, is_stepped) {
  const times = [];
  for (let k = 0; k < n_instants; ++k)
    times.push(is_stepped ? loaded.first_time_s + random() * (loaded.last_time_s - loaded.first_time_s)
                          : (random() < 0.5 ? -1 : 1) * 10 ** (9 * random()));
  return times;
}

const started = import(path.resolve(program_file)).then(({Program}) => Program.start(fs.readFileSync(module_file), fs.readFileSync(fonts_file), null));

for (const name of scenes) {
  test(name, async (t) => {
    const program = await started;
    const file = path.join(folder, `${name}.toml`);
    const text = fs.readFileSync(file, 'utf8');
    for (const named of files_of(text)) program.addFile(named, fs.readFileSync(path.join(folder, named)));
    const loaded = program.load(text, file, [], {width: 640, height: 360});
    const report = JSON.parse(execFileSync(poinsot, ['check', file, '--json']).toString());
    const is_stepped = text.includes('[beside]') || report.regime === 'integrated' || !['exact', undefined].includes(report.method);
    const times = instants(loaded, is_stepped);
    const csv = execFileSync(poinsot, ['sample', file, '--times', times.map(String).join(',')], {maxBuffer: 1 << 27});
    const [heads, ...rows] = csv.toString().trim().split('\n').filter((line) => !line.startsWith('#')).map((line) => line.split(','));
    const column = (head) => heads.findIndex((each) => each.replace(/_(rad_s|s)$/, '') === head);
    const names = ['omega_body_1', 'omega_body_2', 'omega_body_3', 'q_w', 'q_x', 'q_y', 'q_z', 'herpolhode_x', 'herpolhode_y', 'herpolhode_z',
      'theta_rad', 'phi_rad', 'psi_rad'];
    const columns = names.map(column);
    // The moments of an object follow from its surface, whose points need elementary functions, which
    // differ by the last digit. The angle of rotation, ωt, multiplies it.
    const is_object = /^(object|mesh|shape) *=/m.test(text);
    let n_differ = 0;
    let worst = 0;
    let n_compared = 0;
    rows.forEach((row, k) => {
      const digits = program.at(times[k]);
      const own = [...digits.omega_body, ...digits.space_from_body, ...digits.herpolhode, ...(digits.angles ?? [])];
      let differs = false;
      const speed = Math.max(...digits.omega_body.map(Math.abs));
      own.forEach((value, i) => {
        if (columns[i] < 0) return;
        ++n_compared;
        const native = Number(row[columns[i]]);
        if (Object.is(value, native) || value === native) return;
        differs = true;
        const turned = is_object ? 1 + speed * Math.abs(times[k]) : 1;
        worst = Math.max(worst, Math.abs(value - native) / turned / (i > 9 ? Math.max(1, Math.abs(native)) : i < 3 || i > 6 ? speed || 1 : 1));
      });
      n_differ += differs ? 1 : 0;
    });
    const is_exact = !report.regime.includes('top') && !is_stepped && !is_object;
    const limit = 1e-15;
    const fails = n_compared === 0 || (is_exact ? n_differ > 0 : worst > limit && !is_stepped);
    const outcome = `${n_differ} of ${rows.length} instants differ, by ${worst} (${report.regime})`;
    t.diagnostic(outcome);
    assert.ok(!fails, outcome);
  });
}
